"""setPointFields: regions, and states of gas, serial and on two processors."""
import re

import numpy as np
import pytest

from foamCase import FoamCase
from foamEnvironment import PROJECT
from gasBox import GAMMA, R
from statesBox import StatesBox, energyDensity

EVERYTHING = """
defaultFieldValues ( pointScalarFieldValue p 1.1e5 );
regions
(
    boxToCell
    {
        box (0.45 -1 -1) (0.58 0.3 2);
        fieldValues ( pointScalarFieldValue T 300 );
    }
    cylinderToPoint
    {
        p1 (0.8 0.5 -1); p2 (0.8 0.5 2); radius 0.11;
        fieldValues ( pointVectorFieldValue U (1 2 0) );
    }
);
states
(
    sphericalCharge { centre (0.47 0.45 %s); radius 0.2; p 5e5; T 700; }
    mappedProfile
    {
        geometry    %s
        centre      (0.1 0 0);
        file        "$FOAM_CASE/table";
        fraction    %s;
    }
    planarShock
    {
        machNumber 2; point (0.2 0.1 0); normal (3 1 0);
        ahead { p 1.1e5; T 290; }
    }
);
"""
TABLE = """r rho u p
0.05 1.3 0 2e5
0.3 2 100 3e5
0.4 1.3217 0 1.1e5
"""


@pytest.mark.parametrize("dim, parts", [(2, "2 1 1"), (2, "1 2 1"),
                                        (3, "1 1 2"), (3, "2 1 1")])
def test_parallel(tmp_path, dim, parts):
    """Two processors, cut through all states: the same fields."""
    cells = (18, 16, 14)[:dim]
    # 0.1 from the wall x = 0: the profile's part in the mesh is measured by
    # the error message, once, and given
    angle = np.arccos(0.25)
    cap = {
        2: (angle - np.sin(angle) * np.cos(angle)) / np.pi,
        3: (2 + 0.25) * (1 - 0.25) ** 2 / 4,
    }[dim]
    share = {2: 0.5, 3: 0.25}[dim] * (1 - cap)
    text = EVERYTHING % {
        2: ("0", "cylindrical;", share),
        3: ("0.5", "spherical;", share),
    }[dim]

    cases = []
    for name in ("serial", "parallel"):
        case = StatesBox(tmp_path / name, (1, 1, 1)[:dim], cells)
        (case.path / "table").write_text(TABLE)
        cases.append(case)
    cases[0].setPointFields(text)
    cases[1].setInParallel(text, parts)

    serial, parallel = (case.gas() for case in cases)
    for one, two in zip(serial, parallel):
        scale = np.abs(one).max()
        assert np.abs(one - two).max() <= 1e-11 * scale
    assert np.ptp(serial[0]) > 3e5 and np.ptp(serial[1]) > 100
    for after in range(2):
        for one, two in zip(*(case.scene(after) for case in cases)):
            assert one == pytest.approx(two, rel=1e-12)

    # The log counts points and nodes that processors share once
    for words in (r"T = 300 at (\d+) points", r"(\d+) nodes behind it"):
        one, two = (re.search(words, case.log).group(1) for case in cases)
        assert one == two


def test_regions(tmp_path):
    """Sources of points and of cells; the points of the cells are set."""
    case = StatesBox(tmp_path / "case", (1, 1), (10, 10))
    case.setPointFields("""
    regions
    (
        boxToCell
        {
            box (0.2 0.2 -1) (0.5 0.6 1);
            fieldValues ( pointScalarFieldValue p 3e5 );
        }
        sphereToPoint
        {
            centre (0.8 0.8 0); radius 0.15;
            fieldValues
            ( pointScalarFieldValue T 500 pointVectorFieldValue U (7 0 0) );
        }
    );
    """)
    p, U, T, _ = case.gas()
    x = case.x
    box = ((x[:, :2] > 0.2 - 1e-9) & (x[:, :2] < (0.5 + 1e-9, 0.6 + 1e-9)))
    box = box.all(axis=1)
    assert (p[box] == 3e5).all() and (p[~box] == case.P).all()
    ball = np.linalg.norm(x - (0.8, 0.8, 0), axis=1) <= 0.15
    assert ball.sum() > 5
    assert (T[ball] == 500).all() and (abs(T[~ball] - case.T) < 1e-9).all()
    assert (U[ball] == (7, 0, 0)).all() and (U[~ball] == 0).all()


