"""Charges and profiles in wedge scenes: mass and energy are exact for the part
of the body that the wedge holds. The gas constant is 1, gamma 1.4."""
import sys
from pathlib import Path

import numpy as np
import pytest

sys.path.insert(0, str(Path(__file__).parents[1] / "gasBenchmarks"))

from benchmarkCase import BenchmarkCase  # noqa: E402
from blockMeshes import axisymmetric, wedge  # noqa: E402

EXACT = 1e-10
MASS, ENERGY, RADIUS = 0.7, 30.0, 0.31
CHARGE = """
states ( sphericalCharge {{ centre {centre}; mass {mass}; energy {energy};
    radius {radius}; {more} }} );
"""


def still(folder, mesh):
    case = BenchmarkCase(folder, mesh)
    case.start(lambda x: (np.ones(len(x)), 0.0, 1.0),
               dict.fromkeys(("left", "right", "top"), "open"))
    # Totals with all their digits
    case.control({"stopAt": "endTime", "endTime": 1, "deltaT": 1,
                  "writeInterval": 1})
    return case


def setState(case, text):
    case.write("system/setPointFieldsDict", text)
    case.log = case.run("setPointFields")


def radii(case):
    """Distances from the axis or, on a spherical line, from the centre; the
    points are on the sides of the wedge."""
    x = case.x.copy()
    if case.mesh.dim == 2:
        x[:, 0] = 0
    elif len(case.mesh.patches) == 4:
        x[:, 2] = 0
    return np.linalg.norm(x, axis=1)


def lineTotals(case, power, time="0"):
    """Mass and energy of a curved line per unit of angle, by the exact
    integrals of its shape functions; and its nodal weights."""
    r = radii(case)
    a, b = r[:-1], r[1:]
    # Three Gauss points: exact for N_a r^2
    weights = np.zeros(len(r))
    for xi, w in ((-np.sqrt(0.6), 5 / 18), (0, 8 / 18), (np.sqrt(0.6), 5 / 18)):
        t = (1 + xi) / 2
        part = w * (b - a) * ((1 - t) * a + t * b)**power
        weights[:-1] += (1 - t) * part
        weights[1:] += t * part
    p, T, U = (case.result(name, time) for name in ("p", "T", "U"))
    rho = p / T
    energy = p / 0.4 + 0.5 * rho * (U**2).sum(axis=1)
    return (weights * rho).sum(), (weights * energy).sum()


def axisymmetricTotals(case, time="0"):
    """The same of a half plane, over the whole turn, by the triangles of the
    solver: quadrilaterals cut between corners of even parity."""
    nx, nr = case.mesh.blocks[0][1][:2]
    order = np.lexsort(np.round(case.x[:, :2], 9).T)
    shape = (nr + 1, nx + 1)
    x = case.x[order, 0].reshape(shape)
    r = radii(case)[order].reshape(shape)
    p, T, U = (case.result(n, time)[order] for n in ("p", "T", "U"))
    rho = p / T
    energy = p / 0.4 + 0.5 * rho * (U**2).sum(axis=1)
    totals = []
    for f in (rho.reshape(shape), energy.reshape(shape)):
        total = 0.0
        for i in range(nr):
            for j in range(nx):
                c = [(i, j), (i, j + 1), (i + 1, j + 1), (i + 1, j)]
                cut = ((0, 1, 2), (0, 2, 3)) if (i + j) % 2 == 0 else (
                    (1, 2, 3), (1, 3, 0))
                for triangle in cut:
                    xs, rs, fs = (np.array([v[c[k]] for k in triangle])
                                  for v in (x, r, f))
                    area = abs((xs[1] - xs[0]) * (rs[2] - rs[0])
                               - (xs[2] - xs[0]) * (rs[1] - rs[0])) / 2
                    # int f r of linear f and r
                    total += area / 12 * (fs.sum() * rs.sum() + fs @ rs)
        totals.append(2 * np.pi * total)
    return totals


