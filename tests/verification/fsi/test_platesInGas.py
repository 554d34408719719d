"""Rigid plates between gases: exact and converged solutions of coupled motion,
the order in time of each scheme, light plates, balances, restart."""
import re

import numpy as np
import pytest

from platesInGas import GAMMA, R, SIDE, THICKNESS, Gas, PlateInGas, \
    soundSpeed, uniform

P0, T0 = 1e5, 293.0
MASS = 7.6
AREA = SIDE**2
SCHEMES = ("twoWay", "predictedMotion", "iterated")
TIGHT = "iteratedCoeffs { tolerance 1e-10; }\n"


def coeffs(scheme):
    return TIGHT if scheme == "iterated" else ""


# Free plate in uniform gas, vacuum behind: a simple wave, exact for all times

def freePlate(t, m, p, c):
    """m du/dt = p (1 - (g - 1)/2 u/c)^(2g/(g - 1)), integrated."""
    g = GAMMA
    return 2 * c / (g - 1) * (
        1 - (1 + (g + 1) / 2 * p * t / (m * c))**(-(g - 1) / (g + 1)))


@pytest.mark.parametrize("scheme, bound", [
    ("twoWay", 4e-4), ("predictedMotion", 2e-4), ("iterated", 2e-4)])
def test_freePlateInUniformGas(tmp_path, table, scheme, bound):
    """Halves with the mesh and the step."""
    errors = []
    for cells in (200, 400):
        case = PlateInGas(tmp_path / str(cells), MASS,
                          front=Gas(0.5, cells, uniform(P0, T0)))
        case.couple(scheme).runTo(1e-3, deltaT=8e-4 / cells)
        t, _, v = case.motion()
        exact = freePlate(t, MASS, P0, soundSpeed(T0))
        errors.append(abs(v - exact).max() / exact[-1])
    table.add(f"free plate in uniform gas, `{scheme}`",
              "velocity, 200 and 400 cells, largest error over the largest",
              errors, "simple wave, exact", [bound])
    assert errors[0] < bound
    assert errors[1] < 0.55 * errors[0]


# Shock of Mach 1.21 on a plate of 7.6 kg/m2, 50 mm away at the start
# source: 1-D ALE solution on 8000 cells, within 2e-5 of the simple wave with
# p = p5 (1 - 0.2 u/c5)^7 behind the reflected shock; case time [ms] -> mm
SHOCK_ON_PLATE = {
    "front": ({}, {1: 6.4900, 2: 28.630}),
    "both": ({"back": True}, {1: 6.3893, 2: 27.697}),
    "sprung": ({"spring": 3.67544e7}, {1: 4.71329, 2: 5.4209}),
}


def shocked(x):
    """Rankine-Hugoniot, Mach 1.21 into 1e5 Pa and 293 K."""
    behind = x < -0.05 - THICKNESS / 2
    return (np.where(behind, 154145.0, P0), np.where(behind, 109.669, 0.0),
            np.where(behind, 332.3405, T0))


@pytest.mark.parametrize("name", SHOCK_ON_PLATE)
def test_shockOnPlate(tmp_path, table, name):
    options, expected = SHOCK_ON_PLATE[name]

    def run(cells):
        # 50 mm are a whole number of cells and a half: the shock starts
        # between two nodes. Its place is known to a part of a cell
        back = Gas(1, cells, uniform(P0, T0)) if "back" in options else None
        case = PlateInGas(tmp_path / str(cells), MASS, back=back,
                          front=Gas(1, cells, shocked),
                          spring=options.get("spring", 0))
        case.couple("predictedMotion", pRef=0 if back else P0)
        t, x, _ = case.runTo(2.0025e-3, deltaT=7.5e-4 / cells).motion()
        errors = [1e3 * np.interp(1e-3 * time, t, x) / millimetres - 1
                  for time, millimetres in expected.items()]
        return t, x, np.abs(errors)

    t, x, errors = run(1010)
    table.add(f"shock of Mach 1.21 on a plate, {name}",
              "displacement at 1 and 2 ms, error", errors,
              "simple wave, converged 1D solution", "2e-3")
    assert errors.max() < 2e-3
    if name == "front":
        assert (errors < 0.6 * run(510)[2]).all()
    if name == "sprung":
        # source: the same solution
        assert 1e3 * x.max() == pytest.approx(6.894, rel=1e-3)
        assert 1e3 * t[x.argmax()] == pytest.approx(1.550, rel=3e-3)


