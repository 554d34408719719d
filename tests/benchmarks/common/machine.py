"""What a reader needs to know about the machine, without its name."""
import os
import re
import subprocess
from pathlib import Path

from foamEnvironment import environment


class MissingProgram(RuntimeError):
    """A program that the benchmark needs is not there."""


def need(*programs):
    """Stop unless all are on the path of etc/bashrc."""
    folders = environment()["PATH"].split(os.pathsep)
    for program in programs:
        if not any(os.access(os.path.join(f, program), os.X_OK)
                   for f in folders):
            raise MissingProgram(
                f"{program} is not on the path of etc/bashrc; the comparison"
                " needs it (Debian's package openfoam has it)")


def instructions():
    """The widest registers of the processor, as /proc/cpuinfo has them."""
    try:
        with open("/proc/cpuinfo") as stream:
            flags = re.search(r"^flags\s*:(.*)$", stream.read(), re.M)
    except OSError:
        flags = None
    known = set(flags.group(1).split()) if flags else set()
    for flag, name in (("avx512f", "AVX-512"), ("avx2", "AVX2"),
                       ("sse2", "SSE2")):
        if flag in known:
            return name
    return "unknown"


def facts():
    """One sentence."""
    cores = len(os.sched_getaffinity(0))
    return f"{os.uname().machine} with {instructions()}, {cores} cores"


def load():
    """Load over the last minute; 1 with one program at work."""
    return os.getloadavg()[0]


def compiled(source, program, *options):
    """Compile a C++ file with the environment's compiler."""
    subprocess.run(["g++", "-O3", "-march=native", *options, str(source),
                    "-o", str(program)], check=True, env=environment())
    return program


def triad(folder):
    """triad.cpp, compiled into the folder."""
    return compiled(Path(__file__).parent / "triad.cpp", folder / "triad")


def bandwidth(folder):
    """GB/s of one core, see triad.cpp."""
    said = subprocess.run([str(triad(folder))], stdout=subprocess.PIPE,
                          check=True, universal_newlines=True).stdout
    return float(said.split()[0])
