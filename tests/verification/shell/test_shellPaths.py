"""Paths through limit points by arc length: the hinged cylindrical roof of
Sze, Liu and Lo (2004), 3.8. Elements with assumed strains; n is the number of
quadrilaterals per side of a quarter, two triangles each.
"""
import numpy as np
import pytest

from shellCase import ShellCase, Surface, force, isotropic, symmetry
from shellShapes import stacked


def roof(n):
    """A quarter: along the axis from the middle, from the crown to the hinge.
    """
    def normal(u, v):
        return stacked(0*u, np.sin(0.1*v), np.cos(0.1*v))
    return Surface(n, n, lambda u, v: 2540*normal(u, v)
                   + stacked(254*u, 0*u, 0*u), normal)


def path(folder, n, thickness, first, steps, growth):
    """Deflections of the middle and loads over 3000."""
    case = ShellCase(folder, roof(n), isotropic(3102.75, 0.3, thickness),
                     {"x": symmetry("uMin", (1, 0, 0)),
                      "y": symmetry("vMin", (0, 1, 0)),
                      "hinge": {"type": "hinged", "nodeSet": "vMax"}})
    loads, u = case.path({"crown": force("uMinvMin", (0, 0, -750))}, first,
                         steps, [(0, 0, 2540)], maxGrowth=growth)
    return -u[:, 0, 2], loads


def turningLoad(w, p, sign, range):
    """Greatest (least: sign -1) load in a range of deflections, by the
    parabola through three points of the path."""
    inside = [k for k in np.arange(1, len(w) - 1)
              if range[0] < w[k] < range[1]]
    k = max(inside, key=lambda k: sign*p[k])
    slope, bend = (p[k + 1] - p[k - 1])/2, p[k + 1] - 2*p[k] + p[k - 1]
    return p[k] - slope**2/2/bend


@pytest.mark.parametrize("thickness,first,steps,growth,limits", [
    # source: Sze, Liu and Lo (2004), 16 x 16, as in MBDyn's sze38_ref_*.dat
    (12.7, 0.1, 40, 1.5, ((1, (8, 14), 0.7421), (-1, (16, 23), 0.1729))),
    (6.35, 0.05, 60, 1, ((1, (10, 15), 0.1953), (-1, (14, 19), -0.1288))),
])
def test_hingedRoof(tmp_path, table, thickness, first, steps, growth, limits):
    meshes = [2, 4, 5]
    paths = [path(tmp_path/str(n), n, thickness, first, steps, growth)
             for n in meshes]
    for sign, range, value in limits:
        ours = [turningLoad(w, p, sign, range) for w, p in paths]
        table.check(
            f"hinged roof, h {thickness}, " + ("limit" if sign > 0 else "least")
            + " load over 3000", meshes, "load", ours, value, "Sze 3.8",
            (15, 1, 1))
    assert max(p[-1] for _, p in paths) > 0.9
