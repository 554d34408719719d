"""What is wrong in a case is named with file, lines and the valid choices."""
from pathlib import Path

import pytest

from foamCase import FoamCase

CASE = Path(__file__).resolve().parent / "cases" / "dynamicStrip"


@pytest.fixture(scope="module")
def meshed(tmp_path_factory):
    case = FoamCase(CASE, tmp_path_factory.mktemp("messages") / "strip")
    case.run("blockShell")
    return case


def failure(meshed, folder, file, old, new, program="positionalShellFoam"):
    case = FoamCase(meshed.path, folder)
    path = case.path / file
    text = path.read_text()
    assert old in text
    path.write_text(text.replace(old, new, 1))
    log = case.run(program, check=False, timeout=60)
    assert case.exitCode not in (0, None)
    return " ".join(log.split("FOAM FATAL")[1].split())


def line(file, text):
    """Number of the line of the case's file that holds the text."""
    lines = (CASE / file).read_text().splitlines()
    return next(i for i, line in enumerate(lines, 1) if text in line)


@pytest.mark.parametrize("old, new, expected", [
    ("thickness   0.1;", "thicknes    0.1;",
     ["Unknown keyword thicknes", "elementSet thickness material"]),
    ("thickness   0.1;", "thickness   -0.1;", ["must be positive"]),
    ("thickness   0.1;", "", ["thickness", "not found"]),
    ("thickness   0.1;", "thickness 0.1; elementSet panel;",
     ["panel", "all"]),
    ("type    SaintVenantKirchhoff;", "type    Rubber;",
     ["unknown material Rubber", "SaintVenantKirchhoff"]),
    ("nu      0;", "", ["nu is missing", "E nu rho"]),
    ("nu      0;", "nu 0; G 1;", ["unknown parameter G", "E nu rho"]),
    ("nu      0;", "nu 0.5;", ["0.5"]),
    ("nu      0;", "nu 0; axis (1 0 0);",
     ["the same in all directions", "axis"]),
    ("type    SaintVenantKirchhoff;", "type orthotropic;",
     ["parameter E1 is missing", "nu12", "G13"]),
    ("type        clamped;", "type        clampd;",
     ["Unknown type clampd", "clamped", "hinged", "planeStrainStrip"]),
    ("nodeSet     root;", "nodeSet     foot;",
     ["foot", "root", "tip", "uMin"]),
    ("direction   (0 1 0);", "direction   (0 1 1);",
     ["(0 1 1) is not along a coordinate axis", "(0 0 1)"]),
    ("type        traction;", "type        wind;",
     ["Unknown type wind", "followerPressure", "gravity"]),
    ("traction    (0 0 0.4);", "traction (0 0 1); factr 2;",
     ["Unknown keyword factr", "elementSet traction type factor"]),
    ("traction    (0 0 0.4);", "traction (0 0 1); factor ramp;",
     ["Unknown Function1 type ramp", "polynomial"]),
    ("type        traction;\n        traction    (0 0 0.4);",
     "type blastWave; centre (5 0 5); referenceDistance 5; peak 1;\n"
     "arrival 0; speed 400; duration -1; decay 1;",
     ["blast wave: duration", "not positive"]),
    ("type        traction;\n        traction    (0 0 0.4);",
     "type kingeryBulmash; mass 1; position (5 0 90); burst freeAir;\n"
     "face upper;",
     ["scaled distance", "0.147 to 40"]),
    ("type        traction;\n        traction    (0 0 0.4);",
     "type kingeryBulmash; mass 1; position (5 0 9); burst ground;\n"
     "face upper;",
     ["Unknown burst ground", "freeAir surface"]),
    ("analysis        dynamic;", "analysis        dynamical;",
     ["Unknown analysis dynamical", "dynamic static"]),
    ("analysis        dynamic;", "elementForm strain;",
     ["Unknown elementForm strain", "displacement assumedStrain"]),
    ("timeIntegrator  Newmark;", "timeIntegrator  Euler;",
     ["Unknown", "Euler", "Newmark"]),
    ("timeIntegrator  Newmark;", "timeIntegrator  loadSteps;",
     ["loadSteps is for statics"]),
    ("timeIntegrator  Newmark;",
     "timeIntegrator  Newmark; NewmarkCoeffs { gamma 0.4; }",
     ["gamma", "less than 1/2"]),
    ("timeIntegrator  Newmark;",
     "timeIntegrator generalisedAlpha;"
     " generalisedAlphaCoeffs { spectralRadius 2; }",
     ["spectralRadius 2", "between 0 and 1"]),
    ("timeIntegrator  Newmark;",
     "timeIntegrator  Newmark; errorTolerance -1;",
     ["errorTolerance", "negative"]),
    ("timeIntegrator  Newmark;",
     "timeIntegrator  Newmark; newton { lineSearch sometimes; }",
     ["Unknown lineSearch sometimes", "off whenNeeded always"]),
    ("analysis        dynamic;", "analysis static; staticMethod Riks;",
     ["Unknown staticMethod", "Riks", "arcLength", "loadSteps"]),
    ("analysis        dynamic;", "analysis static; staticMethod Newmark;",
     ["Newmark is for dynamics", "select another"]),
    ("mesh            shell;", "mesh shell; meshes 2;",
     ["Unknown keyword meshes", "timeIntegrator"]),
    ("sections", "section", ["Unknown keyword section", "sections"]),
])
def test_shellProperties(meshed, tmp_path, old, new, expected):
    message = failure(
        meshed, tmp_path / "case", "constant/shellProperties", old, new
    )
    assert "constant/shellProperties" in message
    assert "line" in message
    for part in expected:
        assert part in message


