"""Shocks sent back by a wall, and shocks and waves made by a moving wall."""
import numpy as np
import pytest

from benchmarkCase import BenchmarkCase
from blockMeshes import box
from errorNorms import crossing, l1, orders, weights1D
from exactSolutions import (
    normalShock, pushedPiston, reflectedShock, simpleWave
)

C = np.sqrt(1.4)  # rho = p = 1

# Reflected shock: tube of length 1, wall at its right end, the shock starts
# at START and has come back to RUN from the wall
LINES = 400
START = 0.6
RUN = 0.12
PLATEAU = 0.002  # error of the mean pressure at the wall
PLACE = 0.006  # of the reflected shock: two elements


@pytest.mark.parametrize("mach", [1.2, 1.5, 2, 3, 4, 5])
def test_reflectedShock(tmp_path, table, mach):
    p2, rho2, u2 = normalShock(mach)
    p5, rho5, back = reflectedShock(mach)
    case = BenchmarkCase(tmp_path / "case", box([(1, LINES)]))

    def state(x):
        behind = x[:, 0] < START
        return [np.where(behind, a, b)
                for a, b in ((rho2, 1.0), (u2 * C, 0.0), (p2, 1.0))]

    case.start(state, {"left": "fixed", "right": "wall"})
    travel = RUN / back
    case.runTo(((1 - START) / mach + travel) / C)
    x, p = case.x[:, 0], case.result("p")
    # Away from the shock
    plateau = x > 1 - RUN + 0.03
    ours = p[plateau].mean() / p5
    inside = x > 1 - 2 * RUN
    place = crossing(-x[inside][::-1], p[inside][::-1], 0.5 * (p2 + p5))
    table.add(f"reflected shock, M {mach}", f"{LINES} lines",
              "p5/p1 at the wall, error", ours - 1, f"{p5:.6g}", PLATEAU,
              seconds=case.seconds)
    table.add(f"reflected shock, M {mach}", "same",
              "place of the shock, error", place + 1 - RUN, f"{1 - RUN:g}",
              PLACE)
    assert abs(ours - 1) < PLATEAU
    assert abs(-place - (1 - RUN)) < PLACE


# A shock that runs on behind another place's time step. The pressure beyond
# that behind the shock, over the jump
WEAK_LINES = 300
WEAK_TRAVEL = 0.6
WEAK_OVERSHOOT = 0.002


@pytest.mark.parametrize("courant", [0.4, 0.25, 0.15, 0.07])
@pytest.mark.parametrize("mach", [1.0043, 1.02, 1.042, 1.08])
def test_weakShockAtSmallCourantNumber(tmp_path, table, mach, courant):
    p2, rho2, u2 = normalShock(mach)
    case = BenchmarkCase(tmp_path / "case", box([(1, WEAK_LINES)]))

    def state(x):
        behind = x[:, 0] < 0.2
        return [np.where(behind, a, b)
                for a, b in ((rho2, 1.0), (u2 * C, 0.0), (p2, 1.0))]

    case.start(state, {"left": "fixed", "right": "open"})
    case.runTo(WEAK_TRAVEL / (mach * C), maxCo=courant)
    p = case.result("p")
    over = (p.max() - p2) / (p2 - 1)
    table.add(f"shock, M {mach}, Courant number {courant}",
              f"{WEAK_LINES} lines", "overshoot of p over the jump", over, "0",
              WEAK_OVERSHOOT, seconds=case.seconds)
    assert over < WEAK_OVERSHOOT
    # It has arrived, and not smeared out
    x = case.x[:, 0]
    middle = p > 1 + 0.1 * (p2 - 1)
    middle &= p < 1 + 0.9 * (p2 - 1)
    assert abs(x[middle].mean() - 0.2 - WEAK_TRAVEL) < 0.01
    assert middle.sum() < 16


def along(rows):
    """A wall's displacement or velocity in x: pairs (time, value)."""
    rows = " ".join(f"({t:.15g} ({u:.15g} 0 0))" for t, u in rows)
    return ("type uniformFixedValue; uniformValue table (" + rows
            + "); value uniform (0 0 0);")


def pistonCase(folder, lines, wall, end, field="pointMotionU",
               capturing=True, **control):
    """Gas at rest between a piston at x = 0 and a wall at x = 1."""
    case = BenchmarkCase(folder, box([(1, lines)]), capturing=capturing)
    case.start(lambda x: (np.ones(len(x)), 0.0, 1.0),
               {"left": "wall", "right": "wall"})
    case.move(field, {"left": along(wall)})
    case.runTo(end, **control)
    return case


