"""Plot a shock-tube panel case over its references and print the key figures.

    plotPanel.py <picture.png>

Run in the case folder. Reads postProcessing and, where they are there, the
files of reference/ (each with its source in its first line).
"""
import csv
import sys
from pathlib import Path

import matplotlib.pyplot as plt
import numpy as np

# Shock of 415.17 m/s from x = -20 mm to the sensor at x = -10 mm
ARRIVAL = 0.02409  # ms


def history(name):
    """Rows of postProcessing/<name>/<start>/<file>, later restarts appended."""
    folder, file = name.split("/")
    parts = sorted(
        Path("postProcessing", folder).glob(f"*/{file}"),
        key=lambda path: float(path.parent.name),
    )
    if not parts:
        sys.exit(f"no postProcessing/{folder}/*/{file}: run the case first")
    return np.vstack([np.loadtxt(part, ndmin=2) for part in parts])


def reference(name):
    """Columns of reference/<name>.csv as arrays, None when it is not there."""
    path = Path("reference", f"{name}.csv")
    if not path.exists():
        return None
    with open(path) as stream:
        rows = csv.DictReader(r for r in stream if not r.startswith("#"))
        table = list(rows)
    return {key: np.array([float(r[key]) for r in table]) for key in table[0]}


def plotDisplacement(axes, tip):
    experiment = reference("panel50_tip_disp_exp_giordano")
    if experiment:
        axes.errorbar(
            experiment["t_ms"], experiment["tip_disp_mm"],
            yerr=experiment["error_bar_mm"], fmt="o", ms=3, color="0.45",
            ecolor="0.8", label="experiment, Giordano et al. 2005",
        )
    computed = reference("panel50_tip_disp_sim_giordano")
    if computed:
        axes.plot(computed["t_ms"], computed["tip_disp_mm"], "-.",
                  color="tab:blue", label="computation, Giordano et al. 2005")
    m2c = reference("panel50_tip_disp_m2c_spots")
    if m2c:
        axes.plot(m2c["t_ms"], m2c["ux_mm"], "s", mfc="none",
                  color="tab:green", label="M2C (no base step): extrema, zeros")
    axes.plot(1e3*tip[:, 0], 1e3*tip[:, 1], color="tab:red",
              label="shockShellFoam")
    axes.set(xlabel="time since the shock was at x = -20 mm [ms]",
             ylabel="tip displacement [mm]")


def plotPressure(axes, sensor):
    experiment = reference("panel50_pressure_exp_giordano")
    if experiment:
        axes.fill_between(experiment["t_ms"], experiment["p_min_kPa"],
                          experiment["p_max_kPa"], color="0.85", lw=0)
        axes.plot(experiment["t_ms"], experiment["p_mean_kPa"], color="0.45",
                  label="experiment, Giordano et al. 2005")
    computed = reference("panel50_pressure_sim_giordano")
    if computed:
        axes.plot(computed["t_ms"], computed["p_mean_kPa"], "-.",
                  color="tab:blue", label="computation, Giordano et al. 2005")
    m2c = reference("panel50_pressure_m2c")
    if m2c:
        axes.plot(m2c["t_ms"] - ARRIVAL, m2c["p_kPa"], "--",
                  color="tab:green", label="M2C (no base step)")
    axes.plot(1e3*sensor[:, 0] - ARRIVAL, 1e-3*sensor[:, 1],
              color="tab:red", label="shockShellFoam")
    axes.set(xlabel="time since the shock passed the sensor [ms]",
             ylabel="pressure at the roof sensor [kPa]")


def printFigures(tip, sensor):
    t, u = 1e3*tip[:, 0], 1e3*tip[:, 1]
    first = u[t < 2].argmax()
    print(f"first peak of the tip: {u[first]:.3f} mm at {t[first]:.3f} ms")
    if t[-1] > 3.5:
        low = np.where(t < 3.5, u, np.inf).argmin()
        print(f"rebound of the tip: {u[low]:.3f} mm at {t[low]:.3f} ms")

    t, p = 1e3*sensor[:, 0] - ARRIVAL, 1e-3*sensor[:, 1]
    for start, end in ((0.03, 0.07), (0.6, 1.3)):
        inside = (t > start) & (t < end)
        if inside.any():
            print(f"sensor, mean of {start} to {end} ms after arrival: "
                  f"{p[inside].mean():.1f} kPa")


def main():
    picture = Path(sys.argv[1])
    tip = history("panelTip/displacement.dat")
    sensor = history("topSensor/p.dat")

    figure, (upper, lower) = plt.subplots(2, 1, figsize=(8, 8))
    plotDisplacement(upper, tip)
    plotPressure(lower, sensor)
    for axes in (upper, lower):
        axes.set_xlim(0, 1.02e3*tip[-1, 0])
        axes.grid(alpha=0.3)
        axes.legend(fontsize=8)
    figure.suptitle(picture.stem)
    figure.tight_layout()
    figure.savefig(picture, dpi=120)

    printFigures(tip, sensor)
    print(f"picture: {picture}")


if __name__ == "__main__":
    main()
