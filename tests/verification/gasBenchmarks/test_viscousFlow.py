"""Viscosity and heat conduction: flow between plates, along a plate, and over
a plate that is set in motion, waves that decay. Prandtl number 0.72."""
import math

import numpy as np
import pytest

from benchmarkCase import BenchmarkCase
from blockMeshes import box
from errorNorms import l1, orders, weights1D

PRANDTL = 0.72
CP = 3.5
ORDER = 1.8


def plate(U, T=None):
    """A no-slip wall that slides with U along x; without T adiabatic."""
    return {"p": "type zeroGradient;",
            "U": f"type noSlip; value uniform ({U:.17g} 0 0);",
            "T": "type zeroGradient;" if T is None else
                 f"type fixedValue; value uniform {T:.17g};"}


def channel(n):
    """Two cells along x, which repeats, and n across."""
    return box([(2 / n, 2)], (1, n)).cyclic("left", "right")


# Couette flow. The plate at y = 1 moves at U with T = 1, the one at y = 0 has
# T = 1 as well or is adiabatic: u = U y and T = 1 + a y (1 - y), or
# 1 + a (1 - y^2), a = Pr U^2/(2 cp)
# source: Schlichting, Boundary-Layer Theory, sec. on the compressible Couette
# flow with constant viscosity
COUETTE_SPEED = 1.0
COUETTE_MU = 0.05


def couette(y, adiabatic):
    a = PRANDTL * COUETTE_SPEED**2 / (2 * CP)
    heat = 1 - y**2 if adiabatic else y * (1 - y)
    return COUETTE_SPEED * y, 1 + a * heat


@pytest.mark.parametrize("adiabatic", [False, True],
                         ids=["temperatures", "adiabatic"])
def test_couette(tmp_path, table, adiabatic):
    """Starts with more velocity than the steady one, and settles."""
    numbers = (8, 16, 32)
    errors, heats, seconds = [], [], []
    for n in numbers:
        case = BenchmarkCase(tmp_path / str(n), channel(n), mu=COUETTE_MU,
                             prandtl=PRANDTL)

        def state(x):
            u, T = couette(x[:, 1], adiabatic)
            wave = 0.2 * np.sin(np.pi * x[:, 1])
            return 1 / T, u + wave, 1.0

        case.start(state, {"bottom": plate(0, None if adiabatic else 1),
                           "top": plate(COUETTE_SPEED, 1)})
        case.runTo(60.0)
        u, T = couette(case.x[:, 1], adiabatic)
        errors.append(l1(case.result("U")[:, 0] - u))
        heats.append(l1(case.result("T") - T))
        seconds.append(case.seconds)
    name = "Couette flow" + (", one plate adiabatic" if adiabatic else "")
    table.add(name, "8 16 32 across", "L1 of u", errors, "exact",
              "last 1e-6", "", seconds)
    table.add(name, "same", "L1 of T", heats, "exact", "",
              orders(heats, numbers))
    # Velocity is linear, temperature a parabola
    assert errors[-1] < 1e-6
    assert orders(heats, numbers)[-1] > ORDER


# Poiseuille flow, driven by a body force G: u = rho G y (1 - y)/(2 mu). Slow,
# so that density and temperature stay within 1e-3 of 1
FORCE = 0.02
POISEUILLE_MU = 0.05


@pytest.mark.parametrize("capturing", [False, True],
                         ids=["none", "capturing"])
def test_poiseuille(tmp_path, table, capturing):
    numbers = (8, 16, 32)
    errors, seconds = [], []
    for n in numbers:
        case = BenchmarkCase(tmp_path / str(n), channel(n), mu=POISEUILLE_MU,
                             prandtl=PRANDTL, gravity=(FORCE, 0, 0),
                             capturing=capturing)

        def exact(y):
            return FORCE * y * (1 - y) / (2 * POISEUILLE_MU)

        case.start(lambda x: (np.ones(len(x)), exact(x[:, 1]), 1.0),
                   {"bottom": plate(0, 1), "top": plate(0, 1)})
        # The body force is gravity, with which 1/sqrt(3) is the limit
        case.runTo(20.0, maxCo=0.5)
        u = case.result("U")[:, 0]
        errors.append(l1(u - exact(case.x[:, 1])) / exact(0.5))
        seconds.append(case.seconds)
    table.add("Poiseuille flow", "8 16 32 across", "L1 of u over its largest",
              errors, "exact", "last 5e-4", orders(errors, numbers),
              seconds, capturing=capturing)
    assert errors[-1] < 5e-4
    assert orders(errors, numbers)[-1] > ORDER


