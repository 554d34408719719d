"""A closed box of gas in two parts, with an elastic strip between them.

    case = FlexibleWall(folder, lambda x: np.where(x < 0, 1.2e5, 1e5))
    case.couple("twoWay", subCycles=4)
    case.runTo(2e-4, deltaT=1e-6)
    t, x, v = case.motion()

The strip is clamped at both ends; its two faces are walls of the gas, in front
(negative x) and behind. Every other wall is rigid, so that gas and strip keep
their mass and energy. A scene in the plane, plane strain.
"""
import re
from dataclasses import dataclass

import numpy as np

from foamCase import FoamCase
from platesInGas import CONTROL, DIMENSIONS, HEADER, THERMO

HEIGHT, DEPTH = 0.05, 1e-3

SHELL = """
mesh            shell;
sections
{{
    wall
    {{
        elementSet  all;
        thickness   {thickness:.17g};
        material
        {{
            type    SaintVenantKirchhoff;
            E       {E:.17g};
            nu      0.3;
            rho     {rho:.17g};
        }}
    }}
}}
constraints
{{
    low     {{ type clamped; nodeSet low; }}
    high    {{ type clamped; nodeSet high; }}
    strip   {{ type planeStrainStrip; direction (0 0 1); }}
}}
analysis        dynamic;
timeIntegrator  Newmark;
newton          {{ residualTolerance 1e-11; incrementTolerance 1e-11; }}
elementForm     displacement;
vtk             no;
"""
MESH_OF_SHELL = f"""
mesh        shell;
surface
{{
    type    plate;
    origin  (0 0 0);
    sideU   (0 {HEIGHT} 0);
    sideV   (0 0 {DEPTH});
}}
divisions   (6 1);
nodeSets    {{ low uMin; high uMax; }}
"""
FUNCTIONS = """functions
{
    gas
    {
        type    conservation;
        libs    (shockShellFunctionObjects);
    }
    strip
    {
        type    shellEnergyTable;
        libs    (shockShellFunctionObjects);
    }
    wall
    {
        type    shellProbes;
        libs    (shockShellFunctionObjects);
        points  ((0 %g %g));
        fields  (displacement velocity);
    }
}
""" % (HEIGHT / 2, DEPTH / 2)


@dataclass(frozen=True)
class Strip:
    """Aluminium, half a millimetre thick."""
    thickness: float = 5e-4     # m
    E: float = 70e9             # Pa
    rho: float = 2700           # kg/m3


