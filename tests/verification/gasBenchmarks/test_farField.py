"""What a wave leaves behind when it goes out of the scene."""
import numpy as np
import pytest

from benchmarkCase import BenchmarkCase
from blockMeshes import box, wedge
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


# A blast in gas with rho = p = 1, and when its front has gone out to RADIUS
RADIUS = 6
BULB = {"p": 29.67, "rho": 7.591, "radius": 0.5}
OUT = [4.2, 5.2, 6.2]


def blast(folder, radius, waves, directions=2, ends=OUT):
    """Lines of 16 cells per unit of length; {time: pressures}, and the case."""
    case = BenchmarkCase(folder, wedge(radius, 16 * radius, directions))

    def state(x):
        hot = x[:, 0] < BULB["radius"]
        return (np.where(hot, BULB["rho"], 1.0), np.zeros((len(x), 3)),
                np.where(hot, BULB["p"], 1.0))

    case.start(state, {"right": farField(waves)})
    found = {}
    for end in ends:
        case.runTo(end, startFrom="latestTime")
        found[end] = case.result("p")
    return found, case


def farField(waves):
    return {"p": f"type farField; value uniform 1; {waves}",
            "T": "type farField; value uniform 1;",
            "U": "type farField; value uniform (0 0 0);"}


@pytest.mark.parametrize("name, directions, bound", [
    ("spherical", 2, 0.01), ("cylindrical", 1, 0.02)])
def test_blast(tmp_path, table, name, directions, bound):
    """Behind the front the gas flows on: curved waves know it."""
    long, case = blast(tmp_path / "long", 2 * RADIUS, "", directions)
    # The front has gone on from RADIUS and decayed, by this at least
    decay = (case.x[:, 0] / RADIUS)**(directions / 2)
    found = {}
    for waves in (f"waves {name}; origin (0 0 0);", ""):
        short, case = blast(tmp_path / f"short{len(found)}", RADIUS, waves,
                            directions)
        back = max(
            abs(p - long[end][:len(p)]).max()
            / (decay * (long[end] - 1))[len(p):].max()
            for end, p in short.items())
        kind = name if waves else "plane"
        table.add(f"{name} blast at far field, waves {kind}",
                  f"{16 * RADIUS} cells", "largest part sent back", back, "0",
                  bound if waves else "", seconds=case.seconds)
        found[kind] = back
    assert found[name] <= bound
    assert found["plane"] > 3 * found[name]


def test_goesOnAfterARestart(tmp_path):
    """With the afterflow that it has written."""
    waves = "waves spherical; origin (0 0 0);"
    control = {"adjustTimeStep": "no", "deltaT": 5e-3, "writePrecision": 17,
               "maxCo": 0.9}
    ends = {"whole": [6.0], "parts": [5.0, 6.0]}
    p = {}
    for name, stops in ends.items():
        case = BenchmarkCase(tmp_path / name, wedge(RADIUS, 48, 2))
        case.start(
            lambda x: (1 + 0 * x[:, 0], np.zeros((len(x), 3)),
                       1 + 4 * np.exp(-x[:, 0]**2)),
            {"right": farField(waves)})
        for stop in stops:
            case.runTo(stop, startFrom="latestTime", **control)
        p[name] = case.result("p")
    assert np.abs(p["whole"] - p["parts"]).max() < 1e-13
    assert np.abs(p["whole"] - 1).max() > 1e-3


def test_oneFarFieldAroundABox(tmp_path):
    """Facets of an edge's node have each its own flux: one patch around the
    scene or one for each side makes no difference."""
    p = []
    for patches in (["all"] * 4, ["left", "right", "bottom", "top"]):
        mesh = box([(1, 20)], (1, 20))
        names = dict(zip(["left", "right", "bottom", "top"], patches))
        joined = {}
        for name, (kind, faces) in mesh.patches.items():
            entry = joined.setdefault(names.get(name, name), (kind, []))
            entry[1].extend(faces)
        mesh.patches = joined
        case = BenchmarkCase(tmp_path / str(len(p)), mesh)
        case.start(
            lambda x: (1 + 0 * x[:, 0], np.zeros((len(x), 3)), 1 + np.exp(
                -((x[:, 0] - 0.7)**2 + (x[:, 1] - 0.6)**2) / 0.04)),
            dict.fromkeys(patches, "far"),
            lambda x: (np.ones(len(x)), np.zeros((len(x), 3)), 1.0))
        case.runTo(0.8)
        p.append(case.result("p"))
    assert np.abs(p[0] - p[1]).max() < 1e-12


def test_oneFarFieldOfUniformGas(tmp_path):
    """Gas in uniform motion stays so, in a scene one cell wide between two
    sides of one far field."""
    mesh = box([(1, 10)], (0.1, 1))
    kind, faces = mesh.patches.pop("bottom")
    mesh.patches["top"] = (kind, mesh.patches["top"][1] + faces)
    case = BenchmarkCase(tmp_path / "case", mesh)
    case.start(lambda x: (np.ones(len(x)), np.tile([0.2, 0.1, 0], (len(x), 1)),
                          1.0), {"left": "far", "right": "far", "top": "far"})
    case.runTo(0.5)
    assert np.abs(case.result("p") - 1).max() < 1e-12
    assert np.abs(case.result("U") - [0.2, 0.1, 0]).max() < 1e-12
