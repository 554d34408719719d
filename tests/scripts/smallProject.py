"""A project of the same layout as this one that builds in a second."""
import re
import shutil
import subprocess

from foamEnvironment import PROJECT, environment

SCRIPTS = ("Allwmake", "Allclean", "src/Allwmake", "applications/Allwmake",
           "tests/Alltest", "tests/conftest.py")


class SmallProject:
    """Two libraries of one function each, and an application."""

    libraries = ["first", "second"]

    def __init__(self, path):
        self.path = path
        shutil.copytree(PROJECT / "etc", path / "etc")
        for script in SCRIPTS:
            (path / script).parent.mkdir(exist_ok=True)
            shutil.copy(PROJECT / script, path / script)

        text = (path / "src" / "Allwmake").read_text()
        listed = f"libraries=({' '.join(self.libraries)})"
        text = re.sub(r"libraries=\(.*?\)", listed, text, flags=re.S)
        self.write("src/Allwmake", text)

        for library in self.libraries:
            self.folder(f"src/{library}", f"int {library}() {{ return 0; }}\n",
                        f"LIB = $(SHOCKSHELL_LIBBIN)/lib{library}")
            self.write(f"src/{library}/{library}.hpp", f"int {library}();\n")
        used = self.libraries[0]
        self.folder(
            "applications/solvers/smallFoam",
            f'#include "{used}.hpp"\nint main() {{ return {used}(); }}\n',
            "EXE = $(SHOCKSHELL_APPBIN)/smallFoam",
            f"EXE_INC = -I$(SHOCKSHELL_SRC)/{used}/lnInclude\n"
            f"EXE_LIBS = -L$(SHOCKSHELL_LIBBIN) -l{used}\n",
        )

    def write(self, file, text):
        (self.path / file).parent.mkdir(parents=True, exist_ok=True)
        (self.path / file).write_text(text)

    def folder(self, name, source, target, options=""):
        """A folder that wmake builds, with one source."""
        file = name.split("/")[-1] + ".cpp"
        self.write(f"{name}/{file}", source)
        self.write(f"{name}/Make/files", f"{file}\n\n{target}\n")
        self.write(f"{name}/Make/options", options)

    def run(self, *command, folder="/"):
        """Run one of the project's scripts in another folder."""
        return subprocess.run(
            [str(self.path / command[0]), *command[1:]],
            cwd=folder,
            env={k: v for k, v in environment().items()
                 if not k.startswith("SHOCKSHELL")},
            stdout=subprocess.PIPE,
            stderr=subprocess.PIPE,
            universal_newlines=True,
        )

    def files(self):
        return {p for p in self.path.rglob("*") if p.name != "lock"}


def lastLine(done):
    """Last line that a finished script has printed on stderr."""
    return done.stderr.strip().split("\n")[-1]
