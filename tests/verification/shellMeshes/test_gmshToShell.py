"""gmshToShell: formats, orders, sets, geometry, and what it refuses."""
import re
from pathlib import Path

import numpy as np
import pytest

from foamCase import FoamCase
from mshFile import LINE, POINT, TRIANGLE, Mesh
from shellMeshFiles import emptyCase, readShellMesh, samples

HERE = Path(__file__).resolve().parent
FORMATS = [("2.2", False), ("2.2", True), ("4.1", False), ("4.1", True)]

# Places (i, j) in parts of a side: gmsh's reference manual, "Node ordering"
PLACES = {
    1: [(0, 0), (1, 0), (0, 1)],
    2: [(0, 0), (2, 0), (0, 2), (1, 0), (1, 1), (0, 1)],
    3: [(0, 0), (3, 0), (0, 3), (1, 0), (2, 0), (2, 1), (1, 2), (0, 2),
        (0, 1), (1, 1)],
}


@pytest.fixture
def case(tmp_path):
    return FoamCase(emptyCase(tmp_path / "empty"), tmp_path / "case")


def grid(n, order, surface):
    """A mesh of n x n squares in two triangles each, with node numbers that
    are neither consecutive nor start at 1, and its outline."""
    side = n * order
    number = {(i, j): 7 + 3 * (i + (side + 1) * j)
              for j in range(side + 1) for i in range(side + 1)}
    mesh = Mesh({number[i, j]: surface(i / side, j / side)
                 for i, j in number})
    triangles = {}
    for j in range(0, side, order):
        for i in range(0, side, order):
            for turned in (False, True):
                triangles[100 + len(triangles)] = [
                    number[(i + order - a, j + order - b) if turned
                           else (i + a, j + b)] for a, b in PLACES[order]]
    lines = {}
    for i in range(0, side, order):
        inner = [number[i + k, 0] for k in range(1, order)]
        lines[1 + len(lines)] = [number[i, 0], number[i + order, 0], *inner]
    return mesh, triangles, lines, number


def square(u, v):
    return 2 * u, v, 0.0


def plate(order=3, n=2, surface=square):
    """With a group of each kind, one of them without a name."""
    mesh, triangles, lines, number = grid(n, order, surface)
    mesh.names = {(0, 3): "corner", (1, 4): "base", (2, 1): "skin"}
    mesh.add(POINT, {50: [number[n * order, n * order]]}, groups=[3])
    mesh.add(LINE[order], lines, groups=[4])
    first = dict(list(triangles.items())[:3])
    rest = dict(list(triangles.items())[3:])
    mesh.add(TRIANGLE[order], first, entity=1, groups=[1, 9])
    mesh.add(TRIANGLE[order], rest, entity=2, groups=[1])
    return mesh


def convert(case, mesh, *options, version="2.2", binary=False):
    path = mesh.write(case.path / "a.msh", version, binary)
    case.run("gmshToShell", path, *options)
    return readShellMesh(case.path)


@pytest.mark.parametrize("order", [1, 2, 3])
@pytest.mark.parametrize("version, binary", FORMATS)
def test_formats_and_orders(case, version, binary, order):
    found = convert(case, plate(order), version=version, binary=binary)

    # All orders are the same plate: 49 nodes at thirds
    assert len(found.nodes) == 49 and len(found.triangles) == 8
    thirds = np.unique(np.round(6 * found.nodes / [2, 1, 1], 9), axis=0)
    assert len(thirds) == 49 and np.all(thirds == np.round(thirds))
    places = np.round(3 * np.array([
        (1 / 3 * a, 1 / 3 * b) for a, b in PLACES[3]])).astype(int)
    for triangle in found.triangles:
        x = found.nodes[triangle][:, :2]
        expected = x[0] + places @ np.array([x[1] - x[0], x[2] - x[0]]) / 3
        assert x == pytest.approx(expected, abs=1e-14)

    x = found.nodes
    assert found.nodeSets["base"] == list(np.flatnonzero(x[:, 1] == 0))
    (corner,) = found.nodeSets["corner"]
    assert x[corner] == pytest.approx([2, 1, 0])
    assert found.nodeSets["skin"] == list(range(49))
    assert found.elementSets == {"skin": list(range(8)),
                                 "surface9": [0, 1, 2]}
    assert found.nodeSets["surface9"] == sorted(
        set(found.triangles[:3].ravel()))
    assert found.directors is None


