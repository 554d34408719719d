"""Mid-surfaces of the benchmarks."""
import numpy as np

from shellCase import Surface


def stacked(*components):
    return np.stack(np.broadcast_arrays(*components), axis=-1)


def plate(nU, nV, a=1., b=1.):
    return Surface(
        nU, nV,
        lambda u, v: stacked(a*u, b*v, 0*u),
        lambda u, v: stacked(0*u, 0*u, 1 + 0*u))


def skewPlate(n, side, degrees):
    """Rhombus with the given angle between its sides."""
    c, s = np.cos(np.radians(degrees)), np.sin(np.radians(degrees))
    return Surface(
        n, n,
        lambda u, v: side*stacked(u + c*v, s*v, 0*u),
        lambda u, v: stacked(0*u, 0*u, 1 + 0*u))


def annulus(nU, nV, inner, outer, degrees):
    """Plane ring sector, angle u from the x-axis, radius v."""
    def position(u, v):
        angle, r = np.radians(degrees)*u, inner + (outer - inner)*v
        return stacked(r*np.cos(angle), r*np.sin(angle), 0*u)
    return Surface(nU, nV, position,
                   lambda u, v: stacked(0*u, 0*u, -1 + 0*u))


def cylinder(nU, nV, radius, length, degrees):
    """Angle u from the z-axis towards x, axis along y (v)."""
    def normal(u, v):
        angle = np.radians(degrees)*u
        return stacked(np.sin(angle), 0*u, np.cos(angle))
    return Surface(
        nU, nV,
        lambda u, v: radius*normal(u, v) + stacked(0*u, length*v, 0*u),
        normal)


def sphere(n, radius, degrees):
    """Octant from the equator (v = 0) to a latitude, longitude u."""
    def normal(u, v):
        a, b = np.pi/2*u, np.radians(degrees)*v
        return stacked(np.cos(b)*np.cos(a), np.cos(b)*np.sin(a), np.sin(b))
    return Surface(n, n, lambda u, v: radius*normal(u, v), normal)


def twistedBeam(nU, nV, length=12., width=1.1):
    """Along x, turned by 90 degrees from end to end."""
    k = np.pi/2/length

    def across(u):
        return stacked(0*u, np.cos(k*length*u), np.sin(k*length*u))

    def normal(u, v):
        y = width*(v - 0.5)
        along = stacked(1 + 0*u, -y*k*np.sin(k*length*u),
                        y*k*np.cos(k*length*u))
        n = np.cross(along, across(u))
        return n/np.linalg.norm(n, axis=-1, keepdims=True)

    def position(u, v):
        return (stacked(length*u, 0*u, 0*u)
                + (width*(v - 0.5))[..., None]*across(u))

    return Surface(nU, nV, position, normal)
