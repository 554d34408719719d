"""Writes gmsh files: MSH 2.2 and 4.1, ASCII and binary.

    mesh = Mesh(nodes, names={(1, 7): "base"})
    mesh.add(TRIANGLE[3], {1: [4, 8, ...]}, entity=1, groups=[5])
    mesh.write(path, "4.1", binary=True)

nodes: {number: (x, y, z)}; elements: {number: node numbers}. In MSH 2.2 an
element of several groups is written once per group, with new numbers from
1000 on, as gmsh does.
"""
import struct
from dataclasses import dataclass

POINT = 15
LINE = {1: 1, 2: 8, 3: 26}
TRIANGLE = {1: 2, 2: 9, 3: 21}
DIMENSION = {15: 0, 1: 1, 8: 1, 26: 1}


@dataclass
class Block:
    kind: int
    elements: dict
    entity: int
    groups: list

    @property
    def dimension(self):
        return DIMENSION.get(self.kind, 2)


class Out:
    """Collects a file; ints of 4 bytes (i), of 8 (q), reals (d)."""

    def __init__(self, binary):
        self.binary = binary
        self.parts = []

    def text(self, words):
        self.parts.append(words.encode())

    def values(self, kinds, values):
        if self.binary:
            self.parts.append(struct.pack("<" + kinds, *values))
        else:
            self.text(" ".join(repr(v) for v in values) + "\n")

    def end(self, name):
        self.text(("\n" if self.binary else "") + f"$End{name}\n")


class Mesh:

    def __init__(self, nodes, names=None):
        self.nodes, self.names, self.blocks = dict(nodes), names or {}, []

    def add(self, kind, elements, entity=1, groups=()):
        self.blocks.append(Block(kind, dict(elements), entity, list(groups)))
        return self

    def write(self, path, version="2.2", binary=False):
        out = Out(binary)
        out.text(f"$MeshFormat\n{version} {int(binary)} 8\n")
        if binary:
            out.values("i", [1])
        out.end("MeshFormat")
        if self.names:
            out.text(f"$PhysicalNames\n{len(self.names)}\n")
            for (dimension, group), name in self.names.items():
                out.text(f'{dimension} {group} "{name}"\n')
            out.text("$EndPhysicalNames\n")
        {"2.2": self._write2, "4.1": self._write4}[version](out)
        path.write_bytes(b"".join(out.parts))
        return path

    def _write2(self, out):
        out.text(f"$Nodes\n{len(self.nodes)}\n")
        for number, x in self.nodes.items():
            out.values("iddd", [number, *map(float, x)])
        out.end("Nodes")

        again = 1000
        rows = []
        for block in self.blocks:
            for number, nodes in block.elements.items():
                for place, group in enumerate(block.groups or [0]):
                    if place:
                        again += 1
                    rows.append((block.kind, again if place else number,
                                 group, block.entity, nodes))
        out.text(f"$Elements\n{len(rows)}\n")
        for kind, number, group, entity, nodes in rows:
            if out.binary:
                out.values("iii", [kind, 1, 2])
                out.values("i" * (3 + len(nodes)),
                           [number, group, entity, *nodes])
            else:
                out.values("", [number, kind, 2, group, entity, *nodes])
        out.end("Elements")

    def _write4(self, out):
        entities = {(b.dimension, b.entity): b.groups for b in self.blocks}
        count = [sum(d == n for d, _ in entities) for n in range(4)]
        out.text("$Entities\n")
        out.values("qqqq", count)
        for (dimension, entity), groups in sorted(entities.items()):
            reals = 3 if dimension == 0 else 6
            bounds = [] if dimension == 0 else [2, 1, -2]
            out.values(
                "i" + "d" * reals + "q" + "i" * len(groups)
                + ("qii" if bounds else ""),
                [entity, *[0.0] * reals, len(groups), *groups, *bounds])
        out.end("Entities")

        out.text("$Nodes\n")
        out.values("qqqq", [1, len(self.nodes), 1, max(self.nodes)])
        out.values("iiiq", [2, 1, 0, len(self.nodes)])
        for number in self.nodes:
            out.values("q", [number])
        for x in self.nodes.values():
            out.values("ddd", list(map(float, x)))
        out.end("Nodes")

        total = sum(len(b.elements) for b in self.blocks)
        out.text("$Elements\n")
        out.values("qqqq", [len(self.blocks), total, 1, total])
        for block in self.blocks:
            out.values("iiiq", [block.dimension, block.entity, block.kind,
                                len(block.elements)])
            for number, nodes in block.elements.items():
                out.values("q" * (1 + len(nodes)), [number, *nodes])
        out.end("Elements")
