"""The gas settings of all benchmarks, in one place."""

# The numerical scheme: the defaults, which a user gets who says nothing
TIME_SCHEME = "twoStep"
SHOCK_CAPTURING = "fluxCorrected"
NAME = f"`{TIME_SCHEME}`, `{SHOCK_CAPTURING}`"
NAME_SMOOTH = f"`{TIME_SCHEME}`, lumped, `none`"

# The application's default Courant number
MAX_CO = 0.8

# Courant number of OpenFOAM's rhoCentralFoam in the benchmarks beside it.
# source: tutorials/compressible/rhoCentralFoam of OpenFOAM v1912
PEER_MAX_CO = 0.2


def entries(timeScheme, shockCapturing, massMatrix=None):
    """Entries of system/feSchemes; massMatrix: the default without."""
    mass = "" if massMatrix is None else \
        f"{timeScheme}Coeffs {{ massMatrix {massMatrix}; }}\n"
    return (f"timeScheme      {timeScheme};\n{mass}\n"
            f"shockCapturing  {shockCapturing};\n")


def scheme(capturing=True):
    """Entries of system/feSchemes.

    capturing: with shock capturing; smooth flow is also run without, to see
    the order of the time scheme.
    """
    return entries(TIME_SCHEME, SHOCK_CAPTURING if capturing else "none")


def schemeName(capturing=True):
    return NAME if capturing else NAME_SMOOTH


# What can be combined: (timeScheme, shockCapturing, massMatrix), the latter for
# twoStep only
COMBINATIONS = [
    ("twoStep", capturing, mass)
    for mass in ("lumped", "consistent")
    for capturing in ("none", "pressureSwitch", "pressureLaplacian",
                      "fluxCorrected")
] + [
    ("threeStep", capturing, None)
    for capturing in ("none", "pressureSwitch", "pressureLaplacian")
]
DEFAULT = (TIME_SCHEME, SHOCK_CAPTURING, None)
CHEAPEST = ("twoStep", "pressureSwitch", "lumped")
