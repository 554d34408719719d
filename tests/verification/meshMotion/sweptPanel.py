"""A panel that bends towards a wall: the room of cases/panel, but narrow.

The panel (0.3 m high, 40 mm thick) becomes a circular arc without change of
length; its tip covers a given part of the gap between it and the wall.
"""
import re
from pathlib import Path

import numpy as np

from foamCase import FoamCase

from boundaryMesh import BoundaryMesh

HEIGHT, HALF, WALL = 0.3, 0.02, 0.2
FIELD = "0/pointDisplacement"


def arcAngle(part):
    """Angle of the arc at the tip, for the tip's centre to get so far."""
    wanted = part*(WALL - HALF)/HEIGHT
    low, high = 1e-9, 2.0
    for _ in range(100):
        middle = (low + high)/2
        if (1 - np.cos(middle))/middle < wanted:
            low = middle
        else:
            high = middle
    return low


def bent(points, angle):
    """Displacement of points of the panel."""
    x, y = points[:, 0], points[:, 1]
    turn, radius = angle*y/HEIGHT, HEIGHT/angle
    return np.column_stack([
        radius*(1 - np.cos(turn)) + x*np.cos(turn) - x,
        radius*np.sin(turn) - x*np.sin(turn) - y,
        0*x,
    ])


class SweptPanel(FoamCase):
    def __init__(self, folder, part, **coeffs):
        super().__init__(Path(__file__).parent/"cases"/"panel", folder)
        mesh = self.path/"system"/"blockMeshDict"
        mesh.write_text(re.sub(r"\((\s*-?)0\.5 ", rf"(\g<1>{WALL} ",
                               mesh.read_text()))
        self.run("blockMesh")
        for keyword, value in coeffs.items():
            self.set("constant/dynamicMeshDict",
                     f"inverseDistanceCoeffs/{keyword}", value)
        faces = BoundaryMesh(self)
        order = list(dict.fromkeys(
            int(p) for face in faces.patchFaces("panel") for p in face))
        self.bend(bent(faces.points[order], arcAngle(part)))

    def bend(self, values):
        rows = " ".join("(%.17g %.17g %.17g)" % tuple(v) for v in values)
        self.set(FIELD, "boundaryField/panel", "{ type fixedValue; value"
                 f" nonuniform List<vector> {len(values)} ({rows}); }}")

    def moved(self, check=True):
        """The log of the motion."""
        return self.run("moveDynamicMesh", check=check)


def leastRatio(log):
    """The last of the log."""
    return float(re.findall(r"least volume ratio (\S+),", log)[-1])
