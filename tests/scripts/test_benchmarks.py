"""That the benchmarks run, on tiny meshes, and that their parts say the truth.
"""
import re
import subprocess
import sys

import numpy as np
import pytest

from projectFiles import PROJECT

BENCHMARKS = PROJECT / "tests" / "benchmarks"
sys.path[:0] = [str(PROJECT / "tests" / "verification" / "gasBenchmarks"),
                str(BENCHMARKS / "common"), str(BENCHMARKS / "speedError")]

import machine  # noqa: E402
from benchmarkCase import BenchmarkCase  # noqa: E402
from blockMeshes import box  # noqa: E402
from controlVolumes import ControlVolumes  # noqa: E402
from page import NoMarks, marks, replaceBetween  # noqa: E402
from problems import PROBLEMS, gridCells  # noqa: E402
from runLog import TICK, RunLog, TooShort  # noqa: E402
from sameError import Front, interval, levels  # noqa: E402
from tetrahedra import tetrahedra, volumes  # noqa: E402


def run(script, *words, code=0):
    done = subprocess.run([sys.executable, BENCHMARKS / script, *words],
                          stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
                          universal_newlines=True)
    assert done.returncode == code, done.stdout
    return done.stdout


def test_speedErrorRunsAndWritesItsPage(tmp_path):
    page = tmp_path / "page.md"
    page.write_text("before\n" + "\n".join(marks("speedError bulb")) +
                    "\nafter\n")
    run("speedError/speedError.py", "bulb", "-quick", "-page", page)
    text = page.read_text()
    assert text.startswith("before\n") and text.endswith("\nafter\n")
    rows = re.findall(
        r"^\| (\w+) \| (\d+) \| \S+ \| \S+ \| (\S+) \| \S+ \| (\S+) \|",
        text, re.M)
    sizes = PROBLEMS["bulb"].quick
    assert [(r[0], int(r[1])) for r in rows] == [
        (code, n) for code in ("rhoCentralFoam", "shockShellFoam")
        for n in sizes]
    assert re.search(r"rhoCentralFoam takes .* times our time", text)
    assert all(float(r[2]) > 0 and 0 < float(r[3]) < 0.3 for r in rows)
    assert (tmp_path / "pictures" / "speedError-bulb.png").exists()


def test_gasRunsAndWritesItsPage(tmp_path):
    page = tmp_path / "page.md"
    page.write_text("\n".join(marks("gas")) + "\n")
    run("gas/gasBenchmark.py", "-quick", "-page", page)
    text = page.read_text()
    # Each scheme and the peer, at rest and moving; hexahedra
    rows = re.findall(r"^\| (.*?) \| ([\d.]+) \| ([\d.]+) \|$", text, re.M)
    names = [name for name, _, _ in rows]
    for peer in ("rhoCentralFoam", "rhoCentralDyMFoam"):
        assert names.count(peer) == 1
    assert len([n for n in names if "`" in n]) == 6
    assert all(0 < float(b) < float(a) for _, a, b in rows)
    assert re.search(r"^\| 216 \| [\d.]+ \| [\d.]+ \|", text, re.M)
    assert float(re.search(r"([\d.]+) GB/s", text).group(1)) > 0


def test_inverseDistanceRunsAndWritesItsPage(tmp_path):
    page = tmp_path / "page.md"
    page.write_text("\n".join(marks("inverseDistance")) + "\n")
    run("inverseDistance/inverseDistanceBenchmark.py", "-quick", "-page", page)
    text = page.read_text()
    rows = re.findall(
        r"^\| ([23]) \| 0.01 \| ([\d,]+) \| .* \| (\S+) \| (\S+) \|$", text, re.M)
    assert [r[0] for r in rows] == ["2", "2", "3", "3"]
    assert all(0 < float(error) <= float(bound) <= 0.01
               for _, _, error, bound in rows)
    grown = re.findall(r"application grows as N\^([\d.]+)", text)
    assert len(grown) == 2 and all(0.5 < float(g) < 2 for g in grown)


def test_parallelRunsAndWritesItsPage(tmp_path):
    page = tmp_path / "page.md"
    page.write_text("\n".join(marks("parallel")) + "\n")
    run("parallel/parallelBenchmark.py", "-quick", "-methods", "scotch",
        "-page", page)
    one, several, ratio = map(float, re.search(
        r"^\| 2 \| scotch \| ([\d.]+) \| ([\d.]+) \| ([\d.]+) \|",
        page.read_text(), re.M).groups())
    assert ratio == pytest.approx(one / several, rel=0.02)


def test_shockPanelRunsAndWritesItsPage(tmp_path):
    page = tmp_path / "page.md"
    page.write_text("\n".join(marks("shockPanel")) + "\n")
    run("shockPanel/shockPanelBenchmark.py", "-quick", "-page", page)
    rows = re.findall(r"^\| (\w+, .*?) \| (\d+) \| (\S+) \| (\S+) \|$",
                      page.read_text(), re.M)
    assert [r[0].split(",")[0] for r in rows] == [
        "shockShellFoam", "shockShellFoam", "rhoCentralFoam"]
    assert all(int(steps) > 10 and float(seconds) > 0
               for _, steps, seconds, _ in rows)
    assert float(rows[2][3]) == 1


