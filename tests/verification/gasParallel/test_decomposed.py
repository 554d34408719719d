"""Decomposed runs against the serial one.

A blast in a box with a cyclic pair, walls and far fields, cells cut by several
processors; 200 steps, one of the cases with gravity. With a moving mesh also
viscous, with no-slip walls and gravity. The
fields of the reconstructed case agree to rounding, whatever the number of
processors and the way of cutting.
"""
import re
import shutil
import sys
from pathlib import Path

import numpy as np
import pytest

sys.path.insert(0, str(Path(__file__).parents[1] / "gasBenchmarks"))

from benchmarkCase import BenchmarkCase  # noqa: E402
from blockMeshes import HEADER, box  # noqa: E402

STEPS, DELTA_T = 200, 2e-3
END = STEPS * DELTA_T

# Relative to the largest value
TOLERANCE = 1e-10

SIDES = {
    "left": "far", "right": "far", "bottom": "wall", "top": "wall",
}
# Gas that comes in, the more the later
INFLOW = {
    name: f"type farField; uniformValue table ((0 {start}) ({END} {end}));"
    for name, start, end in (
        ("p", "1", "1.5"), ("U", "(0.3 0.1 0)", "(0.6 0.2 0)"), ("T", "1", "1.2")
    )
}
# The mesh follows the right end, which oscillates
MOVING = {
    "right": "type oscillatingDisplacement; amplitude (0.1 0 0); omega 9;"
             " value uniform (0 0 0);",
    "bottom": "type slip;", "top": "type slip;", "back": "type slip;",
    "front": "type slip;",
}


# Waves from a place inside, whose afterflow the nodes keep account of
CURVED = {
    "right": {
        "p": "type farField; value uniform 1; waves spherical;"
             " origin (0.4 0.5 0.3);",
        "U": "type farField; value uniform (0.3 0.1 0);",
        "T": "type farField; value uniform 1;",
    },
}


STICKY = {
    "bottom": {"p": "type zeroGradient;", "U": "type noSlip;",
               "T": "type fixedValue; value uniform 1.2;"},
    "top": {"p": "type zeroGradient;", "T": "type zeroGradient;",
            "U": "type noSlip; value uniform (0.5 0 0.2);"},
}


GRAVITY = {"cyclic": (0.5, -2.0, 0.0), "viscous": (1.0, -2.0, 0.5)}


def blast(x):
    bump = np.exp(-((x - [0.3, 0.4, 0.5])**2).sum(axis=1) / 0.02)
    U = np.outer(np.ones(len(x)), [0.3, 0.1, 0.0])
    return 1 + 2 * bump, U, 1 + 5 * bump


def makeCase(folder, kind):
    mesh = box([(1, 12)], (1, 10), (1, 8))
    if kind == "cyclic":
        mesh.cyclic("back", "front")
    case = BenchmarkCase(folder, mesh, mu=0.01 if kind == "viscous" else 0,
                         gravity=GRAVITY.get(kind))
    sides = dict(SIDES, **(
        {"left": INFLOW} if kind == "cyclic"
        else {"back": "wall", "front": "wall"}))
    if kind == "viscous":
        sides.update(STICKY)
    if kind == "moving":
        sides.update(CURVED)
    case.start(blast, sides)
    if kind != "cyclic":
        case.move("pointDisplacement", MOVING)
    case.write("system/controlDict", f"""
application shockShellFoam; libs ("libtaylorGalerkin.so");
startFrom startTime; startTime 0; stopAt endTime; endTime {END};
deltaT {DELTA_T}; writeControl timeStep; writeInterval {STEPS};
writeFormat ascii; writePrecision 17; timeFormat general; timePrecision 8;
runTimeModifiable no;
""")
    return case


def decompose(case, parts, method):
    counts = {2: "(2 1 1)", 4: "(2 2 1)", 8: "(2 2 2)"}[parts]
    case.write("system/decomposeParDict", f"""
numberOfSubdomains {parts}; method {method};
simpleCoeffs {{ n {counts}; delta 0.001; }}
""")
    case.run("decomposePar", "-force")
    case.log = case.run(
        "mpirun", "--allow-run-as-root", "--oversubscribe",
        "-np", str(parts), "shockShellFoam", "-parallel")
    case.run("reconstructPar", "-latestTime")


def fields(case):
    return {name: case.result(name) for name in "pUT"}


def limits(case):
    """Stable steps of the log, and the nodes that rule them."""
    found = re.findall(r"Stable step (\S+) s: .* node (\d+)", case.log)
    assert len(found) == STEPS
    return np.array(found, float).T


@pytest.fixture(scope="module", params=["cyclic", "moving", "viscous"])
def serial(request, tmp_path_factory):
    folder = tmp_path_factory.mktemp(request.param)
    case = makeCase(folder / "serial", request.param)
    case.log = case.run("shockShellFoam")
    return folder, request.param, fields(case), limits(case)


@pytest.mark.parametrize("parts, method", [
    (2, "scotch"), (4, "simple"), (8, "scotch"),
])
def test_sameAnswer(serial, parts, method):
    folder, kind, reference, stable = serial
    case = makeCase(folder / f"{method}{parts}", kind)
    decompose(case, parts, method)
    for name, values in fields(case).items():
        expected = reference[name]
        error = np.abs(values - expected).max() / np.abs(expected).max()
        print(name, error)
        assert error <= TOLERANCE
    steps, nodes = limits(case)
    assert np.allclose(steps, stable[0], rtol=TOLERANCE)
    # Of several nodes with the same step, up to rounding, the lowest is named
    assert (nodes == stable[1]).all()
    # The blast has gone through the box
    assert np.ptp(reference["p"]) > 0.3
    shutil.rmtree(case.path)
