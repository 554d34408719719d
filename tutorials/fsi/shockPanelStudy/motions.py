"""What the motion of a panel's tip says: extrema, periods, an oscillator."""
from dataclasses import dataclass

import numpy as np


# Half of the second mode's period [ms], whose ripple moves the largest value of
# a swing: (1.8751/4.6941)^2 of the first's, 2.744 ms
RIPPLE = 0.219


@dataclass(frozen=True)
class Extremum:
    time: float
    value: float


def parabola(t, u, i):
    """The extremum through the three instants around i."""
    a, b, c = np.polyfit(t[i - 1:i + 2] - t[i], u[i - 1:i + 2], 2)
    return Extremum(t[i] - b/(2*a), c - b*b/(4*a))


def swings(t, u, least=0.3):
    """Extrema between zero crossings, largest first maximum on; those below
    least of the greatest are not swings. The last one only when u has turned
    well away from it."""
    found = []
    signs = np.sign(u)
    edges = [0, *(np.flatnonzero(signs[1:]*signs[:-1] < 0) + 1), len(u)]
    for start, end in zip(edges[:-1], edges[1:]):
        i = start + abs(u[start:end]).argmax()
        if abs(u[i]) < least*abs(u).max() or i in (0, len(u) - 1):
            continue
        if end == len(u) and abs(u[-1]) > 0.98*abs(u[i]):
            continue
        found.append(parabola(t, u, i))
    return found


def centre(t, u, time):
    """Time of the extremum of the parabola that fits best within RIPPLE about
    a time; None when the motion does not go so far."""
    inside = abs(t - time) <= RIPPLE
    if t[-1] < time + RIPPLE:
        return None
    a, b, _ = np.polyfit(t[inside] - time, u[inside], 2)
    return time - b/(2*a)


@dataclass(frozen=True)
class Swing:
    """First maximum, rebound, second maximum; None where not reached.
    period: between the centres of the two maxima."""
    peak: Extremum = None
    rebound: Extremum = None
    second: Extremum = None
    period: float = None

    @classmethod
    def of(cls, t, u):
        found = swings(t, u)
        while found and found[0].value < 0:
            found.pop(0)
        centres = [centre(t, u, e.time) for e in found[:3:2]]
        period = (centres[1] - centres[0]
                  if len(centres) == 2 and None not in centres else None)
        return cls(*(found + 3*[None])[:3], period)


def oscillator(t, load, period):
    """Displacement of a linear oscillator without damping at rest, per that
    under the load at rest; exact for a load that is linear between instants.
    """
    w = 2*np.pi/period
    x = np.zeros(len(t))
    v = 0.0
    for n, dt in enumerate(np.diff(t)):
        slope = (load[n + 1] - load[n])/dt
        c, s = np.cos(w*dt), np.sin(w*dt)
        # About the load's own line
        a, b = x[n] - load[n], (v - slope)/w
        x[n + 1] = load[n + 1] + a*c + b*s
        v = slope + w*(-a*s + b*c)
    return x


def dampedPeriod(t, u, about):
    """(period, part of the amplitude lost in it) of the decaying sine that fits
    best in the least squares, searched for within 15 % about a period."""
    def rest(period, decay):
        w = 2*np.pi/period
        envelope = np.exp(-decay*(t - t[0]))
        base = np.stack([envelope*np.cos(w*t), envelope*np.sin(w*t)], axis=1)
        _, squares, *_ = np.linalg.lstsq(base, u, rcond=None)
        return squares[0]

    period, decay = about, 0.0
    spread, spreadDecay = 0.15*about, 0.5/about
    for _ in range(8):
        _, period, decay = min(
            (rest(p, d), p, d)
            for p in np.linspace(period - spread, period + spread, 15)
            for d in np.linspace(decay - spreadDecay, decay + spreadDecay, 15))
        spread, spreadDecay = spread/4, spreadDecay/4
    return period, 1 - np.exp(-decay*period)
