"""Dynamic benchmarks as cases: meshes of several surfaces, and their motion."""
from pathlib import Path

import numpy as np

from shellCase import ShellCase

HERE = Path(__file__).resolve().parent
TABLES = "shockShellFunctionObjects"


def reference(name):
    """Rows of a table of reference/: times and deflections."""
    rows = []
    for line in (HERE / "reference" / name).read_text().splitlines():
        try:
            rows.append([float(v) for v in line.split(",")])
        except ValueError:
            assert line.startswith(("#", "t,")), line
    return np.array(rows)


def greatestDifference(times, computed, table, until):
    """Of the columns (time, column) from those of a reference up to a time, in
    percent of the reference's greatest value; both from rest."""
    table = table[table[:, 0] <= until*(1 + 1e-9)]
    found = np.stack([
        np.interp(table[:, 0], np.insert(times, 0, 0), np.insert(c, 0, 0))
        for c in computed.T], axis=-1)
    return 100*abs(found - table[:, 1:]).max()/abs(table[:, 1:]).max()


class Joined:
    """Surfaces that share the nodes of their common edges.

    sets: {name: function of the nodes' coordinates to a truth value}
    """

    def __init__(self, surfaces, sets):
        nodes = np.vstack([s.nodes for s in surfaces])
        directors = np.vstack([s.directors for s in surfaces])
        scale = 1e-7*np.ptp(nodes, axis=0).max()
        _, first, number = np.unique(
            np.round(nodes/scale).astype(int), axis=0, return_index=True,
            return_inverse=True)
        number = number.ravel()
        self.nodes, self.directors = nodes[first], directors[first]
        self.triangles, start = [], 0
        for s in surfaces:
            self.triangles += [number[np.array(t) + start]
                               for t in s.triangles]
            start += len(s.nodes)
        self.sets = {name: np.flatnonzero(belongs(self.nodes))
                     for name, belongs in sets.items()}
        self.size = " + ".join(s.size for s in surfaces)


class MovingCase(ShellCase):
    """A shell in motion from rest, with probes and tables."""

    def march(self, loads, endTime, deltaT, integrator="Newmark", points=(),
              newton=None):
        """Displacements of the points: times, (time, point, component)."""
        self.begin(loads, analysis="dynamic", timeIntegrator=integrator,
                   **({"newton": newton} if newton else {}))
        functions = {"energies": {
            "type": "shellEnergyTable", "libs": (TABLES,),
            "writePrecision": 16}}
        if points:
            text = " ".join("(%.17g %.17g %.17g)" % tuple(p) for p in points)
            functions["probes"] = {
                "type": "shellProbes", "libs": (TABLES,),
                "points": f"({text})", "fields": ("displacement",)}
        steps = round(endTime/deltaT)
        self.control(endTime=endTime, deltaT=deltaT, writeInterval=steps,
                     functions=functions)
        self.start()
        if not points:
            return None
        _, rows = self.case.history("probes/0/displacement.dat")
        return rows[:, 0], rows[:, 1:].reshape(len(rows), len(points), 3)

    def table(self, name):
        """{column: values} of energies or momenta."""
        names, rows = self.case.history(f"energies/0/{name}.dat")
        return dict(zip(names, rows.T))
