"""Sound in gas that flows at a third of its speed, on a mesh at rest and
without artificial viscosity."""
import numpy as np

from gasBox import GAMMA, GasBox

AMPLITUDE = 1e-6
C = np.sqrt(GAMMA)  # rho = p = 1
MACH = 0.3


def deviation(folder, cells, schemes="timeScheme twoStep;"):
    """Largest difference from the pulse carried along at u + c, over it."""
    case = GasBox(folder, (2,), (cells,))
    case.schemes(schemes + " shockCapturing none;")

    def pulse(x):
        return AMPLITUDE * np.exp(-((x - 0.4) / 0.08)**2)

    x = case.x[:, 0]
    s = pulse(x)
    U = (MACH * C + C * s / GAMMA)[:, None] * [1, 0, 0]
    case.start(1 + s / GAMMA, U, 1 + s)
    end = 1.2 / (C * (1 + MACH))
    dt = 0.5 * 2 / cells / (C * (1 + MACH))
    assert case.runTo(
        f"{end:.15g}", deltaT=f"{dt:.15g}", adjustTimeStep="no",
    ) == 0, case.log[-2000:]
    rise = case.result("p") - 1
    return abs(rise - pulse(x - 1.2)).max() / AMPLITUDE


def test_soundCarriedByTheFlow(tmp_path):
    coarse = deviation(tmp_path / "coarse", 200)
    fine = deviation(tmp_path / "fine", 400)
    print(coarse, fine)
    assert fine < 0.05
    assert coarse / fine > 3.5
