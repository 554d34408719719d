"""Smooth flow: order of accuracy, sound over many periods."""
import numpy as np
import pytest

from benchmarkCase import BenchmarkCase
from blockMeshes import box
from errorNorms import l2, orders, weights1D
from exactSolutions import vortex

C = np.sqrt(1.4)  # rho = p = 1

# Isentropic vortex on a square of side 10. It is in the middle half way, and
# at the boundary at all times below 1e-4: the far state is prescribed there
SIDE = 10.0
END = 0.5
ORDER = 1.8
# With the limiter, which cuts moving extrema in part: less error than without
# on the coarsest mesh, more on the others; bounds from own runs
CAPTURED = 0.0016, 0.0008, 0.0005


@pytest.mark.parametrize("capturing", [False, True],
                         ids=["none", "capturing"])
def test_vortex(tmp_path, table, capturing):
    numbers = (32, 64, 128)
    centre = (SIDE - END) / 2, (SIDE - END) / 2

    def far(x):
        return np.ones(len(x)), np.tile([1.0, 1.0, 0.0], (len(x), 1)), 1.0

    errors, seconds = [], []
    for n in numbers:
        case = BenchmarkCase(tmp_path / str(n), box([(SIDE, n)], (SIDE, n)),
                             capturing=capturing)
        case.start(lambda x: vortex(x, 0, centre),
                   dict.fromkeys(("left", "right", "bottom", "top"), "far"),
                   far)
        case.runTo(END)
        exact = vortex(case.x, END, centre)[0]
        errors.append(l2(case.result("rho") - exact))
        seconds.append(case.seconds)
    table.add("isentropic vortex", "32 64 128 ^2 quadrilaterals", "L2 of rho",
              errors, "exact", list(CAPTURED) if capturing else "",
              orders(errors, numbers), seconds, capturing=capturing)
    if capturing:
        assert all(e < bound for e, bound in zip(errors, CAPTURED))
    else:
        assert orders(errors, numbers)[-1] > ORDER


@pytest.mark.long
def test_vortexOnceAcross(tmp_path, table):
    """Cyclic square, back to the start after t = 10."""
    numbers = (64, 128, 256)
    errors, seconds = [], []
    for n in numbers:
        mesh = box([(SIDE, n)], (SIDE, n)).cyclic("left", "right")
        case = BenchmarkCase(tmp_path / str(n), mesh.cyclic("bottom", "top"),
                             capturing=True)
        case.start(lambda x: vortex(x, 0), {})
        case.runTo(SIDE, timeout=1800)
        errors.append(l2(case.result("rho") - vortex(case.x, 0)[0]))
        seconds.append(case.seconds)
    table.add("isentropic vortex, once across", "64 128 256 ^2, cyclic",
              "L2 of rho", errors, "exact", "", orders(errors, numbers),
              seconds)
    assert orders(errors, numbers)[-1] > CAPTURED_ORDER


# Standing sound wave of one length in a closed tube, without shock capturing:
# error of amplitude (over it) and of phase [rad] after PERIODS. Nonlinear
# effects are of the size of the amplitude times the number of radians
AMPLITUDE = 1e-7
SOUND_ORDER = 1.9


def soundWave(folder, lines, periods):
    """Relative amplitude and phase after whole periods."""
    k = 2 * np.pi
    case = BenchmarkCase(folder, box([(1, lines)]), capturing=False)

    def state(x):
        s = AMPLITUDE * np.cos(k * x[:, 0])
        return 1 + s / 1.4, 0.0, 1 + s

    case.start(state, {"left": "wall", "right": "wall"})
    end = periods / C
    steps = int(np.ceil(end * C * lines / 0.5))
    case.runTo(end, deltaT=end / steps, adjustTimeStep="no", timeout=900)
    x = case.x[:, 0]
    w = 2 * weights1D(x)
    cosine = (w * (case.result("p") - 1) * np.cos(k * x)).sum()
    sine = (w * case.result("U")[:, 0] * np.sin(k * x)).sum() * 1.4 / C
    turned = np.angle(complex(cosine, -sine))
    return case, np.hypot(cosine, sine) / AMPLITUDE, turned


def checkSound(tmp_path, table, numbers, periods, amplitude, phase):
    """amplitude, phase: bounds of the errors on the last mesh."""
    losses, phases, seconds = [], [], []
    for n in numbers:
        case, a, angle = soundWave(tmp_path / str(n), n, periods)
        losses.append(abs(1 - a))
        phases.append(abs(angle))
        seconds.append(case.seconds)
    name = f"standing sound wave, {periods} periods"
    mesh = " ".join(map(str, numbers)) + " lines"
    table.add(name, mesh, "loss of amplitude", losses, "0",
              f"last {amplitude}", orders(losses, numbers), seconds,
              capturing=False)
    table.add(name, mesh, "error of phase [rad]", phases, "0",
              f"last {phase}", orders(phases, numbers), capturing=False)
    assert losses[-1] < amplitude and phases[-1] < phase
    assert len(numbers) == 1 or orders(phases, numbers)[-1] > SOUND_ORDER


def test_sound(tmp_path, table):
    checkSound(tmp_path, table, (25, 50, 100), 10, 0.02, 0.05)


@pytest.mark.parametrize("numbers, amplitude, phase", [
    ((100,), 0.1, 2.0),
    pytest.param((100, 200), 0.02, 0.5, marks=pytest.mark.long),
], ids=["100", "100 and 200"])
def test_soundOver100000Steps(tmp_path, table, numbers, amplitude, phase):
    """500 periods, 1e5 steps on 100 elements. Coarser meshes would lose whole
    periods."""
    checkSound(tmp_path, table, numbers, 500, amplitude, phase)
