"""Tables of runs of a shell under a blast: the histories of a run's
postProcessing, what they peak at, and the table as text."""
import sys
from pathlib import Path

import numpy as np

AMBIENT = 101325.0  # Pa


def history(folder, name, file):
    """Rows of postProcessing/<name>/<time>/<file>; restarts follow each
    other."""
    parts = sorted((folder / "postProcessing").glob(f"{name}/*/{file}"),
                   key=lambda path: float(path.parent.name))
    if not parts:
        sys.exit(f"{folder}: no postProcessing/{name}: run ./Allrun first")
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


def printTable(heads, rowsOf, folders, default):
    """Rows of each folder, of those in default when none is given."""
    folders = [Path(f) for f in folders] or sorted(default.glob("*"))
    print("| " + " | ".join(heads) + " |")
    print("|---"*len(heads) + "|")
    for folder in folders:
        for row in rowsOf(folder):
            print("| " + " | ".join(row) + " |")