def test_sets(tmp_path):
    """setToPoint: what topoSet has stored."""
    case = StatesBox(tmp_path / "case", (1, 1), (6, 6))
    head = (case.path / "system/controlDict").read_text().split("// * *")[0]
    (case.path / "system" / "topoSetDict").write_text(
        head.replace("controlDict", "topoSetDict") + """
        actions
        (
            {
                name some; type cellSet; action new;
                source boxToCell; box (-1 -1 -1) (0.3 2 2);
            }
        );
        """)
    case.run("topoSet")
    case.setPointFields("""
    regions
    (
        cellToPoint
        {
            set some; option all;
            fieldValues ( pointScalarFieldValue p 2e5 );
        }
    );
    """)
    left = case.x[:, 0] < 1 / 3 + 1e-9
    p = case.gas()[0]
    assert (p[left] == 2e5).all() and (p[~left] == case.P).all()


def test_planarShock(tmp_path):
    """Rankine-Hugoniot across the plane, gas ahead in motion."""
    case = StatesBox(tmp_path / "case", (1, 1), (20, 20))
    log = case.setPointFields("""
    states
    (
        planarShock
        {
            machNumber  1.8;
            point       (0.3 0.3 0);
            normal      (1 2 0);
            ahead       { p 1e5; T 290; U (20 -10 0); }
        }
    );
    """)
    p, U, T, rho = case.gas()
    n = np.array([1, 2, 0]) / np.sqrt(5)
    behind = (case.x - (0.3, 0.3, 0)) @ n <= 1e-9
    assert 50 < behind.sum() < len(p) - 50

    # In the frame of the front: mass, momentum, energy
    a = np.array([1e5, 290, 20, -10, 0])
    c = np.sqrt(GAMMA * R * a[1])
    rho1, U1 = a[0] / (R * a[1]), a[2:]
    speed = U1 @ n + 1.8 * c
    rho2, p2, U2 = rho[behind][0], p[behind][0], U[behind][0]
    w1, w2 = U1 @ n - speed, U2 @ n - speed
    assert rho2 * w2 == pytest.approx(rho1 * w1, rel=1e-7)
    assert p2 + rho2 * w2**2 == pytest.approx(a[0] + rho1 * w1**2, rel=1e-7)
    h1, h2 = (GAMMA / (GAMMA - 1) * q for q in (a[0] / rho1, p2 / rho2))
    assert h2 + w2**2 / 2 == pytest.approx(h1 + w1**2 / 2, rel=1e-6)
    assert (p[behind] == p2).all() and (p[~behind] == case.P).all()
    assert (U[~behind] == 0).all()
    assert f"{(~behind).sum() // 2} nodes in front of it" in log


def test_chargeOnALine(tmp_path):
    """Mass and energy with nodal volumes made here: halves of the cells."""
    N = 40
    case = StatesBox(tmp_path / "case", (1,), (N,))
    case.setPointFields("""
    states
    ( sphericalCharge { centre (0 0 0); radius 0.213; p 2e6; T 1000; } );
    """)
    p, U, T, rho = case.gas()
    one = (case.x[:, 1] == 0) & (case.x[:, 2] == 0)
    x = case.x[one, 0]
    h = np.full(N + 1, 1 / N)
    h[[np.argmin(x), np.argmax(x)]] /= 2
    rhoIn, rhoOut = 2e6 / (R * 1000), case.P / (R * case.T)
    mass = 0.213 * rhoIn + (1 - 0.213) * rhoOut
    energy = (0.213 * 2e6 + (1 - 0.213) * case.P) / (GAMMA - 1)
    assert (h * rho[one]).sum() == pytest.approx(mass, rel=1e-10)
    assert (h * energyDensity(p, U, rho)[one]).sum() == pytest.approx(
        energy, rel=1e-10)
    assert p.max() <= 2e6 * (1 + 1e-9)


def test_chargeInSpace(tmp_path):
    """An eighth of a ball: what the scene gains, and the gas solver's own
    totals."""
    case = StatesBox(tmp_path / "case", (1, 1, 1), (12, 10, 9))
    case.setPointFields("""
    states
    ( sphericalCharge { centre (0 0 0); radius 0.6; mass 4; energy 5e6; } );
    """)
    ball = 4 * np.pi / 3 * 0.6**3
    rho, e = case.P / (R * case.T), case.P / (GAMMA - 1)
    before, after = case.scene()
    assert before == pytest.approx([rho, e], rel=1e-6)
    gain = (after - before) / (np.array([4, 5e6]) - ball * np.array([rho, e]))
    assert gain == pytest.approx(1 / 8, rel=1e-6)
    assert "nodes along the radius" in case.log
    assert "only" in case.log           # the warning: fewer than 10

    # One step too short for anything to leave
    assert case.runTo(1e-9, deltaT=1e-9, adjustTimeStep="no") == 0, case.log[-1000:]
    end = re.search(r"at the end: mass (\S+) .* energy (\S+) J", case.log)
    assert [float(q) for q in end.groups()] == pytest.approx(after, rel=1e-8)


