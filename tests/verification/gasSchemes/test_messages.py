"""What a user reads who mistypes something in a gas case."""
import pytest

from gasBox import GasBox


@pytest.fixture
def case(tmp_path):
    box = GasBox(tmp_path / "case", (1,), (10,))
    box.start(1.0, (0, 0, 0), 1.0)
    return box


@pytest.mark.parametrize("schemes, expected", [
    ("timeScheme fourStep; shockCapturing none;",
     ["feSchemes", "fourStep", "twoStep", "threeStep"]),
    ("timeScheme twoStep; shockCapturing some;",
     ["feSchemes", "some", "none", "pressureLaplacian"]),
    ("timeScheme twoStep; shockCapturing none; massMatrx lumped;",
     ["feSchemes", "massMatrx", "line", "timeScheme"]),
    ("timeScheme twoStep; twoStepCoeffs { massMatrx lumped; }"
     " shockCapturing none;",
     ["feSchemes", "massMatrx", "line", "massMatrix"]),
    ("timeScheme threeStep; threeStepCoeffs { theta 2; }"
     " shockCapturing none;",
     ["feSchemes", "theta", "0.5"]),
    ("shockCapturing none;", ["feSchemes", "timeScheme"]),
])
def test_feSchemes(case, schemes, expected):
    case.schemes(schemes)
    assert case.runTo(0.01) != 0
    for word in expected:
        assert word in case.log


@pytest.mark.parametrize("file, entry, value, expected", [
    ("0/p", "boundaryField/ends",
     "{ type farField; value uniform 1; }", ["ends", "farField", "zeroGradient"]),
    ("0/U", "boundaryField/ends", "{ type slipp; }", ["slipp", "slip"]),
    ("0/T", "internalField", "uniform -1", ["not physical", "T"]),
    ("constant/thermophysicalProperties", "mixture/transport/mu", "-1e-5",
     ["thermophysicalProperties", "mu", "positive or zero"]),
    ("constant/thermophysicalProperties", "thermoType/equationOfState",
     "rhoConst", ["thermophysicalProperties", "rhoConst", "perfectGas"]),
    ("system/controlDict", "maxCo", "2", ["controlDict", "maxCo", "(0, 1]"]),
])
def test_otherFiles(case, file, entry, value, expected):
    case.set(file, entry, value)
    assert case.runTo(0.01) != 0
    for word in expected:
        assert word in case.log, case.log[-1500:]


@pytest.mark.parametrize("file", [
    "0/T", "system/feSchemes", "constant/thermophysicalProperties",
])
def test_missingFile(case, file):
    (case.path / file).unlink()
    assert case.runTo(0.01) != 0
    assert file.split("/")[1] in case.log


def test_unphysicalStateStopsWithPlaceAndAdvice(tmp_path):
    """Artificial viscosity off at a strong shock: stopped, not repaired, and
    the last good state is on disk."""
    case = GasBox(tmp_path / "case", (1,), (100,))
    left = case.x[:, 0] < 0.5 + 1e-9
    case.start(1.0, (0, 0, 0), [1000.0 if i else 0.01 for i in left])
    assert case.runTo(0.01) != 0
    for word in ("node", "Pa", "time", "maxCo", "fluxCorrected", "state before"):
        assert word in case.log
    assert case.result("p").min() > 0


def test_setPointFields(case):
    values = case.path / "system" / "setPointFieldsDict"
    head = (case.path / "system/controlDict").read_text().split("// * *")[0]
    head = head.replace("controlDict", "setPointFieldsDict")
    text = """
    defaultFieldValues ( pointScalarFieldValue p 3 );
    regions
    (
        %s
        {
            box (0.45 -1 -1) (2 2 2);
            fieldValues
            (
                pointScalarFieldValue p 5
                pointVectorFieldValue U (1 2 3)
            );
        }
    );
    """
    values.write_text(head + text % "boxToPoint")
    case.run("setPointFields")
    p, U = case.pointField("p", "0"), case.pointField("U", "0")
    right = case.x[:, 0] > 0.45
    assert (p[right] == 5).all() and (p[~right] == 3).all()
    assert (U[right] == (1, 2, 3)).all() and (U[~right] == 0).all()

    values.write_text(head + text % "boxToFace")
    log = case.run("setPointFields", check=False)
    assert case.exitCode != 0
    assert "boxToFace" in log and "boxToPoint" in log
