"""The watch over the cells' volumes, and motions up to its limits."""
import re
import sys
from pathlib import Path

import numpy as np
import pytest

from foamCase import FoamCase

from boundaryMesh import BoundaryMesh
from sweptPanel import SweptPanel, leastRatio

PROJECT = Path(__file__).resolve().parents[3]
BLOCK = PROJECT / "tutorials" / "meshMotion" / "slidingBlock"
DICT = "constant/dynamicMeshDict"

for folder in ("gas", "gasSchemes"):
    sys.path.insert(0, str(Path(__file__).parents[1] / folder))

from pistonBox import PistonBox  # noqa: E402


def blockCase(folder, deltaT, endTime, **quality):
    """The sliding block, mesh alone, with the default exponents."""
    case = FoamCase(BLOCK, folder)
    case.set(DICT, "inverseDistanceCoeffs", "{ movingPatches (block); }")
    case.set(DICT, "quality", "{" + " ".join(
        f"{k} {v};" for k, v in quality.items()) + "}")
    case.set("system/controlDict", "deltaT", deltaT)
    case.set("system/controlDict", "endTime", endTime)
    case.run("blockMesh")
    return case


def move(case, check=True):
    return case.run("moveDynamicMesh", "-noFunctionObjects", check=check)


def areas(case, points):
    """Areas of one side of the cells of a plane mesh."""
    result = []
    for face in BoundaryMesh(case).patchFaces("sides"):
        p = points[face]
        normal = np.cross(p[1:-1] - p[0], p[2:] - p[0]).sum(axis=0)
        if np.all(p[:, 2] == 0):
            result.append(abs(normal[2])/2)
    return np.array(result)


def test_ratioOfTheLogIsThatOfTheCells(tmp_path):
    case = blockCase(tmp_path / "case", "1e-4", "8e-4")
    ratio = leastRatio(move(case))
    case.set("system/controlDict", "writeInterval", "8e-4")
    move(case)
    now = areas(case, case.points("0.0008"))
    wanted = (now/areas(case, case.points())).min()
    assert 0.3 < wanted < 0.9
    assert ratio == pytest.approx(wanted, rel=1e-9)


def test_warningsAsTheRatioHalves(tmp_path):
    case = blockCase(tmp_path / "case", "2e-5", "1.2e-3", warnBelow="0.5")
    log = move(case)
    ratios = [float(r) for r in re.findall(r"volume ratio (\S+),", log)]
    warned = [float(r) for r in re.findall(
        r"nearest to patch \w+,\s+to (\S+) of that", log)]
    assert len(ratios) == 60
    first = next(r for r in ratios if r < 0.5)
    second = next(r for r in ratios if r < first/2)
    third = next(r for r in ratios if r < second/2)
    assert warned == pytest.approx([first, second, third])
    assert "warnBelow 0.5" in log and "Warning" in log


def stopMessage(case, log):
    assert case.exitCode not in (0, None)
    found = re.search(
        r"would reduce a volume in cell (\d+) at \((.*)\),\s+nearest to patch"
        r" (\w+), to (\S+) of that in the undeformed mesh at time (\S+)\n",
        log)
    written = re.search(
        r"last good state is that of time (\S+), which is written", log)
    return found.groups(), written.group(1)


@pytest.mark.parametrize("processes", [1, 2])
def test_stopBeforeInversionAndRestart(tmp_path, processes):
    case = blockCase(tmp_path / "case", "1e-4", "2e-3")
    if processes == 1:
        log = move(case, check=False)
    else:
        case.run("decomposePar")
        log = case.runParallel(
            2, "moveDynamicMesh", "-noFunctionObjects", check=False)
    (cell, place, patch, ratio, time), written = stopMessage(case, log)
    assert float(ratio) <= 0
    assert float(time) == pytest.approx(float(written) + 1e-4)

    # The cell is in the gap between block and end, nearer to the floor
    x, y, z = map(float, place.split())
    assert 0 < x < 0.5 and patch in ("floor", "ends", "block")

    if processes == 2:
        # All of it is there, on both
        case.run("reconstructPar", "-latestTime")
        assert np.isfinite(case.pointField("pointDisplacement", written)).all()
    else:
        # Nothing was written at that time otherwise
        assert case.times() == ["0", "0.0005", "0.001", written]
        points = case.points(written)
        assert areas(case, points).min() > 0
        displacement = case.pointField("pointDisplacement", written)
        np.testing.assert_allclose(
            points, case.points() + displacement, rtol=0, atol=1e-11)
        middle = areas(case, points)/areas(case, case.points())
        assert middle[int(cell)] > 0

        # With other exponents the run goes on from there
        case.set("system/controlDict", "startFrom", "latestTime")
        case.set(DICT, "inverseDistanceCoeffs",
                 "{ movingPatches (block); e1 2; e2 2; }")
        log = move(case)
        assert f"Create mesh for time = {written}" in log
        assert "Time = 0.002\n" in log
        assert leastRatio(log) > 0.35


def test_stopBelow(tmp_path):
    case = blockCase(tmp_path / "case", "1e-4", "2e-3", stopBelow="0.5",
                     warnBelow="0.8")
    log = move(case, check=False)
    (_, _, _, ratio, _), _ = stopMessage(case, log)
    assert 0 < float(ratio) <= 0.5
    assert leastRatio(log) > 0.5


