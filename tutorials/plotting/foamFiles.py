"""Reads OpenFOAM's files: headers, lists and fields, ASCII or binary, also
compressed (.gz)."""
import gzip
import re

import numpy as np

from plotting.errors import PlotError

COMPONENTS = {"scalar": 1, "vector": 3, "symmTensor": 6, "tensor": 9}
LIST = re.compile(rb"(?:List<(\w+)>)?\s*(\d+)\s*([({])")


def existing(path):
    """The path, or the one of its compressed form; None without either."""
    packed = path.with_name(path.name + ".gz")
    return next((p for p in (path, packed) if p.is_file()), None)


class FoamFile:
    """Header and body of a file."""

    def __init__(self, path):
        self.path = existing(path)
        if self.path is None:
            raise PlotError(f"{path}: no such file")
        opened = gzip.open if self.path.suffix == ".gz" else open
        with opened(self.path, "rb") as stream:
            data = stream.read()
        head = re.search(rb"FoamFile\s*\{(.*?)\}", data, re.S)
        if head is None:
            raise PlotError(f"{self.path}: not a file of OpenFOAM, it has no"
                            " FoamFile header")
        self.body = data[head.end():]
        self.header = dict(
            re.findall(r'(\w+)\s+"?([^;"]*)"?\s*;', head.group(1).decode()))
        self.binary = self.header.get("format") == "binary"
        # arch tells the sizes of binary data; what is usual without it
        arch = self.header.get("arch", "label=32;scalar=64")
        sizes = dict(re.findall(r"(label|scalar)=(\d+)", self._arch(head)
                                or arch))
        self.label = np.dtype(f"i{int(sizes.get('label', 32))//8}")
        self.scalar = np.dtype(f"f{int(sizes.get('scalar', 64))//8}")

    @staticmethod
    def _arch(head):
        """The entry arch has a semicolon inside its quotes."""
        found = re.search(rb'\barch\s+"([^"]*)"', head.group(1))
        return found.group(1).decode() if found else ""

    @property
    def kind(self):
        """Class of what the file holds, as pointScalarField."""
        return self.header.get("class", "")

    def numbers(self, kind, components, start=0):
        """The list at or after a place, rows of components, and its end."""
        found = LIST.search(self.body, start)
        if found is None:
            raise PlotError(f"{self.path}: no list of numbers in it")
        size, opens = int(found.group(2)), found.group(3)
        if opens == b"{" or not self.binary:
            ends = self.body.find(b"}" if opens == b"{" else b"\n)",
                                  found.end())
            if ends < 0 or b"\n" not in self.body[found.end():ends]:
                # A short list stands on one line
                ends = self._closing(found.end() - 1)
            text = self.body[found.end():ends]
            values = np.array(
                text.replace(b"(", b" ").replace(b")", b" ").split(),
                dtype=kind)
            if opens == b"{":
                values = np.tile(values, size)
        else:
            ends = found.end() + size*components*kind.itemsize
            values = np.frombuffer(
                self.body[found.end():ends], dtype=kind).copy()
        if len(values) != size*components:
            raise PlotError(
                f"{self.path}: {len(values)} numbers in a list of {size}:"
                " the file is cut off or of another kind")
        shape = (size, components) if components > 1 else size
        return values.reshape(shape), ends + 1

    def _closing(self, start):
        """Place of the bracket that closes the one at start."""
        opens = self.body[start:start + 1]
        closes = {b"(": b")", b"{": b"}"}[opens]
        depth = 0
        for match in re.finditer(b"[" + re.escape(opens + closes) + b"]",
                                 self.body[start:]):
            depth += 1 if match.group() == opens else -1
            if depth == 0:
                return start + match.start()
        raise PlotError(f"{self.path}: a bracket is not closed")


def readPoints(path):
    file = FoamFile(path)
    return file.numbers(file.scalar, 3)[0]


def readLabels(path):
    file = FoamFile(path)
    return file.numbers(file.label, 1)[0]


def readFaces(path):
    """(offsets, labels): face i has labels[offsets[i]:offsets[i + 1]]."""
    file = FoamFile(path)
    if file.kind == "faceCompactList":
        offsets, end = file.numbers(file.label, 1)
        labels, _ = file.numbers(file.label, 1, end)
        return offsets, labels
    found = LIST.search(file.body)
    text = file.body[found.end():]
    lists = re.findall(rb"\d+\(([\d\s]+)\)", text)[:int(found.group(2))]
    sizes = np.array([len(one.split()) for one in lists])
    return (np.concatenate([[0], np.cumsum(sizes)]),
            np.array(b" ".join(lists).split(), dtype=file.label))


def readBoundary(path):
    """{patch: (type, first face, number of faces)}"""
    text = FoamFile(path).body.decode()
    patches = {}
    for name, entries in re.findall(r"([\w.:+-]+)\s*\{([^}]*)\}", text):
        entry = dict(re.findall(r"(\w+)\s+([^;]*);", entries))
        patches[name] = (entry["type"], int(entry["startFace"]),
                         int(entry["nFaces"]))
    return patches


def readField(path):
    """(kind, values) of a field's interior: kind as pointScalarField; values
    (n,) or (n, components), of one row when the field is uniform."""
    file = FoamFile(path)
    kind = re.fullmatch(r"(point|vol)(\w+)Field", file.kind)
    place = file.body.find(b"internalField")
    if kind is None or place < 0:
        raise PlotError(f"{file.path}: holds a {file.kind or 'nothing'}, not a"
                        " point or volume field")
    typeName = kind.group(2)
    components = COMPONENTS[typeName[0].lower() + typeName[1:]]
    uniform = re.match(rb"internalField\s+uniform\s+([^;]*);",
                       file.body[place:place + 500])
    if uniform:
        words = re.sub(rb"[()]", b" ", uniform.group(1)).split()
        values = np.array(words, dtype=float)
        return file.kind, values.reshape((1, components) if components > 1
                                         else 1)
    return file.kind, file.numbers(file.scalar, components, place)[0]