def test_line_of_an_unknown_keyword(meshed, tmp_path):
    file = "constant/shellProperties"
    message = failure(
        meshed, tmp_path / "case", file, "thickness   0.1;", "thicknes 0.1;"
    )
    assert f"(line {line(file, 'thickness   0.1;')})" in message


def test_missing_mesh(tmp_path):
    case = FoamCase(CASE, tmp_path / "case")
    log = case.run("positionalShellFoam", check=False)
    assert case.exitCode != 0
    assert "No shell mesh" in log and "blockShell" in log


@pytest.mark.parametrize("old, new, expected", [
    ("points      ((10 0.5 0));", "points ((10 0.5 1));",
     ["Point (10 0.5 1) is 1 m away", "thickness of 0.1 m"]),
    ("(displacement velocity)", "(displacemnt)",
     ["Unknown field displacemnt", "position displacement velocity"]),
])
def test_shellProbes(meshed, tmp_path, old, new, expected):
    message = failure(
        meshed, tmp_path / "case", "system/controlDict", old, new
    )
    for part in ["system/controlDict", "line", *expected]:
        assert part in message


@pytest.mark.parametrize("old, new, expected", [
    ("type        plate;", "type        plane;", ["plane", "plate"]),
    ("divisions       (8 1);", "divisions       (8 0);",
     ["two positive numbers", "(8 0)"]),
    ("tip         uMax;", "tip         xMax;",
     ["xMax", "uMin", "uMax", "vMin"]),
    ("sideV       (0 1 0);", "sideV       (1 0 0);",
     ["do not span an area"]),
    ("divisions", "division", ["Unknown keyword division", "divisions"]),
])
def test_blockShellDict(meshed, tmp_path, old, new, expected):
    message = failure(
        meshed, tmp_path / "case", "system/blockShellDict", old, new,
        program="blockShell",
    )
    for part in ["system/blockShellDict", "line", *expected]:
        assert part in message


def test_divergence_leaves_the_last_good_state(meshed, tmp_path):
    case = FoamCase(meshed.path, tmp_path / "case")
    text = (case.path / "constant" / "shellProperties").read_text()
    (case.path / "constant" / "shellProperties").write_text(
        text.replace("traction    (0 0 0.4);",
                     "traction (0 0 0.4); factor table"
                     " ((0 1) (0.0199 1) (0.02 1e30));", 1)
    )
    log = case.run("positionalShellFoam", check=False)
    assert case.exitCode not in (0, None)
    assert "step from time 0.018 to 0.02 failed" in log
    assert "residual" in log and "Reduce deltaT" in log
    assert (case.path / "0.018" / "shell" / "position").is_file()


def test_failure_of_the_first_step_leaves_the_start_alone(meshed, tmp_path):
    message = failure(
        meshed, tmp_path / "case", "constant/shellProperties",
        "traction    (0 0 0.4);", "traction (0 0 1e30);"
    )
    assert "step from time 0 to 0.002 failed" in message
    assert not (tmp_path / "case" / "0").exists()


def test_a_step_that_fails_says_what_is_left(meshed, tmp_path):
    """One iteration a step, no cuts: the run stops at the first step that
    needs two, with the last good state written."""
    message = failure(
        meshed, tmp_path / "case", "constant/shellProperties",
        "timeIntegrator  Newmark;",
        "timeIntegrator  Newmark;\n"
        "newton { maxIterations 1; maxCuts 0; }",
    )
    assert "step from time" in message
    assert "no convergence in 1 iterations" in message
    assert "last good state is" in message
    assert "maxCuts" in message
