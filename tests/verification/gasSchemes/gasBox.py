"""A box of gas with a mesh of lines, triangles or tetrahedra.

Lengths, pressures and densities of order one; the gas constant is that of the
case (287 J/(kg K)), so temperatures are small numbers.
"""
import re
from pathlib import Path

import numpy as np

from foamCase import FoamCase

HERE = Path(__file__).parent
R = 8314.47 / 28.97028
GAMMA = 1.4

BLOCK = """FoamFile
{{
    version 2.0;
    format ascii;
    class dictionary;
    object blockMeshDict;
}}
vertices
(
    (0 0 0) ({lx} 0 0) ({lx} {ly} 0) (0 {ly} 0)
    (0 0 {lz}) ({lx} 0 {lz}) ({lx} {ly} {lz}) (0 {ly} {lz})
);
blocks (hex (0 1 2 3 4 5 6 7) ({nx} {ny} {nz}) simpleGrading (1 1 1));
boundary
(
{patches}
);
"""

X = "(0 4 7 3) (1 2 6 5)"
Y = "(0 1 5 4) (3 7 6 2)"
Z = "(0 3 2 1) (4 5 6 7)"


def patch(name, kind, faces):
    return f"    {name} {{ type {kind}; faces ({faces}); }}\n"


class GasBox(FoamCase):
    """sides: lengths of the box in the directions of the scene;
    cells: numbers of cells there; closed: slip walls all round."""

    def __init__(self, folder, sides, cells, closed=False):
        super().__init__(HERE / "box", folder)
        dim = len(sides)
        lengths = list(sides) + [sides[0] / cells[0]] * (3 - dim)
        numbers = list(cells) + [1] * (3 - dim)
        ends = {1: X, 2: X + Y, 3: X}[dim]
        patches = patch(*(("walls",) if closed else ("ends",)), "patch", ends)
        if dim == 1:
            patches += patch("sides", "empty", Y + Z)
        elif dim == 2:
            patches += patch("sides", "empty", Z)
        else:
            # A tube: open ends, slip walls
            patches = patch("ends", "patch", X) + patch("walls", "patch", Y + Z)
        (self.path / "system" / "blockMeshDict").write_text(BLOCK.format(
            lx=lengths[0], ly=lengths[1], lz=lengths[2],
            nx=numbers[0], ny=numbers[1], nz=numbers[2], patches=patches,
        ))
        self.run("blockMesh")
        self.x = self.points()

    def schemes(self, text):
        """Entries of system/feSchemes."""
        path = self.path / "system" / "feSchemes"
        head = path.read_text().split("// * *")[0]
        path.write_text(head + "\n" + text + "\n")

    def start(self, rho, U, p):
        """Initial state at the mesh points: arrays (n,), (n, 3), (n,)."""
        n = len(self.x)
        self.writeField("p", np.broadcast_to(p, n))
        self.writeField("T", np.broadcast_to(p, n) / (R * rho))
        self.writeField("U", np.broadcast_to(U, (n, 3)))

    def writeField(self, name, values):
        path = self.path / "0" / name
        vector = values.ndim == 2
        rows = "\n".join(
            "(%.17g %.17g %.17g)" % tuple(v) if vector else "%.17g" % v
            for v in values
        )
        field = (
            f"internalField nonuniform List<{'vector' if vector else 'scalar'}>"
            f"\n{len(values)}\n(\n{rows}\n);"
        )
        text = path.read_text()
        path.write_text(re.sub(r"internalField[^;]*;", lambda _: field, text))

    def runTo(self, endTime, **control):
        self.set("system/controlDict", "endTime", endTime)
        self.set("system/controlDict", "writeInterval",
                 control.pop("writeInterval", endTime))
        for entry, value in control.items():
            self.set("system/controlDict", entry, value)
        self.log = self.run("shockShellFoam", check=False)
        return self.exitCode

    def result(self, name):
        time = self.times()[-1]
        return self.pointField(name, time)
