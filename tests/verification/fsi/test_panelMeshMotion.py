"""The mesh motion of the shock-tube panel: how often, by which solver, and
what stops it."""
import re
from math import prod
from pathlib import Path

import numpy as np
import pytest

from foamCase import FoamCase

PANEL = Path(__file__).resolve().parents[3].joinpath(
    "tutorials", "fsi", "shockPanel50")
END, STEP, STEPS = "1.2e-4", "4e-6", 30

LAPLACIAN = (
    ("fvSchemes", "laplacianSchemes", "{ default Gauss linear corrected; }"),
    ("fvSchemes", "snGradSchemes", "{ default corrected; }"),
    ("fvSchemes", "gradSchemes", "{ default Gauss linear; }"),
    ("fvSchemes", "interpolationSchemes", "{ default linear; }"),
)


class Panel(FoamCase):
    """Cells twice as long in the flow's direction; fixed steps."""

    def __init__(self, folder, end=END):
        super().__init__(PANEL, folder)
        mesh = self.path / "system" / "blockMeshDict"
        mesh.write_text(re.sub(
            r"\) \((\d+) (\d+) 1\)",
            lambda m: f") ({max(2, int(m[1])//2)} {int(m[2])//2} 1)",
            mesh.read_text()))
        for entry, value in (
            ("adjustTimeStep", "no"), ("deltaT", STEP), ("endTime", end),
            ("writeControl", "timeStep"), ("writeInterval", "10"),
            ("writePrecision", "17"), ("timePrecision", "8"),
        ):
            self.set("system/controlDict", entry, value)
        self.run("blockMesh")
        self.run("blockShell")
        self.run("setPointFields")

    def runs(self, check=True):
        self.log = self.run("shockShellFoam", check=check)
        return self

    def tip(self, start=0):
        return self.history(f"panelTip/{start}/displacement.dat")[1]


@pytest.fixture(scope="module")
def panel(tmp_path_factory):
    return Panel(tmp_path_factory.mktemp("motion") / "case").runs()


def test_twiceForEachShellStep(panel):
    """Not once for each of the ten gas steps in it."""
    steps = panel.log.count("\nTime = ")
    assert steps == STEPS
    assert re.findall(r"Gas: (\d+) step", panel.log) == ["10"] * steps
    solves, shellSteps = map(int, re.search(
        r"motion solver was applied (\d+) times in (\d+) shell steps",
        panel.log).groups())
    assert shellSteps == steps
    assert solves == 2*steps + 2


def test_everyStepTellsTheLeastRatio(panel):
    ratios = [float(r) for r in re.findall(
        r"Mesh motion: least volume ratio (\S+), cell \d+ at \(", panel.log)]
    assert len(ratios) == STEPS
    assert 0.99 < ratios[-1] < ratios[0] <= 1


def test_laplacianInTheSameCase(panel, tmp_path):
    """The motion of the panel hardly depends on how the mesh follows it."""
    case = Panel(tmp_path / "case")
    case.set("constant/dynamicMeshDict", "solver", "displacementLaplacian")
    case.set("constant/dynamicMeshDict", "motionSolverLibs",
             "(fvMotionSolvers)")
    case.run("foamDictionary", "constant/dynamicMeshDict", "-entry",
             "displacementLaplacianCoeffs", "-add", "{ diffusivity uniform; }")
    for file, entry, value in LAPLACIAN:
        case.run("foamDictionary", f"system/{file}", "-entry", entry, "-set",
                 value)
    case.run("foamDictionary", "system/fvSolution", "-entry", "solvers",
             "-set", '{ "cellDisplacement.*" { solver PCG; preconditioner DIC;'
             " tolerance 1e-14; relTol 0; } }")
    case.runs()
    assert "Selecting motion solver: displacementLaplacian" in case.log
    one, other = panel.tip()[:, 1], case.tip()[:, 1]
    assert other[-1] > 0
    assert abs(other - one).max() < 1e-3*one[-1]
    assert abs(other - one).max() > 1e-12*one[-1]


def continued(case):
    """The case from its latest time to END."""
    start = case.times()[-1]
    case.set("system/controlDict", "endTime", END)
    case.set("system/controlDict", "startFrom", "latestTime")
    return case.runs(), start


