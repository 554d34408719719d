"""Section forces and moments against an exact solution: a long cylinder with
hinged ends under internal pressure, whose boundary layer bends."""
import numpy as np
import pytest

from shellCase import ShellCase, fixed, isotropic, symmetry
from shellFiles import readGrid
from shellShapes import cylinder

R, H, LENGTH = 1., 0.01, 0.5
E, NU, PRESSURE = 2e11, 0.3, 1e3


def exact(x):
    """Hoop force, moment along the axis and shear force, at the distance x
    from the end.

    source: Timoshenko and Woinowsky-Krieger, Theory of Plates and Shells,
    2nd ed., sections 114-115: the half-infinite cylinder, w = 0 and M = 0 at
    the end, no axial force.
    """
    beta = (3*(1 - NU**2)/(R*H)**2)**0.25
    decay, s, c = np.exp(-beta*x), np.sin(beta*x), np.cos(beta*x)
    return {"N": PRESSURE*R*(1 - decay*c),
            "M": PRESSURE/(2*beta**2)*decay*s,
            "Q": PRESSURE/(2*beta)*decay*(c - s)}


def quarter(folder, n, form):
    """n quadrilaterals along half the length and around; the end at y = 0."""
    mesh = cylinder(n, n, R, LENGTH, 90)
    case = ShellCase(
        folder, mesh, isotropic(E, NU, H),
        {"end": fixed("vMin", "x", "z"), "middle": symmetry("vMax", (0, 1, 0)),
         "left": symmetry("uMin", (1, 0, 0)),
         "right": symmetry("uMax", (0, 0, 1))}, form)
    case.properties.update(vtk="yes", results={
        "fields": "(sectionForces)", "axis": (0, 1, 0)})
    case.solve({"gas": {"type": "followerPressure", "pressure": PRESSURE,
                        "face": "lower"}})
    points, _, data = readGrid(case.case.path/"VTK"/"shell"/"shell_1.vtu")
    return points[:, 1], {
        "N": data["membraneForce"][:, 1], "M": data["bendingMoment"][:, 0],
        "Q": data["shearForce"][:, 0]}


def errors(y, found):
    """Root of the mean square over the nodes, percent of the greatest value.
    """
    result = {}
    for name, value in exact(y).items():
        sign = np.sign((found[name]*value).sum())
        result[name] = 100*np.sqrt(
            np.mean((sign*found[name] - value)**2))/value.max()
    return result


@pytest.mark.parametrize("form, bounds", [
    ("assumedStrain",
     {"N": (3, 0.7, 0.6), "M": (20, 6, 2.5), "Q": (10, 4, 2)}),
    ("displacement",
     {"N": (0.9, 0.7, 0.6), "M": (14, 3, 1.2), "Q": (15, 5.5, 2.2)}),
])
def test_cylinderUnderPressure(tmp_path, table, form, bounds):
    meshes = (4, 8, 12)
    found = [errors(*quarter(tmp_path/str(n), n, form)) for n in meshes]
    for name, quantity in (("N", "hoop force"), ("M", "moment"),
                           ("Q", "shear force")):
        table.below(f"cylinder under pressure, {form}", meshes,
                    f"{quantity}, error [%]",
                    [one[name] for one in found], "Timoshenko", bounds[name])
