"""The project's own files, without what builds and runs leave behind."""
import os
import re
from pathlib import Path

PROJECT = Path(__file__).resolve().parents[2]

GENERATED = re.compile(
    r"(\.git|platforms|lnInclude|__pycache__|\.pytest_cache|postProcessing"
    r"|VTK|dynamicCode|processor\d+|polyMesh|linux\w+|darwin\w+"
    r"|\d+(\.\d+)?(e[-+]?\d+)?)$"
)

OPENFOAM = (".C", ".H")
PLAIN = (".cpp", ".hpp")


def projectFiles(*folders):
    """Paths of the files below these folders (default: all), sorted."""
    found = []
    for folder in folders or (".",):
        for place, inner, names in os.walk(PROJECT / folder):
            inner[:] = [i for i in inner if not GENERATED.match(i)]
            found += [
                Path(place) / name for name in names
                if not name.startswith("log.")
            ]
    return sorted(found)


def sources(*suffixes):
    """C++ files of libraries, applications and tests."""
    return [
        path for path in projectFiles("src", "applications", "tests")
        if path.suffix in (suffixes or OPENFOAM + PLAIN)
    ]


def isScript(path):
    """Is it a shell script, or sourced by one?"""
    if path.suffix == ".sh" or path.name in ("bashrc", "RunFunctions"):
        return True
    with open(path, "rb") as stream:
        return re.match(rb"#!.*sh\b", stream.readline()) is not None


def name(path):
    """Path as seen from the project, for messages."""
    return str(path.relative_to(PROJECT))
