"""The charges, the lines that their waves run on, and the stations."""
import math

from lineRun import Air, Line, Stage

# Charge of 1 kg: scaled distances are the radii
TNT = "sphericalCharge { centre (0 0 0); TNT { mass 1; %s } }"
TNT_AIR = Air()
TNT_STAGES = (
    Stage(Line(3.2, 0.005), 1.3e-3, (0.3, 1.75)),
    Stage(Line(8, 0.01, 0.5, 8, 1.5), 5.2e-3, (1.75, 4.9)),
    Stage(Line(44, 0.02, 1, 32, 3.9), 0.05425, (4.9, 41)),
)
TNT_Z = (0.5, 0.75, 1, 1.25, 1.5, 2, 2.5, 3, 4, 5, 6, 8, 10, 15, 20, 30, 40)

# Radii of the bulb [m/kg^(1/3)] beside that of the charge itself
BULB_RADII = (0.125, 0.25, 0.5)
BULB_Z = (0.75, 1, 1.25, 1.5, 2, 2.5, 3, 4)

# The bursting sphere of the paper's section 5.2
BULB = "sphericalCharge { centre (0 0 0); radius 0.5; p 2967e3; T 1134.85; }"
BULB_AIR = Air(100000.0, 290.36)
BULB_STAGES = (
    Stage(Line(5, 0.005), 2e-3, (0.6, 1.9)),
    Stage(Line(10.5, 0.01, 0.8, 4, 1.7), 9.8e-3, (1.9, 8.5)),
)

# A point source whose energy makes the length d = (E/p0)^(1/3) one metre: a
# sphere of a hundredth of it with the density of the air, so that
# only its radius is not that of a point
POINT_AIR = TNT_AIR
POINT_RADIUS = 0.01


def pointSource():
    volume = 4*math.pi/3*POINT_RADIUS**3
    energy = POINT_AIR.p + POINT_AIR.p*volume/0.4
    return ("sphericalCharge { centre (0 0 0); radius %r; mass %.15g; "
            "energy %.15g; }" % (POINT_RADIUS, POINT_AIR.rho*volume, energy))


POINT_STAGES = (
    Stage(Line(0.5, 0.001), 5.6e-5, (0.05, 0.22)),
    Stage(Line(1.4, 0.002, 0.05, 16, 0.17), 7.9e-4, (0.22, 0.78)),
    Stage(Line(4.6, 0.004, 0.25, 64, 0.6), 4.65e-3, (0.78, 3.4)),
)
