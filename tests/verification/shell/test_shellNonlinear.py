"""Large displacements: the problems of Sze, Liu and Lo (2004, Finite Elements
in Analysis and Design 40, 1551-1569) that load steps can follow, elements with
assumed strains.

Sze's values were computed with 4-node shells on the mesh named in his tables
and are 0.1 to 0.4 % away from converged ones. n is the number of
quadrilaterals per side of the symmetric part, two triangles each.
"""
import numpy as np
import pytest

from shellCase import ShellCase, fixed, force, isotropic, ramp, symmetry
from shellShapes import annulus, cylinder, plate, sphere

X, Y, Z = (1, 0, 0), (0, 1, 0), (0, 0, 1)


def endShear(folder, n):
    case = ShellCase(folder, plate(n, 1, 10, 1), isotropic(1.2e6, 0, 0.1),
                     {"root": {"type": "clamped", "nodeSet": "uMin"}})
    u = case.solve({"tip": ramp({"type": "edge", "nodeSet": "uMax",
                                 "forcePerLength": (0, 0, 4)})}, steps=10)
    return -u[case.mesh.node("uMaxvMin"), 0], u[case.mesh.node("uMaxvMin"), 2]


def test_cantileverUnderEndShear(tmp_path, table):
    meshes = [4, 8, 16]
    ours = np.array([endShear(tmp_path/str(n), n) for n in meshes])
    # source: elastica with transverse shear; Sze (2004), 3.1: 3.286, 6.698
    for k, (quantity, exact) in enumerate([("-U", 3.28951), ("W", 6.70013)]):
        table.check("cantilever, end shear", meshes, quantity, ours[:, k],
                    exact, "elastica; Sze 3.1", (0.1, 0.02, 0.02))


def rollUp(folder, n, steps=200):
    """Director of the end turned once round, its position free: a moment."""
    L = 12
    turns = np.linspace(0, 2*np.pi, steps + 1)

    def driven(component, values):
        points = " ".join(f"({i/steps:.15g} {v:.15g})"
                          for i, v in enumerate(values))
        return {"type": "prescribed", "nodeSet": "uMax",
                "component": component, "displacement": f"table ({points})"}

    case = ShellCase(folder, plate(n, 1, L, 1), isotropic(1.2e6, 0, 0.1),
                     {"root": {"type": "clamped", "nodeSet": "uMin"},
                      "strip": {"type": "planeStrainStrip",
                                "direction": Y},
                      "x": driven("gx", -np.sin(turns)),
                      "z": driven("gz", np.cos(turns) - 1)})
    u = case.solve({}, steps=steps)
    return u[case.mesh.sets["uMax"]].mean(0)


def test_rollUp(tmp_path, table):
    """The strip closes to a circle: its end comes back to its root."""
    meshes = [4, 8, 16]
    ends = np.array([rollUp(tmp_path/str(n), n) for n in meshes])
    # source: exact, a circle of the strip's length
    table.check("roll-up, one full turn of the end", meshes,
                "-U of the end over the length", -ends[:, 0]/12, 1.,
                "exact; Sze 3.2", (0.01, 0.01, 0.01))
    assert np.all(abs(ends[:, 2])/12 < 1e-9)


def pinchedHemisphere(folder, n, steps):
    case = ShellCase(folder, sphere(n, 10, 72), isotropic(6.825e7, 0.3, 0.04),
                     {"x": symmetry("uMin", Y), "y": symmetry("uMax", X),
                      "height": fixed("uMinvMin", "z")})
    u = case.solve({"out": force("uMinvMin", (200, 0, 0)),
                    "in": force("uMaxvMin", (0, -200, 0))}, steps=steps)
    return (u[case.mesh.node("uMinvMin"), 0],
            -u[case.mesh.node("uMaxvMin"), 1])


def checkHemisphere(tmp_path, table, meshes, steps, bounds):
    ours = np.array([pinchedHemisphere(tmp_path/str(n), n, steps)
                     for n in meshes])
    # source: quadratic bricks 32 x 32, converged; Sze (2004), 3.4, mesh
    # 16 x 16: 4.067, 8.178
    for k, (quantity, reference) in enumerate([("outwards", 4.0742),
                                               ("inwards", 8.1516)]):
        table.check("pinched hemisphere, 400 N", meshes, quantity,
                    ours[:, k], reference, "bricks; Sze 3.4", bounds)


