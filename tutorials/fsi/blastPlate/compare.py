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

MAPPED = 1.4e-3  # s, mapTime of system/parameters
HEADS = ("run", "place", "peak [kPa]", "impulse [Pa s]", "deflection [mm]",
         "at [ms]")


def rows(folder):
    plate = history(folder, "plate", "displacement.dat")
    face = history(folder, "face", "p.dat")
    time, deflection = largest(plate[:, 0] + MAPPED, plate[:, 1])
    for place, name in ((1, "middle"), (3, "edge")):
        peak, impulse = positivePhase(face[:, 0], face[:, place] - AMBIENT)
        yield (folder.resolve().name if place == 1 else "",
               name, f"{peak/1e3:.0f}", f"{impulse:.0f}",
               f"{1e3*deflection:.2f}" if place == 1 else "",
               f"{1e3*time:.2f}" if place == 1 else "")
    alone = history(folder / "alone", "plate", "displacement.dat")
    time, deflection = largest(alone[:, 0], alone[:, 1])
    yield ("  shell alone, Kingery-Bulmash", "", "", "",
           f"{1e3*deflection:.2f}", f"{1e3*time:.2f}")


if __name__ == "__main__":
    printTable(HEADS, rows, sys.argv[1:], HERE / "runs")
