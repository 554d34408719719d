"""Tables of the refinement of the 50 mm panel."""
import sys

import numpy as np

from motions import Swing, dampedPeriod, oscillator
from panelRun import PROJECT
from refinedRun import KICK, RINGING, followerLoad, shellAlone, theory
from richardson import limit

sys.path.insert(0, str(PROJECT / "tests" / "benchmarks" / "common"))
from page import table  # noqa: E402

QUANTITIES = [
    ("first peak [mm]", lambda s: s.peak and s.peak.value),
    ("its time [ms]", lambda s: s.peak and s.peak.time),
    ("rebound [mm]", lambda s: s.rebound and s.rebound.value),
    ("its time [ms]", lambda s: s.rebound and s.rebound.time),
    ("second peak [mm]", lambda s: s.second and s.second.value),
    ("first period [ms]", lambda s: s.period),
]
NAMES = [name for name, _ in QUANTITIES]

# Beside the computed values: the same quantities
# source: tutorials/fsi/shockPanel50/reference (digitised from Giordano et al.
# 2005; kevinwgy/m2c @aaf7017b ShockedPanelNarkhede/Fine/results/disp.2)
REFERENCES = [
    ("experiment, Giordano et al.", ["6.2 +- 0.4", "1.33", "-3.38", "3.64",
                                     "-", "-"]),
    ("computed, Giordano et al.", ["6.62", "1.38", "-4.89", "2.76", "5.31",
                                   "2.78"]),
    ("computed, M2C, without the step", ["5.845", "1.291", "-4.046", "2.705",
                                         "4.159", "2.579"]),
]


def values(swing):
    return [quantity(swing) for _, quantity in QUANTITIES]


def digits(value):
    return "-" if value is None else f"{value:.3f}"


def relative(value, base):
    return "-" if value is None or base is None else (
        f"{100*(value/base - 1):+.2f} %")


def limits(family):
    """Of each quantity, from the three finest meshes that have it; None
    without."""
    def of(quantity):
        known = [(found.run.cells, quantity(found.swing))
                 for found in reversed(family)
                 if quantity(found.swing) is not None][:3]
        return limit(*zip(*known)) if len(known) == 3 else None

    return [of(quantity) for _, quantity in QUANTITIES]


def familyRows(family):
    for found in family:
        yield [found.run.words, f"{found.nodes}", f"{found.seconds:.0f}",
               *map(digits, values(found.swing))]
    found = limits(family)
    yield ["limit", "", "",
           *("-" if f is None else f"{f.value:.3f} +- {f.uncertainty:.3f}"
             for f in found)]
    yield ["observed order", "", "",
           *("-" if f is None or f.order is None else f"{f.order:.2f}"
             for f in found)]
    for name, published in REFERENCES:
        yield [name, "", "", *published]


def variantRows(family, rest):
    """Changes against the run on the same mesh, of the same tube."""
    of = {found.run.cells: found for found in family}
    noStep = {found.run.cells: found for found in rest
              if found.run.name in ("noStep", "noStepFine")}
    for found in rest:
        run = found.run
        base = of[run.cells]
        if run.base != base.run.base and found is not noStep.get(run.cells):
            base = noStep[run.cells]
        changes = (relative(*pair) for pair in zip(
            values(found.swing), values(base.swing)))
        yield [run.words, f"{run.cells:.3g}", f"{found.nodes}",
               *map(digits, values(found.swing)), *changes]


def periodRows(family, rest, ringing, folder):
    """(words, period [ms]): from theory to the period in the tube."""
    exact = theory()
    yield "plane-strain strip in vacuum, theory", exact
    if ringing:
        case = folder / RINGING
        alone = shellAlone(case, folder / "ringingAlone", KICK, 4.5e-3, 2e-6)
        periods = []
        for words, (t, u) in (
            ("the same, computed (16 divisions, struck lightly)", alone),
            ("in gas at rest of 195 kPa, struck lightly", ringing.tip),
        ):
            # After the kick
            after = t > 0.25
            period, lost = dampedPeriod(t[after], u[after], exact)
            periods.append(period)
            yield f"{words}; loses {100*lost:.1f} % in a period", period
    names = {found.run.name: found for found in rest}
    size = family[0]
    yield "in the tube, first period", size.swing.period
    for words, found in (
        ("linear oscillator of theory's period under this run's load", size),
        ("the same under the load of the one-way run", names.get("oneWay")),
    ):
        if found:
            t, load = found.load
            yield words, Swing.of(t, oscillator(t, load, exact)).period
    t, load = size.load
    small, large = (
        shellAlone(folder / size.run.name, folder / f"alone{name}",
                   followerLoad(t, load, factor), 1e-3*t[-1], 5e-6)
        for name, factor in (("Small", 1e-4), ("Large", 1)))
    for words, (t, u), factor in (
        ("panel alone, uniform pressure with the mean of this run's load",
         large, 1),
        ("the same load on small displacements (a ten-thousandth)", small,
         1e4),
    ):
        swing = Swing.of(t, u*factor)
        peak = swing.peak
        yield (f"{words}; peak {peak.value:.3f} mm at {peak.time:.3f} ms",
               swing.period)


def text(family, rest, ringing, folder):
    """The page's part."""
    words = [
        "Panel of 50 mm, `predictedMotion` with ten gas steps per coupling"
        " step, so that coupling steps go with the cells; limits and their"
        " uncertainty (grid convergence) from the three finest meshes that"
        " have the quantity; the finest go to 2 ms. Cells"
        " in those of `tutorials/fsi/shockPanel50`, whose own run is `twoWay`"
        " on cells 1.\n",
        table(["gas mesh", "nodes", "processor time [s]", *NAMES],
              familyRows(family)),
        "\nThe first period is between the centres of the first two swings to"
        " the same side: parabolas through a period of the second mode, whose"
        " ripple moves the largest values.\n\nVariants, each against the run on"
        " the same mesh that differs in this alone (a stiffer panel without the"
        " step: against that without the step):\n",
        table(["variant", "cells", "nodes", *NAMES,
               *(f"{name.split(' [')[0]}, change" for name in NAMES)],
              variantRows(family, rest)),
    ]
    periods = [(name, period) for name, period
               in periodRows(family, rest, ringing, folder)]
    if np.all([period is not None for _, period in periods]):
        words += [
            "\nThe first period, on the coarsest mesh of the gas:\n",
            table(["", "period [ms]", "from theory"],
                  [[name, digits(period), relative(period, theory())]
                   for name, period in periods]),
        ]
    return "\n".join(words)
