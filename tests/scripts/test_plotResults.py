"""tutorials/plotResults.py on small cases that are written here: what it reads,
cuts and prints is known exactly."""
import contextlib
import io
import shutil
import subprocess
import sys
from unittest import mock

import numpy as np
import pytest

from projectFiles import PROJECT

SCRIPT = PROJECT / "tutorials" / "plotResults.py"
sys.dont_write_bytecode = True
sys.path.insert(0, str(SCRIPT.parent))

import plotResults  # noqa: E402  (sets the Agg backend)
import matplotlib.pyplot as plt  # noqa: E402
from plotting.errors import PlotError  # noqa: E402
from plotting.foamCase import Case  # noqa: E402
from plotting.raster import Canvas  # noqa: E402
from plotting.shellSurface import _lattice, _subTriangles  # noqa: E402
from plotting.surfaces import patches, planeCut  # noqa: E402
from plotting.tables import Table, history  # noqa: E402

N = (4, 3, 2)               # cells
SIZE = np.array([2, 1.5, 1])

HEADER = ('FoamFile {{ version 2.0; format {format}; class {kind};'
          ' arch "LSB;label=32;scalar=64"; object x; }}\n')


def write(path, kind, content, format="ascii"):
    path.parent.mkdir(parents=True, exist_ok=True)
    head = HEADER.format(kind=kind, format=format).encode()
    path.write_bytes(head + (content if isinstance(content, bytes)
                             else content.encode()))


def numbers(values, binary):
    """A list as OpenFOAM writes it."""
    if binary:
        return (f"{len(values)}\n(".encode()
                + np.ascontiguousarray(values).tobytes() + b")\n")
    rows = (f"({' '.join(map(repr, map(float, v)))})" if np.ndim(v)
            else repr(v.item()) for v in values)
    return f"{len(values)}\n(\n{chr(10).join(rows)}\n)\n".encode()


class BoxCase:
    """Hexahedra in a box, sides z empty or all patches, a linear field."""

    def __init__(self, folder, binary=False, sides="patch"):
        self.folder, self.binary = folder, binary
        self.format = "binary" if binary else "ascii"
        (folder / "system").mkdir(parents=True)
        places = [np.linspace(0, s, n + 1) for s, n in zip(SIZE, N)]
        grid = np.meshgrid(*places, indexing="ij")
        self.points = np.column_stack([g.ravel(order="F") for g in grid])
        faces, owner, neighbour, starts = self.faces()
        mesh = folder / "constant" / "polyMesh"
        self.list(mesh / "points", "vectorField", self.points)
        self.list(mesh / "owner", "labelList", owner.astype("i4"))
        self.list(mesh / "neighbour", "labelList", neighbour.astype("i4"))
        if binary:
            offsets = 4*np.arange(len(faces) + 1, dtype="i4")
            write(mesh / "faces", "faceCompactList",
                  numbers(offsets, True)
                  + numbers(np.ravel(faces).astype("i4"), True), "binary")
        else:
            rows = "\n".join(f"4({' '.join(map(str, f))})" for f in faces)
            write(mesh / "faces", "faceList", f"{len(faces)}\n(\n{rows}\n)\n")
        text = "".join(
            f"{name} {{ type {sides if name == 'z' else 'patch'};"
            f" nFaces {end - start}; startFace {start}; }}\n"
            for name, start, end in starts)
        write(mesh / "boundary", "polyBoundaryMesh",
              f"{len(starts)}\n(\n{text})\n")

    def list(self, path, kind, values):
        write(path, kind, numbers(values, self.binary), self.format)

    def field(self, time, name, values):
        kind = "scalar" if values.ndim == 1 else "vector"
        write(self.folder / time / name, f"point{kind.title()}Field",
              f"dimensions [0 0 0 0 0 0 0];\ninternalField nonuniform"
              f" List<{kind}> ".encode() + numbers(values, self.binary)
              + b";\nboundaryField { }\n", self.format)

    @staticmethod
    def faces():
        """Interior faces, then those of the patches x, y and z."""
        def point(i, j, k):
            return i + (N[0] + 1)*(j + (N[1] + 1)*k)

        def cell(i, j, k):
            return i + N[0]*(j + N[1]*k)

        inner, outer = [], {name: [] for name in "xyz"}
        for axis, name in enumerate("xyz"):
            ends = [n + (a == axis) for a, n in enumerate(N)]
            b, c = np.eye(3, dtype=int)[[(axis + 1) % 3, (axis + 2) % 3]]
            for at in np.ndindex(*ends):
                at = np.array(at)
                face = [point(*p) for p in (at, at + b, at + b + c, at + c)]
                after = at - np.eye(3, dtype=int)[axis]
                if at[axis] == 0:
                    outer[name].append((face[::-1], cell(*at), None))
                elif at[axis] == N[axis]:
                    outer[name].append((face, cell(*after), None))
                else:
                    inner.append((face, cell(*after), cell(*at)))
        starts, faces = [], list(inner)
        for name, some in outer.items():
            starts.append((name, len(faces), len(faces) + len(some)))
            faces += some
        return ([f for f, _, _ in faces],
                np.array([o for _, o, _ in faces]),
                np.array([n for _, _, n in inner]), starts)


