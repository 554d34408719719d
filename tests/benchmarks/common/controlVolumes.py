"""Means of functions over the control volumes of nodes and of cells.

    volumes = ControlVolumes(points, cells)
    volumes.nodes                # int N_a dV, one per point
    volumes.means(function)      # (k, nodes) and (k, cells)

cells: corners of tetrahedra (m, 4), of quadrilaterals in the plane z = 0
(m, 4, counterclockwise) with plane=True, or of hexahedra (m, 8, in OpenFOAM's
order). A node's control volume is weighted by its (bi-, tri-) linear shape
function N_a. Integrals are sums over 4 points in each direction of a
quadrilateral or hexahedron, and over 4 points in each of the 8 parts of a
tetrahedron whose edges are cut in half.
"""
import numpy as np

CHUNK = 20000  # cells at a time

# source: Gauss-Legendre with two points on each half of [0, 1]; tetrahedra:
# the four points of degree 2, A. H. Stroud, Approximate Calculation of
# Multiple Integrals (1971), T3: 2-1
GAUSS = 0.5 * (np.array([[0], [1]]) + 0.5 + np.array([-1, 1]) / np.sqrt(12))
LINE = GAUSS.ravel()
NEAR, REST = 0.5854101966249685, 0.1381966011250105

# Corners of a cube in OpenFOAM's order
HEX = np.array([(0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0),
                (0, 0, 1), (1, 0, 1), (1, 1, 1), (0, 1, 1)])


def tetrahedronPoints():
    """Shape functions (points, 4) at the points of a tetrahedron."""
    corner = np.eye(4)
    middle = {(a, b): 0.5 * (corner[a] + corner[b])
              for a in range(4) for b in range(4) if a != b}
    parts = [[corner[a]] + [middle[a, b] for b in range(4) if b != a]
             for a in range(4)]
    # The octahedron that is left, round one of its diagonals
    m = middle
    ring = [m[0, 2], m[0, 3], m[1, 3], m[1, 2]]
    parts += [[m[0, 1], m[2, 3], ring[i], ring[(i + 1) % 4]]
              for i in range(4)]
    rule = np.full((4, 4), REST) + (NEAR - REST) * np.eye(4)
    return np.concatenate([rule @ np.array(p) for p in parts])


def boxPoints(dim):
    """The same of a quadrilateral or a hexahedron, and their gradients."""
    s = np.stack(np.meshgrid(*[LINE] * dim, indexing="ij"), -1)
    s = s.reshape(-1, 1, dim)
    corner = HEX[:2**dim, :dim]
    factor = np.where(corner, s, 1 - s)
    gradient = np.stack([
        np.prod(np.where(np.arange(dim) == i, 2 * corner - 1, factor), -1)
        for i in range(dim)], -1)
    return factor.prod(axis=-1), gradient


class ControlVolumes:

    def __init__(self, points, cells, plane=False):
        self.points, self.cells = points, np.asarray(cells)
        corners = self.cells.shape[1]
        if corners == 4 and not plane:
            self.shape, self.gradient = tetrahedronPoints(), None
        else:
            self.shape, self.gradient = boxPoints(2 if plane else 3)
        one = self.integrals(lambda x: np.ones((1, len(x))))
        self.nodes, self.cellVolumes = one[0][0], one[1][0]

    def weights(self, x):
        """Volumes of the integration points, (cells, points)."""
        n = len(self.shape)
        if self.gradient is None:
            edge = x[:, 1:] - x[:, :1]
            return np.repeat(abs(np.linalg.det(edge))[:, None], n, 1) / 6 / n
        dim = self.gradient.shape[-1]
        jacobian = np.einsum("cad,qai->cqdi", x[..., :dim], self.gradient)
        return abs(np.linalg.det(jacobian)) / n

    def integrals(self, function):
        """Of each of the k values of function(places (n, 3)), shape (k, n):
        over the control volumes of the nodes (k, nodes), of the cells."""
        atNodes, inCells = [], []
        for start in range(0, len(self.cells), CHUNK):
            cells = self.cells[start:start + CHUNK]
            x = self.points[cells]
            place = np.einsum("qa,cad->cqd", self.shape, x).reshape(-1, 3)
            values = np.asarray(function(place)).reshape(
                -1, len(cells), len(self.shape)) * self.weights(x)
            inCells.append(values.sum(axis=-1))
            share = np.einsum("kcq,qa->kca", values, self.shape)
            atNodes.append([
                np.bincount(cells.ravel(), s.ravel(), len(self.points))
                for s in share])
        return np.sum(atNodes, axis=0), np.concatenate(inCells, axis=1)

    def means(self, function):
        nodes, cells = self.integrals(function)
        return nodes / self.nodes, cells / self.cellVolumes

    def fromCells(self, values):
        """Means over the nodes' control volumes of values constant in each
        cell; each corner has the same share of a cell (exact for simplices
        and parallelepipeds)."""
        corners = self.cells.shape[1]
        share = np.repeat(self.cellVolumes / corners, corners)
        sums = [
            np.bincount(self.cells.ravel(), weights, len(self.points))
            for weights in (share * np.repeat(values, corners), share)]
        return sums[0] / sums[1]
