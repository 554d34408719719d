"""blockShell: surfaces, grading, sets, and what it refuses."""
import numpy as np
import pytest

from foamCase import FoamCase
from shellMeshFiles import emptyCase, readShellMesh, samples

HEADER = "FoamFile { version 2.0; format ascii; class dictionary;" \
    " object blockShellDict; }\n"
EDGES = ["uMax", "uMaxVMax", "uMaxVMin", "uMin", "uMinVMax", "uMinVMin",
         "vMax", "vMin"]


@pytest.fixture
def case(tmp_path):
    return FoamCase(emptyCase(tmp_path / "empty"), tmp_path / "case")


def write(case, surface, divisions, more=""):
    (case.path / "system" / "blockShellDict").write_text(
        f"{HEADER}surface {{ {surface} }}\ndivisions {divisions};\n{more}\n")


def make(case, surface, divisions, more=""):
    write(case, surface, divisions, more)
    case.run("blockShell")
    return readShellMesh(case.path)


def turned(kind, more):
    return f"type {kind}; origin (1 2 3); axis (0 0 2); start (5 0 1); {more}"


def corner(mesh, name):
    (node,) = mesh.nodeSets[name]
    return mesh.nodes[node]


def check(mesh, distance, normal, bound):
    """All points of the triangles within bound of the surface, all nodes on
    it, directors along its normals and on the upper side of the triangles."""
    assert np.abs(distance(mesh.nodes)).max() < 1e-13
    assert np.abs(distance(mesh.at(*samples()))).max() < bound
    assert mesh.directors == pytest.approx(normal(mesh.nodes), abs=1e-13)
    x = mesh.nodes[mesh.triangles]
    area = np.cross(x[:, 1] - x[:, 0], x[:, 2] - x[:, 0])
    inside = mesh.directors[mesh.triangles[:, 9]]
    assert np.all(np.einsum("ei,ei->e", area, inside) > 0)
    assert sorted(mesh.nodeSets) == EDGES


def cylinderDistance(x):
    return np.hypot(x[..., 0] - 1, x[..., 1] - 2) - 0.5


def across(x):
    n = (x - [1, 2, 3]) * [1, 1, 0]
    return n / np.linalg.norm(n, axis=-1, keepdims=True)


def test_sector_of_a_cylinder(case):
    mesh = make(case, turned("cylinder", "radius 0.5; length 2; angle 90;"),
                "(3 2)")
    assert len(mesh.triangles) == 12 and len(mesh.nodes) == 10 * 7
    check(mesh, cylinderDistance, across, 2e-5)
    assert corner(mesh, "uMinVMin") == pytest.approx([1.5, 2, 3])
    assert corner(mesh, "uMaxVMin") == pytest.approx([1, 2.5, 3])
    assert corner(mesh, "uMaxVMax") == pytest.approx([1, 2.5, 5])
    assert len(mesh.nodeSets["uMin"]) == 7 and len(mesh.nodeSets["vMax"]) == 10


def test_whole_cylinder_is_closed(case):
    mesh = make(case, turned("cylinder", "radius 0.5; length 2;"), "(6 1)")
    assert len(mesh.triangles) == 12 and len(mesh.nodes) == 18 * 4
    check(mesh, cylinderDistance, across, 4e-4)
    assert mesh.nodeSets["uMin"] == mesh.nodeSets["uMax"]
    assert len(np.unique(np.round(mesh.nodes, 9), axis=0)) == len(mesh.nodes)


def sphereDistance(x):
    return np.linalg.norm(x - [1, 2, 3], axis=-1) - 10


def radial(x):
    return (x - [1, 2, 3]) / np.linalg.norm(
        x - [1, 2, 3], axis=-1, keepdims=True)


@pytest.mark.parametrize("latitudes, angle, divisions, triangles", [
    ("(0 72)", 90, "(4 4)", 32),        # A hole of 18 degrees
    ("(0 90)", 90, "(4 4)", 28),        # To the pole
    ("(-90 90)", 360, "(12 6)", 120),   # Whole
])
def test_sphere(case, latitudes, angle, divisions, triangles):
    mesh = make(case, turned("sphere", f"radius 10; latitudes {latitudes};"
                             f" angle {angle};"), divisions)
    assert len(mesh.triangles) == triangles
    check(mesh, sphereDistance, radial, 4e-4 * 10)
    if "90)" in latitudes:
        assert corner(mesh, "uMinVMax") == pytest.approx([1, 2, 13])
        assert mesh.nodeSets["vMax"] == mesh.nodeSets["uMaxVMax"]


def test_cone(case):
    mesh = make(case, turned("cone", "radii (0.5 0.3); height 0.4;"
                             " angle 120;"), "(4 2)")

    def distance(x):
        r = np.hypot(x[..., 0] - 1, x[..., 1] - 2)
        return (r - 0.5 + 0.5 * (x[..., 2] - 3)) / np.hypot(1, 0.5)

    def normal(x):
        n = across(x) + [0, 0, 0.5]
        return n / np.linalg.norm(n, axis=-1, keepdims=True)

    check(mesh, distance, normal, 2e-5)
    assert corner(mesh, "uMinVMax") == pytest.approx([1.3, 2, 3.4])


