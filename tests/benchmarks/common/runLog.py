"""Steps and processor time in the log of a run."""
import re
import statistics


# Of OpenFOAM's processor time; no difference is known to be smaller
TICK = 0.01  # s


class TooShort(ValueError):
    """A run of less than three steps has no time per step."""


class RunLog:
    """From the text of the log:

    steps      time steps
    perStep    processor time [s] per step: of all steps but the first, whose
               time is mixed with the set-up, and the last, which writes. At
               least one tick of the clock over their number
    seconds    processor time [s] of all steps at perStep
    """

    def __init__(self, text):
        marks = [float(t) for t in
                 re.findall(r"ExecutionTime = (\S+) s", text)]
        self.steps = len(marks)
        if self.steps < 3:
            raise TooShort(
                f"{self.steps} steps, 3 are needed:\n{text[-2000:]}")
        self.perStep = max(marks[-2] - marks[0], TICK) / (self.steps - 2)
        self.seconds = self.perStep * self.steps


def middle(runs):
    """Of several runs of the same case, that of median time."""
    time = statistics.median_low(run.perStep for run in runs)
    return next(run for run in runs if run.perStep == time)
