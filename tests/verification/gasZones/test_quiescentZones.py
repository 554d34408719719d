"""Quiescent zones: gas that nothing has reached costs nothing, and the fields
are bit for bit those without zones, written with 17 digits.
"""
import re
import shutil
import sys
from pathlib import Path

import pytest

sys.path.insert(0, str(Path(__file__).parents[1] / "gasBenchmarks"))

from benchmarkCase import BenchmarkCase  # noqa: E402
from blockMeshes import box  # noqa: E402

SIDES = ["left", "right", "bottom", "top", "back", "front"]
CELLS = {1: 800, 2: 60, 3: 24}
STEPS, WRITES = 48, 4

# Where the wave comes from, in cells from the corner
RADIUS = 4


def zonesCase(folder, dim, far="far", capturing="fluxCorrected", inlet=None):
    """A blast in a corner of still air, walls on the low sides."""
    n = CELLS[dim]
    case = BenchmarkCase(folder, box([(1, n)], *[(1, n)] * (dim - 1)))
    patches = {
        side: "wall" if k % 2 == 0 else far
        for k, side in enumerate(SIDES[:2 * dim])
    }

    def state(x):
        inside = (x[:, :dim]**2).sum(axis=1) < (RADIUS / n)**2
        hot = inside & (inlet is None)
        return 1 + 3.0 * hot, 0 * x, 1 + 8.0 * hot

    if inlet is not None:
        patches["left"] = inlet
    case.start(state, patches)
    write(case, n)
    choose(case, capturing=capturing)
    return case


def write(case, n, start="startTime"):
    deltaT = 0.15 / n
    case.write("system/controlDict", f"""
application shockShellFoam; libs ("libtaylorGalerkin.so");
startFrom {start}; startTime 0; stopAt endTime; endTime {STEPS * deltaT:.12g};
deltaT {deltaT:.12g}; writeControl timeStep;
writeInterval {STEPS // WRITES}; writeFormat ascii; writePrecision 17;
timeFormat general; timePrecision 8; runTimeModifiable no;
""")


def choose(case, zones="on", capturing="fluxCorrected"):
    case.write("system/feSchemes", f"""
timeScheme twoStep; shockCapturing {capturing}; quiescentZones {zones};
""")


def copyOf(case, folder):
    other = object.__new__(type(case))
    other.__dict__.update(case.__dict__)
    other.path = folder
    shutil.copytree(case.path, folder)
    return other


def shares(log):
    """Parts of the gas that are active, as printed at the write times."""
    found = re.findall(r"Quiescent zones: (\S+) % of the gas is active", log)
    return [float(value) for value in found]


def written(case, prefix=""):
    """The files of the fields, by processor, time and name."""
    return {
        str(file.relative_to(case.path)): file.read_bytes()
        for file in case.path.glob(prefix + "[0-9]*/*")
        if file.name in ("p", "U", "T", "rho") and file.parent.name != "0"
    }


def run(case, processes=1):
    if processes == 1:
        return case.run("shockShellFoam")
    return case.run(
        "mpirun", "--allow-run-as-root", "--oversubscribe",
        "-np", str(processes), "shockShellFoam", "-parallel",
    )


def assertSame(on, off, prefix=""):
    expected = written(off, prefix)
    found = written(on, prefix)
    assert len(expected) >= 4 * WRITES
    assert found.keys() == expected.keys()
    different = [name for name in expected if found[name] != expected[name]]
    assert different == []


def onAndOff(case, tmp_path, processes=1, prefix="",
             capturing="fluxCorrected"):
    off = copyOf(case, tmp_path / "off")
    choose(off, "off", capturing)
    logOn, logOff = run(case, processes), run(off, processes)
    assertSame(case, off, prefix)
    assert "Quiescent zones: none, quiescentZones is off" in logOff
    assert shares(logOff) == []
    return shares(logOn)