def test_chargeAcrossACyclicPatch(tmp_path):
    """A charge has the same part of both sides; a shock must not have two
    states at one place."""
    case = StatesBox(tmp_path / "case", (1, 1), (10, 10))
    blocks = case.path / "system" / "blockMeshDict"
    text = blocks.read_text()
    text = re.sub(r" *ends.*\n", """
        left { type cyclic; neighbourPatch right; faces ((0 4 7 3)); }
        right { type cyclic; neighbourPatch left; faces ((1 2 6 5)); }
        walls { type patch; faces ((0 1 5 4) (3 7 6 2)); }
    """, text)
    blocks.write_text(text)
    case.run("blockMesh")
    for name in "pUT":
        field = case.path / "0" / name
        field.write_text(field.read_text().replace(
            "boundaryField\n{",
            "boundaryField\n{ left { type cyclic; } right { type cyclic; }"
        ))

    case.setPointFields("""
    states
    (
        sphericalCharge
        { centre (0 0.5 0); radius 0.3; p 1e6; T 500; fraction 0.5; }
    );
    """)
    p = case.gas()[0]
    left, right = (np.isclose(case.x[:, 0], x) for x in (0, 1))
    assert (np.sort(p[left]) == np.sort(p[right])).all()
    assert p[left].max() > 4e5

    log = case.setPointFields("""
    states
    (
        planarShock
        {
            machNumber 2; point (0.5 0 0); normal (1 0 0);
            ahead { p 1e5; T 290; }
        }
    );
    """, check=False)
    assert case.exitCode != 0 and "cyclic" in log


def test_profileOfACase(tmp_path):
    """A run on a line into a plane and a space scene: its mass and energy
    per cross section, and its values."""
    source = StatesBox(tmp_path / "source", (1,), (100,))
    source.setPointFields("""
    regions
    (
        boxToPoint
        {
            box (0.4 -1 -1) (0.6 1 1);
            fieldValues ( pointScalarFieldValue p 1.4e5 );
        }
    );
    """)
    source.schemes("timeScheme twoStep; shockCapturing pressureLaplacian;")
    assert source.runTo(4e-4, deltaT=1e-5) == 0, source.log[-1000:]
    time = source.times()[-1]
    assert float(time) == pytest.approx(4e-4)
    p, U, T = (source.pointField(name, time) for name in ("p", "U", "T"))
    one = (source.x[:, 1] == 0) & (source.x[:, 2] == 0)
    r = source.x[one, 0]
    weight = np.full(101, 0.01)
    weight[[np.argmin(r), np.argmax(r)]] /= 2

    for dim, cells in ((2, (50, 4)), (3, (25, 3, 3))):
        case = StatesBox(tmp_path / f"case{dim}", (1, 0.2, 0.2)[:dim], cells)
        text = """
        states
        (
            mappedProfile
            {
                geometry planar; centre (0 0 0); axis (1 0 0);
                case "$FOAM_CASE/../source"; time %s;
            }
        );
        """ % time
        if dim == 2:
            case.setPointFields(text)
        else:
            case.setInParallel(text, "2 1 1")
        section = 0.2 * (0.02 if dim == 2 else 0.2)
        before, after = case.scene()

        # The constants of the gas to all digits, from the uniform start
        volume = case.P * section
        exactR, exactGamma = volume / (case.T * before[0]), 1 + (
            volume / before[1])
        assert (exactR, exactGamma) == pytest.approx((R, GAMMA), rel=1e-6)
        rho = p / (exactR * T)
        energy = p / (exactGamma - 1) + 0.5 * rho * U[:, 0]**2
        line = [(weight * q[one]).sum() for q in (rho, energy)]
        assert after / section == pytest.approx(line, rel=1e-10)
        q = case.gas()[0]
        expected = np.interp(case.x[:, 0], r, p[one])
        assert np.abs(q - expected).max() < 0.01 * np.ptp(expected)


def test_tutorialDictionary(tmp_path):
    """A dictionary of setFields' form alone."""
    case = FoamCase(
        PROJECT / "tutorials" / "fsi" / "shockPanel50", tmp_path / "panel"
    )
    case.run("blockMesh")
    case.run("setPointFields")
    behind = case.points()[:, 0] <= -0.02
    p, U, T = (case.pointField(name, "0") for name in ("p", "U", "T"))
    assert behind.any() and not behind.all()
    assert (p == np.where(behind, 154145, 1e5)).all()
    assert (T == np.where(behind, 332.3405, 293)).all()
    assert (U[behind] == (109.669, 0, 0)).all() and (U[~behind] == 0).all()