# A plate that is set in motion at once (Stokes' first problem), slowly:
# u = U erfc(y/(2 sqrt(nu t)))
STOKES_SPEED = 0.01
STOKES_MU = 0.01
STOKES_END = 1.0


def test_suddenPlate(tmp_path, table):
    """Starts at STOKES_END/4, when the layer is some elements thick."""
    numbers = (32, 64, 128)
    errors, seconds = [], []
    for n in numbers:
        case = BenchmarkCase(tmp_path / str(n), channel(n), mu=STOKES_MU,
                             prandtl=PRANDTL, capturing=False)

        def exact(y, t):
            return STOKES_SPEED * np.array([
                math.erfc(v / (2 * math.sqrt(STOKES_MU * t))) for v in y])

        case.start(
            lambda x: (np.ones(len(x)), exact(x[:, 1], STOKES_END / 4), 1.0),
            {"bottom": plate(STOKES_SPEED, 1), "top": "wall"})
        case.runTo(0.75 * STOKES_END)
        error = case.result("U")[:, 0] - exact(case.x[:, 1], STOKES_END)
        errors.append(l1(error) / STOKES_SPEED)
        seconds.append(case.seconds)
    table.add("plate set in motion", "32 64 128 across", "L1 of u over U",
              errors, "exact", "", orders(errors, numbers), seconds,
              capturing=False)
    assert orders(errors, numbers)[-1] > ORDER


# Waves of small amplitude that decay, in a periodic scene. Order of the whole
# scheme in space and time, with steps in proportion to the elements
WAVE = 2 * np.pi
WAVE_ORDER = 1.9
SMALL = 1e-5


def test_shearWave(tmp_path, table):
    """u = SMALL sin(k x) across the wave decays with exp(-nu k^2 t)."""
    numbers, mu, end = (16, 32, 64), 0.01, 2.0
    decay = math.exp(-mu * WAVE**2 * end)
    errors, seconds = [], []
    for n in numbers:
        mesh = box([(1, n)], (2 / n, 2)).cyclic("left", "right")
        case = BenchmarkCase(tmp_path / str(n), mesh.cyclic("bottom", "top"),
                             mu=mu, prandtl=PRANDTL, capturing=False)

        def wave(x):
            U = np.zeros((len(x), 3))
            U[:, 1] = SMALL * np.sin(WAVE * x[:, 0])
            return np.ones(len(x)), U, 1.0

        case.start(wave, {})
        case.runTo(end)
        v = case.result("U")[:, 1] / SMALL
        errors.append(l1(v - decay * np.sin(WAVE * case.x[:, 0])))
        seconds.append(case.seconds)
    table.add("shear wave that decays", "16 32 64 along", "L1 of v", errors,
              "exact", "", orders(errors, numbers), seconds, capturing=False)
    assert orders(errors, numbers)[-1] > WAVE_ORDER


def linearModes(mu, t):
    """Amplitudes of rho, u, T in exp(ikx) after t, of those at the start:
    exp of the matrix of the linear equations for gas at rest, rho = p = 1."""
    ik, cv = 1j * WAVE, CP - 1
    A = np.array([
        [0, -ik, 0],
        [-ik, -4 / 3 * mu * WAVE**2, -ik],
        [0, -ik / cv, -CP * mu / PRANDTL / cv * WAVE**2],
    ])
    values, vectors = np.linalg.eig(A)
    return vectors @ np.diag(np.exp(values * t)) @ np.linalg.inv(vectors)


def test_heatAndSound(tmp_path, table):
    """A wave of temperature at constant pressure in a closed tube: it makes
    sound, which is damped, and decays by conduction."""
    numbers, mu, end = (25, 50, 100), 0.01, 1.5
    start = np.array([-1, 0, 1])
    amplitudes = linearModes(mu, end) @ start
    errors, seconds = [], []
    for n in numbers:
        case = BenchmarkCase(tmp_path / str(n), box([(1, n)]), mu=mu,
                             prandtl=PRANDTL, capturing=False)

        def wave(x):
            return 1 - SMALL * np.cos(WAVE * x[:, 0]), 0.0, 1.0

        case.start(wave, {"left": "wall", "right": "wall"})
        case.runTo(end)
        x = case.x[:, 0]
        exact = (amplitudes[2] * np.cos(WAVE * x)).real
        error = (case.result("T") - 1) / SMALL - exact
        errors.append((weights1D(x) * abs(error)).sum())
        seconds.append(case.seconds)
    table.add("heat and sound that decay", "25 50 100 lines", "L1 of T",
              errors, "exact, linear", "", orders(errors, numbers), seconds,
              capturing=False)
    assert orders(errors, numbers)[-1] > WAVE_ORDER


