"""A case of positionalShellFoam, and the processor time of its run."""
from ccx import children
from foamCase import FoamCase
from foamEnvironment import environment
from shellCase import ShellCase, entries
from shellFiles import readState


class ShellRun(ShellCase):
    """ShellCase with dynamics, and with the time of the whole program."""

    def run(self, loads, endTime, steps, probe=None, idle=False,
            **properties):
        """probe: a point whose displacement is recorded in every step; idle:
        end before the first step."""
        self.writeMesh()
        self.write("constant/shellProperties", "dictionary", entries(
            {**self.properties, "loads": loads, **properties}))
        control = {
            "application": "positionalShellFoam", "startFrom": "startTime",
            "startTime": 0, "stopAt": "endTime", "endTime": repr(0 if idle else endTime),
            "deltaT": repr(endTime / steps), "writeControl": "timeStep",
            "writeInterval": steps, "writeFormat": "ascii",
            "writePrecision": 12, "timeFormat": "general",
            "timePrecision": 12}
        if probe:
            control["functions"] = {"probe": {
                "type": "shellProbes", "libs": "(shockShellFunctionObjects)",
                "points": "((%.12g %.12g %.12g))" % tuple(probe),
                "fields": "(displacement)", "writePrecision": 12}}
        self.write("system/controlDict", "dictionary", entries(control))

        self.case = FoamCase(self.folder / "source", self.folder / "case")
        # Made once, by a shell of its own: before the clock starts
        environment().update(OMP_NUM_THREADS="1", OPENBLAS_NUM_THREADS="1")
        before = children()
        self.case.run("positionalShellFoam")
        self.seconds = children() - before
        return self

    def displacement(self, time):
        state = readState(self.case, time)
        return state["position"] - self.mesh.nodes

    def history(self):
        """(times, displacements of the probe)"""
        _, table = self.case.history("probe/0/displacement.dat")
        return table[:, 0], table[:, 1:4]
