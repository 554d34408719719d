"""Order of accuracy: a smooth bump of density carried along, without artificial
viscosity, with the default mass matrix of twoStep."""
import numpy as np
import pytest

from gasBox import GasBox


def bump(x, centre, width):
    return 1 + 0.2 * np.exp(-((x - centre)**2).sum(axis=1) / width**2)


def error(folder, sides, cells, start, velocity, width, endTime):
    dim = len(sides)
    case = GasBox(folder, sides, cells)
    case.schemes("timeScheme twoStep; shockCapturing none;")
    x = case.x[:, :dim]
    start, velocity = np.array(start), np.array(velocity)
    U = np.zeros(3)
    U[:dim] = velocity
    case.start(bump(x, start, width), U, 1.0)
    assert case.runTo(endTime) == 0, case.log[-2000:]
    exact = bump(x, start + endTime * velocity, width)
    return np.sqrt(((case.result("rho") - exact)**2).mean())


def orders(errors):
    return [np.log2(a / b) for a, b in zip(errors, errors[1:])]


def test_1D(tmp_path):
    errors = [
        error(tmp_path / str(n), (2,), (n,), (0.7,), (1,), 0.15, 0.5)
        for n in (80, 160, 320)
    ]
    print(errors, orders(errors))
    assert min(orders(errors)) >= 1.9


def test_2D(tmp_path):
    errors = [
        error(tmp_path / str(n), (2, 2), (n, n), (0.8, 0.9), (1, 0.5), 0.25,
              0.4)
        for n in (40, 80, 160)
    ]
    print(errors, orders(errors))
    assert orders(errors)[-1] >= 1.9


@pytest.mark.long
def test_2DFiner(tmp_path):
    errors = [
        error(tmp_path / str(n), (2, 2), (n, n), (0.8, 0.9), (1, 0.5), 0.25,
              0.4)
        for n in (160, 320)
    ]
    print(errors, orders(errors))
    assert orders(errors)[-1] >= 1.9