class FlexibleWall(FoamCase):

    def __init__(self, folder, pressure, strip=Strip(), length=0.1,
                 cells=(40, 10), T=300.0):
        """pressure [Pa] at the start, of x; cells: along a part, and across."""
        self.path = folder.resolve()
        for name in ("0", "constant", "system"):
            (self.path / name).mkdir(parents=True)
        self.strip, self.length, self.cells = strip, length, cells
        self.write("system/feSchemes",
                   "timeScheme twoStep;\nshockCapturing none;\n")
        self.write("system/fvSchemes", "divSchemes {}\ngradSchemes {}\n"
                   "laplacianSchemes {}\n")
        self.write("system/fvSolution", "")
        self.write("constant/thermophysicalProperties", THERMO)
        self.write("constant/shellProperties", SHELL.format(
            thickness=strip.thickness, E=strip.E, rho=strip.rho))
        self.write("system/blockShellDict", MESH_OF_SHELL)
        self.write("system/blockMeshDict", self.blocks())
        self.write(
            "constant/dynamicMeshDict",
            "dynamicFvMesh dynamicMotionSolverFvMesh;\n"
            "motionSolverLibs (meshMotion);\nsolver inverseDistance;\n"
            "inverseDistanceCoeffs { movingPatches (face); tolerance 0; }\n")
        self.setControl()
        self.run("blockMesh")
        self.run("blockShell")
        self.writeFields(pressure, T)

    def write(self, file, text, kind="dictionary"):
        head = HEADER.format(kind=kind, name=file.split("/")[-1])
        (self.path / file).write_text(head + text)

    def blocks(self):
        half = 0.5 * self.strip.thickness
        vertices, blocks, face, walls, sides = [], [], [], [], []
        for low, high in ((-half - self.length, -half),
                          (half, half + self.length)):
            n = len(vertices)
            vertices += [f"({x:.17g} {y:.17g} {z:.17g})" for z in (0, DEPTH)
                         for x, y in ((low, 0), (high, 0), (high, HEIGHT),
                                      (low, HEIGHT))]
            hexahedron = " ".join(str(n + i) for i in range(8))
            blocks.append(f"hex ({hexahedron}) ({self.cells[0]} "
                          f"{self.cells[1]} 1) simpleGrading (1 1 1)")

            def of(*corners):
                return "(" + " ".join(str(n + i) for i in corners) + ")"

            ends = [of(0, 4, 7, 3), of(1, 2, 6, 5)]
            face.append(ends[1 if low < 0 else 0])
            walls += [ends[0 if low < 0 else 1], of(0, 1, 5, 4),
                      of(3, 7, 6, 2)]
            sides += [of(0, 3, 2, 1), of(4, 5, 6, 7)]
        patches = (f"face {{ type wall; faces ({' '.join(face)}); }}\n"
                   f"walls {{ type wall; faces ({' '.join(walls)}); }}\n"
                   f"sides {{ type empty; faces ({' '.join(sides)}); }}\n")
        return (f"scale 1;\nvertices ({' '.join(vertices)});\n"
                f"blocks ({' '.join(blocks)});\nedges ();\n"
                f"boundary ({patches});\n")

    def writeFields(self, pressure, T):
        x = self.points()[:, 0]
        pressures = "\n".join(f"{p:.17g}" for p in pressure(x))
        values = {
            "p": f"nonuniform List<scalar>\n{len(x)}\n(\n{pressures}\n)",
            "T": f"uniform {T:.17g}", "U": "uniform (0 0 0)",
            "pointDisplacement": "uniform (0 0 0)",
        }
        for field, value in values.items():
            kind, dimensions = DIMENSIONS[field]
            wall = face = "type zeroGradient;"
            if field == "U":
                wall, face = "type slip;", "type shellInterface;"
            if field == "pointDisplacement":
                wall = face = "type fixedValue; value uniform (0 0 0);"
            self.write(f"0/{field}", (
                f"dimensions {dimensions};\ninternalField {value};\n"
                "boundaryField\n{\n"
                f"face {{ {face} }}\nwalls {{ {wall} }}\n"
                "sides { type empty; }\n}\n"), kind=kind)

    # Runs

    def setControl(self, endTime=1, deltaT=1, writeInterval=None):
        text = CONTROL[:CONTROL.index("functions")] + FUNCTIONS
        for entry, value in (("endTime", endTime), ("deltaT", deltaT),
                             ("writeInterval", writeInterval or endTime)):
            text = re.sub(rf"\n{entry} +\S+;", f"\n{entry} {value:.12g};",
                          text)
        self.write("system/controlDict", text)

    def couple(self, scheme, coeffs="", **entries):
        self.write("constant/couplingProperties", (
            f"coupling {scheme};\npatches (face);\n"
            + "".join(f"{k} {v};\n" for k, v in entries.items()) + coeffs))
        return self

    def runTo(self, endTime, deltaT, check=True, writeInterval=None):
        self.setControl(endTime, deltaT, writeInterval)
        self.log = self.run("shockShellFoam", check=check)
        return self

    # Results

    def gasTable(self, start="0"):
        """Columns of conservation.csv by name."""
        path = self.path / "postProcessing/gas" / start / "conservation.csv"
        lines = [line for line in path.read_text().splitlines()
                 if not line.startswith("#")]
        rows = np.loadtxt(lines[1:], delimiter=",", ndmin=2)
        return dict(zip(lines[0].split(","), rows.T))

    def stripTable(self, start="0"):
        names, table = self.history(f"strip/{start}/energies.dat")
        return dict(zip(names, table.T))

    def motion(self, start="0"):
        """Times, displacement and velocity of the strip's middle along x."""
        table = self.history(f"wall/{start}/displacement.dat")[1]
        speed = self.history(f"wall/{start}/velocity.dat")[1]
        return table[:, 0], table[:, 1], speed[:, 1]
