"""The VTK series: valid XML with the shell that the run computed."""
from pathlib import Path

import numpy as np
import pytest

from foamCase import FoamCase
from shellFiles import readGrid, readSeries, readState

HERE = Path(__file__).resolve().parent
LAGRANGE_TRIANGLE = 69


@pytest.fixture(scope="module")
def strip(tmp_path_factory):
    case = FoamCase(
        HERE / "cases" / "dynamicStrip", tmp_path_factory.mktemp("vtk") / "strip"
    )
    case.run("blockShell")
    case.run("positionalShellFoam")
    return case


def test_series_lists_the_start_and_every_write(strip):
    series = readSeries(strip.path / "VTK" / "shell.pvd")
    assert [time for time, _ in series] == [0, 0.1, 0.2, 0.3]
    for _, file in series:
        assert (strip.path / "VTK" / file).is_file()


def test_cells_are_cubic_triangles_in_the_order_of_vtk(strip):
    points, cells, _ = readGrid(strip.path / "VTK" / "shell" / "shell_0.vtu")
    assert len(points) == 25*4
    assert len(cells["types"]) == 16
    assert np.all(cells["types"] == LAGRANGE_TRIANGLE)
    assert list(cells["offsets"]) == list(range(10, 170, 10))

    p = points[cells["connectivity"].reshape(-1, 10)]
    a, b, c = p[:, 0], p[:, 1], p[:, 2]
    expected = [
        a, b, c, (2*a + b)/3, (a + 2*b)/3, (2*b + c)/3, (b + 2*c)/3,
        (2*c + a)/3, (c + 2*a)/3, (a + b + c)/3,
    ]
    np.testing.assert_allclose(p, np.stack(expected, axis=1), atol=1e-5)


def test_data_are_those_of_the_restart_state(strip):
    points, _, data = readGrid(strip.path / "VTK" / "shell" / "shell_150.vtu")
    initial, _, _ = readGrid(strip.path / "VTK" / "shell" / "shell_0.vtu")
    state = readState(strip, "0.3")

    np.testing.assert_allclose(points, state["position"], rtol=1e-6, atol=1e-6)
    np.testing.assert_allclose(
        data["displacement"], state["position"] - initial, atol=1e-5
    )
    np.testing.assert_allclose(
        data["velocity"], state["velocity"], rtol=1e-6, atol=1e-6
    )
    np.testing.assert_allclose(
        data["thickness"], 0.1*np.linalg.norm(state["director"], axis=1),
        rtol=1e-6,
    )
    assert abs(data["displacement"]).max() > 6
