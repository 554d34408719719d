"""Boxes of tetrahedra as polyMesh cells.

    mesh = tetrahedra((40, 4, 4), (1, 0.1, 0.1), shift=0.15)

A box of cubes is cut into five tetrahedra each, with diagonals that alternate,
so that faces match. The points inside are then moved at random by up to
`shift` of a cube's side in each direction (seeded).
Patches: left, right; bottom, top; back, front.
"""
import numpy as np

# The two ways to cut a cube; its corner (i, j, k) has the number i + 2 j + 4 k
EVEN = np.array([
    (0, 1, 2, 4), (3, 2, 1, 7), (5, 4, 7, 1), (6, 7, 4, 2), (1, 2, 4, 7)])
ODD = np.array([
    (1, 3, 0, 5), (2, 0, 3, 6), (4, 6, 5, 0), (7, 5, 6, 3), (0, 3, 5, 6)])

# Face opposite to corner c of a tetrahedron of positive volume, seen from
# outside counterclockwise
FACES = np.array([(1, 2, 3), (0, 3, 2), (0, 1, 3), (0, 2, 1)])

PATCHES = ("left", "right", "bottom", "top", "back", "front")


def volumes(points, tets):
    a, b, c, d = (points[tets[:, i]] for i in range(4))
    return np.einsum("ij,ij->i", np.cross(b - a, c - a), d - a) / 6


class TetMesh:
    """points (n, 3), tets (m, 4); patches: name -> (type, None)."""

    dim = 3

    def __init__(self, points, tets, lengths, kinds=None):
        self.points, self.tets, self.lengths = points, tets, lengths
        self.patches = {
            name: ((kinds or {}).get(name, "patch"), None) for name in PATCHES
        }

    @property
    def cells(self):
        return self.tets

    def make(self, case):
        """The polyMesh of a case."""
        faces, owner, neighbour, patches = self.facesOfCells()
        write = PolyMeshWriter(case)
        write.list("points", "vectorField", self.points, "(%.17g %.17g %.17g)")
        write.list("faces", "faceList", faces, "3(%d %d %d)")
        write.list("owner", "labelList", owner, "%d")
        write.list("neighbour", "labelList", neighbour, "%d")
        text = "".join(
            f"{name} {{ type {self.patches[name][0]}; nFaces {count}; "
            f"startFace {start}; }}\n" for name, count, start in patches
        )
        case.write("constant/polyMesh/boundary",
                   f"{len(patches)}\n(\n{text})\n", kind="polyBoundaryMesh")

    def facesOfCells(self):
        """Faces in OpenFOAM's order, owner, neighbour, and the patches:
        (name, faces, start)."""
        cells = len(self.tets)
        all_ = self.tets[:, FACES].reshape(-1, 3)
        cell = np.repeat(np.arange(cells), 4)
        key = np.sort(all_, axis=1)
        order = np.lexsort((cell, key[:, 2], key[:, 1], key[:, 0]))
        k = key[order]
        pair = (k[1:] == k[:-1]).all(axis=1)
        first = np.flatnonzero(pair)
        low, high = order[first], order[first + 1]
        upper = np.lexsort((cell[high], cell[low]))
        low, high = low[upper], high[upper]

        outer = np.ones(len(order), bool)
        outer[first] = outer[first + 1] = False
        outer = np.sort(order[outer])
        centres = self.points[all_[outer]].mean(axis=1)
        faces, owners, patches = [all_[low]], [cell[low]], []
        start = len(low)
        for number, name in enumerate(PATCHES):
            axis, far = divmod(number, 2)
            place = self.lengths[axis] * far
            on = outer[abs(centres[:, axis] - place)
                       < 1e-9 * self.lengths[axis]]
            faces.append(all_[on])
            owners.append(cell[on])
            patches.append((name, len(on), start))
            start += len(on)
        return (np.concatenate(faces), np.concatenate(owners), cell[high],
                patches)


class PolyMeshWriter:

    def __init__(self, case):
        self.case = case
        (case.path / "constant" / "polyMesh").mkdir(parents=True)

    def list(self, name, kind, values, form):
        body = (form + "\n") * len(values) % tuple(values.ravel().tolist())
        self.case.write(f"constant/polyMesh/{name}",
                        f"{len(values)}\n(\n{body})\n", kind=kind)


def tetrahedra(cells, lengths, shift=0.0, kinds=None, seed=1):
    """cells: cubes along x, y and z; kinds: patch -> type, "patch" without."""
    n = np.array(cells)
    axes = [np.arange(m + 1) for m in n]
    k, j, i = np.meshgrid(axes[2], axes[1], axes[0], indexing="ij")
    index = np.stack([i, j, k], axis=-1).reshape(-1, 3)
    inside = ((index > 0) & (index < n)).all(axis=1)
    random = np.random.default_rng(seed).uniform(-shift, shift, index.shape)
    h = np.array(lengths) / n
    points = (index + np.where(inside[:, None], random, 0)) * h
    # The far sides exactly
    points = np.where(index == n, np.array(lengths, float), points)

    low = index[(index < n).all(axis=1)]
    label = low @ np.array([1, n[0] + 1, (n[0] + 1) * (n[1] + 1)])
    corner = np.array([
        x + (n[0] + 1) * (y + (n[1] + 1) * z)
        for z in (0, 1) for y in (0, 1) for x in (0, 1)])
    cubes = label[:, None] + corner
    even = (low.sum(axis=1) % 2 == 0)[:, None, None]
    tets = np.where(even, cubes[:, EVEN], cubes[:, ODD]).reshape(-1, 4)
    turned = volumes(points, tets) < 0
    tets[turned] = tets[turned][:, [0, 2, 1, 3]]
    if volumes(points, tets).min() <= 0:
        raise ValueError(f"shift {shift} is too large")
    return TetMesh(points, tets, lengths, kinds)
