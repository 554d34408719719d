"""Onset of flutter of a clamped panel at Mach 5 against linear piston theory."""
import pytest

from panelInStream import PanelInStream, growthRate, pistonTheory, youngFor

# source: 636.57 of the clamped plane panel without damping (Galerkin, 12 modes,
# w"" + lambda w' = k w; lambda = 2 q a^3/(beta D))
UNDAMPED = 636.5656


def onset(rate, low, high):
    """lambda at which the growth rate starts to be positive."""
    for _ in range(40):
        middle = 0.5 * (low + high)
        low, high = (low, middle) if rate(middle) > 1e-3 else (middle, high)
    return low


def test_theoryHasThePublishedOnset():
    found = onset(lambda x: pistonTheory(x, damped=False), 500, 800)
    assert found == pytest.approx(UNDAMPED, rel=1e-3)


def computedOnset(folder, cells, parameters=(660, 690)):
    """By the line through the growth rates of two runs."""
    rates = []
    for parameter in parameters:
        case = PanelInStream(folder / str(parameter), youngFor(parameter), cells)
        rates.append(growthRate(*case.runTo(0.045).motion()))
    slope = (rates[1] - rates[0]) / (parameters[1] - parameters[0])
    assert slope > 1
    return parameters[0] - rates[0] / slope


def expected():
    """The gas of these runs damps the panel: 0.8 % above."""
    found = onset(pistonTheory, 500, 800)
    assert 1.004 * UNDAMPED < found < 1.02 * UNDAMPED
    return found


def add(table, mesh, found, bound):
    table.add(f"flutter of a clamped panel at Mach 5, {mesh} over it",
              "onset, 2 q a^3/(beta D)", found,
              f"{expected():.4g}, piston theory with its damping", bound)


def test_onset(tmp_path, table):
    found = computedOnset(tmp_path, (40, 4, 16))
    add(table, "40 cells", found, "4 %")
    assert found == pytest.approx(expected(), rel=0.04)


def test_stiffPanelDecays(tmp_path):
    case = PanelInStream(tmp_path / "case", youngFor(0.95 * UNDAMPED))
    assert growthRate(*case.runTo(0.03).motion()) < -20


@pytest.mark.long
def test_onsetOnAFinerMesh(tmp_path, table):
    found = computedOnset(tmp_path, (60, 6, 20))
    add(table, "60 cells", found, "1.5 %")
    assert found == pytest.approx(expected(), rel=0.015)
