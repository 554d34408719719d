"""Patches of an ASCII polyMesh, and the sums of inverse distance done directly."""
import re

import numpy as np

from foamFile import readText


class BoundaryMesh:
    """Points and patch faces of a case's undeformed mesh."""

    def __init__(self, case):
        folder = case.path / "constant" / "polyMesh"
        self.points = case.points()
        self.faces = [
            np.array(face.split(), dtype=int) for face in
            re.findall(r"\b\d+\(([\d ]+)\)", readText(folder / "faces"))
        ]
        self.patches = {
            name: (int(start), int(size)) for name, size, start in re.findall(
                r"(\w+)\s*\{[^}]*nFaces\s+(\d+);\s*startFace\s+(\d+);",
                readText(folder / "boundary"),
            )
        }

    def patchFaces(self, *names):
        for name in names:
            start, size = self.patches[name]
            yield from self.faces[start:start + size]

    def patchPoints(self, *names):
        """Sorted labels of the points of these patches."""
        return np.unique(np.concatenate(list(self.patchFaces(*names))))

    def areas(self, *names):
        """Area of these patches that belongs to each point of the mesh."""
        result = np.zeros(len(self.points))
        for face in self.patchFaces(*names):
            p = self.points[face]
            fan = np.cross(p[1:-1] - p[0], p[2:] - p[0])
            result[face] += np.linalg.norm(fan.sum(axis=0))/2/len(face)
        return result


def distance(x, y):
    return np.linalg.norm(x[:, None, :] - y[None, :, :], axis=2)


def inverseDistance(
    targets, moving, values, fixed, e1=4, e2=4, movingMass=1, fixedMass=1
):
    """Eqs. (M1) to (M3): values of the targets, one row each."""
    a = movingMass*distance(targets, moving)**-e1
    b = fixedMass*distance(targets, fixed)**-e2
    return a @ values/(a.sum(axis=1) + b.sum(axis=1))[:, None]


def slidingDistance(targets, moving, values, fixed, planes, e=4):
    """Eq. (M14). planes: pairs of a unit normal and points.

    Targets on a plane count as very near to it."""
    def weight(points):
        return np.maximum(distance(targets, points), 1e-4)**-e

    a = distance(targets, moving)**-e
    matrix = np.multiply.outer(
        a.sum(axis=1) + (distance(targets, fixed)**-e).sum(axis=1), np.eye(3)
    )
    for normal, points in planes:
        matrix += np.multiply.outer(
            weight(points).sum(axis=1), np.outer(normal, normal)
        )
    return np.linalg.solve(matrix, (a @ values)[:, :, None])[:, :, 0]
