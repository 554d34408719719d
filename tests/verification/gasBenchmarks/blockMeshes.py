"""Block-structured meshes for the benchmarks, as text for blockMesh.

    box([(1, 100)])                         lines
    box([(1, 100)], (0.5, 50))              quadrilaterals
    box([(1, 100)], (0.5, 50), (0.5, 50))   hexahedra
    plane(corners, blocks, patches)         plane blocks with any corners
    wedge(radius, cells, 2)                 a slice of a sphere, along x
    axisymmetric(length, radius, cells)     a wedge round the x axis

Each direction of a box is (length, cells); x is a list of such segments, so
that cell sizes may jump. Patches: left, right; bottom, top; back, front; and
empty `sides` in the directions that the mesh has not.
"""
import math

HEADER = """FoamFile
{{
    version     2.0;
    format      ascii;
    class       {kind};
    object      {name};
}}
"""

X = ("left", (0, 4, 7, 3)), ("right", (1, 2, 6, 5))
Y = ("bottom", (0, 1, 5, 4)), ("top", (3, 7, 6, 2))
Z = ("back", (0, 3, 2, 1)), ("front", (4, 5, 6, 7))


class BlockMesh:
    """vertices: points; blocks: (8 vertices, 3 cell numbers);
    patches: name -> (type, faces); dim: directions that the scene has."""

    def __init__(self, vertices, blocks, patches, dim):
        self.vertices, self.blocks = vertices, blocks
        self.patches, self.dim = patches, dim

    def text(self):
        def words(values):
            return "(" + " ".join(f"{v:.17g}" for v in values) + ")"

        vertices = "\n".join(words(v) for v in self.vertices)
        blocks = "\n".join(
            f"hex {words(corners)} {words(cells)} simpleGrading (1 1 1)"
            for corners, cells in self.blocks
        )
        patches = "\n".join(
            f"{name} {{ type {kind.replace(',', ';')}; faces ("
            + " ".join(words(f) for f in faces) + "); }"
            for name, (kind, faces) in self.patches.items()
        )
        return HEADER.format(kind="dictionary", name="blockMeshDict") + (
            f"vertices\n(\n{vertices}\n);\nblocks\n(\n{blocks}\n);\n"
            f"boundary\n(\n{patches}\n);\n"
        )

    def make(self, case):
        """The polyMesh of a case."""
        case.write("system/blockMeshDict", self.text(), headed=True)
        case.run("blockMesh")

    def cyclic(self, first, second):
        """The mesh with these two patches joined."""
        for name, other in ((first, second), (second, first)):
            faces = self.patches[name][1]
            self.patches[name] = (f"cyclic, neighbourPatch {other}", faces)
        return self


def box(x, y=None, z=None, origin=(0, 0, 0)):
    """A box; see the head of this file."""
    dim = 1 + (y is not None) + (z is not None)
    y, z = y or (1, 1), z or (1, 1)
    vertices, blocks = [], []
    ends = [0.0]
    for length, _ in x:
        ends.append(ends[-1] + length)
    # Four vertices at each end of a segment
    for end in ends:
        vertices += [
            (origin[0] + end, origin[1] + dy, origin[2] + dz)
            for dz in (0, z[0]) for dy in (0, y[0])
        ]
    faces = {}
    for i, (_, cells) in enumerate(x):
        a, b = 4 * i, 4 * i + 4
        corners = (a, b, b + 1, a + 1, a + 2, b + 2, b + 3, a + 3)
        blocks.append((corners, (cells, y[1], z[1])))
        wanted = Y + Z + X[:1] * (i == 0) + X[1:] * (i == len(x) - 1)
        for name, local in wanted:
            faces.setdefault(name, []).append([corners[v] for v in local])
    empty = {1: Y + Z, 2: Z, 3: ()}[dim]
    sides = [f for name, _ in empty for f in faces.pop(name)]
    patches = {name: ("patch", some) for name, some in faces.items()}
    if sides:
        patches["sides"] = ("empty", sides)
    return BlockMesh(vertices, blocks, patches, dim)


def plane(corners, blocks, patches):
    """Plane blocks.

    corners: points (x, y); blocks: (4 corners counterclockwise, (nx, ny));
    patches: name -> pairs of corners, the edges of the patch.
    """
    n = len(corners)
    vertices = [(x, y, z) for z in (0, 1) for x, y in corners]
    hexes, sides = [], []
    for ids, cells in blocks:
        top = [i + n for i in ids]
        hexes.append((tuple(ids) + tuple(top), tuple(cells) + (1,)))
        sides += [list(reversed(ids)), top]
    all_ = {
        name: ("patch", [[a, b, b + n, a + n] for a, b in edges])
        for name, edges in patches.items()
    }
    all_["sides"] = ("empty", sides)
    return BlockMesh(vertices, hexes, all_, 2)


ANGLE = math.radians(1)  # half the opening angle of a wedge


def wedge(radius, cells, directions):
    """A slice of a cylinder (directions = 1: two wedge and two empty patches)
    or of a sphere (2: four wedge patches), from its middle at x = 0, along x.
    """
    r = radius
    y = r * math.tan(ANGLE)
    if directions == 1:
        vertices = [(0, 0, 0), (0, 0, 1)] + [
            (r, s * y, z) for z in (0, 1) for s in (-1, 1)
        ]
        block = (0, 2, 3, 0, 1, 4, 5, 1)
        patches = {
            "right": ("patch", [(2, 3, 5, 4)]),
            "wedge0": ("wedge", [(0, 2, 4, 1)]),
            "wedge1": ("wedge", [(0, 1, 5, 3)]),
            "sides": ("empty", [(0, 0, 3, 2), (1, 4, 5, 1)]),
        }
    else:
        vertices = [(0, 0, 0)] + [
            (r, s * y, t * y) for t in (-1, 1) for s in (-1, 1)
        ]
        block = (0, 1, 2, 0, 0, 3, 4, 0)
        patches = {
            "right": ("patch", [(1, 2, 4, 3)]),
            "wedge0": ("wedge", [(0, 1, 3, 0)]),
            "wedge1": ("wedge", [(0, 0, 4, 2)]),
            "wedge2": ("wedge", [(0, 0, 2, 1)]),
            "wedge3": ("wedge", [(0, 3, 4, 0)]),
        }
    return BlockMesh(vertices, [(block, (cells, 1, 1))], patches, 1)


def axisymmetric(length, radius, cells):
    """A wedge with the axis of rotation along x, one cell thick: a plane
    scene in x and y = r."""
    y, z = radius * math.cos(ANGLE), radius * math.sin(ANGLE)
    vertices = [(x, 0, 0) for x in (0, length)] + [
        (x, y, s * z) for s in (-1, 1) for x in (0, length)
    ]
    block = (0, 1, 3, 2, 0, 1, 5, 4)
    patches = {
        "left": ("patch", [(0, 0, 4, 2)]),
        "right": ("patch", [(1, 3, 5, 1)]),
        "top": ("patch", [(2, 4, 5, 3)]),
        "wedge0": ("wedge", [(0, 2, 3, 1)]),
        "wedge1": ("wedge", [(0, 1, 5, 4)]),
    }
    return BlockMesh(vertices, [(block, tuple(cells) + (1,))], patches, 2)
