"""Dynamic benchmarks as cases: meshes of several surfaces, and their motion."""
import numpy as np

from foamCase import FoamCase
from shellCase import ShellCase, entries

TABLES = "shockShellFunctionObjects"


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
        self.writeMesh()
        properties = {**self.properties, "analysis": "dynamic",
                      "timeIntegrator": integrator, "loads": loads}
        if newton:
            properties["newton"] = newton
        self.write("constant/shellProperties", "dictionary",
                   entries(properties))
        functions = {"energies": {
            "type": "shellEnergyTable", "libs": (TABLES,),
            "writePrecision": 16}}
        if points:
            text = " ".join("(%.17g %.17g %.17g)" % tuple(p) for p in points)
            functions["probes"] = {
                "type": "shellProbes", "libs": (TABLES,),
                "points": f"({text})", "fields": ("displacement",)}
        steps = round(endTime/deltaT)
        self.write("system/controlDict", "dictionary", entries({
            "application": "positionalShellFoam", "startFrom": "startTime",
            "startTime": 0, "stopAt": "endTime", "endTime": endTime,
            "deltaT": deltaT, "writeControl": "timeStep",
            "writeInterval": steps, "writeFormat": "ascii",
            "writePrecision": 12, "timeFormat": "general",
            "timePrecision": 12, "functions": functions,
        }))
        self.case = FoamCase(self.folder/"source", self.folder/"case")
        self.log = self.case.run("positionalShellFoam")
        if not points:
            return None
        _, rows = self.case.history("probes/0/displacement.dat")
        return rows[:, 0], rows[:, 1:].reshape(len(rows), len(points), 3)

    def table(self, name):
        """{column: values} of energies or momenta."""
        names, rows = self.case.history(f"energies/0/{name}.dat")
        return dict(zip(names, rows.T))
