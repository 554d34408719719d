"""The limit of a quantity on ever finer meshes, and its uncertainty.

Values f of three meshes with cells h1 < h2 < h3 are taken as f0 + C h^p
(Roache 1998, Celik et al. 2008). Between p = 0.5 and 2.5 the limit is f0, and
the uncertainty 1.25 |f1 - f0|, the grid convergence index. Where p is outside,
or the values do not go one way, the three say less: the value is that of the
finest mesh, and the uncertainty three times what first order, the order at
shocks, would have left of the last change; at least the range of the three.
"""
from dataclasses import dataclass

# source: Roache, Verification and Validation in Computational Science and
# Engineering, 1998: safety factors of three meshes and of two
THREE, TWO = 1.25, 3.0
ORDERS = 0.5, 2.5
SHOCK_ORDER = 1


@dataclass(frozen=True)
class Limit:
    value: float
    uncertainty: float
    order: float    # None: not of one order


def observedOrder(h, f):
    """p of f0 + C h^p through three values, finest first; None without."""
    fine, coarse = f[1] - f[0], f[2] - f[1]
    if fine*coarse <= 0:
        return None

    def excess(p):
        return (h[2]**p - h[1]**p)/(h[1]**p - h[0]**p) - coarse/fine

    low, high = 0.01, 10
    if excess(low) > 0 or excess(high) < 0:
        return None
    for _ in range(60):
        middle = 0.5*(low + high)
        low, high = (middle, high) if excess(middle) < 0 else (low, middle)
    return 0.5*(low + high)


def limit(h, f):
    """Of three meshes; h and f with the finest first."""
    p = observedOrder(h, f)
    good = p is not None and ORDERS[0] <= p <= ORDERS[1]
    used = p if good else SHOCK_ORDER
    left = (f[0] - f[1])*h[0]**used/(h[1]**used - h[0]**used)
    if good:
        return Limit(f[0] + left, THREE*abs(left), p)
    return Limit(f[0], max(TWO*abs(left), max(f) - min(f)), None)
