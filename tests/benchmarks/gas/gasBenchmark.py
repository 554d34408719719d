r"""Processor time of the gas per node and step and per simplex and step.

    tests/benchmarks/gas/run [<nodes> ...] [-quick] [-repeat <n>]
        [-peerUpTo <nodes>] [-page <file>] [-noPage]

For each scheme, on meshes of tetrahedra at rest and moving, beside OpenFOAM's
rhoCentralFoam (rhoCentralDyMFoam when they move) on the same polyMesh, the
default scheme beside rhoCentralFoam on hexahedra as well, and beside the
memory bandwidth. Writes the tables into the page, by default
doc/performance.md.

    <nodes>       sizes of the meshes, default 50000 400000
    -quick        a tiny mesh, only to see that everything works; no page
                  unless it is named
    -repeat <n>   median of n runs, default 3
    -peerUpTo <nodes>   no run of the peer on larger meshes (on tetrahedra it
                  takes about 16 kB of memory per node), default 400000
    -page <file>  another page
    -noPage       print only
"""
import sys
import tempfile
from pathlib import Path

HERE = Path(__file__).resolve().parent
PROJECT = HERE.parents[2]
sys.path[:0] = [str(PROJECT / "tests" / folder) for folder in (
    "tools", "verification/gasBenchmarks", "benchmarks/common",
    "benchmarks/gas")]

from machine import MissingProgram, bandwidth, facts, load, need  # noqa: E402
from options import Parser  # noqa: E402
from page import NoMarks, expectMarks, replaceBetween, table  # noqa: E402
from scheme import CHEAPEST, COMBINATIONS, DEFAULT  # noqa: E402
from stepCosts import UnitCube  # noqa: E402

PEERS = {False: "rhoCentralFoam", True: "rhoCentralDyMFoam"}
MOTION = {False: "at rest", True: "moving"}


def parsed(words):
    parser = Parser(__doc__)
    parser.add_argument("sizes", nargs="*", type=int, metavar="nodes")
    parser.add_argument("-peerUpTo", type=int, default=400000)
    options = parser.parse(words, repeat=3)
    parser.choosePage(options, usual=True)
    options.sizes = sorted(options.sizes) or (
        [300] if options.quick else [50000, 400000])
    options.schemes = [DEFAULT, *(
        [CHEAPEST, COMBINATIONS[-1]] if options.quick else COMBINATIONS)]
    return options


def name(scheme):
    time, capturing, mass = scheme
    words = f"`{time}`, " + (f"{mass}, " if mass else "") + f"`{capturing}`"
    return words + (" (default)" if scheme == DEFAULT else "")


