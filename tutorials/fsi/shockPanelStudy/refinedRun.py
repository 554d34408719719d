"""One run of the refinement of the 50 mm panel: its settings, case, results.

    run = Variant("nu0", "nu 0", cells=2, edits=[
        (SHELL, "sections/panel/material/nu", "0")])
    run.carryOut(folder, endTime, timeout)
    found = run.results(folder)
"""
import shutil
from dataclasses import dataclass

import numpy as np

from motions import Swing
from panelRun import END, PROGRAM, PROJECT, FoamCase, Mesh, RunFailed, \
    coarsened

COUPLING = "constant/couplingProperties"
SHELL = "constant/shellProperties"
CONTROL = "system/controlDict"
LENGTH, THICKNESS = 50e-3, 1e-3
# source: steel of the panel as in tutorials/fsi/shockPanel50
YOUNG, POISSON, DENSITY = 220e9, 0.3, 7600.0
# source: first root of cos x cosh x = -1
ROOT = 1.8751040687


def theory():
    """Period [ms] of the first mode in vacuum, plane strain."""
    bending = YOUNG*THICKNESS**3/(12*(1 - POISSON**2))
    w = (ROOT/LENGTH)**2*np.sqrt(bending/(DENSITY*THICKNESS))
    return 1e3*2*np.pi/w


@dataclass(frozen=True)
class Variant:
    """words: for the table. cells: times the size of the base case's.
    edits: (file, entry, value) of dictionaries. until: end [s] before that of
    the others."""
    name: str
    words: str
    cells: float = 2
    overPanel: int = 1
    divisions: int = 16
    base: str = "shockPanel50"
    scheme: str = "predictedMotion"
    subCycles: int = 10
    edits: tuple = ()
    until: float = float("inf")

    def done(self, folder):
        return END in self.log(folder)

    def log(self, folder):
        log = folder / self.name / f"log.{PROGRAM}"
        return log.read_text(errors="replace") if log.exists() else ""

    def prepare(self, folder, endTime):
        """A case in a folder of its own, with its meshes."""
        shutil.rmtree(folder / self.name, ignore_errors=True)
        folder.mkdir(parents=True, exist_ok=True)
        case = FoamCase(PROJECT / "tutorials/fsi" / self.base,
                        folder / self.name)
        blocks = case.path / "system/blockMeshDict"
        blocks.write_text(coarsened(blocks.read_text(), Mesh(
            50, coarser=self.cells, overPanel=self.overPanel)))
        end = f"{min(endTime, self.until):g}"
        for entry in (
            (CONTROL, "endTime", end), (CONTROL, "writeInterval", end),
            (COUPLING, "coupling", self.scheme),
            (COUPLING, "subCycles", self.subCycles),
            ("system/blockShellDict", "divisions", f"({self.divisions} 1)"),
            *self.edits,
        ):
            case.set(*entry)
        for program in ("blockMesh", "blockShell", "setPointFields"):
            case.run(program)
        return case

    def carryOut(self, folder, endTime, timeout):
        self.prepare(folder, endTime).run(PROGRAM, timeout=timeout)

    def results(self, folder):
        return Found(self, folder / self.name)


class Found:
    """Histories [ms, mm, kPa] of a run, and its swing."""

    def __init__(self, run, folder):
        self.run = run

        def table(file):
            return np.loadtxt(folder / "postProcessing" / file, ndmin=2)

        tip = table("panelTip/0/displacement.dat")
        self.tip = 1e3*tip[:, 0], 1e3*tip[:, 1]
        balance = table("interface/0/balance.dat")
        # Mean load across the panel, which is 1 mm wide [kPa]
        self.load = 1e3*balance[:, 0], 1e-3*balance[:, 4]/(LENGTH*1e-3)
        self.swing = Swing.of(*self.tip)
        log = (folder / f"log.{PROGRAM}").read_text(errors="replace")
        if END not in log:
            raise RunFailed(f"{folder}: its run did not end")
        self.seconds = float(log.split("ExecutionTime = ")[-1].split()[0])
        self.nodes = int(log.split("\nGas: ")[1].split()[0])


# Runs that are not the shock tube

RINGING = "ringing"
KICK = ("{ kick { type traction; traction (1000 0 0); factor table "
        "((0 0) (1e-5 1) (2e-4 1) (2.1e-4 0) (1 0)); } }")
# Gas at rest at the mean pressure of the sensor from 0.6 to 1.3 ms, compressed
# isentropically from the state behind the incident shock
REST_P = 195.4e3
REST_T = 332.34*(195.4/154.145)**(0.4/1.4)


@dataclass(frozen=True)
class Ringing(Variant):
    """The panel struck lightly in gas at rest, in the same tube."""

    def prepare(self, folder, endTime):
        case = super().prepare(folder, endTime)
        for field, value in (("p", f"{REST_P:g}"), ("T", f"{REST_T:.10g}"),
                             ("U", "(0 0 0)")):
            file = case.path / "0" / field
            shutil.copy(PROJECT / "tutorials/fsi" / self.base / "0.orig"
                        / field, file)
            case.set(f"0/{field}", "internalField", f"uniform {value}")
            case.set(f"0/{field}", "boundaryField/inlet/value",
                     f"uniform {value}")
        case.set(COUPLING, "pRef", f"{REST_P:g}")
        addLoads(case, KICK)
        return case


def addLoads(case, loads):
    case.run("foamDictionary", SHELL, "-entry", "loads", "-add", loads,
             log="log.foamDictionary")


def shellAlone(case, folder, loads, endTime, step):
    """Times [ms] and tip [mm] of the panel alone under these loads."""
    shutil.rmtree(folder, ignore_errors=True)
    shutil.copytree(case / "system", folder / "system")
    (folder / "constant").mkdir()
    shutil.copytree(case / "constant/shell", folder / "constant/shell")
    shutil.copy(case / SHELL, folder / SHELL)
    alone = FoamCase.__new__(FoamCase)
    alone.path = folder.resolve()
    text = (folder / SHELL).read_text()
    if "\nloads" in text:
        alone.run("foamDictionary", SHELL, "-entry", "loads", "-remove",
                  log="log.foamDictionary")
    addLoads(alone, loads)
    for entry, value in (
        ("application", "positionalShellFoam"), ("deltaT", f"{step:g}"),
        ("endTime", f"{endTime:g}"), ("writeInterval", f"{endTime:g}"),
        ("adjustTimeStep", "no"),
    ):
        alone.set(CONTROL, entry, value)
    alone.run("foamDictionary", CONTROL, "-entry", "functions/topSensor",
              "-remove", log="log.foamDictionary")
    alone.run("positionalShellFoam")
    _, table = alone.history("panelTip/0/displacement.dat")
    return 1e3*table[:, 0], 1e3*table[:, 1]


def followerLoad(t, kPa, factor):
    """A pressure on the panel's front by the history of a run."""
    points = " ".join(f"({1e-3*a:.9g} {b:.9g})" for a, b in zip(t, kPa))
    return ("{ gas { type followerPressure; pressure "
            f"{-1e3*factor:g}; factor table ((0 {kPa[0]:.9g}) {points}); }} }}")
