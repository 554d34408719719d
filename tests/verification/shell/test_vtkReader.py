"""The shell's VTK files as VTK 9.1 itself reads them, on which ParaView 5.10 and
5.11 are built: cells, points between the nodes, area of the tessellation and
interpolated data.

Skipped without python3-vtk9 (Debian), which the project does not need.
"""
import numpy as np
import pytest

from shellCase import ShellCase, Surface, force, isotropic
from shellFiles import readGrid

numpy_support = pytest.importorskip(
    "vtkmodules.util.numpy_support", reason="no python3-vtk9")
from vtkmodules.vtkCommonCore import reference  # noqa: E402
from vtkmodules.vtkFiltersGeometry import (  # noqa: E402
    vtkDataSetSurfaceFilter,
)
from vtkmodules.vtkIOXML import vtkXMLUnstructuredGridReader  # noqa: E402

RADIUS, LENGTH, ANGLE = 2.0, 3.0, 1.2
LAGRANGE_TRIANGLE = 69


def cylinder(u, v):
    phi = ANGLE*u
    return np.stack([RADIUS*np.sin(phi), LENGTH*v, RADIUS*np.cos(phi)], -1)


def normal(u, v):
    phi = ANGLE*u
    return np.stack([np.sin(phi), 0*v, np.cos(phi)], -1)


def read(path):
    reader = vtkXMLUnstructuredGridReader()
    reader.SetFileName(str(path))
    reader.Update()
    return reader.GetOutput()


@pytest.fixture(scope="module")
def loaded(tmp_path_factory):
    """A clamped cylindrical panel, and bent by a force at a corner."""
    shell = ShellCase(
        tmp_path_factory.mktemp("vtkReader"), Surface(3, 2, cylinder, normal),
        isotropic(1e6, 0.3, 0.05),
        {"root": {"type": "clamped", "nodeSet": "vMin"}})
    shell.properties["vtk"] = "yes"
    shell.properties["results"] = {"fields": "(stress vonMises)"}
    shell.solve({"pull": force("uMaxvMax", "(0 0 2)")})
    folder = shell.case.path / "VTK" / "shell"
    return folder / "shell_0.vtu", folder / "shell_1.vtu"


def surfaceArea(grid, level):
    surface = vtkDataSetSurfaceFilter()
    surface.SetInputData(grid)
    surface.SetNonlinearSubdivisionLevel(level)
    surface.Update()
    triangles = surface.GetOutput()
    points = numpy_support.vtk_to_numpy(
        triangles.GetPoints().GetData()).astype(float)
    cells = numpy_support.vtk_to_numpy(
        triangles.GetPolys().GetConnectivityArray()).reshape(-1, 3)
    a, b, c = (points[cells[:, i]] for i in range(3))
    return 0.5*np.linalg.norm(np.cross(b - a, c - a), axis=1).sum()


def test_cellsAndArraysAreRead(loaded):
    for path in loaded:
        grid = read(path)
        points, cells, data = readGrid(path)
        assert grid.GetNumberOfCells() == 12
        assert grid.GetNumberOfPoints() == len(points)
        assert all(grid.GetCellType(i) == LAGRANGE_TRIANGLE
                   for i in range(12))
        assert grid.GetCell(0).GetOrder() == 3
        arrays = grid.GetPointData()
        assert arrays.GetNumberOfArrays() == len(data)
        for name, values in data.items():
            assert (numpy_support.vtk_to_numpy(arrays.GetArray(name))
                    == values).all()


def test_pointsBetweenNodesAreOnTheCylinder(loaded):
    """VTK's own basis with its own order of nodes."""
    grid = read(loaded[0])
    off = []
    for i in range(grid.GetNumberOfCells()):
        cell = grid.GetCell(i)
        for xi in ((0.2, 0.3), (0.5, 0.5), (0.1, 0.77), (0.9, 0.05)):
            x, weights = [0.0]*3, [0.0]*10
            cell.EvaluateLocation(reference(0), (*xi, 0.0), x, weights)
            assert sum(weights) == pytest.approx(1)
            off.append(np.hypot(x[0], x[2]) - RADIUS)
    # A cubic over an angle of 0.4 is (0.4)^4 R/384 off, some times at most
    assert np.abs(off).max() < 5*RADIUS*0.4**4/384
    assert np.abs(off).max() > 0


def test_areaOfTheTessellation(loaded):
    exact = RADIUS*ANGLE*LENGTH
    flat, fine = (surfaceArea(read(loaded[0]), level) for level in (0, 4))
    # Subdivided it is the cylinder's, to an angle of 0.4/16; as triangles
    # between corners 12 chords of 0.4
    assert flat == pytest.approx(exact*np.sin(0.2)/0.2, rel=1e-3)
    assert fine == pytest.approx(exact, rel=5e-5)

    # The bent panel: against the cubic triangles' own points
    grid = read(loaded[1])
    points, _, data = readGrid(loaded[1])
    assert np.linalg.norm(data["displacement"], axis=1).max() > 0.05
    total = 0
    for i in range(grid.GetNumberOfCells()):
        cell, n = grid.GetCell(i), 20
        node = {}
        for a in range(n + 1):
            for b in range(n + 1 - a):
                x, weights = [0.0]*3, [0.0]*10
                cell.EvaluateLocation(
                    reference(0), (a/n, b/n, 0.0), x, weights)
                node[a, b] = np.array(x)
        for a in range(n):
            for b in range(n - a):
                corner = node[a, b]
                total += np.linalg.norm(np.cross(
                    node[a + 1, b] - corner, node[a, b + 1] - corner))/2
                if a + b + 2 <= n:
                    corner = node[a + 1, b + 1]
                    total += np.linalg.norm(np.cross(
                        node[a + 1, b] - corner, node[a, b + 1] - corner))/2
    assert surfaceArea(grid, 4) == pytest.approx(total, rel=3e-4)
