"""Curves over time, or over anything else, one panel below the other."""
from dataclasses import dataclass, field

import matplotlib.pyplot as plt
import numpy as np

from plotting.errors import PlotError
from plotting.tables import history

# Styles of references, beside the solid lines of what is computed
REFERENCES = (
    dict(ls="none", marker="o", ms=4, mfc="none", color="0.35"),
    dict(ls="-.", color="0.2", lw=1),
    dict(ls="none", marker="s", ms=4, mfc="none", color="tab:green"),
    dict(ls="--", color="tab:green", lw=1),
    dict(ls="none", marker="x", ms=4, color="tab:purple"),
    dict(ls=":", color="tab:purple", lw=1.5),
)


@dataclass
class Panel:
    label: str = ""
    curves: list = field(default_factory=list)   # (style, words)
    yRange: tuple = None
    logarithmic: bool = False
    means: list = field(default_factory=list)    # (low, high) of x
    within: float = None                         # percent

    def of(self, kind):
        return [words for k, words in self.curves if k == kind]


def columns(case, words):
    """(columns, label) of FILE [X:]Y[:MORE] [LABEL]."""
    file, wanted, *label = words
    table = history(case, file)
    names = wanted.split(":")
    if len(names) == 1:
        names = ["0"] + names
    return ([table.column(name) for name in names],
            " ".join(label) or f"{file} {names[1]}")


def drawPanel(axes, case, panel):
    used = {"curve": 0, "reference": 0}
    for kind, words in panel.curves:
        values, label = columns(case, words)
        if len(values) > 3:
            raise PlotError(f"{' '.join(words)}: more than three columns")
        if kind == "band":
            if len(values) != 3:
                raise PlotError("--band wants X:LOWER:UPPER")
            axes.fill_between(*values, color="0.85", lw=0, label=label)
            continue
        style = (dict(color=f"C{used[kind]}", lw=1.5) if kind == "curve"
                 else REFERENCES[used[kind] % len(REFERENCES)])
        used[kind] += 1
        axes.errorbar(*values[:2], yerr=None if len(values) == 2 else values[2],
                      ecolor="0.8", label=label,
                      markevery=max(1, len(values[0])//50),
                      zorder=3 if kind == "curve" else 2, **style)
    axes.set_ylabel(panel.label)
    if panel.logarithmic:
        axes.set_yscale("log")
    if panel.yRange:
        axes.set_ylim(panel.yRange)
    axes.grid(alpha=0.3)
    axes.legend(fontsize=8)


def draw(case, panels, xLabel="time [s]", title="", xRange=None, size=None,
         logarithmicX=False):
    """A figure with the panels; the caller saves it."""
    size = size or (8, 1.2 + 3.2*len(panels))
    figure, rows = plt.subplots(len(panels), 1, figsize=size, squeeze=False,
                                sharex=xRange is None and len(panels) > 1)
    for axes, panel in zip(rows[:, 0], panels):
        if not panel.curves:
            raise PlotError("a panel without --curve, --reference or --band")
        drawPanel(axes, case, panel)
        if logarithmicX:
            axes.set_xscale("log")
        if xRange:
            axes.set_xlim(xRange)
    rows[-1, 0].set_xlabel(xLabel)
    figure.suptitle(title)
    figure.tight_layout()
    return figure


def figures(case, panels):
    """Lines with extrema and means of what is computed, for the log."""
    for panel in panels:
        for words in panel.of("curve"):
            (x, y, *_), label = columns(case, words)
            if np.isnan(y).all():
                raise PlotError(f"{' '.join(words)}: no numbers in the column")
            low, high = np.nanargmin(y), np.nanargmax(y)
            yield (f"{label}: smallest {y[low]:.6g} at {x[low]:.6g}, largest"
                   f" {y[high]:.6g} at {x[high]:.6g}, last {y[-1]:.6g}")
            for start, end in panel.means:
                inside = (x >= start) & (x <= end)
                if inside.any():
                    yield (f"{label}: mean of {start:g} to {end:g}:"
                           f" {np.nanmean(y[inside]):.6g}")


def deviations(case, panels):
    """(line for the log, is it within the bound?) of each curve and the
    reference given at the same place of its panel: the largest difference at
    the reference's abscissas over the largest value of the reference."""
    for panel in panels:
        if panel.within is None:
            continue
        pairs = list(zip(panel.of("curve"), panel.of("reference")))
        if not pairs:
            raise PlotError("--within wants a --curve and a --reference in its"
                            " panel")
        for curve, reference in pairs:
            (x, y, *_), label = columns(case, curve)
            (at, exact, *_), other = columns(case, reference)
            inside = (at >= x.min()) & (at <= x.max())
            if not inside.any():
                raise PlotError(f"{label}: nothing of it where {other} is")
            there = np.interp(at[inside], x, y)
            off = 100*abs(there - exact[inside]).max()/abs(exact).max()
            yield (f"{label}: largest deviation from {other}: {off:.3g} %"
                   f" (bound {panel.within:g} %)", off <= panel.within)
