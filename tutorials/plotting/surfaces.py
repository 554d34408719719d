"""Triangles with values to draw: patches, the plane of a two-dimensional case,
cuts of a plane through a three-dimensional one."""
from dataclasses import dataclass

import numpy as np

from plotting.errors import PlotError, oneOf


@dataclass
class Surface:
    """points (n, 3); triangles (m, 3); values (n,) at points or (m,)."""
    points: np.ndarray
    triangles: np.ndarray
    values: np.ndarray
    atPoints: bool

    def normal(self):
        """Mean unit normal."""
        a, b, c = (self.points[self.triangles[:, i]] for i in range(3))
        area = np.cross(b - a, c - a)
        total = area.sum(axis=0)
        return total/max(np.linalg.norm(total), 1e-300)


def joined(surfaces):
    starts = np.cumsum([0] + [len(s.points) for s in surfaces])
    return Surface(
        np.concatenate([s.points for s in surfaces]),
        np.concatenate([s.triangles + start
                        for s, start in zip(surfaces, starts)]),
        np.concatenate([s.values for s in surfaces]),
        surfaces[0].atPoints)


def _surface(piece, faces, field):
    """Of some faces; a cell's field is taken from the cell inside."""
    triangles, face = piece.triangles(faces)
    atPoints, values = field
    used, compact = np.unique(triangles, return_inverse=True)
    return Surface(
        piece.points[used], compact.reshape(-1, 3),
        values[used] if atPoints else values[piece.owner[face]], atPoints)


def patches(pieces, names, fieldName):
    """The named patches of the case."""
    there = {name for piece in pieces for name in piece.patches}
    for name in names:
        if name not in there:
            raise PlotError(
                f"no patch {name}; there are: "
                + oneOf(sorted(n for n in there if "procBoundary" not in n)))
    return joined([
        _surface(piece, np.concatenate(
            [piece.patchFaces(name) for name in names
             if name in piece.patches]).astype(int), piece.field(fieldName))
        for piece in pieces])


def planeOfTwoDimensions(pieces, fieldName):
    """One side of the empty or wedge patches of a two-dimensional case."""
    found = []
    for piece in pieces:
        flat = [name for name, (kind, _, size) in piece.patches.items()
                if kind in ("empty", "wedge") and size]
        if not flat:
            continue
        faces = np.concatenate([piece.patchFaces(name) for name in flat])
        triangles, face = piece.triangles(faces)
        normals = piece.normals(triangles)
        axis = abs(normals).sum(axis=0).argmax()
        found.append(_surface(piece, np.unique(face[normals[:, axis] > 0]),
                              piece.field(fieldName)))
    if not found:
        raise PlotError(
            "the case has neither empty nor wedge patches: it is"
            " three-dimensional; give --plane or --patch")
    return joined(found)


def planeCut(pieces, origin, normal, fieldName):
    """Where a plane cuts the cells; linear in tetrahedra.

    Other cells are split into tetrahedra about their centre.
    """
    normal = np.array(normal, float)/np.linalg.norm(normal)
    found = []
    for piece in pieces:
        height = (piece.points - origin) @ normal
        tets, points, cell, atPoints, values = _cutTetrahedra(
            piece, height, fieldName)
        if len(tets):
            found.append(_cut(tets, points, cell, atPoints, values,
                              (points - origin) @ normal))
    if not any(len(s.triangles) for s in found):
        lower = np.min([p.points.min(axis=0) for p in pieces], axis=0)
        upper = np.max([p.points.max(axis=0) for p in pieces], axis=0)
        raise PlotError(
            f"--plane cuts no cell: the mesh spans {lower} to {upper}. A"
            " plane in the boundary is drawn with --patch <name>")
    return joined(found)


def _cutTetrahedra(piece, height, fieldName):
    """Tetrahedra of the cells on both sides, over points and cell centres."""
    atPoints, values = piece.field(fieldName)
    triangles, face = piece.triangles(np.arange(len(piece.owner)))
    high = np.full(piece.nCells, -np.inf)
    low = np.full(piece.nCells, np.inf)
    inner = face < len(piece.neighbour)
    for cells, which in (
        (piece.owner[face], slice(None)),
        (piece.neighbour[face[inner]], inner),
    ):
        np.maximum.at(high, cells, height[triangles[which]].max(axis=1))
        np.minimum.at(low, cells, height[triangles[which]].min(axis=1))
    cut = (low < 0) & (high >= 0)

    sides = [(triangles, piece.owner[face])]
    sides.append((triangles[inner], piece.neighbour[face[inner]]))
    sides = [(t[cut[c]], c[cut[c]]) for t, c in sides]
    triangle = np.concatenate([t for t, _ in sides])
    cell = np.concatenate([c for _, c in sides])

    # Centres: means over the corners of the faces' triangles
    cells, place = np.unique(cell, return_inverse=True)
    count = 3*np.bincount(place, minlength=len(cells))

    def centres(of):
        total = np.zeros((len(cells),) + of.shape[1:])
        np.add.at(total, place, of[triangle].sum(axis=1))
        return (total.T/count).T

    points = np.concatenate([piece.points, centres(piece.points)])
    if atPoints:
        values = np.concatenate([values, centres(values)])
    tets = np.column_stack([triangle, len(piece.points) + place])
    return tets, points, cell, atPoints, values


def _cut(tets, points, cell, atPoints, values, height):
    order = np.argsort(height[tets], axis=1)
    tets = np.take_along_axis(tets, order, axis=1)
    below = (height[tets] < 0).sum(axis=1)
    corners, cells = [], []
    # Edges that the plane cuts, by the number of corners below it
    for count, edges in (
        (1, [(0, 1), (0, 2), (0, 3)]),
        (3, [(0, 3), (1, 3), (2, 3)]),
        (2, [(0, 2), (0, 3), (1, 3)]),
        (2, [(0, 2), (1, 3), (1, 2)]),
    ):
        some = below == count
        corners.append(tets[some][:, np.array(edges)])
        cells.append(cell[some])
    ends = np.concatenate(corners).reshape(-1, 2)
    a, b = ends.T
    part = height[a]/(height[a] - height[b])
    # An edge's point once, whichever tetrahedra share it
    _, first, compact = np.unique(
        ends, axis=0, return_index=True, return_inverse=True)
    a, b, part = a[first], b[first], part[first]

    def between(of):
        weight = part.reshape((-1,) + (1,)*(of.ndim - 1))
        return (1 - weight)*of[a] + weight*of[b]

    return Surface(
        between(points), compact.reshape(-1, 3),
        between(values) if atPoints else values[np.concatenate(cells)],
        atPoints)
