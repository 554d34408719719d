"""Viscosity and heat conduction: flow between plates, along a plate, and over
a plate that is set in motion. Prandtl number 0.72."""
import math

import numpy as np
import pytest

from benchmarkCase import BenchmarkCase
from blockMeshes import box, plane
from errorNorms import l1, orders

PRANDTL = 0.72
CP = 3.5
ORDER = 1.8


def fixedWall(U, T=1.0):
    return {"p": "type zeroGradient;",
            "U": f"type fixedValue; value uniform ({U:.17g} 0 0);",
            "T": f"type fixedValue; value uniform {T:.17g};"}


# Couette flow. The plate at y = 1 moves at U, both have T = 1: u = U y,
# T = 1 + Pr U^2/(2 cp) y (1 - y)
# source: Schlichting, Boundary-Layer Theory, sec. on the compressible Couette
# flow with constant viscosity
COUETTE_SPEED = 1.0
COUETTE_MU = 0.05


def couette(y):
    U = COUETTE_SPEED
    return U * y, 1 + PRANDTL * U**2 / (2 * CP) * y * (1 - y)


def test_couette(tmp_path, table):
    """Starts with the velocity of rest half way to the steady one, and
    settles."""
    numbers = (8, 16, 32)
    errors, heats, seconds = [], [], []
    for n in numbers:
        case = BenchmarkCase(
            tmp_path / str(n), box([(2 / n, 2)], (1, n)).cyclic(
                "left", "right"), mu=COUETTE_MU, prandtl=PRANDTL)

        def state(x):
            u, T = couette(x[:, 1])
            wave = 0.2 * np.sin(np.pi * x[:, 1])
            return 1 / T, u + wave, 1.0

        case.start(state, {"bottom": fixedWall(0),
                           "top": fixedWall(COUETTE_SPEED)})
        case.runTo(40.0)
        u, T = couette(case.x[:, 1])
        errors.append(l1(case.result("U")[:, 0] - u))
        heats.append(l1(case.result("T") - T))
        seconds.append(case.seconds)
    table.add("Couette flow", "8 16 32 across", "L1 of u", errors, "exact",
              1e-4, "", seconds)
    table.add("Couette flow", "same", "L1 of T", heats, "exact", "",
              orders(heats, numbers))
    # Linear: exact on every mesh; the parabola is of second order
    assert max(errors) < 1e-4
    assert orders(heats, numbers)[-1] > ORDER or max(heats) < 1e-5


# Poiseuille flow, driven by a body force G: u = rho G y (1 - y)/(2 mu). Slow,
# so that density and temperature stay within 1e-3 of 1
FORCE = 0.02
POISEUILLE_MU = 0.05


def test_poiseuille(tmp_path, table):
    numbers = (8, 16, 32)
    errors, seconds = [], []
    for n in numbers:
        case = BenchmarkCase(
            tmp_path / str(n), box([(2 / n, 2)], (1, n)).cyclic(
                "left", "right"), mu=POISEUILLE_MU, prandtl=PRANDTL,
            gravity=(FORCE, 0, 0))

        def exact(y):
            return FORCE * y * (1 - y) / (2 * POISEUILLE_MU)

        case.start(lambda x: (np.ones(len(x)), exact(x[:, 1]), 1.0),
                   {"bottom": fixedWall(0), "top": fixedWall(0)})
        case.runTo(20.0)
        u = case.result("U")[:, 0]
        errors.append(l1(u - exact(case.x[:, 1])) / exact(0.5))
        seconds.append(case.seconds)
    table.add("Poiseuille flow", "8 16 32 across", "L1 of u over its largest",
              errors, "exact", 2e-3, orders(errors, numbers), seconds)
    assert errors[-1] < 2e-3


# A plate that is set in motion at once (Stokes' first problem), slowly:
# u = U erfc(y/(2 sqrt(nu t)))
STOKES_SPEED = 0.01
STOKES_MU = 0.01
STOKES_END = 1.0