def linear(x):
    return 3 + x @ np.array([2, -1, 0.5])


def area(surface):
    a, b, c = (surface.points[surface.triangles[:, i]] for i in range(3))
    return 0.5*np.linalg.norm(np.cross(b - a, c - a), axis=1).sum()


def plot(*words, code=0):
    """What the script prints, run in this process: imports cost seconds."""
    printed = io.StringIO()
    with contextlib.redirect_stdout(printed), \
            contextlib.redirect_stderr(printed), \
            mock.patch.object(sys, "argv", [str(SCRIPT), *map(str, words)]):
        try:
            plotResults.main()
            found = 0
        except SystemExit as stop:
            found = stop.code
            if isinstance(found, str):
                printed.write(found)
                found = 1
    plt.close("all")
    assert found == code, printed.getvalue()
    return printed.getvalue()


@pytest.fixture(params=[False, True], ids=["ascii", "binary"])
def box(request, tmp_path):
    case = BoxCase(tmp_path / "box", request.param)
    case.field("0.5", "p", linear(case.points))
    case.field("0.5", "U", case.points)
    return case


def test_cut_of_a_linear_field_is_exact(box):
    pieces = Case(box.folder).pieces("0.5")
    # Along faces of cells, through cells, and at a slant: up from the side
    # y = 0 at z = 0.35 to the side z = 1
    slanted = 2*(0.65/0.75)*1.25
    for origin, normal, wanted in (
        ([1, 0, 0], [1, 0, 0], 1.5), ([0.9, 0, 0], [1, 0, 0], 1.5),
        ([0, 0.2, 0.5], [0, -0.6, 0.8], slanted),
    ):
        cut = planeCut(pieces, origin, normal, "p")
        assert np.abs(cut.values - linear(cut.points)).max() < 1e-12
        out = (cut.points - origin) @ np.array(normal)
        assert np.abs(out).max() < 1e-12
        assert area(cut) == pytest.approx(wanted, rel=1e-12)
    with pytest.raises(PlotError, match="cuts no cell: the mesh spans"):
        planeCut(pieces, [5, 0, 0], [1, 0, 0], "p")


def test_patches_and_components(box):
    pieces = Case(box.folder).pieces("0.5")
    ends = patches(pieces, ["x"], "U.y")
    assert area(ends) == pytest.approx(2*1.5)
    assert np.allclose(ends.values, ends.points[:, 1])
    size = patches(pieces, ["x", "y"], "U")
    assert np.allclose(size.values, np.linalg.norm(size.points, axis=1))
    with pytest.raises(PlotError, match="no patch wall; there are: x, y, z"):
        patches(pieces, ["wall"], "p")
    with pytest.raises(PlotError, match="there are: U, p"):
        patches(pieces, ["x"], "rho")


def test_moved_points_and_parts_of_a_case(tmp_path):
    case = BoxCase(tmp_path / "box", sides="empty")
    case.field("0", "p", linear(case.points))
    case.field("1", "p", linear(case.points))
    case.list(case.folder / "1/polyMesh/points", "vectorField",
              case.points + [0.5, 0, 0])
    moved, = Case(case.folder).pieces("1")
    assert np.allclose(moved.points, case.points + [0.5, 0, 0])
    still, = Case(case.folder).pieces("0")
    assert np.allclose(still.points, case.points)

    # As two processors would have it: the same picture from both
    said = plot("field", tmp_path / "whole.png", "p", "--case", case.folder)
    for i in range(2):
        part = BoxCase(case.folder / f"processor{i}", sides="empty")
        for time in ("0", "1"):
            part.field(time, "p", linear(part.points))
    shutil.rmtree(case.folder / "constant")
    assert len(Case(case.folder).pieces("1")) == 2
    assert "p at 1 s: 2 to 7.5" in said      # of the side z = 1
    assert "p at 1 s: 2 to 7.5" in plot(
        "field", tmp_path / "parts.png", "p", "--case", case.folder)
    assert (tmp_path / "parts.png").stat().st_size > 5000


def test_scene_shows_what_is_in_front(box, tmp_path):
    plot("scene", tmp_path / "scene.png", "p", "--case", box.folder,
         "--patch", "x", "--plane", "(0 1 0)", "(0 1 0)", "--subtract", 1)
    assert (tmp_path / "scene.png").stat().st_size > 5000

    canvas = Canvas(40, 30)
    square = np.array([[5, 5, 1], [35, 5, 1], [35, 25, 1], [5, 25, 1]], float)
    slope = np.array([[0, 0, 0], [40, 0, 2], [40, 30, 2], [0, 30, 0]], float)
    two = np.array([[0, 1, 2], [0, 2, 3]])
    for places, colour in ((square, [1, 0, 0]), (slope, [0, 0, 1])):
        canvas.draw(places, two, np.tile(np.array(colour, float), (4, 1)),
                    np.ones(2))
    image = canvas.image()
    # The slope is nearer in the left half
    assert (image[15, 2:18] == [0, 0, 1]).all()
    assert (image[15, 22:34] == [1, 0, 0]).all()
    assert (image[15, 36:] == [0, 0, 1]).all()


