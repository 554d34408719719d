"""The linear obstacle course, elements with assumed strains, three meshes each.

Loads are scaled down until displacements are linear in them to the digits
compared. n is the number of quadrilaterals per side of the symmetric part, two
triangles each; every mesh has its bound, in percent of the reference.
"""
import numpy as np
import pytest

from shellCase import ShellCase, fixed, force, isotropic, ramp, symmetry
from shellShapes import cylinder, plate, skewPlate, sphere, twistedBeam

X, Y, Z = (1, 0, 0), (0, 1, 0), (0, 0, 1)


def surface(value):
    return {"all": ramp({"type": "traction", "traction": value})}


def scordelisLo(folder, n):
    scale = 1e-4
    case = ShellCase(folder, cylinder(n, n, 25, 25, 40),
                     isotropic(4.32e8, 0, 0.25),
                     {"diaphragm": fixed("vMin", "x", "z", "gx", "gz"),
                      "middle": symmetry("vMax", Y),
                      "crown": symmetry("uMin", X)})
    u = case.solve(surface((0, 0, -90*scale)))
    return -u[case.mesh.node("uMaxvMax"), 2]/scale


def test_scordelisLo(tmp_path, table):
    meshes = [2, 4, 8]
    ours = [scordelisLo(tmp_path/str(n), n) for n in meshes]
    # source: 3D quadratic bricks, converged; shear-flexible shells 0.301334
    # (Krysl), deep-shell value of MacNeal and Harder (1985) 0.3024
    table.check("Scordelis-Lo roof", meshes, "mid-edge deflection", ours,
                0.3014, "bricks; Krysl .301334", (0.6, 0.3, 0.3))


def hemisphere(folder, n, thickness, load):
    case = ShellCase(folder, sphere(n, 10, 72),
                     isotropic(6.825e7, 0.3, thickness),
                     {"x": symmetry("uMin", Y), "y": symmetry("uMax", X),
                      "height": fixed("uMinvMin", "z")})
    u = case.solve({"out": force("uMinvMin", (load/2, 0, 0)),
                    "in": force("uMaxvMin", (0, -load/2, 0))})
    return (u[case.mesh.node("uMinvMin"), 0]
            - u[case.mesh.node("uMaxvMin"), 1])/2


@pytest.mark.parametrize("thickness, load, meshes, reference, source, bounds", [
    # source: 3D quadratic bricks 48 x 48; MacNeal and Harder (1985) 0.0940,
    # Ko, Lee and Bathe (2017) 0.0930
    (0.04, 2, (2, 4, 8), 0.093715, "bricks; MacNeal .0940, Ko .0930",
     (4, 0.6, 0.5)),
    # source: Ko, Lee and Bathe (2017)
    (0.004, 2e-3, (2, 4, 8), 0.0930, "Ko 2017", (8, 3.5, 2)),
    # source: ccx 2.20, C3D20R bricks 48 x 48
    (0.004, 2e-3, (8, 12, 16), 0.09172, "bricks", (0.5, 0.5, 0.5)),
])
def test_pinchedHemisphere(tmp_path, table, thickness, load, meshes, reference,
                           source, bounds):
    scale = 1e-4
    ours = [hemisphere(tmp_path/str(n), n, thickness, scale*load)/scale
            for n in meshes]
    table.check(f"pinched hemisphere, R/t {10/thickness:.0f}", meshes,
                "displacement under the loads", ours, reference, source, bounds)


def shearRigid(E, nu, thickness, axis, factor=100):
    """An isotropic section but for its transverse shear, stiff by a factor:
    what thin shell theory assumes."""
    G = 0.5*E/(1 + nu)
    return {"all": {"thickness": thickness, "material": {
        "type": "orthotropic", "E1": E, "E2": E, "E3": E, "nu12": nu,
        "nu13": nu, "nu23": nu, "G12": G, "G13": factor*G, "G23": factor*G,
        "rho": 1, "axis": axis}}}


def pinchedCylinder(folder, n, section=isotropic(3e6, 0.3, 3)):
    case = ShellCase(folder, cylinder(n, n, 300, 300, 90), section,
                     {"diaphragm": fixed("vMin", "x", "z", "gx", "gz"),
                      "middle": symmetry("vMax", Y),
                      "top": symmetry("uMin", X), "side": symmetry("uMax", Z)})
    u = case.solve({"point": force("uMinvMax", (0, 0, -0.25))})
    return -u[case.mesh.node("uMinvMax"), 2]


