"""Uniform flow and a shock tube on flat elements, on points moved at random
and across tenfold jumps of the element size."""
from dataclasses import replace

import numpy as np
import pytest

from benchmarkCase import BenchmarkCase
from blockMeshes import box
from distortedMeshes import jumps, perturbed, slivers
from errorNorms import l1, weights1D
from shockTubes import TUBES, compare

RANDOM = 0.25  # of an element, in each direction


def meshes(name, n, dim):
    """The mesh, and how to distort the case's points."""
    h = 1 / n
    plain = [(1, n)], (8 * h, 8) if dim == 2 else (4 * h, 4)
    return {
        "slivers": lambda: (slivers(n, 100, dim), None),
        "random": lambda: (
            box(*plain, *([(4 * h, 4)] if dim == 3 else [])),
            lambda case: perturbed(case, RANDOM)),
        "jumps": lambda: (jumps(n, dim), None),
    }[name]()


KINDS = pytest.mark.parametrize("kind, dim", [
    ("slivers", 2), ("slivers", 3), ("random", 2), ("random", 3),
    ("jumps", 1), ("jumps", 2), ("jumps", 3),
])

# Largest change of p over p and of U over the speed after 100 steps
UNIFORM = 1e-11


@KINDS
def test_uniformFlow(tmp_path, table, kind, dim):
    mesh, distort = meshes(kind, 50, dim)
    case = BenchmarkCase(tmp_path / "case", mesh)
    if distort:
        distort(case)
    U = np.array([0.7, 0.5, 0.3]) * (np.arange(3) < dim)

    def state(x):
        return np.ones(len(x)), np.tile(U, (len(x), 1)), 1.0

    case.start(state, dict.fromkeys(mesh.patches, "far"))
    case.runTo(100.0, writeControl="timeStep", writeInterval=100,
               stopAt="nextWrite")
    off = max(abs(case.result("p") - 1).max(),
              abs(case.result("U") - U).max() / np.linalg.norm(U))
    table.add(f"uniform flow, {kind}, {dim}D", f"{len(case.x)} nodes",
              "largest change in 100 steps", off, "0", UNIFORM,
              seconds=case.seconds)
    assert case.steps() >= 99
    assert off < UNIFORM


# Sod's tube: elements, and L1 error of rho. On slivers and moved points that
# of an even mesh with some room; of the tube with jumps a fifth is ten times
# coarser. On slivers the step is that of their width, so they are fewer
LINES = {"slivers": 50, "random": 100, "jumps": 100}
SOD = {"slivers": 0.012, "random": 0.0075, "jumps": 0.012}


@KINDS
def test_sod(tmp_path, table, kind, dim):
    # The diaphragm is in front of the large elements of "jumps"
    tube = replace(TUBES["Sod"], x0=0.3)
    n = LINES[kind]
    mesh, distort = meshes(kind, n, dim)
    case = BenchmarkCase(tmp_path / "case", mesh)
    if distort:
        distort(case)
    walls = dict.fromkeys(mesh.patches, "wall")
    case.start(tube.state, {**walls, "left": "open", "right": "open"})
    case.runTo(tube.end)
    x, ours, exact = compare(case, tube, 1 / n, kind != "random")
    # By length where elements differ along the tube
    places, node, count = np.unique(
        x.round(9), return_inverse=True, return_counts=True)
    w = None if kind == "random" else (weights1D(places) / count)[node]
    error = l1(ours[0] - exact[0], w)
    table.add(f"Sod, {kind}, {dim}D", f"{len(case.x)} nodes",
              "L1 of rho", error, "exact", SOD[kind],
              seconds=case.seconds)
    assert error < SOD[kind]
    assert ours[[0, 2]].min() > 0
