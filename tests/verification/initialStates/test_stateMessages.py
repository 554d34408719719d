"""What a user reads who mistypes something in system/setPointFieldsDict."""
import pytest

from statesBox import HEAD, StatesBox

LINE = HEAD.count("\n") + 1

SHOCK = "machNumber 2; point (0 0 0); normal (1 0 0);"


@pytest.fixture(scope="module")
def case(tmp_path_factory):
    return StatesBox(tmp_path_factory.mktemp("states") / "case", (1, 1),
                     (5, 5))


@pytest.mark.parametrize("entries, line, expected", [
    ("state ();", 0, ["state", "defaultFieldValues", "regions", "states"]),
    ("defaultFieldValues ( volScalarFieldValue p 1 );", 0,
     ["volScalarFieldValue", "pointScalarFieldValue",
      "pointVectorFieldValue"]),
    ("defaultFieldValues ( pointScalarFieldValue q 1 );", None, ["0/q"]),
    ("regions ( boxToPint { box (0 0 0) (1 1 1); } );", 0,
     ["boxToPint", "boxToPoint", "cylinderToPoint"]),
    ("regions ( boxToFace { box (0 0 0) (1 1 1); } );", 0,
     ["boxToFace", "boxToPoint", "boxToCell"]),
    ("regions ( boxToPoint { bx (0 0 0) (1 1 1); } );", 0, ["box"]),
    ("regions\n(\n boxToPoint\n {\n box (0 0 0) (1 1 1);\n }\n);", 4,
     ["fieldValues"]),
    ("states ( sphericalCharg { centre (0 0 0); } );", 0,
     ["sphericalCharg", "sphericalCharge", "planarShock", "mappedProfile"]),
    ("states\n(\n planarShock\n {\n " + SHOCK + "\n ahead { p 1; T 1; }\n"
     " mach 3;\n }\n);", 6, ["mach", "machNumber", "normal"]),
    ("states ( planarShock { " + SHOCK + " ahead { p -2; T 1; } } );", 0,
     ["p is -2"]),
    ("states ( planarShock { machNumber 0.5; point (0 0 0); "
     "normal (1 0 0); ahead { p 1; T 1; } } );", 0, ["machNumber", "0.5"]),
    ("states ( sphericalCharge { centre (0 0 0); radius 1; p 1; } );", 0,
     ["'T' not found"]),
    ("states ( mappedProfile { geometry cylindrical; centre (0 0 0);\n"
     "file \"$FOAM_CASE/nothing\"; } );", 1, ["no file", "nothing"]),
])
def test_dictionary(case, entries, line, expected):
    log = case.setPointFields(entries, check=False)
    assert case.exitCode != 0
    for word in expected:
        assert word in log, log[-1500:]
    if line is not None:
        assert "setPointFieldsDict" in log
        assert f"line {LINE + line}" in log, log[-1500:]


def test_missingProperties(tmp_path):
    case = StatesBox(tmp_path / "case", (1,), (5,))
    (case.path / "constant" / "thermophysicalProperties").unlink()
    charge = "states ( sphericalCharge { centre (0 0 0); radius 1; } );"
    log = case.setPointFields(charge, check=False)
    assert case.exitCode != 0 and "thermophysicalProperties" in log


def test_otherGas(tmp_path):
    """A profile from a case with another gas would not keep mass and energy."""
    source = StatesBox(tmp_path / "source", (1,), (5,))
    source.set("constant/thermophysicalProperties",
               "mixture/thermodynamics/Cp", "1100")
    case = StatesBox(tmp_path / "case", (1,), (5,))
    log = case.setPointFields(
        "states ( mappedProfile { geometry planar; centre (0 0 0);"
        " axis (1 0 0); case \"$FOAM_CASE/../source\"; } );", check=False)
    assert case.exitCode != 0
    assert "equal gases" in log and "1100" in log


def test_profileInOtherUnits(tmp_path):
    """kPa in place of Pa: the end of the profile gives it away."""
    case = StatesBox(tmp_path / "case", (1, 1), (20, 20))
    (case.path / "table").write_text("0 3 0 300\n0.4 1.2 0 100\n")
    log = case.setPointFields(
        "states ( mappedProfile { geometry cylindrical; centre (0 0 0);"
        " file \"$FOAM_CASE/table\"; } );")
    assert "Warning" in log and "p = 100 Pa" in log and "units" in log


def test_missingDictionary(tmp_path):
    case = StatesBox(tmp_path / "case", (1,), (5,))
    log = case.run("setPointFields", check=False)
    assert case.exitCode != 0 and "setPointFieldsDict" in log