def test_stopLeavesTheStateOfARunThatEndsThere(panel, tmp_path):
    """The watch stops before the gas moves: shell and gas go back to the end of
    the last step. What is written is what a run up to there writes, and a run
    that continues from it is the same."""
    ratios = [float(r) for r in re.findall(
        r"least volume ratio (\S+), cell", panel.log)]
    case = Panel(tmp_path / "case")
    case.run("foamDictionary", "constant/dynamicMeshDict", "-entry", "quality",
             "-add", f"{{ stopBelow {0.5*(ratios[24] + ratios[25]):.17g};"
             " warnBelow 1; }")
    case.runs(check=False)
    assert case.exitCode not in (0, None)
    assert "nearest to patch panel" in case.log
    assert "at time 0.000104\n" in case.log
    assert "state is that of time 0.0001, which is written" in case.log
    assert case.times()[-1] == "0.0001"
    case.set("constant/dynamicMeshDict", "quality/stopBelow", "0")

    other = Panel(tmp_path / "other", end="1e-4").runs()
    runs = (case, "0.0001"), (other, "0.0001")
    for pair in (runs, (continued(case), continued(other))):
        names = [c.times()[-1] for c, _ in pair]
        assert names[0] == names[1]
        for name in ("p", "U", "T", "pointDisplacement"):
            one, two = (c.pointField(name, names[0]) for c, _ in pair)
            np.testing.assert_allclose(
                one, two, rtol=0, atol=1e-13*abs(two).max())
        one, two = (c.points(names[0]) for c, _ in pair)
        np.testing.assert_allclose(one, two, rtol=0, atol=1e-16)
    # The restart has found the same map
    maps = [re.search(r"worst offset of a node from the shell .*", c.log)[0]
            for c in (panel, case)]
    assert maps[0] == maps[1]
    assert case.tip("0.0001")[-1, 1] == other.tip("0.0001")[-1, 1]
    assert case.tip("0.0001")[-1, 1] == pytest.approx(
        panel.tip()[-1, 1], rel=1e-6)


def test_restartIsTheSameRun(panel, tmp_path):
    """From a time at which the whole run wrote as well: to rounding, though
    shock capturing sees the moving mesh and the shell kept factors."""
    case = Panel(tmp_path / "case", end="8e-5").runs()
    case, start = continued(case)
    assert start == "8e-05"
    whole, tip = panel.tip(), case.tip(start)
    np.testing.assert_allclose(
        tip[:, 1:], whole[-len(tip):, 1:], rtol=0,
        atol=1e-11*abs(whole[:, 1:]).max())
    end = panel.times()[-1]
    for name in ("p", "U", "T", "pointDisplacement"):
        wanted = panel.pointField(name, end)
        np.testing.assert_allclose(
            case.pointField(name, end), wanted,
            rtol=0, atol=1e-12*abs(wanted).max())


def test_closestPointLoads(panel, tmp_path):
    """The paper's (21) interpolates pressures: force, moment and work differ
    from the gas's, and the tip's edge is left out."""
    case = Panel(tmp_path / "case")
    case.set("constant/couplingProperties", "loadTransfer", "closestPoint")
    case.runs()
    nodes, of = map(int, re.search(
        r"closest points at (\d+) of (\d+) shell nodes", case.log).groups())
    assert nodes == of > 0

    def mismatch(run, column):
        names, table = run.history("interface/0/balance.dat")
        gas, shell = (table[:, names.index(column.format(side))]
                      for side in ("Gas", "Shell"))
        return abs(gas - shell).max()/abs(gas).max()

    # Force and moment in the plane: smooth pressures on the faces
    for column in ("force{}_x", "moment{}_z", "work{}"):
        kept, lost = (mismatch(run, column) for run in (panel, case))
        print(column, kept, lost)
        assert column == "work{}" or kept < 1e-12
    assert 1e-6 < mismatch(case, "force{}_x") < 1e-3
    assert 1e-6 < mismatch(case, "moment{}_z") < 1e-3
    # Along the panel there is only the pressure on its edge
    assert mismatch(case, "force{}_y") > 0.9

    one, other = panel.tip()[:, 1], case.tip()[:, 1]
    assert 1e-6 < abs(other[-1]/one[-1] - 1) < 0.02


