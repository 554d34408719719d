"""The three problems of the comparison of speed against error."""
from pathlib import Path

import numpy as np

from blockMeshes import box
from exactSolutions import Riemann, vortex
from tetrahedra import tetrahedra

REFERENCE = Path(__file__).parent / "reference"
GAMMA = 1.4


def table(name):
    return np.genfromtxt(REFERENCE / name, delimiter=",", names=True,
                         skip_header=1)


def gridCells(nx, ny, nz=None):
    """Corners of the cells of one block of blockMesh; of its quadrilaterals at
    z = 0 without nz."""
    i, j, k = (np.arange(n) for n in (nx, ny, nz or 1))
    first = (i + (nx + 1) * (j[:, None] + (ny + 1) * k[:, None, None])).ravel()
    plane = np.array([0, 1, nx + 2, nx + 1])
    corners = plane if nz is None else np.r_[
        plane, plane + (nx + 1) * (ny + 1)]
    return first[:, None] + corners


class Problem:
    """One problem.

    mesh(n)            the mesh with n cells along a side; .cells its corners
    initial(x)         rho, U (n, 3), p at the start
    exact(x)           the compared quantities at `end`, (k, n)
    quantities         their names, the first is the one of the plot
    scales             what their errors are divided by
    sizes, finer       n for both codes; more n for ours alone, for errors
                       that the peer reaches and we would not
    gauges(points)     places of the gauges among these points, or none
    """

    plane = False
    gauges = None

    def results(self, rho, U, p):
        """The compared quantities of a state."""
        return {"rho": rho, "p": p, "u": U[:, 0]}


class Sod(Problem):
    name, title = "sod", "Sod's tube in 3D, tetrahedra"
    quantities, scales = ("rho", "u", "p"), (1, 1, 1)
    end = 0.2
    sizes, finer, quick = (50, 80, 120), (160,), (10, 20, 30)
    width = 0.1
    boundary = {
        "left": "open", "right": "open",
        **dict.fromkeys(("bottom", "top", "back", "front"), "wall"),
    }
    error = "exact Riemann solution"

    def mesh(self, n):
        across = round(n * self.width)
        return tetrahedra((n, across, across), (1, self.width, self.width),
                          shift=0.15)

    def initial(self, x):
        left = x[:, 0] < 0.5
        return (np.where(left, 1, 0.125), np.zeros((len(x), 3)),
                np.where(left, 1, 0.1))

    def exact(self, x):
        solution = Riemann((1, 0, 1), (0.125, 0, 0.1), GAMMA)
        return solution.sample((x[:, 0] - 0.5) / self.end)


class Bulb(Problem):
    """The paper's section 5.2 without the panel: an octant of a sphere."""

    name, title = "bulb", "spherical bulb in free air, tetrahedra"
    quantities, scales = ("rho", "p"), (1.2, 1e5)
    end = 1e-3
    sizes, finer, quick = (16, 24, 36), (54,), (6, 8, 10)
    side = 1.4
    kinds = dict.fromkeys(("left", "bottom", "back"), "symmetryPlane")
    boundary = dict.fromkeys(("right", "top", "front"), "open")
    error = "converged 1D solution"

    # source: the paper, sec. 5.2; densities with R = 287 J/(kg K)
    radius = 0.5
    inside, outside = (2967e3 / 287 / 1134.85, 2967e3), (1e5 / 287 / 290.36,
                                                         1e5)
    distances = 0.75, 1.0
    directions = np.array([(1, 0, 0), (1, 1, 0), (1, 1, 1)])

    def mesh(self, n):
        return tetrahedra((n, n, n), (self.side,) * 3, shift=0.15,
                          kinds=self.kinds)

    def initial(self, x):
        within = np.linalg.norm(x, axis=1) < self.radius
        rho, p = (np.where(within, a, b)
                  for a, b in zip(self.inside, self.outside))
        return rho, np.zeros((len(x), 3)), p

    def exact(self, x):
        profile = table("bulbProfileAt1ms.csv")
        r = np.linalg.norm(x, axis=1)
        return np.array([
            np.interp(r, profile["r_m"], values)
            for values in (profile["rho_kg_m3"], 1e3 * profile["p_kPa"])])

    def gauges(self, points):
        unit = self.directions / np.linalg.norm(
            self.directions, axis=1)[:, None]
        wanted = np.concatenate([d * unit for d in self.distances])
        near = [np.linalg.norm(points - w, axis=1).argmin() for w in wanted]
        return points[near]

    def peakError(self, places, peaks):
        """Mean over the gauges of the relative error of the overpressure."""
        stations = table("bulbStations.csv")
        exact = 1e3 * np.interp(np.linalg.norm(places, axis=1),
                                stations["r_m"],
                                stations["dp_peak_richardson_kPa"])
        return np.mean(abs((peaks - self.outside[1]) / exact - 1))


class BulbHexahedra(Bulb):
    name, title = "bulbHexahedra", "the same bulb on hexahedra"
    sizes, finer, quick = (24, 36, 54), (81,), (6, 8, 10)

    def mesh(self, n):
        mesh = box([(self.side, n)], (self.side, n), (self.side, n))
        for patch, kind in self.kinds.items():
            mesh.patches[patch] = (kind, mesh.patches[patch][1])
        mesh.cells = gridCells(n, n, n)
        return mesh


class Vortex(Problem):
    name, title = "vortex", "isentropic vortex, once across, quadrilaterals"
    quantities, scales = ("rho",), (1,)
    end = 10.0
    sizes, finer, quick = (32, 64, 128), (256,), (8, 12, 16)
    side = 10.0
    plane = True
    boundary = {}
    error = "exact"

    def mesh(self, n):
        mesh = box([(self.side, n)], (self.side, n))
        mesh.cyclic("left", "right").cyclic("bottom", "top")
        mesh.cells = gridCells(n, n)
        return mesh

    def initial(self, x):
        return vortex(x, 0)

    def exact(self, x):
        # Back where it started
        return vortex(x, 0)[0][None]


PROBLEMS = {
    problem.name: problem
    for problem in (Sod(), Bulb(), BulbHexahedra(), Vortex())
}
