"""The gas settings of all benchmarks, in one place."""

# The numerical scheme: the defaults, which a user gets who says nothing
CAPTURING = "\nshockCapturing  fluxCorrected;\n"
NAME = "`twoStep`, `fluxCorrected`"
NAME_SMOOTH = "`twoStep`, lumped, `none`"

# The application's default Courant number
MAX_CO = 0.8


def scheme(capturing=True):
    """Entries of system/feSchemes.

    capturing: with shock capturing; smooth flow is also run without, to see
    the order of the time scheme.
    """
    chosen = CAPTURING if capturing else "\nshockCapturing  none;\n"
    return "timeScheme      twoStep;\n" + chosen


def schemeName(capturing=True):
    return NAME if capturing else NAME_SMOOTH
