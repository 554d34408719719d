"""The function object conservation: the account of mass, momentum and energy
closes to rounding, and its parts are what they are said to be."""
import csv
import re
import sys
from pathlib import Path

import numpy as np
import pytest

for _folder in ("gasBenchmarks", "fsi"):
    sys.path.insert(0, str(Path(__file__).parents[1] / _folder))

import platesInGas  # noqa: E402
from benchmarkCase import BenchmarkCase  # noqa: E402
from blockMeshes import axisymmetric, box  # noqa: E402
from foamCase import RunFailed  # noqa: E402
from scheme import entries  # noqa: E402

FUNCTION = """{
    balance { type conservation; libs (shockShellFunctionObjects); }
}"""
AMOUNTS = ("mass", "momentum_x", "momentum_y", "momentum_z", "energy")
SCHEMES = {
    "fluxCorrected": entries("twoStep", "fluxCorrected"),
    "lumped": entries("twoStep", "pressureSwitch"),
    "consistent": entries("twoStep", "pressureSwitch", "consistent"),
    "threeStep": entries("threeStep", "pressureLaplacian"),
}


def read(case, file="conservation", start="0"):
    """Columns of a table by name."""
    path = (case.path / "postProcessing" / "balance" / start
            / f"{file}.csv")
    with open(path) as stream:
        rows = list(csv.DictReader(stream))
    return {k: np.array([float(row[k]) for row in rows]) for k in rows[0]}


def blast(x):
    """A bulb of hot gas off the middle, in wind."""
    inside = np.exp(-((x - [0.4, 0.5, 0.5])**2).sum(axis=1)/0.02)
    return 1 + inside, np.tile([0.1, 0.05, 0.0], (len(x), 1)), 1 + 4*inside


def small(x):
    """A bulb at rest, with still gas beyond a radius."""
    r2 = ((x[:, :2] - [0.3, 0.5])**2).sum(axis=1)
    inside = np.where(r2 < 0.09, np.exp(-r2/0.02), 0)
    return 1 + inside, 0.0, 1 + 4*inside


def case(folder, mesh, boundary, scheme="fluxCorrected", state=blast):
    found = BenchmarkCase(folder, mesh)
    found.start(state, boundary)
    found.write("system/feSchemes", SCHEMES[scheme])
    return found


def run(found, end=0.3, **control):
    found.runTo(end, **{
        "functions": FUNCTION, "maxCo": 0.4, "writeFormat": "binary",
        **control})


def closes(table, scale=1):
    """Errors in units of rounding of what is there, step by step."""
    mass, energy = table["mass"][0], table["energy"][0]
    for name in AMOUNTS:
        # Momentum: that of all the gas at the speed of sound, about
        whole = {"mass": mass, "energy": energy}.get(
            name, np.sqrt(mass*energy))
        assert abs(table[f"error_{name}"]).max() < scale*2e-14*whole, name


SIDES = {"left": "wall", "right": "open", "bottom": "wall", "top": "far"}


@pytest.mark.parametrize("scheme", SCHEMES)
def test_accountCloses(tmp_path, scheme):
    found = case(tmp_path / "box", box([(1, 12)], (1, 10)), SIDES, scheme)
    run(found)
    table = read(found)
    closes(table)
    # There is something to account for, through every patch that is open
    assert abs(table["entered_mass"][-1]) > 0.01
    parts = {side: read(found, side) for side in SIDES}
    assert abs(parts["left"]["mass"]).max() == 0
    assert abs(parts["top"]["mass"][-1]) > 1e-3
    assert abs(parts["left"]["momentum_x"][-1]) > 1e-3
    for name in AMOUNTS:
        total = sum(part[name] for part in parts.values())
        assert np.allclose(total, table[f"entered_{name}"], atol=1e-14)
    # No source in a plane, and walls hold no mass
    assert abs(table["sources_momentum_y"]).max() == 0
    assert abs(table["held_mass"]).max() < 1e-14
    np.testing.assert_allclose(
        table["mass"][-1] - table["mass"][0],
        table["entered_mass"][-1] - table["entered_mass"][0], atol=1e-14)


