"""The function object sampleLine: values along lines by the shape functions of
the simplices, on a mesh at rest and a moving one."""
import sys
from pathlib import Path

import numpy as np
import pytest

sys.path.insert(0, str(Path(__file__).parents[1] / "gasBenchmarks"))

from benchmarkCase import BenchmarkCase  # noqa: E402
from blockMeshes import box  # noqa: E402
from foamCase import RunFailed  # noqa: E402

LINES = """
    along { start (0 0.5 0.5); end (2 0.5 0.5); nPoints 41; }
    across { points ((0.33 0 0.5) (0.33 0.6 0.5) (0.33 1.5 0.5)); }
"""
FUNCTIONS = """{{
    profile {{ type sampleLine; libs (shockShellFunctionObjects);
        fields ({fields}); lines {{ {lines} }}
        writeControl writeTime; writePrecision 16; }}
    {more}
}}"""


def gradients(x):
    """Linear in p, U and T at the nodes."""
    p = 1 + 0.1*x[:, 0] + 0.2*x[:, 1]
    U = np.column_stack([0.1*x[:, 1], 0.05*x[:, 0], 0*x[:, 0]])
    return p/(1 + 0.1*x[:, 1]), U, p


def case(folder):
    found = BenchmarkCase(folder, box([(2, 20)], (1, 6)))
    found.start(gradients, dict.fromkeys(
        ("left", "right", "bottom", "top"), "wall"))
    return found


def run(found, end=0.2, fields="p U", lines=LINES, more="", **control):
    found.runTo(end, functions=FUNCTIONS.format(
        fields=fields, lines=lines, more=more), **control)


def read(found, time, line):
    path = (found.path / "postProcessing" / "profile" / time / f"{line}.csv")
    with open(path) as stream:
        names = stream.readline().strip().split(",")
    return dict(zip(names, np.loadtxt(path, delimiter=",", skiprows=1).T))


def test_linearFieldsAreExact(tmp_path):
    found = case(tmp_path / "rest")
    run(found, 1e-6)
    along = read(found, "0", "along")
    assert list(along) == ["distance", "x", "y", "z", "p", "U_x", "U_y", "U_z"]
    assert np.allclose(along["distance"], np.linspace(0, 2, 41))
    assert np.allclose(along["x"], np.linspace(0, 2, 41))
    # Walls change the velocity, and with it p, at their nodes only
    inside = (along["x"] > 0.2) & (along["x"] < 1.8)
    assert np.allclose((along["p"] - 1.1 - 0.1*along["x"])[inside], 0,
                       atol=1e-13)
    assert np.allclose(along["U_y"][inside], 0.05*along["x"][inside])
    assert np.allclose(along["U_x"][inside], 0.05)

    across = read(found, "0", "across")
    assert np.allclose(across["distance"], [0, 0.6, 1.5])
    assert across["p"][1] == pytest.approx(1.153, rel=1e-13)
    # Outside
    assert np.isnan([across[name][2] for name in ("p", "U_x")]).all()


def test_sameOnProcessorsAndAsProbes(tmp_path):
    found = case(tmp_path / "box")
    points = " ".join(f"({x:.17g} 0.5 0.5)" for x in np.linspace(0, 2, 41))
    more = ("places { type pointProbes; libs (shockShellFunctionObjects);"
            f" points ({points}); fields (p U); }}")
    run(found, more=more)
    serial = read(found, "0.2", "along")
    names, rows = found.history("places/0/p.dat")
    assert np.allclose(serial["p"], rows[-1, 1:], rtol=1e-9)
    assert abs(np.ptp(serial["p"]) - 0.2) > 0.01    # something has happened
    names, rows = found.history("places/0/U.dat")
    assert names[4:6] == ["U_x_1", "U_y_1"] and len(names) == rows.shape[1]
    assert np.allclose(serial["U_y"], rows[-1, 2::3], atol=1e-9)

    found.write("system/decomposeParDict",
                "numberOfSubdomains 2; method simple;\n"
                "simpleCoeffs { n (2 1 1); delta 0.001; }\n")
    found.run("rm", "-r", "0.2", "postProcessing")
    found.run("decomposePar")
    found.runParallel(2, "shockShellFoam")
    for line in ("along", "across"):
        assert (found.path / "postProcessing/profile/0" / f"{line}.csv"
                ).exists()
    parallel = read(found, "0.2", "along")
    for name, values in serial.items():
        assert np.allclose(parallel[name], values, rtol=1e-10, atol=1e-12)


def test_pointsStayWhenTheMeshMoves(tmp_path):
    """The wall at x = 0 goes in by 0.1: behind it there is no gas."""
    found = case(tmp_path / "moving")
    found.move("pointDisplacement", {
        "left": "type uniformFixedValue; uniformValue table ((0 (0 0 0))"
                " (1 (0.5 0 0))); value uniform (0 0 0);",
        "bottom": "type slip;", "top": "type slip;"})
    run(found)
    line = read(found, "0.2", "along")
    outside = line["x"] < 0.1 - 1e-9
    assert outside.sum() == 2
    assert np.isnan(line["p"][outside]).all()
    assert not np.isnan(line["p"][~outside]).any()
    # At the wall: its speed, and more pressure than far from it
    wall = np.argmin(abs(line["x"] - 0.1))
    assert line["U_x"][wall] == pytest.approx(0.5, rel=1e-6)
    # Where the line meets nodes of the moved mesh: their values
    nodes = found.nodes()
    far = np.flatnonzero((abs(nodes[:, 1] - 0.5) < 1e-9)
                         & (nodes[:, 0] > 0.1))
    p = found.result("p")
    order = far[np.argsort(nodes[far, 0])]
    assert len(order) > 15
    values = np.interp(line["x"][4:-1], nodes[order, 0], p[order])
    assert np.allclose(line["p"][4:-1], values, rtol=1e-6)


@pytest.mark.parametrize("change, words", [
    ({"fields": "p rhoo"}, r"no point field rhoo[\s\S]*p\b[\s\S]*U"),
    ({"lines": "a { start (0 0 0); end (1 0 0); nPoints 1; }"},
     "at least 2 points"),
    ({"lines": "a { start (5 0 0); end (6 0 0); nPoints 3; }"},
     "No point of the line a"),
    ({"lines": ""}, "No line in the dictionary lines"),
    ({"lines": "a { points ((1 0 0)); start (0 0 0); }"}, "either points"),
    ({"lines": "a { point ((1 0 0)); }"}, "point"),
])
def test_wrongEntriesStop(tmp_path, change, words):
    found = case(tmp_path / "wrong")
    with pytest.raises(RunFailed, match=words):
        run(found, 0.01, **change)
