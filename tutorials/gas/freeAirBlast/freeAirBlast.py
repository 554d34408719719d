"""Free-air blast against Kingery-Bulmash, a bursting sphere and the point source.

    Allrun [-quick] [-levels <n>] [-runs <folder>] [-page <file> | -noPage]

  -quick    the coarsest lines, TNT up to Z = 4.9 and the bursting sphere only;
            some seconds, nothing is written into the page
  -levels   lines: each level halves the cells of the one before; default 3
  -runs     folder of the runs, default runs
  -page     default doc/verification.md, between the marks freeAirBlast; the
            picture goes to pictures/ beside it
  -noPage   print only
"""
import argparse
import sys
import time
from pathlib import Path

import report
from lineRun import HERE, PROJECT, runStages
from references import KingeryBulmash
from scenes import (
    BULB, BULB_AIR, BULB_RADII, BULB_STAGES, POINT_AIR, POINT_STAGES, TNT,
    TNT_AIR, TNT_STAGES, TNT_Z, pointSource,
)

sys.path.insert(0, str(PROJECT / "tests" / "benchmarks" / "common"))
from page import expectMarks, replaceBetween  # noqa: E402

MARK = "freeAirBlast"


def options(words):
    parser = argparse.ArgumentParser(
        prog="Allrun", usage=__doc__, allow_abbrev=False, add_help=False)
    parser.add_argument("-h", "-help", action="store_true")
    parser.add_argument("-quick", action="store_true")
    parser.add_argument("-levels", type=int, choices=(2, 3, 4), default=3)
    parser.add_argument("-runs", type=Path, default=HERE / "runs")
    parser.add_argument("-page", type=Path,
                        default=PROJECT / "doc" / "verification.md")
    parser.add_argument("-noPage", action="store_true")
    found = parser.parse_args(words)
    if found.h:
        print(__doc__)
        sys.exit()
    if found.noPage or found.quick:
        found.page = None
    return found


def levels(folder, name, air, charge, stages, count):
    """Stations on lines that become finer; level 1 is that of scenes.py."""
    found = []
    for level in range(count):
        began = time.time()
        found.append(runStages(folder / f"{name}{level + 1}", air, charge,
                               stages, 2**level))
        print(f"{name}, level {level + 1}: {time.time() - began:.1f} s",
              flush=True)
    return found


def quick(folder):
    """TNT on the first two lines and the bulb: Stations of both."""
    tnt = levels(folder, "TNT", TNT_AIR, TNT % "", TNT_STAGES[:2], 1)
    bulb = levels(folder, "bulb", BULB_AIR, BULB, BULB_STAGES, 1)
    return tnt[0], bulb[0]


def validity(tnt):
    """The sentence on where the charge may be used."""
    Z = [z for z in TNT_Z if z >= 1.5]
    kb = KingeryBulmash()
    off = {}
    for what in ("peak", "arrival", "impulse"):
        limit, _ = report.extrapolated(tnt, what, Z)
        values = report.percent(limit, kb.at(what, Z))
        off[what] = f"{values.min():+.0f} to {values.max():+.0f} %"
    return (
        "**Validity.** For Z from 1.5 to 40 m/kg^(1/3) the limit of the lines "
        f"is off Kingery-Bulmash by {off['peak']} in the peak overpressure, "
        f"{off['arrival']} in the arrival and {off['impulse']} in the positive "
        "impulse. Below the distance that the log of `setPointFields` names "
        "(1.25 here) nothing is promised.")


def study(chosen):
    folder, count = chosen.runs.resolve(), chosen.levels
    tnt = levels(folder, "TNT", TNT_AIR, TNT % "", TNT_STAGES, count)
    wide = {
        radius: runStages(folder / f"R{radius:g}", TNT_AIR,
                          TNT % f"radius {radius};", TNT_STAGES[:2], 2)
        for radius in BULB_RADII
    }
    bulb = levels(folder, "bulb", BULB_AIR, BULB, BULB_STAGES, count)
    point = levels(folder, "point", POINT_AIR, pointSource(), POINT_STAGES,
                   count)
    return tnt, wide, bulb, point


def text(tnt, wide, bulb, point):
    labels = [f"level {i + 1}" for i in range(len(tnt))]
    return "\n\n".join([
        validity(tnt),
        "1 kg of TNT in air of 101 325 Pa and 288.15 K, on the finest line; "
        "`limit off`: the limit of first order from the two finest lines, "
        "`line`: what the finest line lacks of it.",
        report.tntTable(tnt),
        "Refinement, peak overpressure off Kingery-Bulmash in percent:",
        report.tntRefinement(dict(zip(labels, tnt))),
        "Larger bulbs (radius `R` [m/kg^(1/3)]), off the bulb of the charge's "
        "own radius in percent, on lines of level 2:",
        report.radiusTable(tnt[1], wide),
        "The bursting sphere of the paper's section 5.2 against its converged "
        "one-dimensional solution (of another program), `off` in percent at "
        "each level:",
        report.bulbTable(bulb),
        "The ideal point source with counter-pressure, d = (E/p0)^(1/3), as a "
        "sphere of 0.01 d, `off` in percent at each level:",
        report.pointTable(point),
        "![Free-air blast](pictures/freeAirBlast.png)",
    ])


def main(words):
    chosen = options(words)
    expectMarks(chosen.page, MARK)
    if chosen.quick:
        tnt, bulb = quick(chosen.runs.resolve())
        print(report.tntTable([tnt], [z for z in TNT_Z if z < 4.9]))
        print(report.bulbTable([bulb]))
        return
    results = study(chosen)
    page = text(*results)
    print(page)
    picture = HERE / "freeAirBlast.png"
    if chosen.page:
        replaceBetween(chosen.page, MARK, page)
        picture = chosen.page.parent / "pictures" / "freeAirBlast.png"
    report.picture(results[0][-1], picture)
    print(f"picture: {picture}")


if __name__ == "__main__":
    main(sys.argv[1:])