def test_high_order_triangles_are_covered_once():
    for order in (1, 2, 3):
        places = np.array(_lattice(order))
        triangles = np.array(list(_subTriangles(order)))
        assert len(places) == (order + 1)*(order + 2)//2
        a, b, c = (places[triangles[:, i]] for i in range(3))
        assert len(triangles) == order**2
        assert (np.cross(b - a, c - a) == 1).all()
    assert _lattice(3)[3:] == [(1, 0), (2, 0), (2, 1), (1, 2), (0, 2), (0, 1),
                               (1, 1)]


def table(folder, name, text):
    path = folder / "postProcessing" / name
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_text(text)


@pytest.fixture
def tables(tmp_path):
    table(tmp_path, "tip/0/u.dat", "# u\n# Time u_x u_y\n"
          "0 0 0\n1 (2 3)\n2 4 9\n3 6 7\n")
    table(tmp_path, "tip/2/u.dat", "# Time u_x u_y\n2.5 50 1\n3 60 2\n4 70")
    (tmp_path / "exact.csv").write_text(
        "# source: none\nt ms,u\n0,0\n1000,2.02\n2000,4\n9000,1\n")
    return tmp_path


def test_histories_join_restarts_and_scale(tables):
    found = history(tables, "tip/u.dat")
    # The row that is being written is left out
    assert found.rows.tolist() == [
        [0, 0, 0], [1, 2, 3], [2, 4, 9], [2.5, 50, 1], [3, 60, 2]]
    assert found.column("u_x*1e-1-2").tolist() == [-2, -1.8, -1.6, 3, 4]
    assert found.column("2").tolist() == [0, 3, 9, 1, 2]
    odd = Table("x", ["p-1", "p"], np.array([[3.0, 8.0]]))
    assert odd.column("p-1") == 3 and odd.column("p*2-1") == 15
    with pytest.raises(PlotError, match="no column v; there are Time, u_x"):
        found.column("v")
    with pytest.raises(PlotError, match="run the case first.*tip/u.dat"):
        history(tables, "tips/u.dat")


def test_script_runs_without_a_display(tables):
    def caches():
        return set(SCRIPT.parent.glob("**/__pycache__"))

    # Other tests may have left theirs
    before = caches()
    done = subprocess.run(
        [sys.executable, SCRIPT, "history", tables / "u.png", "--case", tables,
         "--curve", "tip/u.dat", "u_x"],
        capture_output=True, text=True, env={"PATH": "/usr/bin:/bin"},
        timeout=120)
    assert done.returncode == 0, done.stderr
    assert f"picture: {tables}/u.png" in done.stdout
    assert caches() <= before


def test_history_prints_and_checks(tables):
    words = ["history", tables / "u.png", "--case", tables, "--panel", "u",
             "--curve", "tip/0/u.dat", "Time*1e3:u_x", "here",
             "--reference", "exact.csv", "t ms:u", "exact",
             "--mean", 500, 2500]
    said = plot(*words, "--within", 0.51)
    assert "here: smallest 0 at 0, largest 6 at 3000, last 6" in said
    assert "here: mean of 500 to 2500: 3" in said
    # 0.02 of 4; what lies behind the history's end is not compared
    assert "largest deviation from exact: 0.5 %" in said
    assert (tables / "u.png").stat().st_size > 5000
    assert "above its bound" in plot(*words, "--within", 0.49, code=1)


def test_messages_name_what_is_wrong(tables, tmp_path):
    (tmp_path / "system").mkdir()
    for words, said in (
        (["history", "x.png"], "nothing to draw"),
        (["history", "x.png", "--curve", "a.dat"], "wants FILE COLUMNS"),
        (["field", "x.png", "p", "--colours", "pink2"], "no colour map pink2"),
    ):
        assert said in plot(*words, code=2)
    for words, said in (
        (["field", "x.png", "p"], "no results"),
        (["field", "x.png", "p", "--case", tmp_path / "none"], "not a case"),
        (["history", "x.png", "--curve", "exact.csv", "a"], "no column a"),
    ):
        more = [] if "--case" in words else ["--case", tmp_path]
        assert said in plot(*words, *more, code=1)
    case = BoxCase(tmp_path / "box")
    case.field("0.5", "p", linear(case.points))
    for words, said in (
        (["field", "x.png", "p"], "it is three-dimensional"),
        (["field", "x.png", "p", "--time", "0.4"], "there are: 0.5"),
        (["scene", "x.png", "p"], "nothing to draw"),
        (["scene", "x.png", "p", "--shell"], "no series (.pvd) of a shell"),
    ):
        flat = " ".join(plot(*words, "--case", case.folder, code=1).split())
        assert said in flat
