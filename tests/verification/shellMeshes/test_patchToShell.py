"""patchToShell: patches of triangles and quadrilaterals, outlines as sets."""
import re

import numpy as np
import pytest

from foamCase import FoamCase
from shellMeshFiles import emptyCase, readShellMesh

HEADER = "FoamFile { version 2.0; format ascii; class %s; object %s; }\n"
SCHEMES = {"fvSchemes": "ddtSchemes{} gradSchemes{} divSchemes{}"
           " laplacianSchemes{} interpolationSchemes{} snGradSchemes{}",
           "fvSolution": ""}

BOX = """
convertToMeters 1;
vertices
(
    (0 0 0) (2 0 0) (2 1 0) (0 1 0) (0 0 1) (2 0 1) (2 1 1) (0 1 1)
);
blocks (hex (0 1 2 3 4 5 6 7) (4 2 2) simpleGrading (1 1 1));
edges ();
boundary
(
    top { type wall; faces ((4 5 6 7)); }
    left { type wall; faces ((0 4 7 3)); }
    others { type wall; faces ((1 2 6 5) (0 1 5 4) (3 7 6 2) (0 3 2 1)); }
);
"""

# A quarter of a ring from radius 1 to 2, 0.5 high
RING = """
convertToMeters 1;
vertices
(
    (1 0 0) (2 0 0) (0 2 0) (0 1 0) (1 0 0.5) (2 0 0.5) (0 2 0.5) (0 1 0.5)
);
blocks (hex (0 1 2 3 4 5 6 7) (1 %d 1) simpleGrading (1 1 1));
edges
(
    arc 1 2 (1.414213562373095 1.414213562373095 0)
    arc 0 3 (0.7071067811865475 0.7071067811865475 0)
    arc 5 6 (1.414213562373095 1.414213562373095 0.5)
    arc 4 7 (0.7071067811865475 0.7071067811865475 0.5)
);
boundary
(
    outer { type wall; faces ((1 2 6 5)); }
    rest { type wall; faces ((0 4 7 3) (0 1 5 4) (3 7 6 2) (0 3 2 1)
                             (4 5 6 7)); }
);
"""


def meshed(tmp_path, blocks):
    case = FoamCase(emptyCase(tmp_path / "empty"), tmp_path / "case")
    for name, text in {"blockMeshDict": blocks, **SCHEMES}.items():
        (case.path / "system" / name).write_text(
            HEADER % ("dictionary", name) + text)
    case.run("blockMesh")
    return case


@pytest.fixture
def box(tmp_path):
    return meshed(tmp_path, BOX)


def areas(mesh):
    x = mesh.nodes[mesh.triangles]
    return 0.5 * np.cross(x[:, 1] - x[:, 0], x[:, 2] - x[:, 0])


def onLine(mesh, name):
    return mesh.nodes[mesh.nodeSets[name]]


def test_patch_of_quadrilaterals(box):
    log = box.run("patchToShell", "top")
    mesh = readShellMesh(box.path)
    assert len(mesh.triangles) == 16 and len(mesh.nodes) == 13 * 7
    assert areas(mesh).sum(axis=0) == pytest.approx([0, 0, 2])
    assert np.all(areas(mesh)[:, 2] > 0)

    outline = onLine(mesh, "boundary")
    assert len(outline) == 2 * (12 + 6)
    assert np.all((np.isin(outline[:, 0], (0, 2)))
                  | (np.isin(outline[:, 1], (0, 1))))
    corners = np.array([onLine(mesh, f"corner{i}")[0] for i in range(4)])
    assert sorted(map(tuple, corners[:, :2].round(12))) == [
        (0, 0), (0, 1), (2, 0), (2, 1)]
    sizes = sorted(len(mesh.nodeSets[f"edge{i}"]) for i in range(4))
    assert sizes == [7, 7, 13, 13]
    for i in range(4):
        x = onLine(mesh, f"edge{i}")
        assert min(np.ptp(x[:, 0]), np.ptp(x[:, 1])) < 1e-14
    # Where another patch begins
    assert len(mesh.nodeSets["left"]) == 7
    assert np.all(onLine(mesh, "left")[:, 0] == 0)
    assert len(mesh.nodeSets["others"]) == 13 + 13 + 7 - 2
    assert sorted(mesh.nodeSets) == sorted(
        ["boundary", "left", "others"]
        + [f"{kind}{i}" for kind in ("edge", "corner") for i in range(4)])
    assert re.search(r"geometric error\s+0 m|geometric error\s+\S+e-1\d", log)
    assert re.search(r"edge0\s+from \(", log)


