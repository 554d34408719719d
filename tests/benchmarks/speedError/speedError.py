r"""Processor time against error, beside OpenFOAM's rhoCentralFoam.

    tests/benchmarks/speedError/run [<problem> ...] [-quick] [-repeat <n>]
        [-capturing <name>] [-page <file>] [-noPage]

Runs each problem on the same polyMesh with both codes, three meshes each and
one more for ours, and writes table and picture of it into the page, by default
doc/performance.md with pictures/ beside it.

    <problem>     sod, bulb, bulbHexahedra, vortex; all without
    -quick        tiny meshes, only to see that everything works; no page
                  unless it is named
    -repeat <n>   median of n runs, default 3
    -capturing <name>   another shockCapturing than the default; no page unless
                  it is named
    -page <file>  another page
    -noPage       print only
"""
import argparse
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
from page import NoMarks, replaceBetween, table  # noqa: E402
from problems import PROBLEMS  # noqa: E402
from sameError import Front, interval, levels  # noqa: E402
from scheme import SHOCK_CAPTURING, TIME_SCHEME  # noqa: E402

QUANTITIES = {
    "rho": "L1 of rho", "p": "L1 of p", "u": "L1 of u",
    "peak": "peak at the gauges",
}


def parsed(words):
    parser = argparse.ArgumentParser(
        prog="run", usage=__doc__, allow_abbrev=False)
    parser.add_argument("problems", nargs="*", metavar="problem")
    parser.add_argument("-quick", action="store_true")
    parser.add_argument("-repeat", type=int)
    parser.add_argument("-capturing", default=SHOCK_CAPTURING)
    parser.add_argument("-page", type=Path)
    parser.add_argument("-noPage", action="store_true")
    options = parser.parse_args(words)
    for name in options.problems:
        if name not in PROBLEMS:
            parser.error(f"unknown problem '{name}'; valid: "
                         + " ".join(PROBLEMS))
    options.problems = options.problems or list(PROBLEMS)
    options.repeat = options.repeat or (1 if options.quick else 3)
    if options.noPage:
        options.page = None
    elif options.page is None and not options.quick \
            and options.capturing == SHOCK_CAPTURING:
        options.page = PROJECT / "doc" / "performance.md"
    return options


def runAll(problem, options, folder):
    """Runs of both codes on all meshes, coarse to fine."""
    runs = []
    common = problem.quick if options.quick else problem.sizes
    finer = () if options.quick else problem.finer
    for size in (*common, *finer):
        pair = Comparison(problem, size, folder / problem.name / str(size),
                          options.repeat, options.capturing)
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
    """Table of the times for the errors of the peer."""
    ours, peer = (
        Front([r.seconds for r in of(runs, code)],
              [r.errors[quantity] for r in of(runs, code)])
        for code in (OURS, PEER))
    return table(
        (f"same error, {QUANTITIES[quantity]}", f"{PEER} [s]", f"{OURS} [s]",
         "ratio"),
        [(level.error, level.peer, interval(*level.ours),
          interval(*level.ratio)) for level in levels(ours, peer)])


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
        f"Reference: {problem.error}. `{TIME_SCHEME}`,"
        f" `{options.capturing}`; {facts()}; median of {options.repeat}"
        f" run(s); load of the machine at the end {load():.1f}.",
        table(head, rows),
    ]
    parts += [sameErrors(runs, name) for name in names]
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
