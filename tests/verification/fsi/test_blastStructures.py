"""The tutorials blastPlate and blastCylinder on coarse meshes for a short time: the
charge's mass and energy go from the line into space, the structure takes up what the
gas gives, and the shell alone under Kingery-Bulmash's load moves alike."""
import re
import shutil

import numpy as np
import pytest

from foamCase import FoamCase
from foamEnvironment import PROJECT

TUTORIALS = PROJECT / "tutorials"
EXACT = 1e-10

# The tutorials' air. source: OpenFOAM v1912, constant::thermodynamic::RR
R = 8314.47006650545 / 28.97028
GAMMA = 1004.5 / (1004.5 - R)


class BlastCase(FoamCase):
    """What Allrun does, cells `coarser` times as large."""

    def __init__(self, name, folder, coarser, endTime, baffle=False):
        super().__init__(TUTORIALS / "fsi" / name, folder)
        self.line = self.path / "line"
        free = TUTORIALS / "gas" / "freeAirBlast"
        for part, copy in (("0.orig", "0"), ("constant", "constant"),
                           ("system", "system")):
            shutil.copytree(free / part, self.line / copy)
        for file in ("stageDict", "setPointFieldsDict"):
            (self.line / file).replace(self.line / "system" / file)
        (self.path / "system/options").write_text(
            f"endTime {endTime};\n" + ("middle 0;\n" if baffle else ""))
        self.set("system/controlDict", "writeInterval", endTime)
        self.set("system/controlDict", "writePrecision", 16)
        cells = self.path / "system/cells"
        cells.write_text(re.sub(
            r"^(n\w+ +)(\d+);",
            lambda m: f"{m.group(1)}{max(2, int(m.group(2)) // coarser)};",
            cells.read_text(), flags=re.M))
        for program in ("blockMesh", "setPointFields", "shockShellFoam"):
            self.run(program, "-case", "line")
        if baffle:
            path = self.path / "system"
            (path / "blockMeshDict.baffle").replace(path / "blockMeshDict")
        self.run("blockMesh")
        if baffle:
            self.run("createBaffles", "-overwrite")
            self.run("mergeOrSplitBaffles", "-split", "-overwrite")
            # createBaffles has written fields of its own
            shutil.rmtree(self.path / "0")
            shutil.copytree(self.path / "0.orig", self.path / "0")
        self.run("blockShell")
        self.states = self.run("setPointFields")

    def alone(self, endTime):
        """The shell alone until then; its probes' table."""
        folder = self.path / "alone"
        (folder / "constant").mkdir(parents=True)
        (folder / "system").mkdir()
        shutil.copytree(self.path / "constant/shell",
                        folder / "constant/shell")
        for source, copy in (
                ("constant/shellProperties.alone", "constant/shellProperties"),
                ("system/controlDict.alone", "system/controlDict"),
                ("system/parameters", "system/parameters"),
                ("system/endParameters", "system/endParameters"),
                ("system/fvSchemes", "system/fvSchemes"),
                ("system/fvSolution", "system/fvSolution")):
            shutil.copy(self.path / source, folder / copy)
        (folder / "system/options").write_text(f"endAlone {endTime};\n")
        self.log = self.run("positionalShellFoam", "-case", "alone")
        return folder

    def scene(self):
        """Mass and energy before and after the mapping."""
        words = re.search(
            r"scene: mass (\S+) -> (\S+) kg, energy (\S+) -> (\S+) J",
            self.states)
        return [float(word) for word in words.groups()]


def probes(folder, name, file="displacement.dat"):
    table, = (folder / "postProcessing" / name).glob(f"*/{file}")
    return np.loadtxt(table, ndmin=2)


def lineContent(line):
    """Radius of the end, mass and energy of the whole ball, by the exact integrals of
    the line's shape functions; mass and energy per volume at its end."""
    time = line.times()[-1]
    x = line.points()
    r = np.linalg.norm(x, axis=1)
    _, place = np.unique(r.round(9), return_index=True)
    p, T, U = (line.pointField(name, time)[place] for name in "pTU")
    rho = p / (R * T)
    energy = p / (GAMMA - 1) + 0.5 * rho * (U**2).sum(axis=1)
    r = r[place]
    a, b = r[:-1], r[1:]
    content = np.zeros(2)
    # Three Gauss points are exact
    for xi, w in ((-np.sqrt(0.6), 5 / 18), (0, 8 / 18), (np.sqrt(0.6), 5 / 18)):
        t = (1 + xi) / 2
        part = 4 * np.pi * w * (b - a) * ((1 - t) * a + t * b)**2
        for i, f in enumerate((rho, energy)):
            content[i] += (part * ((1 - t) * f[:-1] + t * f[1:])).sum()
    return r[-1], content, np.array([rho[-1], energy[-1]])


def expectMapped(case, charge, part):
    """The scene gains mass and energy of the line less those of the still air that
    they replace; and that is what the charge has released."""
    m0, m1, e0, e1 = case.scene()
    line = FoamCase.__new__(FoamCase)
    line.path = case.line
    end, content, air = lineContent(line)
    gain = part * (content - 4 / 3 * np.pi * end**3 * air)
    assert abs(m0 + gain[0] - m1) < EXACT * m1
    assert abs(e0 + gain[1] - e1) < EXACT * e1
    # The line's digits, and its air's
    assert (e1 - e0) / (part * charge * 4.52e6) == pytest.approx(1, rel=1e-6)


@pytest.mark.parametrize("scene", ["wall", "baffle"])
def test_plate(tmp_path, scene):
    baffle = scene == "baffle"
    case = BlastCase("blastPlate", tmp_path / "case", 2, 1.6e-3, baffle)
    expectMapped(case, 1.0, 0.25)
    log = case.run("shockShellFoam")
    moved = probes(case.path, "plate")
    assert moved[-1, 1]  > 1e-3              # away from the charge
    assert "\nEnd" in log

    folder = case.alone(3e-3)
    alone = probes(folder, "plate")
    assert "scaled distance" in case.log
    # The tables' impulse is a fifth larger
    ratio = moved[-1, 1] / np.interp(3e-3, alone[:, 0], alone[:, 1])
    assert 0.5 < ratio < 1.05, ratio


def test_cylinder(tmp_path):
    case = BlastCase("blastCylinder", tmp_path / "case", 2, 1.3e-3)
    expectMapped(case, 0.1, 0.25)
    case.run("shockShellFoam")
    front = probes(case.path, "tube")
    assert front[-1, 1] > 5e-5
    alone = probes(case.alone(1.86e-3), "tube")
    ratio = front[-1, 1] / np.interp(1.86e-3, alone[:, 0], alone[:, 1])
    assert 0.5 < ratio < 1.3, ratio
