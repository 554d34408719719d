"""One-dimensional cases of a rigid plate between gases, for exact solutions.

    case = PlateInGas(folder, mass=7.6, front=Gas(1.0, 1000, airAtRest))
    case.couple("twoWay", subCycles=1)
    case.runTo(1e-3, deltaT=1e-6)
    t, x = case.motion()

The plate is a shell whose nodes can only move along x, all by the same way. It
has a length and width of 0.1 m and a mass and a spring (elasticFoundation) per
area. The gas is in front of it (negative x), behind it, or both; what is not
gas has the constant pressure pRef.
"""
from dataclasses import dataclass

import numpy as np

from foamCase import FoamCase

# source: reference data of the cases: gamma 1.4, R 287 J/(kg K)
GAMMA, R = 1.4, 287.0

SIDE = 0.1
THICKNESS = 1e-3

HEADER = """FoamFile
{{
    version     2.0;
    format      ascii;
    class       {kind};
    object      {name};
}}
"""
# source: OpenFOAM v1912, constant::thermodynamic::RR [J/(kmol K)]
THERMO = f"""
thermoType
{{
    type hePsiThermo; mixture pureMixture; transport const; thermo hConst;
    equationOfState perfectGas; specie specie; energy sensibleInternalEnergy;
}}
mixture
{{
    specie {{ molWeight {8314.47006650545 / R:.17g}; }}
    thermodynamics {{ Cp {GAMMA * R / (GAMMA - 1):.17g}; Hf 0; }}
    transport {{ mu 0; Pr 1; }}
}}
"""
CONTROL = """
application     shockShellFoam;
startFrom       latestTime;
startTime       0;
stopAt          endTime;
endTime         1;
deltaT          1;
adjustTimeStep  no;
writeControl    adjustableRunTime;
writeInterval   1;
writeFormat     ascii;
writePrecision  17;
timeFormat      general;
timePrecision   12;
runTimeModifiable no;
functions
{
    plate
    {
        type        shellProbes;
        libs        (shockShellFunctionObjects);
        points      ((0 0 0));
        writePrecision 16;
        fields      (displacement velocity);
    }
}
"""
SHELL = """
mesh            shell;
sections
{{
    plate
    {{
        elementSet  all;
        thickness   {thickness:.17g};
        material
        {{
            type    SaintVenantKirchhoff;
            E       1e9;
            nu      0;
            rho     {density:.17g};
        }}
    }}
}}
constraints
{{
    guide   {{ type fixed; nodeSet all; components (y z gx gy gz a); }}
    rigid   {{ type tied; nodeSet all; component x; }}
}}
{loads}
analysis        dynamic;
timeIntegrator  Newmark;
newton          {{ residualTolerance 1e-12; incrementTolerance 1e-12; }}
elementForm     displacement;
vtk             no;
"""
MESH_OF_SHELL = f"""
mesh        shell;
surface
{{
    type    plate;
    origin  (0 0 0);
    sideU   (0 {SIDE} 0);
    sideV   (0 0 {SIDE});
}}
divisions   (1 1);
"""
DIMENSIONS = {
    "p": ("pointScalarField", "[1 -1 -2 0 0 0 0]"),
    "T": ("pointScalarField", "[0 0 0 1 0 0 0]"),
    "U": ("pointVectorField", "[0 1 -1 0 0 0 0]"),
    "pointDisplacement": ("pointVectorField", "[0 1 0 0 0 0 0]"),
}


@dataclass
class Gas:
    """Gas from the plate over a length [m] to a far end.

    state: function of x, returns p, U, T (arrays). farEnd: wall or farField.
    """

    length: float
    cells: int
    state: object
    farEnd: str = "farField"


def uniform(p, T, U=0.0):
    """State of a uniform gas."""
    return lambda x: (p + 0 * x, U + 0 * x, T + 0 * x)


def soundSpeed(T):
    return np.sqrt(GAMMA * R * T)


def listed(values):
    values = np.asarray(values)
    if values.ndim == 1:
        kind, rows = "scalar", ("%.17g" % v for v in values)
    else:
        kind, rows = "vector", ("(%.17g %.17g %.17g)" % tuple(v)
                                for v in values)
    return f"nonuniform List<{kind}>\n{len(values)}\n(\n" + "\n".join(rows) \
        + "\n)"


