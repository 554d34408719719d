"""Steps that are adjusted to the write times are not longer than wanted."""
import re
import sys
from pathlib import Path

import numpy as np
import pytest

sys.path.insert(0, str(Path(__file__).parents[1] / "gasBenchmarks"))

from benchmarkCase import BenchmarkCase  # noqa: E402
from blockMeshes import box  # noqa: E402

MAX_CO = 0.5


@pytest.mark.parametrize("interval", [0.0253, 0.03, 0.1])
def test_gasTakesOneStepPerTimeStep(tmp_path, interval):
    """Rounding their number down would make some steps a few per cent longer
    than the Courant number allows, and the gas would halve these."""
    case = BenchmarkCase(tmp_path / "case", box([(1, 100)]))
    case.start(
        lambda x: (np.ones(len(x)), 0.0, np.where(x[:, 0] < 0.5, 1.5, 1.0)),
        {"left": "wall", "right": "wall"})
    case.runTo(0.3, maxCo=MAX_CO, writeInterval=interval)
    steps = [(int(n), float(share)) for n, share in re.findall(
        r"Gas: (\d+) step\(s\), (\S+) of the stable step", case.log)]
    assert len(steps) > 60
    assert {n for n, _ in steps} == {1}
    shares = [share for _, share in steps]
    assert max(shares) <= MAX_CO * (1 + 1e-6)
    assert np.mean(shares) > 0.85 * MAX_CO

    # The writes are at their times
    times = sorted(float(t) for t in case.times() if float(t) > 0)
    expected = interval * np.arange(1, len(times) + 1)
    assert times[:-1] == pytest.approx(list(expected[:-1]), abs=1e-9)
