"""Refinement of the 50 mm panel, and what its differences from the references
come from.

    Allrun -refinement [-finest <size>] [-endTime <s>] [-quick]
           [-runs <folder>] [-noRuns] [-page <file> | -noPage] [-limit <s>]

Gas meshes with cells of 2, 1.5, 1, 2/3 times those of shockPanel50, with
coupling steps as much shorter, those below 1 up to 2 ms; and, on the mesh of 2, steps, meshes of the shell and of
the gas over the panel, Poisson's ratio, a stiffer panel, small displacements,
no step in front of the panel, another shock capturing, no motion of the mesh,
and the panel ringing in gas at rest.

  -finest    1, 2/3 (default) or 1/2
  -endTime   default 4.5e-3, past the second maximum
  -quick     cells of 8, 6, 4, the first peak, few variants, no page unless it
             is named
  -runs      folder of the runs; those that ended are not run again
  -noRuns    run nothing, show what is there
  -page      default doc/verification.md
  -noPage    print only
  -limit     seconds that one run may take, default 3600
"""
import argparse
import sys
from pathlib import Path

from panelRun import HERE, PROJECT
from refinedRun import COUPLING, RINGING, SHELL, Ringing, Variant
from refinementTables import text

sys.path.insert(0, str(PROJECT / "tests" / "benchmarks" / "common"))
from page import NoMarks, expectMarks, replaceBetween  # noqa: E402

MARK = "shockPanelRefinement"
SIZES = {"1": (2, 1.5, 1), "2/3": (2, 1.5, 1, 2/3),
         "1/2": (2, 1.5, 1, 2/3, 1/2)}
QUICK = (8, 6, 4)
# The finest meshes go past the first peak [s]
PEAK = 2e-3
MATERIAL = "sections/panel/material"


def options(words):
    parser = argparse.ArgumentParser(
        prog="Allrun -refinement", usage=__doc__, allow_abbrev=False,
        add_help=False)
    parser.add_argument("-h", "-help", action="store_true")
    parser.add_argument("-finest", choices=SIZES, default="2/3")
    parser.add_argument("-endTime", type=float)
    parser.add_argument("-quick", action="store_true")
    parser.add_argument("-runs", type=Path, default=HERE / "runs")
    parser.add_argument("-noRuns", action="store_true")
    parser.add_argument("-page", type=Path)
    parser.add_argument("-noPage", action="store_true")
    parser.add_argument("-limit", type=float, default=3600)
    found = parser.parse_args(words)
    if found.h:
        print(__doc__)
        sys.exit()
    found.endTime = found.endTime or (1.7e-3 if found.quick else 4.5e-3)
    if not found.page and not found.quick:
        found.page = PROJECT / "doc" / "verification.md"
    if found.noPage:
        found.page = None
    return found


def meshes(chosen):
    """The runs on ever finer meshes of the gas."""
    sizes = QUICK if chosen.quick else SIZES[chosen.finest]
    return [Variant(f"cells{size:.3g}", f"cells {size:.3g}", cells=size,
                    until=PEAK if size < 1 else float("inf"))
            for size in sizes]


def variants(chosen):
    """What is changed on the coarsest mesh, or on the next ones."""
    size = QUICK[0] if chosen.quick else SIZES["1"][0]

    def of(name, words, *edits, **settings):
        return Variant(name, words, edits=edits,
                       **{"cells": size, **settings})

    noStep = dict(base="shockPanel50NoStep")
    few = [
        of("nu0", "nu 0", (SHELL, f"{MATERIAL}/nu", "0")),
        of("noStep", "no step (M2C's channel and states)", **noStep),
    ]
    if chosen.quick:
        return few
    return few + [
        of("noStepStiff", "the same, E 14 % greater",
           (SHELL, f"{MATERIAL}/E", f"{1.14*220e9:g}"), **noStep),
        of("noStepFine", "no step, cells 1", **noStep, cells=1),
        of("noStepFineStiff", "the same, E 14 % greater",
           (SHELL, f"{MATERIAL}/E", f"{1.14*220e9:g}"), **noStep, cells=1),
        of("nu033", "nu 0.33", (SHELL, f"{MATERIAL}/nu", "0.33")),
        of("courant04", "Courant number 0.4 for 0.8: all steps halved",
           ("system/controlDict", "maxCo", "0.4")),
        of("subCycles1", "1 gas step per coupling step", subCycles=1),
        of("twoWay", "`twoWay`", scheme="twoWay"),
        of("twoWay50", "`twoWay`, 50 gas steps per coupling step",
           scheme="twoWay", subCycles=50),
        of("oneWay", "`oneWay`", scheme="oneWay"),
        of("shell8", "8 divisions of the shell", divisions=8),
        of("shell32", "32 divisions of the shell", divisions=32),
        of("panel2", "twice the cells over the panel", overPanel=2),
        of("panel4", "four times the cells over the panel", overPanel=4),
        of("fct", "shock capturing `fluxCorrected`",
           ("system/feSchemes", "shockCapturing", "fluxCorrected")),
        of("fctFine", "the same, cells 1",
           ("system/feSchemes", "shockCapturing", "fluxCorrected"), cells=1),
        of("suddenly", "`pRef` 0: meets the ambient pressure suddenly",
           (COUPLING, "pRef", "0")),
    ]


def ringing(chosen):
    return Ringing(RINGING, "struck lightly in gas at rest")


def carryOut(run, chosen, folder):
    """Results, or None when there are none and none are to be made."""
    if not run.done(folder):
        if chosen.noRuns:
            return None
        run.carryOut(folder, chosen.endTime, chosen.limit)
    found = run.results(folder)
    peak = found.swing.peak
    print(f"{run.name}: {found.nodes} nodes, {found.seconds:.1f} s"
          + (f", peak {peak.value:.3f} mm at {peak.time:.3f} ms" if peak
             else ""), flush=True)
    return found


def main():
    chosen = options(sys.argv[1:])
    try:
        expectMarks(chosen.page, MARK)
    except NoMarks as problem:
        sys.exit(f"shockPanelStudy: error: {problem}")
    folder = chosen.runs / f"refinement-{chosen.endTime*1e3:g}ms"
    wanted = meshes(chosen) + variants(chosen)
    if not chosen.quick:
        wanted.append(ringing(chosen))
    found = {run.name: carryOut(run, chosen, folder) for run in wanted}
    found = {name: result for name, result in found.items() if result}
    family = [found[r.name] for r in meshes(chosen) if r.name in found]
    if len(family) < 3:
        sys.exit(f"shockPanelStudy: error: fewer than 3 meshes in {folder}")
    rest = [found[r.name] for r in variants(chosen) if r.name in found]
    words = text(family, rest, found.get(RINGING), folder)
    print(words)
    if chosen.page:
        replaceBetween(chosen.page, MARK, words)
        print(f"written: {chosen.page}")


if __name__ == "__main__":
    main()
