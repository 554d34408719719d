"""Tip displacement of the cantilever over the exact solution: cantilever.png

Prints the largest deviation and ends with exit code 1 when it exceeds 0.5 % of
the exact displacement at the full load.
"""
import sys
from pathlib import Path

import matplotlib.pyplot as plt
import numpy as np

CASE = Path(__file__).resolve().parent
HISTORY = CASE / "postProcessing" / "tip" / "0" / "displacement.dat"
REFERENCE = CASE / "reference" / "sze31_cantilever_end_shear.csv"
BOUND = 0.005


def readReference(path):
    """Columns of the table by name; lines with # are its sources."""
    lines = path.read_text().splitlines()
    table = [line for line in lines if not line.startswith("#")]
    return np.genfromtxt(table, delimiter=",", names=True)


def main():
    load, ux, _, uz = np.loadtxt(HISTORY).T
    table = readReference(REFERENCE)
    fraction = table["P_over_Pmax"]

    deviation = 0
    _, axes = plt.subplots(figsize=(7, 5))
    for values, name, exact, printed, colour in (
        (-ux, "towards the root", "minus_U_exact", "minus_U_tip_Sze", "C0"),
        (uz, "along the force", "W_exact", "W_tip_Sze", "C1"),
    ):
        axes.plot(load, values, colour, label=f"{name}, computed")
        axes.plot(fraction, table[exact], "o", mfc="none", color=colour,
                  label=f"{name}, exact (elastica)")
        axes.plot(fraction, table[printed], "x", color=colour,
                  label=f"{name}, Sze et al. 2004")
        here = np.interp(fraction, load, values)
        deviation = max(
            deviation, abs(here - table[exact]).max() / table[exact][-1]
        )

    axes.set_xlabel("fraction of the end shear force of 4 N/m")
    axes.set_ylabel("tip displacement [m]")
    axes.set_title("Cantilever under end shear")
    axes.grid(alpha=0.3)
    axes.legend(fontsize="small")
    plt.savefig(CASE / "cantilever.png", dpi=150, bbox_inches="tight")

    print(f"largest deviation from the exact tip displacement: "
          f"{100 * deviation:.3f} % of that at the full load")
    print(f"plot: {CASE.name}/cantilever.png")
    if not deviation <= BOUND:
        sys.exit(f"deviation above the bound of {100 * BOUND} %")


if __name__ == "__main__":
    main()
