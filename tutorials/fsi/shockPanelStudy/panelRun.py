"""One run of a shock-tube panel: its settings, its case, its results."""
import re
import shutil
import sys
from dataclasses import dataclass
from math import ceil
from pathlib import Path

import numpy as np

HERE = Path(__file__).resolve().parent
PROJECT = HERE.parents[2]
sys.path.insert(0, str(PROJECT / "tests" / "tools"))

from foamCase import FoamCase, RunFailed  # noqa: E402,F401

PROGRAM = "shockShellFoam"
END, STOP = "\nEnd\n", "FOAM FATAL ERROR:"
BASE_HEIGHT = 15       # mm, see the blockMeshDict of the base cases
CELL_OVER_PANEL = 0.5  # mm, the same


def stoppedLate(log):
    """Did the program stop with a message, but after some steps?"""
    return STOP in log and "\nProgress: " in log


def reason(log):
    """What the program says about why it stopped: up to its advice."""
    said = log.split(STOP)[-1].strip()
    first = re.split(r"\n    The run |:?\n *\d|\n\n", said)[0]
    return re.sub(r"\s+", " ", first)


@dataclass(frozen=True)
class Mesh:
    """coarser: cell sizes are this many times those of the base case.
    overPanel: cells over the panel's thickness, times as many as by coarser.
    """
    length: int                 # mm, a base case shockPanel<length> exists
    thickness: float = 1.0      # mm
    coarser: float = 2
    overPanel: int = 1


def coarsened(blockMeshDict, mesh):
    """The text with cells of this size, and a panel of this thickness.

    The panel's front stays at x = 0; what is behind starts later.
    """
    over = round(mesh.thickness/CELL_OVER_PANEL)
    text, places = re.subn(
        r"^(\s*\()1( \d+ [01]\))", rf"\g<1>{mesh.thickness:g}\2",
        blockMeshDict, flags=re.M)

    def cells(match):
        counts = [int(n) for n in match.group(2).split()]
        overPanel = counts[0] == round(1/CELL_OVER_PANEL)
        if overPanel:
            counts[0] = over
        # Rounded up, but not what is whole but for its rounding
        counts = [ceil(n/mesh.coarser - 1e-9) for n in counts[:2]] + counts[2:]
        if overPanel:
            counts[0] *= mesh.overPanel
        return match.group(1) + "(%d %d %d)" % tuple(counts)

    text, blocks = re.subn(
        r"^(\s*hex \([^)]*\) )\(([\d ]+)\)", cells, text, flags=re.M)
    if places != 6 or not blocks:
        raise ValueError(
            f"blockMeshDict of shockPanel{mesh.length}: {places} points at the"
            f" panel's back instead of 6, {blocks} blocks")
    return text


