"""Pictures of the tutorials' results.

    plotResults.py history <picture.png> ...    curves over time
    plotResults.py field <picture.png> ...      a field in a plane
    plotResults.py scene <picture.png> ...      a field in space, and the shell

Needs numpy and matplotlib, no display. Reads the case's own files, ASCII or
binary, whole or decomposed. Each command tells its options with --help;
examples are in README.md beside this file.
"""
import argparse
import io
import sys
from pathlib import Path

# Folders of the tutorials hold cases only
sys.dont_write_bytecode = True

import matplotlib  # noqa: E402

matplotlib.use("Agg")

from PIL import Image  # noqa: E402  (matplotlib needs it too)

from plotting import fields, histories, scenes  # noqa: E402
from plotting.errors import PlotError  # noqa: E402
from plotting.foamCase import Case  # noqa: E402

DPI = 110

HISTORY = """\
Curves of files of postProcessing, one panel below the other, with references.

FILE is <function object>/<file> below postProcessing, without the start time
(restarts are joined), or a path. COLUMNS is Y or X:Y, each a column's name or
number; X is the first column when it is not given. A column may be scaled and
shifted: p_0*1e-3-101.325. A third one, X:Y:E, draws error bars.
"""
FIELD = """\
Colours of a field in a plane: of the front of a two-dimensional case (its
empty or wedge patches), of --patch, or of --plane, which cuts cells. On a moved
mesh. FIELD is a point or cell field: p, U (its magnitude) or U.x.
"""
SCENE = """\
Colours of a field on patches and planes in space, and the deformed shell with a
field of its own, seen in parallel perspective.
"""


class InPanel(argparse.Action):
    """Options that belong to the panel begun last."""

    def __call__(self, parser, namespace, values, option=None):
        panels = namespace.panels = namespace.panels or []
        if self.dest == "panel":
            panels.append(histories.Panel(values))
            return
        if not panels:
            panels.append(histories.Panel())
        if self.dest in ("curve", "reference", "band"):
            if not 2 <= len(values):
                parser.error(f"{option} wants FILE COLUMNS [LABEL]")
            panels[-1].curves.append((self.dest, values))
        elif self.dest == "mean":
            panels[-1].means.append(values)
        else:
            setattr(panels[-1], self.dest, values)


class Flag(InPanel):
    def __init__(self, *words, **options):
        super().__init__(*words, nargs=0, **options)

    def __call__(self, parser, namespace, values, option=None):
        super().__call__(parser, namespace, True, option)
        namespace.panels[-1].logarithmic = True


def vector(text):
    numbers = text.strip("() ").split()
    if len(numbers) != 3:
        raise argparse.ArgumentTypeError(f"{text}: wanted '(x y z)'")
    return [float(number) for number in numbers]


def addPicture(parser):
    parser.add_argument("picture", type=Path, help="PNG to write")
    parser.add_argument("--case", default=".", help="folder of the case")
    parser.add_argument("--title", default="")
    parser.add_argument("--size", nargs=2, type=float, metavar=("W", "H"),
                        help=f"of the picture in inches of {DPI} pixels")


def addHistory(parser):
    addPicture(parser)
    parser.set_defaults(panels=None)
    series = dict(nargs="+", action=InPanel, metavar=("FILE", "COLUMNS"))
    parser.add_argument("--panel", action=InPanel, metavar="YLABEL",
                        help="begin a panel; what follows belongs to it")
    parser.add_argument("--curve", help="what is computed: FILE COLUMNS"
                        " [LABEL]", **series)
    parser.add_argument("--reference", help="the same in another style",
                        **series)
    parser.add_argument("--band", help="FILE X:LOWER:UPPER [LABEL]", **series)
    parser.add_argument("--yRange", nargs=2, type=float, action=InPanel,
                        metavar=("LOW", "HIGH"))
    parser.add_argument("--logY", action=Flag)
    parser.add_argument("--mean", nargs=2, type=float, action=InPanel,
                        metavar=("LOW", "HIGH"), help="print the curves' mean"
                        " over this part of the abscissa; may be repeated")
    parser.add_argument("--within", type=float, action=InPanel,
                        metavar="PERCENT", help="exit code 1 when a curve is"
                        " further off the reference given at the same place"
                        " of its panel, in percent of that one's largest value")
    parser.add_argument("--logX", action="store_true")
    parser.add_argument("--xLabel", default="time [s]")
    parser.add_argument("--xRange", nargs=2, type=float,
                        metavar=("LOW", "HIGH"))


def addColours(parser):
    addPicture(parser)
    parser.add_argument("field", help="name of the field")
    parser.add_argument("--time", action="append", metavar="SECONDS|latest",
                        help="of a written time; latest by default")
    parser.add_argument("--range", nargs=2, type=float,
                        metavar=("LOW", "HIGH"), help="of the colours")
    parser.add_argument("--colours", default="turbo",
                        help="a colour map of matplotlib (turbo)")
    parser.add_argument("--scale", type=float, default=1,
                        help="drawn is SCALE*(field - SUBTRACT)")
    parser.add_argument("--subtract", type=float, default=0)
    parser.add_argument("--label", help="of the colours, as 'p [kPa]'")
    parser.add_argument("--timeScale", type=float, default=1)
    parser.add_argument("--timeUnit", default="s")


