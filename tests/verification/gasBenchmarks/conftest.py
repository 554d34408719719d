"""The table of results: every benchmark adds its rows to it.

With SHOCKSHELL_TABLE=<file> in the environment the rows are appended to that
file, one JSON object per line, for writeTable.py.
"""
import json
import os
import re

import numpy as np
import pytest

from scheme import schemeName


def written(value):
    if isinstance(value, str):
        return value
    if np.ndim(value) > 0:
        return " ".join(written(v) for v in value)
    return f"{value:.3g}"


class Table:

    def __init__(self, test):
        self.test, self.rows = test, []

    def add(self, case, mesh, quantity, ours, reference, bound="", order="",
            seconds="", capturing=True):
        """One row; numbers or lists of numbers (one per mesh)."""
        row = {
            "case": case, "mesh": mesh, "quantity": quantity,
            "ours": ours, "bound": bound, "order": order,
            "reference": reference, "seconds": seconds,
            "scheme": schemeName(capturing),
        }
        self.rows.append({k: written(v) for k, v in row.items()})
        print(self.rows[-1])


@pytest.hookimpl(hookwrapper=True)
def pytest_runtest_makereport(item, call):
    """Keeps what the application said, for the row of a test that stops."""
    if call.when == "call" and call.excinfo:
        said = re.search(r"FATAL (?:IO )?ERROR:\s*(.*?)[.,;:]?\s*\n",
                         str(call.excinfo.value))
        item.reason = "stops" + (f": {said.group(1)}" if said else "")
    yield


@pytest.fixture
def table(request):
    table = Table(request.node.name)
    yield table
    file = os.environ.get("SHOCKSHELL_TABLE")
    if not file:
        return
    if not table.rows:
        table.add(request.node.name, "", "run",
                  getattr(request.node, "reason", ""), "runs")
    with open(file, "a") as stream:
        for row in table.rows:
            place = f"{request.node.path.name}::{table.test}"
            stream.write(json.dumps({"test": place, **row}) + "\n")