def test_wallsHoldNoEnergyAtRest(tmp_path):
    found = case(tmp_path / "box", box([(1, 12)], (1, 10)),
                 dict.fromkeys(SIDES, "wall"))
    run(found)
    table, absolute = read(found), read(found, "left")
    # The same of the overpressure: less the ambient pressure's impulse
    run(found, functions=FUNCTION.replace("type", "ambient 1; type"))
    over = read(found, "left")
    assert np.allclose(absolute["momentum_x"] - over["momentum_x"],
                       over["time"], rtol=1e-10)
    assert abs(over["momentum_x"][-1]) < 0.5*absolute["momentum_x"][-1]
    for name in AMOUNTS:
        assert np.allclose(read(found)[f"entered_{name}"],
                           table[f"entered_{name}"], atol=1e-13)
    closes(table)
    for name in ("entered_mass", "entered_energy", "held_energy"):
        assert abs(table[name]).max() < 1e-13


@pytest.mark.parametrize(
    "scene", ["tetrahedra", "axisymmetric", "inlet", "stillZones"])
def test_otherScenesClose(tmp_path, scene):
    mesh, boundary = {
        "tetrahedra": (box([(1, 6)], (1, 5), (1, 5)), {
            "left": "wall", "right": "open", "bottom": "far", "top": "wall",
            "back": "wall", "front": "open"}),
        "axisymmetric": (axisymmetric(1, 1, (10, 10)), {}),
        "inlet": (box([(1, 12)], (1, 10)), {
            "left": "fixed", "right": "open", "bottom": "wall",
            "top": "wall"}),
        "stillZones": (box([(4, 80)], (1, 10)), SIDES),
    }[scene]
    if scene == "axisymmetric":
        boundary = {patch: "wall" for patch, (kind, _) in mesh.patches.items()
                    if kind.split(",")[0] == "patch"}
        boundary[next(iter(boundary))] = "open"
    found = case(tmp_path / scene, mesh, boundary,
                 state=small if scene == "stillZones" else blast)
    run(found, 0.2)
    table = read(found)
    closes(table)
    if scene == "axisymmetric":
        sources = [abs(table[f"sources_{name}"]).max() for name in AMOUNTS]
        assert np.argmax(sources) == 2 and max(sources) > 1e-6
    if scene == "stillZones":
        active = re.findall(r"zones: ([\d.]+) % of the gas is", found.log)
        assert float(active[0]) < 50
    if scene == "inlet":
        assert abs(table["held_mass"][-1]) > 1e-7


def piston(folder, mesh=None, **more):
    """A wall that goes into the gas."""
    found = case(folder, mesh or box([(1, 20)], (1, 4)),
                 dict.fromkeys(SIDES, "wall"), **more)
    found.move("pointDisplacement", {
        "left": "type uniformFixedValue; uniformValue { type sine; frequency"
                " 1; amplitude 0.1; scale (1 0 0); level (0 0 0); };"
                " value uniform (0 0 0);",
        "bottom": "type slip;", "top": "type slip;"})
    return found


def test_movingWallDoesTheWorkThatEnters(tmp_path):
    found = piston(tmp_path / "piston")
    run(found, 0.25)
    table = read(found)
    closes(table, scale=3)
    wall = read(found, "left")
    work = wall["energy"][-1]
    gained = table["energy"][-1] - table["energy"][0]
    assert work > 0.05
    # All that the gas gains comes from this wall, as pressure and constraint
    assert gained == pytest.approx(
        work + table["held_energy"][-1] - table["held_energy"][0], rel=0.05)


def still(x):
    return np.ones(len(x)), 0.0, np.ones(len(x))


