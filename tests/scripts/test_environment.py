"""etc/bashrc and etc/setup: what they set, install and refuse."""
import os
import subprocess

import pytest

from foamEnvironment import PROJECT, environment

ONE_LINE = """deb [signed-by=/k.gpg] http://example.org/debian stable main
# deb http://example.org/debian commented main
deb-src http://example.org/debian already main
deb cdrom:[Debian]/ stable main
deb\thttp://example.org/debian tabbed main
"""
DEB822 = """Types: deb
URIs: http://example.org/debian
Suites: stable

Types: deb deb-src
Enabled: no
URIs: http://example.org/other
Suites: stable
"""


def bash(script, **variables):
    """Run a bash script without any OpenFOAM in the environment."""
    foreign = ("WM_", "FOAM_", "SHOCKSHELL_", "MPI_")
    clean = {
        name: value for name, value in os.environ.items()
        if not name.startswith(foreign)
    }
    return subprocess.run(
        ["bash", "-c", script],
        env={**clean, "PROJECT": str(PROJECT), **variables},
        stdout=subprocess.PIPE,
        stderr=subprocess.PIPE,
        universal_newlines=True,
    )


def lastLine(done):
    return done.stderr.strip().split("\n")[-1]


@pytest.fixture
def commands(tmp_path):
    """A folder of stand-ins for commands, and the PATH with it first."""

    def make(**scripts):
        for name, script in scripts.items():
            path = tmp_path / "bin" / name.replace("_", "-")
            path.parent.mkdir(exist_ok=True)
            path.write_text("#!/bin/sh\n" + script)
            path.chmod(0o755)
        return f"{tmp_path}/bin:{os.environ['PATH']}"

    return make


@pytest.fixture
def otherOpenFOAM(tmp_path):
    """An OpenFOAM tree that looks usable; returns its variables."""

    def make(apiInfo, version, precision="DP"):
        tree = tmp_path / "tree"
        for folder in ("wmake", "src/OpenFOAM/lnInclude", "lib", "META-INFO"):
            (tree / folder).mkdir(parents=True)
        (tree / "lib" / "libOpenFOAM.so").touch()
        (tree / "wmake" / "wmake").touch(mode=0o755)
        (tree / "META-INFO" / "api-info").write_text(apiInfo)
        return {
            "WM_PROJECT": "OpenFOAM",
            "WM_PROJECT_DIR": str(tree),
            "WM_PROJECT_VERSION": version,
            "WM_OPTIONS": "linux64GccDPInt32Opt",
            "WM_PRECISION_OPTION": precision,
            "FOAM_LIBBIN": str(tree / "lib"),
        }

    return make


def test_environment_is_complete():
    variables = environment()
    built = f"{PROJECT}/platforms/{variables['WM_OPTIONS']}"
    assert variables["SHOCKSHELL_DIR"] == str(PROJECT)
    assert variables["SHOCKSHELL_SRC"] == f"{PROJECT}/src"
    assert variables["SHOCKSHELL_LIBBIN"] == f"{built}/lib"
    assert variables["SHOCKSHELL_APPBIN"] == f"{built}/bin"
    assert variables["PATH"].startswith(f"{built}/bin:")
    assert variables["LD_LIBRARY_PATH"].startswith(f"{built}/lib")


def test_environment_keeps_the_shell_as_it_was():
    done = bash(
        'set -eu; set -- one "two words"; cd /; before="$-"\n'
        'source "$PROJECT/etc/bashrc"; first="$PATH:$LD_LIBRARY_PATH"\n'
        'source "$PROJECT/etc/bashrc"; second="$PATH:$LD_LIBRARY_PATH"\n'
        '[ "$first" = "$second" ] && [ "$before" = "$-" ] && echo "$#$2$PWD"',
        **{k: v for k, v in environment().items() if k.startswith("WM_")},
        FOAM_LIBBIN=environment()["FOAM_LIBBIN"],
    )
    assert done.stdout == "2two words/\n", done.stderr


def test_sourced_openfoam_is_used(otherOpenFOAM):
    mine = otherOpenFOAM("api=1912\n", "v1912")
    done = bash('source "$PROJECT/etc/bashrc" && echo "$WM_PROJECT_DIR"', **mine)
    assert done.stdout.strip() == mine["WM_PROJECT_DIR"], done.stderr


