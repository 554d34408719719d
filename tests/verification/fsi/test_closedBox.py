"""Gas on both sides of an elastic strip in a closed box: what it keeps, and a
strip so light that only the iterated scheme can move it."""
import re

import numpy as np
import pytest

from flexibleWall import FlexibleWall, Strip

P0 = 1e5
STEP = 2.5e-6   # s, of the gas


def hump(part, half):
    """Pressure with a hump in front that is not felt at the strip at first."""
    return lambda x: np.where(
        x < 0, P0 * (1 + part * np.sin(np.pi * (x + half) / 0.1)**2), P0)


def box(folder, cells=(40, 10)):
    return FlexibleWall(folder, hump(0.2, 2.5e-4), cells=cells)


def energies(case):
    """Mass of the gas, energy of gas and strip, and of the strip, at the end."""
    gas, strip = case.gasTable(), case.stripTable()
    own = strip["kinetic"][-1] + strip["strain"][-1]
    return gas["mass"][-1], gas["energy"][-1] + own, own


def test_rigidWallsKeepMassAndEnergy(tmp_path, table):
    """Fixed mesh; waves of a tenth of the pressure hit all walls, the strip
    that moves without the gas's seeing it among them."""
    case = box(tmp_path / "case").couple("oneWay").runTo(9.6e-4, STEP)
    gas = case.gasTable()
    assert case.stripTable()["strain"].max() > 1e-5
    for name in ("mass", "energy"):
        table.add("closed box, rigid walls, fixed mesh", f"{name}, drift",
                  float(abs(gas[name] / gas[name][0] - 1).max()), "0", "1e-10")
        # source: acceptance, drift of 1e-10
        assert abs(gas[name] / gas[name][0] - 1).max() < 1e-10
    # 1/(g - 1) p V, exact for the trapezoidal rule
    assert gas["energy"][-1] == pytest.approx(2.1 * P0 / 0.4 * 5e-6, rel=1e-10)


@pytest.fixture(scope="module")
def drifts(tmp_path_factory):
    """Energy gained by gas and strip over the strip's, at 0.48 ms."""
    folder = tmp_path_factory.mktemp("drift")
    start = 2.1 * P0 / 0.4 * 5e-6

    def drift(scheme, n, cells=(40, 10), coeffs=""):
        case = box(folder / f"{scheme}{n}-{cells[0]}", cells)
        step = STEP * 40 / cells[0]
        case.couple(scheme, subCycles=n, coeffs=coeffs)
        mass, total, strip = energies(case.runTo(4.8e-4, n * step))
        assert mass == pytest.approx(case.gasTable()["mass"][0], rel=1e-13)
        assert strip > 2e-5 * start
        return (total - start) / strip

    return drift


def addDrift(table, scheme, found, bound, steps=None):
    steps = steps or ", ".join(("1", "2", "4") if len(found) == 3 else
                               ("1", "4"))
    table.add(f"closed box, elastic wall, `{scheme}`", f"energy gained over the "
              f"wall's; {steps} gas steps per coupling step", found, "0", bound)


def test_flexibleWallDriftsInFirstOrder(drifts, table):
    """twoWay, by the lag of its loads."""
    found = [drifts("twoWay", n) for n in (1, 2, 4)]
    order = np.log2(np.array(found[1:]) / found[:-1])
    addDrift(table, "twoWay", found, "order 1 +- 0.15")
    assert (abs(order - 1) < 0.15).all()
    assert found[0] < 0.03


def test_iteratedStepsKeepTheEnergyButForTheMesh(drifts, table):
    """No lag: what is left is of the mesh, not of the coupling step."""
    tight = "iteratedCoeffs { tolerance 1e-9; }\n"
    coarse = [drifts("iterated", n, coeffs=tight) for n in (1, 4)]
    fine = drifts("iterated", 1, (80, 20), coeffs=tight)
    addDrift(table, "iterated", coarse, "1e-3")
    addDrift(table, "iterated", [fine], "0.7 of that", "half the cells, 1")
    assert abs(coarse[0]) < 1e-3
    assert abs(coarse[1] - coarse[0]) < 0.1 * abs(coarse[0])
    assert abs(fine) < 0.7 * abs(coarse[0])


def test_predictionMissesFastVibrations(drifts, table):
    found = drifts("predictedMotion", 4)
    addDrift(table, "predictedMotion", [found], "0.05", "4")
    assert abs(found) < 0.05


@pytest.mark.parametrize("scheme", ["oneWay", "twoWay", "predictedMotion"])
def test_gasThatStopsLeavesTheShellsState(tmp_path, scheme):
    """Steps above the stable one; the shell goes back to the start of the
    coupling step in which the gas fails."""
    step = 2.4e-5
    case = FlexibleWall(tmp_path / "case", lambda x: np.where(
        abs(x) < 0.02, P0, np.where(abs(x) < 0.06, 2 * P0, P0)))
    case.couple(scheme, subCycles=4).runTo(2e-3, step, check=False)
    assert case.exitCode != 0
    assert "no longer in a physical state" in case.log
    own, gas = (re.search(rf'{words} written to "?([-+.\de]+)', case.log)[1]
                for words in ("shell's last good state is",
                              "state before this step is"))
    assert float(gas) - step < float(own) <= float(gas)
    assert float(own) == pytest.approx(case.stripTable()["Time"][-1], rel=1e-9)
    assert (case.path / own / "shell" / "position").exists()


# A thousandth of steel's density, 15.6 g/m2: mass ratio 0.4 in steps of 50 us
LIGHT = Strip(thickness=2e-3, E=1e7, rho=7.8)


def light(folder, scheme, n):
    case = FlexibleWall(folder, hump(0.002, 1e-3), strip=LIGHT)
    case.couple(scheme, subCycles=n, pRef=P0)
    return case.runTo(1.5e-3, n * STEP, check=False)


def test_lightStripNeedsTheIteratedScheme(tmp_path, table):
    """Above the least mass ratio nothing warns; below it staggered schemes
    warn and fail, the iterated one goes on."""
    fine = light(tmp_path / "fine", "iterated", 1)
    t, _, v = fine.motion()
    largest = abs(v).max()

    case = light(tmp_path / "iterated", "iterated", 20)
    assert case.exitCode == 0 and "is not safe" not in case.log
    converged, limit = map(int, re.search(
        r"converged in (\d+), iteration limit reached in (\d+)",
        case.log).groups())
    assert limit == 0 and converged == 30
    where, _, own = case.motion()
    assert abs(own).max() < 1.1 * largest
    # A phase error of steps that are a twentieth of the period
    assert abs(own[-5:] - np.interp(where[-5:], t, v)).max() < 0.35 * largest

    table.add("strip of mass ratio 0.39, `iterated`", "largest velocity over "
              "that in steps a 20th as long",
              float(abs(own).max() / largest), "1", "1.1")
    for scheme in ("twoWay", "predictedMotion"):
        case = light(tmp_path / scheme, scheme, 20)
        table.add(f"the same, `{scheme}` (warns)", "the same",
                  float(abs(case.motion()[2]).max() / largest), "1",
                  "must be above 2")
        assert "is not safe, (C20)" in case.log
        assert "Use coupling iterated" in case.log
        assert case.exitCode != 0 or abs(case.motion()[2]).max() > 2 * largest
