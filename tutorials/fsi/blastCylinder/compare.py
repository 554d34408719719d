"""Table of the runs of this folder: coupled, and the shell alone.

    compare.py [<run folder> ...]       default: all of runs/
"""
import sys
from pathlib import Path

import numpy as np

HERE = Path(__file__).resolve().parent
AMBIENT = 101325.0  # Pa
MAPPED = 5.6e-4     # s, mapTime of system/parameters


def history(folder, name):
    parts = sorted((folder / "postProcessing").glob(f"{name[0]}/*/{name[1]}"),
                   key=lambda path: float(path.parent.name))
    if not parts:
        sys.exit(f"{folder}: no postProcessing/{name[0]}: run ./Allrun first")
    return np.vstack([np.loadtxt(part, ndmin=2) for part in parts])


def largest(t, values):
    """Time and value of the largest magnitude."""
    i = abs(values).argmax()
    return t[i], values[i]


def positivePhase(t, over):
    """Peak and impulse until the overpressure first falls below zero."""
    start = np.flatnonzero(over > 0.05*over.max())[0]
    below = np.flatnonzero(over[start:] < 0)
    end = start + (below[0] if len(below) else len(over) - start)
    t, over = t[start:end], over[start:end]
    return over.max(), (np.diff(t)*(over[1:] + over[:-1])/2).sum()


def rows(folder):
    tube = history(folder, ("tube", "displacement.dat"))
    face = history(folder, ("face", "p.dat"))
    alone = history(folder / "alone", ("tube", "displacement.dat"))
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


def main(folders):
    folders = [Path(f) for f in folders] or sorted((HERE / "runs").glob("*"))
    print("| run | place | peak [kPa] | impulse [Pa s] | coupled [mm] "
          "| at [ms] | shell alone [mm] | at [ms] |")
    print("|---" * 8 + "|")
    for folder in folders:
        for row in rows(folder):
            print("| " + " | ".join(row) + " |")


if __name__ == "__main__":
    main(sys.argv[1:])
