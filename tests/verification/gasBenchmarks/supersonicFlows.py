"""Plane supersonic flows: ramps, a forward step, a shock that runs up a
ramp."""
import numpy as np

from benchmarkCase import BenchmarkCase
from blockMeshes import plane

C = np.sqrt(1.4)  # rho = p = 1 ahead, unless said otherwise
FLOOR = {"floor": "wall", "ramp": "wall", "top": "wall"}


def rampMesh(theta, n, ahead=0.25, length=1.0, height=1.0):
    """A floor of length `ahead`, then a ramp with the slope theta [rad]; n
    elements over length 1. Grid lines across are vertical."""
    rise = length * np.tan(theta)
    corners = [(-ahead, 0), (0, 0), (length, rise),
               (length, height), (0, height), (-ahead, height)]
    up = int(round(n * height))
    blocks = [((0, 1, 4, 5), (int(round(n * ahead)), up)),
              ((1, 2, 3, 4), (int(round(n * length)), up))]
    return plane(corners, blocks, {
        "inlet": [(5, 0)], "outlet": [(2, 3)], "floor": [(0, 1)],
        "ramp": [(1, 2)], "top": [(3, 4), (4, 5)],
    })


def column(case, x, field):
    """y and field along the grid line nearest to x."""
    xs = np.unique(case.x[:, 0].round(8))
    line = np.flatnonzero(
        abs(case.x[:, 0] - xs[abs(xs - x).argmin()]) < 1e-7)
    line = line[np.argsort(case.x[line, 1])]
    return case.x[line, 0].mean(), case.x[line, 1], field[line]


def overRamp(folder, mach, theta, n):
    """Steady flow of this Mach number over a ramp: case, the nodes on it
    between x = 0.4 and 0.9, and nodes in the uniform flow 0.1 above it."""
    case = BenchmarkCase(folder, rampMesh(theta, n))
    case.start(lambda x: (np.ones(len(x)), mach * C, 1.0),
               {**FLOOR, "inlet": "fixed", "outlet": "open"})
    case.runTo(4 / (mach * C))
    x, y = case.x[:, 0], case.x[:, 1]
    height = y - x * np.tan(theta)
    on = (x > 0.4) & (x < 0.9) & (abs(height) < 1e-6)
    above = (x > 0.6) & (x < 0.9) & (abs(height - 0.1) < 0.04)
    return case, on, above


def machNumber(case):
    U = case.result("U")
    return np.sqrt((U**2).sum(axis=1) * case.result("rho")
                   / (1.4 * case.result("p")))


STEP_MACH = 3.0


def forwardStep(folder, n):
    """Flow of Mach 3 onto a step of height 0.2 in a channel of height 1, at
    t = 4; rho = 1.4, so that c = 1.

    source: P. Woodward and P. Colella, J. Comput. Phys. 54 (1984) 115
    """
    corners = [(0, 0), (0.6, 0), (0, 0.2), (0.6, 0.2), (3, 0.2),
               (0, 1), (0.6, 1), (3, 1)]

    def cells(length):
        return int(round(n * length))

    mesh = plane(corners, [
        ((0, 1, 3, 2), (cells(0.6), cells(0.2))),
        ((2, 3, 6, 5), (cells(0.6), cells(0.8))),
        ((3, 4, 7, 6), (cells(2.4), cells(0.8))),
    ], {
        "inlet": [(2, 0), (5, 2)], "outlet": [(4, 7)],
        "floor": [(0, 1)], "face": [(1, 3)], "step": [(3, 4)],
        "top": [(6, 5), (7, 6)],
    })
    case = BenchmarkCase(folder, mesh)
    case.start(lambda x: (np.full(len(x), 1.4), STEP_MACH, 1.0), {
        **dict.fromkeys(("floor", "face", "step", "top"), "wall"),
        "inlet": "fixed", "outlet": "open"})
    case.runTo(4.0)
    return case


# Mach 10 at a ramp of 30 degrees: double Mach reflection. rho = 1.4, c = 1
DOUBLE_MACH = 10.0
RAMP = np.radians(30)
DOUBLE_TIME = 0.2  # since the shock was at the corner


def doubleMach(folder, n):
    """A shock that runs into gas at rest, up a ramp; the wall, the shock's
    direction and the time are those of the source, the frame is not tilted.

    source: P. Woodward and P. Colella, J. Comput. Phys. 54 (1984) 115;
    behind the shock rho = 8, p = 116.5, u = 8.25
    """
    start = 0.1
    case = BenchmarkCase(folder, rampMesh(RAMP, n, 0.3, 2.5, 2.2))

    def state(x):
        behind = x[:, 0] < -start
        return [np.where(behind, a, b)
                for a, b in ((8.0, 1.4), (8.25, 0.0), (116.5, 1.0))]

    case.start(state, {**FLOOR, "inlet": "fixed", "outlet": "open"})
    case.runTo(DOUBLE_TIME + start / DOUBLE_MACH)
    return case
