"""Tables of function objects (.dat, .csv) and of references, by column."""
import re
from pathlib import Path

import numpy as np

from plotting.errors import PlotError, oneOf

NUMBER = r"[-+]?(?:\d+\.?\d*|\.\d+)(?:[eE][-+]?\d+)?"
COLUMN = re.compile(
    rf"(?P<name>.+?)(?:\*(?P<factor>{NUMBER}))?(?P<shift>[-+]{NUMBER[5:]})?")


class Table:
    """Rows of numbers with names of their columns; text columns are nan."""

    def __init__(self, path, names, rows):
        self.path, self.names, self.rows = path, names, rows

    def column(self, words):
        """Of a name or number: NAME, NAME*FACTOR, NAME*FACTOR-SHIFT."""
        words = words.strip()
        if words in self.names:
            return self._values(words)
        match = COLUMN.fullmatch(words)
        values = self._values(match["name"])
        return values*float(match["factor"] or 1) + float(match["shift"] or 0)

    def _values(self, name):
        if name in self.names:
            return self.rows[:, self.names.index(name)]
        if name.isdigit() and int(name) < self.rows.shape[1]:
            return self.rows[:, int(name)]
        raise PlotError(
            f"{self.path}: no column {name}; there are"
            f" {oneOf(self.names, 40)}, or numbers from 0 to"
            f" {self.rows.shape[1] - 1}")


def number(word):
    try:
        return float(word)
    except ValueError:
        return np.nan


def readTable(path):
    """A .csv file, or one with columns between blanks; names from the last
    line that is a comment, or from a first line that is not numbers."""
    path = Path(path)
    if not path.is_file():
        raise PlotError(f"{path}: no such file")
    commas = path.suffix == ".csv"
    names, rows = [], []
    for line in path.read_text(errors="replace").splitlines():
        comment = line.startswith("#")
        words = line.lstrip("# ") if comment else line
        if not commas:
            words = words.replace("(", " ").replace(")", " ")
        words = [w.strip() for w in (words.split(",") if commas
                                     else words.split())]
        if comment:
            names = words if not rows else names
        elif any(words):
            if not rows and np.isnan(number(words[0])) and words[0] != "nan":
                names = words
                continue
            rows.append([number(word) for word in words])
    if not rows:
        raise PlotError(f"{path}: no rows in it yet")
    # The row being written by a run
    if len(rows) > 1 and len(rows[-1]) < len(rows[0]):
        rows.pop()
    uneven = [i for i, row in enumerate(rows, 1) if len(row) != len(rows[0])]
    if uneven:
        raise PlotError(f"{path}: row {uneven[0]} has {len(rows[uneven[0]-1])}"
                        f" columns, the first one {len(rows[0])}")
    if len(names) != len(rows[0]):
        names = []
    return Table(path, names, np.array(rows))


def history(case, name):
    """A table of the case: a file, or <function object>/<file> below
    postProcessing without the start time, with which restarts are joined."""
    case = Path(case)
    name = re.sub(r"^postProcessing/", "", name)
    for path in (case / name, case / "postProcessing" / name):
        if path.is_file():
            return readTable(path)
    folder, file = Path(name).parent, Path(name).name
    parts = sorted(
        (path for path in (case / "postProcessing" / folder).glob(f"*/{file}")
         if not np.isnan(number(path.parent.name))),
        key=lambda path: float(path.parent.name))
    if not parts:
        there = sorted({
            f"{p.parent.parent.name}/{p.name}"
            for p in (case / "postProcessing").glob("*/*/*") if p.is_file()})
        raise PlotError(
            f"no postProcessing/{folder}/<time>/{file} in {case.resolve()}:"
            f" run the case first; there are: {oneOf(there)}")
    tables = [readTable(part) for part in parts]
    rows = tables[0].rows
    for part, table in zip(parts[1:], tables[1:]):
        # A run begun anew from an earlier time replaces what came after it
        rows = np.vstack([rows[rows[:, 0] <= float(part.parent.name)],
                          table.rows])
    return Table(parts[0], tables[-1].names, rows)
