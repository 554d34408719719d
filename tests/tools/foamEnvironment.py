"""The environment of etc/bashrc, for programs started from Python."""
import functools
import os
import subprocess
from pathlib import Path

PROJECT = Path(__file__).resolve().parents[2]


@functools.lru_cache(maxsize=None)
def environment():
    """All variables after sourcing etc/bashrc, as a dict."""
    script = 'source "$1" && env -0'
    done = subprocess.run(
        ["bash", "-c", script, "bash", str(PROJECT / "etc" / "bashrc")],
        stdout=subprocess.PIPE,
        stderr=subprocess.PIPE,
        universal_newlines=True,
    )
    if done.returncode != 0:
        raise RuntimeError(done.stderr)
    pairs = (item.split("=", 1) for item in done.stdout.split("\0") if item)
    variables = dict(pairs)

    # mpirun refuses root, the only user of many containers
    if os.getuid() == 0:
        variables["OMPI_ALLOW_RUN_AS_ROOT"] = "1"
        variables["OMPI_ALLOW_RUN_AS_ROOT_CONFIRM"] = "1"
    return variables