# A weak blast on a free-standing plate: the impulse that it takes

@pytest.mark.parametrize("psi", (0.3, 2.0))
def test_blastOnFreeStandingPlate(tmp_path, psi):
    """A pulse p exp(-t/theta) in the acoustic limit; psi = rho c theta/m.

    source: Taylor (1941), reprinted in Scientific Papers III, eq. for a plate
    free to move: m v' + rho c v = 2 p exp(-t/theta), of which the largest
    momentum is 2 p theta psi^(psi/(1 - psi)).
    """
    peak, c = 1e-3 * P0, soundSpeed(T0)
    impedance = P0 / (R * T0) * c
    theta = 2e-4
    mass = impedance * theta / psi
    front = -0.05

    def pulse(x):
        p = np.where(x < front, peak * np.exp((x - front) / (c * theta)), 0)
        # Isentropic to first order
        return (P0 + p, p / impedance,
                T0 * (1 + (GAMMA - 1) / GAMMA * p / P0))

    case = PlateInGas(tmp_path / "case", mass, front=Gas(0.8, 1600, pulse))
    case.couple("predictedMotion", pRef=P0)
    t, _, v = case.runTo(1e-3, deltaT=1e-6).motion()

    largest = 2 * peak * theta * psi**(psi / (1 - psi))
    assert mass * v.max() == pytest.approx(largest, rel=5e-3)
    arrival = (-THICKNESS / 2 - front) / c
    s = (t - arrival) / theta
    exact = 2 * peak * theta / (mass * (1 - psi)) * (
        np.exp(-psi * s) - np.exp(-s))
    # Behind the front, which some cells smear
    after = s > 0.2
    assert abs(v - exact)[after].max() < 0.01 * exact.max()


# Closed chamber with a spring piston
# source: Lefrancois & Boufflet, SIAM Review 52 (2010) 747: L0 = 1 m, A = 1 m2,
# U0 = 0.2 m, 1e5 Pa and 300 K at L0, expanded isentropically, k = 1e7 N/m
SPRING, START = 1e7, 0.2
P_START = 77472.265
T_START = 300 * (P_START / 1e5)**((GAMMA - 1) / GAMMA)


def chamber(folder, mass, cells, capturing="none"):
    return PlateInGas(folder, mass, spring=SPRING, capturing=capturing,
                      front=Gas(1 + START, cells, uniform(P_START, T_START),
                                farEnd="wall"))


def coupleChamber(case, scheme, **entries):
    """The spring acts from the initial place: its force there is in pRef."""
    return case.couple(scheme, pRef=1e5 + SPRING * START, **entries)


def test_closedChamber(tmp_path, table):
    case = chamber(tmp_path / "case", 1000, 50)
    coupleChamber(case, "predictedMotion", subCycles="adaptive")
    period = 2 * np.pi * np.sqrt(1000 / SPRING)
    case.runTo(2 * period, deltaT=period / 500)
    t, x, _ = case.motion()
    u = START + x
    second = t > period
    table.add("chamber with a spring piston, 1000 kg/m2", "least place [m]",
              float(u[second].min()), "-0.19954", "1e-4")
    # source: 1-D ALE solution on 800 cells, converged to 1e-5 m
    assert u[second].min() == pytest.approx(-0.19954, abs=1e-4)
    assert t[second][u[second].argmin()] == pytest.approx(0.09362, rel=2e-3)
    assert np.interp(0.1253495, t, u) == pytest.approx(0.19967, abs=1e-4)
    # As many gas steps as the Courant number asks for, all alike
    steps = [int(n) for n in re.findall(r"Gas: (\d+) step\(s\)", case.log)]
    assert min(steps) >= 2 and max(steps) <= 12
    assert max(float(c) for c in re.findall(
        r"step\(s\), (\S+) of the stable", case.log)) <= 0.8 + 1e-9