@pytest.mark.parametrize("dim, far, capturing", [
    (1, "far", "fluxCorrected"),
    (2, "far", "fluxCorrected"),
    (2, "open", "pressureSwitch"),
    (3, "wall", "fluxCorrected"),
])
def test_fieldsAreTheSameBitForBit(dim, far, capturing, tmp_path):
    case = zonesCase(tmp_path / "on", dim, far, capturing)
    active = onAndOff(case, tmp_path, capturing=capturing)
    assert len(active) >= WRITES
    assert active == sorted(active)
    assert active[0] < 40
    assert active[0] < active[-1]


def test_fieldsAreTheSameOnSeveralProcessors(tmp_path):
    case = zonesCase(tmp_path / "on", 2)
    case.write("system/decomposeParDict", """
numberOfSubdomains 4; method simple; simpleCoeffs { n (2 2 1); delta 0.001; }
""")
    case.run("decomposePar", "-force")
    active = onAndOff(case, tmp_path, 4, "processor*/")
    assert active[0] < 20
    assert active[0] < active[-1] < 80


def test_fieldsAreTheSameAfterARestart(tmp_path):
    case = zonesCase(tmp_path / "on", 2)
    run(case)
    times = sorted((t for t in case.path.iterdir()
                    if re.fullmatch(r"0\.\d+", t.name)),
                   key=lambda t: float(t.name))
    for time in times[WRITES // 2:]:
        shutil.rmtree(time)
    write(case, CELLS[2], "latestTime")
    off = copyOf(case, tmp_path / "off")
    choose(off, "off")
    log = run(case)
    run(off)
    assertSame(case, off)
    assert shares(log)[0] < 60


def moveTop(case):
    """The top goes down by a cell while the blast leaves the corner; the mesh
    is at rest from a fifth of the box on."""
    end = STEPS * 0.15 / CELLS[case.mesh.dim]
    down = 1 / CELLS[case.mesh.dim]
    case.move("pointDisplacement", {
        "top": f"""type uniformFixedValue; value uniform (0 0 0);
uniformValue table ((0 (0 0 0)) ({0.8 * end} (0 0 0)) ({end} (0 {-down} 0)));""",
        **{side: "type slip;" for side in ("left", "right", "back", "front")
           if side in case.mesh.patches},
    })
    case.write("constant/dynamicMeshDict", """
motionSolverLibs (meshMotion); solver inverseDistance;
inverseDistanceCoeffs { movingPatches (top); outerDistance 0.2; }
""")


@pytest.mark.parametrize("processes", [1, 4])
def test_gasSleepsWhereAMovingMeshRests(processes, tmp_path):
    case = zonesCase(tmp_path / "on", 2)
    moveTop(case)
    prefix = ""
    if processes > 1:
        prefix = "processor*/"
        case.write("system/decomposeParDict", """
numberOfSubdomains 4; method simple; simpleCoeffs { n (2 2 1); delta 0.001; }
""")
        case.run("decomposePar", "-force")
    active = onAndOff(case, tmp_path, processes, prefix)

    # The top has woken what is near it, and what its waves reach
    assert active[-2] < 50
    assert active[-2] + 20 < active[-1] < 100


def test_valuesThatChangeWithTimeWakeTheGas(tmp_path):
    inlet = {
        "p": "type uniformFixedValue; value uniform 1;"
             " uniformValue table ((0 1) (2e-3 1) (4e-3 4));",
        "U": "type fixedValue; value uniform (0 0 0);",
        "T": "type fixedValue; value uniform 1;",
    }
    case = zonesCase(tmp_path / "on", 1, inlet=inlet)
    active = onAndOff(case, tmp_path)
    assert active[-1] < 10
    assert case.result("p").max() > 2


def test_reasonIsGivenWhereThereAreNone(tmp_path):
    case = zonesCase(tmp_path / "case", 1)
    case.write("system/feSchemes", "timeScheme threeStep;"
               " shockCapturing pressureLaplacian;")
    case.write("system/controlDict", """
application shockShellFoam; startFrom startTime; startTime 0; stopAt endTime;
endTime 1e-5; deltaT 1e-5; writeControl timeStep; writeInterval 10;
""")
    assert "Quiescent zones: none, timeScheme threeStep" in run(case)
