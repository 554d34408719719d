r"""Runs the gas benchmarks and writes their results into doc/verification.md.

    "$(etc/python numpy pytest)" \
        tests/verification/gasBenchmarks/writeTable.py \
        [-long] [<pytest options, such as -k sod>]

The rows of the tests that ran replace all those between the two marks of the
page; tests that fail have a row too. The exit code is pytest's.
"""
import json
import os
import subprocess
import sys
import tempfile
from pathlib import Path

HERE = Path(__file__).resolve().parent
PROJECT = HERE.parents[2]
PAGE = PROJECT / "doc" / "verification.md"
BEGIN = "<!-- gasBenchmarks: written by writeTable.py -->"
END = "<!-- gasBenchmarks: end -->"
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


def main():
    arguments = ["--long" if a == "-long" else a for a in sys.argv[1:]]
    with tempfile.TemporaryDirectory() as folder:
        file = Path(folder) / "rows"
        file.touch()
        code = subprocess.run(
            [sys.executable, "-m", "pytest", "-q", "-p", "no:cacheprovider",
             HERE, *arguments],
            cwd=PROJECT / "tests",
            env={**os.environ, "SHOCKSHELL_TABLE": str(file)},
        ).returncode
        rows = [json.loads(line) for line in file.read_text().splitlines()]
    if not rows:
        sys.exit(f"no rows; pytest ended with {code}")
    before, rest = PAGE.read_text().split(BEGIN)
    after = rest.split(END)[1]
    PAGE.write_text(
        before + BEGIN + "\n" + "\n".join(lines(rows)) + "\n\n" + END + after)
    sys.exit(code)


if __name__ == "__main__":
    main()
