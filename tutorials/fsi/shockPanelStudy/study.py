"""The paper's studies of the shock-tube panel, for both lengths.

    Allrun [<study> ...] [-length 50|40] [-endTime <s>] [-coarser <n>]
           [-quick] [-runs <folder>] [-noRuns] [-page <file> | -noPage]
           [-limit <s>]

Studies, all but the last two by default:
  twoWay       1, 5, 10, 50, 100, 200 gas steps per shell step
  oneWay       the same one-way, and its largest differences from two-way
  thick        a panel of 2.5 mm, one-way and two-way, with 1 and 50
  schemes      predictedMotion and iterated beside twoWay, with 10 and 50
  pRef         50, 100, 200 two-way and one-way, 50 by the other schemes; the
               shell in ambient pressure from the start
  integrators  the same without, but the shell by energyMomentum
  asPrinted    200 gas steps of 0.00625 us, 80 times the others' cost

  -length    one panel alone
  -endTime   default 3e-3
  -coarser   cells this many times the size of shockPanel50's; default 2, on
             which a gas step of 1 us is stable, as the paper's runs need
  -quick     a small mesh and 0.1 ms, few runs, no page unless it is named
  -runs      folder of the runs; runs that are there are not run again
  -noRuns    run nothing, show what is there
  -page      default doc/verification.md; the pictures go to pictures/ beside it
  -noPage    print only
  -limit     seconds that one run may take, default 3600
"""
import argparse
import sys
from pathlib import Path

from panelRun import HERE, PROJECT, Mesh, RunFailed
from studies import (
    COST_HEAD, DIFFERENCE_HEAD, STUDIES, USUAL, costRows, differenceRows,
    reference, runsOf, stable, stops, thick,
)

sys.path.insert(0, str(PROJECT / "tests" / "benchmarks" / "common"))
from page import NoMarks, expectMarks, replaceBetween, table  # noqa: E402

MARK = "shockPanelStudy"
LENGTHS = (50, 40)


def options(words):
    parser = argparse.ArgumentParser(
        prog="Allrun", usage=__doc__, allow_abbrev=False, add_help=False)
    parser.add_argument("study", nargs="*", metavar="study")
    parser.add_argument("-h", "-help", action="store_true")
    parser.add_argument("-length", type=int, choices=LENGTHS)
    parser.add_argument("-endTime", type=float)
    parser.add_argument("-coarser", type=int, choices=range(1, 9))
    parser.add_argument("-quick", action="store_true")
    parser.add_argument("-runs", type=Path, default=HERE / "runs")
    parser.add_argument("-noRuns", action="store_true")
    parser.add_argument("-page", type=Path)
    parser.add_argument("-noPage", action="store_true")
    parser.add_argument("-limit", type=float, default=3600)
    found = parser.parse_args(
        [w[1:] if w.startswith("--") else w for w in words])
    if found.h:
        print(__doc__)
        sys.exit()
    unknown = [name for name in found.study if name not in STUDIES]
    if unknown:
        parser.error(f"no study {unknown[0]}; choose from {', '.join(STUDIES)}")
    found.endTime = found.endTime or (1e-4 if found.quick else 3e-3)
    found.coarser = found.coarser or (4 if found.quick else 2)
    found.study = found.study or (
        ["oneWay"] if found.quick else USUAL)
    found.lengths = [found.length] if found.length else (
        LENGTHS[:1] if found.quick else LENGTHS)
    if not found.page and not found.quick:
        found.page = PROJECT / "doc" / "verification.md"
    if found.noPage:
        found.page = None
    return found


