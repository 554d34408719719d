"""Stresses in the VTK series, energies and reactions as tables."""
from pathlib import Path

import numpy as np
import pytest

from foamCase import FoamCase
from shellFiles import readGrid

HERE = Path(__file__).resolve().parent
TABLES = """
    energies { type shellEnergyTable; libs (shockShellFunctionObjects); }
    reactions
    {
        type shellReactionTable; libs (shockShellFunctionObjects);
        CofR (0 0.5 0);
    }
    tip"""
HEIGHTS = ("Lower", "Middle", "Upper")
LENGTH, WIDTH, H, LOAD = 10, 1, 0.1, 0.4


def replace(path, *pairs):
    text = path.read_text()
    for old, new in pairs:
        assert old in text
        text = text.replace(old, new)
    path.write_text(text)


def strip(folder, results=""):
    """The strip of the dynamic tests; with tables."""
    case = FoamCase(HERE / "cases" / "dynamicStrip", folder)
    case.run("blockShell")
    replace(case.path / "system" / "controlDict", ("    tip", TABLES))
    path = case.path / "constant" / "shellProperties"
    path.write_text(path.read_text() + results)
    return case


@pytest.fixture(scope="module")
def bent(tmp_path_factory):
    """The strip under a small uniform load, in statics: a beam."""
    case = strip(
        tmp_path_factory.mktemp("results") / "bent",
        "results { fields (stress strain secondPiola vonMises"
        " sectionForces); }")
    replace(case.path / "constant" / "shellProperties",
            ("analysis        dynamic;\ntimeIntegrator  Newmark;",
             "analysis static;"), ("(0 0 0.4)", "(0 0 4e-3)"))
    for entry, value in (("endTime", "1"), ("deltaT", "1"),
                         ("writeInterval", "1")):
        case.set("system/controlDict", entry, value)
    case.log = case.run("positionalShellFoam")
    return case


def test_stresses_and_section_forces_of_a_beam(bent):
    """q = 4e-3 per area: M = q (L - x)^2/2 with the lower face in tension,
    Q = q (L - x), stress M h/2 / (h^3/12)."""
    points, _, data = readGrid(bent.path / "VTK" / "shell" / "shell_1.vtu")
    x = points[:, 0]
    M = 0.5*4e-3*(LENGTH - x)**2
    # Away from the layer at the clamp
    inside = x > 1
    scale = M.max()
    assert abs(data["bendingMoment"][:, 0] + M)[inside].max() < 0.01*scale
    assert abs(abs(data["shearForce"][:, 0]) - 4e-3*(LENGTH - x))[
        inside].max() < 0.02*4e-3*LENGTH
    stress = 6/H**2*scale
    for height, sign in zip(HEIGHTS, (1, 0, -1)):
        for field in ("stress", "secondPiola"):
            found = data[field + height][:, 0]
            assert abs(found - sign*6/H**2*M)[inside].max() < 0.015*stress
        assert data["stress" + height].shape == (len(x), 6)
        assert data["stress" + height].dtype == np.float64
        found = data["vonMises" + height]
        assert abs(found - abs(sign)*6/H**2*M)[inside].max() < 0.015*stress
        found = data["strain" + height][:, 0]
        assert abs(found - sign*6/H**2*M/1.2e6)[inside].max() \
            < 0.015*stress/1.2e6
    np.testing.assert_allclose(data["sectionAxis1"][:, 0], 1, rtol=1e-3)


def test_reactions_equal_the_loads(bent):
    names, root = bent.history("reactions/0/root.dat")
    assert names[1:] == [
        f"{q}_{axis}" for q in ("force", "moment") for axis in "xyz"]
    force = 4e-3*LENGTH*WIDTH
    np.testing.assert_allclose(root[-1, 1:4], [0, 0, -force], atol=1e-7*force)
    # About the middle of the root. In plane strain the forces between the
    # nodes across, which are not reported, carry moments about x and z
    tip = 0.5*force*LENGTH
    assert abs(root[-1, 5] - tip) < 1e-3*tip
    _, total = bent.history("reactions/0/total.dat")
    np.testing.assert_allclose(total[-1, 1:4], root[-1, 1:4],
                               atol=1e-7*force)
    assert "Shell: reaction = (" in bent.log


def test_tables_continue_after_a_restart(tmp_path):
    whole = strip(tmp_path / "whole", "results { fields (); }")
    whole.set("system/controlDict", "endTime", "0.04")
    whole.set("system/controlDict", "writeInterval", "10")
    log = whole.run("positionalShellFoam")
    parts = strip(tmp_path / "parts")
    parts.set("system/controlDict", "writeInterval", "10")
    for end in ("0.02", "0.04"):
        parts.set("system/controlDict", "endTime", end)
        parts.run("positionalShellFoam", log=f"log.{end}")

    for table in ("energies/%s/energies.dat", "reactions/%s/root.dat"):
        names, rows = whole.history(table % "0")
        _, first = parts.history(table % "0")
        _, second = parts.history(table % "0.02")
        assert len(first) == len(second) == 10
        np.testing.assert_allclose(
            np.vstack((first, second)), rows, rtol=1e-9,
            atol=1e-9*abs(rows).max())

    names, rows = whole.history("energies/0/energies.dat")
    end = dict(zip(names, rows[-1]))
    assert end["externalWork"] > 1e-3
    for name, column in (("strain", "strain"), ("kinetic", "kinetic"),
                         ("external work", "externalWork")):
        text = log.split("Shell energies [J]")[1].split(name)[1]
        assert abs(float(text.split()[0])/end[column] - 1) < 1e-5
    # kinetic + strain = works, within the error of the trapezoidal rule
    assert abs(end["mismatch"]) < 1e-4*end["externalWork"]
    balance = end["kinetic"] + end["strain"] - end["externalWork"] \
        - end["supportWork"] + end["dissipated"]
    assert abs(balance - end["mismatch"]) < 1e-8*end["externalWork"]

    # No fields, and the default ones
    _, _, data = readGrid(whole.path / "VTK" / "shell" / "shell_20.vtu")
    assert set(data) == {"displacement", "velocity", "director", "thickness"}
    _, _, data = readGrid(parts.path / "VTK" / "shell" / "shell_20.vtu")
    assert {"stressLower", "vonMisesUpper", "bendingMoment"} <= set(data)
    assert "strainLower" not in data


def test_an_unknown_field_is_named(tmp_path):
    case = strip(tmp_path / "strip", "results { fields (stresses); }")
    log = case.run("positionalShellFoam", check=False)
    assert case.exitCode != 0
    assert "Unknown field stresses" in log
    assert "(strain secondPiola stress vonMises sectionForces)" in log
    assert "shellProperties.results" in log
