"""What the log says about the step, and a step that shrinks without end."""
import re

import numpy as np

from gasBox import GAMMA, GasBox
from pistonBox import PistonBox

C = np.sqrt(GAMMA)  # rho = p = 1
LINE = re.compile(
    r"Stable step (\S+) s: (convection|artificial viscosity) at node (\d+)"
    r" \((\S+) (\S+) (\S+)\)\ndeltaT = (\S+)\n")


def steps(case):
    found = LINE.findall(case.log)
    assert len(found) == case.log.count("\nTime = ")
    return found


def test_logNamesTheLimitAndItsPlace(tmp_path):
    """A jump of the pressure: the faster gas behind it limits, with
    artificial viscosity at the jump."""
    limits = {}
    for capturing, coeffs in (("none", ""), (
        "pressureLaplacian", "pressureLaplacianCoeffs { qDif 2; }",
    )):
        case = GasBox(tmp_path / capturing, (1,), (50,))
        case.schemes(f"timeScheme twoStep; shockCapturing {capturing}; {coeffs}")
        p = np.where(case.x[:, 0] < 0.5, 3.0, 1.0)
        case.start(np.ones(len(p)), (0, 0, 0), p)
        assert case.runTo(0.02, adjustTimeStep="yes", maxCo="0.4") == 0
        first = steps(case)[0]
        limits[capturing] = first[1]
        if capturing == "none":
            # source: (G10) on a line, dx/c of the faster gas
            assert abs(float(first[0]) / (0.02 / (C * 3**0.5)) - 1) < 1e-5
            assert float(first[3]) < 0.5
        else:
            assert abs(float(first[3]) - 0.5) < 0.03
        assert 0.3 < float(first[6]) / float(first[0]) <= 0.4
    assert limits == {"none": "convection",
                      "pressureLaplacian": "artificial viscosity"}


def stopped(case, *words):
    assert case.exitCode not in (0, None)
    for word in words:
        assert word in case.log, case.log[-2500:]
    # The state that it names is there and can be read
    written = re.search(r"The state is written to (\S+)", case.log).group(1)
    for name in ("p", "U", "T", "rho"):
        assert np.isfinite(case.pointField(name, written)).all()
    return written


def test_cellsThatCollapse(tmp_path):
    """A piston that closes the gap altogether: each step takes a part of what
    is left of it."""
    case = PistonBox(
        tmp_path / "case", (4,), "type uniformFixedValue; uniformValue table"
        " ((0 (0 0 0)) (1 (1 0 0)) (2 (1 0 0)));", "inverseDistance")
    case.schemes("timeScheme twoStep; shockCapturing fluxCorrected;")
    case.start(np.ones(len(case.x)), (0, 0, 0), 1.0)
    case.runTo(1.5, adjustTimeStep="yes", maxCo="0.8")
    stopped(case, "has shrunk to", "convection at node", "minDeltaT",
            "cells collapse", "(")
    last = steps(case)[-1]
    assert float(last[0]) < 1e-5 * float(steps(case)[0][0])


def test_minDeltaT(tmp_path):
    case = GasBox(tmp_path / "case", (1,), (50,))
    case.schemes("timeScheme twoStep;")
    case.start(np.ones(len(case.x)), (0, 0, 0), 1.0)
    case.runTo(0.05, adjustTimeStep="yes", maxCo="0.5")
    assert case.exitCode == 0
    # The stable step is 0.0169
    case.run("foamDictionary", "system/controlDict", "-entry", "minDeltaT",
             "-add", "0.02")
    case.runTo(0.05)
    assert stopped(case, "has shrunk to 0.016", "minDeltaT is 0.02") == "0"


def test_unphysicalStateOnAMovingMesh(tmp_path):
    """A piston that is pulled away faster and faster until the gas cannot
    follow in one step. What is written is the mesh and the gas before the
    step, and a run with shorter steps goes on from there."""
    cells, times, places = (20, 4), (0, 0.2, 0.24, 1.24), (0, 0, -0.04, -40.04)
    table = " ".join(f"({t} ({x} 0 0))" for t, x in zip(times, places))
    case = PistonBox(
        tmp_path / "case", cells, "type uniformFixedValue; uniformValue table"
        f" ({table});", "inverseDistance")
    case.schemes("timeScheme twoStep; shockCapturing fluxCorrected;")
    case.start(np.ones(len(case.x)), (0, 0, 0), 1.0)
    case.set("system/controlDict", "writePrecision", "17")
    case.runTo(0.4, deltaT="0.02", adjustTimeStep="no")
    assert case.exitCode not in (0, None)
    assert "no longer in a physical state" in case.log
    written = case.times()[-1]
    assert 0.2 < float(written) < 0.4
    piston = case.points(written)[:, 0].min()
    assert abs(piston - np.interp(float(written), times, places)) < 1e-12
    assert piston < -0.03
    first = case.mass(written, cells)
    # The gas constant of the case and of this test agree to 1e-5
    assert abs(first - 1) < 1e-5

    case.set("system/controlDict", "startFrom", "latestTime")
    end = f"{float(written) + 0.002:.10g}"
    case.runTo(end, deltaT="1e-4", adjustTimeStep="no")
    assert case.exitCode == 0, case.log[-2000:]
    assert case.times()[-1] == end
    assert abs(case.mass(end, cells) / first - 1) < 1e-12
