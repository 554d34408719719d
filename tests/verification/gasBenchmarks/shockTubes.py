"""Riemann problems in tubes: cases, meshes and exact solutions."""
from dataclasses import dataclass

import numpy as np

from benchmarkCase import BenchmarkCase
from blockMeshes import box
from errorNorms import l1, weights1D
from exactSolutions import Riemann


PIECES = 50  # for the mean of an exact solution over a node's element


@dataclass
class Tube:
    """States (rho, u, p) on the two sides of x0; length from 0."""
    left: tuple
    right: tuple
    x0: float
    end: float
    length: float = 1.0
    gamma: float = 1.4

    def exact(self, low, high, shift):
        """Means of rho, u and p at the end from low to high; the diaphragm
        is at x0 + shift."""
        solution = Riemann(self.left, self.right, self.gamma)
        parts = (np.arange(PIECES) + 0.5) / PIECES
        return sum(
            solution.sample(
                (low + s * (high - low) - self.x0 - shift) / self.end)
            for s in parts
        ) / PIECES

    def state(self, x):
        inside = (x[:, 0] <= self.x0 * (1 + 1e-9))[:, None]
        values = np.where(inside, self.left, self.right)
        return values.T


# source: reference riemann_star_states.csv; LeBlanc: R. Loubere and
# M. Shashkov, J. Comput. Phys. 209 (2005) 105-138, sec. 6.3 (e = 0.1 and 1e-7)
TUBES = {
    "Sod": Tube((1, 0, 1), (0.125, 0, 0.1), 0.5, 0.2),
    "Lax": Tube((0.445, 0.698, 3.528), (0.5, 0, 0.571), 0.5, 0.13),
    "123": Tube((1, -2, 0.4), (1, 2, 0.4), 0.5, 0.15),
    "pressure 1e5": Tube((1, 0, 1000), (1, 0, 0.01), 0.5, 0.012),
    "LeBlanc": Tube((1, 0, 0.2 / 3), (1e-3, 0, 2e-10 / 3), 3, 6, 9, 5 / 3),
}


def run(folder, tube, cells, mesh=None):
    """The tube at its end time: case; x, and (rho, u, p) ours and exact.

    A node is at x0 and has the left state, so the jump lies between it and
    the next one.
    """
    mesh = mesh or box([(tube.length, cells)])
    case = BenchmarkCase(folder, mesh, tube.gamma)
    slip = {name: "wall" for name in mesh.patches}
    case.start(tube.state, {**slip, "left": "open", "right": "open"})
    case.runTo(tube.end)
    return (case,) + compare(case, tube, tube.length / cells)


def compare(case, tube, h, across=True):
    """x, and (rho, u, p) ours and exact; the elements are of size h at x0.

    across: the nodes are on planes across the tube; the exact means are then
    over half of the distances to the planes beside, otherwise over h.
    """
    x = case.x[:, 0]
    ours = np.array([
        case.result("rho"), case.result("U")[:, 0], case.result("p")])
    low, high = x - 0.5 * h, x + 0.5 * h
    if across:
        places, node = np.unique(x.round(9), return_inverse=True)
        middle = 0.5 * (places[1:] + places[:-1])
        ends = np.r_[places[0], middle, places[-1]]
        low, high = ends[node], ends[node + 1]
    return x, ours, tube.exact(low, high, 0.5 * h)


def l1Errors(x, ours, exact):
    """Mean over the length of |error| of rho, u and p on lines."""
    w = weights1D(x)
    return [l1(a - b, w) for a, b in zip(ours, exact)]
