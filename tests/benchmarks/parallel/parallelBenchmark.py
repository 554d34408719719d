r"""Speed-up of the gas on several processors.

    tests/benchmarks/parallel/run [-tetrahedra <n>] [-ranks <n> ...]
        [-methods <name> ...] [-repeat <n>] [-quick] [-page <file>] [-noPage]

The default scheme on a cube of tetrahedra, nowhere uniform, on one processor
and on several; wall-clock time, as the closing lines of the log give it.
Writes the table into the page, by default doc/performance.md.

    -tetrahedra <n>   about how many, default 400000
    -ranks <n> ...    numbers of processors beside one, default 2
    -methods <name> ...   of decomposePar: scotch, simple; default both
    -repeat <n>       median of n runs, default 5
    -quick            a tiny mesh, only to see that everything works; no page
                      unless it is named
    -page <file>      another page
    -noPage           print only
"""
import re
import statistics
import subprocess
import sys
import tempfile
from pathlib import Path

HERE = Path(__file__).resolve().parent
PROJECT = HERE.parents[2]
sys.path[:0] = [str(PROJECT / "tests" / folder) for folder in (
    "tools", "verification/gasBenchmarks", "benchmarks/common",
    "benchmarks/gas")]

from machine import (  # noqa: E402
    MissingProgram, facts, load, need, triad,
)
from options import Parser  # noqa: E402
from page import NoMarks, expectMarks, replaceBetween, table  # noqa: E402
from scheme import DEFAULT, entries  # noqa: E402
from stepCosts import UnitCube  # noqa: E402

DECOMPOSE = """
numberOfSubdomains {ranks};
method {method};
simpleCoeffs {{ n ({ranks} 1 1); delta 0.001; }}
"""
CLOSING = re.compile(
    r"\((\d+) nodes, (\d+) gas steps, (\S+) s\); gas alone")


def parsed(words):
    parser = Parser(__doc__)
    parser.add_argument("-tetrahedra", type=int)
    parser.add_argument("-ranks", type=int, nargs="+", default=[2])
    parser.add_argument("-methods", nargs="+", default=["scotch", "simple"])
    options = parser.parse(words, repeat=5)
    parser.choosePage(options, usual=True)
    options.tetrahedra = options.tetrahedra or (
        2000 if options.quick else 400000)
    return options


def perStep(log):
    """Wall-clock seconds per step, of a run that writes nothing."""
    _, steps, seconds = CLOSING.search(log).groups()
    return float(seconds) / int(steps)


class Cases:
    """The cube on one processor and decomposed in all ways."""

    def __init__(self, folder, options):
        self.cube = UnitCube(folder, round((options.tetrahedra / 5)**(1 / 3)))
        self.case = self.cube.case
        self.case.write("system/feSchemes", entries(*DEFAULT))
        steps = 5 if options.quick else max(
            20, round(1e7 / self.cube.nodes))
        self.entries = {
            "stopAt": "endTime", "endTime": steps * self.cube.deltaT,
            **self.cube.control(steps),
        }
        self.case.control(self.entries)

    def decompose(self, ranks, method):
        self.case.write("system/decomposeParDict",
                        DECOMPOSE.format(ranks=ranks, method=method))
        self.case.run("decomposePar", "-force")

    def seconds(self, ranks):
        if ranks == 1:
            return perStep(self.case.run("shockShellFoam", timeout=3600))
        return perStep(self.case.runParallel(
            ranks, "shockShellFoam", timeout=3600))


def together(program, count):
    """GB/s of `count` triads at the same time."""
    running = [subprocess.Popen([str(program)], stdout=subprocess.PIPE,
                                universal_newlines=True)
               for _ in range(count)]
    return sum(float(p.communicate()[0].split()[0]) for p in running)


def measured(options, folder):
    """Rows of the table. One processor and several take turns, so that both
    see the machine in the same state."""
    cases = Cases(folder / "cube", options)
    program = triad(folder)
    rows = []
    for ranks in options.ranks:
        memory = together(program, ranks) / together(program, 1)
        for method in options.methods:
            cases.decompose(ranks, method)
            pairs = [(cases.seconds(1), cases.seconds(ranks))
                     for _ in range(options.repeat)]
            one, several = (statistics.median(p) for p in zip(*pairs))
            ratio = statistics.median(a / b for a, b in pairs)
            rows.append((ranks, method, 1e3 * one, 1e3 * several, ratio,
                         memory))
            print(f"{ranks} processors, {method}: {1e3 * several:.2f} ms per"
                  f" step, one {1e3 * one:.2f} ms, speed-up {ratio:.2f}",
                  flush=True)
    return cases.cube, rows


def main(words):
    options = parsed(words)
    try:
        expectMarks(options.page, "parallel")
        need("shockShellFoam", "decomposePar", "mpirun")
        with tempfile.TemporaryDirectory() as folder:
            cube, rows = measured(options, Path(folder))
        text = (
            f"{cube.cells:,} tetrahedra, {cube.nodes:,} nodes; {facts()};"
            f" medians of {options.repeat} pair(s) of runs; load of the"
            f" machine at the end {load():.1f}.\n\n" + table(
                ("processors", "decomposition", "one processor [ms per step]",
                 "several [ms per step]", "speed-up",
                 "memory bandwidth, together over alone"), rows))
        print(f"\n{text}", flush=True)
        if options.page:
            replaceBetween(options.page, "parallel", text)
    except (MissingProgram, NoMarks) as problem:
        sys.exit(f"parallel: error: {problem}")


if __name__ == "__main__":
    main(sys.argv[1:])
