"""Processor time per step of the gas on one mesh, by scheme and by code.

The gas is nowhere uniform (waves of length 1 in all quantities), so that no
part of the mesh can be left out, and steps are of equal length, a fifth of the
shortest crossing of an element by a wave. On a moving mesh all points turn
round the middle of the box: the motion itself costs next to nothing, but all
geometry changes.
"""
import re

import numpy as np

from benchmarkCase import BenchmarkCase
from blockMeshes import box
from peerCase import PeerCase
from runLog import RunLog, middle
from scheme import entries
from tetrahedra import tetrahedra

SPEED = 2.5  # more than |u| + c anywhere

ROTATION = """
dynamicFvMesh dynamicMotionSolverFvMesh;
motionSolverLibs (dynamicMesh);
solver solidBody;
solidBodyCoeffs
{
    solidBodyMotionFunction oscillatingRotatingMotion;
    oscillatingRotatingMotionCoeffs
    { origin (0.5 0.5 0.5); amplitude (1 1 1); omega 20; }
}
"""


def waves(x):
    """rho, U, p: nowhere uniform."""
    s = np.sin(2 * np.pi * x)
    rho = 1 + 0.2 * s[:, 0] * s[:, 1]
    U = 0.3 * np.roll(s, 1, axis=1)
    return rho, U, 1 + 0.2 * s[:, 1] * s[:, 2]


class UnitCube:
    """A cube of n^3 cubes, cut into tetrahedra or as they are."""

    boundary = dict.fromkeys(
        ("left", "right", "bottom", "top", "back", "front"), "wall")

    def __init__(self, folder, n, cut=True):
        self.n, self.cut, self.folder = n, cut, folder
        mesh = tetrahedra((n, n, n), (1, 1, 1), shift=0.15) if cut else \
            box([(1, n)], (1, n), (1, n))
        self.case = BenchmarkCase(folder / "ours", mesh)
        self.case.start(waves, self.boundary)
        self.nodes = (n + 1)**3
        self.cells = n**3 * (5 if cut else 1)
        self.deltaT = 0.2 * (0.5 if cut else 1) / n / SPEED

    def centres(self):
        if self.cut:
            mesh = self.case.mesh
            return mesh.points[mesh.tets].mean(axis=1)
        i = (np.arange(self.n) + 0.5) / self.n
        z, y, x = np.meshgrid(i, i, i, indexing="ij")
        return np.stack([x, y, z], axis=-1).reshape(-1, 3)

    def control(self, steps):
        """Steps of equal length; nothing is written."""
        return {"deltaT": self.deltaT, "adjustTimeStep": "no",
                "writeControl": "timeStep", "writeInterval": 10 * steps,
                "libs": "(dynamicMesh)"}

    def move(self, moving):
        file = self.case.path / "constant" / "dynamicMeshDict"
        if moving:
            self.case.write("constant/dynamicMeshDict", ROTATION)
        elif file.exists():
            file.unlink()

    def ours(self, scheme, moving, steps, repeat):
        """(microseconds per node and step, per simplex and step)."""
        self.case.write("system/feSchemes", entries(*scheme))
        self.move(moving)

        def run():
            self.case.runTo(steps * self.deltaT, timeout=7200,
                            **self.control(steps))
            return RunLog(self.case.log)

        seconds = middle([run() for _ in range(repeat)]).perStep
        simplices = int(re.search(
            r"simplices\s*:\s*(\d+)", self.case.log).group(1))
        return 1e6 * seconds / self.nodes, 1e6 * seconds / simplices

    def peer(self, moving, steps, repeat):
        """Microseconds per cell and step of rhoCentralFoam, of
        rhoCentralDyMFoam when the mesh moves."""
        program = "rhoCentralDyMFoam" if moving else "rhoCentralFoam"
        self.move(moving)
        case = PeerCase(self.folder / f"{program}{moving}", self.case)
        rho, U, p = waves(self.centres())
        case.start({"p": p, "U": U, "T": p / rho}, self.boundary)

        def run():
            case.runTo(steps * self.deltaT, program,
                       **self.control(steps))
            return case.runLog

        return 1e6 * middle(
            [run() for _ in range(repeat)]).perStep / self.cells
