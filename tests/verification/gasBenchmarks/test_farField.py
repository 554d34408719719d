"""What a pressure pulse of 10 % leaves behind when it goes out of the scene."""
import pytest

from pulses import along, corner, oblique, reflections

# Largest parts of the pulse that may come back
STRAIGHT = 0.01
OBLIQUE = 0.1
OTHER_ANGLES = 0.05
CORNER = 0.05

# A wall sends all of it back, twice as high while they overlap
WALL = 0.8

# Cells of the ducts across; along they have 100
DUCTS = {"1D": (), "2D": (5,), "3D": (4, 4)}


def compare(tmp_path, table, name, mesh, pulse, bound, capturing):
    """A far field, and the paper's extrapolation."""
    results = []
    for kind, (found, case) in zip(
        ("far field", "zeroGradient"),
        reflections(tmp_path, pulse, ("far", "open"), capturing),
    ):
        table.add(f"pulse at {kind}, {name}", mesh, "largest part sent back",
                  found, "0", "" if results else bound, seconds=case.seconds,
                  capturing=capturing)
        results.append(found)
    far, extrapolated = results
    assert far <= bound
    assert far < extrapolated


@pytest.mark.parametrize("scene, capturing", [
    ("1D", True), ("1D", False), ("2D", True), ("3D", True), ("3D", False),
])
def test_straight(tmp_path, table, scene, capturing):
    compare(tmp_path, table, scene, "100 cells", along(100, DUCTS[scene]),
            STRAIGHT, capturing)


def test_aWallSendsItBack(tmp_path):
    """The measure sees what is there to see."""
    (found, _), = reflections(tmp_path, along(100, ()), ["wall"])
    assert found > WALL


@pytest.mark.parametrize("capturing", [True, False],
                         ids=["capturing", "none"])
def test_at45DegreesIn3D(tmp_path, table, capturing):
    compare(tmp_path, table, "45 degrees, 3D", "40 x 57 x 4",
            oblique(40, 45, 4), OBLIQUE, capturing)


@pytest.mark.parametrize("degrees", [30, 60])
def test_obliqueIn2D(tmp_path, table, degrees):
    (found, case), = reflections(tmp_path, oblique(60, degrees, 0), ["far"])
    table.add(f"pulse at far field, {degrees} degrees, 2D", "60 cells",
              "largest part sent back", found, "0", OTHER_ANGLES,
              seconds=case.seconds)
    assert found <= OTHER_ANGLES


def test_intoACorner(tmp_path, table):
    (found, case), = reflections(
        tmp_path, corner(50), ["far"],
        others={"left": "wall", "bottom": "wall", "top": "far"})
    table.add("round pulse at two far fields", "50^2",
              "largest part sent back", found, "0", CORNER,
              seconds=case.seconds)
    assert found <= CORNER
