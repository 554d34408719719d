"""Patches, planes and the deformed shell in space."""
import matplotlib.pyplot as plt
import numpy as np
from matplotlib.cm import ScalarMappable
from matplotlib.colors import Normalize

from plotting import surfaces
from plotting.errors import PlotError
from plotting.raster import Canvas
from plotting.shellSurface import shellSurface

PIXELS = (1400, 900)    # drawn twice as fine as shown

def viewAxes(elevation, azimuth, up):
    """Rows: to the right, upwards, away from the eye."""
    elevation, azimuth = np.radians([elevation, azimuth])
    eye = np.array([np.cos(elevation)*np.cos(azimuth),
                    np.cos(elevation)*np.sin(azimuth), np.sin(elevation)])
    eye = np.roll(eye, {"z": 0, "x": 1, "y": 2}[up])
    upwards = np.eye(3)["xyz".index(up)]
    right = np.cross(upwards, eye)
    right /= np.linalg.norm(right)
    return np.array([right, np.cross(eye, right), -eye])


def clipped(surface, box):
    """The triangles whose middle is in the box."""
    if box is None:
        return surface
    middle = surface.points[surface.triangles].mean(axis=1)
    inside = ((middle >= box[::2]) & (middle <= box[1::2])).all(axis=1)
    return surfaces.Surface(
        surface.points, surface.triangles[inside],
        surface.values if surface.atPoints else surface.values[inside],
        surface.atPoints)


def gasSurfaces(pieces, options):
    found = []
    if options.patch:
        found.append(surfaces.patches(pieces, options.patch, options.field))
    for plane in options.plane:
        found.append(surfaces.planeCut(pieces, *plane, options.field))
    box = np.array(options.box) if options.box else None
    return [clipped(surface, box) for surface in found]


def limitsOf(layers, wanted):
    if wanted:
        return wanted
    values = np.concatenate([s.values[s.triangles].ravel() if s.atPoints
                             else s.values for s in layers])
    return float(values.min()), float(values.max())


def shading(surface, axes):
    """Darker where a triangle is seen at a slant."""
    a, b, c = (surface.points[surface.triangles[:, i]] for i in range(3))
    normal = np.cross(b - a, c - a)
    length = np.maximum(np.linalg.norm(normal, axis=1), 1e-300)
    light = 0.4*axes[0] + 0.5*axes[1] - axes[2]
    return 0.75 + 0.25*abs(normal @ light)/length/np.linalg.norm(light)


def placed(layers, axes):
    """Pixels of all layers' points, all in the picture; pixels a metre."""
    seen = [s.points @ axes.T for s, *_ in layers]
    used = np.concatenate([p[s.triangles].reshape(-1, 3)
                           for p, (s, *_) in zip(seen, layers)])
    low, high = used.min(axis=0)[:2], used.max(axis=0)[:2]
    perMetre = 0.94*min(PIXELS/np.maximum(high - low, 1e-300))
    middle = 0.5*(low + high)
    for places in seen:
        places[:, :2] = ((places[:, :2] - middle)*perMetre*(1, -1)
                         + 0.5*np.array(PIXELS))
    return seen, perMetre


def drawTriad(axes, view):
    """The directions of x, y and z in a corner."""
    for direction, name in zip(np.eye(3), "xyz"):
        tip = 0.06*np.array([view[0] @ direction, view[1] @ direction])
        if np.linalg.norm(tip) < 0.005:
            continue
        start = np.array([0.07, 0.1])
        arrow = dict(arrowstyle="-", color="0.2")
        axes.annotate(name, start, start + tip*(1, PIXELS[0]/PIXELS[1]),
                      xycoords="axes fraction", textcoords="axes fraction",
                      ha="center", va="center", arrowprops=arrow, fontsize=9)


def drawOne(axes, case, time, options):
    view = viewAxes(*options.view, options.up)
    gas = gasSurfaces(case.pieces(time), options)
    for surface in gas:
        surface.values = options.scale*(surface.values - options.subtract)
    layers, bars = [], []
    if gas:
        norm = Normalize(*limitsOf(gas, options.range))
        bars.append((norm, options.colours, options.label or options.field))
        layers += [(s, norm, options.colours) for s in gas]
    if options.shell:
        _, shell = shellSurface(case.folder, float(time), options.shell,
                                options.warp)
        shell.values = options.shellScale*shell.values
        norm = Normalize(*limitsOf([shell], options.shellRange))
        bars.append((norm, options.shellColours,
                     options.shellLabel or f"shell: {options.shell}"))
        layers.append((shell, norm, options.shellColours))
    if not any(len(s.triangles) for s, *_ in layers):
        raise PlotError("nothing to draw: give --patch, --plane or --shell, and"
                        " a --box that holds some of it")
    canvas = Canvas(*PIXELS)
    places, perMetre = placed(layers, view)
    for (surface, norm, colours), at in zip(layers, places):
        rgb = plt.get_cmap(colours)(norm(surface.values))[:, :3]
        canvas.draw(at, surface.triangles, rgb, shading(surface, view))
    image = canvas.image()
    axes.imshow(image, interpolation="antialiased")
    axes.axis("off")
    drawTriad(axes, view)
    axes.set_title(f"{options.timeScale*float(time):g} {options.timeUnit}",
                   fontsize=10)
    said = [f"{label} at {time} s: {norm.vmin:.6g} to {norm.vmax:.6g}"
            for norm, _, label in bars]
    return bars, said


def draw(case, options):
    """(figure, lines for the log)"""
    times = [case.time(time) for time in options.time]
    figure, rows = plt.subplots(
        len(times), 1, figsize=options.size or (8, 0.4 + 4.6*len(times)),
        squeeze=False, layout="constrained")
    lines = []
    for axes, time in zip(rows[:, 0], times):
        bars, said = drawOne(axes, case, time, options)
        lines += said
        for norm, colours, label in bars:
            figure.colorbar(ScalarMappable(norm, colours), ax=axes,
                            shrink=0.7, label=label, pad=0.02)
    figure.suptitle(options.title)
    return figure, lines
