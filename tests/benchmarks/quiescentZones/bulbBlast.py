r"""Processor time of a bulb blast in still air, with and without quiescent
zones, until the wave fills half of the domain.

    tests/benchmarks/quiescentZones/run [-cells <n>] [-repeat <n>]

An eighth of the bulb stands in the corner of a cube, whose three sides there
are planes of symmetry and whose others are far fields. The time at which the
pressure of half of the nodes has changed by more than 1 % is found with 24
cells along a side. Runs with and without zones follow each other.

    -cells <n>    along a side of the cube, default 60
    -repeat <n>   median of n runs, default 3
"""
import argparse
import re
import statistics
import sys
import tempfile
from pathlib import Path

HERE = Path(__file__).resolve().parent
PROJECT = HERE.parents[2]
sys.path[:0] = [str(PROJECT / "tests" / folder) for folder in (
    "tools", "verification/gasBenchmarks", "benchmarks/common")]

import numpy as np  # noqa: E402

from benchmarkCase import BenchmarkCase  # noqa: E402
from blockMeshes import box  # noqa: E402
from machine import facts, load  # noqa: E402
from runLog import RunLog  # noqa: E402

# source: Suzuki and Sanches, section 5.2: 2967 kPa, 1134.85 K in air of
# 100 kPa, 290.36 K; here in units of the air's pressure and density
BULB_P = 29.67
BULB_RHO = 29.67 * 290.36 / 1134.85

# Of the cube's side: the bulb has a radius of 0.5 m, the cube a side of 4 m
RADIUS = 0.125

ARRIVED = 0.01


def bulb(x):
    inside = (x**2).sum(axis=1) < RADIUS**2
    return (np.where(inside, BULB_RHO, 1.0), 0.0,
            np.where(inside, BULB_P, 1.0))


def blastCase(folder, n):
    case = BenchmarkCase(folder, box([(1, n)], (1, n), (1, n)))
    case.start(bulb, {
        "left": "wall", "bottom": "wall", "back": "wall",
        "right": "far", "top": "far", "front": "far",
    })
    return case


def choose(case, zones):
    case.write("system/feSchemes",
               f"timeScheme twoStep; quiescentZones {zones};")


def timeOfHalf(folder):
    """When the wave has reached half of the nodes."""
    case = blastCase(folder, 24)
    case.runTo(1, writeInterval=0.02)
    for time in sorted(case.times(), key=float):
        p = case.result("p", time)
        if np.mean(np.abs(p - 1) > ARRIVED) >= 0.5:
            return float(time)
    raise RuntimeError("the wave does not fill half of the domain")


def measure(case, zones, end):
    choose(case, zones)
    case.runTo(end, timeout=3600)
    shares = [float(s) for s in
              re.findall(r"zones: (\S+) % of the gas is active", case.log)]
    return RunLog(case.log), case.result("p"), shares


def main(words):
    parser = argparse.ArgumentParser(
        prog="run", usage=__doc__, allow_abbrev=False)
    parser.add_argument("-cells", type=int, default=60)
    parser.add_argument("-repeat", type=int, default=3)
    options = parser.parse_args(words)

    print(facts())
    with tempfile.TemporaryDirectory() as folder:
        folder = Path(folder)
        end = timeOfHalf(folder / "coarse")
        case = blastCase(folder / "fine", options.cells)
        ratios, same = [], True
        print(f"{(options.cells + 1)**3} nodes, half filled at time {end:g};"
              f" load {load()}")
        for _ in range(options.repeat):
            on, pOn, shares = measure(case, "on", end)
            off, pOff, _ = measure(case, "off", end)
            same = same and np.array_equal(pOn, pOff)
            ratios.append(off.seconds / on.seconds)
            print(f"with zones {on.seconds:.2f} s, without"
                  f" {off.seconds:.2f} s in {on.steps} steps: ratio"
                  f" {ratios[-1]:.2f}; active at the end {shares[-1]:.0f} %")
        print(f"median ratio {statistics.median(ratios):.2f}, fields"
              f" {'the same' if same else 'DIFFERENT'} bit for bit")
    return 0 if same else 1


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