@dataclass(frozen=True)
class Run:
    mesh: Mesh
    scheme: str                 # coupling of couplingProperties
    subCycles: int
    gasStep: float              # us
    integrator: str = "Newmark"
    pRef: float = 0             # Pa, pressure that the shell starts in

    @property
    def variant(self):
        """What differs from the paper's shell, in words for a file's name."""
        return "".join(
            [f"-{self.integrator}" if self.integrator != "Newmark" else "",
             f"-pRef{self.pRef:g}" if self.pRef else ""])

    @property
    def name(self):
        mesh = self.mesh
        return (f"panel{mesh.length}-{mesh.thickness:g}mm-{self.scheme}"
                f"-{self.subCycles}x{self.gasStep:g}us{self.variant}")

    def done(self, folder):
        """Ended, or stopped with a message: that is a result too."""
        text = self.log(folder)
        return END in text or stoppedLate(text)

    def log(self, folder):
        log = folder / self.name / f"log.{PROGRAM}"
        return log.read_text(errors="replace") if log.exists() else ""

    def carryOut(self, folder, endTime, timeout):
        """A run in a folder of its own, anew when it did not end before."""
        shutil.rmtree(folder / self.name, ignore_errors=True)
        folder.mkdir(parents=True, exist_ok=True)
        case = FoamCase(PROJECT / f"tutorials/fsi/shockPanel{self.mesh.length}",
                        folder / self.name)
        self.setMesh(case)
        control = {
            "endTime": endTime, "deltaT": f"{self.subCycles*self.gasStep:g}e-6",
            "adjustTimeStep": "no", "writeControl": "timeStep",
            "writeInterval": 10**9,
        }
        for entry, value in control.items():
            case.set("system/controlDict", entry, value)
        case.set("constant/couplingProperties", "coupling", self.scheme)
        case.set("constant/couplingProperties", "subCycles", self.subCycles)
        case.set("constant/couplingProperties", "pRef", f"{self.pRef:g}")
        if self.integrator != "Newmark":
            case.set("constant/shellProperties", "timeIntegrator",
                     self.integrator)
        for program in ("blockMesh", "blockShell", "setPointFields"):
            case.run(program)
        case.run(PROGRAM, timeout=timeout, check=False)
        self.check(folder)

    def check(self, folder):
        """Raise when there is nothing that could be a result."""
        text = self.log(folder)
        if self.done(folder):
            return
        raise RunFailed(
            f"in its first step: {reason(text)}" if STOP in text
            else "without a message; the end of its log:\n" + text[-500:])

    def setMesh(self, case):
        path = case.path / "system/blockMeshDict"
        path.write_text(coarsened(path.read_text(), self.mesh))
        if self.mesh.thickness != 1:
            middle = 0.5e-3*self.mesh.thickness
            tip = 1e-3*(BASE_HEIGHT + self.mesh.length)
            case.set("system/blockShellDict", "surface/origin",
                     f"({middle:g} {1e-3*BASE_HEIGHT:g} 0)")
            case.set("constant/shellProperties", "sections/panel/thickness",
                     f"{1e-3*self.mesh.thickness:g}")
            case.set("system/controlDict", "functions/panelTip/points",
                     f"(({middle:g} {tip:g} 0.0005))")

    def results(self, folder):
        return Results(self, folder / self.name)


class Results:
    """Histories and times of a run that is done."""

    def __init__(self, run, folder):
        self.run = run
        tip = np.loadtxt(folder / "postProcessing/panelTip/0/displacement.dat",
                         ndmin=2)
        gauge = np.loadtxt(folder / "postProcessing/topSensor/0/p.dat", ndmin=2)
        self.displacement = tip[:, 0]*1e3, tip[:, 1]*1e3    # ms, mm
        self.pressure = gauge[:, 0]*1e3, gauge[:, 1]*1e-3   # ms, kPa
        log = (folder / f"log.{PROGRAM}").read_text(errors="replace")

        def numbers(pattern):
            return [float(word) for word in re.findall(pattern, log)]

        number = r"([-+.\de]+)"
        self.seconds = numbers(f"ExecutionTime = {number}")[-1]
        self.nodes = int(numbers(rf"Gas: {number} nodes")[-1])
        self.stopped = None if END in log else reason(log)

        def phase(name, what):
            found = numbers(rf"\n    {name}: {what}")
            return found[-1] if found else None

        self.share = {name: phase(name, rf"\S+ s, {number} %")
                      for name in ("gas", "shell", "mesh motion")}
        self.shell = phase("shell", f"{number} s")
        self.stableStep = min(numbers(f"Stable step {number} s"))*1e6  # us
        self.ofStable = max(numbers(rf"step\(s\), {number} of the stable"))

    @property
    def peak(self):
        """Time [ms] and value [mm] of the greatest displacement, by the
        parabola through the three instants around it: the instants may be as
        far apart as a tenth of the period."""
        t, u = self.displacement
        i = u.argmax()
        if i in (0, len(u) - 1):
            return t[i], u[i]
        a, b, c = np.polyfit(t[i - 1:i + 2] - t[i], u[i - 1:i + 2], 2)
        return t[i] - b/(2*a), c - b*b/(4*a)


def largestDifference(history, reference):
    """max |history - reference| over max |reference|, at the instants of the
    history: its steps are the longer ones."""
    t, values = history
    return abs(values - np.interp(t, *reference)).max()/abs(reference[1]).max()
