r"""Runs the coupled cases with exact answers and writes their results into
doc/verification.md.

    "$(etc/python numpy pytest)" tests/verification/fsi/writeTable.py \
        [-long] [<pytest options, such as -k flutter>]

The rows of the tests that ran replace all those between the two marks of the
page. The exit code is pytest's.
"""
import sys
from pathlib import Path

HERE = Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parents[1] / "tools"))

from resultPage import writePage  # noqa: E402

FILES = ["test_platesInGas.py", "test_closedBox.py", "test_panelFlutter.py"]
COLUMNS = ("case", "quantity", "ours", "reference", "bound")


def lines(rows):
    yield "| " + " | ".join(COLUMNS) + " |"
    yield "|---" * len(COLUMNS) + "|"
    for row in rows:
        yield "| " + " | ".join(row[c] for c in COLUMNS) + " |"


if __name__ == "__main__":
    sys.exit(writePage("fsiBenchmarks", lines, [HERE / f for f in FILES]))
