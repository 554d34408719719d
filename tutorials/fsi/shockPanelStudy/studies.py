"""The studies of the paper's sections 4 and 5.1, and what they show."""
from dataclasses import replace

from panelRun import Mesh, Run, largestDifference

# Sub-cycles and gas steps [us] of section 5.1. For 200 sub-cycles it prints
# 0.00625 us: read as 0.625 us here (doc/misprints.md), as printed in its own
# study
STEPS = [(1, 0.5), (5, 0.5), (10, 0.5), (50, 1), (100, 0.5), (200, 0.625)]
AS_PRINTED = [(200, 0.00625)]
THICK = 2.5
AMBIENT = 1e5  # Pa, of the gas at rest

# Largest differences one-way to two-way of the paper [%], by thickness, then
# sub-cycles: displacement, pressure. Where it prints none: None
# source: Suzuki and Sanches, section 5.1 (text to Figs. 10 and 11)
PRINTED = {
    1.0: {1: (17.166, 0.890), 50: (None, 2.470), 200: (22.558, None)},
    2.5: {1: (8.570, 0.422), 50: (7.011, 2.336)},
}

# A step that is to be stable all through a run on a mesh that moves
SAFETY = 0.9


def reference(mesh):
    """The finest run of a panel, which all others are compared with."""
    return Run(mesh, "twoWay", *STEPS[0])


def thick(mesh):
    return Mesh(mesh.length, THICK, mesh.coarser)


def long(of):
    """The long shell steps. In them the trapezoidal rule of Newmark, with
    rotations that are not small, keeps what fast motion the ambient pressure
    starts, which a shell without it (pRef 0) meets all of a sudden."""
    return [*of("twoWay", STEPS[3:]), *of("oneWay", STEPS[3:]),
            *of("predictedMotion", STEPS[3:4]), *of("iterated", STEPS[3:4])]


def runsOf(study, mesh):
    """In the paper's steps; the reference first."""
    def of(scheme, steps, panel=mesh):
        return [Run(panel, scheme, *step) for step in steps]

    some = [STEPS[0], STEPS[3]]
    runs = {
        "twoWay": lambda: of("twoWay", STEPS),
        "oneWay": lambda: of("oneWay", STEPS),
        "thick": lambda: of("twoWay", some, thick(mesh))
        + of("oneWay", some, thick(mesh)),
        "schemes": lambda: of("twoWay", STEPS[2:4])
        + of("predictedMotion", STEPS[2:4]) + of("iterated", STEPS[2:4]),
        "integrators": lambda: [
            replace(run, integrator="energyMomentum") for run in long(of)],
        "pRef": lambda: [replace(run, pRef=AMBIENT) for run in long(of)],
        "asPrinted": lambda: of("twoWay", AS_PRINTED),
    }[study]()
    first = reference(runs[0].mesh)
    return [first] + [run for run in runs if run != first]


USUAL = ("twoWay", "oneWay", "thick", "schemes", "pRef")
STUDIES = (*USUAL, "integrators", "asPrinted")


def stable(run, stableStep):
    """The run, with the largest stable step where its own is not [us]."""
    if run.gasStep <= stableStep:
        return run
    step = float(f"{SAFETY*stableStep:.2g}")
    return replace(run, gasStep=step)


def percent(value):
    return "-" if value is None else f"{value:.3g} %"


def stepWords(run, wanted):
    words = f"{run.gasStep:g}"
    return words if run == wanted else (
        f"{words} (paper {wanted.gasStep:g}, not stable)")


def schemeWords(found):
    words = f"`{found.run.scheme}`"
    if found.run.variant:
        words += f" {found.run.variant[1:]}"
    return words if not found.stopped else (
        f"{words}, stopped after {found.displacement[0][-1]:.3g} ms")


def stops(results):
    """Why runs did not get to the end."""
    return [f"- {found.run.name} stopped: {found.stopped}"
            for found in results if found.stopped]


def costRows(pairs, first):
    """pairs: (run wanted, results)."""
    for wanted, found in pairs:
        time, peak = found.peak
        run = found.run
        yield [
            schemeWords(found), str(run.subCycles), stepWords(run, wanted),
            f"{run.subCycles*run.gasStep:g}", f"{peak:.3f}", f"{time:.3f}",
            percent(100*largestDifference(
                found.displacement, first.displacement)),
            percent(100*largestDifference(found.pressure, first.pressure)),
            f"{found.seconds:.1f}",
            "-" if found.stopped else f"{found.seconds/first.seconds:.2f}",
            percent(found.share["shell"]), percent(found.share["mesh motion"]),
            "-" if found.stopped else f"{first.shell/found.shell:.1f}",
        ]


COST_HEAD = [
    "scheme", "sub-cycles", "gas step [us]", "shell step [us]", "peak [mm]",
    "at [ms]", "displacement", "pressure", "processor time [s]",
    "over the finest's", "shell", "mesh motion", "shell time less [times]",
]

DIFFERENCE_HEAD = [
    "panel [mm]", "scheme", "sub-cycles", "displacement", "paper", "pressure", "paper",
    "peak one-way [mm]", "two-way [mm]", "displacement, same sub-cycles",
    "pressure, same",
]


def differenceRows(found, first):
    """found: results of a panel, from which the one-way ones are taken."""
    twoWay = {(f.run.variant, f.run.subCycles): f for f in found
              if f.run.scheme == "twoWay"}
    for one in found:
        mesh, n = one.run.mesh, one.run.subCycles
        if one.run.scheme != "oneWay":
            continue
        paper = PRINTED[mesh.thickness].get(n, (None, None))

        def both(other):
            return [
                percent(100*largestDifference(
                    getattr(one, name), getattr(other, name)))
                if other else "-" for name in ("displacement", "pressure")]

        u, p = both(first)
        yield [
            f"{mesh.length} x {mesh.thickness:g}", schemeWords(one), str(n),
            u, percent(paper[0]), p, percent(paper[1]), f"{one.peak[1]:.3f}",
            f"{first.peak[1]:.3f}",
            *both(twoWay.get((one.run.variant, n))),
        ]
