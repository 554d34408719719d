"""The rules that every file of the project keeps; see tests/README.md."""
import os
import re
import subprocess

import pytest

from projectFiles import (
    OPENFOAM, PLAIN, PROJECT, isScript, name, projectFiles, sources
)

LINES = 500
COLUMNS = {**dict.fromkeys(OPENFOAM, 80), **dict.fromkeys(PLAIN, 100)}
CODE = OPENFOAM + PLAIN + (".py", ".sh")

# What each library may use: dependencies point one way
USES = {
    "gasDynamics": set(),
    "dictionaryCheck": set(),
    "feMesh": {"gasDynamics"},
    "positionalShell": {"gasDynamics"},
    "initialStates": {"dictionaryCheck", "feMesh", "gasDynamics"},
    "taylorGalerkin": {"dictionaryCheck", "feMesh", "gasDynamics"},
    "shellModel": {"dictionaryCheck", "positionalShell", "gasDynamics"},
    "shellMeshing": {"shellModel", "positionalShell", "gasDynamics"},
    "meshMotion": {"dictionaryCheck", "feMesh", "gasDynamics"},
    "fluidShellCoupling": {
        "taylorGalerkin", "shellModel", "dictionaryCheck", "feMesh",
        "positionalShell", "meshMotion", "gasDynamics",
    },
    "functionObjects": {
        "fluidShellCoupling", "taylorGalerkin", "shellModel", "meshMotion",
        "dictionaryCheck", "feMesh", "positionalShell", "gasDynamics",
    },
}

UNFINISHED = re.compile(r"\b(TO" r"DO|FIX" r"ME|X" r"XX|place" r"holder)\b")
MACHINE = re.compile(r"(?<![\w.$}])/(home|root|work|mnt|Users)/")


def codeFiles():
    return [
        path for path in projectFiles()
        if path.suffix in CODE or isScript(path)
        or path.parent.name == "Make"
    ]


def text(path):
    return path.read_text(encoding="utf-8", errors="surrogateescape")


def offences(paths, check):
    """file:line of the lines for which check(path, line) is true."""
    return [
        f"{name(path)}:{number}"
        for path in paths
        for number, line in enumerate(text(path).split("\n"), 1)
        if check(path, line)
    ]


def test_code_is_ascii():
    assert not offences(codeFiles(), lambda path, line: not line.isascii())


def test_code_has_no_tabs():
    assert not offences(codeFiles(), lambda path, line: "\t" in line)


def test_lines_are_short():
    assert not offences(
        sources(), lambda path, line: len(line) > COLUMNS[path.suffix]
    )


def test_files_are_short():
    long = [name(p) for p in sources() if text(p).count("\n") > LINES]
    assert not long


def test_nothing_is_left_unfinished():
    assert not offences(
        codeFiles(), lambda path, line: UNFINISHED.search(line)
    )


def test_no_path_of_one_machine():
    binary = (".png", ".gz", ".vtu", ".msh")
    files = [path for path in projectFiles() if path.suffix not in binary]
    assert not offences(files, lambda path, line: MACHINE.search(line))


def test_dependencies_point_one_way():
    wrong = []
    mention = re.compile(
        r"\$\(SHOCKSHELL_SRC\)/(\w+)/lnInclude|#include [\"<](\w+)/"
    )
    for library, allowed in USES.items():
        for path in projectFiles(f"src/{library}"):
            for match in mention.finditer(text(path)):
                used = match.group(1) or match.group(2)
                if used in USES and used not in allowed | {library}:
                    wrong.append(f"{name(path)} uses {used}")
    assert not wrong


def test_every_library_is_built_in_an_order_that_works():
    script = text(PROJECT / "src" / "Allwmake")
    order = re.search(r"libraries=\((.*?)\)", script, re.S).group(1).split()
    folders = {p.name for p in (PROJECT / "src").iterdir() if p.is_dir()}
    assert set(order) == set(USES) == folders
    for place, library in enumerate(order):
        assert USES[library] <= set(order[:place]), library


@pytest.mark.parametrize("library", ["gasDynamics", "positionalShell"])
def test_library_is_free_of_openfoam(library):
    files = projectFiles(f"src/{library}")
    assert not [name(path) for path in files if path.suffix in OPENFOAM]
    assert not offences(
        files, lambda path, line: re.match(r'\s*#include\s*["<].*\.H[">]', line)
    )


def test_shell_scripts_are_valid():
    scripts = [path for path in projectFiles() if isScript(path)]
    assert len(scripts) > 10
    for path in scripts:
        subprocess.run(["bash", "-n", str(path)], check=True)


def test_scripts_are_executable():
    plain = [
        name(path) for path in projectFiles()
        if text(path).startswith("#!") and not os.access(path, os.X_OK)
    ]
    assert not plain


def test_tutorials_are_complete():
    cases = sorted((PROJECT / "tutorials").glob("*/*/"))
    wanted = ("Allrun", "Allclean", "README.md", "system/controlDict")
    # A study runs copies of other cases
    study = (*wanted[:3], "study.py")
    missing = [
        f"{name(case)}/{file}" for case in cases
        for file in (study if case.name.endswith("Study") else wanted)
        if case.is_dir() and not (case / file).exists()
    ]
    assert not missing
