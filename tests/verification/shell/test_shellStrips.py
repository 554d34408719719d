"""Strips and a panel in motion, large displacements, against geometrically
exact beams and plane strain solids: elements with assumed strains, three
meshes each. n is the number of quadrilaterals along the strip.
"""
import numpy as np
import pytest

from shellCase import Surface, isotropic, symmetry
from shellMotion import MovingCase, greatestDifference, reference
from shellShapes import plate, stacked

CLAMP = {"root": {"type": "clamped", "nodeSet": "uMin"}}
PLANE = {"strip": {"type": "planeStrainStrip", "direction": (0, 1, 0)}}


def swing(folder, n, thickness, E, nu, rho, load, until, deltaT, supports):
    """Motion of the tip of a cantilever of length 10: times, (time, xyz)."""
    case = MovingCase(
        folder, plate(n, 1, 10, 1), isotropic(E, nu, thickness, rho),
        {**CLAMP, **supports})
    times, u = case.march({"sudden": load}, until, deltaT,
                          points=[(10, 0.5, 0)])
    return times, u[:, 0, :]


def dead(q):
    return {"type": "traction", "traction": (0, 0, q)}


def follower(q):
    return {"type": "followerPressure", "pressure": -q}


@pytest.mark.parametrize("kind", ["dead", "follower"])
def test_suddenlyLoadedStrip(tmp_path, table, kind):
    """L/h = 100: the tip to the end of the first swing back."""
    load = {"dead": dead, "follower": follower}[kind](0.4)
    file = f"dyn_D1_strip_{kind}_beam2d.csv"
    meshes, errors = [4, 6, 8], []
    for n in meshes:
        times, u = swing(tmp_path/str(n), n, 0.1, 1.2e6, 0, 0.01, load, 0.56,
                         2e-3, PLANE)
        errors.append(greatestDifference(
            times, u[:, (0, 2)], reference(file), 0.56))
    table.below(
        f"suddenly loaded strip, {kind} load", meshes,
        "tip, greatest difference [%]", errors,
        "own geometrically exact beam, confirmed by ccx S8R", (2, 1, 0.5))


@pytest.mark.parametrize("kind", ["dead", "follower"])
def test_thickCantilever(tmp_path, table, kind):
    """Bathe, Ramm and Wilson (1975): L/h = 10, a step of 2.85 lb/in."""
    load = {"dead": dead, "follower": follower}[kind](2.85)
    file = f"dyn_bathe_cantilever_{kind}_beam2d.csv"
    meshes, errors = [2, 4, 8], []
    for n in meshes:
        times, u = swing(tmp_path/str(n), n, 1, 12000, 0.2, 1e-6, load, 2.8e-3,
                         1e-5, {})
        errors.append(greatestDifference(
            times, u[:, (0, 2)], reference(file), 2.8e-3))
    table.below(
        f"cantilever of Bathe, Ramm and Wilson, {kind} load", meshes,
        "tip, greatest difference [%]", errors,
        "own geometrically exact beam", (1, 1, 1))


def panel(n):
    """Half an arc of R = 5, half angle 30 degrees; crown at uMin."""
    def normal(u, v):
        return stacked(np.sin(np.pi/6*u), 0*u, np.cos(np.pi/6*u))
    return Surface(n, 1, lambda u, v: 5*normal(u, v) + stacked(0*u, v, 0*u),
                   normal)


def test_snapThroughOfAPanel(tmp_path, table):
    """After Kuhl and Ramm: the crown under a line load that grows, to 0.1 s,
    where the panel snaps."""
    meshes, errors = [4, 8, 16], []
    for n in meshes:
        case = MovingCase(
            tmp_path/str(n), panel(n), isotropic(200e9, 0.25, 0.1, 1e4),
            {**PLANE, "crown": symmetry("uMin", (1, 0, 0)),
             "hinge": {"type": "hinged", "nodeSet": "uMax"}})
        times, u = case.march(
            {"crown": {"type": "edge", "nodeSet": "uMin",
                       "forcePerLength": (0, 0, -2.5e7),
                       "factor": "polynomial ((5 1))"}},
            0.1, 2.5e-4, "energyMomentum", points=[(0, 0.5, 5)])
        errors.append(greatestDifference(
            times, -u[:, 0, 2:], reference("dyn_D5_panel_to0.1s_n80_ccx.csv"),
            0.1))
    table.below(
        "dynamic snap-through of a panel", meshes,
        "crown, greatest difference [%]", errors,
        "own ccx 2.20, 80 CPE8; data as in Siqueira (2019)", (0.5, 0.3, 0.3))
