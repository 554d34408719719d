"""Tables of the runs that are there: mesh, time, free field, wall, balances.

    summary.py            prints them
    summary.py -write     and puts them into README.md and doc/verification.md,
                          between their marks

Reads runs/, needs numpy. Deviations are relative to the largest value.
"""
import csv
import re
import sys
from pathlib import Path

import numpy as np

HERE = Path(__file__).resolve().parent
PROJECT = HERE.parents[2]
sys.dont_write_bytecode = True
sys.path.insert(0, str(PROJECT / "tests" / "benchmarks" / "common"))
from page import replaceBetween, table  # noqa: E402

MARK = "explosionWall"
AMBIENT = 1e5
POINTS = ("top, middle", "half height, middle", "top, corner")

# What the log says
CPU = r"ExecutionTime = (\S+) s"
STEPS = r"(\d+) gas steps,"
CLOCK = r"ClockTime = (\S+) s"
PROCESSORS = r"nProcs : (\d+)"
EXTERNAL = r"external work +(\S+)"
MISMATCH = r"\n    mismatch +(\S+)"
MOTION = r"chang\w* the load by about (\S+) %"

# Of the tutorial [s]
DURATION = 20e-3

# Arrival in the reference: 1 kPa of overpressure
THRESHOLD = 1e3


class Run:
    """One folder of runs/, as far as its run has come."""

    def __init__(self, folder):
        self.folder, self.name = folder, folder.name
        log = folder / "log.shockShellFoam"
        self.log = log.read_text(errors="replace") if log.exists() else ""

    @property
    def done(self):
        return self.log.rstrip().endswith("End") or "\nEnd\n" in self.log

    @property
    def coupled(self):
        return "Shell energies" in self.log

    def number(self, pattern):
        """The last match of a pattern with one group, None when there is none."""
        found = re.findall(pattern, self.log)
        return float(found[-1]) if found else None

    def history(self, path):
        """Rows of a file of postProcessing; restarts follow each other."""
        parts = sorted((self.folder / "postProcessing" / path.split("/")[0]).glob(
            "*/" + path.split("/")[1]), key=lambda p: float(p.parent.name))
        return np.vstack([np.loadtxt(part, ndmin=2) for part in parts])

    def displacement(self):
        """Times, and the three points' displacement along x [m]."""
        rows = self.history("wallPoints/displacement.dat")
        return rows[:, 0], rows[:, 1::3]

    def aloneDisplacement(self):
        """The same of the wall without gas; None when it has not been run."""
        files = list((self.folder / "alone" / "postProcessing").glob(
            "wallPoints/*/displacement.dat"))
        if not files:
            return None
        rows = np.loadtxt(files[0])
        return rows[:, 0], rows[:, 1::3]

    def phases(self):
        """Share of the time [%] by phase."""
        return {name: float(share) for name, share in re.findall(
            r"^    ([a-z ]+): \S+ s, (\S+) %$", self.log, re.M)}


def reference():
    """Overpressure peak [Pa] and arrival [s] by radius [m]."""
    with open(HERE / "reference" / "bulb_2967kPa_1D_spherical_stations.csv") as f:
        rows = csv.DictReader(line for line in f if not line.startswith("#"))
        return {
            float(row["r_m"]): (1e3*float(row["dp_peak_richardson_kPa"]),
                                1e-3*float(row["t_arrival_ms"]))
            for row in rows
        }


def crossing(t, p, level):
    """When p first reaches the level, linear between two samples."""
    k = int(np.argmax(p >= level))
    return np.interp(level, p[k - 1:k + 1], t[k - 1:k + 1])


def stations():
    """Distances of the gauge line's points from the bulb's centre [m]."""
    text = (HERE / "system" / "controlDict").read_text()
    line = text[text.index("gaugeLine"):]
    return [float(r) for r in re.findall(r"-\$standOff - (\S+) \}", line)]


def runTable(runs):
    rows = []
    for run in runs:
        share = run.phases()
        rows.append([
            run.name, int(run.number(r"\n    nodes +: (\d+)")),
            int(run.number(r"\n    simplices +: (\d+)")),
            int(run.number(PROCESSORS)),
            int(run.number(STEPS)),
            run.log.count("\nTime = "),
            f"{run.number(CPU):.0f}",
            f"{run.number(CLOCK):.0f}",
            " / ".join(f"{share.get(name, 0):.0f}" for name in (
                "gas", "shell", "mesh motion", "transfer",
                "output and function objects")),
        ])
    return table(["run", "nodes", "tetrahedra", "processors", "gas steps",
                  "steps of the run", "processor time [s]", "clock [s]",
                  "gas / wall / mesh motion / transfer / output [%]"], rows)


