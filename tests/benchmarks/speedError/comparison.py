"""Runs one problem on one mesh with both codes."""
import shutil
from dataclasses import dataclass, field

import numpy as np

from benchmarkCase import BenchmarkCase
from controlVolumes import ControlVolumes
from peerCase import PeerCase
from problems import GAMMA
from runLog import RunLog, middle
from scheme import TIME_SCHEME, entries

OURS, PEER = "shockShellFoam", "rhoCentralFoam"


@dataclass
class Run:
    code: str
    size: int
    unknowns: int          # nodes or cells
    steps: int
    seconds: float         # processor time of the time loop
    errors: dict = field(default_factory=dict)

    @property
    def perStep(self):
        """Microseconds per node or cell and step."""
        return 1e6 * self.seconds / self.steps / self.unknowns


def conserved(state):
    rho, U, p = state
    energy = p / (GAMMA - 1) + 0.5 * rho * (U**2).sum(axis=1)
    return np.vstack([rho, rho * U.T, energy])


def primitive(means):
    """p, U, T and rho of the means of the conserved variables."""
    rho, U = means[0], (means[1:4] / means[0]).T
    p = (GAMMA - 1) * (means[4] - 0.5 * rho * (U**2).sum(axis=1))
    return {"p": p, "U": U, "T": p / rho, "rho": rho}


def errors(problem, volumes, exact, values):
    """Mean over the volume of |error| of each compared quantity, scaled."""
    ours = problem.results(**values)
    return {
        name: np.average(abs(ours[name] - reference), weights=volumes) / scale
        for name, scale, reference in zip(
            problem.quantities, problem.scales, exact)
    }


class Comparison:
    """One mesh. Both codes start from the means of the initial state over
    their control volumes and are compared with those of the exact one."""

    def __init__(self, problem, size, folder, options):
        """options: with repeat, and capturing and maxCo of ours."""
        self.problem, self.size, self.options = problem, size, options
        self.case = BenchmarkCase(folder / OURS, problem.mesh(size), GAMMA)
        self.case.write("system/feSchemes", entries(
            TIME_SCHEME, options.capturing))
        self.folder = folder
        self.volumes = ControlVolumes(
            self.case.x, self.case.mesh.cells, problem.plane)
        means = self.volumes.means(lambda x: conserved(problem.initial(x)))
        self.initial = [primitive(m) for m in means]
        self.exact = self.volumes.means(problem.exact)

    def gauges(self, points, kind):
        """Entries of controlDict; the places."""
        if not self.problem.gauges:
            return {}, None
        places = self.problem.gauges(points)
        library = {"pointProbes": "(shockShellFunctionObjects)",
                   "probes": "(sampling)"}[kind]
        listed = {
            "pointProbes": "points", "probes": "probeLocations"}[kind]
        text = " ".join("(%.12g %.12g %.12g)" % tuple(x) for x in places)
        return {"functions": f"{{ gauges {{ type {kind}; libs {library};"
                f" fields (p); {listed} ({text}); }} }}"}, places

    def measured(self, run):
        """The run of median time; run: does one, returns its log."""
        return middle([run() for _ in range(self.options.repeat)])

    def ours(self):
        values, case = self.initial[0], self.case
        copies = len(case.allPoints) // len(case.x)

        def everywhere(name):
            value = values[name]
            return np.concatenate([value] * copies)

        case.start(lambda x: [everywhere(n) for n in ("rho", "U", "p")],
                   self.problem.boundary)
        control, places = self.gauges(case.x, "pointProbes")

        def run():
            case.runTo(self.problem.end, timeout=7200,
                       maxCo=self.options.maxCo, **control)
            return RunLog(case.log)

        log = self.measured(run)
        run = self.finish(
            OURS, log, self.volumes.nodes, self.exact[0],
            {n: case.result(n) for n in ("rho", "U", "p")},
            places, case, "gauges/0/p.dat")
        run.errors["rhoAtNodes"] = run.errors["rho"]
        return run

    def peer(self):
        case = PeerCase(self.folder / PEER, self.case)
        values = self.initial[1]
        case.start({n: values[n] for n in "pUT"}, self.problem.boundary)
        centres = self.volumes.points[self.volumes.cells].mean(axis=1)
        control, places = self.gauges(centres, "probes")

        def run():
            case.runTo(self.problem.end, **control)
            return case.runLog

        log = self.measured(run)
        p, T = case.cellField("p"), case.cellField("T")
        run = self.finish(
            PEER, log, self.volumes.cellVolumes, self.exact[1],
            {"rho": p / T, "U": case.cellField("U"), "p": p},
            places, case, "gauges/0/p")
        # Where ours is measured
        atNodes = self.volumes.fromCells(p / T)
        run.errors["rhoAtNodes"] = np.average(
            abs(atNodes - self.exact[0][0]), weights=self.volumes.nodes
        ) / self.problem.scales[0]
        return run

    def finish(self, code, log, volumes, exact, values, places, case, file):
        found = errors(self.problem, volumes, exact, values)
        if places is not None:
            _, rows = case.history(file)
            found["peak"] = self.problem.peakError(
                places, rows[:, 1:].max(axis=0))
        shutil.rmtree(case.path)
        return Run(code, self.size, len(volumes), log.steps, log.seconds,
                   found)