class Studies:
    """What has been run, by the run in the paper's steps."""

    def __init__(self, options):
        self.options = options
        self.results = {}
        self.failed = []    # why a run has no results at all
        self.folder = options.runs / (
            f"{options.endTime*1e3:g}ms-cells{options.coarser}")

    def runsOf(self, study, length):
        runs = runsOf(study, Mesh(length, coarser=self.options.coarser))
        if self.options.quick:
            return [run for run in runs if run.subCycles in (1, 10)]
        return runs

    def run(self, wanted):
        """In the largest stable step where the paper's is not."""
        if wanted in self.results:
            return
        run, first = wanted, reference(wanted.mesh)
        if wanted != first:
            if first not in self.results:
                return
            run = stable(wanted, self.results[first].stableStep)
        if run != wanted:
            print(f"{wanted.name}: its gas step is not stable on this mesh,"
                  f" {run.gasStep:g} us instead", flush=True)
        if not run.done(self.folder):
            if self.options.noRuns:
                if run.log(self.folder):
                    run.check(self.folder)
                return
            run.carryOut(self.folder, self.options.endTime,
                         self.options.limit)
        found = run.results(self.folder)
        print(f"{run.name}: {found.seconds:.1f} s, peak {found.peak[1]:.3f} mm"
              f" at {found.peak[0]:.3f} ms, up to {found.ofStable:.2f} of the"
              " stable step", *stops([found]), sep="\n", flush=True)
        if run == first and found.stopped:
            sys.exit("no other run can be compared without it")
        if found.ofStable > 1:
            print(f"{run.name}: its steps were not stable, it is left out",
                  file=sys.stderr)
            if run == first:
                sys.exit("no other run can be compared without it")
            return
        self.results[wanted] = found

    def found(self, runs):
        return [(r, self.results[r]) for r in runs if r in self.results]

    def costs(self, length):
        """Rows of the studies with two-way schemes; without doubles."""
        runs = [r for study in ("twoWay", "schemes", "pRef", "integrators",
                              "asPrinted")
                if study in self.options.study
                for r in self.runsOf(study, length) if r.scheme != "oneWay"]
        pairs = self.found(dict.fromkeys(runs))
        return list(costRows(pairs, pairs[0][1])) if pairs else []

    def differences(self, length):
        mesh = Mesh(length, coarser=self.options.coarser)
        for panel in (mesh, thick(mesh)):
            found = [result for run, result in self.results.items()
                     if run.mesh == panel]
            if found:
                yield from differenceRows(
                    found, self.results[reference(panel)])


def text(studies):
    options = studies.options
    nodes = max(found.nodes for found in studies.results.values())
    yield (
        f"Up to {options.endTime*1e3:g} ms; cells {options.coarser} times the"
        f" size of those of `tutorials/fsi/shockPanel50`, {nodes:,} nodes of"
        " the gas at most. A difference is the largest one over the run,"
        " divided by the largest value of the run compared with. The shares of"
        " the shell and of the mesh motion are of the elapsed time.")
    for length in options.lengths:
        rows = studies.costs(length)
        if rows:
            yield (
                f"\nPanel of {length} mm, two-way; displacement and pressure:"
                " difference from the first row, the finest in time:\n")
            yield table(COST_HEAD, rows)
    rows = [r for length in options.lengths
            for r in studies.differences(length)]
    if rows:
        yield ("\nOne-way; its difference from the two-way run of 1 sub-cycle,"
               " beside the paper's, and from that of as many sub-cycles:\n")
        yield table(DIFFERENCE_HEAD, rows)
    reasons = stops(studies.results.values()) + sorted(set(studies.failed))
    if reasons:
        yield ("\nRuns that stopped are compared as far as they went:\n")
        yield "\n".join(reasons)


def main():
    chosen = options(sys.argv[1:])
    try:
        expectMarks(chosen.page, MARK)
    except NoMarks as problem:
        sys.exit(f"shockPanelStudy: error: {problem}")
    studies = Studies(chosen)
    for length in chosen.lengths:
        for study in chosen.study:
            for run in studies.runsOf(study, length):
                try:
                    studies.run(run)
                except RunFailed as problem:
                    print(f"{run.name} is left out, stopped {problem}",
                          f"    see its folder in {studies.folder}",
                          sep="\n", file=sys.stderr)
                    studies.failed.append(f"- {run.name} stopped {problem}")
                    if run == reference(run.mesh):
                        return 1
    if not studies.results:
        sys.exit(f"shockPanelStudy: error: no run in {studies.folder}")
    words = list(text(studies))
    print("\n".join(words))
    if chosen.page:
        from pictures import pictures
        for length in chosen.lengths:
            words += pictures(studies, length, chosen.page.parent / "pictures")
        replaceBetween(chosen.page, MARK, "\n".join(words))
        print(f"written: {chosen.page}")
    return 0


if __name__ == "__main__":
    sys.exit(main())
