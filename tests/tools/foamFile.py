"""Reads OpenFOAM's ASCII fields and lists, and histories in .dat files."""
import re

import numpy as np

COMPONENTS = {
    "scalar": 1,
    "label": 1,
    "vector": 3,
    "symmTensor": 6,
    "tensor": 9,
}
NUMBER = re.compile(r"[-+]?(?:nan|inf|(?:\d+\.?\d*|\.\d+)(?:[eE][-+]?\d+)?)")


def withoutComments(text):
    """The text without // and /* */ comments."""
    text = re.sub(r"/\*.*?\*/", "", text, flags=re.S)
    return re.sub(r"//[^\n]*", "", text)


def readText(path):
    """Contents of an ASCII OpenFOAM file, comments removed."""
    with open(path, encoding="ascii", errors="replace") as stream:
        text = stream.read()
    if re.search(r"\bformat\s+binary\s*;", text):
        raise ValueError(f"{path}: binary; use writeFormat ascii")
    return withoutComments(text)


def numbers(text, components):
    """All numbers of the text, as rows when there are several components."""
    values = np.array([float(n) for n in NUMBER.findall(text)])
    return values if components == 1 else values.reshape(-1, components)


def expectSize(path, values, size):
    if len(values) != size:
        raise ValueError(f"{path}: {len(values)} entries, expected {size}")
    return values


def readList(path, components):
    """A file that holds one list: points, labels."""
    text = re.sub(r"FoamFile\s*\{.*?\}", "", readText(path), flags=re.S)
    size, body = re.search(r"(\d+)\s*\((.*)\)", text, flags=re.S).groups()
    return expectSize(path, numbers(body, components), int(size))


def readInternalField(path, size):
    """internalField of a field file; uniform values are repeated size times.

    Returns shape (size,) for scalars, (size, 3) for vectors.
    """
    text = readText(path)

    listed = re.search(
        r"\binternalField\s+nonuniform\s+List<(\w+)>\s*(\d+)\s*"
        r"(?:\((.*?)\)\s*;|\{(.*?)\}\s*;)",
        text,
        flags=re.S,
    )
    if listed:
        kind, count, entries, repeated = listed.groups()
        components = COMPONENTS[kind]
        if repeated is None:
            values = numbers(entries, components)
        else:
            values = np.repeat(numbers(repeated, components), int(count), 0)
        expectSize(path, values, int(count))
        return expectSize(path, values, size)

    uniform = re.search(r"\binternalField\s+uniform\s+([^;]*);", text)
    if not uniform:
        raise ValueError(f"{path}: no internalField that this can read")
    value = numbers(uniform.group(1), 1)
    return np.full(size, value[0]) if len(value) == 1 else np.tile(
        value, (size, 1)
    )


def readHistory(path):
    """A .dat file of a function object.

    Returns (names, table): the words of the last line of the header, and one
    row per time. Parentheses around vectors are ignored.
    """
    names, rows = [], []
    with open(path, encoding="ascii") as stream:
        for line in stream:
            if line.startswith("#"):
                names = line[1:].split()
            elif line.strip():
                words = line.replace("(", " ").replace(")", " ").split()
                rows.append([float(word) for word in words])
    if not rows:
        raise ValueError(f"{path}: no data")
    return names, np.array(rows)