def ratioTable(runs):
    """Times over those of the same mesh, by the processor time."""
    byName = {run.name: run for run in runs}
    rows = []
    for name, run in byName.items():
        for suffix, other, words in (
            ("-twoWay", "-gasAlone", "two-way over gas alone"),
            ("-oneWay", "-gasAlone", "one-way over gas alone"),
            ("-noZones", "", "without over with quiescent zones"),
        ):
            base = byName.get(name.removesuffix(suffix) + other)
            if not name.endswith(suffix) or not base:
                continue
            pair = [r.number(CPU) for r in (run, base)]
            steps = [r.number(STEPS) for r in (run, base)]
            if run.number(PROCESSORS) != base.number(PROCESSORS):
                continue
            rows.append([name, words, f"{pair[0]/pair[1]:.2f}",
                         f"{pair[0]/steps[0]/(pair[1]/steps[1]):.2f}"])
    return table(["run", "processor time", "ratio", "of that per gas step"],
                 rows) if rows else ""


def freeFieldTable(runs):
    """Of runs whose steps are those of the gas, so that no peak is missed."""
    known, rows = reference(), []
    for run in runs:
        if not run.name.endswith(("-gasAlone", "-freeField")):
            continue
        values = run.history("gaugeLine/p.dat")
        for k, r in enumerate(stations()):
            t, p = values[:, 0], values[:, 1 + k] - AMBIENT
            peak, arrival = known[r]
            if p.max() < 0.2*peak:
                continue
            rows.append([
                run.name, f"{r:g}", f"{1e-3*p.max():.2f}", f"{1e-3*peak:.2f}",
                f"{100*(p.max()/peak - 1):+.1f}",
                f"{1e3*arrival:.3f}",
                f"{100*(crossing(t, p, 0.5*p.max())/arrival - 1):+.2f}",
                f"{100*(crossing(t, p, THRESHOLD)/arrival - 1):+.2f}",
            ])
    return table(["run", "r [m]", "peak [kPa]", "1D", "off [%]",
                  "arrival, 1D [ms]", "off, half of the peak [%]",
                  "off, 1 kPa [%]"], rows) if rows else ""


def deviation(run, other):
    """Largest difference of the points' displacement over the largest one."""
    t, u = run.displacement()
    tOther, uOther = other.displacement()
    same = t <= tOther[-1]
    return [
        np.abs(u[same, k] - np.interp(t[same], tOther, uOther[:, k])).max()
        / np.abs(uOther[:, k]).max() for k in range(u.shape[1])
    ]


def aloneTable(runs):
    """The wall without gas under the load of a charge, and the coupled one."""
    rows = []
    for run in runs:
        alone = run.aloneDisplacement() if run.coupled else None
        if alone is None:
            continue
        for k, point in enumerate(POINTS):
            row = [run.name, point]
            found = []
            for t, u in (run.displacement(), alone):
                m = np.abs(u[:, k]).argmax()
                found.append(u[m, k])
                row += [f"{1e3*u[m, k]:.3f}", f"{1e3*t[m]:.2f}"]
            rows.append(row + [f"{100*(found[1]/found[0] - 1):+.1f}"])
    return table(["run", "point", "coupled [mm]", "at [ms]",
                  "without gas [mm]", "at [ms]", "off [%]"],
                 rows) if rows else ""


def alike(run, other):
    """Same mesh, or same coupling."""
    one, two = (re.fullmatch(r"(.*)-((?:one|two)Way.*)", r.name).groups()
                for r in (run, other))
    return one[0] == two[0] or one[1] == two[1]


def wallTables(runs):
    coupled = [run for run in runs if run.coupled]
    rows = []
    for run in coupled:
        t, u = run.displacement()
        for k, point in enumerate(POINTS):
            m = np.abs(u[:, k]).argmax()
            rows.append([run.name, point, f"{1e3*u[m, k]:.3f}",
                         f"{1e3*t[m]:.2f}", f"{1e3*u[-1, k]:.3f}"])
    made = [table(["run", "point", "largest displacement [mm]", "at [ms]",
                   "at the end [mm]"], rows)]
    rows = [
        [run.name, other.name] + [f"{100*d:.2f}" for d in deviation(run, other)]
        for k, run in enumerate(coupled) for other in coupled[k + 1:]
        if alike(run, other)
    ]
    if rows:
        made.append(table(["run", "compared with"] + [
            f"{point} [%]" for point in POINTS], rows))
    return made


