"""Allwmake, Allclean and RunFunctions on a small project of the same layout."""
import shutil

import pytest

from foamEnvironment import environment
from smallProject import SmallProject, lastLine

NOTHING = "shockShellFoam: nothing to do: everything is up to date\n"


@pytest.fixture
def project(tmp_path):
    return SmallProject(tmp_path / "small")


@pytest.fixture
def built(project):
    done = project.run("Allwmake")
    assert done.returncode == 0, done.stdout + done.stderr
    return project


def test_build_repeat_and_clean(project):
    before = project.files()
    done = project.run("Allwmake")
    assert done.returncode == 0, done.stdout + done.stderr
    options = environment()["WM_OPTIONS"]
    program = project.path / "platforms" / options / "bin" / "smallFoam"
    assert lastLine(done).startswith("shockShellFoam: built in ")
    assert program.exists()

    again = project.run("Allwmake")
    assert (again.returncode, again.stdout, again.stderr) == (0, "", NOTHING)
    quiet = project.run("Allwmake", "-quiet")
    assert (quiet.returncode, quiet.stdout, quiet.stderr) == (0, "", "")

    assert project.run("Allclean").returncode == 0
    assert project.files() == before


@pytest.mark.parametrize("arguments", [[], ["-quiet"]])
def test_compile_error(built, arguments):
    library = built.libraries[-1]
    built.write(f"src/{library}/{library}.cpp", "int broken = ;\n")
    done = built.run("Allwmake", *arguments)
    assert done.returncode == 1
    assert f"error: src/{library} did not build" in lastLine(done)
    assert "expected primary-expression" in done.stdout + done.stderr


def test_link_error(built):
    built.write(
        "applications/solvers/smallFoam/smallFoam.cpp",
        "int absent();\nint main() { return absent(); }\n",
    )
    done = built.run("Allwmake")
    assert done.returncode == 1
    assert "applications/solvers/smallFoam did not build" in lastLine(done)


def test_missing_library(built):
    library = built.libraries[0]
    shutil.rmtree(built.path / "src" / library)
    done = built.run("Allwmake")
    assert done.returncode == 1
    assert f"missing: src/{library}/Make/files" in lastLine(done)


def test_renamed_header(built):
    used = built.libraries[0]
    folder = built.path / "src" / used
    (folder / f"{used}.hpp").rename(folder / "renamed.hpp")
    program = "applications/solvers/smallFoam/smallFoam.cpp"
    text = (built.path / program).read_text()
    built.write(program, text.replace(f"{used}.hpp", "renamed.hpp"))
    done = built.run("Allwmake")
    assert done.returncode == 0, done.stdout + done.stderr
    assert built.run("Allwmake").stderr == NOTHING


def test_changed_header_rebuilds_what_includes_it(built):
    used = built.libraries[0]
    built.write(f"src/{used}/{used}.hpp", "#error changed\n")
    done = built.run("Allwmake")
    assert done.returncode == 1
    assert "smallFoam did not build" in lastLine(done)


def test_source_taken_out_leaves_the_library(built):
    used = built.libraries[0]
    folder = f"src/{used}"
    target = f"\nLIB = $(SHOCKSHELL_LIBBIN)/lib{used}\n"
    built.write(f"{folder}/other.cpp", "int other() { return 0; }\n")
    built.write(f"{folder}/Make/files", f"{used}.cpp\nother.cpp\n{target}")
    assert built.run("Allwmake").returncode == 0

    built.write(f"{folder}/Make/files", f"other.cpp\n{target}")
    done = built.run("Allwmake")
    assert done.returncode == 0, done.stdout + done.stderr
    (built.path / "applications/solvers/smallFoam/smallFoam.cpp").touch()
    done = built.run("Allwmake")
    assert done.returncode == 1
    assert "smallFoam did not build" in lastLine(done)


def test_copy_of_a_built_project_builds_anew(built, tmp_path):
    copy = tmp_path / "copy"
    shutil.copytree(built.path, copy, symlinks=True)
    done = built.run("../copy/Allwmake")
    assert done.returncode == 0, done.stdout + done.stderr
    assert "building anew" in done.stderr
    assert built.run("../copy/Allwmake").stderr == NOTHING


def test_unknown_argument(project):
    for script in ("Allwmake", "Allclean"):
        done = project.run(script, "-fast")
        assert done.returncode == 1
        assert "'-fast'" in lastLine(done)


ALLRUN = """#!/bin/bash
cd "${0%/*}" || exit 1
. "${SHOCKSHELL_DIR:-../../..}/etc/RunFunctions" || exit 1
touch started
"""


@pytest.fixture
def allrun(built):
    def make(text):
        built.write("tutorials/family/case/Allrun", ALLRUN + text)
        (built.path / "tutorials/family/case/Allrun").chmod(0o755)
        return built.run("tutorials/family/case/Allrun")

    return make


def test_allrun_stops_at_the_failing_application(allrun, built):
    done = allrun("runApplication smallFoam\nrunApplication cat nothing\n"
                  "touch reached\n")
    case = built.path / "tutorials/family/case"
    assert done.returncode == 1
    assert "cat nothing failed (exit code 1), see" in lastLine(done)
    assert "nothing: No such file" in done.stderr
    assert (case / "log.smallFoam").exists()
    assert (case / "log.cat.failed").exists()
    assert not (case / "log.cat").exists() and not (case / "reached").exists()


def test_allrun_stops_at_the_failing_plot(allrun):
    done = allrun("echo 'raise SystemExit(3)' > plot.py\nrunPlot plot.py\n")
    assert done.returncode == 1
    assert "plot.py failed (exit code 3)" in lastLine(done)


def test_allrun_stops_at_the_failing_build(allrun, built):
    library = built.libraries[0]
    built.write(f"src/{library}/{library}.cpp", "int broken = ;\n")
    done = allrun("")
    assert done.returncode == 1
    assert f"src/{library} did not build" in lastLine(done)
    assert not (built.path / "tutorials/family/case/started").exists()