def test_closedChamberWithShocks(tmp_path, table):
    """A plate of 10 kg/m2 drives shocks, whose losses damp it."""
    case = chamber(tmp_path / "case", 10, 200, capturing="fluxCorrected")
    coupleChamber(case, "predictedMotion", subCycles=2)
    period = 2 * np.pi * np.sqrt(10 / SPRING)
    t, x, _ = case.runTo(2 * period, deltaT=period / 500).motion()
    table.add("the same, 10 kg/m2, shocks", "least place [m]",
              START + float(x[t < 0.75 * period].min()), "-0.19103", "3e-4")
    # source: 1-D ALE solution on 800 cells: time [ms], place [m]
    for time, place in ((1.570796, 0.0018604672), (3.141593, -0.19103313),
                        (6.283185, 0.18366093), (9.424778, -0.16359119),
                        (11.78097, 0.091106057)):
        assert np.interp(1e-3 * time, t, START + x) == pytest.approx(
            place, abs=3e-4)


@pytest.fixture(scope="module")
def orders(tmp_path_factory):
    """Errors of displacement, velocity and work against one gas step per step.

    The gas's mesh and step are the same in all runs: what differs is the
    number of them in a coupling step.
    """
    folder = tmp_path_factory.mktemp("orders")
    end, steps = 0.02, 2048

    def run(scheme, n, **entries):
        words = [scheme, str(n), *map(str, entries.values())]
        case = chamber(folder / "-".join(words), 1000, 50)
        coupleChamber(case, scheme, subCycles=n, coeffs=coeffs(scheme),
                      **entries).runTo(end, deltaT=end * n / steps)
        _, x, v = case.motion()
        work = case.balance()
        return np.array([
            x[-1], v[-1], work["workGas"][-1] - work["workShell"][-1]])

    finest = run("iterated", 1)
    finest[2] = 0
    cache = {}

    def observed(scheme, **entries):
        key = (scheme, *entries.values())
        if key not in cache:
            errors = np.array([abs(run(scheme, n, **entries) - finest)
                               for n in (8, 16, 32)])
            cache[key] = np.log2(errors[1:] / errors[:-1]), errors
        return cache[key]

    return observed


def addOrders(table, scheme, order, bound):
    table.add(f"closed chamber, `{scheme}`", "order in time of displacement, "
              "velocity, difference of the works", list(order[-1]), "", bound)


@pytest.mark.parametrize("scheme", ("predictedMotion", "iterated"))
def test_secondOrderInTime(orders, table, scheme):
    order, _ = orders(scheme)
    addOrders(table, scheme, order, "2 +- 0.1, 2 +- 0.1, above 1.8")
    assert (abs(order[:, :2] - 2) < 0.1).all()
    # The works by loads at both ends differ by less than the motion's error
    assert (order[:, 2] > 1.8).all()


def test_firstOrderInTime(orders, table):
    """The lag of the loads; the error of Newmark's rule is of second order."""
    order, errors = orders("twoWay")
    addOrders(table, "twoWay", order, "-, 1 +- 0.25, 1 +- 0.1")
    assert (abs(order[:, 1] - 1) < 0.25).all()
    assert (abs(order[:, 2] - 1) < 0.1).all()
    assert errors[-1, 1] > 4 * orders("predictedMotion")[1][-1, 1]


@pytest.mark.parametrize("scheme", ("twoWay", "predictedMotion"))
def test_averagedLoadsAreOfFirstOrder(orders, scheme):
    order, _ = orders(scheme, loads="average")
    assert (order[:, 1] > 0.8).all() and (order[:, 1] < 1.6).all()


# Light plates: the mass ratio (C20) by the gas's rho c and the coupling step

