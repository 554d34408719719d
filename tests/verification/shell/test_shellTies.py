"""Rigid ties in a case: a force and a moment at a point, a given motion."""
import numpy as np

from foamFile import readText
from shellCase import ShellCase, isotropic, ramp
from shellFiles import readState
from shellMotion import MovingCase
from shellShapes import plate

CLAMP = {"root": {"type": "clamped", "nodeSet": "uMin"}}
FLANGE = {"type": "rigidTie", "nodeSet": "uMax", "point": (13, 0.5, 0)}


def test_end_moment_bends_a_strip_to_a_half_circle(tmp_path):
    """source: Sze, Liu and Lo (2004), 3.2: radius EI/M, here L/pi; the point
    lies beyond the end on its tangent."""
    length, EI = 12, 1.2e6*0.1**3/12
    case = ShellCase(
        tmp_path, plate(8, 1, length, 1), isotropic(1.2e6, 0, 0.1),
        {**CLAMP, "flange": FLANGE})
    moment = np.pi*EI/length
    u = case.solve({"moment": ramp({
        "type": "rigidTie", "nodeSet": "uMax", "moment": (0, -moment, 0)})},
        steps=8)
    end = (case.mesh.nodes + u)[case.mesh.sets["uMax"]]
    radius = length/np.pi
    assert abs(end[:, 0]).max() < 0.01*length
    assert abs(end[:, 2] - 2*radius).max() < 0.01*length
    # The end moves as one: distances between neighbours
    steps = np.diff(end, axis=0)
    assert abs(np.linalg.norm(steps, axis=1) - 1/3).max() < 1e-9
    assert abs(steps - steps[0]).max() < 1e-9
    assert "UMFPACK" in case.log


def test_given_motion_of_a_flange(tmp_path):
    """One end held, the other turned and moved as given; restart files hold
    the rotation."""
    case = MovingCase(
        tmp_path, plate(4, 1, 12, 1), isotropic(1.2e6, 0, 0.1),
        {**CLAMP, "flange": {
            "type": "rigidMotion", "nodeSet": "uMax", "point": (13, 0.5, 0),
            "direction": (0, 0, 2), "displacement": "polynomial ((0.3 2))",
            "axis": (1, 0, 0), "angle": "polynomial ((1.5 2))"}})
    case.march({}, 0.5, 0.02)
    state = readState(case.case, 0.5)
    nodes = case.mesh.sets["uMax"]
    angle, shift = 1.5*0.5**2, 2*0.3*0.5**2
    c, s = np.cos(angle), np.sin(angle)
    turn = np.array([(1, 0, 0), (0, c, -s), (0, s, c)])
    arms = case.mesh.nodes[nodes] - (13, 0.5, 0)
    expected = arms @ turn.T + (13, 0.5, shift)
    np.testing.assert_allclose(state["position"][nodes], expected, atol=1e-12)
    np.testing.assert_allclose(
        state["director"][nodes], np.tile(turn[:, 2], (len(nodes), 1)),
        atol=1e-12)
    np.testing.assert_allclose(
        state["velocity"][nodes],
        np.cross((2*1.5*0.5, 0, 0), expected - (13, 0.5, shift))
        + (0, 0, 2*2*0.3*0.5), atol=1e-10)
    # Work of the driven end is what the strip has
    energies = case.table("energies")
    total = energies["kinetic"][-1] + energies["strain"][-1]
    assert abs(energies["supportWork"][-1]/total - 1) < 0.01


def test_wrong_ties_are_named(tmp_path):
    case = ShellCase(
        tmp_path, plate(2, 1), isotropic(1, 0, 0.1),
        {**CLAMP, "flange": {**FLANGE, "nodeSet": "vMin"}})
    try:
        case.solve({})
    except Exception:
        pass
    log = readText(tmp_path / "case" / "log.positionalShellFoam")
    assert "rigid tie of node set vMin: node" in log
    assert "in another constraint" in log
