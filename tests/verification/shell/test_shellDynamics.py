"""Clamped strip under a sudden load, large displacements, and its restart."""
from pathlib import Path

import numpy as np
import pytest

from foamCase import FoamCase
from shellFiles import readGrid, readSeries, readState

HERE = Path(__file__).resolve().parent
TRACTION = "type        traction;\n        traction    (0 0 0.4);"
PRESSURE = "type followerPressure; pressure -0.4;"


def strip(folder):
    case = FoamCase(HERE / "cases" / "dynamicStrip", folder)
    case.run("blockShell")
    return case


def readTable(name):
    lines = (HERE / "reference" / name).read_text().splitlines()
    lines = [line for line in lines if not line.startswith("#")]
    return np.genfromtxt(lines, delimiter=",", names=True)


def setEntry(case, old, new):
    """Replace text of shellProperties that is there."""
    path = case.path / "constant" / "shellProperties"
    text = path.read_text()
    assert old in text
    path.write_text(text.replace(old, new))


@pytest.mark.parametrize("load,integrator", [
    ("dead", "Newmark"), ("follower", "Newmark"),
    ("dead", "generalisedAlpha"), ("follower", "energyMomentum"),
])
def test_strip_moves_as_a_geometrically_exact_beam(tmp_path, load, integrator):
    """Tip within 0.5 % of the greatest deflection at every time up to the
    first peak and beyond."""
    case = strip(tmp_path / "strip")
    setEntry(case, "Newmark;", f"{integrator};")
    if load == "follower":
        path = case.path / "constant" / "shellProperties"
        text = path.read_text()
        assert TRACTION in text
        path.write_text(text.replace(TRACTION, PRESSURE))
    case.run("positionalShellFoam")

    names, rows = case.history("tip/0/displacement.dat")
    table = readTable(f"dyn_D1_strip_{load}_beam2d.csv")
    table = table[table["t"] <= rows[-1, 0]]
    for column, reference in (
        ("displacement_x", "u_tip"), ("displacement_z", "w_tip"),
    ):
        computed = np.interp(
            table["t"], np.insert(rows[:, 0], 0, 0),
            np.insert(rows[:, names.index(column)], 0, 0),
        )
        assert abs(computed - table[reference]).max() <= 0.005*7.3


def test_restart_continues_as_if_it_had_not_stopped(tmp_path):
    whole = strip(tmp_path / "whole")
    whole.run("positionalShellFoam")

    parts = strip(tmp_path / "parts")
    parts.set("system/controlDict", "endTime", "0.2")
    parts.run("positionalShellFoam", log="log.first")
    parts.set("system/controlDict", "endTime", "0.3")
    log = parts.run("positionalShellFoam", log="log.second")
    assert "continues from the state in 0.2/shell" in log

    # The state, and with it the forces that made it
    one, two = readState(whole, "0.3"), readState(parts, "0.3")
    for name, values in one.items():
        np.testing.assert_array_equal(values, two[name], err_msg=name)

    # The history, to the last digit written
    _, rows = whole.history("tip/0/displacement.dat")
    _, first = parts.history("tip/0/displacement.dat")
    _, second = parts.history("tip/0.2/displacement.dat")
    assert first[-1, 0] < second[0, 0]
    np.testing.assert_allclose(
        np.vstack((first, second)), rows, rtol=1e-12, atol=1e-13
    )

    # The account of energies goes on, the VTK series too
    assert endReport(parts, "log.second") == endReport(whole)
    assert (
        readSeries(parts.path / "VTK" / "shell.pvd")
        == readSeries(whole.path / "VTK" / "shell.pvd")
    )


def test_steps_from_an_error_estimate_restart_as_if_not_stopped(tmp_path):
    """The length of the next step is part of the restart state."""
    runs = []
    for ends in (["0.1"], ["0.05", "0.1"]):
        case = strip(tmp_path / f"runs{len(ends)}")
        setEntry(case, "Newmark;", "generalisedAlpha;\nerrorTolerance 1e-5;")
        case.set("system/controlDict", "deltaT", "0.05")
        case.set("system/controlDict", "writeInterval", "1")
        for end in ends:
            case.set("system/controlDict", "endTime", end)
            log = case.run("positionalShellFoam", log=f"log.{end}")
        assert "Shell: taken in" in log
        runs.append(readState(case, "0.1"))
    for name, values in runs[0].items():
        np.testing.assert_array_equal(values, runs[1][name], err_msg=name)


