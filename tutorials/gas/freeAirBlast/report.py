"""Tables and the picture of the free-air runs."""
import sys

import numpy as np

from lineRun import PROJECT
from references import Bulb, KingeryBulmash, PointSource
from scenes import BULB_Z, POINT_AIR, TNT_Z

sys.path.insert(0, str(PROJECT / "tests" / "benchmarks" / "common"))
from page import table  # noqa: E402


def percent(ours, reference):
    return 100*(np.asarray(ours)/reference - 1)


def signed(values):
    return [f"{v:+.1f}" for v in values]


def extrapolated(levels, what, r):
    """The limit of first order from the two finest lines, and the finest's
    distance from it in percent. Shocks are a number of cells wide: so the
    peak's error goes with the cell's size."""
    fine = levels[-1].at(what, r)
    limit = 2*fine - levels[-2].at(what, r)
    return limit, percent(fine, limit)


def tntTable(levels, Z=TNT_Z):
    reference = KingeryBulmash()
    Z = np.array(Z, float)
    columns = [[f"{z:g}" for z in Z]]
    head = ["Z"]
    for what, name, unit in (("peak", "peak [kPa]", 1e3),
                             ("arrival", "arrival [ms]", 1e-3),
                             ("impulse", "impulse [Pa s]", 1)):
        kb = reference.at(what, Z)
        ours = levels[-1].at(what, Z)
        head += [name, "K-B", "off [%]"]
        columns += [list(ours/unit), list(kb/unit), signed(percent(ours, kb))]
        if len(levels) > 1:
            limit, error = extrapolated(levels, what, Z)
            head += ["limit off [%]", "line [%]"]
            columns += [signed(percent(limit, kb)), signed(error)]
    return table(head, [[v if isinstance(v, str) else float(v) for v in row]
                        for row in zip(*columns)])


def refinementTable(runs, what, r, reference, name="Z"):
    """runs: spacing factor -> Stations; off the reference in percent."""
    rows = []
    for label, stations in runs.items():
        off = percent(stations.at(what, r), reference)
        rows.append([label] + signed(off))
    return table([name] + [f"{x:g}" for x in r], rows)


def tntRefinement(runs):
    Z = np.array([1, 1.5, 2, 3, 5, 10, 20, 40], float)
    return refinementTable(runs, "peak", Z, KingeryBulmash().at("peak", Z))


def radiusTable(compact, others):
    """others: radius -> Stations, on the same lines as compact."""
    Z = np.array(BULB_Z, float)
    rows = []
    for radius, stations in others.items():
        for what in ("peak", "arrival", "impulse"):
            off = percent(stations.at(what, Z), compact.at(what, Z))
            rows.append([f"{radius:g}", what] + signed(off))
    return table(["R", "of"] + [f"{z:g}" for z in Z], rows)


def bulbTable(levels):
    reference = Bulb()
    rows = []
    for i, r in enumerate(reference.r):
        row = [f"{r:g}"]
        for what, unit in (("peak", 1e3), ("arrival", 1e-3), ("impulse", 1)):
            exact = reference.values[what][i]
            ours = float(levels[-1].at(what, [r])[0])
            row += [ours/unit, float(exact/unit)]
            row += signed([percent(s.at(what, [r])[0], exact) for s in levels])
        rows.append(row)
    offs = [f"off {k + 1}" for k in range(len(levels))]
    return table(
        ["r [m]", "peak [kPa]", "reference"] + offs
        + ["arrival [ms]", "reference"] + offs
        + ["impulse [Pa s]", "reference"] + offs, rows)


def pointTable(levels):
    p, c = POINT_AIR.p, POINT_AIR.c
    rows = []
    for r, peak, arrival in PointSource.PEAKS:
        row = [f"{r:g}"]
        for what, unit, exact in (("peak", p, peak),
                                  ("arrival", 1/c, arrival)):
            ours = [s.at(what, [r])[0]/unit for s in levels]
            row += [float(ours[-1]), exact]
            row += signed([percent(v, exact) for v in ours])
        rows.append(row)
    offs = [f"off {k + 1}" for k in range(len(levels))]
    peaks = table(["r/d", "peak/p0", "exact"] + offs
                  + ["c0 t/d", "exact"] + offs, rows)
    rows = []
    for r, exact in PointSource.IMPULSES:
        ours = [s.at("impulse", [r])[0]*c/p for s in levels]
        rows.append([f"{r:g}", float(ours[-1]), exact]
                    + signed([percent(v, exact) for v in ours]))
    return peaks + "\n\n" + table(
        ["r/d", "impulse c0/(p0 d)", "exact"] + offs, rows)


def picture(stations, file):
    import matplotlib.pyplot as plt
    Z = np.geomspace(0.4, 40, 200)
    reference = KingeryBulmash()
    figure, axes = plt.subplots(1, 3, figsize=(12, 4))
    for one, what, unit, name in zip(
            axes, ("peak", "arrival", "impulse"), (1e3, 1e-3, 1),
            ("peak overpressure [kPa]", "arrival [ms/kg$^{1/3}$]",
             "positive impulse [Pa s/kg$^{1/3}$]")):
        one.loglog(Z, reference.at(what, Z)/unit, "--", color="0.4",
                   label="Kingery-Bulmash")
        one.loglog(Z, stations.at(what, Z)/unit, color="tab:red",
                   label="shockShellFoam")
        one.set(xlabel="Z [m/kg$^{1/3}$]", title=name)
        one.grid(alpha=0.3, which="both")
    axes[0].legend()
    figure.tight_layout()
    figure.savefig(file, dpi=90)
