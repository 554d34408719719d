"""Reads what positionalShellFoam writes: restart states and VTK files."""
import base64
import re
import xml.etree.ElementTree as ElementTree

import numpy as np

from foamFile import numbers, readList, readText

# Files of <time>/shell and the number of components
STATE = {
    "position": 3, "director": 3, "thicknessStrain": 1,
    "velocity": 3, "directorVelocity": 3,
    "acceleration": 3, "directorAcceleration": 3,
    "force": 3, "directorForce": 3, "thicknessForce": 1,
}

NUMBERS = {
    "Float32": np.float32, "Float64": np.float64, "Int32": np.int32,
    "Int64": np.int64, "UInt8": np.uint8,
}


def readValues(path, components):
    """A file that holds one list, also as OpenFOAM's n{value}."""
    repeated = re.search(r"(\d+)\s*\{([^{}]*)\}\s*$", readText(path))
    if not repeated:
        return readList(path, components)
    value = numbers(repeated.group(2), components)
    return np.repeat(value, int(repeated.group(1)), axis=0)


def readState(case, time):
    """The shell's restart state at a time: {file: values}."""
    folder = case.path / str(time) / "shell"
    return {name: readValues(folder / name, n) for name, n in STATE.items()}


def dataArray(element):
    """Values of a DataArray in base64: (n,) or (n, components)."""
    raw = base64.b64decode("".join(element.text.split()))
    size = int(np.frombuffer(raw[:8], np.uint64)[0])
    assert size == len(raw) - 8
    values = np.frombuffer(raw[8:], NUMBERS[element.get("type")])
    components = int(element.get("NumberOfComponents", "1"))
    return values if components == 1 else values.reshape(-1, components)


def readGrid(path):
    """A .vtu file: points, cells by name, point data by name."""
    piece = ElementTree.parse(path).getroot().find("UnstructuredGrid/Piece")
    arrays = {
        part: {a.get("Name"): dataArray(a) for a in piece.find(part)}
        for part in ("Points", "Cells", "PointData")
    }
    assert int(piece.get("NumberOfPoints")) == len(arrays["Points"]["Points"])
    assert int(piece.get("NumberOfCells")) == len(arrays["Cells"]["types"])
    return arrays["Points"]["Points"], arrays["Cells"], arrays["PointData"]


def readSeries(path):
    """Times and files of a .pvd file."""
    sets = ElementTree.parse(path).getroot().findall("Collection/DataSet")
    return [(float(s.get("timestep")), s.get("file")) for s in sets]
