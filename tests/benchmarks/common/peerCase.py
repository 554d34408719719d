"""OpenFOAM's rhoCentralFoam on the polyMesh of a case of ours.

    peer = PeerCase(folder, ours)
    peer.start({"p": p, "U": U, "T": T}, boundary)      # one value per cell
    peer.runTo(0.2)
    rho = peer.cellField("rho")

The scheme of its tutorials: Kurganov, vanLeer (vanLeerV for U), Euler, Courant
number 0.2; inviscid. Same gas, boundaries and control entries as ours.
"""
import shutil

from benchmarkCase import BenchmarkCase, listed
from foamCase import FoamCase
from foamFile import readInternalField
from runLog import RunLog
from scheme import PEER_MAX_CO

DIMENSIONS = {
    "p": ("volScalarField", "[1 -1 -2 0 0 0 0]"),
    "U": ("volVectorField", "[0 1 -1 0 0 0 0]"),
    "T": ("volScalarField", "[0 0 0 1 0 0 0]"),
}
FV_SCHEMES = """
fluxScheme Kurganov;
ddtSchemes { default Euler; }
gradSchemes { default Gauss linear; }
divSchemes { default none; div(tauMC) Gauss linear; }
laplacianSchemes { default Gauss linear corrected; }
interpolationSchemes
{
    default linear;
    reconstruct(rho) vanLeer;
    reconstruct(U) vanLeerV;
    reconstruct(T) vanLeer;
}
snGradSchemes { default corrected; }
"""
FV_SOLUTION = """
solvers
{
    "(rho|rhoU|rhoE)" { solver diagonal; }
    "(cellMotionU|cellDisplacement)"
    { solver PCG; preconditioner DIC; tolerance 1e-13; relTol 0; }
}
"""


class PeerCase(FoamCase):

    # The same files and entries as ours
    write = BenchmarkCase.write
    control = BenchmarkCase.control

    def __init__(self, folder, ours):
        self.path, self.ours = folder.resolve(), ours
        for name in ("0", "system"):
            (self.path / name).mkdir(parents=True)
        shutil.copytree(ours.path / "constant", self.path / "constant")
        self.write("constant/turbulenceProperties",
                   "simulationType laminar;\n")
        self.write("system/fvSchemes", FV_SCHEMES)
        self.write("system/fvSolution", FV_SOLUTION)

    def start(self, values, boundary):
        """boundary: as BenchmarkCase.start, without fixed and far."""
        self.cells = len(values["p"])
        types = {name: {} for name in "pUT"}
        for patch, (kind, _) in self.ours.mesh.patches.items():
            kind = kind.split(",")[0]
            chosen = boundary.get(patch, kind) if kind == "patch" else kind
            for field, text in self.ours.boundaryTypes(
                patch, chosen, None
            ).items():
                types[field][patch] = text
        for name, (kind, dimensions) in DIMENSIONS.items():
            patches = "\n".join(
                f"{patch} {{ {text} }}"
                for patch, text in types[name].items())
            self.write(
                f"0/{name}", f"dimensions {dimensions};\n"
                f"internalField {listed(values[name])};\n"
                f"boundaryField\n{{\n{patches}\n}}\n", kind=kind)

    def runTo(self, endTime, program="rhoCentralFoam", timeout=7200,
              **control):
        """Runs to endTime and keeps self.runLog. control: entries of
        controlDict."""
        self.control({
            "stopAt": "endTime", "endTime": endTime,
            # Cut down to the Courant number's in the first step; from a
            # smaller one it would only grow by a fifth per step
            "deltaT": endTime,
            "adjustTimeStep": "yes", "maxCo": PEER_MAX_CO,
            "writeControl": "adjustableRunTime", "writeInterval": endTime,
            **control,
        })
        self.runLog = RunLog(self.run(program, timeout=timeout))

    def cellField(self, name):
        """A field's values in the cells at the last time."""
        return readInternalField(
            self.path / self.times()[-1] / name, self.cells)
