r"""Cost of the shell library, and time against error beside CalculiX.

    tests/benchmarks/shell/run [<part> ...] [-quick] [-repeat <n>]
        [-upTo <elements>] [-page <file>] [-noPage]

Parts: costs (times of the library's work for 72 to 5,000 elements), and the
problems that CalculiX's ccx solves too: cantilever, hemisphere, plate. Default
all. The tables and pictures go into the page, by default doc/performance.md.

    -quick        tiny meshes, only to see that everything works; no page unless
                  it is named
    -repeat <n>   median of n runs, default 3
    -upTo <elements>   no costs of more elements (5,000 take minutes), default
                  5000
    -page <file>  another page
    -noPage       print only

Without ccx (Debian's package calculix-ccx) only our side is run and printed.
"""
import statistics
import subprocess
import sys
import tempfile
from pathlib import Path

HERE = Path(__file__).resolve().parent
PROJECT = HERE.parents[2]
sys.path[:0] = [str(PROJECT / "tests" / folder) for folder in (
    "tools", "verification/shell", "benchmarks/common",
    "benchmarks/speedError", "benchmarks/shell")]

import ccx  # noqa: E402
from foamEnvironment import environment  # noqa: E402
from machine import facts, load  # noqa: E402
from options import Parser  # noqa: E402
from page import NoMarks, expectMarks, replaceBetween, table  # noqa: E402
from sameError import Front, interval, levels  # noqa: E402
from shellProblems import PROBLEMS  # noqa: E402

OURS, PEER = "positionalShellFoam", "ccx"
FORMS = ("displacement", "assumedStrain")

# Quadrilaterals along a side of the wall: 72 to 5,000 triangles
SIDES = 6, 12, 25, 50


def parsed(words):
    parser = Parser(__doc__)
    known = ["costs", *PROBLEMS]
    parser.add_argument("parts", nargs="*", metavar="part")
    parser.add_argument("-upTo", type=int, default=5000)
    options = parser.parse(words, repeat=3)
    for part in options.parts:
        if part not in known:
            parser.error(f"no part {part}; there are {', '.join(known)}")
    options.parts = options.parts or known
    parser.choosePage(options, usual=True)
    return options


def conditions(options):
    return (f"{facts()}, one thread; median of {options.repeat} run(s); load"
            f" of the machine at the end {load():.1f}.")


# Costs

def program():
    """Built for this; its path."""
    subprocess.run(["wmake", "-s", str(HERE)], check=True, env=environment(),
                   stdout=subprocess.DEVNULL)
    return Path(environment()["SHOCKSHELL_APPBIN"]) / "benchmarks" / "shell"


def costsOf(path, n, form, options):
    """Medians of what the program prints, by name."""
    def once():
        done = subprocess.run(
            [str(path), str(n), form, "0.01" if options.quick else "1"],
            env={**environment(), "OMP_NUM_THREADS": "1",
                 "OPENBLAS_NUM_THREADS": "1"},
            stdout=subprocess.PIPE, check=True, universal_newlines=True)
        return {name: float(value) for name, value in
                (line.split() for line in done.stdout.splitlines())}

    runs = [once() for _ in range(options.repeat)]
    return {name: statistics.median(r[name] for r in runs)
            for name in runs[0]}


ROWS = (
    ("us per element: tangent, into the sparse matrix", "tangent", 1e6, True),
    ("us per element: straightforward dense tangent", "straightforward", 1e6,
     True),
    ("us per element: residual", "residual", 1e6, True),
    ("equations", "equations", 1, False),
    ("ms: first factorisation, with symbolic analysis", "firstFactorisation",
     1e3, False),
    ("ms: factorisation (Cholesky)", "factorisation", 1e3, False),
    ("ms: solution", "solve", 1e3, False),
    ("ms: Newton iteration, new tangent in each", "newtonIteration", 1e3,
     False),
    ("ms: iteration with kept factors", "keptIteration", 1e3, False),
    ("iterations per step with kept factors", "keptIterationsPerStep", 1,
     False),
    ("steps measured (60 at most)", "keptSteps", 1, False),
    ("factorisations in them", "keptFactorisations", 1, False),
    ("ms: dynamic step, new tangents", "newtonStep", 1e3, False),
    ("ms: dynamic step, kept factors", "keptStep", 1e3, False),
)


def rowOf(found, key, factor, perElement):
    values = [costs.get(key) for costs in found]
    if values[0] is None:
        return None
    cells = [value * factor / (costs["elements"] if perElement else 1)
             for value, costs in zip(values, found) if value is not None]
    growth = cells[-1] / cells[0]
    if key in ("equations", "keptSteps", "keptFactorisations"):
        cells = [int(c) for c in cells]
    return cells + [""] * (len(values) - len(cells)) + [float(growth)]


