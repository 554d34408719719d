"""The motionSolver inverseDistance in OpenFOAM's moveDynamicMesh."""
from pathlib import Path

import numpy as np
import pytest

from foamCase import FoamCase

from boundaryMesh import BoundaryMesh, inverseDistance, slidingDistance

CASES = Path(__file__).resolve().parent / "cases"
DICT = "constant/dynamicMeshDict"
COEFFS = "inverseDistanceCoeffs"
FIELD = "pointDisplacement"
AMPLITUDE = np.array([0.008, -0.002, 0])


def prescribed(points):
    """Displacement that the case gives the panel at time 1."""
    return np.cos(1.5 - 3*points[:, 1])[:, None]*AMPLITUDE


def panelCase(folder, sides="empty"):
    case = FoamCase(CASES / "panel", folder)
    if sides != "empty":
        case.set("system/blockMeshDict", "sideType", sides)
        case.set("system/blockMeshDict", "nz", 5)
        patchField = "fixedValue" if sides == "patch" else sides
        case.set(
            f"0/{FIELD}", 'boundaryField/"(front|back)"',
            f"{{ type {patchField}; value uniform (0 0 0); }}",
        )
    return case


def setCoeff(case, keyword, value):
    case.set(DICT, f"{COEFFS}/{keyword}", value)


def moved(case):
    """Displacement of all points at time 1."""
    case.run("blockMesh")
    case.log = case.run("moveDynamicMesh")
    return case.pointField(FIELD, "1")


def movedInParallel(case, parts):
    case.run("blockMesh")
    case.set("system/decomposeParDict", "simpleCoeffs/n", f"({parts})")
    case.run("decomposePar")
    case.log = case.runParallel(2, "moveDynamicMesh")
    case.run("reconstructPar")
    return case.pointField(FIELD, "1")


@pytest.fixture(scope="module")
def panel(tmp_path_factory):
    case = panelCase(tmp_path_factory.mktemp("panel") / "case")
    case.displacement = moved(case)
    case.mesh = BoundaryMesh(case)
    return case


def test_interface_follows_what_is_prescribed(panel):
    points = panel.mesh.patchPoints("panel")
    np.testing.assert_allclose(
        panel.displacement[points],
        prescribed(panel.mesh.points[points]),
        rtol=0, atol=1e-16,
    )


def test_fixed_points_stay(panel):
    points = np.setdiff1d(
        panel.mesh.patchPoints("floor", "walls"),
        panel.mesh.patchPoints("panel"),
    )
    assert len(points) > 200
    assert np.all(panel.displacement[points] == 0)


def test_mesh_points_are_displaced_and_the_mesh_is_valid(panel):
    np.testing.assert_allclose(
        panel.points("1"),
        panel.mesh.points + panel.displacement,
        rtol=0, atol=1e-15,
    )
    assert "Mesh OK." in panel.run("checkMesh", "-time", "1")


def test_both_sides_move_alike_in_their_plane(panel):
    inPlane = {}
    for x, d in zip(np.round(panel.mesh.points, 9), panel.displacement):
        inPlane.setdefault((x[0], x[1]), []).append(d)
    for front, back in inPlane.values():
        assert np.all(front == back)
    assert np.all(panel.displacement[:, 2] == 0)


def expected(mesh, fixedPatches, area=False, **exponents):
    """Direct sums at all points that neither move nor are fixed.

    Both sides of a two-dimensional mesh count twice above and below the
    fraction's line, so all points may be summed in the plane."""
    moving = mesh.patchPoints("panel")
    fixed = np.setdiff1d(mesh.patchPoints(*fixedPatches), moving)
    targets = np.setdiff1d(
        np.arange(len(mesh.points)), np.concatenate([moving, fixed])
    )
    position = mesh.points.copy()
    if "front" not in fixedPatches:
        position[:, 2] = 0
    mass = {}
    if area:
        mass["movingMass"] = mesh.areas("panel")[moving]
        mass["fixedMass"] = mesh.areas(*fixedPatches)[fixed]
    return targets, inverseDistance(
        position[targets], position[moving], prescribed(position[moving]),
        position[fixed], **exponents, **mass,
    )


@pytest.mark.parametrize("tolerance, bound", [(0, 1e-13), (1e-2, 1e-2)])
@pytest.mark.parametrize("sides", ["empty", "patch"])
@pytest.mark.parametrize("coeffs", [
    {}, {"e1": 2, "e2": 3.5}, {"weights": "area"},
])
def test_points_follow_the_weighted_sum(
    tmp_path, sides, coeffs, tolerance, bound
):
    case = panelCase(tmp_path / "case", sides)
    for keyword, value in coeffs.items():
        setCoeff(case, keyword, value)
    setCoeff(case, "tolerance", tolerance)
    displacement = moved(case)

    patches = ["floor", "walls"]
    if sides == "patch":
        patches += ["front", "back"]
    exponents = {k: v for k, v in coeffs.items() if k != "weights"}
    targets, values = expected(
        BoundaryMesh(case), patches, area="weights" in coeffs, **exponents
    )
    error = np.linalg.norm(displacement[targets] - values, axis=1)
    assert error.max() <= bound*np.linalg.norm(AMPLITUDE)


