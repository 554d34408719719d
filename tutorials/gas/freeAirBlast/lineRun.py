"""Blast along one radius: runs on spherical lines, each mapped to the next.

A stage is a line that is fine where the wave is. The next one starts from the
profile at half of the stage's time, so that both see the waves of the stations
between them whole.
"""
import math
import shutil
import sys
from dataclasses import dataclass
from pathlib import Path

import numpy as np

HERE = Path(__file__).resolve().parent
PROJECT = HERE.parents[2]
sys.path.insert(0, str(PROJECT / "tests" / "tools"))

from foamCase import FoamCase  # noqa: E402

MAPPED = """mappedProfile
    {{
        geometry    spherical;
        centre      (0 0 0);
        case        "{case}";
        time        {time};
    }}"""
FIELDS = ("peakOverpressure", "arrivalTime", "positiveImpulse")


class LineCase(FoamCase):
    """A copy of this tutorial's case without the runs in it."""

    def __init__(self, folder):
        self.path = folder
        for part, copy in (("constant", "constant"), ("system", "system"),
                           ("0.orig", "0")):
            shutil.copytree(HERE / part, folder / copy)


@dataclass(frozen=True)
class Line:
    """length and spacing [m]; within core [m] the cells are coarser by the
    factor coarser, and become finer up to fine [m]: hot gas is left behind
    there, whose sound speed would set the step."""
    length: float
    spacing: float
    core: float = 0.0
    coarser: float = 1.0
    fine: float = 0.0

    def refined(self, factor):
        return Line(self.length, self.spacing/factor, self.core, self.coarser,
                    self.fine)

    def parts(self):
        """(length, cells, expansion) of each part from the centre."""
        if self.coarser == 1:
            return [(self.length, round(self.length/self.spacing), 1.0)]
        middle = self.fine - self.core
        cells, span = 1, 0.0
        while span < middle:
            cells += 1
            ratio = self.coarser**(-1/(cells - 1))
            span = self.coarser*self.spacing*(1 - ratio**cells)/(1 - ratio)
        outer = self.length - self.fine
        return [
            (self.core, max(1, round(self.core/self.coarser/self.spacing)),
             1.0),
            (middle, cells, 1/self.coarser),
            (outer, round(outer/self.spacing), 1.0),
        ]

    def entries(self):
        parts = self.parts()
        cells = sum(n for _, n, _ in parts)
        grading = " ".join(
            f"({a/self.length:.15g} {n/cells:.15g} {g:.15g})"
            for a, n, g in parts)
        return (f"length {self.length};\ncells {cells};\n"
                f"grading ({grading});\n")


@dataclass(frozen=True)
class Stage:
    """time [s]: when the next stage takes over; this one runs twice as long.
    stations: between these radii [m]."""
    line: Line
    time: float
    stations: tuple


@dataclass(frozen=True)
class Air:
    p: float = 101325.0     # Pa
    T: float = 288.15       # K

    @property
    def c(self):
        """Speed of sound in the case's air, R = 287, gamma = 1.4."""
        return math.sqrt(1.4*287*self.T)

    @property
    def rho(self):
        return self.p/(287*self.T)


class Stations:
    """What was seen at radii r: peak [Pa], arrival [s], impulse [Pa s]."""

    def __init__(self, r, peak, arrival, impulse):
        order = np.argsort(r)
        self.r = r[order]
        self.values = {"peak": peak[order], "arrival": arrival[order],
                       "impulse": impulse[order]}

    def at(self, what, r):
        """Interpolated in the logarithms."""
        r = np.asarray(r, float)
        if r.min() < self.r[0] or r.max() > self.r[-1]:
            raise ValueError(
                f"no stations from {r.min()} to {r.max()} m, but from "
                f"{self.r[0]} to {self.r[-1]} m")
        return np.exp(np.interp(np.log(r), np.log(self.r),
                                np.log(self.values[what])))


def write(case, line, air, time, state):
    def put(name, text):
        file = case.path / "system" / name
        head = file.read_text().split("// * *")[0]
        file.write_text(f"{head}\n{text}\n")

    put("stageDict", line.entries()
        + f"pAmbient {air.p!r};\nTAmbient {air.T!r};\n"
        + f"endTime {2*time:.12g};\nwriteInterval {time:.12g};\n")
    put("setPointFieldsDict", f"states\n(\n    {state}\n);")


def nodes(case):
    """Points of the line's nodes in the order of their radius, and the radii."""
    r = np.linalg.norm(case.points(), axis=1)
    order = np.argsort(r, kind="stable")
    first = np.concatenate([[True], np.diff(r[order]) > 1e-9*r.max()])
    return order[first], r[order][first]


def runStages(folder, air, charge, stages, factor=1):
    """Runs in folder/0, 1, ... on lines refined by factor; the Stations."""
    folder = folder.resolve()
    shutil.rmtree(folder, ignore_errors=True)
    state, start, found = charge, 0.0, []
    for i, stage in enumerate(stages):
        case = LineCase(folder / str(i))
        write(case, stage.line.refined(factor), air, stage.time, state)
        for program in ("blockMesh", "setPointFields", "shockShellFoam"):
            case.run(program, timeout=600)
        place, r = nodes(case)
        times = case.times()
        peak, arrival, impulse = (
            case.pointField(name, times[-1])[place] for name in FIELDS)
        low, high = stage.stations
        seen = (r >= low) & (r <= high) & (arrival > 0)
        found.append([r[seen], peak[seen], arrival[seen] + start,
                      impulse[seen]])
        state = MAPPED.format(case=case.path, time=times[-2])
        start += stage.time
    return Stations(*(np.concatenate(part) for part in zip(*found)))