@pytest.mark.parametrize("version", ["22", "41"])
def test_file_of_gmsh(case, version):
    """Its numbering of elements, groups and blocks, not this test's."""
    case.run("gmshToShell", HERE / "meshes" / f"twoPlates{version}.msh")
    found = readShellMesh(case.path)
    x = found.nodes
    assert len(x) == 67 and len(found.triangles) == 12
    assert sorted(found.elementSets) == ["both", "left", "surface6"]
    assert len(found.elementSets["both"]) == 12
    assert sorted(found.elementSets["left"] + found.elementSets["surface6"]
                  ) == list(range(12))
    base = x[found.nodeSets["base"]]
    assert np.sort(base[:, 0]) == pytest.approx(np.arange(7) / 3)
    assert np.all(base[:, 1:] == 0)
    (tip,) = found.nodeSets["tip"]
    assert x[tip] == pytest.approx([2, 0, 0])
    area = 0.5 * np.linalg.norm(np.cross(
        x[found.triangles[:, 1]] - x[found.triangles[:, 0]],
        x[found.triangles[:, 2]] - x[found.triangles[:, 0]]), axis=1).sum()
    assert area == pytest.approx(3)


RADIUS = 2.0


def sphere(u, v):
    """A sixth of a sphere, seen from the centre as the face of a cube."""
    x = np.array([np.tan(np.pi / 4 * (2 * u - 1)),
                  np.tan(np.pi / 4 * (2 * v - 1)), 1])
    return tuple(RADIUS * x / np.linalg.norm(x))


def cylinder(u, v):
    return RADIUS * np.sin(u), 1.5 * v, RADIUS * np.cos(u)


def said(case):
    return float(re.search(r"geometric error\s+(\S+) m", case.run(
        "gmshToShell", case.path / "a.msh")).group(1))


def offSurface(mesh, surface):
    x = mesh.at(*samples())
    if surface == cylinder:
        x = x[..., [0, 2]]
    return np.abs(np.linalg.norm(x, axis=-1) - RADIUS).max()


@pytest.mark.parametrize("surface", [sphere, cylinder])
def test_order_3_follows_curved_surfaces(case, surface):
    """A swapped pair of nodes would fold or at least bend the triangles. The
    distance falls with the fourth power of the size, between nodes."""
    errors = [offSurface(convert(case, plate(3, n, surface)), surface)
              for n in (4, 8)]
    assert errors[1] < 5e-5 * RADIUS
    assert np.log2(errors[0] / errors[1]) > 3.5


@pytest.mark.parametrize("order, rate, low, high", [
    # Straight sides: (SM2) is what a smooth surface has to second order
    (1, 2, 0.7, 1.4),
    # Quadratic sides: (SM3) holds for an error of the third order
    (2, 3, 0.5, 4),
])
@pytest.mark.parametrize("surface", [sphere, cylinder])
def test_geometric_error_of_low_orders(case, surface, order, rate, low, high):
    errors, estimates = [], []
    for n in (4, 8):
        mesh = convert(case, plate(order, n, surface))
        errors.append(offSurface(mesh, surface))
        estimates.append(said(case))
        assert low < estimates[-1] / errors[-1] < high
    assert np.log2(errors[0] / errors[1]) > rate - 0.3
    assert np.log2(estimates[0] / estimates[1]) > rate - 0.3


def test_folds_are_no_geometric_error(case):
    def fold(u, v):
        return min(u, 0.5), v, max(u - 0.5, 0.0)

    convert(case, plate(1, 2, fold))
    assert said(case) < 1e-12
    log = case.run("gmshToShell", case.path / "a.msh", "-featureAngle", "170")
    assert float(re.search(r"geometric error\s+(\S+) m", log).group(1)) > 0.01


def test_scale_and_name(case):
    found = convert(case, plate(), "-scale", "0.001")
    assert found.nodes.max() == pytest.approx(0.002)
    mesh = plate()
    case.run("gmshToShell", mesh.write(case.path / "b.msh"), "-mesh", "wall")
    assert readShellMesh(case.path, "wall").nodes.max() == pytest.approx(2)