def test_pinchedHemisphere(tmp_path, table):
    checkHemisphere(tmp_path, table, [4, 6, 8], 25, (11, 4, 1.5))


@pytest.mark.long
def test_pinchedHemisphereOnFinerMeshes(tmp_path, table):
    checkHemisphere(tmp_path, table, [8, 10, 12], 25, (1.5, 1, 1))


def pulledCylinder(folder, n):
    mesh = cylinder(*n, 4.953, 10.35/2, 90)
    case = ShellCase(folder, mesh, isotropic(10.5e6, 0.3125, 0.094),
                     {"middle": symmetry("vMin", Y),
                      "top": symmetry("uMin", X), "side": symmetry("uMax", Z)})
    corners = [mesh.node(c) for c in ("uMinvMin", "uMaxvMin", "uMaxvMax")]
    return case, corners, {"pull": force("uMinvMin", (0, 0, 10000))}


def signed(u):
    """W at A, -U at B, -U at C, from displacements there."""
    return u[..., 0, 2], -u[..., 1, 0], -u[..., 2, 0]


def halfPulled(folder, n):
    """By load steps, until the shell is about to snap."""
    case, corners, loads = pulledCylinder(folder, n)
    return signed(case.solve(loads, steps=40, endTime=0.5)[corners])


def fullyPulled(folder, n):
    """By arc length, past the snap."""
    case, corners, loads = pulledCylinder(folder, n)
    p, u = case.path(loads, 0.004, 34, case.mesh.nodes[corners], maxGrowth=1)
    return [whole(p, values) for values in signed(u)]


def whole(p, values):
    """Where a path first comes to the whole load, by a cubic in the load."""
    k = int(np.argmax(p >= 1))
    assert k > 0, "the path ends too soon"
    near = slice(k - 2, k + 2)
    return np.polyval(np.polyfit(p[near] - 1, values[near], 3), 0)


# source: Sze (2004), 3.5, mesh 36 x 24, at half the load and at the whole; the
# shell snaps between the two, at 0.50 to 0.525 of 40 kN
@pytest.mark.parametrize("load,pull,meshes,references,bounds", [
    ("20 kN", halfPulled, [(4, 4), (6, 6), (8, 8)], (2.473, 3.653, 3.718),
     (3, 1.5, 1)),
    ("40 kN", fullyPulled, [(6, 4), (8, 6)], (2.768, 4.551, 3.269), (3, 2)),
    pytest.param(
        "40 kN", fullyPulled, [(6, 4), (9, 6), (12, 8)],
        (2.768, 4.551, 3.269), (3, 2, 1), marks=pytest.mark.long),
])
def test_pullOut(tmp_path, table, load, pull, meshes, references, bounds):
    ours = np.array([pull(tmp_path/f"{i}", n) for i, n in enumerate(meshes)])
    for k, quantity in enumerate(("W at A", "-U at B", "-U at C")):
        table.check(f"pull-out of an open cylinder, {load}",
                    [f"{a} x {b}" for a, b in meshes], quantity, ours[:, k],
                    references[k], "Sze 3.5", bounds)


def slitAnnulus(folder, n):
    """Held at one side of the slit, lifted at the other: W inside, outside."""
    nU, nV = n
    mesh = annulus(nU, nV, 6, 10, 360)
    case = ShellCase(folder, mesh, isotropic(21e6, 0, 0.03),
                     {"slit": {"type": "clamped", "nodeSet": "uMin"}})
    u = case.solve({"lift": ramp({"type": "edge", "nodeSet": "uMax",
                                  "forcePerLength": (0, 0, 0.8)})}, steps=20)
    return u[mesh.node("uMaxvMin"), 2], u[mesh.node("uMaxvMax"), 2]


def test_slitAnnulus(tmp_path, table):
    meshes = [(8, 1), (12, 2), (16, 2)]
    ours = np.array([slitAnnulus(tmp_path/str(i), n)
                     for i, n in enumerate(meshes)])
    # source: Sze (2004), 3.3, mesh 80 x 10, as in MBDyn's sze33_ref.dat
    for k, (quantity, reference) in enumerate([("W inside", 13.891),
                                               ("W outside", 17.528)]):
        table.check("slit annular plate, 0.8 per length",
                    [f"{a} x {b}" for a, b in meshes], quantity, ours[:, k],
                    reference, "Sze 3.3", (5, 1.5, 1))