SIMPLE = """
FoamFile {{ version 2.0; format ascii; class dictionary;
    object decomposeParDict; }}
numberOfSubdomains {parts}; method simple;
simpleCoeffs {{ n {n}; delta 0.001; }}
"""


# The panel on one process, cut along it, cut across it, and spread over four
@pytest.mark.parametrize("n", ["(2 1 1)", "(1 2 1)", "(4 1 1)", "(2 2 1)"])
def test_sameAnswerOnSeveralProcesses(panel, tmp_path, n):
    parts = prod(int(i) for i in n.strip("()").split())
    case = Panel(tmp_path / "case")
    (case.path / "system" / "decomposeParDict").write_text(
        SIMPLE.format(parts=parts, n=n))
    case.run("decomposePar")
    case.log = case.runParallel(parts, "shockShellFoam")
    case.run("reconstructPar", "-latestTime")

    end = panel.times()[-1]
    for name in ("p", "U", "T", "pointDisplacement"):
        wanted = panel.pointField(name, end)
        np.testing.assert_allclose(
            case.pointField(name, end), wanted,
            rtol=0, atol=1e-10*abs(wanted).max())
    one, several = panel.tip(), case.tip()
    np.testing.assert_allclose(several, one, rtol=0,
                               atol=1e-9*abs(one[:, 1:]).max())
    one, several = (c.history("interface/0/balance.dat")[1]
                    for c in (panel, case))
    # Columns of forces, impulses and works; the z components are round-off
    scale = abs(one).max(axis=0)
    columns = scale > 1e-9*scale[1]*scale[0]
    assert columns.sum() > 6
    np.testing.assert_allclose(
        several[:, columns]/scale[columns], one[:, columns]/scale[columns],
        rtol=0, atol=1e-9)

    lines = [re.search(r"Interface: (\d+) gas nodes, (\S+) m2", c.log).groups()
             for c in (panel, case)]
    assert lines[0][0] == lines[1][0]
    assert float(lines[0][1]) == pytest.approx(float(lines[1][1]), rel=1e-12)


@pytest.mark.parametrize("scheme, loads", [
    ("predictedMotion", "end"), ("iterated", "end"), ("twoWay", "average")])
def test_parallelRestartIsTheSameRun(tmp_path, scheme, loads):
    """What a scheme keeps of the last step belongs to the interface nodes of
    each process."""
    tips = []
    for name in ("whole", "parts"):
        case = Panel(tmp_path / name, end="8e-5" if name == "parts" else END)
        case.set("constant/couplingProperties", "coupling", scheme)
        case.run("foamDictionary", "constant/couplingProperties", "-entry",
                 "loads", "-add", loads)
        (case.path / "system" / "decomposeParDict").write_text(
            SIMPLE.format(parts=2, n="(1 2 1)"))
        case.run("decomposePar")
        case.log = case.runParallel(2, "shockShellFoam")
        if name == "parts":
            case.set("system/controlDict", "endTime", END)
            case.set("system/controlDict", "startFrom", "latestTime")
            case.log = case.runParallel(2, "shockShellFoam")
            assert "not known on this decomposition" not in case.log
        tips.append(case.tip("8e-05" if name == "parts" else 0))
    whole, parts = tips
    np.testing.assert_allclose(parts, whole[-len(parts):], rtol=0,
                               atol=1e-12*abs(whole[:, 1:]).max())


@pytest.mark.parametrize("scheme", ["predictedMotion", "iterated"])
def test_gasFirstOnTwoProcesses(tmp_path, scheme):
    """The interface's motion of both together is predicted and iterated."""
    tips = []
    for parts in (1, 2):
        case = Panel(tmp_path / str(parts))
        case.set("constant/couplingProperties", "coupling", scheme)
        if parts == 1:
            case.runs()
        else:
            (case.path / "system" / "decomposeParDict").write_text(
                SIMPLE.format(parts=parts, n="(1 2 1)"))
            case.run("decomposePar")
            case.log = case.runParallel(parts, "shockShellFoam")
        tips.append(case.tip())
    np.testing.assert_allclose(tips[1], tips[0], rtol=0,
                               atol=1e-9*abs(tips[0][:, 1:]).max())
