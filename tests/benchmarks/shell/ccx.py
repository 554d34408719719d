"""Decks for CalculiX, its runs and results.

Shells are strips and plates of S8R or S6 elements on a grid of half elements;
a curved shell is one layer of C3D20R bricks, which is what CalculiX makes of S8R
itself: with shell elements its symmetry planes lock.
"""
import os
import re
import shutil
import subprocess
from resource import RUSAGE_CHILDREN, getrusage

PROGRAM = "ccx"


class Failed(RuntimeError):
    """CalculiX did not come to the end."""


def available():
    return shutil.which(PROGRAM) is not None


class Grid:
    """nU x nV quadrilaterals of f(u, v), numbered by half elements (i, j)."""

    def __init__(self, nU, nV, f):
        self.nU, self.nV, self.f = nU, nV, f
        self.number, self.nodes = {}, {}

    def node(self, i, j):
        if (i, j) not in self.number:
            self.number[i, j] = len(self.number) + 1
            self.nodes[self.number[i, j]] = self.f(
                i / (2 * self.nU), j / (2 * self.nV))
        return self.number[i, j]

    def elements(self, kind):
        found = []
        for i in range(0, 2 * self.nU, 2):
            for j in range(0, 2 * self.nV, 2):
                corners = [(0, 0), (2, 0), (2, 2), (0, 2)]
                if kind == "S8R":
                    shapes = [corners + [(1, 0), (2, 1), (1, 2), (0, 1)]]
                else:
                    shapes = [
                        [(0, 0), (2, 0), (2, 2), (1, 0), (2, 1), (1, 1)],
                        [(0, 0), (2, 2), (0, 2), (1, 1), (1, 2), (0, 1)]]
                found += [[self.node(i + a, j + b) for a, b in shape]
                          for shape in shapes]
        return found


class Bricks:
    """One layer of 20-node bricks about the surface f with normals n."""

    def __init__(self, nU, nV, f, n, thickness):
        self.number, self.nodes, self.bricks = {}, {}, []
        self.nU, self.nV = nU, nV
        self.f, self.n, self.thickness = f, n, thickness
        for i in range(0, 2 * nU, 2):
            for j in range(0, 2 * nV, 2):
                corners = [(i, j), (i + 2, j), (i + 2, j + 2), (i, j + 2)]
                middles = [(i + 1, j), (i + 2, j + 1), (i + 1, j + 2),
                           (i, j + 1)]
                self.bricks.append(
                    [self.node(*p, level) for places in (corners, middles)
                     for level in (-1, 1) for p in places]
                    + [self.node(*p, 0) for p in corners])

    def node(self, i, j, level):
        key = i, j, level
        if key not in self.number:
            self.number[key] = len(self.number) + 1
            u, v = i / (2 * self.nU), j / (2 * self.nV)
            self.nodes[self.number[key]] = tuple(
                x + 0.5 * level * self.thickness * n
                for x, n in zip(self.f(u, v), self.n(u, v)))
        return self.number[key]

    def elements(self, _):
        return self.bricks


def lineWeights(n):
    """Shares of the nodes of n quadratic edges in a uniform line load."""
    shares = [0.0] * (2 * n + 1)
    for edge in range(n):
        for place, share in enumerate((1 / 6, 4 / 6, 1 / 6)):
            shares[2 * edge + place] += share / n
    return shares


def rows(numbers, width=10):
    numbers = list(numbers)
    return "".join(
        ",".join(map(str, numbers[k:k + width])) + ",\n"
        for k in range(0, len(numbers), width))


def meshText(mesh, kind):
    elements = mesh.elements(kind)  # Numbers the nodes that it needs
    text = "*NODE,NSET=NALL\n" + "".join(
        f"{k},{x:.12e},{y:.12e},{z:.12e}\n"
        for k, (x, y, z) in sorted(mesh.nodes.items()))
    text += f"*ELEMENT,TYPE={kind},ELSET=EALL\n"
    for number, nodes in enumerate(elements, 1):
        text += f"{number}," + rows(nodes).rstrip(",\n") + "\n"
    return text


def nodeSet(name, numbers):
    return f"*NSET,NSET={name}\n" + rows(numbers)


class Result:
    """seconds of processor time; history: [(time, {node: (ux, uy, uz)})]"""

    def __init__(self, folder, job, seconds):
        self.seconds = seconds
        self.history = []
        for line in (folder / f"{job}.dat").read_text().splitlines():
            head = re.match(r"\s*displacements .* time\s+(\S+)", line)
            words = line.split()
            if head:
                self.history.append((float(head.group(1)), {}))
            elif self.history and len(words) == 4:
                try:
                    self.history[-1][1][int(words[0])] = tuple(
                        map(float, words[1:]))
                except ValueError:
                    pass

    @property
    def last(self):
        return self.history[-1][1]


def children():
    used = getrusage(RUSAGE_CHILDREN)
    return used.ru_utime + used.ru_stime


def run(folder, text, endTime):
    """Of one thread."""
    folder.mkdir(parents=True, exist_ok=True)
    (folder / "job.inp").write_text(text)
    before = children()
    done = subprocess.run(
        [PROGRAM, "-i", "job"], cwd=folder, stdout=subprocess.PIPE,
        stderr=subprocess.STDOUT, universal_newlines=True,
        env={**os.environ, "OMP_NUM_THREADS": "1",
             "CCX_NPROC_STIFFNESS": "1", "CCX_NPROC_EQUATION_SOLVER": "1"})
    seconds = children() - before
    if "Job finished" not in done.stdout:
        raise Failed("\n".join(done.stdout.splitlines()[-15:]))
    result = Result(folder, "job", seconds)
    if not result.history or abs(
            result.history[-1][0] - endTime) > 1e-6 * endTime:
        raise Failed("it stopped before the end")
    return result
