"""What a user reads whose fields do not fit the mesh."""
import pytest

from gasBox import GasBox


@pytest.fixture
def case(tmp_path):
    box = GasBox(tmp_path / "case", (1,), (10,))
    box.start(1.0, (0, 0, 0), 1.0)
    return box


def fails(case, *expected):
    assert case.runTo(0.01) != 0
    for word in expected:
        assert word in case.log, case.log[-1500:]


def test_farFieldForOneFieldOnly(case):
    case.set("0/p", "boundaryField/ends", "{ type farField; value uniform 1; }")
    fails(case, "Patch ends", "farField for p", "zeroGradient for U", "all three")


def test_patchThatIsNotThere(case):
    """U names the patches one by one; ends is misspelled."""
    text = (case.path / "0/U").read_text()
    (case.path / "0/U").write_text(text.replace("ends", "edns"))
    fails(case, "ends", "/0/U", "line")


def test_farFieldWithoutItsState(case):
    for name in "pUT":
        case.set(f"0/{name}", "boundaryField/ends", "{ type farField; }")
    fails(case, "value", "boundaryField", "line")


def test_unknownTypeNamesTheValidOnes(case):
    case.set("0/p", "boundaryField/ends", "{ type fixedValeu; }")
    fails(case, "fixedValeu", "fixedValue", "farField", "/0/p")


def farFields(case, waves, field="p"):
    """farField for all, with the entries of waves in one of the fields."""
    for name, value in (("p", "1"), ("U", "(0 0 0)"), ("T", "1")):
        entries = waves if name == field else ""
        case.set(f"0/{name}", "boundaryField/ends",
                 f"{{ type farField; value uniform {value}; {entries} }}")


@pytest.mark.parametrize("waves, field, expected", [
    ("waves round; origin (0 0 0);", "p", ["round", "spherical", "plane"]),
    ("waves spherical;", "p", ["origin", "/0/p"]),
    ("waves spherical; origin (3 0 0);", "U", ["entry of p", "/0/U"]),
    ("waves spherical; origin (3 0 0);", "T", ["belongs to p", "/0/T"]),
    # A line without curvature has plane waves only
    ("waves spherical; origin (3 0 0);", "p", ["ends", "1 dimension"]),
])
def test_curvedWaves(case, waves, field, expected):
    farFields(case, waves, field)
    fails(case, *expected)