def test_path_by_arc_length(tmp_path):
    """Published end shear (source: Sze, Liu and Lo 2004, 3.1: elastica, tip
    at W = 6.700, U = 3.289 for the load 4) as a path; its restart."""
    runs = []
    for ends in (["6"], ["2.5", "6"]):
        case = strip(tmp_path / f"runs{len(ends)}")
        setEntry(case, TRACTION, "type edge; nodeSet tip;\n"
                 "        forcePerLength (0 0 4);"
                 " factor polynomial ((0.1 1));")
        setEntry(case, "analysis        dynamic;\ntimeIntegrator  Newmark;",
                 "analysis static;\nstaticMethod arcLength;\n"
                 "arcLengthCoeffs { maxGrowth 1; }")
        case.set("system/controlDict", "deltaT", "0.5")
        case.set("system/controlDict", "writeInterval", "1")
        for end in ends:
            case.set("system/controlDict", "endTime", end)
            log = case.run("positionalShellFoam", log=f"log.{end}")
        runs.append((case, log, readState(case, "6")))
    for name, values in runs[0][2].items():
        np.testing.assert_array_equal(values, runs[1][2][name], err_msg=name)

    case, log, _ = runs[0]
    loads = [
        0.1*float(line.split("=")[1]) for line in log.splitlines()
        if "load parameter =" in line
    ]
    names, rows = case.history("tip/0/displacement.dat")
    assert len(loads) == len(rows) == 12 and loads[-1] > 1
    # Cubic through the four points next to the published load
    near = np.argsort(abs(np.array(loads) - 1))[:4]
    u, w = (
        np.polyval(np.polyfit(np.array(loads)[near] - 1, values[near], 3), 0)
        for values in (
            rows[:, names.index("displacement_x")],
            rows[:, names.index("displacement_z")],
        )
    )
    assert abs(w - 6.700) < 0.01*6.700
    assert abs(-u - 3.289) < 0.01*3.289


def test_frequencies_and_modes(tmp_path):
    """Clamped beam: roots 1.8751 and 4.6941 of cos x cosh x = -1."""
    case = strip(tmp_path / "strip")
    log = case.run("positionalShellFoam", "-modes", "2")
    lines = log.split("Shell frequencies [Hz]")[1].splitlines()[1:3]
    found = [float(line.split()[1]) for line in lines]
    wave = (1.2e6*0.1**2/12/0.01)**0.5/10**2/(2*np.pi)
    for frequency, root in zip(found, (1.87510, 4.69409)):
        assert abs(frequency/(wave*root**2) - 1) < 3e-3

    # The first mode bends to one side, the second has one node
    for number, file in readSeries(case.path / "VTK" / "modes.pvd"):
        points, _, data = readGrid(case.path / "VTK" / file)
        w = data["displacement"][:, 2][np.argsort(points[:, 0])]
        w = w[abs(w) > 1e-3*abs(w).max()]
        assert (np.diff(np.sign(w)) != 0).sum() == number - 1


def endReport(case, log="log.positionalShellFoam"):
    """Energies at the end, as printed; not the mismatch: that is round-off
    and the error of the trapezoidal rule."""
    text = (case.path / log).read_text().split("Shell energies [J]")[1]
    return text.split("mismatch")[0]


def test_restart_with_another_mesh_is_an_error(tmp_path):
    case = strip(tmp_path / "strip")
    case.set("system/controlDict", "endTime", "0.1")
    case.run("positionalShellFoam")
    case.set("system/blockShellDict", "divisions", "(4 1)")
    case.run("blockShell")
    log = case.run("positionalShellFoam", check=False)
    assert case.exitCode != 0
    assert '0.1/shell/position" holds 100 values' in log
    assert "the shell mesh has 52 nodes" in log
