"""Cantilever under end shear through the applications, against the elastica.

Case: tutorials/shell/cantilever. The bound is 0.5 % of the displacement at
each load, plus 1e-4 of that at the full load (the table's last digit).
"""
from pathlib import Path

import numpy as np
import pytest

from foamCase import FoamCase

TUTORIAL = (
    Path(__file__).resolve().parents[3] / "tutorials" / "shell" / "cantilever"
)
TABLE = "sze31_cantilever_end_shear.csv"


@pytest.fixture(scope="module")
def cantilever(tmp_path_factory):
    case = FoamCase(TUTORIAL, tmp_path_factory.mktemp("shell") / "cantilever")
    case.run("blockShell")
    case.log = case.run("positionalShellFoam")
    return case


@pytest.fixture(scope="module")
def table():
    lines = (TUTORIAL / "reference" / TABLE).read_text().splitlines()
    lines = [line for line in lines if not line.startswith("#")]
    return np.genfromtxt(lines, delimiter=",", names=True)


@pytest.mark.parametrize("sign, column, exact", [
    (-1, "displacement_x", "minus_U_exact"),
    (1, "displacement_z", "W_exact"),
])
def test_tip_follows_the_elastica(cantilever, table, sign, column, exact):
    names, rows = cantilever.history("tip/0/displacement.dat")
    np.testing.assert_allclose(rows[:, 0], table["P_over_Pmax"], rtol=1e-9)

    computed = sign*rows[:, names.index(column)]
    error = abs(computed - table[exact])
    assert np.all(error <= 0.005*table[exact] + 1e-4*table[exact][-1])


def test_log_reports_the_step_and_the_energies(cantilever):
    assert "Newton (CHOLMOD LL^T):  Solving for shell" in cantilever.log
    assert "Shell energies [J]" in cantilever.log
    assert cantilever.log.rstrip().endswith("End")


def test_strain_energy_is_the_work_of_the_load(cantilever):
    """Work by the trapezoidal rule over 20 steps: second order in their size,
    so within 1 %; the curve gives the same integral by Simpson's rule."""
    names, rows = cantilever.history("tip/0/displacement.dat")
    load = np.insert(4*rows[:, 0], 0, 0)
    w = np.insert(rows[:, names.index("displacement_z")], 0, 0)
    simpson = 4*w[-1] - (
        (load[2::2] - load[:-2:2])*(w[:-2:2] + 4*w[1::2] + w[2::2])/6
    ).sum()

    energy = float(
        cantilever.log.split("Shell energies [J]")[1].split()[1]
    )
    assert energy == pytest.approx(simpson, rel=1e-3)
