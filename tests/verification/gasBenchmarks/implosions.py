"""Noh's problem and point explosions on boxes of one to three directions with
the centre in a corner, and on slices of cylinders and spheres."""
import re

import numpy as np

from benchmarkCase import BenchmarkCase
from blockMeshes import axisymmetric, box, wedge
from exactSolutions import noh

COLD = 1e-6  # pressure instead of none


def corner(directions, cells, length=1.0):
    """Box mesh; boundary: walls through the centre, the rest `outer`."""
    more = [(length, cells)] * (directions - 1)
    mesh = box([(length, cells)], *more)
    walls = ("left", "bottom", "back")
    return mesh, walls


def slices(directions, cells, length=1.0):
    """Lines along a radius of a cylinder (2) or a sphere (3)."""
    return wedge(length, cells, directions - 1), ()


def quarter(directions, cells, length=1.0):
    """Half a plane through a sphere's axis, which is along x."""
    return axisymmetric(length, length, (cells, cells)), ("left",)


def radius(mesh, x):
    """In the directions that the scene has."""
    return np.sqrt((x[:, :mesh.dim]**2).sum(axis=1))


def boundary(mesh, walls, outer):
    return {
        name: "wall" if name in walls else outer
        for name, (kind, _) in mesh.patches.items() if kind == "patch"
    }


NOH_END = 0.6
NOH_REACH = 0.35  # what comes from the fixed outer boundary stays outside


def runNoh(folder, directions, cells, meshOf=corner):
    """case, radius, rho and the exact rho of nodes within NOH_REACH."""
    mesh, walls = meshOf(directions, cells)
    case = BenchmarkCase(folder, mesh, gamma=5 / 3)

    def state(x):
        r = radius(mesh, x)[:, None]
        U = -x * (np.arange(3) < mesh.dim) / np.where(r > 0, r, 1)
        return np.ones(len(x)), U, COLD

    case.start(state, boundary(mesh, walls, "fixed"))
    case.runTo(NOH_END)
    r = radius(mesh, case.x)
    near = r < NOH_REACH
    exact = noh(r[near], NOH_END, directions)[0]
    return case, r[near], case.result("rho")[near], exact


def explosion(folder, directions, cells, end, length=1.2, width=3.0,
              meshOf=corner):
    """Energy 1 within `width` elements of the centre, in cold gas of density
    1. Returns the case after its run."""
    mesh, walls = meshOf(directions, cells, length)
    case = BenchmarkCase(folder, mesh)
    h = length / cells

    def state(x):
        # A smooth hat, so that the energy hardly depends on how nodes are
        # counted; the energy that the case really has is in its log
        s = np.minimum(radius(mesh, x) / (width * h), 1)
        hat = 1 + np.cos(np.pi * s)
        whole = integral(directions) * (width * h)**directions
        return np.ones(len(x)), 0.0, COLD + 0.4 * hat / whole

    case.start(state, boundary(mesh, walls, "wall"))
    case.runTo(end)
    return case


def integral(directions):
    """Of the hat over all directions, per width**directions:
    int (1 + cos pi s) A s^(j-1) ds, A = 2, 2 pi, 4 pi."""
    s = (np.arange(2000) + 0.5) / 2000
    area = {1: 2, 2: 2 * np.pi, 3: 4 * np.pi}[directions]
    return area * ((1 + np.cos(np.pi * s)) * s**(directions - 1)).mean()


def energyHeld(case, directions, length):
    """Energy of the explosion from the closing line of the log, for all
    directions (1: for one side). The box holds 1/2^directions of it."""
    total = float(re.search(
        r"Gas at the end:.*energy (\S+) J", case.log).group(1))
    still = COLD / 0.4 * length**directions
    return (total - still) * (2**directions if directions > 1 else 1)


def energyOfAll(case, volume):
    """The same for a part of the scene, whose density was 1 everywhere: scaled
    up to the given volume. With few elements over the charge the energy of the
    nodes differs from that of the function by some percent."""
    mass, total = (
        float(re.search(rf"Gas at the end:.*{word} ([\d.e+-]+)", case.log)
              .group(1))
        for word in ("mass", "energy")
    )
    return (total - COLD / 0.4 * mass) * volume / mass
