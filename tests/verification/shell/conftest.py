"""The table of results: every benchmark of the shell adds its rows to it.

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
    return f"{value:.5g}"


class Table:

    def __init__(self):
        self.rows = []

    def add(self, case, mesh, quantity, ours, reference, source, bound):
        """One row; ours and reference: numbers or lists (one per mesh)."""
        row = {
            "case": case, "mesh": mesh, "quantity": quantity, "ours": ours,
            "reference": reference, "source": source, "bound": bound,
        }
        self.rows.append({k: written(v) for k, v in row.items()})
        print(self.rows[-1])

    def check(self, case, meshes, quantity, ours, reference, source, bounds):
        """A row, and every mesh within its bound, in percent of the reference.
        """
        self.add(case, meshes, quantity, ours, reference, source,
                 " ".join(f"{b:g} %" for b in bounds))
        for mesh, value, bound in zip(meshes, ours, bounds):
            error = 100*(value/reference - 1)
            assert abs(error) <= bound, f"{case}, {mesh}: {error:.3f} %"

    def below(self, case, meshes, quantity, errors, source, bounds):
        """A row of errors in percent, and each of them within its bound."""
        self.add(case, meshes, quantity, errors, 0, source,
                 " ".join(f"{b:g} %" for b in bounds))
        for mesh, error, bound in zip(meshes, errors, bounds):
            assert error <= bound, f"{case}, {mesh}: {error:.3f} %"


@pytest.fixture
def table(request):
    table = Table()
    yield table
    file = os.environ.get("SHOCKSHELL_TABLE")
    if file:
        with open(file, "a") as stream:
            for row in table.rows:
                stream.write(json.dumps(row) + "\n")
