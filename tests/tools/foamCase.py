"""An OpenFOAM case in a folder of its own, for verification tests.

    def test_something(tmp_path):
        case = FoamCase(CASES / "tube", tmp_path / "tube")
        case.set("system/controlDict", "maxCo", "0.5")
        case.run("blockMesh")
        case.run("shockShellFoam")
        p = case.pointField("p", case.times()[-1])

A program that fails, or takes longer than its timeout, fails the test with the
end of its log in the message.
"""
import re
import shutil
import subprocess
from pathlib import Path

from foamEnvironment import environment
from foamFile import readHistory, readInternalField, readList

TIME = re.compile(r"\d+(\.\d+)?(e[-+]?\d+)?$")
TAIL = 40


class RunFailed(AssertionError):
    """A program ended with an exit code other than 0, or did not end."""


def isResult(name):
    """Is this file or folder of a case made by a run? 0 and 0.orig are not."""
    return (
        (TIME.match(name) is not None and name != "0")
        or name.startswith(("log.", "processor"))
        or name in ("postProcessing", "VTK", "dynamicCode", "polyMesh")
    )


class FoamCase:
    """A copy of a case without results; 0.orig is copied to 0."""

    def __init__(self, source, folder, keepMesh=False):
        """source: case to copy; folder: where to, must not exist.

        keepMesh: copy constant/polyMesh too (tracked meshes).
        """
        self.path = Path(folder).resolve()

        def ignored(_, names):
            return [
                n for n in names
                if isResult(n) and not (keepMesh and n == "polyMesh")
            ]

        shutil.copytree(source, self.path, ignore=ignored)
        if (self.path / "0.orig").is_dir():
            shutil.rmtree(self.path / "0", ignore_errors=True)
            shutil.copytree(self.path / "0.orig", self.path / "0")

    # Running

    def run(self, *command, log=None, timeout=600, check=True):
        """Run a program in the case; its output, also in log.<program>.

        check: raise RunFailed when the exit code is not 0; otherwise the exit
        code is left in self.exitCode for the test to look at.
        """
        words = [str(word) for word in command]
        log = self.path / (log or f"log.{Path(words[0]).name}")
        with open(log, "w") as stream:
            try:
                self.exitCode = subprocess.run(
                    words,
                    cwd=self.path,
                    env={**environment(), "PWD": str(self.path)},
                    stdin=subprocess.DEVNULL,
                    stdout=stream,
                    stderr=subprocess.STDOUT,
                    timeout=timeout,
                ).returncode
                problem = f"exit code {self.exitCode}"
            except subprocess.TimeoutExpired:
                self.exitCode = None
                problem = f"not finished after {timeout} s"
            except FileNotFoundError:
                raise RunFailed(f"{words[0]}: no such program") from None
        text = log.read_text(errors="replace")
        if self.exitCode is None or (check and self.exitCode != 0):
            end = "\n".join(text.splitlines()[-TAIL:])
            raise RunFailed(f"{' '.join(words)}: {problem}\n{log}:\n{end}")
        return text

    def runParallel(self, processes, *command, **options):
        """As run, with mpirun and -parallel, on a decomposed case."""
        options.setdefault("log", f"log.{Path(str(command[0])).name}")
        return self.run(
            "mpirun", "--oversubscribe", "-np", processes,
            *command, "-parallel", **options,
        )

    # Dictionaries

    def set(self, file, entry, value):
        """Set an entry of a dictionary, sub-dictionaries as a/b/c.

        Directives and $variables elsewhere in the file stay as they are.
        """
        self.run(
            "foamDictionary", "-disableFunctionEntries", file,
            "-entry", entry, "-set", value, log="log.foamDictionary",
        )

    def get(self, file, entry):
        """Value of an entry of a dictionary, as text."""
        return self.run(
            "foamDictionary", file, "-entry", entry, "-value",
            log="log.foamDictionary",
        ).strip()

    # Results

    def times(self):
        """Names of the time folders, in the order of time."""
        names = [
            item.name for item in self.path.iterdir()
            if item.is_dir() and TIME.match(item.name)
        ]
        return sorted(names, key=float)

    def points(self, time="constant"):
        """Mesh points of a time (the original ones if it has none): (n, 3)."""
        moved = self.path / str(time) / "polyMesh" / "points"
        mesh = self.path / "constant" / "polyMesh" / "points"
        return readList(moved if moved.exists() else mesh, 3)

    def pointField(self, name, time):
        """A point field at a time: (n,) or (n, 3)."""
        path = self.path / str(time) / name
        return readInternalField(path, len(self.points()))

    def history(self, path):
        """(names, table) of a .dat file below postProcessing."""
        return readHistory(self.path / "postProcessing" / path)
