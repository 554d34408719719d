"""Oblique shocks, expansion fans, the forward step and double Mach
reflection."""
import numpy as np
import pytest

from errorNorms import crossing
from exactSolutions import (
    machStem, obliqueShock, pitotPressure, prandtlMeyer
)
from supersonicFlows import (
    DOUBLE_MACH, DOUBLE_TIME, RAMP, STEP_MACH, column, doubleMach,
    forwardStep, machNumber, overRamp
)

# Elements over the ramp's length; bounds are those of the last
RAMPS = (16, 32, 64)
RAMPS_MESH = "16 32 64 over the ramp"
OBLIQUE = {"pressure": 0.01, "Mach": 0.01, "degrees": 0.5}
FAN = {"pressure": 0.01, "Mach": 0.005}
# Of M2 on the wall itself: the corner leaves a layer of entropy, some elements
# thick, that refinement makes thinner, not weaker
WALL = 0.06


def shockAngle(case, p2):
    """Of the shock from the corner, from the places where the pressure is
    half way, on the grid lines across; least squares through two free
    parameters, as the shock's foot is some elements wide."""
    p = case.result("p")
    places = []
    for at in np.arange(0.4, 0.96, 0.05):
        x, y, values = column(case, at, p)
        places.append((x, crossing(y, values, 0.5 * (1 + p2))))
    x, y = np.transpose(places)
    return np.arctan(np.polyfit(x, y, 1)[0])


def rampErrors(folder, mach, theta, p2, m2):
    """Cases; errors of p2/p1 on the wall, of M2 above it and on it."""
    cases, errors = [], []
    for n in RAMPS:
        case, on, above = overRamp(folder / str(n), mach, theta, n)
        machs = machNumber(case)
        errors.append((
            case.result("p")[on].mean() / p2 - 1,
            machs[above].mean() / m2 - 1, machs[on].mean() / m2 - 1,
        ))
        cases.append(case)
    return cases, np.transpose(errors)


def checkRamp(table, name, cases, errors, p2, m2, bounds):
    bounds = bounds["pressure"], bounds["Mach"], WALL
    quantities = "p2/p1 at the wall", "M2", "M2 at the wall"
    for quantity, ours, exact, bound in zip(
        quantities, errors, (p2, m2, m2), bounds
    ):
        table.add(name, RAMPS_MESH, quantity + ", error", ours,
                  f"{exact:.6g}", f"last {bound}",
                  seconds=[c.seconds for c in cases])
    assert (abs(errors[:, -1]) < bounds).all()


@pytest.mark.parametrize("mach", [2.5, 3.0])
def test_obliqueShock(tmp_path, table, mach):
    theta = np.radians(15)
    beta, p2, _, m2 = obliqueShock(mach, theta)
    name = f"oblique shock, M {mach:g}, 15 degrees"
    cases, errors = rampErrors(tmp_path, mach, theta, p2, m2)
    angles = [np.degrees(shockAngle(c, p2) - beta) for c in cases]
    table.add(name, RAMPS_MESH, "shock angle, error [degrees]", angles,
              f"{np.degrees(beta):.5g}", f"last {OBLIQUE['degrees']}")
    checkRamp(table, name, cases, errors, p2, m2, OBLIQUE)
    assert abs(angles[-1]) < OBLIQUE["degrees"]


@pytest.mark.parametrize("mach, degrees", [(2.0, 10), (2.5, 15)])
def test_expansionFan(tmp_path, table, mach, degrees):
    theta = np.radians(degrees)
    m2, p2 = prandtlMeyer(mach, theta)
    cases, errors = rampErrors(tmp_path, mach, -theta, p2, m2)
    checkRamp(table, f"Prandtl-Meyer, M {mach:g}, {degrees} degrees", cases,
              errors, p2, m2, FAN)


# Forward step. Stagnation pressure in the corner in front of the step; total
# enthalpy ahead of the step, where the flow is steady by then, and how far the
# bow shock on the floor moves with the last refinement
STEP = {"pressure": 0.05, "enthalpy": 0.015, "shock": 0.04}


