"""The tutorial tutorials/meshMotion/slidingBlock with rhoCentralDyMFoam."""
from pathlib import Path

import numpy as np
import pytest

from foamCase import FoamCase

from boundaryMesh import BoundaryMesh

CASE = Path(__file__).resolve().parents[3].joinpath(
    "tutorials", "meshMotion", "slidingBlock")
END = "0.0006"


@pytest.fixture(scope="module")
def block(tmp_path_factory):
    case = FoamCase(CASE, tmp_path_factory.mktemp("block") / "case")
    case.set("system/controlDict", "endTime", END)
    case.set("system/controlDict", "writeInterval", END)
    case.run("blockMesh")
    case.log = case.run("rhoCentralDyMFoam")
    case.mesh = BoundaryMesh(case)
    return case


def test_blockGoesItsWay(block):
    points = block.mesh.patchPoints("block")
    moved = block.points(END)[points] - block.mesh.points[points]
    way = 0.12*(1 + np.sin(2*np.pi*250*(float(END) - 1e-3)))
    np.testing.assert_allclose(
        moved, np.tile([way, 0, 0], (len(points), 1)), rtol=0, atol=1e-10)


def test_floorAndRoofSlide(block):
    for patch, height in (("floor", 0), ("roof", 0.4)):
        points = np.setdiff1d(block.mesh.patchPoints(patch),
                              block.mesh.patchPoints("block", "ends"))
        now = block.points(END)[points]
        assert np.all(now[:, 1] == height)
        assert np.all(now[:, 0] > block.mesh.points[points, 0])


def test_endsStay(block):
    points = block.mesh.patchPoints("ends")
    assert np.all(block.points(END)[points] == block.mesh.points[points])


def test_meshStaysValid(block):
    assert "Mesh OK." in block.run("checkMesh", "-latestTime")
    assert block.log.count("Mesh motion: least volume ratio") == 120


def test_massStays(block):
    mass = block.history("mass/0/volFieldValue.dat")[1][:, 1]
    # What rhoCentralDyMFoam loses at its moving wall
    assert abs(mass/mass[0] - 1).max() < 5e-4
