"""Point explosions in cold gas: Sedov's solution in one, two and three
directions, and how round a blast stays on hexahedra."""
import numpy as np
import pytest

from errorNorms import l1, orders, weights1D
from exactSolutions import Sedov
from implosions import (
    COLD, energyHeld, energyOfAll, explosion, quarter, radius, slices,
)

LENGTH = 1.2
END = {1: 0.5, 2: 0.75, 3: 0.75}

# Numbers of elements along a side
NUMBERS = {1: (100, 200, 400), 2: (32, 64, 128), 3: (12, 18, 27)}
LONG = {2: (64, 128, 256), 3: (27, 40, 60)}

# Bounds at the last of NUMBERS: error of the shock's radius over the exact
# one, and L1 error of rho (mean over the nodes inside 1.1 radii)
RADIUS = {1: 0.01, 2: 0.02, 3: 0.04}
ERROR = {1: 0.08, 2: 0.2, 3: 0.42}
ORDER = {1: 0.4, 2: 0.5, 3: 0.3}


def frontRadius(r, rho, blast):
    """Where the density outside its peak passes half of the jump ahead of a
    shock: mean over shells of a hundredth of the radius."""
    edges = blast.radius * np.linspace(0.5, 1.3, 81)
    shell = np.digitize(r, edges)
    middle, mean = zip(*[
        (r[shell == k].mean(), rho[shell == k].mean())
        for k in range(1, len(edges)) if (shell == k).any()
    ])
    middle, mean = np.array(middle), np.array(mean)
    peak = mean.argmax()
    level = 0.5 * (mean[peak] + blast.rho0)
    out = peak + np.flatnonzero(mean[peak:] < level)[0]
    return np.interp(-level, -mean[out - 1:out + 1], middle[out - 1:out + 1])


def check(tmp_path, table, directions, numbers, name, mesh, meshOf=None,
          volume=None):
    """volume: function of the outer radius, of the whole that a slice is of."""
    errors, offs, seconds = [], [], []
    for n in numbers:
        options = {"meshOf": meshOf} if meshOf else {}
        case = explosion(tmp_path / str(n), directions, n, END[directions],
                         LENGTH, **options)
        r, rho = radius(case.mesh, case.x), case.result("rho")
        energy = energyOfAll(case, volume(r.max())) if meshOf else \
            energyHeld(case, directions, LENGTH)
        blast = Sedov(energy, END[directions], directions)
        assert rho.min() > 0 and case.result("p").min() > 0
        near = r < 1.1 * blast.radius
        w = weights1D(r, directions - 1) if case.mesh.dim == 1 else \
            np.ones(len(r))
        errors.append(l1(rho[near] - blast.sample(r[near])[0], w[near]))
        offs.append(abs(frontRadius(r, rho, blast) / blast.radius - 1))
        seconds.append(case.seconds)
    table.add(name, mesh, "L1 of rho", errors, "exact",
              f"last {ERROR[directions]}", orders(errors, numbers), seconds)
    table.add(name, "same", "radius of the front", offs, "exact",
              f"last {RADIUS[directions]}")
    assert errors[-1] < ERROR[directions]
    assert orders(errors, numbers)[-1] > ORDER[directions]
    assert offs[-1] < RADIUS[directions]


@pytest.mark.parametrize("directions", [1, 2, 3])
def test_sedov(tmp_path, table, directions):
    numbers = NUMBERS[directions]
    kind = {1: "lines", 2: "^2 quadrilaterals", 3: "^3 hexahedra"}[directions]
    name = {1: "plane", 2: "quarter of a cylinder", 3: "octant of a sphere"}
    check(tmp_path, table, directions, numbers, "Sedov, " + name[directions],
          " ".join(map(str, numbers)) + f" {kind}")


@pytest.mark.long
@pytest.mark.parametrize("directions", [2, 3])
def test_sedovFiner(tmp_path, table, directions):
    numbers = LONG[directions]
    check(tmp_path, table, directions, numbers, f"Sedov, {directions}D, finer",
          " ".join(map(str, numbers)) + f" ^{directions} elements")


@pytest.mark.parametrize("directions", [2, 3])
def test_sedovOnSlices(tmp_path, table, directions):
    """The same along one radius, of a cylinder and of a sphere."""
    name = {2: "cylinder", 3: "sphere"}[directions]
    check(tmp_path, table, directions, NUMBERS[1], f"Sedov, {name}, 1D",
          "100 200 400 lines", meshOf=slices,
          volume={2: lambda r: np.pi * r**2,
                  3: lambda r: 4 / 3 * np.pi * r**3}[directions])


def test_sedovRoundAnAxis(tmp_path, table):
    """A sphere in the plane of its axis and a radius."""
    check(tmp_path, table, 3, NUMBERS[2], "Sedov, sphere, axisymmetric",
          "32 64 128 ^2 quadrilaterals", meshOf=quarter,
          volume=lambda r: 2 * np.pi * LENGTH**3)


# Roundness. A shock is some elements wide, so the front's place along a ray is
# found by interpolation; the requirement is 1 % of the radius
ROUND = 0.01


def raysOfOctant():
    """Axes, face diagonals, the space diagonal, and some in between."""
    rays = np.array([
        (i, j, k) for i in range(4) for j in range(4) for k in range(4)
        if np.gcd.reduce([i, j, k]) == 1
    ], float)
    return rays / np.linalg.norm(rays, axis=1)[:, None]


def frontAlong(ray, field, h, near, far, ahead):
    """Radius along a ray at which a field on a grid of nodes, interpolated
    linearly in the three directions, passes half of its rise."""
    s = np.linspace(near, far, 400)
    place = np.outer(s, ray) / h
    low = np.minimum(place.astype(int), np.array(field.shape) - 2)
    part = place - low
    values = 0
    for corner in np.ndindex(2, 2, 2):
        c = np.array(corner)
        weight = np.prod(np.where(c, part, 1 - part), axis=1)
        values = values + weight * field[tuple((low + c).T)]
    peak = values.argmax()
    level = 0.5 * (values[peak] + ahead)
    out = peak + np.flatnonzero(values[peak:] < level)[0]
    return np.interp(-level, -values[out - 1:out + 1], s[out - 1:out + 1])


@pytest.mark.parametrize(
    "cells", [30, pytest.param(60, marks=pytest.mark.long)])
def test_blastStaysRound(tmp_path, table, cells):
    case = explosion(tmp_path / "case", 3, cells, END[3], LENGTH, width=4)
    blast = Sedov(energyHeld(case, 3, LENGTH), END[3], 3)
    grid = np.rint(case.x * cells / LENGTH).astype(int)
    p = np.empty((cells + 1,) * 3)
    p[tuple(grid.T)] = case.result("p")
    fronts = np.array([
        frontAlong(ray, p, LENGTH / cells, 0.7 * blast.radius, LENGTH, COLD)
        for ray in raysOfOctant()
    ])
    off = fronts / fronts.mean() - 1
    table.add("blast on hexahedra", f"{cells}^3",
              "front's radius over its mean - 1, least and largest",
              [off.min(), off.max()], "0", f"+- {ROUND}",
              seconds=case.seconds)
    assert abs(off).max() < ROUND
