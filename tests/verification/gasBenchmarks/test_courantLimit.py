"""Small noise at the Courant number that each scheme says it is stable up to,
section 5.4 of doc/theory/gas.md: on a cyclic line, in gas at rest and in flow.
A wave that the scheme amplifies would have grown by orders of magnitude."""
import re

import numpy as np
import pytest

from benchmarkCase import BenchmarkCase
from blockMeshes import box
from foamCase import RunFailed
from scheme import COMBINATIONS, entries

CELLS = 100
STEPS = 1200
NOISE = 1e-6
C = np.sqrt(1.4)


def noisyLine(folder, scheme, mach):
    case = BenchmarkCase(
        folder, box([(1, CELLS)]).cyclic("left", "right"), capturing=False)
    case.write("system/feSchemes", scheme)
    random = np.random.default_rng(1)

    def state(x):
        noise = NOISE * (random.random((3, len(x))) - 0.5)
        return 1 + noise[0], mach * C + noise[1], 1 + noise[2]

    case.start(state, {})
    return case


def size(case, time=None):
    """Root mean square of the waves of pressure and velocity."""
    p, u = (case.result(name, time) for name in ("p", "U"))
    u = u[:, 0] if u.ndim > 1 else u
    return np.sqrt(np.mean(((p - p.mean()) / C)**2 + (u - u.mean())**2))


def growth(folder, scheme, mach, limit):
    """Of noise, in steps at the limit, which the log must have named."""
    case = noisyLine(folder, scheme, mach)
    case.runTo(STEPS * limit / CELLS / (C * (1 + mach)), maxCo=limit)
    said = re.search(r"stable up to Courant number (\S+)", case.log)
    assert float(said.group(1)) == pytest.approx(limit, rel=1e-4)
    return size(case) / size(case, "0")


def limitOf(scheme):
    """(G82), and what the log says with flux correction"""
    _, capturing, mass = scheme
    if mass != "consistent":
        return 1
    return 0.95 if capturing == "fluxCorrected" else 0.57735


@pytest.mark.parametrize(
    "scheme", COMBINATIONS, ids=lambda s: "-".join(filter(None, s)))
def test_noiseDoesNotGrowAtTheLimit(tmp_path, scheme):
    # threeStep says that it is for gas at rest
    for mach in (0, 0.5, 1.5) if scheme[0] == "twoStep" else (0,):
        found = growth(tmp_path / str(mach), entries(*scheme), mach,
                       limitOf(scheme))
        # threeStep keeps p^2 + v^2 - sigma p v, which is within 1 +- 1/2 of it
        assert found < (1.01 if scheme[0] == "twoStep" else np.sqrt(3))


def test_moreMassIterations(tmp_path):
    scheme = "timeScheme twoStep; shockCapturing none;" \
        "twoStepCoeffs { massMatrix consistent; massIterations 3; }"
    assert growth(tmp_path / "at", scheme, 0.5, 0.57735) < 1.01


def test_beyondTheLimit(tmp_path):
    """Where the consistent mass is not stable, the test above can tell, and
    the run is refused."""
    scheme = entries("twoStep", "none", "consistent")
    case = noisyLine(tmp_path / "case", scheme, 0)
    dt = 1 / CELLS / C
    with pytest.raises(RunFailed, match="no longer in a physical state"):
        case.runTo(STEPS * dt, adjustTimeStep="no", deltaT=dt)

    refused = noisyLine(tmp_path / "refused", scheme, 0)
    refused.control({"stopAt": "endTime", "endTime": 1, "deltaT": dt,
                     "writeInterval": 1, "maxCo": 0.8,
                     "adjustTimeStep": "yes"})
    log = refused.run("shockShellFoam", check=False)
    assert "maxCo is 0.8, but must be in (0, 0.577" in log