# Boundary layer on an adiabatic flat plate, Mach 0.2, Re = 1e4 at its end. The
# scene begins half way along the plate and ends at twice the layer's
# thickness; the far states are Blasius'.
# source: Blasius: 2 f_3 + f f_2 = 0 (derivatives), f_2 = 0.332057 at the wall
# (Schlichting)
PLATE_MACH = 0.2
PLATE_RE = 1e4
BLASIUS = 0.332057
FRICTION = 0.02


def blasius(x, y, U, nu):
    """Velocity (n, 3), by Runge-Kutta steps of 0.01 from the plate."""
    step, rows = 0.01, [np.array([0.0, 0.0, BLASIUS])]

    def slope(f):
        return np.array([f[1], f[2], -0.5 * f[0] * f[2]])

    for _ in range(1500):
        f = rows[-1]
        k1 = slope(f)
        k2 = slope(f + step / 2 * k1)
        k3 = slope(f + step / 2 * k2)
        k4 = slope(f + step * k3)
        rows.append(f + step / 6 * (k1 + 2 * k2 + 2 * k3 + k4))
    eta = y * np.sqrt(U / (nu * x))
    f, df = (np.interp(eta, step * np.arange(len(rows)),
                       [row[i] for row in rows]) for i in (0, 1))
    v = 0.5 * np.sqrt(nu * U / x) * (eta * df - f)
    return np.stack([U * df, v, 0 * x], 1)


def wallFriction(case, mu):
    """Places and mu du/dy at the plate's points, second order."""
    ys = np.unique(case.x[:, 1].round(9))[:3]
    u = case.result("U")[:, 0]
    rows = []
    for y in ys:
        on = abs(case.x[:, 1] - y) < 1e-8
        x = case.x[on, 0]
        order = np.argsort(x)
        rows.append((x[order], u[on][order]))
    slope = (4 * rows[1][1] - rows[2][1] - 3 * rows[0][1]) / (2 * ys[1])
    return rows[0][0], mu * slope


@pytest.mark.parametrize("capturing, numbers", [
    (False, (10, 20, 40)),
    pytest.param(True, (20, 40, 80), marks=pytest.mark.long),
], ids=["none", "capturing"])
def test_boundaryLayer(tmp_path, table, capturing, numbers):
    """Starts as Blasius' layer and stays so for two passages."""
    U = PLATE_MACH * math.sqrt(1.4)
    mu = U / PLATE_RE
    height = 2 * 5 / math.sqrt(PLATE_RE)

    def layer(x):
        # Temperature by Crocco and Busemann, recovery factor sqrt(Pr)
        u = blasius(x[:, 0], x[:, 1], U, mu)
        warm = math.sqrt(PRANDTL) * (U**2 - u[:, 0]**2) / (2 * CP)
        return 1 / (1 + warm), u, 1.0

    ratios, seconds = [], []
    for n in numbers:
        mesh = box([(0.5, n // 2)], (height, n), origin=(0.5, 0, 0))
        case = BenchmarkCase(tmp_path / str(n), mesh, mu=mu, prandtl=PRANDTL,
                             capturing=capturing)
        case.start(layer, {"bottom": plate(0), "left": "far", "right": "far",
                           "top": "far"})
        case.runTo(2 * 0.5 / U, timeout=1800)
        x, stress = wallFriction(case, mu)
        part = (x > 0.6) & (x < 0.9)
        exact = BLASIUS * U**2 / np.sqrt(PLATE_RE * x[part])
        ratios.append((stress[part] / exact).mean())
        seconds.append(case.seconds)
    table.add("boundary layer, Re 1e4",
              " ".join(map(str, numbers)) + " across two thicknesses",
              "wall friction over Blasius'", ratios, "1", f"last {FRICTION}",
              seconds=seconds, capturing=capturing)
    assert abs(ratios[-1] - 1) < FRICTION