class PlateInGas(FoamCase):

    def __init__(self, folder, mass, front=None, back=None, spring=0.0,
                 capturing="fluxCorrected"):
        self.path = folder.resolve()
        for name in ("0", "constant", "system"):
            (self.path / name).mkdir(parents=True)
        self.sides = {name: gas for name, gas in
                      (("front", front), ("back", back)) if gas}
        self.write("system/controlDict", CONTROL)
        self.write("system/feSchemes", "timeScheme twoStep;\n"
                   f"shockCapturing {capturing};\n")
        # OpenFOAM's mesh reads them; nothing in them is used
        self.write("system/fvSchemes", "divSchemes {}\ngradSchemes {}\n"
                   "laplacianSchemes {}\n")
        self.write("system/fvSolution", "")
        self.write("constant/thermophysicalProperties", THERMO)
        loads = "" if spring == 0 else (
            "loads { spring { type elasticFoundation; "
            f"stiffness {spring:.17g}; direction (1 0 0); }} }}")
        self.write("constant/shellProperties", SHELL.format(
            thickness=THICKNESS, density=mass / THICKNESS, loads=loads))
        self.write("system/blockShellDict", MESH_OF_SHELL)
        self.write("system/blockMeshDict", self.blocks())
        self.write("constant/dynamicMeshDict", self.meshMotion())
        self.run("blockMesh")
        self.run("blockShell")
        self.writeFields()

    def write(self, file, text, kind="dictionary"):
        head = HEADER.format(kind=kind, name=file.split("/")[-1])
        (self.path / file).write_text(head + text)

    # Mesh

    def extent(self, side):
        gas = self.sides[side]
        return ((-gas.length - THICKNESS / 2, -THICKNESS / 2)
                if side == "front" else
                (THICKNESS / 2, gas.length + THICKNESS / 2))

    def blocks(self):
        vertices, blocks, patches, empty = [], [], [], []
        for side, gas in self.sides.items():
            n = len(vertices)
            low, high = self.extent(side)
            vertices += [
                f"({x:.17g} {y:.17g} {z:.17g})" for z in (0, SIDE)
                for x, y in ((low, 0), (high, 0), (high, SIDE), (low, SIDE))
            ]
            hexahedron = " ".join(str(n + i) for i in range(8))
            blocks.append(f"hex ({hexahedron}) ({gas.cells} 1 1) "
                          "simpleGrading (1 1 1)")
            ends = {"low": (0, 4, 7, 3), "high": (1, 2, 6, 5)}
            plate, far = (("high", "low") if side == "front"
                          else ("low", "high"))
            for name, end in ((f"{side}Face", plate), (f"{side}End", far)):
                face = " ".join(str(n + i) for i in ends[end])
                patches.append(
                    f"{name} {{ type patch; faces (({face})); }}")
            empty += ["(" + " ".join(str(n + i) for i in face) + ")"
                      for face in ((0, 1, 5, 4), (3, 7, 6, 2),
                                   (0, 3, 2, 1), (4, 5, 6, 7))]
        patches.append(f"sides {{ type empty; faces ({' '.join(empty)}); }}")
        return (f"scale 1;\nvertices ({' '.join(vertices)});\n"
                f"blocks ({' '.join(blocks)});\nedges ();\n"
                f"boundary ({' '.join(patches)});\n")

    def meshMotion(self):
        faces = " ".join(f"{side}Face" for side in self.sides)
        return ("dynamicFvMesh dynamicMotionSolverFvMesh;\n"
                "motionSolverLibs (meshMotion);\nsolver inverseDistance;\n"
                f"inverseDistanceCoeffs {{ movingPatches ({faces}); "
                "e1 1; e2 1; tolerance 0; }\n")

    # Fields

    def writeFields(self):
        points = self.points()
        x = points[:, 0]
        p, U, T = np.zeros(len(x)), np.zeros((len(x), 3)), np.zeros(len(x))
        for side, gas in self.sides.items():
            here = x < 0 if side == "front" else x > 0
            p[here], U[here, 0], T[here] = gas.state(x[here])
        values = {"p": p, "T": T, "U": U, "pointDisplacement": 0 * U}
        for field, value in values.items():
            kind, dimensions = DIMENSIONS[field]
            text = (f"dimensions {dimensions};\ninternalField "
                    f"{listed(value)};\nboundaryField\n{{\n"
                    "sides { type empty; }\n")
            for side in self.sides:
                text += f"{side}Face {{ {self.faceType(field)} }}\n"
                text += f"{side}End {{ {self.endType(side, field)} }}\n"
            self.write(f"0/{field}", text + "}\n", kind=kind)

    @staticmethod
    def faceType(field):
        if field == "pointDisplacement":
            return "type fixedValue; value uniform (0 0 0);"
        return "type shellInterface;" if field == "U" else \
            "type zeroGradient;"

    def endType(self, side, field):
        gas = self.sides[side]
        if field == "pointDisplacement":
            return "type fixedValue; value uniform (0 0 0);"
        if gas.farEnd == "wall":
            return "type slip;" if field == "U" else "type zeroGradient;"
        low, high = self.extent(side)
        p, U, T = gas.state(np.array([low if side == "front" else high]))
        value = {"p": f"{p[0]:.17g}", "T": f"{T[0]:.17g}",
                 "U": f"({U[0]:.17g} 0 0)"}[field]
        return f"type farField; value uniform {value};"

    # Runs

    def couple(self, scheme, pRef=0.0, coeffs="", **entries):
        faces = " ".join(f"{side}Face" for side in self.sides)
        text = f"coupling {scheme};\npatches ({faces});\npRef {pRef:.17g};\n"
        text += "".join(f"{k} {v};\n" for k, v in entries.items()) + coeffs
        self.write("constant/couplingProperties", text)
        return self

    def runTo(self, endTime, deltaT=None, maxCo=None, check=True,
              writeInterval=None):
        """Fixed coupling steps deltaT, or by the Courant number maxCo."""
        text = CONTROL
        for entry, value in (
            ("endTime", endTime), ("writeInterval", writeInterval or endTime),
            ("deltaT", deltaT or 1e-9),
        ):
            text = text.replace(f"\n{entry} ", f"\n{entry} {value:.12g}; //",
                                1)
        if maxCo:
            text = text.replace("adjustTimeStep  no;",
                                f"adjustTimeStep yes; maxCo {maxCo};")
        self.write("system/controlDict", text)
        self.log = self.run("shockShellFoam", check=check)
        return self

    def motion(self, start="0"):
        """Times, displacement and velocity of the plate along x."""
        table = self.history(f"plate/{start}/displacement.dat")[1]
        speed = self.history(f"plate/{start}/velocity.dat")[1]
        return table[:, 0], table[:, 1], speed[:, 1]

    def balance(self, start="0"):
        """Columns of postProcessing/interface by name."""
        names, table = self.history(f"interface/{start}/balance.dat")
        return dict(zip(names, table.T))
