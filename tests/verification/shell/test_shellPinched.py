"""The pinched cylinder with end diaphragms of Sze, Liu and Lo (2004), 3.6, at
its full load. The shell snaps many times on the way; it is followed in motion,
loaded within a second and heavily damped, its vibrations a thousand times
faster than that. n is the number of quadrilaterals per side of an eighth.
"""
import numpy as np
import pytest

from shellCase import ShellCase, fixed, isotropic, symmetry
from shellFiles import readState
from shellShapes import cylinder

X, Y, Z = (1, 0, 0), (0, 1, 0), (0, 0, 1)
LOAD, RAMP, END, STEP = 3000, 1, 1.12, 0.04


def pinched(folder, n):
    """-W under the load, U at the side, at rest under the full load."""
    mesh = cylinder(n, n, 100, 100, 90)
    case = ShellCase(folder, mesh, isotropic(30e3, 0.3, 1, rho=1e-6),
                     {"middle": symmetry("vMin", Y),
                      "top": symmetry("uMin", X), "side": symmetry("uMax", Z),
                      "diaphragm": fixed("vMax", "x", "z")})
    case.begin(
        {"pinch": {"type": "nodal", "nodeSet": "uMinvMin",
                   "force": (0, 0, -LOAD),
                   "factor": f"table ((0 0) ({RAMP} 1) (2 1))"}},
        analysis="dynamic", timeIntegrator="generalisedAlpha",
        generalisedAlphaCoeffs={"spectralRadius": 0}, massDamping=50,
        newton={"maxCuts": 8})
    case.control(endTime=END, deltaT=STEP, writeInterval=round(END/STEP))
    case.start(timeout=3000)
    line = case.log.split("max displacement")[-1].splitlines()[0]
    strain, kinetic = (float(line.split(f"{name} energy = ")[1].split()[0])
                       for name in ("strain", "kinetic"))
    assert kinetic < 1e-4*strain
    u = readState(case.case, END)["position"] - mesh.nodes
    return (-u[mesh.node("uMinvMin"), 2], u[mesh.node("uMaxvMin"), 0])


def check(tmp_path, table, meshes, bounds):
    ours = np.array([pinched(tmp_path/str(n), n) for n in meshes])
    # source: Sze (2004), 3.6, mesh 48 x 48, as in MBDyn's sze36_ref.dat
    for k, (quantity, reference) in enumerate([("-W at A", 83.102),
                                               ("U at B", 34.272)]):
        table.check("pinched cylinder with diaphragms, 12 kN", meshes,
                    quantity, ours[:, k], reference, "Sze 3.6",
                    [pair[k] for pair in bounds])


@pytest.mark.long
def test_pinchedCylinder(tmp_path, table):
    check(tmp_path, table, [8, 12, 16], [(5, 26), (1, 3), (1, 1.5)])
