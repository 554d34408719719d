"""The table of results: tests with exact answers add their rows to it.

With SHOCKSHELL_TABLE=<file> in the environment the rows are appended to that
file, one JSON object per line, for writeTable.py.
"""
import json
import os

import numpy as np
import pytest


def written(value):
    if isinstance(value, str):
        return value
    if np.ndim(value) > 0:
        return " ".join(written(v) for v in value)
    return f"{value:.4g}"


class Table:

    def __init__(self):
        self.rows = []

    def add(self, case, quantity, ours, reference, bound):
        """One row; numbers or lists of numbers, or words."""
        row = {"case": case, "quantity": quantity, "ours": ours,
               "reference": reference, "bound": bound}
        self.rows.append({k: written(v) for k, v in row.items()})
        print(self.rows[-1])


@pytest.fixture
def table(request):
    table = Table()
    yield table
    file = os.environ.get("SHOCKSHELL_TABLE")
    if file:
        with open(file, "a") as stream:
            for row in table.rows:
                stream.write(json.dumps(row) + "\n")