def test_pinchedCylinder(tmp_path, table):
    meshes = [4, 8, 12]
    ours = [pinchedCylinder(tmp_path/str(n), n) for n in meshes]
    # source: MacNeal and Harder (1985), thin shells; with transverse shear the
    # value under a point grows without end (bricks 32 x 32: 1.844e-5)
    table.check("pinched cylinder", meshes, "displacement under the load",
                ours, 1.8248e-5, "MacNeal 1985", (7, 1, 1.5))


def test_pinchedCylinderOfThinShellTheory(tmp_path, table):
    """The reference's own model, to its last digit but one."""
    meshes = [4, 8, 12]
    section = shearRigid(3e6, 0.3, 3, Y)
    ours = [pinchedCylinder(tmp_path/str(n), n, section) for n in meshes]
    # source: MacNeal and Harder (1985)
    table.check("pinched cylinder, rigid in transverse shear", meshes,
                "displacement under the load", ours, 1.8248e-5, "MacNeal 1985",
                (11, 1, 0.1))


def clampedPlate(folder, n, thickness, edges):
    E, nu = 1e4, 0.3
    D = E*thickness**3/12/(1 - nu**2)
    scale = 1e-3*thickness
    supports = {"x": symmetry("uMax", X), "y": symmetry("vMax", Y)}
    for edge, tangent in (("uMin", "y"), ("vMin", "x")):
        supports[edge] = (
            {"type": "clamped", "nodeSet": edge} if edges == "clamped"
            else fixed(edge, "z", tangent, "g" + tangent))
    case = ShellCase(folder, plate(n, n, 0.5, 0.5),
                     isotropic(E, nu, thickness), supports)
    u = case.solve(surface((0, 0, scale*D)))
    return u[case.mesh.node("uMaxvMax"), 2]/scale


@pytest.mark.parametrize("edges, thickness, reference", [
    # source: Mindlin's plate (Ritz) with shear factor 5/6; thin: Kirchhoff
    ("clamped", 1e-2, 0.0012679), ("clamped", 1e-3, 0.00126534),
    ("clamped", 1e-4, 0.00126532),
    ("simply supported", 1e-2, 0.0040645),
    ("simply supported", 1e-4, 0.00406235),
])
def test_squarePlate(tmp_path, table, edges, thickness, reference):
    meshes = [1, 2, 4]
    ours = [clampedPlate(tmp_path/str(n), n, thickness, edges) for n in meshes]
    table.check(f"{edges} square plate, t/a {thickness:g}", meshes,
                "w D/(q a^4) at the middle", ours, reference,
                "Mindlin, Kirchhoff", (9, 1, 0.2))