def lightPlate(folder, scheme, massRatio, n=20, steps=60, coeffs=""):
    """Ends in p0 - pRef = rho c v; (case, velocity over that one)."""
    h, c = 1e-3, soundSpeed(T0)
    impedance = P0 / (R * T0) * c
    dt = 0.5 * h / c
    length = max(0.1, 0.75 * c * dt * n * steps)
    case = PlateInGas(folder, massRatio * impedance * dt * n,
                      front=Gas(length, int(length / h), uniform(P0, T0)))
    case.couple(scheme, pRef=0.999 * P0, subCycles=n, coeffs=coeffs)
    case.runTo(dt * n * steps, deltaT=dt * n, check=False)
    return case, case.motion()[2] / (1e-3 * P0 / impedance)


@pytest.mark.parametrize("scheme, stable, unstable", [
    # Limits (C20): 1/2 and sqrt(3)/2
    ("twoWay", 0.7, 0.44), ("predictedMotion", 1.0, 0.75)])
def test_staggeredSchemesHaveALeastMassRatio(
    tmp_path, scheme, stable, unstable
):
    # What the first step starts decays slowly near the limit
    case, v = lightPlate(tmp_path / "stable", scheme, stable, steps=120)
    assert v[-5:] == pytest.approx(1, abs=0.02)
    assert "is not safe, (C20)" in case.log
    case, v = lightPlate(tmp_path / "unstable", scheme, unstable)
    assert abs(v[-5:]).max() > 3
    assert "choose iterated" in case.log or case.exitCode != 0
    case, v = lightPlate(tmp_path / "safe", scheme, 2.1)
    assert "is not safe" not in case.log
    assert v[-5:] == pytest.approx(1, abs=0.02)


@pytest.mark.parametrize("method", ("Aitken", "quasiNewton"))
def test_iterationTakesLightPlates(tmp_path, method):
    case, v = lightPlate(tmp_path / "case", "iterated", 0.05, coeffs=(
        f"iteratedCoeffs {{ acceleration {method}; }}\n"))
    assert v[-5:] == pytest.approx(1, abs=0.02)
    assert re.search(r"converged in 60, iteration limit reached in 0",
                     case.log)
    assert "not safe" not in case.log


def test_iterationLimitIsAnotherEnding(tmp_path):
    case, _ = lightPlate(tmp_path / "case", "iterated", 0.3, steps=10, coeffs=(
        "iteratedCoeffs { acceleration constant; relaxation 0.5; "
        "maxIterations 3; tolerance 1e-9; }\n"))
    assert case.exitCode == 0
    assert "iteration limit reached after 3 passes" in case.log
    converged, limit = map(int, re.search(
        r"converged in (\d+), iteration limit reached in (\d+)",
        case.log).groups())
    assert limit > 0 and converged + limit == 10


# Balances

def test_workAndForceAgreeInEveryStep(tmp_path):
    """Without sub-cycling: to round-off, both gases, moving plate."""
    case = PlateInGas(tmp_path / "case", MASS, front=Gas(0.3, 110, shocked),
                      back=Gas(0.3, 110, uniform(P0, T0)))
    case.couple("twoWay").runTo(1e-3, deltaT=4e-6)
    b = case.balance()
    work = b["stepWorkShell"]
    assert abs(work).max() > 0
    # Displacements of a step are differences of positions: their rounding
    position = case.motion()[1].max() + THICKNESS / 2
    rounding = 4 * np.finfo(float).eps * position * 2.5e5 * AREA
    difference = abs(b["stepWorkGas"] - work)
    assert (difference <= 1e-12 * abs(work) + rounding).all()
    assert (difference <= 1e-12 * abs(work)).mean() > 0.5
    scale = P0 * AREA
    for k in "xyz":
        assert abs(b[f"forceGas_{k}"] - b[f"forceShell_{k}"]).max() \
            <= 1e-12 * scale
        assert abs(b[f"momentGas_{k}"] - b[f"momentShell_{k}"]).max() \
            <= 1e-12 * scale * SIDE
    assert b["impulseGas_x"] == pytest.approx(b["impulseShell_x"], rel=1e-12)


