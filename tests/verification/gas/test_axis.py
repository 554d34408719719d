"""The axis of wedge scenes: no gas goes through it, and it is no wall."""
import sys
from pathlib import Path

import numpy as np
import pytest

sys.path.insert(0, str(Path(__file__).parents[1] / "gasBenchmarks"))

from benchmarkCase import BenchmarkCase  # noqa: E402
from blockMeshes import axisymmetric, wedge  # noqa: E402

# Mesh, and the direction of the radius
SCENES = {
    "cylinder": (wedge(1, 40, 1), 0),
    "sphere": (wedge(1, 40, 2), 0),
    "axisymmetric": (axisymmetric(1, 1, (20, 40)), 1),
}
SPEED = 0.3
END = 0.1


@pytest.mark.parametrize("scene", SCENES)
def test_gasComesToTheAxis(tmp_path, scene):
    """Gas that is flung at the axis all round: it stops there, and compresses
    more than at a wall. Along the axis it flows on."""
    mesh, radial = SCENES[scene]
    case = BenchmarkCase(tmp_path / "case", mesh)
    velocity = np.zeros(3)
    velocity[radial] = -SPEED
    velocity[1 - radial] = SPEED if scene == "axisymmetric" else 0

    def state(x):
        return np.ones(len(x)), np.tile(velocity, (len(x), 1)), 1.0

    case.start(state, {"left": "open", "right": "open", "top": "open"})
    case.runTo(END)
    U, p = case.result("U"), case.result("p")
    r = case.x[:, radial]
    axis = r == 0
    assert axis.sum() == (21 if scene == "axisymmetric" else 1)
    assert (U[axis][:, radial] == 0).all()
    # Half way the gas has not heard of the axis yet
    far = (r > 0.45) & (r < 0.55)
    assert (U[far][:, radial] < -0.8 * SPEED).all()

    # source: p behind the shock that stops gas at a plane wall (normal shock
    # relations): W = up (g+1)/4 + sqrt((up (g+1)/4)^2 + c^2), p = 1 + up W
    half = SPEED * 2.4 / 4
    wall = 1 + SPEED * (half + np.hypot(half, np.sqrt(1.4)))
    assert (p[axis] > wall).all()
    if scene == "axisymmetric":
        inside = axis & (case.x[:, 0] > 0.2) & (case.x[:, 0] < 0.8)
        assert abs(U[inside][:, 0] - SPEED).max() < 0.05 * SPEED
