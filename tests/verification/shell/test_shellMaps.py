"""The function object shellMaps, and stresses of shellProbes: peaks over time
against histories at points, in the VTK series, over restarts."""
import csv
import re
from pathlib import Path

import numpy as np
import pytest

from foamCase import FoamCase, RunFailed
from shellFiles import readGrid

HERE = Path(__file__).resolve().parent
# Nodes: at the root, on an edge between two elements, the tip
POINTS = ((0, 0, 0), (5, 0, 0), (10, 0, 0))
FIELDS = ("peakDisplacement", "peakStrain", "peakVonMises")
FUNCTIONS = """
    maps
    {
        type shellMaps; libs (shockShellFunctionObjects);
        writeControl writeTime;
    }
    places
    {
        type shellProbes; libs (shockShellFunctionObjects);
        points (%s);
        fields (displacement stress strain vonMises sectionForces);
        writePrecision 15;
    }
    tip""" % " ".join("(%g %g %g)" % p for p in POINTS)


def strip(folder, functions=FUNCTIONS, end="0.36"):
    case = FoamCase(HERE / "cases" / "dynamicStrip", folder)
    path = case.path / "system" / "controlDict"
    path.write_text(path.read_text().replace("    tip", functions, 1))
    case.set("system/controlDict", "endTime", end)
    case.set("system/controlDict", "deltaT", "0.006")
    case.set("system/controlDict", "writeInterval", "30")
    case.run("blockShell")
    return case


@pytest.fixture(scope="module")
def swung(tmp_path_factory):
    """The strip under a sudden load, past its largest deflection."""
    case = strip(tmp_path_factory.mktemp("maps") / "swung")
    case.run("positionalShellFoam")
    return case


def grid(case, index=60):
    return readGrid(case.path / "VTK" / "maps" / f"maps_{index}.vtu")


def column(case, field):
    """History of one field at the points: (times, values [step, point, k])"""
    _, rows = case.history(f"places/0/{field}.dat")
    return rows[:, 0], rows[:, 1:].reshape(len(rows), len(POINTS), -1)


def principal(t):
    """Largest principal value of xx yy zz xy yz xz."""
    xx, yy, zz, xy, yz, xz = np.moveaxis(t, -1, 0)
    matrix = np.stack([xx, xy, xz, xy, yy, yz, xz, yz, zz], -1)
    return np.linalg.eigvalsh(matrix.reshape(t.shape[:-1] + (3, 3)))[..., -1]


def histories(case):
    times, u = column(case, "displacement")
    strain = np.maximum(*(principal(column(case, f"strain{side}")[1])
                          for side in ("Lower", "Upper")))
    vonMises = np.max([column(case, f"vonMises{h}")[1][..., 0]
                       for h in ("Lower", "Middle", "Upper")], axis=0)
    return times, (np.linalg.norm(u, axis=2), strain, vonMises)


def test_peaksAreThoseOfTheHistories(swung):
    points, _, data = grid(swung)
    initial = points - data["displacement"]
    times, values = histories(swung)
    for name, history in zip(FIELDS, values):
        for i, place in enumerate(POINTS):
            node = np.argmin(abs(initial - place).sum(axis=1))
            # VTK has the places in single precision
            assert abs(initial[node] - place).max() < 1e-5
            peak = history[:, i].max()
            if name == "peakDisplacement" and i == 0:
                assert data[name][node] < 1e-12
                continue
            assert data[name][node] == pytest.approx(peak, rel=1e-9), name
            assert data[name + "Time"][node] == pytest.approx(
                times[history[:, i].argmax()], rel=1e-9)
    # Peaks at different times: waves run along the strip. It swings back
    assert len(np.unique(data["peakVonMisesTime"])) > 3
    assert data["peakDisplacementTime"].max() < 0.35


def test_stressesOfProbesGoTogether(swung):
    """At the upper face: stress, strain and section forces of a strip."""
    _, stress = column(swung, "stressUpper")
    _, vonMises = column(swung, "vonMisesUpper")
    _, strain = column(swung, "strainUpper")
    # nu = 0: the stress along the strip alone
    axial = principal(np.concatenate([stress, -stress], axis=1))
    largest = np.maximum(axial[:, :3], axial[:, 3:])
    at = abs(vonMises[:, 1, 0]) > 0.1*vonMises[:, 1, 0].max()
    assert np.allclose(vonMises[at, 1, 0], largest[at, 1], rtol=0.02)
    assert np.allclose(stress[at, 0, 0], 1.2e6*strain[at, 0, 0], rtol=0.03)
    names, rows = swung.history("places/0/bendingMoment.dat")
    assert names[1:6] == ["bendingMoment_11_0", "bendingMoment_22_0",
                          "bendingMoment_12_0", "bendingMoment_21_0",
                          "bendingMoment_11_1"]
    # sigma = M h/2/(h^3/12) at the root, but for the membrane's part
    moment = rows[at, 1]
    assert np.allclose(stress[at, 0, 0], 600*moment,
                       atol=0.05*abs(600*moment).max())
    assert (swung.path / "postProcessing/places/0/shearForce.dat").exists()


def test_summaryHasTheLargest(swung):
    with open(swung.path / "postProcessing/maps/0/shellMaps.csv") as stream:
        rows = [row for row in csv.DictReader(stream)]
    last = {row["field"]: row for row in rows if row["time [s]"] == "0.36"}
    assert set(last) == set(FIELDS) and len(rows) == 6
    points, _, data = grid(swung)
    for name in FIELDS:
        most = data[name].argmax()
        assert float(last[name]["peak"]) == pytest.approx(
            data[name][most], rel=1e-9)
        assert float(last[name]["x [m]"]) == pytest.approx(
            (points - data["displacement"])[most, 0], abs=1e-5)
        assert float(last[name]["at [s]"]) == pytest.approx(
            data[name + "Time"][most], rel=1e-9)


def test_restartGoesOn(swung, tmp_path):
    case = strip(tmp_path / "parts", end="0.18")
    case.run("positionalShellFoam")
    case.set("system/controlDict", "endTime", "0.36")
    assert "goes on with the peaks" in case.run("positionalShellFoam")
    _, _, wanted = grid(swung)
    _, _, found = grid(case)
    for name in FIELDS:
        assert (found[name] == wanted[name]).all(), name
        # The clock of a run that restarts differs in the last digit
        assert np.allclose(found[name + "Time"], wanted[name + "Time"],
                           rtol=1e-12)
    series = (case.path / "VTK" / "maps.pvd").read_text()
    assert len(re.findall("<DataSet", series)) == 2

    # Another mesh
    path = case.path / "0.36" / "shell" / "maps"
    path.write_text(path.read_text().replace(
        re.search(r"\n(\d+)\n\(", path.read_text()).group(0), "\n2\n(", 1))
    path.write_text(re.sub(r"\n2\n\(.*\)", "\n2\n(\n1\n2\n)",
                           path.read_text(), flags=re.S))
    case.set("system/controlDict", "endTime", "0.42")
    with pytest.raises(RunFailed, match="holds 2 values, but the shell has"):
        case.run("positionalShellFoam")


def test_unknownFieldOfAProbe(tmp_path):
    case = strip(tmp_path / "wrong", FUNCTIONS.replace("vonMises", "mises"))
    with pytest.raises(RunFailed, match=r"Unknown field mises[\s\S]*"
                       r"acceleration[\s\S]*sectionForces"):
        case.run("positionalShellFoam")
