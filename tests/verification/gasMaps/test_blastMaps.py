"""The function object blastMaps: peaks, arrivals and impulses of a blast in a
tube, against the same quantities from histories at some of its nodes."""
import csv
import sys
from pathlib import Path

import numpy as np
import pytest

sys.path.insert(0, str(Path(__file__).parents[1] / "gasBenchmarks"))

from benchmarkCase import BenchmarkCase  # noqa: E402
from blockMeshes import box  # noqa: E402
from foamCase import RunFailed  # noqa: E402
from foamFile import readHistory  # noqa: E402

CELLS, END, DELTA_T = 80, 0.6, 5e-3
THRESHOLD = 0.02
FIELDS = ("peakOverpressure", "arrivalTime", "positiveImpulse",
          "positiveDuration", "impulseSinceArrival")
# In the dip, where the wave passes, and not reached
PLACES = (0.1, 0.5, 0.7, 1.0, 2.0)

FUNCTIONS = """{{
    blast {{ type blastMaps; libs (shockShellFunctionObjects); ambient {ambient};
        threshold {threshold}; {more} writeControl writeTime; }}
    places {{ type pointProbes; libs (shockShellFunctionObjects);
        points ({points}); fields (p); }}
}}"""


def charge(x):
    """A bump of pressure, and behind it gas below the ambient pressure."""
    bump = np.exp(-((x[:, 0] - 0.3) / 0.08)**2)
    dip = np.exp(-(x[:, 0] / 0.15)**2)
    return 1 + 0.5 * bump - 0.2 * dip, 0.0, 1 + 2 * bump - 0.6 * dip


def tube(folder, **more):
    case = BenchmarkCase(folder, box([(2, CELLS)]))
    case.start(charge, {"left": "wall", "right": "wall"})
    case.more = {"ambient": 1, "threshold": THRESHOLD, "more": "", **more}
    return case


def run(case, end=END, **control):
    points = " ".join(f"({x} 0.5 0.5)" for x in PLACES)
    case.runTo(end, functions=FUNCTIONS.format(points=points, **case.more),
               adjustTimeStep="no", deltaT=DELTA_T, writePrecision=17,
               **control)


def expected(times, p):
    """The fields' values from a history of the overpressure."""
    over = p - 1
    peak = max(over.max(), 0)
    above = np.flatnonzero(over >= THRESHOLD)
    above = above[above > 0]
    if not len(above):
        return peak, -1, 0, 0, 0
    k = above[0]
    rise = over[k] - over[k - 1]
    part = min((over[k] - THRESHOLD) / rise, 1) if rise > 0 else 1
    arrival = times[k] - part * (times[k] - times[k - 1])
    # With the point of the arrival as a sample
    t = np.concatenate([[arrival], times[k:]])
    f = np.concatenate([[over[k] - part * rise], over[k:]])
    running = np.concatenate(
        [[0], np.cumsum(0.5 * np.diff(t) * (f[1:] + f[:-1]))])
    best = running.argmax()
    return (peak, arrival, running[best], t[best] - arrival, running[-1])


def atPlaces(case):
    nodes = [np.argmin(abs(case.x[:, 0] - place)) for place in PLACES]
    return np.array([case.result(name)[nodes] for name in FIELDS]).T


@pytest.fixture(scope="module")
def straight(tmp_path_factory):
    case = tube(tmp_path_factory.mktemp("maps") / "straight")
    run(case)
    return case


def test_mapsAgreeWithHistories(straight):
    _, history = readHistory(
        straight.path / "postProcessing" / "places" / "0" / "p.dat")
    start = straight.primitive(charge, np.array([[x, 0, 0] for x in PLACES]))
    times = np.concatenate([[0], history[:, 0]])
    values = np.vstack([start["p"], history[:, 1:]])
    maps = atPlaces(straight)
    for i, found in enumerate(maps):
        wanted = expected(times, values[:, i])
        # The histories have ten digits
        assert np.allclose(found, wanted, rtol=1e-7, atol=1e-9), PLACES[i]
    # The wave has left gas of low pressure at the third place; nothing has
    # come to the last
    assert maps[2, 0] > 0.1 and maps[-1, 1] == -1 and maps[-1, 2] == 0
    assert 0 < maps[2, 3] < END - maps[2, 1] - 0.02
    assert maps[2, 4] < maps[2, 2]


def test_summaryHasTheLargest(straight):
    with open(straight.path / "postProcessing" / "blast" / "0"
              / "blastMaps.csv") as file:
        rows = {row["part"]: row for row in csv.DictReader(file)}
    assert set(rows) == {"gas", "left", "right"}
    peaks = straight.result("peakOverpressure")
    gas = rows["gas"]
    assert float(gas["peak overpressure [Pa]"]) == pytest.approx(
        peaks.max(), rel=1e-9)
    assert float(gas["x [m]"]) == pytest.approx(
        straight.x[peaks.argmax(), 0], abs=1e-9)
    assert float(rows["left"]["positive impulse [Pa s]"]) == pytest.approx(
        straight.result("positiveImpulse")[0], rel=1e-9)
    assert float(rows["right"]["first arrival [s]"]) == -1


def test_restartContinues(straight, tmp_path):
    case = tube(tmp_path / "restart")
    run(case, END / 2)
    run(case, END, startFrom="latestTime")
    assert (case.path / "postProcessing" / "blast" / str(END / 2)).is_dir()
    assert np.allclose(atPlaces(case), atPlaces(straight), rtol=1e-9,
                       atol=1e-12)


def test_severalProcessors(straight, tmp_path):
    case = tube(tmp_path / "parallel")
    case.write("system/decomposeParDict",
               "numberOfSubdomains 2; method simple;\n"
               "simpleCoeffs { n (2 1 1); delta 0.001; }\n")
    run(case)  # for its controlDict
    for time in case.times():
        if time != "0":
            case.run("rm", "-r", time)
    case.run("decomposePar")
    case.run("mpirun", "--allow-run-as-root", "--oversubscribe", "-np", "2",
             "shockShellFoam", "-parallel")
    case.run("reconstructPar", "-latestTime")
    assert np.allclose(atPlaces(case), atPlaces(straight), rtol=1e-9,
                       atol=1e-12)


@pytest.mark.parametrize("more, words", [
    ({"ambient": -1}, "must be positive"),
    ({"threshold": 0}, "must be positive"),
    ({"more": "field rho0;"}, "there is no pointScalarField rho0"),
])
def test_wrongEntriesStop(tmp_path, more, words):
    case = tube(tmp_path / "wrong", **more)
    with pytest.raises(RunFailed, match=words):
        run(case, 0.01)