def test_patches_that_are_neither_moving_nor_fixed_follow(tmp_path):
    case = panelCase(tmp_path / "case")
    setCoeff(case, "fixedPatches", "(floor)")
    setCoeff(case, "tolerance", 0)
    case.set(
        f"0/{FIELD}", "boundaryField/walls", "{ type calculated; }"
    )
    displacement = moved(case)
    targets, values = expected(BoundaryMesh(case), ["floor"])
    np.testing.assert_allclose(
        displacement[targets], values, rtol=0, atol=1e-14
    )


def test_points_of_moving_and_fixed_patches_move(panel):
    foot = np.intersect1d(
        panel.mesh.patchPoints("panel"), panel.mesh.patchPoints("floor")
    )
    assert len(foot) == 4
    np.testing.assert_allclose(
        panel.displacement[foot], np.cos(1.5)*np.tile(AMPLITUDE, (4, 1)),
        rtol=0, atol=1e-16,
    )


INNER, OUTER = 0.05, 0.15


def fading(case):
    setCoeff(case, "innerDistance", INNER)
    setCoeff(case, "outerDistance", OUTER)
    return case


def test_displacements_fade_and_far_points_rest(panel, tmp_path):
    case = fading(panelCase(tmp_path / "case"))
    displacement = moved(case)
    flat = panel.mesh.points[:, :2]
    moving = flat[panel.mesh.patchPoints("panel")]
    distance = np.array([
        np.hypot(*(moving - x).T).min() for x in flat
    ])
    s = np.clip((distance - INNER) / (OUTER - INNER), 0, 1)
    scale = (1 + np.cos(np.pi*s)) / 2
    np.testing.assert_allclose(
        displacement, scale[:, None]*panel.displacement, rtol=0, atol=1e-15
    )
    far = distance > OUTER
    assert 0.2 < far.mean() < 0.9
    assert np.all(displacement[far] == 0)
    near = distance < INNER
    assert np.all(displacement[near] == panel.displacement[near])
    assert "where the mesh is at rest" in case.log


@pytest.mark.parametrize("inner, outer, message", [
    (0.2, 0.1, "outerDistance is 0.1"), (-1, 0.1, "innerDistance is -1"),
    (0.1, None, "innerDistance without outerDistance"),
])
def test_fading_distances_are_checked(tmp_path, inner, outer, message):
    case = panelCase(tmp_path / "case")
    setCoeff(case, "innerDistance", inner)
    if outer is not None:
        setCoeff(case, "outerDistance", outer)
    case.run("blockMesh")
    log = case.run("moveDynamicMesh", check=False)
    assert case.exitCode != 0
    assert message in log


def slipCase(folder):
    """Walls (two sides and a ceiling, one patch) along which points slide."""
    case = panelCase(folder)
    case.set(f"0/{FIELD}", "boundaryField/walls", "{ type slip; }")
    return case


def wallsOf(mesh, left, right, top):
    """Labels of the points on the walls, by the direction of the normal."""
    points = mesh.patchPoints("walls")
    x, y = mesh.points[points, 0], mesh.points[points, 1]
    return (points[np.isclose(x, left) | np.isclose(x, right)],
            points[np.isclose(y, top)])


def test_points_slide_along_walls(tmp_path):
    case = slipCase(tmp_path / "case")
    setCoeff(case, "tolerance", 0)
    displacement = moved(case)
    mesh = BoundaryMesh(case)
    sides, ceiling = wallsOf(mesh, -0.5, 0.5, 0.6)
    floor = mesh.patchPoints("floor")

    assert len(ceiling) > 60
    assert abs(displacement[sides, 0]).max() < 1e-16
    assert abs(displacement[ceiling, 1]).max() < 1e-16
    assert abs(displacement[ceiling, 0]).max() > 0.001
    between = np.setdiff1d(sides, np.concatenate([ceiling, floor]))
    assert abs(displacement[between, 1]).min() > 0
    assert "Mesh OK." in case.run("checkMesh", "-time", "1")

    # The sides have one normal; a plane's points on the floor are fixed
    moving = mesh.patchPoints("panel")
    fixed = np.setdiff1d(floor, moving)
    targets = np.setdiff1d(
        np.arange(len(mesh.points)), np.concatenate([moving, floor])
    )
    flat = mesh.points*[1, 1, 0]
    values = slidingDistance(
        flat[targets], flat[moving], prescribed(flat[moving]), flat[fixed],
        [([1, 0, 0], flat[np.setdiff1d(sides, floor)]),
         ([0, 1, 0], flat[ceiling])],
    )
    np.testing.assert_allclose(
        displacement[targets], values, rtol=0, atol=1e-10
    )


