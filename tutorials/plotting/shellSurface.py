"""The shell's VTK series (VTK/<name>.pvd) as triangles to draw."""
import base64
import xml.etree.ElementTree as xml
from pathlib import Path

import numpy as np

from plotting.errors import PlotError, oneOf
from plotting.surfaces import Surface

TYPES = {"Float32": "f4", "Float64": "f8", "Int32": "i4", "Int64": "i8",
         "UInt8": "u1"}
LAGRANGE_TRIANGLE = 69


def _arrays(path):
    """Arrays of a .vtu file by name, as shellVTK writes them."""
    try:
        root = xml.parse(path).getroot()
    except (OSError, xml.ParseError) as problem:
        raise PlotError(f"{path}: {problem}")
    arrays = {}
    for array in root.iter("DataArray"):
        data = base64.b64decode(array.text)
        values = np.frombuffer(data[8:], TYPES[array.get("type")])
        width = int(array.get("NumberOfComponents", 1))
        arrays[array.get("Name")] = (
            values.reshape(-1, width) if width > 1 else values)
    return arrays


def series(case):
    """[(time, file)] of the case's shell, by time."""
    found = sorted((Path(case) / "VTK").glob("*.pvd"))
    if not found:
        raise PlotError(f"{Path(case).resolve()}/VTK: no series (.pvd) of a"
                        " shell; run the case first")
    parts = [(float(part.get("timestep")), found[0].parent / part.get("file"))
             for part in xml.parse(found[0]).getroot().iter("DataSet")]
    return sorted(parts, key=lambda part: part[0])


def _lattice(order):
    """Places (i, j) of VTK's Lagrange triangle of an order, in its order:
    corners, then edges, then the triangle inside."""
    if order == 0:
        return [(0, 0)]
    places = [(0, 0), (order, 0), (0, order)]
    places += [(i, 0) for i in range(1, order)]
    places += [(order - i, i) for i in range(1, order)]
    places += [(0, order - i) for i in range(1, order)]
    if order > 2:
        places += [(i + 1, j + 1) for i, j in _lattice(order - 3)]
    return places


def _subTriangles(order):
    place = {at: n for n, at in enumerate(_lattice(order))}
    for i in range(order):
        for j in range(order - i):
            yield place[i, j], place[i + 1, j], place[i, j + 1]
            if i + j + 2 <= order:
                yield place[i + 1, j], place[i + 1, j + 1], place[i, j + 1]


def shellSurface(case, time, fieldName="displacement", warp=1.0):
    """The shell nearest to a time; vectors by their magnitude.

    warp: the displacement is drawn this many times as large.
    """
    instant, path = min(series(case), key=lambda part: abs(part[0] - time))
    arrays = _arrays(path)
    ends = arrays["offsets"]
    if (arrays["types"] != LAGRANGE_TRIANGLE).any():
        raise PlotError(f"{path}: not the Lagrange triangles of a shell")
    nodes = arrays["connectivity"].reshape(len(ends), -1)
    order = {3: 1, 6: 2, 10: 3}[nodes.shape[1]]
    name, _, axis = fieldName.partition(".")
    if name not in arrays:
        there = [n for n in arrays if n not in
                 ("Points", "connectivity", "offsets", "types")]
        raise PlotError(f"{path}: no field {name}; there are:"
                        f" {oneOf(sorted(there))}")
    values = arrays[name].astype(float)
    if values.ndim == 2:
        values = (values[:, "xyz".index(axis)] if axis in ("x", "y", "z")
                  else np.linalg.norm(values, axis=1))
    points = arrays["Points"].astype(float)
    points = points + (warp - 1)*arrays["displacement"]
    triangles = nodes[:, np.array(list(_subTriangles(order)))].reshape(-1, 3)
    return instant, Surface(points, triangles, values, True)