def balanceTable(runs):
    rows = []
    for run in runs:
        if not run.coupled:
            continue
        work = re.findall(r"work given by the gas (\S+) J, received by the"
                          r" shell (\S+) J", run.log)[-1]
        impulse = re.findall(r"impulse of the gas \((\S+) .*?\) N s, on the"
                             r" shell \((\S+) ", run.log)[-1]
        rows.append([
            run.name, *(f"{float(w):.1f}" for w in work),
            *(f"{float(j):.1f}" for j in impulse),
            f"{forwardImpulse(run):.0f}",
            f"{run.number(EXTERNAL):.1f}",
            f"{run.number(MISMATCH):.1e}",
            f"{run.number(MOTION):.2f}",
        ])
    return table([
        "run", "work of the gas [J]", "on the wall [J]",
        "impulse along x: gas [N s]", "wall [N s]", "its largest [N s]",
        "wall: external work [J]", "energy mismatch [J]",
        "motion in the load [%]"], rows)


def forwardImpulse(run):
    """Largest impulse along x that the wall has had at any time [N s]."""
    path = next((run.folder / "postProcessing" / "interface").glob(
        "*/balance.dat"))
    names = path.read_text().split("\n", 2)[1].lstrip("# ").split()
    column = names.index("impulseShell_x")
    return np.abs(np.loadtxt(path)[:, column]).max()


def frequencyTable(runs):
    rows = []
    for run in runs:
        swing = run.folder / "swing" / "postProcessing" / "wallPoints"
        log = run.folder / "log.positionalShellFoam.modes"
        if not swing.exists() or not log.exists():
            continue
        modes = re.findall(r"^    \d  (\S+)$", log.read_text(), re.M)
        values = np.loadtxt(next(swing.glob("*/displacement.dat")))
        found = frequencies(values[1:, 0], values[1:, 1])
        for k in range(2):
            mode = float(modes[k])
            rows.append([run.name, k + 1, f"{mode:.4f}", f"{found[k]:.4f}",
                         f"{100*(found[k]/mode - 1):+.2f}"])
    return table(["run", "mode", "eigenfrequency [Hz]", "of the motion [Hz]",
                  "off [%]"], rows) if rows else ""


def frequencies(t, u, order=20, every=4):
    """Frequencies in a free vibration, from the subspace of its shifts
    (ESPRIT): no window, no resolution of 1/duration."""
    x, dt = u[::every], every*(t[1] - t[0])
    shifts = np.lib.stride_tricks.sliding_window_view(x, len(x)//2)
    space = np.linalg.svd(shifts.T, full_matrices=False)[0][:, :order]
    z = np.linalg.eigvals(np.linalg.lstsq(
        space[:-1], space[1:], rcond=None)[0])
    amplitude = np.abs(np.linalg.lstsq(
        np.vander(z, len(x), increasing=True).T, x.astype(complex),
        rcond=None)[0])
    f = np.angle(z)/(2*np.pi*dt)
    return sorted(f[(f > 0.5) & (amplitude > 0.01*amplitude.max())])


def farFieldTable(runs):
    """Runs of the same cells, with and without more of them further out."""
    byName = {run.name: run for run in runs}
    rows = []
    for name, near in byName.items():
        wide = byName.get(name.replace("-near", "-wide"))
        if not name.endswith("-near") or wide is None:
            continue
        one, two = (r.history("gaugeLine/p.dat") for r in (near, wide))
        for k, r in enumerate(stations()):
            p = np.interp(one[:, 0], two[:, 0], two[:, 1 + k])
            peak = (p - AMBIENT).max()
            off = 100*np.abs(one[:, 1 + k] - p)/peak
            rows.append([
                name.removesuffix("-near"), f"{r:g}", f"{1e-3*peak:.2f}",
                f"{off[one[:, 0] <= DURATION].max():.2f}", f"{off.max():.2f}",
                f"{1e3*one[-1, 0]:.0f}"])
    return table(["runs", "r [m]", "incident peak [kPa]",
                  "sent back until 20 ms [%]",
                  "largest [%]", "until [ms]"], rows) if rows else ""


def main():
    runs = [run for run in map(Run, sorted((HERE / "runs").glob("*")))
            if run.done and run.name != "meshes"]
    if not runs:
        sys.exit("summary.py: no run in runs/ has ended; ./Allrun makes one")
    far = [run for run in runs if run.name.endswith(("-near", "-wide"))]
    usual = [run for run in runs if run not in far]
    parts = [runTable(runs), ratioTable(usual)]
    for title, made in (
        ("**Free field**", [freeFieldTable(usual)]),
        ("**Far field**", [farFieldTable(far)]),
        ("**Wall**", wallTables(usual) + [balanceTable(usual)]),
        ("**Wall without gas**", [aloneTable(usual)]),
        ("**Frequencies**", [frequencyTable(usual)]),
    ):
        made = [text for text in made if text]
        parts += [title] + made if made else []
    text = "\n\n".join(part for part in parts if part)
    print(text)
    if "-write" in sys.argv[1:]:
        for page in (HERE / "README.md", PROJECT / "doc" / "verification.md"):
            replaceBetween(page, MARK, text)


if __name__ == "__main__":
    main()
