"""Draws triangles in space into pixels: the nearest one is seen.

matplotlib sorts whole polygons by distance, which fails where large and small
ones cross; here every pixel has its own depth.
"""
import numpy as np

# Samples a pixel along a triangle's longest edge, so that none is missed
DENSITY = 1.6


class Canvas:
    """Colours and depths of width times height pixels."""

    def __init__(self, width, height):
        self.width, self.height = width, height
        self.depth = np.full(width*height, np.inf)
        self.colour = np.ones((width*height, 3))

    def draw(self, places, triangles, colours, shade):
        """places (n, 3): pixel x, y from above, depth; colours (n, 3) at
        points or (m, 3); shade (m,) darkens a triangle."""
        corners = places[triangles]
        low, high = corners[..., :2].min(axis=1), corners[..., :2].max(axis=1)
        seen = ((high >= 0) & (low < (self.width, self.height))).all(axis=1)
        edges = corners - np.roll(corners, 1, axis=1)
        longest = np.linalg.norm(edges[..., :2], axis=2).max(axis=1)
        level = np.maximum(
            1, 2**np.ceil(np.log2(np.maximum(DENSITY*longest, 1)))).astype(int)
        atPoints = len(colours) == len(places)
        for n in np.unique(level[seen]):
            # Few samples at a time: they are (n + 1)(n + 2)/2 a triangle
            some = np.flatnonzero(seen & (level == n))
            size = max(1, 4_000_000//((n + 1)*(n + 2)//2))
            for start in range(0, len(some), size):
                part = some[start:start + size]
                self._samples(
                    corners[part],
                    colours[triangles[part]] if atPoints
                    else np.repeat(colours[part][:, None], 3, axis=1),
                    shade[part], n)

    def _samples(self, corners, colours, shade, n):
        i, j = np.meshgrid(np.arange(n + 1), np.arange(n + 1))
        inside = i + j <= n
        weights = np.column_stack(
            [n - i[inside] - j[inside], i[inside], j[inside]])/n
        places = np.einsum("sc,mcd->msd", weights, corners).reshape(-1, 3)
        pixels = np.floor(places[:, :2]).astype(int)
        kept = ((pixels >= 0) & (pixels < (self.width, self.height))
                ).all(axis=1)
        at = pixels[kept, 1]*self.width + pixels[kept, 0]
        depth = places[kept, 2]
        order = np.argsort(-depth, kind="stable")
        last = np.full(self.width*self.height, -1)
        last[at[order]] = order         # the nearest is assigned last
        pixel = np.flatnonzero(last >= 0)
        sample = last[pixel]
        nearer = depth[sample] < self.depth[pixel]
        pixel, sample = pixel[nearer], sample[nearer]
        self.depth[pixel] = depth[sample]
        row, column = np.divmod(np.flatnonzero(kept)[sample], len(weights))
        mixed = np.einsum("sc,scd->sd", weights[column], colours[row])
        self.colour[pixel] = mixed*shade[row][:, None]

    def image(self):
        return self.colour.reshape(self.height, self.width, 3)
