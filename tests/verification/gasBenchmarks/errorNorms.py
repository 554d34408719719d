"""Norms of errors, and what is said about a series of them."""
import numpy as np


def weights1D(x, power=0):
    """Lumped lengths of the nodes of lines: int N_a |x|^power dx, exact for
    power 0 (plane), 1 (cylinder) and 2 (sphere)."""
    a, b = x[:-1], x[1:]
    h = b - a
    # int of (1 - s) (a + s h)^power and of s (a + s h)^power over s
    left, right = {
        0: (1 / 2, 1 / 2),
        1: (a / 2 + h / 6, a / 2 + h / 3),
        2: (a**2 / 2 + a * h / 3 + h**2 / 12, a**2 / 2 + 2 * a * h / 3
            + h**2 / 4),
    }[power]
    w = np.zeros(len(x))
    w[:-1] += h * left
    w[1:] += h * right
    return w


def l1(error, weights=None):
    """Mean of |error|; over the nodes when no weights are given."""
    return np.average(np.abs(error), weights=weights)


def l2(error, weights=None):
    return np.sqrt(np.average(np.square(error), weights=weights))


def orders(errors, numbers=None):
    """Observed orders of a series of errors on meshes with these numbers of
    elements along a side; without them, twice as many each time."""
    errors = np.asarray(errors)
    n = 2.0**np.arange(len(errors)) if numbers is None else \
        np.array(list(numbers), float)
    return np.log(errors[:-1] / errors[1:]) / np.log(n[1:] / n[:-1])


def overshoot(values, exact):
    """How far values leave the range of exact, over that range."""
    low, high = exact.min(), exact.max()
    return max(values.max() - high, low - values.min(), 0) / (high - low)


def variation(values):
    """Total variation along a line."""
    return np.abs(np.diff(values)).sum()


def crossing(x, values, level):
    """Largest x at which values, along ascending x, pass through level."""
    side = values > level
    i = np.flatnonzero(side[1:] != side[:-1])[-1]
    s = (level - values[i]) / (values[i + 1] - values[i])
    return x[i] + s * (x[i + 1] - x[i])
