r"""Runs the benchmarks of the shell and writes their results into
doc/verification.md.

    "$(etc/python numpy pytest)" \
        tests/verification/shell/writeTable.py \
        [-long] [<pytest options, such as -k hemisphere>]

The rows of the tests that ran replace all those between the two marks of the
page. The exit code is pytest's.
"""
import sys
from pathlib import Path

HERE = Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parents[1] / "tools"))

from resultPage import writePage  # noqa: E402

FILES = [
    "test_shellLinear.py", "test_shellNonlinear.py", "test_shellPaths.py",
    "test_shellFrequencies.py", "test_shellStrips.py", "test_shellMotion.py",
    "test_shellSections.py", "test_shellPinched.py",
]
COLUMNS = ["case", "mesh", "quantity", "ours", "reference", "source", "bound"]


def lines(rows):
    yield "| " + " | ".join(COLUMNS) + " |"
    yield "|---"*len(COLUMNS) + "|"
    for row in rows:
        yield "| " + " | ".join(row[c] for c in COLUMNS) + " |"


if __name__ == "__main__":
    sys.exit(writePage("shellBenchmarks", lines, [HERE / f for f in FILES]))