def test_points_slide_along_an_oblique_wall(tmp_path):
    """The room turned by 30 degrees: the same motion, turned."""
    displacement = {}
    c, s = np.cos(np.radians(30)), np.sin(np.radians(30))
    turn = np.array([[c, -s, 0], [s, c, 0], [0, 0, 1]])
    for angle in (0, 30):
        case = slipCase(tmp_path / str(angle))
        setCoeff(case, "tolerance", 0)
        case.set(f"0/{FIELD}", "boundaryField/panel", """{
            type uniformFixedValue; value uniform (0 0 0);
            uniformValue ("""
            + " ".join(map(str, (turn if angle else np.eye(3)) @ [.01, .005, 0]))
            + "); }")
        case.run("blockMesh")
        case.run("transformPoints", "-rotate-angle", f"((0 0 1) {angle})")
        case.run("moveDynamicMesh")
        displacement[angle] = case.pointField(FIELD, "1")
    np.testing.assert_allclose(
        displacement[30], displacement[0] @ turn.T, rtol=0, atol=1e-8
    )


def test_curved_walls_cannot_slide(tmp_path):
    case = slipCase(tmp_path / "case")
    case.set("system/blockMeshDict", "edges", "(arc 9 10 (-0.3 0.7 0)"
             " arc 21 22 (-0.3 0.7 0.1) arc 8 9 (-0.4 0.7 0)"
             " arc 20 21 (-0.4 0.7 0.1))")
    case.run("blockMesh")
    log = case.run("moveDynamicMesh", check=False)
    assert case.exitCode != 0
    assert "faces of patch walls have more than" in log
    assert "fixedValue" in log


def test_symmetry_planes_hold_their_points(tmp_path):
    case = panelCase(tmp_path / "case", "symmetryPlane")
    case.set(
        f"0/{FIELD}", "boundaryField/panel/amplitude", "(0.008 -0.002 0.001)"
    )
    displacement = moved(case)
    mesh = BoundaryMesh(case)
    points = np.setdiff1d(
        mesh.patchPoints("front", "back"), mesh.patchPoints("panel")
    )
    assert abs(displacement[points, 2]).max() < 1e-18
    np.testing.assert_array_equal(
        case.points("1")[points, 2], mesh.points[points, 2]
    )
    inside = np.setdiff1d(
        np.arange(len(mesh.points)), mesh.patchPoints(*mesh.patches)
    )
    assert np.all(displacement[inside, 2] > 0)


@pytest.mark.parametrize("sides, parts, coeffs", [
    ("empty", "2 1 1", {}),
    ("empty", "1 2 1", {"weights": "area"}),
    ("patch", "1 2 1", {"e1": 3}),
    ("patch", "1 1 2", {"weights": "area"}),
    ("symmetryPlane", "1 1 2", {}),
    ("slip", "2 1 1", {"innerDistance": 0.05, "outerDistance": 0.15}),
    ("slip", "2 1 1", {}),
    ("slip", "1 2 1", {"weights": "area"}),
])
def test_two_processes_move_the_mesh_as_one_does(
    tmp_path, sides, parts, coeffs
):
    displacement = []
    for name in ("one", "two"):
        case = (slipCase(tmp_path / name) if sides == "slip"
                else panelCase(tmp_path / name, sides))
        for keyword, value in coeffs.items():
            setCoeff(case, keyword, value)
        displacement.append(
            moved(case) if name == "one" else movedInParallel(case, parts)
        )
    np.testing.assert_allclose(*displacement, rtol=0, atol=1e-14)


def test_wedge_keeps_its_planes(tmp_path):
    case = FoamCase(CASES / "wedge", tmp_path / "wedge")
    setCoeff(case, "tolerance", 0)
    displacement = moved(case)
    mesh = BoundaryMesh(case)
    inPlane = np.column_stack([
        mesh.points[:, 0], np.hypot(mesh.points[:, 1], mesh.points[:, 2])
    ])

    # One node for the two points at equal axial and radial position
    nodes, pointOfNode = np.unique(
        np.round(inPlane, 9), axis=0, return_index=True
    )
    moving = np.isclose(nodes[:, 0], 0.4)
    fixed = ~moving & (
        np.isclose(nodes[:, 0], 0) | np.isclose(nodes[:, 1], 0.1)
    )
    wave = np.cos(10*mesh.points[pointOfNode, 1])
    given = np.column_stack([
        -0.01*wave, 0.004*wave*np.cos(np.radians(2.5))*(nodes[:, 1] > 0)
    ])
    values = np.where(moving[:, None], given, 0)
    others = ~moving & ~fixed
    values[others] = inverseDistance(
        nodes[others], nodes[moving], values[moving], nodes[fixed]
    )
    values[nodes[:, 1] == 0, 1] = 0
    radial = np.hypot(displacement[:, 1], displacement[:, 2])
    np.testing.assert_allclose(
        np.column_stack([displacement[:, 0], radial])[pointOfNode], values,
        rtol=0, atol=1e-12,
    )

    points = case.points("1")
    np.testing.assert_allclose(
        abs(points[:, 2]), np.tan(np.radians(2.5))*points[:, 1],
        rtol=0, atol=1e-14,
    )