@pytest.mark.parametrize("order", [1, 2, 3])
def test_minus_sign_turns_surfaces(case, order):
    """As gmsh does when it writes MSH 2.2."""
    def area(sign):
        mesh, triangles, *_ = grid(1, order, square)
        mesh.add(TRIANGLE[order], triangles, groups=[sign * 5])
        found = convert(case, mesh, version="4.1")
        x = found.nodes[found.triangles]
        return np.cross(x[:, 1] - x[:, 0], x[:, 2] - x[:, 0])[:, 2].sum() / 2

    assert area(1) == pytest.approx(2)
    assert area(-1) == pytest.approx(-2)


# What is refused

def refused(case, path, *expected):
    log = case.run("gmshToShell", path, check=False, timeout=60)
    assert case.exitCode not in (0, None)
    assert "FOAM FATAL" in log, log
    message = " ".join(log.split("FOAM FATAL")[1].split())
    for part in [path.name, *expected]:
        assert part in message, message
    assert not (case.path / "constant" / "shell").exists()


def quads(mesh):
    mesh.add(3, {77: mesh.blocks[2].elements[100][:3] + [7]})


def volumes(mesh):
    mesh.add(4, {77: [7, 10, 13, 16]})


def serendipity(mesh):
    mesh.add(20, {77: mesh.blocks[2].elements[100][:9]})


def fourthOrder(mesh):
    mesh.add(23, {77: list(mesh.nodes)[:15]})


def turnedRound(mesh):
    block = mesh.blocks[2].elements
    a, b, c, d, e, f, g, h, i, j = block[101]
    block[101] = [a, c, b, i, h, g, f, e, d, j]


def duplicateNode(mesh):
    """A triangle with a node of its own where its neighbour has one."""
    triangle = mesh.blocks[2].elements[101]
    mesh.nodes[999] = mesh.nodes[triangle[1]]
    triangle[1] = 999


def degenerate(mesh):
    triangle = mesh.blocks[2].elements[100]
    for node in triangle:
        x, y, z = mesh.nodes[node]
        mesh.nodes[node] = x + 1.4 * y, 0.0, z


def inverted(mesh):
    """The node inside far out: the mapping folds."""
    inside = mesh.blocks[2].elements[100][9]
    mesh.nodes[inside] = 1.0, 0.6, 0.0


def sameTriangle(mesh):
    block = mesh.blocks[2].elements
    block[101] = block[100]


def unknownNode(mesh):
    mesh.blocks[2].elements[100][4] = 12345


def repeatedCorner(mesh):
    triangle = mesh.blocks[2].elements[100]
    triangle[1] = triangle[0]


def emptyGroup(mesh):
    mesh.names[1, 8] = "tip"


def sameName(mesh):
    mesh.names[2, 9] = "base"


def badName(mesh):
    mesh.names[1, 4] = "left edge"


def freeLine(mesh):
    mesh.nodes.update({900: (5, 0, 0), 901: (6, 0, 0), 902: (5.3, 0, 0),
                       903: (5.7, 0, 0)})
    mesh.blocks[1].elements[60] = [900, 901, 902, 903]


def freePoint(mesh):
    mesh.nodes[900] = 5, 0, 0
    mesh.blocks[0].elements[60] = [900]


def noGroups(mesh):
    mesh.names = {}
    for block in mesh.blocks:
        block.groups = []


def otherSign(mesh):
    mesh.blocks[2].groups = [1, -9]


def noTriangles(mesh):
    mesh.blocks = mesh.blocks[:2]


def mixedOrders(mesh):
    mesh.add(TRIANGLE[1], {77: [7, 10, 31]}, entity=3)


