"""The references of the benchmarks, against tabulated and published values."""
import numpy as np
import pytest

import exactSolutions as exact
from errorNorms import crossing, orders, overshoot, weights1D
from exactSolutions import reference


def test_riemannStarStates():
    rows = reference("riemann_star_states.csv")
    assert len(rows) == 11
    for row in rows:
        left, right = ([row[n + s] for n in ("rho", "u", "p")] for s in "LR")
        star = exact.Riemann(left, right)
        scale = np.sqrt(left[2] / left[0])
        assert star.p == pytest.approx(row["p_star"], rel=2e-7)
        # Toro's fifth problem has u* near 0, within the printed digits of uL
        assert star.u == pytest.approx(
            row["u_star"], rel=2e-7, abs=1e-6 * scale)
        for side, key in ((-1, "L"), (1, "R")):
            near = star.u + side * 1e-9 * scale
            rho = star.sample([near])[0, 0]
            assert rho == pytest.approx(row["rho_star" + key], rel=2e-7)


def test_riemannFanAndShock():
    """Sod: invariants in the fan, speeds of the waves."""
    sod = exact.Riemann((1, 0, 1), (0.125, 0, 0.1))
    speeds = np.linspace(-1.1, -0.1, 7)
    rho, u, p = sod.sample(speeds)
    c = np.sqrt(1.4 * p / rho)
    assert u - c == pytest.approx(speeds)
    assert u + 5 * c == pytest.approx(5 * np.sqrt(1.4))
    assert p / rho**1.4 == pytest.approx(1)
    # source: reference riemann_star_states.csv: shock 1.7521557
    assert sod.sample([1.75215])[0] > 0.2
    assert sod.sample([1.75216])[0] == 0.125


def test_reflectedShock():
    for row in reference("normal_shock_reflection.csv"):
        p2, rho2, u2 = exact.normalShock(row["Ms"])
        p5, rho5, back = exact.reflectedShock(row["Ms"])
        for ours, name in ((p2, "p2_p1"), (rho2, "rho2_rho1"), (u2, "u2_c1"),
                           (p5, "p5_p1"), (rho5, "rho5_rho1"),
                           (back, "Wr_c1")):
            assert ours == pytest.approx(row[name], rel=2e-6), name


def test_obliqueShock():
    for row in reference("oblique_shock_theta_beta_M.csv"):
        beta, p, rho, m2 = exact.obliqueShock(
            row["M1"], np.radians(row["theta_deg"]))
        assert np.degrees(beta) == pytest.approx(row["beta_deg"], rel=2e-5)
        assert p == pytest.approx(row["p2_p1"], rel=2e-5)
        assert rho == pytest.approx(row["rho2_rho1"], rel=2e-5)
        assert m2 == pytest.approx(row["M2"], rel=2e-5)


def test_prandtlMeyer():
    for row in reference("prandtl_meyer.csv"):
        m2, p = exact.prandtlMeyer(row["M1"], np.radians(row["theta_deg"]))
        assert m2 == pytest.approx(row["M2"], rel=2e-6)
        assert p == pytest.approx(row["p2_p1"], rel=2e-5)


def test_piston():
    for row in reference("moving_piston_impulsive.csv"):
        wave, p, rho = exact.pushedPiston(row["up_c0"])
        assert wave == pytest.approx(row["W_c0_or_tail"], rel=2e-6)
        assert p == pytest.approx(row["p2_p0"], rel=2e-5)
        assert rho == pytest.approx(row["rho2_rho0"], rel=2e-5)


def test_simpleWave():
    """At the piston the gas has its velocity; at the front it is at rest."""
    t, k = 0.3, 0.5
    u, c = exact.simpleWave(np.array([k * t**3 / 3, t, 2 * t]), t, k)
    assert u == pytest.approx([k * t**2, 0, 0])
    assert c == pytest.approx([1 + 0.2 * k * t**2, 1, 1])
    with pytest.raises(ValueError):
        exact.simpleWave(np.zeros(1), 2.0, 2.0)


def test_noh():
    # source: Noh 1987: density 4, 16, 64 behind the shock, its speed 1/3
    for j in (1, 2, 3):
        rho, p, speed = exact.noh(np.array([0.1, 0.199, 0.201]), 0.6, j)
        assert rho[:2] == pytest.approx(4**j)
        assert p[:2] == pytest.approx(4**j / 3)
        assert rho[2] == pytest.approx((1 + 0.6 / 0.201)**(j - 1))
        assert list(speed) == [0, 0, 1]


def test_sedovConstants():
    for row in reference("sedov_constants.csv"):
        if row["gamma"] == 1.4:
            j = row["j"]
            alpha = row["alpha"] / (2 if j == 1 else 1)
            assert exact.SEDOV_ALPHA[j] == pytest.approx(alpha, rel=1e-8)


@pytest.mark.parametrize("j", [1, 2, 3])
def test_sedovHoldsItsMassAndEnergy(j):
    blast = exact.Sedov(2.0, 0.3, j)
    r = np.linspace(0, blast.radius, 40001)
    rho, u, p = blast.sample(r)
    area = {1: 1, 2: 2 * np.pi, 3: 4 * np.pi}[j]
    w = area * weights1D(r, j - 1)
    # The profile is tabulated, and interpolated between its points
    assert (w * rho).sum() == pytest.approx(w.sum(), rel=5e-3)
    assert (w * (p / 0.4 + rho * u * u / 2)).sum() == \
        pytest.approx(2.0, rel=5e-3)


def test_pitot():
    # source: NACA Report 1135, table II: p1/p02 = 0.08291 at M1 = 3
    assert 1 / exact.pitotPressure(3) == pytest.approx(0.08291, abs=5e-6)


def test_machStem():
    """The stem is stronger than the incident shock's trace at the wall would
    be without reflection, and weaker than that of a shock standing there."""
    chi, speed = exact.machStem(10, np.radians(30))
    assert 2 < np.degrees(chi) < 20
    assert 10 < speed < 10 / np.cos(np.radians(30 + 25))


def test_vortexIsSteadyWhenItDoesNotMove():
    """Centrifugal balance dp/dr = rho u^2/r, by differences."""
    h = 1e-4
    for r in (0.3, 1.0, 2.2):
        x = np.array([[5 + r + d, 5.0, 0] for d in (-h, 0, h)])
        rho, U, p = exact.vortex(x, 0, velocity=(0, 0))
        assert (p[2] - p[0]) / (2 * h) == \
            pytest.approx(rho[1] * U[1, 1]**2 / r, rel=1e-6)
        assert p[1] / rho[1]**1.4 == pytest.approx(1)


def test_norms():
    x = np.array([0.0, 0.5, 2.0])
    for power in (0, 1, 2):
        w = weights1D(x, power)
        assert w.sum() == pytest.approx(2**(power + 1) / (power + 1))
        assert (w * x).sum() == pytest.approx(2**(power + 2) / (power + 2))
    assert list(orders([8, 2, 1])) == pytest.approx([2, 1])
    assert overshoot(np.array([-0.2, 1.1]), np.array([0, 2])) == \
        pytest.approx(0.1)
    assert crossing(x, np.array([3, 2, 0]), 1) == pytest.approx(1.25)
