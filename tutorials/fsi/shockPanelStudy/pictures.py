"""Histories of displacement and pressure of the studies, one picture a panel
length."""
import matplotlib.pyplot as plt
import numpy as np

TITLES = {
    "twoWay": "two-way", "oneWay": "one-way, and two-way with 1",
    "thick": "2.5 mm thick", "schemes": "schemes",
    "integrators": "shell by energyMomentum",
    "pRef": "shell in ambient pressure from the start (pRef)",
    "asPrinted": "200 steps as printed",
}
COLOURS = plt.get_cmap("tab10").colors


def label(run):
    return f"{run.scheme}, {run.subCycles} x {run.gasStep:g} us{run.variant}"


def drawReference(axes, length, folder):
    """Published displacement, for the panel it belongs to."""
    if length != 50:
        return
    text = (folder / "panel50_tip_disp_sim_giordano.csv").read_text()
    rows = [line.split(",") for line in text.splitlines()
            if line[:1].isdigit()]
    t, u = np.array(rows, dtype=float).T
    inside = t <= axes.get_xlim()[1]
    axes.plot(t[inside], u[inside], ":", color="0.3", lw=1,
              label="Giordano et al., computed")


def pictures(studies, length, folder):
    """Draw; the Markdown lines that show it."""
    drawn = [(name, studies.found(studies.runsOf(name, length)))
             for name in studies.options.study]
    drawn = [(name, runs) for name, runs in drawn if runs]
    figure, grid = plt.subplots(
        len(drawn), 2, figsize=(10, 2.5*len(drawn)), squeeze=False)
    end = 1e3*studies.options.endTime
    for (name, runs), axes in zip(drawn, grid):
        for n, (_, found) in enumerate(runs):
            style = dict(color=COLOURS[n], lw=1, label=label(found.run))
            axes[0].plot(*found.displacement, **style)
            axes[1].plot(*found.pressure, **style)
        for side, quantity in zip(
                axes, ("tip displacement [mm]", "roof pressure [kPa]")):
            side.set(title=TITLES[name], xlabel="time [ms]", ylabel=quantity,
                     xlim=(0, end))
            side.grid(alpha=0.3)
        if name != "thick":
            drawReference(axes[0], length,
                          studies.folder / runs[0][0].name / "reference")
        axes[0].legend(fontsize=6)
    figure.tight_layout()
    folder.mkdir(exist_ok=True)
    path = folder / f"shockPanelStudy{length}.png"
    figure.savefig(path, dpi=60)
    plt.close(figure)
    return [f"\n![histories, {length} mm](pictures/{path.name})"]