class Results:
    """Microseconds per step; keys are sizes."""

    def __init__(self, options):
        self.options = options
        self.nodes = {}
        self.ours = {}      # (scheme, moving, size): per node, per simplex
        self.peer = {}      # (moving, size): per node, per cell
        self.hexahedra = {}  # size: cells, ours per node, peer per cell

    def steps(self, unknowns, seconds):
        """Enough of them for a second or more of ours, at `seconds` each."""
        if self.options.quick:
            return 4
        return max(12, round(1.5 / (seconds * unknowns)))

    def tetrahedra(self, size, folder):
        cube = UnitCube(folder, round(size**(1 / 3)) - 1)
        self.nodes[size] = cube.nodes
        repeat = self.options.repeat
        for moving in (False, True):
            steps = self.steps(cube.nodes, 5e-7 if moving else 1e-7)
            for scheme in self.options.schemes:
                costs = cube.ours(scheme, moving, steps, repeat)
                self.ours[scheme, moving, size] = costs
                print(f"{cube.nodes:>9,} nodes {MOTION[moving]:8}"
                      f" {name(scheme):52} {costs[0]:8.3f} us/node"
                      f" {costs[1]:8.3f} us/simplex", flush=True)
            if size <= self.options.peerUpTo:
                cost = cube.peer(moving, self.steps(cube.cells, 1e-6), repeat)
                each = cost * cube.cells / cube.nodes
                self.peer[moving, size] = each, cost
                print(f"{cube.nodes:>9,} nodes {MOTION[moving]:8}"
                      f" {PEERS[moving]:52} {each:8.3f} us/node"
                      f" {cost:8.3f} us/cell", flush=True)

    def cubes(self, size, folder):
        """Hexahedra, as many as the tetrahedra have nodes."""
        cube = UnitCube(folder, round(size**(1 / 3)) - 1, cut=False)
        repeat = self.options.repeat
        ours, _ = cube.ours(
            DEFAULT, False, self.steps(cube.nodes, 2e-7), repeat)
        peer = cube.peer(False, self.steps(cube.cells, 1e-6), repeat)
        self.hexahedra[size] = cube.cells, ours, peer
        print(f"{cube.cells:>9,} hexahedra: {name(DEFAULT)}"
              f" {ours:.3f} us/node, {PEERS[False]} {peer:.3f} us/cell",
              flush=True)

    # Tables

    def schemes(self, moving):
        head = [f"mesh {MOTION[moving]}"]
        for size in self.options.sizes:
            head += [f"{self.nodes[size]:,} nodes: us per node and step",
                     "per simplex (cell) and step"]
        rows = []
        for scheme in self.options.schemes:
            rows.append([name(scheme)] + [
                cost for size in self.options.sizes
                for cost in self.ours[scheme, moving, size]])
        rows.append([PEERS[moving]] + [
            cost for size in self.options.sizes
            for cost in self.peer.get((moving, size), ("", ""))])
        return table(head, rows)

    def onHexahedra(self):
        rows = []
        for size, (cells, ours, peer) in self.hexahedra.items():
            onTets = self.ours[DEFAULT, False, size][0]
            rows.append((cells, peer, ours, peer / ours, onTets,
                         peer / onTets))
        return table(
            ("cells", f"{PEERS[False]}, us per cell and step",
             "default on the same mesh, us per node and step", "ratio",
             "default on tetrahedra with as many nodes", "ratio"), rows)

    def flat(self):
        first, *_, last = self.options.sizes
        return table(
            ("cost per node, largest mesh over smallest",
             f"{self.nodes[last]:,} over {self.nodes[first]:,} nodes"),
            [(name(s), self.ours[s, False, last][0]
              / self.ours[s, False, first][0])
             for s in (DEFAULT, CHEAPEST)])

    def report(self, memory):
        o = self.options
        size = o.sizes[-1]
        moved = ", ".join(
            f"{name(s)} {self.ours[s, False, size][0] * memory:.1f} kB"
            for s in (CHEAPEST, DEFAULT))
        parts = [
            f"{facts()}; median of {o.repeat} run(s); load of the machine at"
            f" the end {load():.1f}. Memory bandwidth of one core in this run"
            f" (triad): {memory:.1f} GB/s, so that the time per node and step"
            f" on the largest mesh is worth, in memory traffic: {moved}.",
            self.schemes(False), self.schemes(True), self.onHexahedra()]
        if len(o.sizes) > 1:
            parts.append(self.flat())
        return "\n\n".join(parts)


def main(words):
    options = parsed(words)
    results = Results(options)
    try:
        expectMarks(options.page, "gas")
        need("shockShellFoam", "blockMesh", *PEERS.values())
        with tempfile.TemporaryDirectory() as folder:
            memory = bandwidth(Path(folder))
            print(f"memory bandwidth {memory:.1f} GB/s", flush=True)
        for size in options.sizes:
            for run in (results.tetrahedra, results.cubes):
                if run == results.cubes and size > options.peerUpTo:
                    continue
                with tempfile.TemporaryDirectory() as folder:
                    run(size, Path(folder))
        text = results.report(memory)
        print(f"\n{text}", flush=True)
        if options.page:
            replaceBetween(options.page, "gas", text)
    except (MissingProgram, NoMarks) as problem:
        sys.exit(f"gas: error: {problem}")


if __name__ == "__main__":
    main(sys.argv[1:])
