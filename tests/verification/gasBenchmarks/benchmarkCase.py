"""A case of the gas solver, written and run by a benchmark.

    case = BenchmarkCase(folder, box([(1, 100)]))
    case.start(lambda x: (rho, U, p), {"left": "wall", "right": "open"})
    case.runTo(0.2)
    x, rho = case.x, case.result("rho")

States are functions of the coordinates (n, 3) of the points; U is (n, 3) or
its x component (n,). Arrays hold one value per node of the scene: the mesh
points of one side of the mesh in the directions that the scene has not.
The gas constant is 1, so that p = rho T.
"""
import re

import numpy as np

from blockMeshes import HEADER
from foamCase import FoamCase
from foamFile import readText
from scheme import MAX_CO, scheme

# source: OpenFOAM v1912, constant::thermodynamic::RR [J/(kmol K)], with which
# the gas constant is 1
MOLAR_WEIGHT = 8314.47006650545

FIELDS = {
    "p": ("pointScalarField", "[1 -1 -2 0 0 0 0]"),
    "U": ("pointVectorField", "[0 1 -1 0 0 0 0]"),
    "T": ("pointScalarField", "[0 0 0 1 0 0 0]"),
    "pointDisplacement": ("pointVectorField", "[0 1 0 0 0 0 0]"),
    "pointMotionU": ("pointVectorField", "[0 1 -1 0 0 0 0]"),
}
THERMO = """
thermoType
{{
    type hePsiThermo; mixture pureMixture; transport const; thermo hConst;
    equationOfState perfectGas; specie specie; energy sensibleInternalEnergy;
}}
mixture
{{
    specie {{ molWeight {weight:.17g}; }}
    thermodynamics {{ Cp {cp:.17g}; Hf 0; }}
    transport {{ mu {mu:.17g}; Pr {prandtl:.17g}; }}
}}
"""
CONTROL = """
application     shockShellFoam;
startFrom       startTime;
startTime       0;
writeFormat     ascii;
writePrecision  16;
timeFormat      general;
timePrecision   12;
"""
# Motion solvers of OpenFOAM, by the field that drives them. The displacement
# is exact at each time, but displacementLaplacian is unstable when a length
# halves (it is linear in the moved coordinates); with the velocity the walls'
# places are sums over the steps.
MOTION = """
motionSolverLibs (fvMotionSolvers);
solver {solver};
{solver}Coeffs {{ diffusivity uniform; }}
"""
DRIVEN = {
    "pointDisplacement": "displacementLaplacian",
    "pointMotionU": "velocityLaplacian",
}
# Read by the motion solver only
FV_SCHEMES = """
gradSchemes { default Gauss linear; }
divSchemes { default none; }
laplacianSchemes { default Gauss linear corrected; }
interpolationSchemes { default linear; }
snGradSchemes { default corrected; }
"""
FV_SOLUTION = """
solvers { "(cellMotionU|cellDisplacement)"
{ solver PCG; preconditioner DIC; tolerance 1e-13; relTol 0; } }
"""


def listed(values):
    """A field's values, as OpenFOAM writes them."""
    values = np.asarray(values)
    if values.ndim == 1:
        kind, rows = "scalar", ("%.17g" % v for v in values)
    else:
        kind, rows = "vector", ("(%.17g %.17g %.17g)" % tuple(v)
                                for v in values)
    body = "\n".join(rows)
    return f"nonuniform List<{kind}>\n{len(values)}\n(\n{body}\n)"


