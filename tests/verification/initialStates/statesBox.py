"""A box of gas whose initial state is set by setPointFields."""
import numpy as np

from gasBox import GAMMA, R, GasBox

HEAD = """FoamFile
{
    version 2.0;
    format ascii;
    class dictionary;
    object setPointFieldsDict;
}
"""
DECOMPOSE = """FoamFile
{
    version 2.0;
    format ascii;
    class dictionary;
    object decomposeParDict;
}
numberOfSubdomains 2;
method simple;
simpleCoeffs { n (%s); delta 0.001; }
"""


class StatesBox(GasBox):
    """Air at 1e5 Pa and 290 K at the start."""

    P, T = 1e5, 290.0

    def __init__(self, folder, sides, cells):
        super().__init__(folder, sides, cells)
        self.start(self.P / (R * self.T), (0, 0, 0), self.P)

    def dictionary(self, text):
        path = self.path / "system" / "setPointFieldsDict"
        path.write_text(HEAD + text)

    def setPointFields(self, text, check=True):
        """The log of setPointFields with these entries of its dictionary."""
        self.dictionary(text)
        self.log = self.run("setPointFields", check=check)
        return self.log

    def setInParallel(self, text, parts):
        """The same on two processors; the fields are reconstructed."""
        self.dictionary(text)
        (self.path / "system" / "decomposeParDict").write_text(
            DECOMPOSE % parts
        )
        self.run("decomposePar")
        self.log = self.runParallel(2, "setPointFields")
        self.run("reconstructPar", "-withZero")
        return self.log

    def gas(self):
        """p, U, T and rho at the points."""
        p, U, T = (self.pointField(name, "0") for name in ("p", "U", "T"))
        return p, U, T, p / (R * T)

    def scene(self, after=-1):
        """(mass, energy) before and after a state, as the log says."""
        line = [s for s in self.log.splitlines() if "scene: mass" in s][after]
        words = line.replace(",", "").split()
        numbers = [float(w) for w in words if w[0].isdigit()]
        return np.array(numbers[0::2]), np.array(numbers[1::2])


def energyDensity(p, U, rho):
    return p / (GAMMA - 1) + 0.5 * rho * (U * U).sum(axis=-1)
