"""What tests/Alltest counts, on a small project with tests of every outcome."""
import pytest

from smallProject import SmallProject

# Stands for a GoogleTest program: writes the report and ends with the code
PROGRAM = """#include <cstdio>
#include <cstdlib>
#include <cstring>
int main(int argc, char** argv)
{
    for (int i = 1; i < argc; i++)
    {
        if (std::strncmp(argv[i], "--gtest_output=xml:", 19) || !%(tests)d)
            continue;
        std::FILE* file = std::fopen(argv[i] + 19, "w");
        std::fprintf(file, "<testsuites tests=\\"99\\">\\n");
        std::fprintf(file, "<testsuite name=\\"a\\" tests=\\"%(tests)d\\" "
            "failures=\\"%(failures)d\\" disabled=\\"0\\" "
            "skipped=\\"%(skipped)d\\" errors=\\"0\\">");
        std::fclose(file);
    }
    return %(code)d;
}
"""
CASES = """import pytest
def test_good(): pass
def test_bad(): assert False
@pytest.mark.long
def test_lasting(): pass
"""


@pytest.fixture
def project(tmp_path):
    return SmallProject(tmp_path / "small")


def unitTest(project, name, source=PROGRAM, tests=0, failures=0, skipped=0,
             code=0):
    values = {"tests": tests, "failures": failures, "skipped": skipped,
              "code": code}
    project.folder(f"tests/unit/{name}", source % values,
                   f"EXE = $(SHOCKSHELL_APPBIN)/tests/{name}")


def closing(done):
    return done.stdout.strip().split("\n")[-1]


def test_all_passed(project):
    unitTest(project, "good", tests=3)
    unitTest(project, "more", tests=2, skipped=1)
    done = project.run("tests/Alltest", "unit")
    assert closing(done) == "4 passed, 0 failed", done.stdout + done.stderr
    assert done.returncode == 0


@pytest.mark.parametrize(
    "counted, program",
    [
        ("4 passed, 1 failed", dict(tests=2, failures=1, code=1)),
        ("3 passed, 1 failed", dict(tests=0, code=134)),
        ("4 passed, 1 failed", dict(tests=2, code=134)),
        ("3 passed, 1 failed", dict(tests=0)),
        ("3 passed, 1 failed", dict(source="int broken = ;")),
    ],
    ids=["failure", "crash", "crash at the end", "no tests", "no build"],
)
def test_one_failed(project, counted, program):
    unitTest(project, "good", tests=3)
    unitTest(project, "bad", **program)
    done = project.run("tests/Alltest", "unit")
    assert closing(done) == counted, done.stdout + done.stderr
    assert done.returncode == 1


def test_nothing_tested(project):
    done = project.run("tests/Alltest", "unit")
    assert closing(done) == "0 passed, 0 failed"
    assert done.returncode == 1


def test_broken_build(project):
    unitTest(project, "good", tests=3)
    project.write("src/second/second.cpp", "int broken = ;\n")
    done = project.run("tests/Alltest", "unit")
    assert closing(done) == "0 passed, 1 failed"
    assert done.returncode == 1
    assert "src/second did not build" in done.stderr


def test_python_parts(project):
    project.write("tests/verification/test_cases.py", CASES)
    run = project.run
    done = run("tests/Alltest", "verification", "-k", "good")
    assert closing(done) == "1 passed, 0 failed" and done.returncode == 0
    done = run("tests/Alltest", "verification")
    assert closing(done) == "1 passed, 1 failed" and done.returncode == 1
    done = run("tests/Alltest", "verification", "-long")
    assert closing(done) == "2 passed, 1 failed" and done.returncode == 1
    done = run("tests/Alltest", "verification", "-k", "absent")
    assert closing(done) == "0 passed, 0 failed" and done.returncode == 1


def test_unknown_part(project):
    done = project.run("tests/Alltest", "units")
    assert done.returncode == 1
    assert "'units'; valid: unit" in done.stderr
