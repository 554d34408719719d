r"""Processor time against error, beside OpenFOAM's rhoCentralFoam.

    tests/benchmarks/speedError/run [<problem> ...] [-quick] [-repeat <n>]
        [-sizes <n> ...] [-capturing <name>] [-maxCo <number>]
        [-page <file>] [-noPage]

Runs each problem on the same polyMesh with both codes, three meshes each and
one more for ours, and writes table and picture of it into the page, by default
doc/performance.md with pictures/ beside it.

    <problem>     sod, bulb, bulbHexahedra, vortex; all without
    -quick        tiny meshes, only to see that everything works; no page
                  unless it is named
    -repeat <n>   median of n runs, default 3
    -sizes <n> ...      other meshes, with both codes
    -capturing <name>   another shockCapturing of ours
    -maxCo <number>     another Courant number of ours
                  (with one of these three: no page unless it is named)
    -page <file>  another page
    -noPage       print only
"""
import sys
import tempfile
from pathlib import Path

HERE = Path(__file__).resolve().parent
PROJECT = HERE.parents[2]
sys.path[:0] = [str(PROJECT / "tests" / folder) for folder in (
    "tools", "verification/gasBenchmarks", "benchmarks/common",
    "benchmarks/speedError")]

from comparison import OURS, PEER, Comparison  # noqa: E402
from machine import MissingProgram, facts, load, need  # noqa: E402
from options import Parser  # noqa: E402
from page import NoMarks, expectMarks, replaceBetween, table  # noqa: E402
from problems import PROBLEMS  # noqa: E402
from sameError import Front, interval, levels  # noqa: E402
from scheme import MAX_CO, SHOCK_CAPTURING, TIME_SCHEME  # noqa: E402

QUANTITIES = {
    "rho": "L1 of rho", "p": "L1 of p", "u": "L1 of u",
    "peak": "peak at the gauges",
    "rhoAtNodes": "L1 of rho, both at nodes",
}


def parsed(words):
    parser = Parser(__doc__)
    parser.add_argument("problems", nargs="*", metavar="problem")
    parser.add_argument("-sizes", type=int, nargs="+")
    parser.add_argument("-capturing")
    parser.add_argument("-maxCo", type=float)
    options = parser.parse(words, repeat=3)
    for name in options.problems:
        if name not in PROBLEMS:
            parser.error(f"unknown problem '{name}'; valid: "
                         + " ".join(PROBLEMS))
    options.problems = options.problems or list(PROBLEMS)
    parser.choosePage(options, usual=not (
        options.sizes or options.capturing or options.maxCo))
    options.capturing = options.capturing or SHOCK_CAPTURING
    options.maxCo = options.maxCo or MAX_CO
    return options


def runAll(problem, options, folder):
    """Runs of both codes on all meshes, coarse to fine."""
    runs = []
    common, finer = problem.sizes, problem.finer
    if options.quick or options.sizes:
        common, finer = options.sizes or problem.quick, ()
    for size in (*common, *finer):
        pair = Comparison(problem, size, folder / problem.name / str(size),
                          options)
        codes = (pair.peer, pair.ours) if size in common else (pair.ours,)
        for code in codes:
            runs.append(code())
            print(line(runs[-1]), flush=True)
    return runs


def line(run):
    found = ", ".join(f"{QUANTITIES[n]} {e:.3g}"
                      for n, e in run.errors.items())
    return (f"{run.code:15} n {run.size:<4} {run.unknowns:>8} unknowns"
            f" {run.steps:>5} steps {run.seconds:>9.3f} s"
            f" {run.perStep:6.3f} us: {found}")


def of(runs, code):
    return [run for run in runs if run.code == code]


def sameErrors(runs, quantity):
    """The times of both for the errors of the peer."""
    ours, peer = (
        Front([r.seconds for r in of(runs, code)],
              [r.errors[quantity] for r in of(runs, code)])
        for code in (OURS, PEER))
    return levels(ours, peer)


def tableOfTimes(runs, quantity):
    return table(
        (f"same error, {QUANTITIES[quantity]}", f"{PEER} [s]", f"{OURS} [s]",
         "ratio"),
        [(level.error, level.peer, interval(*level.ours),
          interval(*level.ratio)) for level in sameErrors(runs, quantity)])


def summary(runs, quantity):
    """One sentence."""
    ratios = ", ".join(interval(*level.ratio)
                       for level in sameErrors(runs, quantity))
    return (f"**{PEER} takes {ratios} times our time for its errors"
            f" ({QUANTITIES[quantity]}, coarse to fine).**")


def report(problem, runs, options):
    """The section of the page."""
    names = list(runs[0].errors)
    rows = [
        (r.code, r.size, r.unknowns, r.steps, r.seconds, r.perStep,
         *(r.errors[n] for n in names))
        for r in sorted(runs, key=lambda r: (r.code, r.size))
    ]
    head = ("code", "n", "nodes or cells", "steps", "time [s]",
            "us per node (cell) and step", *(QUANTITIES[n] for n in names))
    parts = [
        summary(runs, names[0]),
        f"Reference: {problem.error}. `{TIME_SCHEME}`,"
        f" `{options.capturing}`, `maxCo` {options.maxCo:g}; {facts()}; median"
        f" of {options.repeat} run(s); load of the machine at the end"
        f" {load():.1f}.",
        table(head, rows),
    ]
    parts += [tableOfTimes(runs, name) for name in names]
    return "\n\n".join(parts)


def draw(problem, runs, file):
    """Picture of time against error of the first quantity."""
    import matplotlib
    matplotlib.use("Agg")
    from matplotlib import pyplot

    quantity = problem.quantities[0]
    figure, axes = pyplot.subplots(figsize=(4.5, 3.4), dpi=80)
    for code, mark in ((PEER, "s--"), (OURS, "o-")):
        some = of(runs, code)
        axes.loglog([r.seconds for r in some],
                    [r.errors[quantity] for r in some], mark, label=code)
    axes.set_xlabel("processor time [s]")
    axes.set_ylabel(QUANTITIES[quantity])
    axes.set_title(problem.title, fontsize=9)
    axes.grid(which="both", alpha=0.3)
    axes.legend(fontsize=8)
    figure.tight_layout()
    file.parent.mkdir(exist_ok=True)
    figure.savefig(file, metadata={"Software": None})
    pyplot.close(figure)


def write(problem, runs, text, page):
    picture = f"speedError-{problem.name}.png"
    draw(problem, runs, page.parent / "pictures" / picture)
    replaceBetween(
        page, f"speedError {problem.name}",
        f"### {problem.title[0].upper() + problem.title[1:]}\n\n{text}\n\n"
        f"![Error against time](pictures/{picture})")


def main(words):
    options = parsed(words)
    try:
        expectMarks(options.page,
                    *(f"speedError {name}" for name in options.problems))
        need(OURS, PEER, "blockMesh")
        for name in options.problems:
            problem = PROBLEMS[name]
            print(f"\n{problem.title}", flush=True)
            with tempfile.TemporaryDirectory() as folder:
                runs = runAll(problem, options, Path(folder))
            text = report(problem, runs, options)
            print(f"\n{text}", flush=True)
            if options.page:
                write(problem, runs, text, options.page)
    except (MissingProgram, NoMarks) as problem:
        sys.exit(f"speedError: error: {problem}")


if __name__ == "__main__":
    main(sys.argv[1:])
