r"""Processor time of the tutorial shockPanel50 with its default settings, and of
rhoCentralFoam on the same mesh at rest for the same duration.

    tests/benchmarks/shockPanel/run [-endTime <s>] [-quick] [-page <file>]

Three runs, one after the other: the tutorial (two-way), its gas alone with a
rigid panel, and rhoCentralFoam with the scheme of its tutorials (Kurganov,
vanLeer, Euler, Courant number 0.2) in the same tube with a rigid panel; its
inlet prescribes the state behind the shock.

    -endTime <s>  duration, the tutorial's by default
    -quick        a few steps, to try the script
    -page <file>  page with the section, default doc/performance.md
"""
import argparse
import re
import shutil
import sys
import tempfile
from pathlib import Path

HERE = Path(__file__).resolve().parent
PROJECT = HERE.parents[2]
sys.path[:0] = [str(PROJECT / "tests" / folder) for folder in (
    "tools", "verification/gasBenchmarks", "benchmarks/common")]

from foamCase import FoamCase  # noqa: E402
from machine import facts, load, need  # noqa: E402
from page import expectMarks, replaceBetween, table  # noqa: E402
from peerCase import DIMENSIONS, FV_SCHEMES, FV_SOLUTION  # noqa: E402
from runLog import RunLog  # noqa: E402
from scheme import PEER_MAX_CO  # noqa: E402

TUTORIAL = PROJECT / "tutorials" / "fsi" / "shockPanel50"
SECTION = "shockPanel"
HEADER = "FoamFile { version 2.0; format ascii; class %s; object %s; }\n"


def panelCase(folder, coupling, endTime):
    case = FoamCase(TUTORIAL, folder)
    if endTime:
        case.set("system/controlDict", "endTime", f"{endTime:g}")
    case.set("constant/couplingProperties", "coupling", coupling)
    if coupling == "none":
        (case.path / "constant" / "dynamicMeshDict").unlink()
        case.set("system/controlDict", "functions", "{}")
    else:
        case.run("blockMesh")
        case.run("blockShell")
        case.run("setPointFields")
        return case
    case.run("blockMesh")
    case.run("setPointFields")
    return case


def entry(file, pattern):
    return re.search(pattern, file.read_text()).group(1)


class Peer(FoamCase):
    """The tube for rhoCentralFoam: the panel's states and mesh."""

    def __init__(self, folder, ours):
        self.path = folder
        shutil.copytree(ours.path / "constant", folder / "constant")
        (folder / "0").mkdir()
        (folder / "system").mkdir()
        for name in ("dynamicMeshDict", "couplingProperties",
                     "shellProperties"):
            (folder / "constant" / name).unlink(missing_ok=True)
        self.writeDict("constant/turbulenceProperties",
                       "simulationType laminar;\n")
        self.writeDict("system/fvSchemes", FV_SCHEMES)
        self.writeDict("system/fvSolution", FV_SOLUTION)
        self.writeStates(ours)
        control = (ours.path / "system" / "controlDict").read_text()
        endTime = re.search(r"endTime\s+(\S+);", control).group(1)
        self.writeDict("system/controlDict", f"""
startFrom startTime; startTime 0; stopAt endTime; endTime {endTime};
deltaT {endTime}; adjustTimeStep yes; maxCo {PEER_MAX_CO}; maxDeltaT 1;
writeControl timeStep; writeInterval 1000000; timePrecision 10;
""")

    def writeDict(self, name, text, kind="dictionary"):
        (self.path / name).write_text(
            HEADER % (kind, Path(name).name) + text)

    def writeStates(self, ours):
        """The two states of the tutorial, from its own dictionary."""
        states = (ours.path / "system" / "setPointFieldsDict").read_text()
        values = {
            name: re.findall(rf"FieldValue {name} ([^\n]*)\n", states)
            for name in "pTU"
        }
        place = re.search(r"box (\([^)]*\) \([^)]*\));", states).group(1)
        for name, (kind, dimensions) in DIMENSIONS.items():
            still, behind = values[name]
            wall = "slip" if name == "U" else "zeroGradient"
            self.writeDict(f"0/{name}", f"""
dimensions {dimensions};
internalField uniform {still};
boundaryField
{{
    inlet {{ type fixedValue; value uniform {behind}; }}
    sides {{ type empty; }}
    ".*" {{ type {wall}; }}
}}
""", kind)
        self.writeDict("system/setFieldsDict", "regions ( boxToCell { box "
                       + place + "; fieldValues ( " + " ".join(
                           f"{kind}Value "
                           f"{name} {values[name][1]}"
                           for name, (kind, _) in DIMENSIONS.items())
                       + " ); } );\n")
        self.run("setFields")


def measured(endTime, folder):
    rows = []
    ours = panelCase(folder / "twoWay", "twoWay", endTime)
    alone = panelCase(folder / "alone", "none", endTime)
    peer = Peer(folder / "peer", alone)
    nodes = None
    for label, case, program in (
        ("shockShellFoam, two-way", ours, "shockShellFoam"),
        ("shockShellFoam, gas alone", alone, "shockShellFoam"),
        ("rhoCentralFoam, panel at rest", peer, "rhoCentralFoam"),
    ):
        log = case.run(program, timeout=3 * 3600)
        found = re.search(r"Gas: (\d+) nodes", log)
        nodes = nodes or int(found.group(1))
        seconds = float(re.findall(r"ExecutionTime = (\S+) s", log)[-1])
        gasSteps = sum(int(n) for n in re.findall(
            r"^Gas: (\d+) step", log, re.M)) or RunLog(log).steps
        rows.append((label, gasSteps, seconds))
    peerSeconds = rows[-1][2]
    return nodes, [(*row, row[2] / peerSeconds) for row in rows]


def main(words):
    parser = argparse.ArgumentParser(
        prog="run", usage=__doc__, allow_abbrev=False)
    parser.add_argument("-endTime", type=float)
    parser.add_argument("-quick", action="store_true")
    parser.add_argument("-page", type=Path,
                        default=PROJECT / "doc" / "performance.md")
    options = parser.parse_args(words)
    need("shockShellFoam", "rhoCentralFoam", "setFields")
    page = None if options.quick and "-page" not in words else options.page
    expectMarks(page, SECTION)

    conditions = f"{facts()}; load {load()} at the start."
    with tempfile.TemporaryDirectory() as folder:
        nodes, rows = measured(
            2e-5 if options.quick else options.endTime, Path(folder))
    text = "\n\n".join([
        f"{nodes} gas nodes; {conditions}",
        table(["run", "gas steps", "processor time [s]",
               "over rhoCentralFoam's"], rows),
    ])
    print(text)
    if page:
        replaceBetween(page, SECTION, text)
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
