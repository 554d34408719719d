"""Runs benchmarks and writes the rows that they add into doc/verification.md.

    sys.exit(writePage("shellBenchmarks", lines, [HERE / "test_a.py"]))

A test appends its rows, one JSON object per line, to the file that the
environment variable SHOCKSHELL_TABLE names. The rows of the tests that ran
replace all those between the two marks of the page.
"""
import json
import os
import subprocess
import sys
import tempfile
from pathlib import Path

PROJECT = Path(__file__).resolve().parents[2]
PAGE = PROJECT / "doc" / "verification.md"


def between(text, mark, lines):
    """The text of a page with new lines between the marks."""
    begin = f"<!-- {mark}: written by writeTable.py -->"
    end = f"<!-- {mark}: end -->"
    before, rest = text.split(begin)
    after = rest.split(end)[1]
    table = "\n".join(lines).strip("\n")
    return f"{before}{begin}\n\n{table}\n\n{end}{after}"


def writePage(mark, lines, tests, words=None):
    """lines: function of the rows; words: options for pytest, -long for
    --long, by default those of the command line. Pytest's exit code."""
    if words is None:
        words = sys.argv[1:]
    words = ["--long" if word == "-long" else word for word in words]
    with tempfile.TemporaryDirectory() as folder:
        file = Path(folder) / "rows"
        file.touch()
        code = subprocess.run(
            [sys.executable, "-m", "pytest", "-q", "-p", "no:cacheprovider",
             *tests, *words],
            cwd=PROJECT / "tests",
            env={**os.environ, "SHOCKSHELL_TABLE": str(file)},
        ).returncode
        rows = [json.loads(line) for line in file.read_text().splitlines()]
    if not rows:
        sys.exit(f"no rows; pytest ended with {code}")
    PAGE.write_text(between(PAGE.read_text(), mark, lines(rows)))
    return code
