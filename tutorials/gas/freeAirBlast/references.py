"""What the runs are compared with."""
import csv
import math
from pathlib import Path

import numpy as np

FOLDER = Path(__file__).resolve().parent / "reference"


def table(name):
    with open(FOLDER / name) as stream:
        return list(csv.DictReader(r for r in stream if not r.startswith("#")))


class KingeryBulmash:
    """Spherical free-air burst of TNT, per kg^(1/3), SI units."""

    NAMES = {"peak": ("Pso", 1e3), "arrival": ("Ta", 1e-3),
             "impulse": ("Iso", 1.0)}

    def __init__(self):
        self.rows = [row for row in table("kingery_bulmash_coefficients.csv")
                     if row["burst"] == "sph"]

    def value(self, what, Z):
        name, unit = self.NAMES[what]
        for row in self.rows:
            if row["quantity"] == name and \
                    float(row["Zmin"]) <= Z <= float(row["Zmax"]):
                U = float(row["K0"]) + float(row["K1"])*math.log10(Z)
                terms = [float(v) for k, v in row.items()
                         if k[0] == "C" and v]
                return unit*10**sum(c*U**i for i, c in enumerate(terms))
        raise ValueError(f"{name} is not given at Z = {Z}")

    def at(self, what, Z):
        return np.array([self.value(what, z) for z in Z])


class Bulb:
    """Converged one-dimensional solution of the bursting sphere."""

    def __init__(self):
        rows = table("bulb_2967kPa_stations.csv")

        def column(name, unit):
            return np.array([unit*float(row[name]) for row in rows])

        self.r = column("r_m", 1)
        self.values = {
            "peak": column("dp_peak_richardson_kPa", 1e3),
            "arrival": column("t_arrival_ms", 1e-3),
            "impulse": column("impulse_Pa_s", 1),
        }


class PointSource:
    """Ideal point source with counter-pressure, spherical, gamma = 1.4."""

    # source: shancock9/blast-ips (MIT), accurate to about 1e-6, spot values:
    # lambda = r/d, overpressure over p0, c0 t/d
    PEAKS = (
        (0.1059, 132.83, 0.003972), (0.1729, 31.335, 0.013354),
        (0.2795, 8.1079, 0.042406), (0.4183, 2.9099, 0.104816),
        (0.6172, 1.2324, 0.228970), (0.9546, 0.54004, 0.489363),
        (1.6390, 0.22447, 1.09193), (3.2157, 0.086087, 2.58480),
    )
    # source: the same; positive impulse times c0/(p0 d)
    IMPULSES = ((0.5, 0.077584), (1.0, 0.043777), (2.0, 0.022506),
                (3.0, 0.015057))
