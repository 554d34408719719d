r"""Runs the benchmarks of the shell and writes their results into
doc/verification.md.

    "$(etc/python numpy pytest)" \
        tests/verification/shell/writeTable.py \
        [-long] [<pytest options, such as -k hemisphere>]

The rows of the tests that ran replace all those between the two marks of the
page. The exit code is pytest's.
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
BEGIN = "<!-- shellBenchmarks: written by writeTable.py -->"
END = "<!-- shellBenchmarks: end -->"
FILES = [
    "test_shellLinear.py", "test_shellNonlinear.py", "test_shellMotion.py",
]
COLUMNS = ["case", "mesh", "quantity", "ours", "reference", "source", "bound"]


def lines(rows):
    yield "| " + " | ".join(COLUMNS) + " |"
    yield "|---"*len(COLUMNS) + "|"
    for row in rows:
        yield "| " + " | ".join(row[c] for c in COLUMNS) + " |"


def main():
    arguments = ["--long" if a == "-long" else a for a in sys.argv[1:]]
    with tempfile.TemporaryDirectory() as folder:
        file = Path(folder) / "rows"
        file.touch()
        code = subprocess.run(
            [sys.executable, "-m", "pytest", "-q", "-p", "no:cacheprovider",
             *(HERE / name for name in FILES), *arguments],
            cwd=PROJECT / "tests",
            env={**os.environ, "SHOCKSHELL_TABLE": str(file)},
        ).returncode
        rows = [json.loads(line) for line in file.read_text().splitlines()]
    if not rows:
        sys.exit(f"no rows; pytest ended with {code}")
    before, rest = PAGE.read_text().split(BEGIN)
    after = rest.split(END)[1]
    PAGE.write_text(
        before + BEGIN + "\n\n" + "\n".join(lines(rows)) + "\n\n" + END + after)
    sys.exit(code)


if __name__ == "__main__":
    main()
