r"""Cost of the mesh motion inverseDistance against the direct sum.

    tests/benchmarks/inverseDistance/run [-sizes <n> ...]
        [-tolerances <t> ...] [-quick] [-page <file>] [-noPage]

A unit square and a unit cube of equal cells, the boundary fixed, with a panel
inside that bends and stretches. The direct sum is taken over all sources at
1000 of the points, in turn with the fast one. Writes the table into the page,
by default doc/performance.md.

    -sizes <n> ...        about how many points, default 10000 100000 1000000
                          (4 GB)
    -tolerances <t> ...   default 0.01, that of inverseDistance
    -quick                tiny meshes, only to see that everything works; no
                          page unless it is named
    -page <file>          another page
    -noPage               print only
"""
import math
import os
import subprocess
import sys
from pathlib import Path

HERE = Path(__file__).resolve().parent
PROJECT = HERE.parents[2]
sys.path[:0] = [str(PROJECT / "tests" / "tools"),
                str(PROJECT / "tests" / "benchmarks" / "common")]

from foamEnvironment import environment  # noqa: E402
from machine import facts, load  # noqa: E402
from options import Parser  # noqa: E402
from page import NoMarks, expectMarks, replaceBetween, table  # noqa: E402

HEAD = ("dimensions", "tolerance", "points", "moving", "fixed",
        "weights per point", "over log2 of moving", "bytes per point",
        "set-up [us per point]", "application [us per point]",
        "set-up over direct sum", "application over direct sum",
        "error", "bound")


def parsed(words):
    parser = Parser(__doc__)
    parser.add_argument("-sizes", type=int, nargs="+")
    parser.add_argument("-tolerances", type=float, nargs="+", default=[0.01])
    options = parser.parse(words, repeat=1)
    options.sizes = options.sizes or (
        [1000, 4000] if options.quick else [10000, 100000, 1000000])
    parser.choosePage(options, usual=True)
    return options


def program():
    """The compiled benchmark.C."""
    subprocess.run(["wmake", "-s", str(HERE)], check=True, env=environment(),
                   stdout=subprocess.DEVNULL)
    return os.path.join(environment()["SHOCKSHELL_APPBIN"], "benchmarks",
                        "inverseDistance")


def row(executable, dimensions, size, tolerance):
    said = subprocess.run(
        [executable, str(dimensions), str(size), str(tolerance)],
        stdout=subprocess.PIPE, check=True, universal_newlines=True,
        env=environment()).stdout.split()
    points, moving, fixed = map(int, said[:3])
    weights, _, memory, *rest = map(float, said[3:])
    *rest, error, bound = rest
    return (dimensions, tolerance, points, moving, fixed, weights,
            weights / math.log2(moving), memory, *rest,
            f"{error:.1e}", f"{bound:.1e}")


def exponent(rows, column):
    """Of the growth of points times column with the number of points."""
    one, other = rows[0], rows[-1]
    return math.log(other[2]*other[column] / (one[2]*one[column])) / math.log(
        other[2] / one[2])


def growth(rows):
    """How cost and memory grow, one sentence for each kind of mesh."""
    text = []
    for dimensions, tolerance in dict.fromkeys(r[:2] for r in rows):
        kind = [r for r in rows if r[:2] == (dimensions, tolerance)]
        text.append(
            f"- {dimensions} dimensions, tolerance {tolerance:g}: from"
            f" {kind[0][2]:,} to {kind[-1][2]:,} points the time of an"
            f" application grows as N^{exponent(kind, 9):.2f}, that of set-up"
            f" as N^{exponent(kind, 8):.2f}, memory as"
            f" N^{exponent(kind, 7):.2f}; moving times all points, the terms"
            f" of the direct sum, as N^{exponent(kind, 3):.2f}.")
    return "\n".join(text)


def main(words):
    options = parsed(words)
    try:
        expectMarks(options.page, "inverseDistance")
        executable = program()
        rows = []
        for dimensions in (2, 3):
            for tolerance in options.tolerances:
                for size in options.sizes:
                    rows.append(row(executable, dimensions, size, tolerance))
                    print(*rows[-1], flush=True)
        text = (f"{facts()}; load of the machine at the end {load():.1f}.\n\n"
                + table(HEAD, rows) + "\n\n" + growth(rows))
        print(f"\n{text}", flush=True)
        if options.page:
            replaceBetween(options.page, "inverseDistance", text)
    except NoMarks as problem:
        sys.exit(f"inverseDistance: error: {problem}")


if __name__ == "__main__":
    main(sys.argv[1:])
