"""A field in a plane, one panel for each time."""
import matplotlib.pyplot as plt
import matplotlib.tri as tri
import numpy as np

from plotting import surfaces
from plotting.errors import PlotError
from plotting.shellSurface import shellSurface


def surfaceOf(pieces, options):
    if options.plane:
        return surfaces.planeCut(pieces, *options.plane, options.field)
    if options.patch:
        return surfaces.patches(pieces, options.patch, options.field)
    return surfaces.planeOfTwoDimensions(pieces, options.field)


def axesOf(normal):
    """The two coordinates that the plane is drawn over."""
    return [i for i in range(3) if i != abs(normal).argmax()]


def shellOutline(case, time, across, scale):
    """The shell's edges as seen along the plane's normal."""
    _, shell = shellSurface(case, time)
    return scale*shell.points[shell.triangles][:, [0, 1, 2, 0]][..., across]


def cropped(surface, points, crop):
    """The surface's triangles that are at least partly inside."""
    if crop is None:
        return surface.triangles, slice(None)
    corners = points[surface.triangles]
    low, high = np.array(crop[::2]), np.array(crop[1::2])
    inside = ((corners.max(axis=1) >= low) & (corners.min(axis=1) <= high)
              ).all(axis=1)
    if not inside.any():
        raise PlotError(
            f"--crop leaves nothing: the plane spans {points.min(axis=0)} to"
            f" {points.max(axis=0)} in the units of the axes")
    return surface.triangles[inside], inside


def drawOne(axes, case, time, options, limits):
    surface = surfaceOf(case.pieces(time), options)
    across = axesOf(surface.normal())
    points = options.lengthScale*surface.points[:, across]
    triangles, inside = cropped(surface, points, options.crop)
    values = options.scale*(surface.values - options.subtract)
    mesh = tri.Triangulation(*points.T, triangles)
    colours = dict(cmap=options.colours, vmin=limits[0], vmax=limits[1])
    if surface.atPoints:
        image = axes.tripcolor(mesh, values, shading="gouraud", **colours)
        seen = values[triangles]
    else:
        image = axes.tripcolor(mesh, facecolors=values[inside], **colours)
        seen = values[inside]
    if options.mesh:
        axes.triplot(mesh, color="k", lw=0.2, alpha=0.5)
    if options.shell:
        for line in shellOutline(case.folder, float(time), across,
                                 options.lengthScale):
            axes.plot(*line.T, color="k", lw=1.2, solid_joinstyle="round")
    axes.set_aspect("equal")
    crop = options.crop or (*np.sort(points[triangles][..., 0].ravel())[[0, -1]],
                            *np.sort(points[triangles][..., 1].ravel())[[0, -1]])
    axes.set(xlim=crop[:2], ylim=crop[2:])
    for name, axis in zip(("xlabel", "ylabel"), across):
        axes.set(**{name: f"{'xyz'[axis]} [{options.lengthUnit}]"})
    axes.set_title(f"{options.timeScale*float(time):g} {options.timeUnit}",
                   fontsize=10)
    return image, float(seen.min()), float(seen.max())


def draw(case, options):
    """(figure, lines for the log)"""
    times = [case.time(time) for time in options.time]
    limits = options.range or (None, None)
    figure, rows = plt.subplots(
        len(times), 1, figsize=options.size or (8, 1 + 3*len(times)),
        squeeze=False, sharex=True, layout="constrained")
    said, images = [], []
    for axes, time in zip(rows[:, 0], times):
        image, low, high = drawOne(axes, case, time, options, limits)
        images.append(image)
        said.append(f"{options.label or options.field} at {time} s: {low:.6g}"
                    f" to {high:.6g}")
    for axes in rows[:-1, 0]:
        axes.set_xlabel("")
    # One colour bar for all needs one range for all
    low = min(image.norm.vmin for image in images)
    high = max(image.norm.vmax for image in images)
    for image in images:
        image.set_clim(low, high)
    figure.colorbar(images[0], ax=rows[:, 0].tolist(), shrink=0.9,
                    label=options.label or options.field)
    figure.suptitle(options.title)
    return figure, said
