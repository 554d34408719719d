"""The refinement of the shock-tube panel: its limits, what it reads from motions,
and a small run."""
import subprocess
import sys

import numpy as np
import pytest

from projectFiles import PROJECT

STUDY = PROJECT / "tutorials" / "fsi" / "shockPanelStudy"
sys.path.insert(0, str(STUDY))

from motions import Swing, dampedPeriod, oscillator  # noqa: E402
from panelRun import Mesh, coarsened  # noqa: E402
from refinedRun import theory  # noqa: E402
from richardson import limit, observedOrder  # noqa: E402


@pytest.mark.parametrize("order", (0.7, 1, 2))
@pytest.mark.parametrize("h", ((1, 2, 4), (2/3, 1, 2), (1, 1.5, 2)))
def test_limitOfAPowerOfTheCells(order, h):
    found = limit(h, [6.3 + 0.1*size**order for size in h])
    assert found.value == pytest.approx(6.3, abs=1e-9)
    assert found.order == pytest.approx(order, rel=1e-6)
    assert found.uncertainty == pytest.approx(1.25*0.1*h[0]**order)


def test_valuesWithoutAnOrder():
    """The finest value; three times what first order would leave."""
    found = limit((2/3, 1, 1.5), (6.41, 6.38, 6.41))
    assert found.order is None and found.value == 6.41
    assert found.uncertainty == pytest.approx(3*0.03*(2/3)/(1/3))
    assert observedOrder((1, 2, 4), (1, 1 + 1e-3, 2)) == pytest.approx(
        np.log2(999), rel=1e-6)
    assert limit((1, 2, 4), (1, 1.001, 2)).uncertainty == 1


def test_swingOfAForcedOscillator():
    """A constant load: 1 - cos; the load removed at rest: it stays there."""
    t = np.linspace(0, 6, 601)
    x = oscillator(t, np.ones(len(t)), 2.5)
    np.testing.assert_allclose(x, 1 - np.cos(2*np.pi*t/2.5), atol=1e-12)
    # About its own middle it swings
    swing = Swing.of(t, x - 1)
    assert swing.peak.time == pytest.approx(1.25, rel=1e-6)
    assert swing.rebound.value == pytest.approx(-1, rel=1e-3)
    assert swing.period == pytest.approx(2.5, rel=1e-6)
    assert Swing.of(t[:200], x[:200] - 1).second is None
    u = np.exp(-0.2*t)*np.sin(2*np.pi*t/2.6)
    assert dampedPeriod(t, u, 2.5) == pytest.approx(
        (2.6, 1 - np.exp(-0.2*2.6)), rel=1e-3)


def test_theoryHasThePublishedFrequency():
    # source: 364.4 Hz of the cantilever with E/(1 - nu^2), Giordano's panel
    assert theory() == pytest.approx(1e3/364.4, rel=1e-3)


def test_cellsThatAreNoWholeMultiples():
    text = (STUDY.parent / "shockPanel50/system/blockMeshDict").read_text()
    assert ") (3 23 1)" in coarsened(text, Mesh(50, coarser=2/3))
    assert ") (4 8 1)" in coarsened(text, Mesh(50, coarser=2, overPanel=4))
    noStep = STUDY.parent / "shockPanel50NoStep/system/blockMeshDict"
    assert ") (1 8 1)" in coarsened(noStep.read_text(), Mesh(50, coarser=2))


def test_smallRefinementWritesItsPage(tmp_path):
    page = tmp_path / "page.md"
    page.write_text("<!-- shockPanelRefinement: begin -->\nold\n"
                    "<!-- shockPanelRefinement: end -->\n")
    done = subprocess.run(
        [STUDY / "Allrun", "-refinement", "-quick", "-runs", tmp_path / "runs",
         "-page", page], stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
        universal_newlines=True)
    assert done.returncode == 0, done.stdout
    text = page.read_text()
    rows = [line.split(" | ") for line in text.splitlines()
            if line.startswith("| cells ")]
    assert len(rows) == 3 and "old" not in text
    # A mesh this coarse is within 5 % of the finest measured one
    assert float(rows[-1][3]) == pytest.approx(6.41, rel=0.05)
    assert float(rows[-1][4]) == pytest.approx(1.34, rel=0.02)
    assert "| limit |" in text and "no step (M2C" in text