def test_shellRunsAndWritesItsPage(tmp_path):
    """The peer's rows only where it is installed."""
    page = tmp_path / "page.md"
    names = "costs", "cantilever", "hemisphere", "plate"
    page.write_text("\n".join(
        "\n".join(marks(f"shell {name}")) for name in names))
    run("shell/shellBenchmark.py", "-quick", "-page", page)
    text = page.read_text()
    for form in ("displacement", "assumedStrain"):
        assert f"| `{form}` | 2 elements | 8 elements |" in text
    dense, ours = (
        [float(v) for v in re.search(
            rf"^\| us per element: {name} \| (\S+) \| (\S+) \|", text,
            re.M).groups()]
        for name in ("straightforward dense tangent", "tangent, .*?"))
    assert dense[1] > 4 * ours[1]
    rows = re.findall(
        r"^\| positionalShellFoam \| (.*?) \| (\S+) \| (\S+) \|$", text, re.M)
    assert len(rows) == 3
    assert all(0 < float(seconds) < 30 for _, seconds, _ in rows)
    # Strip: one element in the length of a quarter; plate: 2 x 2
    assert 0 < float(rows[0][2]) < 0.5 and 0 < float(rows[2][2]) < 20
    for name in names[1:]:
        assert (tmp_path / "pictures" / f"shell-{name}.png").exists()


def test_shellNamesItsParts():
    said = run("shell/shellBenchmark.py", "nonsense", code=2)
    assert all(name in said for name in ("costs", "hemisphere", "plate"))


def test_speedErrorNamesTheProblems():
    said = run("speedError/speedError.py", "nonsense", code=2)
    assert all(name in said for name in PROBLEMS)


def test_missingProgramIsNamed(monkeypatch, tmp_path):
    monkeypatch.setattr(machine, "environment",
                        lambda: {"PATH": str(tmp_path)})
    with pytest.raises(machine.MissingProgram, match="rhoCentralFoam"):
        machine.need("rhoCentralFoam")


def test_pageWithoutMarks(tmp_path):
    """Known before the runs."""
    page = tmp_path / "page.md"
    page.write_text(marks("gas")[0])
    with pytest.raises(NoMarks):
        replaceBetween(page, "gas", "text")
    said = run("gas/gasBenchmark.py", "-quick", "-page", page, code=1)
    assert said.startswith("gas: error:") and "gas: end" in said


def test_timeAtTheSameError():
    """Time ~ error^-4 and a tenth of it; one run that another one beats."""
    errors = np.array([0.1, 0.05, 0.02])
    peer = Front(errors**-4, errors)
    ours = Front([*0.1 * errors**-4, 0.11 * 0.1**-4],
                 [*errors, 0.12])
    middle = levels(ours, Front([0.03**-4], [0.03]))[0]
    assert middle.ratio == pytest.approx((10, 10))
    assert [r.ratio[0] for r in levels(ours, peer)] == pytest.approx([10] * 3)
    assert interval(*ours.time(0.2)) == f"< {0.1 * 0.1**-4:.3g}"
    assert interval(*ours.time(0.01)) == f"> {0.1 * 0.02**-4:.3g}"


def test_timePerStep():
    def log(times):
        return "".join(f"ExecutionTime = {t} s  ClockTime = 1 s\n"
                       for t in times)

    found = RunLog(log([1.0, 1.5, 2.0, 9.0]))
    assert found.steps == 4
    assert found.perStep == pytest.approx(0.5)
    assert found.seconds == pytest.approx(2.0)
    assert RunLog(log([1, 1, 1])).perStep == TICK
    with pytest.raises(TooShort):
        RunLog(log([1.0, 2.0]))


def test_meansOverControlVolumes(tmp_path):
    """Volumes, and the means of linear functions, are exact."""
    def check(points, cells, size, **options):
        found = ControlVolumes(points, cells, **options)
        assert found.nodes.sum() == pytest.approx(size)
        assert found.cellVolumes.sum() == pytest.approx(size)
        coefficients = np.array([1.0, -2.0, 3.0])
        atNodes, inCells = found.means(
            lambda x: (x @ coefficients)[None])
        centres = points[cells].mean(axis=1) @ coefficients
        assert found.fromCells(np.full(len(cells), 2.0)) == pytest.approx(2)
        assert inCells[0] == pytest.approx(centres)
        whole = (found.cellVolumes * centres).sum()
        assert (found.nodes * atNodes[0]).sum() == pytest.approx(whole)

    mesh = tetrahedra((4, 3, 2), (1, 0.5, 0.5), shift=0.15)
    assert volumes(mesh.points, mesh.tets).min() > 0
    check(mesh.points, mesh.tets, 0.25)
    for cells in ((4, 3), (4, 3, 2)):
        sides = [(length, n) for length, n in zip((1, 0.5, 0.4), cells)]
        case = BenchmarkCase(tmp_path / str(len(cells)),
                             box(sides[:1], *sides[1:]))
        check(case.x, gridCells(*cells), {2: 0.5, 3: 0.2}[len(cells)],
              plane=len(cells) == 2)


def test_meshOfTetrahedraIsValid(tmp_path):
    case = BenchmarkCase(tmp_path / "case",
                         tetrahedra((4, 3, 2), (1, 0.5, 0.5), shift=0.15))
    assert "Mesh OK." in case.run("checkMesh")
