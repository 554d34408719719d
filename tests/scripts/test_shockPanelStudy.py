"""The study of the shock-tube panel: it runs, on a tiny mesh, and its numbers
are those of its runs."""
import re
import subprocess
import sys

import numpy as np
import pytest

from projectFiles import PROJECT

STUDY = PROJECT / "tutorials" / "fsi" / "shockPanelStudy"
sys.path.insert(0, str(STUDY))

import panelRun  # noqa: E402
import studies  # noqa: E402
from panelRun import Mesh, Run, coarsened, largestDifference  # noqa: E402

NUMBER = r"([-\d.]+)"


def study(*words, code=0, script=(sys.executable, STUDY/"study.py")):
    done = subprocess.run([*script, *words], stdout=subprocess.PIPE,
                          stderr=subprocess.STDOUT, universal_newlines=True)
    assert done.returncode == code, done.stdout
    return done.stdout


@pytest.fixture(scope="module")
def quick(tmp_path_factory):
    """The page and the folder of the runs."""
    folder = tmp_path_factory.mktemp("study")
    page = folder / "page.md"
    page.write_text("before\n<!-- shockPanelStudy: begin -->\nold\n"
                    "<!-- shockPanelStudy: end -->\nafter\n")
    words = ("twoWay", "oneWay", "-quick", "-runs", folder/"runs",
             "-page", page)
    study(*words, script=[STUDY/"Allrun"])
    return folder, words


def test_itWritesItsPage(quick):
    folder, _ = quick
    text = (folder / "page.md").read_text()
    assert text.startswith("before\n") and text.endswith("\nafter\n")
    assert "old" not in text
    rows = re.findall(r"^\| `(\w+)` \| (\d+) \| 0.5 \| " + NUMBER
                      + r" \| .*? \| .*? \| " + NUMBER + " % ", text, re.M)
    assert [row[:3] for row in rows] == [
        ("twoWay", "1", "0.5"), ("twoWay", "10", "5")]
    # The loads of ten gas steps ago: about a shell step's delay of a motion
    # that has lasted for ten
    assert float(rows[0][3]) == 0 and 1 < float(rows[1][3]) < 50
    assert len(re.findall(r"^\| 50 x 1 \| `oneWay` \| (?:1|10) \|", text, re.M)) == 2
    assert (folder / "pictures/shockPanelStudy50.png").stat().st_size < 150e3


def test_itsRunsAreAsAskedFor(quick):
    runs = quick[0] / "runs" / "0.1ms-cells4"
    log = (runs / "panel50-1mm-twoWay-10x0.5us/log.shockShellFoam").read_text()
    assert len(re.findall(r"^Gas: 10 step\(s\)", log, re.M)) == 20
    assert "Coupling: twoWay, 10 gas step(s)" in log
    oneWay = runs / "panel50-1mm-oneWay-1x0.5us"
    assert "Coupling: oneWay" in (oneWay / "log.shockShellFoam").read_text()
    found = Run(Mesh(50, coarser=4), "twoWay", 10, 0.5).results(runs)
    assert len(found.displacement[0]) == 20 and found.ofStable < 1


def test_whatIsDoneIsNotRunAgain(quick):
    folder, words = quick
    logs = {path: path.stat().st_mtime_ns
            for path in folder.glob("runs/*/*/log.shockShellFoam")}
    broken = sorted(logs)[0]
    broken.write_text("Time = 1e-5\n")
    study(*words)
    again = [p for p in logs if p.stat().st_mtime_ns != logs[p]]
    assert len(logs) == 4 and again == [broken]
    assert "\nEnd\n" in broken.read_text()


def test_thickPanel():
    """Cells, points at the back, and the block behind the panel's front."""
    text = (STUDY.parent / "shockPanel50/system/blockMeshDict").read_text()
    found = coarsened(text, Mesh(50, 2.5, 2))
    assert "(2.5 15 0)" in found and "(1 15 0)" not in found
    assert "(13 14 21 20 37 38 45 44) (3 8 1)" in found
    assert "(5 6 13 12 29 30 37 36) (8 25 1)" in found
    assert coarsened(text, Mesh(50, 1, 1)) == text
    with pytest.raises(ValueError, match="shockPanel50: 0 points"):
        coarsened(text.replace("(1 ", "(1.1 "), Mesh(50))


def test_largestDifference():
    """At the instants of the longer steps, over the largest of the other."""
    t = np.linspace(0, 1, 101)
    fine = (t, -2*t)
    coarse = (np.array([0.5, 1.0]), np.array([-1.1, -1.9]))
    assert largestDifference(coarse, fine) == pytest.approx(0.05)
    assert largestDifference(fine, fine) == 0


def test_stepsThatAreNotStableAreMadeSmaller():
    run = Run(Mesh(50), "twoWay", 50, 1)
    assert studies.stable(run, 1.2) == run
    less = studies.stable(run, 0.8)
    assert less.gasStep == pytest.approx(0.72) and less.subCycles == 50
    assert "paper 1, not stable" in studies.stepWords(less, run)


def test_runsThatStopSayWhy():
    """Without the program's advice, which names files of one machine."""
    advice = "\n    The run ends at ratios of 0\n\n    From function\n"
    log = f"\nTime = 1\n\n--> {panelRun.STOP} \nThe cell\n    is flat{advice}"
    assert panelRun.reason(log) == "The cell is flat"
    failed = "The step from 0 to 1 failed:\n 0  residual 1\n10  residual 1\n\n"
    assert panelRun.reason(panelRun.STOP + failed) == (
        "The step from 0 to 1 failed")
    assert not panelRun.stoppedLate(log)
    assert panelRun.stoppedLate("\nProgress: 1 %" + log)


def test_peakBetweenInstants():
    t = np.arange(0, 2, 0.2)
    found = panelRun.Results.__new__(panelRun.Results)
    found.displacement = t, 6 - (t - 0.93)**2
    assert found.peak == pytest.approx((0.93, 6))


@pytest.mark.parametrize("words, expected", [
    (("threeWay",), ["threeWay", *studies.STUDIES]),
    (("-length", "60"), ["60", "50", "40"]),
])
def test_errorsNameTheChoices(words, expected):
    said = study(*words, "-noPage", code=2)
    assert all(word in said for word in expected)


def test_pageWithoutMarksIsKnownBeforeTheRuns(tmp_path):
    page = tmp_path / "page.md"
    page.write_text("nothing\n")
    said = study("-quick", "-page", page, "-runs", tmp_path/"runs", code=1)
    assert "shockPanelStudy: begin" in said
    assert not (tmp_path / "runs").exists()