@pytest.mark.parametrize("scene", ["sphere", "cylinder", "density"])
def test_chargeOnALine(tmp_path, scene):
    directions = 1 if scene == "cylinder" else 2
    case = still(tmp_path / "case", wedge(1, 57, directions))
    around = (2 if directions == 1 else 4) * np.pi
    volume = around * RADIUS**(directions + 1) / (directions + 1)
    text = CHARGE.format(centre="(0 0 0)", mass=MASS, energy=ENERGY,
                         radius=RADIUS, more="")
    if scene == "density":
        text = text.replace(f"radius {RADIUS}",
                            f"density {MASS / volume:.17g}")
    setState(case, text)
    mass, energy = lineTotals(case, directions)
    whole = around / (directions + 1) * radii(case).max()**(directions + 1)
    assert abs(around * mass / (whole - volume + MASS) - 1) < EXACT
    assert abs(around * energy / ((whole - volume) / 0.4 + ENERGY) - 1) < EXACT
    assert case.result("p", "0")[0] == pytest.approx(0.4 * ENERGY / volume)
    assert case.result("p", "0")[-1] == pytest.approx(1)


@pytest.mark.parametrize("centre, part", [(0.5, 1.0), (0.0, 0.5)])
def test_chargeInAnAxisymmetricScene(tmp_path, centre, part):
    case = still(tmp_path / "case", axisymmetric(1, 0.6, (30, 18)))
    setState(case, CHARGE.format(
        centre=f"({centre} 0 0)", mass=MASS, energy=ENERGY, radius=RADIUS,
        more=""))
    mass, energy = axisymmetricTotals(case)
    volume = 4 / 3 * np.pi * RADIUS**3 * part
    whole = np.pi * radii(case).max()**2
    assert abs(mass / (whole - volume + part * MASS) - 1) < EXACT
    assert abs(
        energy / ((whole - volume) / 0.4 + part * ENERGY) - 1) < EXACT


def test_profileOfASphericalRun(tmp_path):
    """A blast on a spherical line goes on in an axisymmetric mesh: mass and
    energy within the profile are those of the run, velocities point away."""
    line = still(tmp_path / "line", wedge(0.4, 60, 2))
    setState(line, CHARGE.format(
        centre="(0 0 0)", mass=MASS, energy=ENERGY, radius=0.2, more=""))
    line.runTo(0.03)
    time = line.times()[-1]
    lineMass, lineEnergy = lineTotals(line, 2, time)

    case = still(tmp_path / "plane", axisymmetric(1, 0.6, (80, 48)))
    setState(case, f"""
states ( mappedProfile {{ geometry spherical; centre (0.5 0 0);
    case "{line.path}"; }} );
""")
    mass, energy = axisymmetricTotals(case)
    end = radii(line).max()
    rest = np.pi * radii(case).max()**2 - 4 / 3 * np.pi * end**3
    assert abs(mass / (rest + 4 * np.pi * lineMass) - 1) < EXACT
    assert abs(energy / (rest / 0.4 + 4 * np.pi * lineEnergy) - 1) < EXACT

    # The velocity is radial, as on the line, and has no part across the wedge
    d = case.x - [0.5, 0, 0]
    r = np.linalg.norm(d, axis=1)
    U = case.result("U", "0")
    moving = (np.linalg.norm(U, axis=1) > 0.1) & (r < 0.9 * end)
    assert moving.sum() > 100
    along = (U[moving] * d[moving]).sum(axis=1) / r[moving]
    assert np.allclose(along, np.linalg.norm(U[moving], axis=1), rtol=1e-6)
    exact = np.interp(r[moving], radii(line),
                      np.linalg.norm(line.result("U", time), axis=1))
    assert abs(along - exact).max() < 0.15 * exact.max()


@pytest.mark.parametrize("text, words", [
    (CHARGE.format(centre="(0.5 0.1 0)", mass=1, energy=1, radius=0.2,
                   more=""), ("not on the axis", "ring")),
    ("states ( sphericalCharge { centre (0.5 0 0); radius 0.2; p 2; T 1;"
     " U (0 1 0); } );", ("U is (0 1 0)", "along the axis")),
    ("states ( planarShock { machNumber 2; point (0.5 0 0);"
     " normal (0 1 0); } );", ("normal", "along the axis")),
])
def test_whatAWedgeHasNot(tmp_path, text, words):
    case = still(tmp_path / "case", axisymmetric(1, 0.6, (10, 6)))
    case.write("system/setPointFieldsDict", text)
    log = case.run("setPointFields", check=False)
    assert case.exitCode not in (0, None)
    for word in words:
        assert word in log, log[-1500:]
