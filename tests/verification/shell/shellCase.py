"""A static shell benchmark as a case: mesh of a mapped surface, sections,
supports and loads written from Python, run by positionalShellFoam,
displacements read back.

    mesh = Surface(n, n, position, normal)
    case = ShellCase(folder, mesh, sections, constraints)
    u = case.solve(loads, steps=10)
    u[case.mesh.node("uMaxvMax")]

and its frequencies and paths through limit points.
"""
import numpy as np

from foamCase import FoamCase
from shellFiles import readState

HEADER = """FoamFile
{
    version     2.0;
    format      ascii;
    class       %s;
    object      %s;
}
"""

# Places (i, j) in thirds of the ten nodes of a triangle: shellMeshIO.H
TRIANGLE = [(0, 0), (3, 0), (0, 3), (1, 0), (2, 0), (2, 1), (1, 2), (0, 2),
            (0, 1), (1, 1)]


class Surface:
    """nU x nV quadrilaterals of position(u, v), two cubic triangles each.

    position and normal map arrays u, v in [0, 1] to (..., 3).
    """

    def __init__(self, nU, nV, position, normal):
        self.nU, self.nV = nU, nV
        v, u = np.meshgrid(np.linspace(0, 1, 3*nV + 1),
                           np.linspace(0, 1, 3*nU + 1), indexing="ij")
        self.number = np.arange(u.size).reshape(u.shape)
        self.nodes = position(u, v).reshape(-1, 3)
        self.directors = normal(u, v).reshape(-1, 3)

        self.triangles = []
        for j in range(0, 3*nV, 3):
            for i in range(0, 3*nU, 3):
                self.triangles.append(
                    [self.number[j + b, i + a] for a, b in TRIANGLE])
                self.triangles.append(
                    [self.number[j + 3 - b, i + 3 - a] for a, b in TRIANGLE])

        n = self.number
        edges = {"uMin": n[:, 0], "uMax": n[:, -1],
                 "vMin": n[0, :], "vMax": n[-1, :]}
        self.sets = dict(edges)
        for u in ("uMin", "uMax"):
            for v in ("vMin", "vMax"):
                self.sets[u + v] = np.intersect1d(edges[u], edges[v])

    def node(self, name):
        """The one node of a set, such as the corner uMinvMax."""
        (node,) = self.sets[name]
        return node

    @property
    def size(self):
        return f"{self.nU} x {self.nV}"


def vectors(values):
    rows = "\n".join("(%.17g %.17g %.17g)" % tuple(v) for v in values)
    return f"{len(values)}\n(\n{rows}\n)\n"


def labels(values):
    return f"{len(values)}(" + " ".join(str(v) for v in values) + ")"


def entries(dictionary, indent=0):
    """OpenFOAM's text of nested Python dictionaries."""
    pad = " "*indent
    text = ""
    for name, value in dictionary.items():
        if isinstance(value, dict):
            text += f"{pad}{name}\n{pad}{{\n"
            text += entries(value, indent + 4) + f"{pad}}}\n"
        elif isinstance(value, (tuple, list)):
            text += f"{pad}{name} ({' '.join(str(v) for v in value)});\n"
        else:
            text += f"{pad}{name} {value};\n"
    return text


def isotropic(E, nu, thickness, rho=1):
    """Section of all elements."""
    return {"all": {
        "thickness": thickness,
        "material": {"type": "SaintVenantKirchhoff", "E": E, "nu": nu,
                     "rho": rho},
    }}


def symmetry(edge, normal):
    return {"type": "symmetryPlane", "nodeSet": edge, "normal": normal}


def fixed(nodes, *components):
    return {"type": "fixed", "nodeSet": nodes, "components": components}


def ramp(load):
    """The load grows with time from 0 to its value at 1."""
    return {**load, "factor": "polynomial ((1 1))"}


def force(nodes, value):
    return ramp({"type": "nodal", "nodeSet": nodes, "force": value})


class ShellCase:

    def __init__(self, folder, mesh, sections, constraints,
                 form="assumedStrain"):
        self.folder, self.mesh = folder, mesh
        self.properties = {
            "mesh": "shell", "sections": sections, "constraints": constraints,
            "analysis": "static", "elementForm": form, "vtk": "no",
        }

    def write(self, file, kind, text):
        path = self.folder / "source" / file
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(HEADER % (kind, path.name) + text)

    def writeMesh(self):
        mesh = self.mesh
        self.write("constant/shell/nodes", "vectorField", vectors(mesh.nodes))
        self.write("constant/shell/directors", "vectorField",
                   vectors(mesh.directors))
        rows = "\n".join(labels(t) for t in mesh.triangles)
        self.write("constant/shell/triangles", "labelListList",
                   f"{len(mesh.triangles)}\n(\n{rows}\n)\n")
        self.write("constant/shell/nodeSets", "dictionary", "".join(
            f"{name} {labels(nodes)};\n" for name, nodes in mesh.sets.items()))

    def control(self, **entriesOfControl):
        self.write("system/controlDict", "dictionary", entries({
            "application": "positionalShellFoam", "startFrom": "startTime",
            "startTime": 0, "stopAt": "endTime", "endTime": 1, "deltaT": 1,
            "writeControl": "timeStep", "writeFormat": "ascii",
            "writePrecision": 12, "timeFormat": "general",
            "timePrecision": 12, **entriesOfControl,
        }))

    def begin(self, loads, **properties):
        """The case without its controlDict."""
        self.writeMesh()
        self.write("constant/shellProperties", "dictionary",
                   entries({**self.properties, "loads": loads, **properties}))

    def start(self, *options, timeout=600):
        self.case = FoamCase(self.folder/"source", self.folder/"case")
        self.log = self.case.run("positionalShellFoam", *options,
                                 timeout=timeout)

    def solve(self, loads, steps=1, newton=None, endTime=1):
        """Displacements of all nodes; loads that ramp are whole at 1."""
        self.begin(loads, **({"newton": newton} if newton else {}))
        self.control(endTime=endTime, deltaT=repr(endTime/steps),
                     writeInterval=steps)
        self.start()
        return readState(self.case, endTime)["position"] - self.mesh.nodes

    def frequencies(self, number, shift=None):
        """The lowest frequencies [Hz]; shift as the program's."""
        self.begin({})
        self.control(writeInterval=1)
        self.start("-modes", number, *(("-shift", shift) if shift else ()))
        lines = self.log.split("Shell frequencies [Hz]")[1].splitlines()
        return [float(line.split()[1]) for line in lines[1:number + 1]]

    def path(self, loads, first, steps, points, **coeffs):
        """Load parameters and displacements of points along a path by arc
        length: arrays (step), (step, point, component), from the start."""
        self.begin(loads, staticMethod="arcLength", arcLengthCoeffs=coeffs)
        text = " ".join("(%.17g %.17g %.17g)" % tuple(p) for p in points)
        self.control(endTime=repr(first*steps), deltaT=repr(first),
                     writeInterval=steps, functions={"points": {
                         "type": "shellProbes",
                         "libs": "(shockShellFunctionObjects)",
                         "points": f"({text})",
                         "fields": "(displacement)", "writePrecision": 12}})
        self.start()
        _, rows = self.case.history("points/0/displacement.dat")
        loads = [float(line.split("=")[1]) for line in self.log.splitlines()
                 if "load parameter =" in line]
        u = rows[:, 1:].reshape(len(rows), len(points), 3)
        return np.insert(loads, 0, 0), np.insert(u, 0, 0, axis=0)
