"""A shock that a closed wall sends back."""
import numpy as np
import pytest

from gasBox import GAMMA, GasBox

C = np.sqrt(GAMMA)  # rho = p = 1
START = 0.6  # the shock, in a tube of length 1 with the wall at x = 1

# source: Rankine-Hugoniot for gamma 1.4: p2/p1, rho2/rho1, u2/c1, p5/p1, and
# the reflected shock's speed over c1
SHOCKS = {
    1.21: (1.54145, 1.358983, 0.3196281, 2.316145, 0.9542975),
    2: (4.5, 2.666667, 1.25, 15, 1.0),
}
SCHEMES = {
    "twoStep": "timeScheme twoStep; shockCapturing pressureLaplacian;"
               " pressureLaplacianCoeffs { qDif 0.5; }",
    "threeStep": "timeScheme threeStep; shockCapturing pressureLaplacian;"
                 " pressureLaplacianCoeffs { qDif 1; }",
}


@pytest.mark.parametrize("scheme", SCHEMES)
@pytest.mark.parametrize("mach", SHOCKS)
def test_pressureAndPlace(tmp_path, mach, scheme):
    p2, rho2, u2, p5, back = SHOCKS[mach]
    case = GasBox(tmp_path / "case", (1,), (400,), closed=True)
    case.schemes(SCHEMES[scheme])
    x = case.x[:, 0]
    behind = x < START
    case.start(
        np.where(behind, rho2, 1),
        np.where(behind, u2 * C, 0)[:, None] * [1, 0, 0],
        np.where(behind, p2, 1.0),
    )
    arrives = (1 - START) / mach / C
    end = arrives + 0.12 / C
    assert case.runTo(end) == 0, case.log[-2000:]

    p = case.result("p")
    front = 1 - 0.12 * back
    plateau = x > front + 0.03
    print(p[plateau].mean() / p5, p[plateau].min() / p5, p[plateau].max() / p5)
    assert abs(p[plateau].mean() / p5 - 1) < 0.01

    # Where the pressure is half way, on one line of points
    line = np.lexsort((x, case.x[:, 1], case.x[:, 2]))[:401]
    order = line[np.argsort(x[line])]
    near = order[x[order] > front - 0.1]
    place = np.interp((p2 + p5) / 2, p[near], x[near])
    print(place, front)
    assert abs(place - front) < 0.008
