"""The error that plotResults.py prints without a traceback."""


class PlotError(Exception):
    """Says what is wrong, in which file, and what to do about it."""


def oneOf(names, limit=12):
    """Valid choices for an error message; long lists are shortened."""
    names = [str(name) for name in names]
    if not names:
        return "none"
    if len(names) > limit:
        half = limit//2
        names = names[:half] + ["..."] + names[-half:]
    return ", ".join(names)
