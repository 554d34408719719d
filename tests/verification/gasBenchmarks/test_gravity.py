"""Columns of gas at rest in a field of gravity."""
import numpy as np
import pytest

from foamCase import RunFailed
from benchmarkCase import BenchmarkCase
from blockMeshes import axisymmetric, box
from distortedMeshes import perturbed
from errorNorms import orders
from scheme import DEFAULT, entries

C = np.sqrt(1.4)  # rho = p = 1 at the origin
G = 1.0           # the scale height of the isothermal column is 1

# Ten passages of sound through a column as high as the scale height
END = 10 / C

# Of one temperature: at rest up to rounding, whose part in the pressure is about
# 1e-16 per step
REST = 1e-12

# With the consistent mass: below the limit 1/sqrt(3), (G82). Beyond it waves
# grow until they are as steep as the column, which is when fluxCorrected sees
# them: Mach number 0.016 on 50 lines with 0.8.
MAX_CO = 0.5

# Adiabatic: second order
ORDER = 1.9


def isothermal(direction):
    """rho, U, p with gravity along direction."""
    def state(x):
        p = np.exp(G * x @ np.array(direction, float))
        return p, 0.0, p
    return state


def adiabatic(x):
    T = 1 - 0.4 / 1.4 * G * x[:, 0]
    return T**2.5, 0.0, T**3.5


def machNumber(case):
    c = np.sqrt(1.4 * case.result("p") / case.result("rho"))
    return (np.linalg.norm(case.result("U"), axis=1) / c).max()


def run(case, state, boundary, end, scheme=DEFAULT):
    case.write("system/feSchemes", entries(*scheme))
    case.start(state, boundary)
    lumped = scheme[0] == "threeStep" or scheme[2] == "lumped"
    case.runTo(end, maxCo=0.8 if lumped else MAX_CO)
    return machNumber(case)


DOWN = (-1.0, 0.0, 0.0)
SLANTED = (0.6, -0.8, 0.0)


@pytest.mark.parametrize("scheme", [
    DEFAULT, ("twoStep", "none", "lumped"), ("twoStep", "none", "consistent"),
    ("threeStep", "none", None),
], ids=lambda scheme: "-".join(str(word) for word in scheme))
def test_columnOfOneTemperature(tmp_path, table, scheme):
    case = BenchmarkCase(tmp_path / "column", box([(1, 50)]),
                         gravity=tuple(G * np.array(DOWN)))
    mach = run(case, isothermal(DOWN), {"left": "wall", "right": "wall"},
               END, scheme)
    words = " ".join(word for word in scheme if word)
    table.add("isothermal column of gas at rest", f"50 lines, {words}",
              "largest Mach number, 10 passages of sound", mach, "0",
              f"{REST}", "", case.seconds, capturing=scheme == DEFAULT)
    assert mach < REST


SCENES = {
    # Points moved at random; gravity along no line of the mesh
    "triangles": (lambda: box([(1, 8)], (1, 8)), SLANTED, {}),
    "tetrahedra": (lambda: box([(1, 4)], (1, 4), (1, 4)), (0.6, 0, -0.8), {}),
    "open": (lambda: box([(1, 8)], (1, 8)), DOWN,
             {"bottom": "open", "top": "open"}),
    "farField": (lambda: box([(1, 8)], (1, 8)), DOWN,
                 {"bottom": "far", "top": "far"}),
    "cyclic": (lambda: box([(1, 8)], (1, 8)).cyclic("bottom", "top"), DOWN,
               {}),
    "axisymmetric": (lambda: axisymmetric(1, 1, (8, 8)), DOWN, {}),
}


@pytest.mark.parametrize("scene", SCENES)
def test_gasOfOneTemperatureStaysAtRest(tmp_path, scene):
    mesh, direction, boundary = SCENES[scene]
    case = BenchmarkCase(tmp_path / "case", mesh(),
                         gravity=tuple(G * np.array(direction)))
    if scene in ("triangles", "tetrahedra"):
        perturbed(case, 0.2)
    walls = {name: "wall" for name, (kind, _) in case.mesh.patches.items()
             if kind == "patch"}
    assert run(case, isothermal(direction), {**walls, **boundary}, 1) < REST


def test_columnOfOneEntropy(tmp_path, table):
    """Cools upwards: in balance with second order."""
    numbers = (25, 50, 100)
    for capturing in (False, True):
        speeds, seconds = [], []
        for n in numbers:
            case = BenchmarkCase(tmp_path / f"{n}{capturing}", box([(1, n)]),
                                 gravity=tuple(G * np.array(DOWN)))
            scheme = DEFAULT if capturing else ("twoStep", "none", "lumped")
            speeds.append(run(case, adiabatic,
                              {"left": "wall", "right": "wall"}, END, scheme))
            seconds.append(case.seconds)
        table.add("adiabatic column of gas at rest", "25 50 100 lines",
                  "largest Mach number, 10 passages of sound", speeds, "0",
                  "", orders(speeds, numbers), seconds, capturing=capturing)
        assert orders(speeds, numbers)[-1] > ORDER, (capturing, speeds)


def test_courantNumberAtWhichWavesGrowIsRefused(tmp_path):
    case = BenchmarkCase(tmp_path / "case", box([(1, 10)]),
                         gravity=tuple(G * np.array(DOWN)))
    case.start(isothermal(DOWN), {"left": "wall", "right": "wall"})
    with pytest.raises(RunFailed) as failed:
        case.runTo(0.1, maxCo=0.8)
    assert "maxCo is 0.8, but must be in (0, 0.577" in str(failed.value)
