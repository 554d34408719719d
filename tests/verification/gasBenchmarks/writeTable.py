r"""Runs the gas benchmarks and writes their results into doc/verification.md.

    "$(etc/python numpy pytest)" \
        tests/verification/gasBenchmarks/writeTable.py \
        [-long] [<pytest options, such as -k sod>]

The rows of the tests that ran replace all those between the two marks of the
page; tests that fail have a row too. The exit code is pytest's.
"""
import sys
from pathlib import Path

HERE = Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parents[1] / "tools"))

from resultPage import writePage  # noqa: E402

COLUMNS = {
    "case": "case", "mesh": "mesh", "quantity": "quantity", "ours": "ours",
    "order": "observed order", "bound": "bound", "reference": "reference",
    "seconds": "time [s]",
}


def lines(rows):
    """The table, one part per scheme."""
    for scheme in dict.fromkeys(row["scheme"] for row in rows):
        yield f"\nScheme {scheme}:\n"
        yield "| " + " | ".join(COLUMNS.values()) + " |"
        yield "|---" * len(COLUMNS) + "|"
        for row in rows:
            if row["scheme"] == scheme:
                yield "| " + " | ".join(row[c] for c in COLUMNS) + " |"


if __name__ == "__main__":
    sys.exit(writePage("gasBenchmarks", lines, [HERE]))