def test_firstStepHasNothingToWrite(tmp_path):
    case = blockCase(tmp_path / "case", "2e-3", "2e-3")
    log = move(case, check=False)
    assert case.exitCode != 0
    assert "last good state is that of time 0, the start" in log
    assert case.times() == ["0"]


@pytest.mark.parametrize("quality, expected", [
    ({"warnBelow": "2"}, ["warnBelow is 2", "0 to 1"]),
    ({"stopBelow": "-1"}, ["stopBelow is -1", "0 to 1"]),
    ({"stopBelow": "0.5"}, ["stopBelow must not be the larger"]),
    ({"warnBellow": "0.5"}, ["warnBellow", "warnBelow", "stopBelow"]),
])
def test_mistakes(tmp_path, quality, expected):
    case = blockCase(tmp_path / "case", "1e-4", "1e-4", **quality)
    log = move(case, check=False)
    assert case.exitCode != 0
    for word in expected + ["dynamicMeshDict"]:
        assert word in log


# source: eq. (M16); e = 3 is what section 5 of doc/theory/meshMotion.md says
def test_tipSweepsSixtyPerCentOfTheGap(tmp_path):
    good = SweptPanel(tmp_path / "good", 0.6, e1=3, e2=3, weights="area")
    assert leastRatio(good.moved()) > 0.05
    log = good.run("checkMesh", "-time", "1", check=False)
    assert "negative" not in log.lower()
    mesh = BoundaryMesh(good)
    tip = mesh.patchPoints("panel")
    tip = tip[np.isclose(mesh.points[tip, 1], 0.3)]
    moved = good.pointField("pointDisplacement", "1")[tip, 0]
    assert moved.max() > 0.6*0.18

    # With the default of 4 it is stopped
    bad = SweptPanel(tmp_path / "bad", 0.6)
    assert "would reduce a volume" in bad.moved(check=False)


# source: eq. (M16)
@pytest.mark.parametrize("exponent", [2, 3])
def test_evenGap(tmp_path, exponent):
    """A plane wall that moves towards another: least ratio 1 - m delta/g, with
    area weights on both, m = e - 1."""
    case = FoamCase(Path(__file__).parent / "cases" / "panel",
                    tmp_path / "case")
    (case.path / "system" / "blockMeshDict").write_text("""
FoamFile { version 2.0; format ascii; class dictionary; object blockMeshDict; }
scale 1;
vertices ((0 0 0) (1 0 0) (1 20 0) (0 20 0) (0 0 1) (1 0 1) (1 20 1) (0 20 1));
blocks (hex (0 1 2 3 4 5 6 7) (40 400 1) simpleGrading (1 1 1));
boundary (
panel { type wall; faces ((0 4 7 3)); } walls { type wall; faces ((1 2 6 5)); }
floor { type patch; faces ((0 1 5 4) (3 7 6 2)); }
front { type empty; faces ((4 5 6 7)); } back { type empty; faces ((0 3 2 1)); }
);
""")
    case.run("blockMesh")
    case.set(DICT, "inverseDistanceCoeffs",
             "{ movingPatches (panel); fixedPatches (walls); tolerance 1e-4;"
             f" weights area; e1 {exponent}; e2 {exponent}; }}")
    case.set("0/pointDisplacement", "boundaryField/floor",
             "{ type calculated; }")
    case.set("0/pointDisplacement", "boundaryField/panel",
             "{ type fixedValue; value uniform (0.3 0 0); }")
    case.run("moveDynamicMesh")
    x = case.points()
    moved = case.pointField("pointDisplacement", "1")[:, 0]
    middle = np.isclose(x[:, 1], 10) & (x[:, 2] == 0)
    order = np.argsort(x[middle, 0])
    ratios = 1 + np.diff(moved[middle][order])/np.diff(x[middle, 0][order])
    m = exponent - 1
    assert ratios.min() == pytest.approx(1 - 0.3*m, abs=0.02)


def test_gasStopsAndGoesOn(tmp_path):
    """shockShellFoam watches its simplices, before the gas moves."""
    case = PistonBox(
        tmp_path / "case", (10, 4), "type uniformFixedValue; uniformValue"
        " table ((0 (0 0 0)) (1 (1 0 0)));", "inverseDistance")
    case.schemes("timeScheme twoStep;")
    case.start(np.ones(len(case.x)), (0, 0, 0), 1.0)
    case.run("foamDictionary", DICT, "-entry", "quality", "-add",
             "{ stopBelow 0.5; warnBelow 0.8; }")
    case.runTo(0.6, deltaT="0.01", adjustTimeStep="no")
    (cell, place, patch, ratio, time), written = stopMessage(case, case.log)
    assert 0 < float(ratio) <= 0.5
    assert patch in ("piston", "walls", "end")
    assert float(written) == pytest.approx(float(time) - 0.01)
    for name in ("p", "U", "T", "rho"):
        assert np.isfinite(case.pointField(name, written)).all()
    piston = case.points(written)[:, 0].min()
    assert piston == pytest.approx(float(written), abs=1e-8)
    mass = case.mass(written, (10, 4))
    assert mass == pytest.approx(1, rel=1e-7)

    case.set(DICT, "quality/stopBelow", "0")
    case.set("system/controlDict", "startFrom", "latestTime")
    end = f"{float(written) + 0.02:.3g}"
    case.set("system/controlDict", "endTime", end)
    case.run("shockShellFoam")
    assert case.times()[-1] == end
    assert case.mass(end, (10, 4)) == pytest.approx(1, rel=1e-7)
