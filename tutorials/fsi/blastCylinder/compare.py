"""Table of the runs of this folder: coupled, and the shell alone.

    compare.py [<run folder> ...]       default: all of runs/
"""
import sys
from pathlib import Path

HERE = Path(__file__).resolve().parent
sys.dont_write_bytecode = True
sys.path.insert(0, str(HERE.parents[1] / "plotting"))

from blastRuns import (  # noqa: E402
    AMBIENT, history, largest, positivePhase, printTable)

MAPPED = 5.6e-4  # s, mapTime of system/parameters
HEADS = ("run", "place", "peak [kPa]", "impulse [Pa s]", "coupled [mm]",
         "at [ms]", "shell alone [mm]", "at [ms]")


def rows(folder):
    tube = history(folder, "tube", "displacement.dat")
    face = history(folder, "face", "p.dat")
    alone = history(folder / "alone", "tube", "displacement.dat")
    for i, (name, axis) in enumerate(
            (("front", 0), ("flank", 1), ("rear", 0))):
        peak, impulse = positivePhase(face[:, 0], face[:, 1 + i] - AMBIENT)
        row = [folder.resolve().name if i == 0 else "", name,
               f"{peak/1e3:.0f}", f"{impulse:.0f}"]
        column = 1 + 3*i + axis
        for table, start in ((tube, MAPPED), (alone, 0)):
            time, moved = largest(table[:, 0] + start, table[:, column])
            row += [f"{1e3*moved:.2f}", f"{1e3*time:.2f}"]
        yield row


if __name__ == "__main__":
    printTable(HEADS, rows, sys.argv[1:], HERE / "runs")
