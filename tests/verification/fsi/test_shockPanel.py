"""The shock-tube panel, shortened to the first reflection at the panel."""
import re
import xml.etree.ElementTree as ET
from pathlib import Path

import numpy as np
import pytest

from foamCase import FoamCase

PROJECT = Path(__file__).resolve().parents[3]
CASES = PROJECT / "tutorials" / "fsi"

# Rankine-Hugoniot, Mach 1.21 into 1e5 Pa, gamma 1.4: behind the incident
# shock, and after normal reflection
P2 = 154145.0
P5 = 231614.5


def rows(case, name, file):
    """Table of postProcessing/<name>/0/<file>, time in the first column."""
    return case.history(f"{name}/0/{file}")[1]


def meshedCase(folder, name="shockPanel50"):
    case = FoamCase(CASES / name, folder)
    case.run("blockMesh")
    case.run("blockShell")
    case.run("setPointFields")
    return case


@pytest.fixture(scope="module")
def reflected(tmp_path_factory):
    """Run to just after the reflection, every shell step with one gas step."""
    case = meshedCase(tmp_path_factory.mktemp("panel") / "case")
    case.set("system/controlDict", "endTime", "9e-5")
    case.set("system/controlDict", "writeInterval", "9e-5")
    case.set("constant/couplingProperties", "subCycles", "1")
    # 0.5 mm in front of the panel, half way up
    case.set(
        "system/controlDict", "functions/topSensor/points",
        "((-0.0005 0.04 0) (-0.015 0.07 0))",
    )
    case.log = case.run("shockShellFoam")
    return case


def test_reflectedPressure(reflected):
    p = rows(reflected, "topSensor", "p.dat")
    front = p[(p[:, 0] > 65e-6) & (p[:, 0] < 85e-6)]
    assert len(front) > 10
    assert front[:, 1].mean() == pytest.approx(P5, rel=0.03)
    # The overshoot behind the shock has gone by the end of the plateau
    assert abs(front[-10:, 1] - P5).max() < 0.03 * P5


def test_incidentShock(reflected):
    """Pressure and arrival (415.17 m/s from x = -20 mm) at x = -15 mm."""
    p = rows(reflected, "topSensor", "p.dat")
    arrival = np.interp(0.5 * (1e5 + P2), p[:40, 2], p[:40, 0])
    assert arrival == pytest.approx(5e-3 / 415.17, abs=3e-6)
    behind = p[(p[:, 0] > 25e-6) & (p[:, 0] < 40e-6), 2]
    assert behind.mean() == pytest.approx(P2, rel=0.02)


def test_workBalanceCloses(reflected):
    """Without sub-cycling both sides do the same work, (C5) and (C7)."""
    table = rows(reflected, "interface", "balance.dat")
    forceGas, forceShell = table[:, 1:4], table[:, 4:7]
    workGas, workShell = table[-1, 10], table[-1, 11]
    assert workShell > 0
    assert abs(workGas - workShell) <= 1e-9 * workShell
    assert abs(forceGas - forceShell).max() <= 1e-12 * abs(forceGas).max()


def test_panelMovesDownstream(reflected):
    tip = rows(reflected, "panelTip", "displacement.dat")
    assert tip[-1, 1] > 0
    assert abs(tip[:, 3]).max() == 0  # plane strain
    assert "Figure of merit" in reflected.log


def test_vtkSeriesShowsTheMovingPanel(reflected):
    series = ET.parse(reflected.path / "VTK" / "shell.pvd").getroot()
    files = [s.get("file") for s in series.iter("DataSet")]
    assert len(files) == 2
    last = ET.parse(reflected.path / "VTK" / files[-1]).getroot()
    names = {a.get("Name") for a in last.iter("DataArray")}
    assert "displacement" in names


def test_foamToVTKWritesTheGas(reflected):
    reflected.run("foamToVTK", "-no-boundary", "-latestTime", "-name", "gasVTK")
    files = list((reflected.path / "gasVTK").glob("*/internal.vtu"))
    assert len(files) == 1
    content = files[0].read_bytes().decode("latin1")
    for field in ("p", "U", "T"):
        assert f"Name='{field}'" in content


def test_subCyclesAgreeWithoutAndSayTheMismatch(reflected, tmp_path):
    """Ten gas steps per shell step, mismatch told.

    The loads of a step's start act all through it, so the motion lags that
    of the finest steps, by one shell step at most.
    """
    case = meshedCase(tmp_path / "case")
    case.set("system/controlDict", "endTime", "9e-5")
    case.set("system/controlDict", "writeInterval", "9e-5")
    log = case.run("shockShellFoam")
    tip = rows(case, "panelTip", "displacement.dat")
    fine = rows(reflected, "panelTip", "displacement.dat")
    step = np.diff(tip[:, 0]).max()
    lagging = np.interp(tip[-1, 0] - step, fine[:, 0], fine[:, 1])
    assert lagging < tip[-1, 1] < fine[-1, 1]
    mismatch = float(re.findall(r"relative mismatch (\S+)", log)[-1])
    assert 1e-9 < mismatch < 0.05


# Errors: each names what is wrong and what would be right

@pytest.fixture(scope="module")
def prepared(tmp_path_factory):
    return meshedCase(tmp_path_factory.mktemp("errors") / "case")


@pytest.mark.parametrize("file, entry, value, expected", [
    ("constant/couplingProperties", "coupling", "threeWay",
     ["couplingProperties", "threeWay", "none", "oneWay", "twoWay"]),
    ("constant/couplingProperties", "subCycels", "10",
     ["couplingProperties", "subCycels", "subCycles", "line"]),
    ("constant/couplingProperties", "patches", "(pannel)",
     ["couplingProperties", "line", "pannel", "panel", "endWall"]),
    ("constant/couplingProperties", "patches", "(roof)",
     ["roof", "shellInterface", "couplingProperties"]),
    ("constant/couplingProperties", "loadTransfer", "nearest",
     ["nearest", "consistent", "closestPoint"]),
    ("constant/shellProperties", "sections/panel/thickness", "1e-4",
     ["not on the shell", "element", "of all", "thickness"]),
    ("0/pointDisplacement", "boundaryField/panel/type", "zeroGradient",
     ["pointDisplacement", "panel", "fixedValue"]),
    ("constant/dynamicMeshDict", "solver", "inverseDistanc",
     ["inverseDistanc", "inverseDistance"]),
])
def test_errorsSayWhatToChange(
    prepared, tmp_path, file, entry, value, expected
):
    case = FoamCase(prepared.path, tmp_path / "case", keepMesh=True)
    case.set(file, entry, value) if "subCycels" not in entry else case.run(
        "foamDictionary", file, "-entry", entry, "-add", value)
    log = case.run("shockShellFoam", check=False)
    assert case.exitCode != 0
    for word in expected:
        assert word in log, f"{word} is not in the message:\n{log[-2000:]}"


@pytest.mark.parametrize("file", [
    "constant/couplingProperties", "constant/shellProperties",
    "constant/thermophysicalProperties", "system/feSchemes",
    "constant/shell/nodes", "constant/dynamicMeshDict",
])
def test_missingFileIsNamed(prepared, tmp_path, file):
    case = FoamCase(prepared.path, tmp_path / "case", keepMesh=True)
    (case.path / file).unlink()
    log = case.run("shockShellFoam", check=False)
    assert case.exitCode != 0
    assert Path(file).name in log