@pytest.mark.parametrize("numbers", [
    (20, 40), pytest.param((40, 80, 120), marks=pytest.mark.long),
], ids=["coarse", "fine"])
def test_forwardStep(tmp_path, table, numbers):
    stagnation = pitotPressure(STEP_MACH)
    total = 3.5 / 1.4 + 0.5 * STEP_MACH**2
    pressures, shocks, seconds = [], [], []
    for n in numbers:
        case = forwardStep(tmp_path / str(n), n)
        rho, p, U = (case.result(f) for f in ("rho", "p", "U"))
        assert rho.min() > 0 and p.min() > 0
        x, y = case.x[:, 0], case.x[:, 1]
        corner = np.hypot(x - 0.6, y).argmin()
        pressures.append(p[corner])
        floor = np.flatnonzero((y < 1e-9) & (x <= 0.6 + 1e-9))
        floor = floor[np.argsort(x[floor])]
        shocks.append(crossing(x[floor], p[floor], 5))
        h = 3.5 * p / rho + 0.5 * (U**2).sum(axis=1)
        face = abs(x - 0.6) + y < 0.15
        enthalpy = abs(h[face] / total - 1).mean()
        seconds.append(case.seconds)
    mesh = " ".join(map(str, numbers)) + " over the height"
    table.add("forward step, Mach 3", mesh, "p in front of the step",
              pressures, f"{stagnation:.5g} (Rayleigh)",
              f"{100 * STEP['pressure']:g} %", seconds=seconds)
    table.add("forward step, Mach 3", "last",
              "mean error of total enthalpy before the step", enthalpy,
              f"{total:g}", STEP["enthalpy"])
    table.add("forward step, Mach 3", mesh, "place of the bow shock",
              shocks, "converges", f"moves {STEP['shock']}")
    assert abs(pressures[-1] / stagnation - 1) < STEP["pressure"]
    assert enthalpy < STEP["enthalpy"]
    assert abs(shocks[-1] - shocks[-2]) < STEP["shock"]


# Double Mach reflection. The theory takes a straight stem; the jet behind it
# pushes its foot forward
DOUBLE = {"foot": 0.04, "degrees": 2.5, "incident": 0.015}


@pytest.mark.parametrize("numbers", [
    (20, 40), pytest.param((60, 120), marks=pytest.mark.long),
], ids=["coarse", "fine"])
def test_doubleMachReflection(tmp_path, table, numbers):
    chi, speed = machStem(DOUBLE_MACH, RAMP)
    exact = speed * DOUBLE_TIME
    feet, angles, incidents, peaks, seconds = [], [], [], [], []
    for n in numbers:
        case = doubleMach(tmp_path / str(n), n)
        rho, p = case.result("rho"), case.result("p")
        assert rho.min() > 0 and p.min() > 0
        x, y = case.x[:, 0], case.x[:, 1]
        level = 0.5 * 116.5
        ramp = np.flatnonzero(
            (x > 0) & (abs(y - x * np.tan(RAMP)) < 1e-6))
        ramp = ramp[np.argsort(x[ramp])]
        feet.append(crossing(x[ramp] / np.cos(RAMP), p[ramp], level))
        top = np.flatnonzero(y > y.max() - 1e-9)
        top = top[np.argsort(x[top])]
        incidents.append(crossing(x[top], p[top], level))
        # The stem is what is ahead of the incident shock
        stem = (p > level) & (x > DOUBLE_MACH * DOUBLE_TIME + 1.5 / n)
        highest = np.flatnonzero(stem)[y[stem].argmax()]
        angles.append(np.degrees(
            np.arctan2(y[highest], x[highest]) - RAMP))
        peaks.append(rho.max())
        seconds.append(case.seconds)
    mesh = " ".join(map(str, numbers)) + " over length 1"
    name = "double Mach reflection"
    table.add(name, mesh, "Mach stem's foot along the ramp", feet,
              f"{exact:.4g} (three-shock theory)", DOUBLE["foot"] * exact,
              seconds=seconds)
    table.add(name, mesh, "angle of the triple point's path [degrees]",
              angles, f"{np.degrees(chi):.3g} (three-shock theory)",
              DOUBLE["degrees"])
    table.add(name, mesh, "incident shock", incidents,
              f"{DOUBLE_MACH * DOUBLE_TIME:g}", DOUBLE["incident"])
    table.add(name, mesh, "largest density", peaks, "rises")
    assert abs(feet[-1] / exact - 1) < DOUBLE["foot"]
    assert abs(angles[-1] - np.degrees(chi)) < DOUBLE["degrees"]
    assert abs(incidents[-1] - DOUBLE_MACH * DOUBLE_TIME) < DOUBLE["incident"]
    assert peaks[-1] > peaks[0]
