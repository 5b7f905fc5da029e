"""A hash of source rooms: what Snakemake and numba's cache must watch, because neither sees a change in an imported module."""

import hashlib
from pathlib import Path

PACKAGE = Path(__file__).parent
SHAKING = ("seismic/beam", "seismic/readers", "seismic/records")  # what a seismic scene is made of
SCENE = (
    "catalogue",
    "errors",
    "files",
    "tables",
    "config",
    "scene",
    "figures/__init__",
    "pressure",
    "buckling",
    "packing",
    *SHAKING,
)
# stage -> rooms whose change makes its results stale (a test follows the imports)
STAGES = {
    "cases": SCENE,
    "pressure": (*SCENE, "compute", "cube"),
    "uncertainty": (*SCENE, "compute", "cube"),
    "buckling": (*SCENE, "compute", "cube"),
    "shell": (*SCENE, "compute", "cube"),
    "seismic": (*SCENE, "compute", "cube", "seismic"),
    "dem": (*SCENE, "compute", "cube", "contact", "dem"),
    "grains": (*SCENE, "compute", "cube", "contact", "dem", "seismic"),
    "accuracy": (*SCENE, "accuracy", "compute", "cube", "contact", "dem", "seismic"),
    "draw": ("catalogue", "errors", "files", "tables", "cube", "figures"),
}


def stamp(*rooms: str) -> str:
    """Short hash over every source file (.py, .csv, .bib) of the named rooms; all of the package when none is named."""
    digest = hashlib.sha256()
    for path in sorted(file for room in rooms or (".",) for file in _sources(PACKAGE / room)):
        digest.update(f"{path.relative_to(PACKAGE)}\0".encode() + path.read_bytes())
    return digest.hexdigest()[:12]


def _sources(room: Path) -> list[Path]:
    if room.with_suffix(".py").is_file():
        return [room.with_suffix(".py")]
    if not room.is_dir():
        raise FileNotFoundError(f"no room {room.name!r} in {PACKAGE}")
    return [file for file in room.rglob("*") if file.suffix in {".py", ".csv", ".bib"}]