@pytest.mark.parametrize("scheme", SCHEMES)
def test_closestPointsKeepUniformPressures(tmp_path, scheme):
    """On a plate that stays plane (C24) has nothing to interpolate, with gas
    on both sides and on one: the same run as with consistent loads."""
    for back in (None, Gas(0.3, 110, uniform(0.5 * P0, T0))):
        runs = {}
        for transfer in ("consistent", "closestPoint"):
            case = PlateInGas(tmp_path / f"{transfer}{bool(back)}", MASS,
                              front=Gas(0.3, 110, shocked), back=back)
            case.couple(scheme, loadTransfer=transfer, subCycles=4,
                        coeffs=coeffs(scheme))
            runs[transfer] = case.runTo(4e-4, deltaT=8e-6)
        one, two = (run.motion()[1] for run in runs.values())
        assert one[-1] > 0.005 * THICKNESS
        assert abs(two - one).max() <= 1e-10 * one[-1]
        b = runs["closestPoint"].balance()
        assert abs(b["forceGas_x"] - b["forceShell_x"]).max() \
            <= 1e-12 * P0 * AREA


def boxState(x):
    p = np.where(x < 0, P0 * (1.1 + 0.2 * np.sin(
        np.pi * (x + THICKNESS / 2) / 0.2)**2), P0)
    return p, 0 * x, 300 + 0 * x


def boxRun(folder, scheme, cells, dt):
    """Mass of the gas, and energy of gas, plate and spring, at the end."""
    case = PlateInGas(folder, 5, front=Gas(0.2, cells, boxState, "wall"),
                      back=Gas(0.2, cells, boxState, "wall"), spring=1e7,
                      capturing="none")
    case.couple(scheme).runTo(4e-3, deltaT=dt)
    _, x, v = case.motion()
    gas = re.search(r"Gas at the end: mass (\S+) kg, .* energy (\S+) J",
                    case.log)
    plate = 0 if scheme == "oneWay" else \
        0.5 * AREA * (5 * v[-1]**2 + 1e7 * x[-1]**2)
    return np.array([float(gas[1]), float(gas[2]) + plate, plate])


def test_closedBoxKeepsMassAndEnergy(tmp_path):
    # The mean pressure is 1.2e5 Pa in front, 1e5 Pa behind, to round-off of
    # the trapezoidal rule; 1/(g - 1) p V
    energy = (1.2 + 1) * P0 / (GAMMA - 1) * 0.2 * AREA
    rest = boxRun(tmp_path / "rest", "oneWay", 40, 4e-6)
    assert rest[1] == pytest.approx(energy, rel=1e-10)

    drift = {}
    for dt in (8e-6, 4e-6, 2e-6):
        mass, total, plate = boxRun(tmp_path / f"{dt}", "twoWay", 40, dt)
        assert mass == pytest.approx(rest[0], rel=1e-12)
        drift[dt] = (total - energy) / plate
    # First order in the step, by the lag of the loads
    assert 1.7 < drift[8e-6] / drift[4e-6] < 2.3
    assert 1.7 < drift[4e-6] / drift[2e-6] < 2.3

    # Without a lag: what the pressures at the wall and in the gas's energy
    # equation differ by, which falls with the mesh
    staggered = []
    for cells in (40, 80):
        mass, total, plate = boxRun(
            tmp_path / f"second{cells}", "predictedMotion", cells,
            1.6e-4 / cells)
        assert mass == pytest.approx(rest[0], rel=1e-12)
        staggered.append(abs(total - energy) / plate)
    assert staggered[0] < 0.01
    assert staggered[1] < 0.7 * staggered[0]


# Steps, restart, advice

def test_shellStepsWithinAGasStep(tmp_path):
    """A stiff spring: the error of the shell's long step goes with more."""
    def run(name, dt, **entries):
        case = PlateInGas(tmp_path / name, MASS, spring=3.67544e7,
                          front=Gas(0.6, 20, uniform(1.1 * P0, T0)))
        case.couple("predictedMotion", pRef=P0, **entries)
        return case.runTo(1.6e-3, deltaT=dt).motion()[1][-1]

    fine = run("fine", 6.25e-7)
    one = abs(run("one", 5e-5) - fine)
    four = abs(run("four", 5e-5, shellSteps=4) - fine)
    assert four < 0.5 * one