@pytest.mark.parametrize(
    "apiInfo, version, precision, reason",
    [
        ("", "9", "DP", "(OpenFOAM 9) is not an OpenFOAM.com release"),
        ("api=1812\n", "v1812", "DP", "v1812, older than v1912"),
        ("api=1912\n", "v1912", "SP", "WM_PRECISION_OPTION SP, not DP"),
    ],
)
@pytest.mark.parametrize("script", ["source {}/etc/bashrc", "{}/etc/setup"])
def test_unsupported_openfoam_is_refused(
    otherOpenFOAM, script, apiInfo, version, precision, reason
):
    mine = otherOpenFOAM(apiInfo, version, precision)
    done = bash(script.format(PROJECT), **mine)
    assert done.returncode == 1
    assert reason in lastLine(done)


def test_no_openfoam_at_all(commands, tmp_path):
    path = commands(dpkg_query="exit 1")
    done = bash('set -e; source "$PROJECT/etc/bashrc"; echo reached', PATH=path)
    assert done.returncode == 1 and "reached" not in done.stdout
    assert "run" in lastLine(done) and "etc/setup" in lastLine(done)


def test_setup_without_root_says_what_to_install(commands, tmp_path):
    called = tmp_path / "called"
    path = commands(
        dpkg_query="exit 1", id="echo 1000", apt_get=f"touch {called}"
    )
    done = bash('"$PROJECT/etc/setup" build', PATH=path)
    assert done.returncode == 1
    for package in ("openfoam", "dpkg-dev", "g++", "libsuitesparse-dev"):
        assert package in lastLine(done)
    assert "apt-get install" in lastLine(done)
    assert not called.exists()


def test_setup_reports_a_failed_installation(commands):
    path = commands(
        dpkg_query="exit 1", id="echo 0", apt_get="echo E: no network; exit 100"
    )
    done = bash('"$PROJECT/etc/setup" build', PATH=path)
    assert done.returncode == 1
    assert "E: no network" in done.stderr
    assert "could not install" in lastLine(done)


def test_setup_installs_only_what_is_asked_for(commands, tmp_path):
    called = tmp_path / "called"
    path = commands(
        dpkg_query="exit 1", id="echo 0", apt_get=f'echo "$*" >> {called}'
    )
    done = bash('"$PROJECT/etc/setup" test', PATH=path)
    assert done.returncode == 0, done.stderr
    assert "libgtest-dev" in called.read_text()
    assert "openfoam" not in called.read_text()
    assert "matplotlib" not in called.read_text()


def test_setup_unknown_part():
    done = bash('"$PROJECT/etc/setup" plots')
    assert done.returncode == 1
    assert lastLine(done).endswith("'plots'; valid: build plot gmsh test")


def test_second_setup_does_nothing():
    done = bash('"$PROJECT/etc/setup" build test', **environment())
    assert done.returncode == 0
    assert done.stderr == "shockShellFoam: set-up: nothing to do (build test)\n"


def test_apt_entries_become_source_entries(tmp_path):
    apt, private = tmp_path / "apt", tmp_path / "private"
    (apt / "sources.list.d").mkdir(parents=True)
    (apt / "sources.list").write_text(ONE_LINE)
    (apt / "sources.list.d" / "more.list").write_text(ONE_LINE)
    (apt / "sources.list.d" / "debian.sources").write_text(DEB822)
    done = bash(
        '. "$PROJECT/etc/lib/apt.sh"; sourceEntries "$APT" "$PRIVATE"',
        APT=str(apt), PRIVATE=str(private),
    )
    assert done.returncode == 0, done.stderr
    lines = (
        "deb-src [signed-by=/k.gpg] http://example.org/debian stable main\n"
        "deb-src\thttp://example.org/debian tabbed main\n"
    )
    assert sorted(p.name for p in private.iterdir()) == [
        "debian.sources", "more.list.list", "sources.list.list"
    ]
    assert (private / "sources.list.list").read_text() == lines
    assert (private / "more.list.list").read_text() == lines
    assert (private / "debian.sources").read_text() == DEB822.replace(
        "Types: deb deb-src", "Types: deb"
    ).replace("Types: deb", "Types: deb-src")


def test_python_is_found_by_its_modules():
    found = bash('"$PROJECT/etc/python" numpy pytest')
    assert found.returncode == 0
    subprocess.run([found.stdout.strip(), "-c", "import numpy"], check=True)
    missing = bash('"$PROJECT/etc/python" numpy no_such_module')
    assert missing.returncode == 1
    assert "no python3 with numpy no_such_module" in missing.stderr
