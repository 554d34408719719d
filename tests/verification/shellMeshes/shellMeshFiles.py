"""Shell meshes on disk, and the shape of their triangles."""
import re
from dataclasses import dataclass

import numpy as np

from foamFile import numbers, readList, readText

CONTROL = """FoamFile
{ version 2.0; format ascii; class dictionary; object controlDict; }
startFrom startTime; startTime 0; stopAt endTime; endTime 1; deltaT 1;
writeControl timeStep; writeInterval 1; writePrecision 16;
"""


def emptyCase(folder):
    """A folder that programs accept as a case."""
    (folder / "system").mkdir(parents=True)
    (folder / "system" / "controlDict").write_text(CONTROL)
    return folder


@dataclass
class ShellMesh:
    nodes: np.ndarray
    triangles: np.ndarray
    nodeSets: dict
    elementSets: dict
    directors: np.ndarray

    def at(self, xi1, xi2):
        """Points of all triangles, (triangles, points, 3)."""
        return np.einsum("pj,ejk->epk", basis(xi1, xi2),
                         self.nodes[self.triangles])


def readSets(path):
    text = readText(path)
    text = text[text.index("}") + 1:]
    found = re.findall(r"([\w.-]+)\s+(?:List<label>\s*)?(\d+)\s*"
                       r"(?:\(([^)]*)\)|\{([^}]*)\})\s*;", text)
    return {name: sorted(int(v) for v in members.split()) if members
            else [int(one)] * int(n)
            for name, n, members, one in found}


def vectors(path):
    """A list of vectors, also as OpenFOAM's n{value}."""
    repeated = re.search(r"(\d+)\s*\{(\([^{}]*\))\}\s*$", readText(path))
    if repeated:
        return np.repeat(numbers(repeated.group(2), 3),
                         int(repeated.group(1)), axis=0)
    return readList(path, 3)


def readShellMesh(case, name="shell"):
    folder = case / "constant" / name
    text = readText(folder / "triangles")
    rows = re.findall(r"10\(([\d\s]*)\)", text)
    directors = folder / "directors"
    return ShellMesh(
        vectors(folder / "nodes"),
        np.array([[int(v) for v in row.split()] for row in rows]),
        readSets(folder / "nodeSets"), readSets(folder / "elementSets"),
        vectors(directors) if directors.exists() else None)


def basis(xi1, xi2):
    """Cubic Lagrange basis, nodes as shellMeshIO.H has them: (points, 10)."""
    L = [1 - xi1 - xi2, xi1, xi2]

    def corner(a):
        return L[a] * (3 * L[a] - 1) * (3 * L[a] - 2) / 2

    def edge(a, b):
        return 4.5 * L[a] * L[b] * (3 * L[a] - 1)

    return np.stack([
        corner(0), corner(1), corner(2), edge(0, 1), edge(1, 0), edge(1, 2),
        edge(2, 1), edge(2, 0), edge(0, 2), 27 * L[0] * L[1] * L[2]], axis=-1)


def samples(n=12):
    """Parametric points all over the triangle."""
    i, j = np.meshgrid(np.arange(n + 1), np.arange(n + 1), indexing="ij")
    inside = i + j <= n
    return i[inside] / n, j[inside] / n
