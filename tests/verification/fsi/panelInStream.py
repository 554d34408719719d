"""Supersonic gas over an elastic panel in a wall, and piston theory of it.

    case = PanelInStream(folder, E=2e11)
    case.runTo(0.04)
    rate = growthRate(*case.motion())

A strip in plane strain, clamped at both ends, with the stream over its upper face
and the stream's pressure (pRef) below.
"""
import re

import numpy as np

from foamCase import FoamCase
from platesInGas import CONTROL, DIMENSIONS, GAMMA, HEADER, R, THERMO

MACH, P, T = 5.0, 1e5, 300.0
SPEED = MACH * np.sqrt(GAMMA * R * T)
LENGTH, DEPTH, AHEAD = 0.5, 0.01, 0.05      # m
THICKNESS, DENSITY, POISSON = 2e-3, 2000.0, 0.3
MASS = DENSITY * THICKNESS
# Sound from the panel gets back from this height behind its end
HEIGHT = 0.06

SHELL = f"""
mesh            shell;
sections
{{
    panel
    {{
        elementSet  all;
        thickness   {THICKNESS};
        material
        {{
            type    SaintVenantKirchhoff;
            E       %.17g;
            nu      {POISSON};
            rho     {DENSITY};
        }}
    }}
}}
constraints
{{
    low     {{ type clamped; nodeSet low; }}
    high    {{ type clamped; nodeSet high; }}
    strip   {{ type planeStrainStrip; direction (0 0 1); }}
}}
loads
{{
    kick
    {{
        type        traction;
        traction    (0 20 0);
        factor      table ((0 0) (2e-4 1) (1e-3 1) (1.2e-3 0) (9 0));
    }}
}}
analysis        dynamic;
timeIntegrator  Newmark;
elementForm     displacement;
vtk             no;
"""
MESH_OF_SHELL = f"""
mesh        shell;
surface
{{
    type    plate;
    origin  (0 {-THICKNESS / 2} {DEPTH});
    sideU   ({LENGTH} 0 0);
    sideV   (0 0 {-DEPTH});
}}
divisions   (10 1);
nodeSets    {{ low uMin; high uMax; }}
"""
PROBE = """functions
{
    panel
    {
        type    shellProbes;
        libs    (shockShellFunctionObjects);
        points  ((%g %g %g));
        fields  (displacement);
        writePrecision 12;
    }
}
""" % (0.75 * LENGTH, -THICKNESS / 2, DEPTH / 2)


def stiffness(E):
    """Bending stiffness of the strip [N m]."""
    return E * THICKNESS**3 / (12 * (1 - POISSON**2))


def youngFor(parameter):
    """E with which lambda = 2 q a^3/(beta D) is this."""
    beta = np.sqrt(MACH**2 - 1)
    D = GAMMA * P * MACH**2 * LENGTH**3 / (beta * parameter)
    return D * 12 * (1 - POISSON**2) / THICKNESS**3


def pistonTheory(parameter, damped=True, n=160):
    """Growth rate [1/s] of the least stable motion of the panel by linear piston
    theory, p' = 2q/beta (dw/dx + (M^2-2)/(M^2-1)/U dw/dt); differences on n
    intervals, ends clamped."""
    D = stiffness(youngFor(parameter))
    h = LENGTH / n
    size = n - 1
    fourth = np.zeros((size, size))
    first = np.zeros((size, size))
    for i in range(size):
        for offset, weight in ((-2, 1), (-1, -4), (0, 6), (1, -4), (2, 1)):
            if 0 <= i + offset < size:
                fourth[i, i + offset] += weight
        for offset, weight in ((-1, -0.5), (1, 0.5)):
            if 0 <= i + offset < size:
                first[i, i + offset] += weight
    # w = w' = 0: the mirrored node outside has the value of the first inside
    fourth[0, 0] += 1
    fourth[-1, -1] += 1
    load = GAMMA * P * MACH**2 / np.sqrt(MACH**2 - 1)
    operator = D * fourth / h**4 + load * first / h
    damping = load / SPEED * (MACH**2 - 2) / (MACH**2 - 1) if damped else 0
    # m s^2 + d s + k = 0 for each eigenvalue k
    k = np.linalg.eigvals(operator)
    root = np.sqrt(damping**2 - 4 * MASS * k.astype(complex))
    return max(((-damping + root) / (2 * MASS)).real.max(),
               ((-damping - root) / (2 * MASS)).real.max())


def growthRate(t, w):
    """[1/s] from the largest values of the second and the last third."""
    end = t[-1]
    parts = [(t > a * end) & (t <= b * end)
             for a, b in ((1 / 3, 2 / 3), (2 / 3, 1))]
    sizes = [np.sqrt((w[part]**2).mean()) for part in parts]
    return np.log(sizes[1] / sizes[0]) / (end / 3)