def addField(parser):
    addColours(parser)
    where = parser.add_mutually_exclusive_group()
    where.add_argument("--plane", nargs=2, type=vector,
                       metavar=("POINT", "NORMAL"),
                       help="cut by a plane, as '(0 0 1)' '(0 0 1)'")
    where.add_argument("--patch", action="append", metavar="NAME",
                       help="a plane patch; may be repeated")
    parser.add_argument("--crop", nargs=4, type=float,
                        metavar=("X0", "X1", "Y0", "Y1"),
                        help="part that is drawn, in the axes' units")
    parser.add_argument("--lengthScale", type=float, default=1)
    parser.add_argument("--lengthUnit", default="m")
    parser.add_argument("--mesh", action="store_true",
                        help="draw the triangles' edges")
    parser.add_argument("--shell", action="store_true",
                        help="draw the shell, from its VTK series")


def addScene(parser):
    addColours(parser)
    parser.add_argument("--patch", action="append", metavar="NAME",
                        default=[], help="may be repeated")
    parser.add_argument("--plane", nargs=2, type=vector, action="append",
                        default=[], metavar=("POINT", "NORMAL"),
                        help="cut by a plane, as '(0 0 1)' '(0 0 1)'; may be"
                        " repeated")
    parser.add_argument("--shell", nargs="?", const="displacement",
                        metavar="FIELD", help="the shell with a field of its"
                        " VTK series (displacement)")
    parser.add_argument("--shellScale", type=float, default=1)
    parser.add_argument("--shellLabel")
    parser.add_argument("--shellRange", nargs=2, type=float,
                        metavar=("LOW", "HIGH"))
    parser.add_argument("--shellColours", default="viridis",
                        help="a colour map (viridis)")
    parser.add_argument("--warp", type=float, default=1,
                        help="the shell's displacement is drawn this many"
                        " times as large")
    parser.add_argument("--view", nargs=2, type=float, default=(25, -60),
                        metavar=("ELEVATION", "AZIMUTH"),
                        help="where the eye is, in degrees; azimuth from x"
                        " (y up: from z; x up: from y)")
    parser.add_argument("--up", choices="xyz", default="z")
    parser.add_argument("--box", nargs=6, type=float, metavar=(
        "X0", "X1", "Y0", "Y1", "Z0", "Z1"), help="part that is drawn [m]")


def parsed(words):
    parser = argparse.ArgumentParser(
        prog="plotResults.py", description=__doc__,
        formatter_class=argparse.RawDescriptionHelpFormatter)
    commands = parser.add_subparsers(dest="command", required=True)
    for name, about, add in (("history", HISTORY, addHistory),
                             ("field", FIELD, addField),
                             ("scene", SCENE, addScene)):
        add(commands.add_parser(
            name, description=about, allow_abbrev=False,
            formatter_class=argparse.RawDescriptionHelpFormatter))
    options = parser.parse_args(words)
    if options.command != "history":
        options.time = options.time or ["latest"]
        for name in {options.colours, vars(options).get("shellColours",
                                                        options.colours)}:
            if name not in matplotlib.colormaps:
                parser.error(f"no colour map {name} in matplotlib; try turbo,"
                             " viridis, coolwarm, inferno")
    elif not options.panels:
        parser.error("history: nothing to draw; give --curve FILE COLUMNS")
    return options


def save(figure, path):
    """As a PNG of 256 colours, a third of the size, for READMEs: the best 240
    of the picture, and greys for text and lines."""
    content = io.BytesIO()
    figure.savefig(content, dpi=DPI, format="png")
    image = Image.open(content).convert("RGB")
    colours = image.quantize(240).getpalette()[:3*240]
    greys = [value for k in range(16) for value in 3*[17*k]]
    palette = Image.new("P", (1, 1))
    palette.putpalette(colours + (3*240 - len(colours))*[255] + greys)
    image.quantize(palette=palette, dither=Image.Dither.NONE).save(
        path, format="PNG", optimize=True)


def drawn(options):
    """(figure, lines for the log)"""
    if options.command == "history":
        figure = histories.draw(
            options.case, options.panels, options.xLabel, options.title,
            options.xRange, options.size, options.logX)
        return figure, histories.figures(options.case, options.panels)
    draw = fields.draw if options.command == "field" else scenes.draw
    return draw(Case(options.case), options)


def main():
    options = parsed(sys.argv[1:])
    try:
        figure, said = drawn(options)
        for line in said:
            print(line)
        save(figure, options.picture)
        print(f"picture: {options.picture}")
        if options.command == "history":
            held = list(histories.deviations(options.case, options.panels))
            for line, _ in held:
                print(line)
            if not all(good for _, good in held):
                sys.exit("plotResults.py: error: a deviation is above its"
                         " bound")
    except (PlotError, OSError) as problem:
        sys.exit(f"plotResults.py: error: {problem}")


if __name__ == "__main__":
    main()
