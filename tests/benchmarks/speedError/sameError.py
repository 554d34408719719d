"""Processor time of two codes at the same error."""
from dataclasses import dataclass

import numpy as np


class Front:
    """Runs of one code that no other one beats in both time and error; the
    time for an error in between is on the straight line between the two runs
    beside it, in logarithms."""

    def __init__(self, seconds, errors):
        self.runs, best = [], np.inf
        self.longest = max(seconds)
        for t, e in sorted(zip(seconds, errors)):
            if e < best:
                self.runs.append((t, e))
                best = e

    def time(self, error):
        """Least and greatest number of seconds: alike among the runs. Beyond
        them nothing is known but 0 or infinity and what the runs took."""
        t, e = np.array(self.runs).T
        if error > e[0] * (1 + 1e-12):
            return 0.0, t[0]
        if error < e[-1] * (1 - 1e-12):
            return self.longest, np.inf
        between = np.exp(np.interp(-np.log(error), -np.log(e), np.log(t)))
        return between, between


@dataclass
class Level:
    """An error of the peer and the two codes' times for it; ours and the
    ratio, its time over ours, as the least and the greatest."""
    error: float
    peer: float
    ours: tuple
    ratio: tuple


def levels(ours, peer):
    """One level per run of the peer that is on its front."""
    found = []
    for seconds, error in peer.runs:
        low, high = ours.time(error)
        ratio = (seconds / high, seconds / low if low > 0 else np.inf)
        found.append(Level(error, seconds, (low, high), ratio))
    return found


def interval(low, high):
    """As text: a number, or a bound."""
    if low == high:
        return f"{low:.3g}"
    return f"> {low:.3g}" if np.isinf(high) else f"< {high:.3g}"