class PanelInStream(FoamCase):

    def __init__(self, folder, E, cells=(40, 4, 16)):
        """cells: over the panel, ahead and behind, and up."""
        self.cells = cells
        self.path = folder.resolve()
        for name in ("0", "constant", "system"):
            (self.path / name).mkdir(parents=True)
        for file, text in (
            ("system/feSchemes", "timeScheme twoStep;\n"
             "shockCapturing none;\n"),
            ("system/fvSchemes", "divSchemes {}\ngradSchemes {}\n"
             "laplacianSchemes {}\n"),
            ("system/fvSolution", ""),
            ("constant/thermophysicalProperties", THERMO),
            ("constant/shellProperties", SHELL % E),
            ("system/blockShellDict", MESH_OF_SHELL),
            ("system/blockMeshDict", self.blocks()),
            ("constant/dynamicMeshDict",
             "dynamicFvMesh dynamicMotionSolverFvMesh;\n"
             "motionSolverLibs (meshMotion);\nsolver inverseDistance;\n"
             "inverseDistanceCoeffs { movingPatches (panel); }\n"),
            ("constant/couplingProperties",
             "coupling predictedMotion;\npatches (panel);\n"
             f"pRef {P:.17g};\nsubCycles 10;\n"),
        ):
            self.write(file, text)
        self.setControl(1)
        self.run("blockMesh")
        self.run("blockShell")
        self.writeFields()

    def write(self, file, text, kind="dictionary"):
        head = HEADER.format(kind=kind, name=file.split("/")[-1])
        (self.path / file).write_text(head + text)

    def blocks(self):
        panel, ahead, up = self.cells
        places = (-AHEAD, 0, LENGTH, LENGTH + AHEAD)
        vertices = " ".join(
            f"({x} {y} {z})" for z in (0, DEPTH) for y in (0, HEIGHT)
            for x in places)
        blocks, walls, top, sides = [], [], [], []
        for i, cells in enumerate((ahead, panel, ahead)):
            corners = (i, i + 1, i + 5, i + 4, i + 8, i + 9, i + 13, i + 12)
            blocks.append(f"hex ({' '.join(map(str, corners))}) "
                          f"({cells} {up} 1) simpleGrading (1 1 1)")
            walls.append(f"({i} {i + 1} {i + 9} {i + 8})")
            top.append(f"({i + 4} {i + 12} {i + 13} {i + 5})")
            sides += [f"({i} {i + 4} {i + 5} {i + 1})",
                      f"({i + 8} {i + 9} {i + 13} {i + 12})"]
        return (
            f"scale 1;\nvertices ({vertices});\nblocks ({' '.join(blocks)});\n"
            "edges ();\nboundary\n(\n"
            f"panel {{ type wall; faces ({walls[1]}); }}\n"
            f"walls {{ type wall; faces ({walls[0]} {walls[2]}); }}\n"
            "outer { type patch; faces ((0 8 12 4) (3 7 15 11) "
            f"{' '.join(top)}); }}\n"
            f"sides {{ type empty; faces ({' '.join(sides)}); }}\n);\n")

    def writeFields(self):
        values = {"p": f"{P:.17g}", "T": f"{T:.17g}", "U": f"({SPEED:.17g} 0 0)",
                  "pointDisplacement": "(0 0 0)"}
        for field, value in values.items():
            kind, dimensions = DIMENSIONS[field]
            outer = f"type farField; value uniform {value};"
            wall = panel = "type zeroGradient;"
            if field == "U":
                wall, panel = "type slip;", "type shellInterface;"
            if field == "pointDisplacement":
                outer = wall = panel = "type fixedValue; value uniform (0 0 0);"
            self.write(f"0/{field}", (
                f"dimensions {dimensions};\ninternalField uniform {value};\n"
                f"boundaryField\n{{\npanel {{ {panel} }}\nwalls {{ {wall} }}\n"
                f"outer {{ {outer} }}\nsides {{ type empty; }}\n}}\n"),
                kind=kind)

    def setControl(self, endTime):
        text = CONTROL[:CONTROL.index("functions")] + PROBE
        for entry, value in (("endTime", f"{endTime:g}"), ("deltaT", "1e-6"),
                             ("writeInterval", f"{endTime:g}"),
                             ("adjustTimeStep", "yes")):
            text = re.sub(rf"\n{entry} +\S+;", f"\n{entry} {value};", text)
        self.write("system/controlDict", text)

    def runTo(self, endTime):
        self.setControl(endTime)
        self.log = self.run("shockShellFoam")
        return self

    def motion(self):
        """Times, and displacement across the panel at three quarters of it."""
        table = self.history("panel/0/displacement.dat")[1]
        return table[:, 0], table[:, 2]