def beam(folder, nU, nV, thickness, load, direction):
    case = ShellCase(folder, twistedBeam(nU, nV),
                     isotropic(29e6, 0.22, thickness),
                     {"root": {"type": "clamped", "nodeSet": "uMin"}})
    traction = np.zeros(3)
    traction[direction] = load/1.1
    u = case.solve({"end": ramp({"type": "edge", "nodeSet": "uMax",
                                 "forcePerLength": tuple(traction)})})
    end = u[case.mesh.sets["uMax"], direction]
    return end[len(end)//2] if len(end) % 2 else end.mean()


@pytest.mark.parametrize("thickness, load, direction, reference, source", [
    # source: Zupan and Saje (2004), as quoted by Krysl. Fully clamped 3D solids
    # converge to 0.005411 and 0.0017490 for the thick one
    (0.32, 1, 2, 0.005424535, "Zupan 2004; solids .005411"),
    (0.32, 1, 1, 0.001753248, "Zupan 2004; solids .001749"),
    # source: MacNeal and Harder's beam made thin, Belytschko et al. (1989)
    (0.0032, 1e-6, 2, 0.005256, "as quoted by Krysl"),
    (0.0032, 1e-6, 1, 0.001294, "as quoted by Krysl"),
])
def test_twistedBeam(tmp_path, table, thickness, load, direction, reference,
                     source):
    scale = 1e-2
    meshes = [(3, 1), (6, 2), (12, 2)]
    ours = [beam(tmp_path/str(i), *m, thickness, scale*load, direction)/scale
            for i, m in enumerate(meshes)]
    table.check(f"twisted beam, t {thickness:g}, load along "
                + "xyz"[direction], [f"{a}x{b}" for a, b in meshes],
                "displacement of the end", ours, reference, source,
                (3.5, 1, 0.5))


def skew(folder, n, degrees):
    scale = 1e-2
    mesh = skewPlate(n, 1., degrees)
    rim = np.unique(np.concatenate(
        [mesh.sets[e] for e in ("uMin", "uMax", "vMin", "vMax")]))
    mesh.sets["rim"] = rim
    mesh.sets["middle"] = [
        int(np.linalg.norm(mesh.nodes - mesh.nodes.mean(0), axis=1).argmin())]
    case = ShellCase(folder, mesh, isotropic(3e7, 0.3, 0.01),
                     {"rim": fixed("rim", "z"),
                      "a": fixed("uMinvMin", "x", "y"),
                      "b": fixed("uMaxvMin", "y")})
    u = case.solve(surface((0, 0, scale)))
    return u[mesh.node("middle"), 2]/scale


@pytest.mark.parametrize("degrees, meshes, reference, source, bounds", [
    # source: Morley (1963), as quoted in CATIA's ELFINI guide, elfugbt0105
    (80, (4, 8, 12), 1.409e-3, "Morley 1963", (1, 1, 1)),
    # Kirchhoff; supports that hold w alone give more with transverse shear
    (30, (4, 8, 12), 0.1485e-3, "Morley 1963", (1, 3, 4)),
    # source: ccx 2.20, one layer of C3D20R bricks held by w at an edge of the
    # rim, 48 x 48 (16 x 16: 0.14266e-3, 32 x 32: 0.15304e-3)
    (30, (8, 12, 16), 0.15475e-3, "bricks", (3, 1.5, 1)),
])
def test_skewPlate(tmp_path, table, degrees, meshes, reference, source,
                   bounds):
    ours = [skew(tmp_path/str(n), n, degrees) for n in meshes]
    table.check(f"skew plate, {degrees} degrees, simply supported", meshes,
                "deflection of the middle", ours, reference, source,
                bounds)


def orthotropicPlate(folder, n):
    """Hard simply supported square plate, stiff along x; w at the middle."""
    E1, E2, G, nu12, h = 25e6, 1e6, 0.5e6, 0.25, 1e-3
    section = {"all": {"thickness": h, "material": {
        "type": "orthotropic", "E1": E1, "E2": E2, "E3": E2, "nu12": nu12,
        "nu13": nu12, "nu23": nu12, "G12": G, "G13": G, "G23": 0.2e6,
        "rho": 1, "axis": X}}}
    case = ShellCase(folder, plate(n, n, 0.5, 0.5), section, {
        "x": symmetry("uMax", X), "y": symmetry("vMax", Y),
        "edgeX": fixed("uMin", "z", "y", "gy"),
        "edgeY": fixed("vMin", "z", "x", "gx")})
    part = h**3/12/(1 - nu12**2*E2/E1)
    D1, D2, D3 = E1*part, E2*part, nu12*E2*part + 2*G*h**3/12
    q = 1e-9
    exact = sum(
        16*q/np.pi**6/(m*k)*np.sin(m*np.pi/2)*np.sin(k*np.pi/2)
        / (D1*m**4 + 2*D3*m**2*k**2 + D2*k**4)
        for m in range(1, 200, 2) for k in range(1, 200, 2))
    u = case.solve(surface((0, 0, q)))
    return u[case.mesh.node("uMaxvMax"), 2]/exact


def test_orthotropicPlate(tmp_path, table):
    meshes = [1, 2, 4]
    ours = [orthotropicPlate(tmp_path/str(n), n) for n in meshes]
    # source: Navier's series for Kirchhoff's orthotropic plate; t/a = 0.001
    table.check("orthotropic square plate, E1/E2 25, simply supported", meshes,
                "deflection of the middle over the series", ours, 1.,
                "Navier", (25, 2, 0.2))