def test_suddenPlate(tmp_path, table):
    """Starts at STOKES_END/4, when the layer is some elements thick."""
    numbers = (16, 32, 64)
    errors, seconds = [], []
    for n in numbers:
        case = BenchmarkCase(
            tmp_path / str(n), box([(2 / n, 2)], (1, n)), mu=STOKES_MU,
            prandtl=PRANDTL, capturing=False)

        def exact(y, t):
            return STOKES_SPEED * np.array([
                math.erfc(v / (2 * math.sqrt(STOKES_MU * t))) for v in y])

        case.start(
            lambda x: (np.ones(len(x)), exact(x[:, 1], STOKES_END / 4), 1.0),
            {"bottom": fixedWall(STOKES_SPEED), "top": "wall",
             "left": "open", "right": "open"})
        case.runTo(0.75 * STOKES_END)
        error = case.result("U")[:, 0] - exact(case.x[:, 1], STOKES_END)
        errors.append(l1(error) / STOKES_SPEED)
        seconds.append(case.seconds)
    table.add("plate set in motion", "16 32 64 across", "L1 of u over U",
              errors, "exact", "", orders(errors, numbers), seconds)
    assert orders(errors, numbers)[-1] > ORDER


# Boundary layer on a flat plate, Mach 0.2, Re = 1e4 at its end.
# source: Blasius: wall friction c_f = 0.66412/sqrt(Re_x) (Schlichting)
PLATE_MACH = 0.2
PLATE_RE = 1e4
FRICTION = 0.05


def plateMesh(n):
    """A slip wall of 0.4 ahead of the plate of length 1; n elements across
    twice the layer's thickness at the end."""
    delta = 5 / math.sqrt(PLATE_RE)
    corners = [(x, y) for y in (0, 2 * delta, 0.6) for x in (-0.4, 0, 1)]
    blocks = [((0, 1, 4, 3), (n // 2, n)), ((1, 2, 5, 4), (n, n)),
              ((3, 4, 7, 6), (n // 2, n // 2)), ((4, 5, 8, 7), (n, n // 2))]
    return plane(corners, blocks, {
        "symmetry": [(0, 1)], "plate": [(1, 2)], "inlet": [(0, 3), (3, 6)],
        "outlet": [(2, 5), (5, 8)], "top": [(6, 7), (7, 8)],
    })


@pytest.mark.long
def test_boundaryLayer(tmp_path, table):
    U = PLATE_MACH * math.sqrt(1.4)
    mu = U / PLATE_RE
    ratios, seconds = [], []
    for n in (20, 40, 80):
        case = BenchmarkCase(tmp_path / str(n), plateMesh(n), mu=mu,
                             prandtl=PRANDTL)
        adiabatic = fixedWall(0)
        adiabatic["T"] = "type zeroGradient;"
        case.start(lambda x: (np.ones(len(x)), U, 1.0), {
            "symmetry": "wall", "plate": adiabatic, "inlet": "far",
            "outlet": "far", "top": "far"})
        case.runTo(5 / U, timeout=1800)
        # Slope at the plate's points between 0.5 and 0.9, second order
        ys = np.unique(case.x[:, 1].round(9))[:3]
        u = case.result("U")[:, 0]
        rows = []
        for y in ys:
            on = abs(case.x[:, 1] - y) < 1e-8
            x = case.x[on, 0]
            order = np.argsort(x)
            rows.append((x[order], u[on][order]))
        x = rows[0][0]
        slope = (4 * rows[1][1] - rows[2][1] - 3 * rows[0][1]) / (2 * ys[1])
        part = (x > 0.5) & (x < 0.9)
        friction = mu * slope[part] / (0.5 * U**2)
        exact = 0.66412 / np.sqrt(PLATE_RE * x[part])
        ratios.append((friction / exact).mean())
        seconds.append(case.seconds)
    table.add("boundary layer, Re 1e4", "20 40 80 along and across",
              "wall friction over Blasius'", ratios, "1", FRICTION,
              seconds=seconds)
    assert abs(ratios[-1] - 1) < FRICTION
