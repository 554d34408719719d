"""Meshes that are hard on a solver: flat elements, points moved at random,
jumps of the element size."""
import numpy as np

from blockMeshes import box


def perturbed(case, part, seed=1):
    """Move the interior points of a box of equal elements at random, by up to
    `part` of an element in each direction of the scene.

    Points that face each other across the mesh's thickness move alike.
    """
    x = case.allPoints
    random = np.random.default_rng(seed)
    dim = case.mesh.dim
    h = np.array([np.diff(np.unique(x[:, i].round(9))).min()
                  for i in range(dim)])
    low, high = x[:, :dim].min(axis=0), x[:, :dim].max(axis=0)
    inside = ((x[:, :dim] > low + 0.5 * h)
              & (x[:, :dim] < high - 0.5 * h)).all(axis=1)
    # One displacement for all points of the same place in the scene
    _, node = np.unique(x[:, :dim].round(9), axis=0, return_inverse=True)
    node = node.ravel()
    shift = random.uniform(-part, part, (node.max() + 1, dim)) * h
    moved = x.copy()
    moved[inside, :dim] += shift[node[inside]]
    case.movePoints(moved)


def slivers(n, aspect, dim):
    """n elements along a tube of length 1, `aspect` times as long as wide, two
    or four across."""
    width = 1 / n / aspect
    across = [(4 * width, 4)] if dim == 2 else [(2 * width, 2)] * 2
    return box([(1, n)], *across)


def jumps(n, dim):
    """Elements of size h, 10 h, h along a tube of length 1; h = 1/n."""
    h = 1 / n
    thirds = [(0.4, round(0.4 * n)), (0.2, round(0.02 * n)),
              (0.4, round(0.4 * n))]
    across = {1: [], 2: [(4 * h, 4)], 3: [(2 * h, 2)] * 2}[dim]
    return box(thirds, *across)
