"""Boundary values from tables in time: a sound wave of finite amplitude that
comes in from the left, exactly a simple wave."""
import numpy as np
import pytest

from benchmarkCase import BenchmarkCase
from blockMeshes import box
from errorNorms import l1, orders, weights1D

C = np.sqrt(1.4)  # rho = p = 1
PEAK, DURATION, END = 0.05, 0.4, 0.6
TIMES = np.linspace(0, 1, 1001)
ORDER = 1.8
CAPTURED = 3e-4  # L1 of p with the limiter, which cuts moving extrema


def entering(x, t):
    """rho, u, p: each characteristic x = (u + c)(t - s) has the velocity with
    which it started from x = 0 at s."""
    def speed(s):
        on = np.clip(s, 0, DURATION)
        return PEAK * np.sin(np.pi * on / DURATION)**2

    low, high = np.full(len(x), t - 2 / C), np.full(len(x), t)
    for _ in range(60):
        s = (low + high) / 2
        late = (1.2 * speed(s) + C) * (t - s) < x
        low, high = np.where(late, low, s), np.where(late, s, high)
    u = speed((low + high) / 2)
    c = C + 0.2 * u
    return (c / C)**5, u, (c / C)**7


def timeTable(name):
    rows = []
    for t in TIMES:
        rho, u, p = (v[0] for v in entering(np.zeros(1), t))
        value = {"p": f"{p:.17g}", "T": f"{p / rho:.17g}",
                 "U": f"({u:.17g} 0 0)"}[name]
        rows.append(f"({t:.12g} {value})")
    return "table (" + " ".join(rows) + ")"


@pytest.mark.parametrize("kind, capturing", [
    ("uniformFixedValue", False), ("farField", False),
    ("uniformFixedValue", True), ("farField", True),
])
def test_waveComesIn(tmp_path, table, kind, capturing):
    inlet = {name: f"type {kind}; uniformValue {timeTable(name)};"
             for name in "pUT"}
    numbers, errors, seconds = (50, 100, 200), [], []
    for n in numbers:
        case = BenchmarkCase(tmp_path / str(n), box([(1, n)]),
                             capturing=capturing)
        case.start(lambda x: (np.ones(len(x)), 0.0, 1.0),
                   {"left": inlet, "right": "far"})
        case.runTo(END)
        x = case.x[:, 0]
        error = case.result("p") - entering(x, END)[2]
        errors.append(l1(error, weights1D(x)))
        seconds.append(case.seconds)
    table.add(f"wave comes in through {kind}, table", "50 100 200 lines",
              "L1 of p", errors, "exact simple wave",
              f"last {CAPTURED}" if capturing else "",
              orders(errors, numbers), seconds, capturing=capturing)
    if capturing:
        assert errors[-1] < CAPTURED
    else:
        assert orders(errors, numbers)[-1] > ORDER