def test_gasThatSleepsOnAMovingMesh(tmp_path):
    """Only the part about the wall moves and is computed."""
    found = piston(tmp_path / "still", mesh=box([(4, 80)], (1, 8)),
                   state=still)
    found.write("constant/dynamicMeshDict", """
motionSolverLibs (meshMotion);
solver inverseDistance;
inverseDistanceCoeffs
{
    movingPatches (left); fixedPatches (right);
    innerDistance 0.4; outerDistance 1;
}
""")
    run(found, 0.2)
    active = re.findall(r"zones: ([\d.]+) % of the gas is", found.log)
    assert float(active[-1]) < 60
    closes(read(found))


def test_restartGoesOn(tmp_path):
    whole = case(tmp_path / "whole", box([(1, 12)], (1, 10)), SIDES)
    steps = {"adjustTimeStep": "no", "deltaT": 0.01}
    run(whole, 0.2, **steps)
    parts = case(tmp_path / "parts", box([(1, 12)], (1, 10)), SIDES)
    run(parts, 0.1, **steps)
    run(parts, 0.2, startFrom="latestTime", **steps)
    wanted, first, last = read(whole), read(parts), read(parts, start="0.1")
    assert len(first["time"]) + len(last["time"]) == len(wanted["time"])
    # The state has primitive variables, in 16 digits
    closes(last, scale=10)
    for name, values in wanted.items():
        if "error" not in name:
            assert np.allclose(last[name], values[len(first["time"]):],
                               rtol=1e-12, atol=1e-13), name


def test_severalProcessors(tmp_path):
    found = case(tmp_path / "serial", box([(1, 12)], (1, 10)), SIDES)
    run(found, 0.1)
    serial = read(found)
    right = read(found, "right")
    found.write("system/decomposeParDict",
                "numberOfSubdomains 2; method simple;\n"
                "simpleCoeffs { n (2 1 1); delta 0.001; }\n")
    found.run("rm", "-r", "0.1", "postProcessing")
    found.run("decomposePar")
    found.runParallel(2, "shockShellFoam")
    parallel = read(found)
    closes(parallel)
    for name, values in serial.items():
        assert np.allclose(parallel[name], values, rtol=1e-10, atol=1e-12)
    for name, values in read(found, "right").items():
        assert np.allclose(values, right[name], rtol=1e-10, atol=1e-12)


@pytest.mark.parametrize("scheme", ["twoWay", "iterated"])
def test_coupledStepsThatAreRepeatedCountOnce(tmp_path, monkeypatch, scheme):
    """A plate that gas pushes: the work of the interface is what enters."""
    monkeypatch.setattr(platesInGas, "CONTROL", platesInGas.CONTROL.replace(
        "functions\n{", "functions\n" + FUNCTION[:-1]))
    found = platesInGas.PlateInGas(
        tmp_path / scheme, 7.6,
        front=platesInGas.Gas(0.5, 50, platesInGas.uniform(1e5, 293)))
    found.couple(scheme, coeffs="iteratedCoeffs { tolerance 1e-10; }\n"
                 if scheme == "iterated" else "").runTo(2e-4, deltaT=1e-5)
    table = read(found)
    closes(table)
    assert len(table["time"]) == 20
    plate = read(found, "frontFace")
    work = found.balance()["workGas"][-1]
    assert plate["energy"][-1] < 0
    assert work > 0 and plate["energy"][-1] == pytest.approx(-work, rel=2e-3)
    assert plate["momentum_x"][-1] == pytest.approx(
        -found.balance()["impulseGas_x"][-1], rel=2e-3)


def test_viscousGasStops(tmp_path):
    found = BenchmarkCase(tmp_path / "box", box([(1, 8)], (1, 4)), mu=1e-3)
    found.start(blast, dict.fromkeys(SIDES, "wall"))
    with pytest.raises(RunFailed, match="knows neither viscosity"):
        run(found, 0.01)
