"""Gas in front of a moving wall, through the application with its motion
solvers."""
import shutil

import numpy as np
import pytest

from gasBox import GAMMA
from pistonBox import PistonBox

C = np.sqrt(GAMMA)  # rho = p = 1
CELLS = (24, 12)
TWO = "timeScheme twoStep; shockCapturing pressureLaplacian;"
THREE = "timeScheme threeStep; shockCapturing pressureLaplacian;"


def oscillating(amplitude, omega):
    return (f"type oscillatingDisplacement; amplitude ({amplitude} 0 0);"
            f" omega {omega};")


@pytest.mark.parametrize("motionSolver", [
    "inverseDistance", "displacementLaplacian",
])
@pytest.mark.parametrize("schemes", [TWO, THREE], ids=["twoStep", "threeStep"])
def test_massStays(tmp_path, schemes, motionSolver):
    """A piston that goes to and fro at up to a quarter of the speed of sound.
    The mass of the fields on disk is the same at all times."""
    period = 2.5
    case = PistonBox(
        tmp_path / "case", CELLS,
        oscillating(0.12, 2 * np.pi / period), motionSolver,
    )
    case.schemes(schemes)
    case.start(np.ones(len(case.x)), (0, 0, 0), 1.0)
    assert case.runTo(1.5, writeInterval=0.25) == 0, case.log[-2000:]

    times = case.times()[1:]
    assert len(times) == 6
    masses = np.array([case.mass(time, CELLS) for time in times])
    print(masses / masses[0] - 1)
    assert abs(masses / masses[0] - 1).max() <= 1e-12

    # The gas constant of the case and of this test agree to 1e-5
    assert abs(masses[0] - 1) < 1e-5

    # It did move, and compress
    moved = [case.points(time)[:, 0].min() for time in times]
    assert max(moved) > 0.1 and min(moved) < -0.05
    assert np.ptp(case.result("p")) > 0.05


def test_slowCompressionIsIsentropic(tmp_path):
    """A quarter of a period of 12 passages of sound: the piston ends at rest,
    and p V^gamma is what it was. The waves that its start at M = 0.01 sends
    out are up to gamma M = 1.5 % of the pressure, and come back."""
    end, stroke = 12 / C, 0.08
    case = PistonBox(
        tmp_path / "case", CELLS,
        oscillating(stroke, np.pi / 2 / end), "inverseDistance",
    )
    case.schemes(TWO)
    case.start(np.ones(len(case.x)), (0, 0, 0), 1.0)
    assert case.runTo(end) == 0, case.log[-2000:]
    p = case.result("p")
    expected = (1 - stroke)**-GAMMA
    print(p.min() / expected, p.mean() / expected, p.max() / expected)
    assert abs(p.mean() / expected - 1) < 0.01
    assert abs(p / expected - 1).max() < 0.03


# source: moving piston, exact: W = up (g+1)/4 + sqrt((up (g+1)/4)^2 + c^2),
# p/p0 = 1 + g up W/c^2; pulled: p/p0 = (1 - (g-1)/2 |up|/c)^(2g/(g-1))
IMPULSIVE = {0.2: 1.315609, 0.5: 1.940821, -0.2: 0.7514475}


@pytest.mark.parametrize("schemes", [TWO, THREE], ids=["twoStep", "threeStep"])
@pytest.mark.parametrize("speed", IMPULSIVE)
def test_impulsivePiston(tmp_path, speed, schemes):
    """A piston that is pushed, or pulled, at once: pressure on it."""
    end = 0.4 / C
    case = PistonBox(
        tmp_path / "case", (200,),
        "type uniformFixedValue; uniformValue table"
        f" ((0 (0 0 0)) (1 ({speed * C} 0 0)));",
        "inverseDistance",
    )
    case.schemes(schemes)
    case.start(np.ones(len(case.x)), (0, 0, 0), 1.0)
    assert case.runTo(end) == 0, case.log[-2000:]

    x, p = case.points(case.times()[-1])[:, 0], case.result("p")
    assert abs(x.min() - speed * 0.4) < 1e-6
    near = x < x.min() + 0.08
    print(p[near].min(), p[near].mean(), p[near].max())
    assert abs(p[near].mean() / IMPULSIVE[speed] - 1) < 0.01
    assert abs(case.result("U")[near][:, 0].mean() / (speed * C) - 1) < 0.02


@pytest.mark.parametrize("adjust", ["no", "yes"])
def test_restartIsTheSameRun(tmp_path, adjust):
    """At full write precision, to rounding: viscosity and stable step are
    those of the mesh at rest after a write, and the walls keep their speed."""
    case = PistonBox(
        tmp_path / "case", CELLS, oscillating(0.12, 2.5), "inverseDistance")
    case.schemes(TWO)
    case.start(np.ones(len(case.x)), (0, 0, 0), 1.0)
    case.set("system/controlDict", "writePrecision", "17")
    assert case.runTo(0.5, writeInterval=0.25, adjustTimeStep=adjust,
                      deltaT=0.005) == 0
    names = ("p", "U", "T", "rho")
    whole = [case.pointField(name, "0.5") for name in names]
    points = case.points("0.5")
    shutil.rmtree(case.path / "0.5")

    case.set("system/controlDict", "startFrom", "latestTime")
    log = case.run("shockShellFoam")
    assert 0 < log.count("\nTime = ") < case.log.count("\nTime = ")
    np.testing.assert_allclose(case.points("0.5"), points, rtol=0, atol=1e-14)
    assert points[:, 0].min() > 0.05
    for name, wanted in zip(names, whole):
        error = abs(case.pointField(name, "0.5") - wanted).max()
        print(name, error)
        assert error <= 1e-12 * abs(wanted).max()