@pytest.mark.parametrize("processes", [1, 2])
def test_tubeOfAWedgeSlides(tmp_path, processes):
    """A wall of constant radius is a plane of the scene (axial, radial)."""
    case = FoamCase(CASES / "wedge", tmp_path / "wedge")
    case.set(f"0/{FIELD}", "boundaryField", """{
        panel { type waveDisplacement; amplitude (-0.01 0 0); omega 0;
            waveNumber (0 0 0); value uniform (0 0 0); }
        inlet { type fixedValue; value uniform (0 0 0); }
        tube { type slip; }
        "(front|back)" { type wedge; }
        axis { type empty; }
    }""")
    if processes == 1:
        moved(case)
    else:
        movedInParallel(case, "2 1 1")
    assert "0 sliding" not in case.log
    points, now = case.points(), case.pointField(FIELD, "1")
    radius = np.hypot(points[:, 1], points[:, 2])
    tube = np.isclose(radius, 0.1)
    inside = tube & (points[:, 0] > 0.01) & (points[:, 0] < 0.39)
    after = points + now
    np.testing.assert_allclose(
        np.hypot(after[tube, 1], after[tube, 2]), radius[tube],
        rtol=0, atol=1e-16)
    assert np.all(now[inside, 0] < 0)

    # The motion of the panel is axial: without walls that hold, so is all
    assert abs(now[:, 1:]).max() < 1e-16


def coeff(keyword, value):
    return lambda case: setCoeff(case, keyword, value)


def patchField(patch, value):
    return lambda case: case.set(
        f"0/{FIELD}", f"boundaryField/{patch}", value
    )


def withoutMovingPatches(case):
    case.run(
        "foamDictionary", DICT, "-entry", f"{COEFFS}/movingPatches", "-remove"
    )


def fixedSlip(case):
    case.set(f"0/{FIELD}", "boundaryField/floor", "{ type slip; }")
    setCoeff(case, "fixedPatches", "(floor walls)")


@pytest.mark.parametrize("spoil, wanted", [
    (coeff("movingPatches", "(pannel)"), [
        "Unknown patch pannel in movingPatches", "panel", "walls",
    ]),
    (coeff("fixedPatches", "(flor)"), ["Unknown patch flor in fixedPatches"]),
    (coeff("fixedPatches", "(panel floor)"), [
        "Patch panel is in movingPatches and in fixedPatches",
    ]),
    (coeff("movingPatches", "(front)"), ["Patch front is of type empty"]),
    (withoutMovingPatches, ["'movingPatches' not found"]),
    (coeff("movingPatch", "(panel)"), [
        "Unknown keyword movingPatch", "tolerance",
    ]),
    (coeff("e1", 0), ["e1 is 0", "exponents above 0"]),
    (coeff("e2", -1), ["e2 is -1", "exponents above 0"]),
    (coeff("tolerance", 2), ["tolerance is 2", "0.5"]),
    (coeff("referenceLength", 0), ["referenceLength is 0"]),
    (coeff("weights", "mass"), ["Unknown weights mass", "uniform area"]),
    (coeff("fixedPatches", "(floor)"), [
        "on patch walls, which is neither moving nor fixed",
    ]),
    (patchField("panel", "{ type calculated; }"), [
        "type calculated on the moving patch panel",
    ]),
    (fixedSlip, ["type slip on the fixed patch floor", "slide"]),
    (patchField("panel", "{ type slip; }"), [
        "type slip on the moving patch panel",
    ]),
    (patchField("floor", "{ type fixedValue; value uniform (1 0 0); }"), [
        "not zero on the fixed patch floor", "movingPatches",
    ]),
    (lambda case: case.set(DICT, "cellZone", "some"), ["cellZone"]),
])
def test_mistakes_stop_with_what_to_change(tmp_path, spoil, wanted):
    case = panelCase(tmp_path / "case")
    case.run("blockMesh")
    spoil(case)
    log = case.run("moveDynamicMesh", check=False)
    assert case.exitCode not in (0, None)
    assert "FOAM FATAL" in log
    if "cellZone" not in wanted:
        assert "dynamicMeshDict" in log
    for text in wanted:
        assert text in log
