"""A closed box of gas whose wall at x = 0 is a piston; the mesh follows it."""
import numpy as np

from foamCase import FoamCase
from gasBox import BLOCK, HERE, GasBox, patch

HEADER = "FoamFile { version 2.0; format ascii; class %s; object %s; }\n"

MOTION = {
    "inverseDistance": """
motionSolverLibs (meshMotion);
solver inverseDistance;
inverseDistanceCoeffs { movingPatches (piston); fixedPatches (end); }
""",
    "displacementLaplacian": """
motionSolverLibs (fvMotionSolvers);
solver displacementLaplacian;
displacementLaplacianCoeffs { diffusivity uniform; }
""",
}


class PistonBox(GasBox):
    """cells: (n,) for lines, (n, m) for triangles; the box is a unit square.

    piston: boundary condition of pointDisplacement there, as text.
    """

    def __init__(self, folder, cells, piston, motionSolver):
        FoamCase.__init__(self, HERE / "box", folder)
        dim = len(cells)
        numbers = list(cells) + [1] * (3 - dim)
        sides = "(0 3 2 1) (4 5 6 7)"
        across = "(0 1 5 4) (3 7 6 2)"
        patches = patch("piston", "patch", "(0 4 7 3)")
        patches += patch("end", "patch", "(1 2 6 5)")
        if dim == 2:
            patches += patch("walls", "patch", across)
        else:
            sides += across
        patches += patch("sides", "empty", sides)
        (self.path / "system" / "blockMeshDict").write_text(BLOCK.format(
            lx=1, ly=1, lz=0.1, nx=numbers[0], ny=numbers[1], nz=1,
            patches=patches,
        ))
        self.run("blockMesh")
        self.x = self.points()
        for name in ("piston", "end"):
            self.set("0/U", f"boundaryField/{name}", "{ type slip; }")
        self.motion(motionSolver, piston)

    def motion(self, solver, piston):
        # inverseDistance moves the points alongside as those inside, with the
        # piston; the Laplacian solver has to be told that they may slide
        walls = "calculated" if solver == "inverseDistance" else "slip"
        (self.path / "constant" / "dynamicMeshDict").write_text(
            HEADER % ("dictionary", "dynamicMeshDict") + MOTION[solver])
        (self.path / "0" / "pointDisplacement").write_text(
            HEADER % ("pointVectorField", "pointDisplacement") + f"""
dimensions [0 1 0 0 0 0 0];
internalField uniform (0 0 0);
boundaryField
{{
    piston {{ {piston} value uniform (0 0 0); }}
    end {{ type fixedValue; value uniform (0 0 0); }}
    walls {{ type {walls}; }}
    sides {{ type empty; }}
}}
""")
        for file, entry, value in (
            ("fvSchemes", "laplacianSchemes",
             "{ default Gauss linear corrected; }"),
            ("fvSchemes", "snGradSchemes", "{ default corrected; }"),
            ("fvSchemes", "gradSchemes", "{ default Gauss linear; }"),
            ("fvSchemes", "interpolationSchemes", "{ default linear; }"),
            ("fvSolution", "solvers", "{ cellDisplacement { solver PCG;"
             " preconditioner DIC; tolerance 1e-10; relTol 0; } }"),
        ):
            self.run("foamDictionary", f"system/{file}", "-entry", entry,
                     "-add", value, log="log.foamDictionary", check=False)
            self.set(f"system/{file}", entry, value)

    def mass(self, time, cells):
        """Integral of the density of a plane box, by the solver's triangles:
        a quadrilateral is cut between its corners at an even number of edges
        from the first point."""
        n, m = cells
        shape = (m + 1, n + 1)
        side = slice(0, shape[0] * shape[1])
        x = self.points(time)[side, :2].reshape(*shape, 2)
        rho = self.pointField("rho", time)[side].reshape(shape)

        corners = [
            (a[:-1, :-1], a[:-1, 1:], a[1:, 1:], a[1:, :-1]) for a in (x, rho)
        ]
        row, column = np.indices((m, n))
        even = (row + column) % 2 == 0
        total = 0.0
        for cut, triangles in (
            (even, ((0, 1, 2), (0, 2, 3))), (~even, ((1, 2, 3), (1, 3, 0))),
        ):
            for i, j, k in triangles:
                p, q, r = (corners[0][c][cut] for c in (i, j, k))
                d, e = q - p, r - p
                area = (d[..., 0] * e[..., 1] - d[..., 1] * e[..., 0]) / 2
                assert (area > 0).all()
                mean = sum(corners[1][c][cut] for c in (i, j, k)) / 3
                total += (area * mean).sum()
        return total