@pytest.mark.parametrize("version, binary", [("2.2", False), ("4.1", True)])
@pytest.mark.parametrize("spoil, expected", [
    (quads, ["element 77", "quadrilateral", "RecombineAll"]),
    (volumes, ["element 77", "volume", "gmsh -2"]),
    (serendipity, ["element 77", "SecondOrderIncomplete"]),
    (fourthOrder, ["element 77", "order above 3", "ElementOrder"]),
    (turnedRound, ["triangle 100 (surface 1)", "triangle 101 (surface 1)",
                   "oriented against each other", "Reverse Surface"]),
    (duplicateNode, ["node 999", "at the same place", "(", "Coherence"]),
    (degenerate, ["triangle 100 (surface 1)", "no area"]),
    (inverted, ["triangle 100 (surface 1)", "folded over"]),
    (sameTriangle, ["triangles 100 and 101", "same corners"]),
    (unknownNode, ["element 100 has node 12345", "does not hold"]),
    (repeatedCorner, ["triangle 100 (surface 1) has node 7 twice"]),
    (emptyGroup, ["physical group 8 of curves, 'tip', has no element"]),
    (sameName, ["physical group", "'base'", "rename one"]),
    (badName, ["physical group 4 of curves", "'left edge'", "rename"]),
    (freeLine, ["line 60 of the group base", "nodes 900 and 901", "embed"]),
    (freePoint, ["point 60 of the group corner is node 900", "embed"]),
    (noGroups, ["no physical groups", "Physical Curve", "-noGroups"]),
    (noTriangles, ["no triangles", "gmsh -2"]),
    (mixedOrders, ["of order 3", "77 of order 1", "ElementOrder"]),
])
def test_refused(case, version, binary, spoil, expected):
    mesh = plate()
    spoil(mesh)
    refused(case, mesh.write(case.path / "a.msh", version, binary), *expected)


def test_surface_in_groups_of_both_signs(case):
    mesh = plate()
    otherSign(mesh)
    refused(case, mesh.write(case.path / "a.msh", "4.1"),
            "surface 1 (triangle 100)", "minus sign", "use one sign")


def test_no_groups_on_request(case):
    mesh = plate()
    noGroups(mesh)
    found = convert(case, mesh, "-noGroups")
    assert found.nodeSets == {} and len(found.triangles) == 8


@pytest.mark.parametrize("version, binary", FORMATS)
@pytest.mark.parametrize("part", [0.02, 0.3, 0.6, 0.9, 0.995])
def test_truncated(case, version, binary, part):
    path = plate().write(case.path / "a.msh", version, binary)
    content = path.read_bytes()
    path.write_bytes(content[:int(part * len(content))])
    refused(case, path, "byte" if binary and part > 0.1 else "line",
            "truncated" if part > 0.1 else "section")


def test_doubled_node_number(case):
    path = plate().write(case.path / "a.msh")
    text = path.read_text().replace("\n10 0.3", "\n7 0.3")
    assert "\n7 0.3" in text
    path.write_text(text)
    refused(case, path, "line", "$Nodes", "node 7 occurs twice")


@pytest.mark.parametrize("old, new, expected", [
    ("2.2 0 8", "4 0 8", ["line 2", "version 4 ", "msh22"]),
    ("2.2 0 8", "1 0 8", ["version 1 "]),
    ("2.2 0 8", "2.2 0 4", ["4 bytes"]),
    ("$MeshFormat", "$Format", ["no gmsh file"]),
    ("$Nodes\n49\n", "$Nodes\n48\n", ["expected $EndNodes", "found '151"]),
    ("$Nodes\n49\n", "$Nodes\n4x\n", ["whole number", "'4x'"]),
    ("$Elements", "$PartitionedEntities\n$EndPartitionedEntities\n$Elements",
     ["partitioned"]),
])
def test_wrong_text(case, old, new, expected):
    path = plate().write(case.path / "a.msh")
    text = path.read_text()
    assert text.count(old) >= 1
    path.write_text(text.replace(old, new, 1))
    refused(case, path, *expected)


def test_other_byte_order(case):
    path = plate().write(case.path / "a.msh", binary=True)
    content = path.read_bytes()
    one = b"2.2 1 8\n\x01\x00\x00\x00"
    assert one in content
    path.write_bytes(content.replace(one, b"2.2 1 8\n\x00\x00\x00\x01"))
    refused(case, path, "order of bytes", "ASCII")


def test_missing_file(case):
    refused(case, case.path / "none.msh", "missing or empty")


def test_directors_of_another_mesh_do_not_stay(case):
    folder = case.path / "constant" / "shell"
    folder.mkdir(parents=True)
    (folder / "directors").write_text("from before")
    assert convert(case, plate()).directors is None