class BenchmarkCase(FoamCase):

    def __init__(self, folder, mesh, gamma=1.4, mu=0, prandtl=1, gravity=None,
                 capturing=True):
        self.path, self.mesh, self.gamma = folder.resolve(), mesh, gamma
        for name in ("0", "constant", "system"):
            (self.path / name).mkdir(parents=True)
        self.write("system/feSchemes", scheme(capturing))
        self.control({"stopAt": "endTime", "endTime": 1, "deltaT": 1,
                      "writeInterval": 1})
        self.write("system/fvSchemes", FV_SCHEMES)
        self.write("system/fvSolution", FV_SOLUTION)
        self.write("constant/thermophysicalProperties", THERMO.format(
            weight=MOLAR_WEIGHT, cp=gamma / (gamma - 1), mu=mu,
            prandtl=prandtl,
        ))
        if gravity is not None:
            self.write(
                "constant/g", "dimensions [0 1 -2 0 0 0 0];\n"
                "value (%.17g %.17g %.17g);\n" % gravity,
                kind="uniformDimensionedVectorField",
            )
        mesh.make(self)
        self.readMesh()

    def write(self, file, text, kind="dictionary", headed=False):
        head = HEADER.format(kind=kind, name=file.split("/")[-1])
        (self.path / file).write_text(text if headed else head + text)

    # Points

    def readMesh(self):
        self.allPoints = self.points()
        side = np.ones(len(self.allPoints), bool)
        for axis in range(self.mesh.dim, 3):
            z = self.allPoints[:, axis]
            # A wedge has points on both sides of 0, and those of its axis at 0
            side &= z <= (0 if z.min() < 0 else z.min() + 1e-9 * np.ptp(z))
        self.side = np.flatnonzero(side)
        # Lines in the order of x
        if self.mesh.dim == 1:
            self.side = self.side[np.argsort(self.allPoints[self.side, 0])]
        self.x = self.allPoints[self.side]

    def movePoints(self, points):
        """Replace the mesh points (all of them)."""
        self.write("constant/polyMesh/points",
                   listed(points).split("\n", 1)[1], kind="vectorField")
        self.readMesh()

    def patchPoints(self, patch):
        """Labels of a patch's points in the order of its point fields."""
        folder = self.path / "constant" / "polyMesh"
        entry = re.search(
            rf"\b{patch}\s*\{{(.*?)\}}", readText(folder / "boundary"), re.S
        ).group(1)
        count, first = (
            int(re.search(rf"{word}\s+(\d+)", entry).group(1))
            for word in ("nFaces", "startFace")
        )
        faces = re.findall(r"\d+\(([\d ]+)\)", readText(folder / "faces"))
        labels = {}
        for face in faces[first:first + count]:
            for label in face.split():
                labels.setdefault(int(label))
        return np.array(list(labels))

    # Initial and boundary values

    def start(self, state, boundary, outer=None):
        """Writes 0/p, U and T.

        state: function of the points, returns rho, U, p. boundary: patch ->
        open (nothing prescribed), wall (slip), fixed or far (the values of
        outer, a function like state; without one, of state), or a dict with
        the types of p, U and T as text. Wedge, empty and cyclic patches need
        no entry.
        """
        types = {name: {} for name in "pUT"}
        for patch, (kind, _) in self.mesh.patches.items():
            kind = kind.split(",")[0]
            chosen = boundary.get(patch, kind) if kind == "patch" else kind
            for field, text in self.boundaryTypes(
                patch, chosen, outer or state
            ).items():
                types[field][patch] = text
        values = self.primitive(state, self.allPoints)
        for field, value in values.items():
            self.writeField(field, value, types[field])

    def boundaryTypes(self, patch, chosen, outer):
        if isinstance(chosen, dict):
            return chosen
        if chosen in ("fixed", "far"):
            kind = {"fixed": "fixedValue", "far": "farField"}[chosen]
            points = self.allPoints[self.patchPoints(patch)]
            return {
                field: f"type {kind}; value {listed(value)};"
                for field, value in self.primitive(outer, points).items()
            }
        same = {"open": ("zeroGradient", "zeroGradient"),
                "wall": ("zeroGradient", "slip")}
        scalars, vectors = same.get(chosen, (chosen, chosen))
        return {"p": f"type {scalars};", "T": f"type {scalars};",
                "U": f"type {vectors};"}

    @staticmethod
    def primitive(state, points):
        n = len(points)
        rho, U, p = state(points)
        U = np.asarray(U, float)
        if U.ndim == 0 or U.shape == (n,):
            U = np.multiply.outer(np.broadcast_to(U, n), [1.0, 0.0, 0.0])
        p = np.broadcast_to(np.asarray(p, float), n)
        return {"p": p, "T": p / rho, "U": np.broadcast_to(U, (n, 3))}

    def writeField(self, name, values, types):
        kind, dimensions = FIELDS[name]
        patches = "\n".join(
            f"{patch} {{ {text} }}" for patch, text in types.items()
        )
        self.write(
            f"0/{name}",
            f"dimensions {dimensions};\ninternalField {listed(values)};\n"
            f"boundaryField\n{{\n{patches}\n}}\n", kind=kind,
        )

    def move(self, field, moving):
        """The mesh moves: pointDisplacement or pointMotionU; patch -> its type
        there, as text; the other patches stay."""
        self.write("constant/dynamicMeshDict",
                   MOTION.format(solver=DRIVEN[field]))
        types = {}
        for patch, (kind, _) in self.mesh.patches.items():
            still = "fixedValue; value uniform (0 0 0)"
            types[patch] = moving.get(
                patch, f"type {still if kind == 'patch' else kind};")
        self.writeField(field, np.zeros((len(self.allPoints), 3)), types)

    # Running

    def control(self, entries):
        self.write("system/controlDict", CONTROL + "\n".join(
            f"{k} {v if isinstance(v, str) else format(v, '.15g')};"
            for k, v in entries.items()
        ))

    def runTo(self, endTime, timeout=300, **control):
        """Runs to endTime; self.seconds is the processor time of the run.

        control: entries of controlDict.
        """
        entries = {
            "stopAt": "endTime", "endTime": endTime, "deltaT": 1e-9 * endTime,
            "adjustTimeStep": "yes", "maxCo": MAX_CO,
            "writeControl": "adjustableRunTime", "writeInterval": endTime,
            **control,
        }
        self.control(entries)
        self.log = self.run("shockShellFoam", timeout=timeout)
        self.seconds = float(
            re.findall(r"ExecutionTime = (\S+) s", self.log)[-1])

    def result(self, name, time=None):
        """A field's values at the nodes at a time, the last one by default."""
        return self.pointField(name, time or self.times()[-1])[self.side]

    def nodes(self, time=None):
        """The nodes' places at a time, the last one by default."""
        return self.points(time or self.times()[-1])[self.side]

    def steps(self):
        return self.log.count("\nTime = ")