def test_upper_face(box):
    box.run("patchToShell", "top", "-flip", "-mesh", "wall")
    mesh = readShellMesh(box.path, "wall")
    assert np.all(areas(mesh)[:, 2] < 0)


@pytest.mark.parametrize("n", [4, 8])
def test_curved_patch(tmp_path, n):
    case = meshed(tmp_path, RING % n)
    log = case.run("patchToShell", "outer")
    mesh = readShellMesh(case.path)
    assert len(mesh.triangles) == 2 * n
    said = float(re.search(r"geometric error\s+(\S+) m", log).group(1))
    sagitta = 2 * (1 - np.cos(np.pi / 4 / n))
    assert said == pytest.approx(sagitta, rel=0.03)
    # Four corners: the arcs turn by less than the feature angle
    assert sum(name.startswith("edge") for name in mesh.nodeSets) == 4
    # Outward of the gas, that is away from the axis
    x = mesh.nodes[mesh.triangles[:, 9]]
    assert np.all(np.einsum("ei,ei->e", areas(mesh)[:, :2], x[:, :2]) > 0)


def test_feature_angle(tmp_path):
    """Arcs of 22.5 degrees a face are corners when asked for."""
    case = meshed(tmp_path, RING % 4)
    case.run("patchToShell", "outer", "-featureAngle", "20")
    mesh = readShellMesh(case.path)
    assert sum(name.startswith("corner") for name in mesh.nodeSets) == 4 + 6


def test_patch_of_triangles_and_quadrilaterals(box):
    """The same faces, one of them already cut."""
    path = box.path / "constant" / "polyMesh" / "faces"
    text = path.read_text()
    before = patchFaces(box, "top")
    quad = before[0]
    words = "4(" + " ".join(map(str, quad)) + ")"
    assert text.count(words) == 1
    # A face of three points and one cell with a hole in it: enough for a patch
    path.write_text(text.replace(
        words, "3(" + " ".join(map(str, quad[:3])) + ")"))
    box.run("patchToShell", "top")
    mesh = readShellMesh(box.path)
    assert len(mesh.triangles) == 15
    assert areas(mesh).sum(axis=0)[2] == pytest.approx(2 - 0.125)


def patchFaces(case, name):
    folder = case.path / "constant" / "polyMesh"
    start, count = (
        int(re.search(rf"{name}\s*\{{[^}}]*{key}\s+(\d+);",
                      (folder / "boundary").read_text()).group(1))
        for key in ("startFace", "nFaces"))
    rows = re.findall(r"^\d+\(([\d ]+)\)", (folder / "faces").read_text(), re.M)
    return [[int(p) for p in row.split()]
            for row in rows[start:start + count]]


def refused(case, *words, expected):
    log = case.run("patchToShell", *words, check=False, timeout=60)
    assert case.exitCode not in (0, None)
    message = " ".join(log.split("FOAM FATAL")[1].split())
    for part in expected:
        assert part in message, message
    assert not (case.path / "constant" / "shell").exists()


def test_unknown_patch(box):
    refused(box, "roof", expected=["Unknown patch roof", "top left others"])


def test_branching_patch(box):
    """All sides of the box but two: no edge has more than two faces, so this
    is a shell with folds of 90 degrees, corners of three faces included."""
    box.run("patchToShell", "others")
    mesh = readShellMesh(box.path)
    assert np.linalg.norm(areas(mesh), axis=1).sum() == pytest.approx(7)


def test_polygons(box):
    path = box.path / "constant" / "polyMesh" / "faces"
    text = path.read_text()
    faces = patchFaces(box, "top")
    words = "4(" + " ".join(map(str, faces[0])) + ")"
    path.write_text(text.replace(
        words, "5(" + " ".join(map(str, [*faces[0], faces[5][2]])) + ")"))
    refused(box, "top", expected=["Patch top", "number 0 of patch top",
                                  "has 5 points", "triangles and quad"])


def test_face_without_area(box):
    path = box.path / "constant" / "polyMesh" / "points"
    a, b, c, d = patchFaces(box, "top")[0]
    lines = path.read_text().splitlines()
    first = next(i for i, line in enumerate(lines) if line.strip() == "(") + 1
    lines[first + c] = "(0.3 0 1)"
    lines[first + d] = "(0.2 0 1)"
    path.write_text("\n".join(lines))
    refused(box, "top", expected=["number 0 of patch top", "checkMesh"])


def test_name_of_another_patch(box):
    path = box.path / "constant" / "polyMesh" / "boundary"
    path.write_text(path.read_text().replace("left", "edge0"))
    refused(box, "top", expected=["patch edge0", "rename that patch"])
