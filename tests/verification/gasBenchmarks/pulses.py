"""Pressure pulses that meet a boundary, and what comes back.

The same pulse runs on a mesh that ends at x = 1 and on one that goes on to
x = 2 with the same cells; the difference of the two is what the boundary sends
back, of first order in the reflected wave and free of the scheme's errors.
"""
import numpy as np

from benchmarkCase import BenchmarkCase
from blockMeshes import box

AMPLITUDE = 0.1  # of the ambient pressure
C = np.sqrt(1.4)  # rho = p = 1


def rest(x):
    return np.ones(len(x)), np.zeros((len(x), 3)), 1.0


def simpleWave(rise, direction):
    """Gas of a plane wave of finite amplitude, an isentropic simple wave."""
    p = 1 + rise
    speed = 2 * C / 0.4 * (p**(0.2 / 1.4) - 1)
    return p**(1 / 1.4), speed[:, None] * direction, p


def along(cells, across):
    """Straight at the boundary, in a duct; (mesh of a length, state, end)."""
    sides = [(n / cells, n) for n in across]

    def mesh(length):
        return box([(length, length * cells)], *sides)

    def state(x):
        rise = AMPLITUDE * np.exp(-((x[:, 0] - 0.6) / 0.06)**2)
        return simpleWave(rise, np.array([1.0, 0, 0]))

    return mesh, state, 0.7 / C


def oblique(cells, degrees, deep):
    """Plane pulses at an angle to the boundary's normal, one per unit of
    length along their way; cyclic sides."""
    angle = np.radians(degrees)
    direction = np.array([np.cos(angle), np.sin(angle), 0])
    side = 1 / np.sin(angle)
    n = round(side * cells)

    def mesh(length):
        depth = [(deep / cells, deep)] if deep else []
        m = box([(length, length * cells)], (side, n), *depth)
        m.cyclic("bottom", "top")
        return m.cyclic("back", "front") if deep else m

    def state(x):
        s = (x @ direction + 0.25) % 1 - 0.5
        return simpleWave(AMPLITUDE * np.exp(-(s / 0.1)**2), direction)

    return mesh, state, 0.5 / C


def corner(cells):
    """A round pulse from a corner of a square; its front meets two sides."""
    def mesh(length):
        return box([(length, length * cells)], (length, length * cells))

    def state(x):
        r = np.hypot(x[:, 0], x[:, 1])
        p = 1 + AMPLITUDE * np.exp(-(r / 0.3)**2)
        return p**(1 / 1.4), 0.0, p

    return mesh, state, 1.5 / C


def pressures(folder, mesh, state, end, ends, capturing):
    """{rounded place: pressure} at the end, and the case."""
    case = BenchmarkCase(folder, mesh, capturing=capturing)
    boundary = dict.fromkeys(("bottom", "top", "back", "front"), "wall")
    boundary.update({"left": "far", "right": "far", **ends})
    case.start(state, boundary, rest)
    case.runTo(end)
    return dict(zip(map(tuple, np.round(case.x, 7)), case.result("p"))), case


def reflections(folder, pulse, kinds, capturing=True, others=None):
    """Largest part of the pulse that comes back from the right side, and the
    case, for each kind of boundary there.

    others: the kinds of the other patches, in the long mesh as well.
    """
    mesh, state, end = pulse
    others = others or {}
    long, _ = pressures(
        folder / "long", mesh(2), state, end, others, capturing)
    for kind in kinds:
        short, case = pressures(
            folder / kind, mesh(1), state, end, {**others, "right": kind},
            capturing)
        sentBack = max(abs(p - long[x]) for x, p in short.items())
        yield sentBack / AMPLITUDE, case
