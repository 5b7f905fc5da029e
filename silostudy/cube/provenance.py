"""Provenance of a cube: attributes that go on every file. No time of day, so equal inputs give equal files."""

import hashlib
from collections.abc import Iterable
from importlib.metadata import version

from silostudy import __version__
from silostudy.stages import FILE_KINDS, STAGES
from silostudy.tables.references import cite

PACKAGES = ("numpy", "scipy", "xarray", "netCDF4", "numba")
# Contracts of names and dimensions in a cube -> what changed with them.  A new one is a new major version.
CONTRACTS = {
    1: "the first",
    2: "the dimension of pressure methods is pressure_method, no longer method",
    3: "scenes of discs and of spheres have the same names for the same things, as outflow_mass and energy",
}
OF_STAGES = {3: ("dem",)}  # contracts that changed cubes of some stages alone
CONTRACT = max(CONTRACTS)


def provenance(title: str, study: str, sources: Iterable[str], stage: str) -> dict[str, str | int]:
    """Attributes: study (canonical JSON) and its hash, stamp of the stage's sources, package versions, references used."""
    return {
        "Conventions": "CF-1.11",
        "title": title,
        "institution": "unknown (set by whoever publishes the file)",
        "source": f"silostudy {__version__}",
        "cube_contract": CONTRACT,
        "stage": stage,
        "history": f"computed by silostudy {__version__}",
        "references": "\n".join(cite(key) for key in dict.fromkeys(sources)),
        "study": study,
        "study_hash": hashlib.sha256(study.encode()).hexdigest()[:12],
        "source_stamp": next(kind for kind in FILE_KINDS.values() if STAGES[stage] in kind.stages).stamp(STAGES[stage]),
        "package_versions": ", ".join(f"{package} {version(package)}" for package in PACKAGES),
    }