@pytest.mark.parametrize("scheme", SCHEMES)
def test_restartContinuesMotionAndBalance(tmp_path, scheme):
    runs = {}
    for name in ("whole", "parts"):
        case = PlateInGas(tmp_path / name, MASS,
                          front=Gas(0.3, 110, shocked))
        case.couple(scheme, pRef=P0, subCycles=4)
        if name == "parts":
            case.runTo(4e-4, deltaT=8e-6)
        # The whole run writes there as well: a write resets kept factors and
        # the mesh's last motion
        case.runTo(8e-4, deltaT=8e-6, writeInterval=4e-4)
        runs[name] = case
    start = "0.0004"
    _, x, v = runs["parts"].motion(start)
    _, wholeX, wholeV = runs["whole"].motion()
    # At the table's and the fields' 16 digits
    assert x[-1] == pytest.approx(wholeX[-1], rel=1e-12)
    assert v[-1] == pytest.approx(wholeV[-1], rel=1e-12)
    parts, whole = runs["parts"].balance(start), runs["whole"].balance()
    for column in ("workGas", "workShell", "impulseGas_x", "impulseShell_x"):
        assert parts[column][-1] == pytest.approx(whole[column][-1], rel=1e-12)
    for name in ("p", "U", "T"):
        one, two = (run.pointField(name, "0.0008") for run in runs.values())
        assert abs(one - two).max() <= 1e-12 * abs(one).max()
    # The first part's rows are still there
    assert len(runs["parts"].balance("0")["time"]) == 50


def test_indicatorsAndAdvice(tmp_path):
    """One-way: what the motion would change; two-way: what it changed."""
    def run(name, scheme, mass):
        case = PlateInGas(tmp_path / name, mass, front=Gas(0.3, 110, shocked))
        case.couple(scheme, pRef=P0, adviceTolerance=0.02)
        case.runTo(5e-4, deltaT=4e-6)
        load = float(re.search(r"change(?:d)? the load by about (\S+) %",
                               case.log)[1])
        damped = float(re.search(r"vibrations .* (\S+) % of their",
                                 case.log)[1])
        return case, load, damped

    case, load, damped = run("light", "oneWay", MASS)
    assert "would change the load" in case.log
    # rho5 c5 v over p5 - p1 as the plate gains p5 - p1 from 0.12043 ms on
    rho5, c5, p5 = 231614.5 / (R * 374.35), 387.69, 231614.5
    v = (p5 - P0) * (5e-4 - 0.12043e-3) / MASS
    assert load == pytest.approx(100 * rho5 * c5 * v / (p5 - P0), rel=0.05)
    assert "scene needs the motion" in case.log

    case, both, _ = run("both", "twoWay", MASS)
    assert "the motion changed the load" in case.log
    assert 0.7 * load < both < load

    case, load, damped = run("heavy", "oneWay", 100 * MASS)
    assert load < 0.5 and damped < 0.5
    assert "oneWay is enough" in case.log


@pytest.mark.parametrize("entries, expected", [
    ({"subCycles": 0}, ["subCycles", "adaptive"]),
    ({"subCycles": "many"}, ["subCycles", "adaptive"]),
    ({"shellSteps": 0}, ["shellSteps", "at least 1"]),
    ({"loads": "mean"}, ["mean", "end", "average"]),
    ({"loadTransfer": "nearest"}, ["nearest", "consistent", "closestPoint"]),
    ({"loadTransfer": "closestPoint", "loads": "average"}, ["loads end"]),
    ({"coeffs": "iteratedCoeffs { acceleration Anderson; }\n"},
     ["Anderson", "Aitken", "quasiNewton", "constant"]),
    ({"coeffs": "iteratedCoeffs { maxIterations 0; }\n"}, ["maxIterations"]),
])
def test_errorsSayWhatToChange(tmp_path, entries, expected):
    case = PlateInGas(tmp_path / "case", MASS,
                      front=Gas(0.1, 10, uniform(P0, T0)))
    case.couple("iterated", **entries).runTo(1e-5, deltaT=1e-6, check=False)
    assert case.exitCode != 0
    for word in expected + ["couplingProperties"]:
        assert word in case.log