def test_circular_plate(case):
    mesh = make(case, turned("cone", "radii (2 0); height 0;"), "(8 2)")
    assert len(mesh.triangles) == 8 * 3
    assert np.all(mesh.nodes[:, 2] == 3)
    assert np.all(mesh.directors == [0, 0, 1])
    assert corner(mesh, "uMinVMax") == pytest.approx([1, 2, 3])
    r = np.hypot(*(mesh.nodes[mesh.nodeSets["vMin"]] - [1, 2, 3])[:, :2].T)
    assert r == pytest.approx(np.full(24, 2.0))
    x = mesh.at(*samples())
    assert np.hypot(x[..., 0] - 1, x[..., 1] - 2).max() < 2 * (1 + 4e-4)


def test_tip_of_a_cone(case):
    mesh = make(case, turned("cone", "radii (1 0); height 1;"), "(8 2)")
    (tip,) = mesh.nodeSets["vMax"]
    assert mesh.nodes[tip] == pytest.approx([1, 2, 4])
    assert mesh.directors[tip] == pytest.approx([0, 0, 1])


PLATE = "type plate; origin (0 0 0); sideU (3 0 0); sideV (0 1 0);"


def along(mesh, edge, axis):
    return np.sort(mesh.nodes[mesh.nodeSets[edge], axis])


def test_grading(case):
    """Last over first division 4 along u; two sections along v."""
    mesh = make(case, PLATE, "(3 4)",
                "grading (4 ((0.25 0.5 1) (0.75 0.5 1)));")
    u = along(mesh, "vMin", 0)
    widths = np.diff(u[::3])
    assert widths[1:] / widths[:-1] == pytest.approx([2, 2])
    assert np.diff(u) == pytest.approx(np.repeat(widths / 3, 3))
    v = along(mesh, "uMax", 1)
    assert v[::3] == pytest.approx([0, 0.125, 0.25, 0.625, 1])
    assert mesh.nodes.max(axis=0) == pytest.approx([3, 1, 0])


def test_without_grading_as_ever(case):
    mesh = make(case, PLATE, "(3 1)", "elementSet skin; nodeSets"
                " { ends (uMin uMax); tip uMaxVMax; }")
    assert np.diff(along(mesh, "vMin", 0)) == pytest.approx([1 / 3] * 9)
    assert mesh.elementSets == {"skin": list(range(6))}
    assert mesh.nodeSets["ends"] == sorted(
        mesh.nodeSets["uMin"] + mesh.nodeSets["uMax"])
    # Node by node, u first
    assert mesh.nodes[:10, 1] == pytest.approx(0)
    assert mesh.nodes[10:20, 1] == pytest.approx(1 / 3)


@pytest.mark.parametrize("surface, divisions, more, expected", [
    (turned("cylindre", "radius 1; length 1;"), "(3 1)", "",
     ["cylindre", "cylinder", "cone", "sphere", "plate"]),
    (turned("cylinder", "radius -1; length 1;"), "(3 1)", "",
     ["radius -1 must be positive"]),
    (turned("cylinder", "radius 1;"), "(3 1)", "", ["length", "not found"]),
    (turned("cylinder", "radius 1; lenght 1; length 2;"), "(3 1)", "",
     ["Unknown keyword lenght", "radius length"]),
    (turned("cylinder", "radius 1; length 1; angle 400;"), "(3 1)", "",
     ["angle 400", "360"]),
    ("type cylinder; origin (0 0 0); axis (0 0 1); start (0 0 2); radius 1;"
     " length 1;", "(3 1)", "", ["start (0 0 1) is along the axis"]),
    (turned("cylinder", "radius 1; length 1;"), "(2 1)", "",
     ["closed along u needs 3"]),
    (turned("sphere", "radius 1; latitudes (90 0);"), "(4 4)", "",
     ["latitudes", "must ascend"]),
    (turned("sphere", "radius 1; latitudes 90;"), "(4 4)", "", ["latitudes"]),
    (turned("cone", "radii (0 0); height 1;"), "(4 4)", "",
     ["radii", "nor both 0"]),
    (turned("cone", "radii (1 1); height 0;"), "(4 4)", "",
     ["height", "must be positive"]),
    (PLATE, "(2 2)", "grading (4);", ["grading"]),
    (PLATE, "(1 2)", "grading (((0.5 0.5 1) (0.5 0.5 2)) 1);",
     ["2 sections for 1 divisions"]),
])
def test_refused(case, surface, divisions, more, expected):
    write(case, surface, divisions, more)
    log = case.run("blockShell", check=False, timeout=60)
    assert case.exitCode not in (0, None)
    message = " ".join(log.split("FOAM FATAL")[1].split())
    for part in ["blockShellDict", *expected]:
        assert part in message, message
    assert not (case.path / "constant" / "shell").exists()
