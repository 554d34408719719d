"""Meshes and fields of an OpenFOAM case at a time, whole or decomposed.

A decomposed case is read piece by piece, without reconstructing it: pictures
need no common numbering.
"""
import re
from pathlib import Path

import numpy as np

from plotting.errors import PlotError, oneOf
from plotting.foamFiles import (
    existing, readBoundary, readFaces, readField, readLabels, readPoints,
)

TIME = re.compile(r"\d+(\.\d+)?(e[-+]?\d+)?$")


def timesOf(folder):
    names = [item.name for item in folder.iterdir()
             if item.is_dir() and TIME.match(item.name)]
    return sorted(names, key=float)


class Piece:
    """Mesh and fields of one folder at a time."""

    def __init__(self, folder, time):
        self.folder, self.time = folder, time
        mesh = folder / "constant" / "polyMesh"
        if existing(mesh / "faces") is None:
            raise PlotError(f"{mesh}/faces: no mesh; make it first (Allrun)")
        self.points = readPoints(self._pointsFile())
        self.offsets, self.labels = readFaces(mesh / "faces")
        self.owner = readLabels(mesh / "owner")
        self.neighbour = readLabels(mesh / "neighbour")
        self.patches = readBoundary(mesh / "boundary")
        self.nCells = 1 + max(self.owner.max(),
                              self.neighbour.max(initial=-1))

    def _pointsFile(self):
        """Of this time, else of the last one before it that has some."""
        earlier = [t for t in timesOf(self.folder)
                   if float(t) <= float(self.time)]
        for time in reversed(earlier):
            path = self.folder / time / "polyMesh" / "points"
            if existing(path):
                return path
        return self.folder / "constant" / "polyMesh" / "points"

    def field(self, name):
        """(at points?, values) with a row per point or cell; p, U (its
        magnitude) or U.x, U.y, U.z."""
        base, _, axis = name.partition(".")
        path = self.folder / self.time / base
        if existing(path) is None:
            there = [p.name.removesuffix(".gz")
                     for p in sorted((self.folder / self.time).iterdir())
                     if p.is_file()]
            raise PlotError(f"{path}: no such field; at this time there are:"
                            f" {oneOf(there)}")
        kind, values = readField(path)
        if values.ndim == 2:
            if axis and axis not in ("x", "y", "z"):
                raise PlotError(f"{name}: components are .x, .y and .z")
            values = (values[:, "xyz".index(axis)] if axis
                      else np.linalg.norm(values, axis=1))
        elif axis:
            raise PlotError(f"{name}: {base} is a scalar, it has no"
                            f" component {axis}")
        atPoints = kind.startswith("point")
        size = len(self.points) if atPoints else self.nCells
        if len(values) == 1:
            values = np.full(size, values[0])
        if len(values) != size:
            raise PlotError(f"{path}: {len(values)} values on a mesh of {size}"
                            f" {'points' if atPoints else 'cells'}")
        return atPoints, values

    # Faces

    def triangles(self, faces):
        """(triangles, face of each): fans of the given faces' points."""
        faces = np.asarray(faces)
        counts = np.diff(self.offsets)[faces] - 2
        which = np.repeat(np.arange(len(faces)), counts)
        step = np.arange(counts.sum()) - np.repeat(
            np.cumsum(counts) - counts, counts)
        first = self.offsets[faces][which]
        corners = np.stack(
            [first, first + step + 1, first + step + 2], axis=1)
        return self.labels[corners], faces[which]

    def normals(self, triangles):
        a, b, c = (self.points[triangles[:, i]] for i in range(3))
        return 0.5*np.cross(b - a, c - a)

    def patchFaces(self, name):
        _, start, size = self.patches[name]
        return np.arange(start, start + size)


class Case:
    """A case's folder."""

    def __init__(self, folder):
        self.folder = Path(folder)
        if not (self.folder / "system").is_dir():
            raise PlotError(f"{self.folder.resolve()}: not a case, it has no"
                            " folder system; name the case with --case")

    def parts(self):
        """The folders with meshes: the case, or its processor folders."""
        split = sorted(self.folder.glob("processor[0-9]*"),
                       key=lambda path: int(path.name[9:]))
        whole = existing(self.folder / "constant/polyMesh/faces")
        if split and (not whole or
                      len(timesOf(split[0])) > len(timesOf(self.folder))):
            return split
        return [self.folder]

    def time(self, wanted):
        """Name of a time's folder: of latest, or of a number."""
        names = timesOf(self.parts()[0])
        if not names:
            raise PlotError(f"{self.folder.resolve()}: no results (no folder"
                            " of a time); run the case first")
        if wanted == "latest":
            return names[-1]
        try:
            value = float(wanted)
        except ValueError:
            raise PlotError(f"--time {wanted}: neither a number nor latest")
        close = min(names, key=lambda name: abs(float(name) - value))
        if abs(float(close) - value) > 1e-6*max(abs(value), 1e-12):
            raise PlotError(f"--time {wanted}: not written; in"
                            f" {self.folder.resolve()} there are:"
                            f" {oneOf(names)}")
        return close

    def pieces(self, time):
        return [Piece(part, time) for part in self.parts()]
