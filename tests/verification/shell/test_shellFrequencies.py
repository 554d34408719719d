"""Frequencies of strips and plates, elements with assumed strains.

n is the number of quadrilaterals per side of the whole plate (along the
strip), two triangles each.
"""
import numpy as np
import pytest

from shellCase import ShellCase, fixed
from shellShapes import plate

E, RHO = 200e9, 8000.
EDGES = {"uMin": "y", "uMax": "y", "vMin": "x", "vMax": "x"}


def section(thickness, nu):
    return {"all": {"thickness": thickness, "material": {
        "type": "SaintVenantKirchhoff", "E": E, "nu": nu, "rho": RHO}}}


def supports(kind):
    """Clamped, free, hard simply supported (S), or clamped on one side."""
    if kind == "SSSS":
        return {edge: fixed(edge, "z", "g" + tangent)
                for edge, tangent in EDGES.items()}
    clamped = {"CCCC": EDGES, "CFFF": ["uMin"], "FFFF": []}[kind]
    return {edge: {"type": "clamped", "nodeSet": edge} for edge in clamped}


def plateFrequencies(folder, n, kind, side, thickness, number):
    """Of bending; a free plate's rigid motions are left out."""
    constraints = supports(kind)
    if kind in ("SSSS", "FFFF"):
        constraints["inPlane"] = fixed("all", "x", "y")
    case = ShellCase(folder, plate(n, n, side, side), section(thickness, 0.3),
                     constraints)
    rigid = 3 if kind == "FFFF" else 0
    unit = np.sqrt(E*thickness**2/12/(1 - 0.09)/RHO)/side**2
    shift = -(0.3*13.5*unit)**2 if rigid else None
    return case.frequencies(number + rigid, shift)[rigid:]


# source: converged Ritz values of Kirchhoff's plate, nu = 0.3: lambda of the
# first and of later modes (SSSS: exact, pi^2 (i^2 + j^2))
KIRCHHOFF = {
    "CFFF": {1: 3.4710, 2: 8.5065, 3: 21.2846, 4: 27.1988},
    "FFFF": {1: 13.4682, 2: 19.5961, 3: 24.2702, 4: 34.8009},
    "CCCC": {1: 35.9852, 2: 73.3938, 4: 108.2165},
    "SSSS": {1: 19.7392, 2: 49.3480, 4: 78.9568},
}


@pytest.mark.parametrize("kind", list(KIRCHHOFF))
def test_thinSquarePlate(tmp_path, table, kind):
    side, thickness, meshes = 1., 1e-3, [2, 4, 6]
    unit = np.sqrt(E*thickness**2/12/(1 - 0.09)/RHO)/side**2/(2*np.pi)
    ours = np.array([
        plateFrequencies(tmp_path/str(n), n, kind, side, thickness, 4)
        for n in meshes])/unit
    for mode, value in KIRCHHOFF[kind].items():
        table.check(
            f"square plate {kind}, t/a 0.001, mode {mode}", meshes,
            "omega a^2 sqrt(rho t/D)", ours[:, mode - 1], value,
            "Ritz, Kirchhoff", (11, 1.5, 0.5))


@pytest.mark.parametrize("name,kind,thickness,values", [
    # source: NAFEMS selected benchmarks FV12 and FV52, as in Krysl, FinEtools
    ("FV12", "FFFF", 0.05, {1: 1.622, 2: 2.360, 3: 2.922, 4: 4.190}),
    ("FV52", "SSSS", 1.0, {1: 45.897, 2: 109.44, 4: 167.89}),
])
def test_plateOfNafems(tmp_path, table, name, kind, thickness, values):
    meshes = [2, 4, 6]
    ours = np.array([
        plateFrequencies(tmp_path/str(n), n, kind, 10., thickness, 4)
        for n in meshes])
    for mode, value in values.items():
        table.check(
            f"plate {name} of NAFEMS, mode {mode}", meshes, "frequency [Hz]",
            ours[:, mode - 1], value, "NAFEMS; Krysl", (8, 1, 1))


def test_clampedStrip(tmp_path, table):
    """Plane strain, L/h = 100."""
    L, h, nu, meshes = 10., 0.1, 0.3, [2, 4, 8]
    wave = np.sqrt(E/(1 - nu**2)*h**2/12/RHO)/L**2/(2*np.pi)
    ours = []
    for n in meshes:
        case = ShellCase(
            tmp_path/str(n), plate(n, 1, L, 1.), section(h, nu),
            {"root": {"type": "clamped", "nodeSet": "uMin"},
             "strip": {"type": "planeStrainStrip", "direction": (0, 1, 0)}})
        ours.append(np.sqrt(np.array(case.frequencies(3))/wave))
    # source: roots of cos x cosh x = -1
    roots = (1.8751041, 4.6940911, 7.8547574)
    for mode, (root, bound) in enumerate(zip(roots, (0.1, 0.2, 0.3))):
        table.check(
            f"clamped strip, mode {mode + 1}", meshes,
            "root of the frequency", np.array(ours)[:, mode], root,
            "beam theory", (5, 0.5, bound))