def costs(options):
    path = program()
    sides = (1, 2) if options.quick else [
        n for n in SIDES if 2 * n * n <= options.upTo]
    parts = []
    for form in FORMS:
        found = [costsOf(path, n, form, options) for n in sides]
        rows = []
        for title, key, factor, perElement in ROWS:
            row = rowOf(found, key, factor, perElement)
            if row:
                rows.append([title, *row])
        head = [f"`{form}`"] + [f"{int(c['elements']):,} elements"
                                for c in found] + ["largest over smallest"]
        parts.append(table(head, rows))
        print(parts[-1], flush=True)
        if "straightforward" in found[0]:
            ratios = ", ".join(f"{c['straightforward'] / c['tangent']:.0f}"
                               for c in found)
            differ = max(c["tangentDifference"] for c in found)
            parts.append(
                f"The straightforward product takes {ratios} times the"
                " library's time; both tangents differ by"
                f" {differ:.1g} of their norm.")
    return "\n\n".join([conditions(options), *parts])


# Comparison

class Run:

    def __init__(self, mesh, seconds, error):
        self.mesh, self.seconds, self.error = mesh, seconds, error


def measured(solve, mesh, choices, folder, options, code):
    """Runs of one code; those that fail are said and left out."""
    runs = []
    for choice in choices:
        try:
            seconds = []
            for k in range(options.repeat):
                name = "-".join(map(str, (code, *choice, k)))
                time, error = solve(folder / name, *choice)
                seconds.append(time)
        except ccx.Failed as problem:
            print(f"{code:20} {mesh(*choice):44} failed: {problem}")
            continue
        runs.append(Run(mesh(*choice), statistics.median(seconds), error))
        print(f"{code:20} {mesh(*choice):44} {runs[-1].seconds:8.3f} s"
              f" {100 * runs[-1].error:9.4f} %", flush=True)
    return runs


def plot(name, title, runs, page):
    import matplotlib
    matplotlib.use("Agg")
    from matplotlib import pyplot

    figure, axes = pyplot.subplots(figsize=(5.5, 4))
    for code, marker in ((OURS, "o"), (PEER, "s")):
        if runs.get(code):
            axes.loglog([r.seconds for r in runs[code]],
                        [100 * r.error for r in runs[code]], marker, label=code)
    axes.set(title=title, xlabel="processor time [s]", ylabel="error [%]")
    axes.grid(which="both", alpha=0.3)
    axes.legend()
    figure.tight_layout()
    file = page.parent / "pictures" / f"shell-{name}.png"
    file.parent.mkdir(exist_ok=True)
    figure.savefig(file, metadata={"Software": None})
    pyplot.close(figure)
    return f"![Error against time](pictures/{file.name})"


def sameError(runs):
    """Headline and table; nothing without the peer."""
    if not runs.get(PEER):
        return []
    fronts = {code: Front([r.seconds for r in runs[code]],
                          [r.error for r in runs[code]]) for code in runs}
    found = levels(fronts[OURS], fronts[PEER])
    ratios = ", ".join(interval(*one.ratio) for one in found)
    return [
        f"**ccx takes {ratios} times our time for its errors (coarse to"
        " fine).**",
        table(("same error [%]", "ccx [s]", f"{OURS} [s]", "ratio"),
              [(100 * one.error, one.peer, interval(*one.ours),
                interval(*one.ratio)) for one in found])]


def startUp(problem, folder, options):
    """What of our time is the start; nothing where that is of no account."""
    if not hasattr(problem, "startUp"):
        return ""
    seconds = statistics.median(problem.startUp(folder / f"startUp-{k}")
                                for k in range(options.repeat))
    return (f"Of each of our runs {seconds:.3f} s pass before the first step:"
            " loading OpenFOAM and the libraries, reading its settings and the"
            " case.")


def compared(name, options):
    problem = PROBLEMS[name]()
    ours, peers = (problem.quick if options.quick
                   else (problem.ourChoices, problem.peerChoices))
    with tempfile.TemporaryDirectory() as folder:
        folder = Path(folder)
        if hasattr(problem, "prepare"):
            problem.prepare(folder / "reference", options.quick)
        runs = {OURS: measured(problem.ours, problem.ourMesh, ours, folder,
                               options, OURS)}
        start = startUp(problem, folder, options)
        if ccx.available():
            runs[PEER] = measured(problem.peer, problem.peerMesh, peers,
                                  folder, options, PEER)
    rows = [(code, r.mesh, r.seconds, 100 * r.error)
            for code in runs for r in runs[code]]
    head, *same = sameError(runs) or [""]
    parts = [
        f"### {problem.title}", head,
        f"Error: {problem.says}. {conditions(options)}",
        table(("code", "mesh", "processor time [s]", "error [%]"), rows),
        *same, start]
    if options.page:
        parts.append(plot(name, problem.title, runs, options.page))
    return "\n\n".join(part for part in parts if part)


def main(words):
    options = parsed(words)
    try:
        expectMarks(options.page, *(f"shell {p}" for p in options.parts))
        if not ccx.available() and options.parts != ["costs"]:
            print("ccx is not on the path (Debian's package calculix-ccx): only"
                  " our side runs, the page is left as it is", flush=True)
            options.page = None if not options.quick else options.page
        for part in options.parts:
            text = (costs(options) if part == "costs"
                    else compared(part, options))
            print(f"\n{text}\n", flush=True)
            if options.page:
                replaceBetween(options.page, f"shell {part}", text)
    except NoMarks as problem:
        sys.exit(f"shell: error: {problem}")
    except subprocess.CalledProcessError as problem:
        sys.exit(f"shell: error: {problem}")


if __name__ == "__main__":
    main(sys.argv[1:])
