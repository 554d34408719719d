"""FoamCase on a box of 2 x 1 x 1 cells."""
import pytest

from foamCase import FoamCase, RunFailed

FILES = {
    "system/controlDict": "application none; startFrom startTime;"
    " startTime 0; stopAt endTime; endTime 1; deltaT 1;"
    " writeControl timeStep; writeInterval 1;",
    "system/fvSchemes": "ddtSchemes {} gradSchemes {} divSchemes {}"
    " laplacianSchemes {}",
    "system/fvSolution": "",
    "system/blockMeshDict": "length 2; nCells (2 1 1); vertices ((0 0 0)"
    " ($length 0 0) ($length 1 0) (0 1 0) (0 0 1) ($length 0 1)"
    " ($length 1 1) (0 1 1)); blocks (hex (0 1 2 3 4 5 6 7) $nCells"
    " simpleGrading (1 1 1)); boundary ();",
    "system/decomposeParDict": "numberOfSubdomains 2; method simple;"
    " simpleCoeffs { n (2 1 1); delta 0.001; }",
    "0.orig/p": "dimensions [1 -1 -2 0 0 0 0]; internalField uniform 1e5;"
    " boundaryField { defaultFaces { type zeroGradient; } }",
}


@pytest.fixture
def box(tmp_path):
    source = tmp_path / "source"
    for name, text in FILES.items():
        path = source / name
        path.parent.mkdir(parents=True, exist_ok=True)
        kind = "pointScalarField" if path.name == "p" else "dictionary"
        path.write_text(
            "FoamFile { version 2.0; format ascii; class %s; object %s; }\n%s\n"
            % (kind, path.name, text)
        )
    (source / "0.5").mkdir()
    (source / "log.blockMesh").touch()
    (source / "constant").mkdir()
    return FoamCase(source, tmp_path / "box")


def test_copy_leaves_results_behind(box):
    assert box.times() == ["0"]
    assert not (box.path / "log.blockMesh").exists()


def test_mesh_field_and_dictionary(box):
    box.set("system/blockMeshDict", "length", "4")
    assert box.get("system/blockMeshDict", "length") == "4"
    assert "$length" in (box.path / "system/blockMeshDict").read_text()

    text = box.run("blockMesh")
    assert "nCells: 2" in text
    points = box.points()
    assert points.shape == (12, 3) and points[:, 0].max() == 4
    assert box.pointField("p", 0).tolist() == [1e5] * 12


def test_sub_dictionary(box):
    box.set("system/decomposeParDict", "simpleCoeffs/delta", "0.01")
    file = "system/decomposeParDict"
    assert box.get(file, "simpleCoeffs/delta") == "0.01"


def test_parallel(box):
    box.run("blockMesh")
    box.run("decomposePar", "-time", "none")
    text = box.runParallel(2, "checkMesh")
    assert "nProcs : 2" in text and "cells:            2" in text


def test_failure_shows_the_end_of_the_log(box):
    (box.path / "system/blockMeshDict").unlink()
    with pytest.raises(RunFailed, match="FOAM FATAL"):
        box.run("blockMesh")


def test_failure_can_be_asked_for(box):
    (box.path / "system/blockMeshDict").unlink()
    assert "FOAM FATAL" in box.run("blockMesh", check=False)
    assert box.exitCode != 0


def test_missing_program(box):
    with pytest.raises(RunFailed, match="no such program"):
        box.run("noSuchFoam")


def test_timeout(box):
    with pytest.raises(RunFailed, match="not finished after 0.1 s"):
        box.run("sleep", "5", timeout=0.1)