# Impulsive piston: L1 errors of p over the pressure behind the wave, at 100,
# 200 and 400 lines, and the pressure on the piston
IMPULSIVE = {0.5: 0.008, 2.0: 0.015, -0.5: 0.004}
AT_PISTON = 0.02


@pytest.mark.parametrize("speed", IMPULSIVE)
def test_impulsivePiston(tmp_path, table, speed):
    wave, p1, _ = pushedPiston(speed)
    end = 0.5 / max(wave, 1) / C
    errors, seconds = [], []
    for n in (100, 200, 400):
        case = pistonCase(tmp_path / str(n), n,
                          [(0, speed * C), (1, speed * C)], end)
        x, p = case.nodes()[:, 0], case.result("p")
        seconds.append(case.seconds)
        if speed > 0:
            exact = np.where(x < wave * C * end, p1, 1.0)
        else:
            s = np.clip(x / (C * end), wave, 1)
            exact = (1 + (s - 1) / 6)**7  # fan: c/c0 = 1 + (x/t/c0 - 1)/6
        errors.append(l1(p - exact, weights1D(x)) / max(p1, 1))
    near = x < x[0] + 0.05
    onPiston = p[near].mean() / p1
    name = f"piston at {speed} c0 at once"
    table.add(name, "100 200 400 lines, moving", "L1 of p over its largest",
              errors, "exact", f"last {IMPULSIVE[speed]}", orders(errors),
              seconds)
    table.add(name, "last", "p at the piston, error", onPiston - 1,
              f"{p1:.5g}", AT_PISTON)
    assert errors[-1] < IMPULSIVE[speed]
    assert orders(errors)[-1] > 0.6
    assert abs(onPiston - 1) < AT_PISTON


# Smooth piston: before its waves meet, second order
SMOOTH_ORDER = 1.8
GROWTH = 0.5  # of the piston's velocity, k t^2, with c0 = length = 1


def test_smoothPiston(tmp_path, table):
    end = 0.8
    times = np.linspace(0, 1, 2001)
    wall = [(t / C, GROWTH * t**3 / 3) for t in times]
    errors, seconds = [], []
    for n in (50, 100, 200):
        case = pistonCase(tmp_path / str(n), n, wall, end / C,
                          "pointDisplacement", capturing=False)
        x = case.nodes()[:, 0]
        exact = simpleWave(x, end, GROWTH)[0]
        errors.append(l1(case.result("U")[:, 0] / C - exact, weights1D(x)))
        seconds.append(case.seconds)
    table.add("piston set in motion smoothly", "50 100 200 lines, moving",
              "L1 of u over c0", errors, "exact simple wave",
              "", orders(errors), seconds, capturing=False)
    assert orders(errors)[-1] > SMOOTH_ORDER


# Closing piston: to a fifth of the gap
GAP = 0.2
CLOSED = {"mass": 1e-12, "pressure": 0.03}


def test_closingPiston(tmp_path, table):
    """The piston speeds up and slows down smoothly, at most at Mach 0.13 (of
    the gas at the start); mass stays, pressure follows p V^1.4 = 1."""
    end = 10 / C
    times = np.linspace(0, 1, 1001)
    stroke = 1 - GAP
    wall = [(end * s, stroke * 0.5 * np.pi / end * np.sin(np.pi * s))
            for s in times]
    case = pistonCase(tmp_path / "case", 50, wall, end,
                      writeInterval=end / 5)
    masses = [
        (case.result("rho", t) * weights1D(case.nodes(t)[:, 0])).sum()
        for t in case.times()[1:]
    ]
    x, p = case.nodes()[:, 0], case.result("p")
    change = np.abs(np.array(masses) / masses[0] - 1).max()
    exact = np.ptp(x)**-1.4
    table.add("piston closing to 20 % of the gap", "50 lines, moving",
              "change of mass", change, "0", CLOSED["mass"])
    table.add("piston closing to 20 % of the gap", "50 lines, moving",
              "p at the end, error", p.mean() / exact - 1,
              f"{exact:.5g} (isentropic)", CLOSED["pressure"],
              seconds=case.seconds)
    assert np.ptp(x) == pytest.approx(GAP, rel=0.01)
    assert len(masses) == 5 and change < CLOSED["mass"]
    assert abs(p.mean() / exact - 1) < CLOSED["pressure"]
