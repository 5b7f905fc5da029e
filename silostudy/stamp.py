"""A hash of sources: what Snakemake and kept kernels must watch, because neither sees a change in an imported module.

Imports are followed file by file, and tables by their names in the code: a change reruns what depends on it and nothing else.
"""

import ast
import hashlib
from functools import cache
from pathlib import Path

PACKAGE = Path(__file__).parent
TABLES = "tables"  # the room of the tables that code in any room may name
# which outputs and kinds of study there are, how sources are watched, and words on mistakes change no number
CHECKED = {PACKAGE / "tables/outputs.py", PACKAGE / "stamp.py", PACKAGE / "config/alone.py", *(PACKAGE / "stages").glob("*.py")}


def stamp(*places: str) -> str:
    """Short hash over every source file (.py, .csv, .bib, .html) that the named files or rooms hold or import."""
    digest = hashlib.sha256()
    for path in sources(*places):
        digest.update(f"{path.relative_to(PACKAGE)}\0".encode() + path.read_bytes())
    return digest.hexdigest()[:12]


def sources(*places: str) -> list[Path]:
    """The files behind a stamp; FileNotFoundError for a place that is not there."""
    reached: set[Path] = set()
    fresh = {file for place in places for file in _held(PACKAGE / place)}
    while fresh:
        reached |= fresh
        fresh = {target for path in fresh for target in _named(path)} - reached - CHECKED
    return sorted(reached)


def _held(place: Path) -> list[Path]:
    if place.with_suffix(".py").is_file():
        return [place.with_suffix(".py")]
    if not place.is_dir():
        raise FileNotFoundError(f"no room {place.name!r} in {PACKAGE}")
    return [file for file in place.rglob("*") if file.suffix in {".py", ".csv", ".bib", ".html"}]


@cache
def _named(path: Path) -> set[Path]:
    """Files of the package that a module imports, and tables that it names."""
    files = {file for file in [path.parent / "__init__.py"] if file.is_file()}
    if path.suffix != ".py":
        return files
    for node in ast.walk(ast.parse(path.read_text(encoding="utf-8"))):
        if isinstance(node, ast.ImportFrom) and node.module:
            if node.module == "silostudy.catalogue" and "members" in {alias.name for alias in node.names}:
                files |= {*path.parent.glob("*.py"), *path.parent.glob("*/__init__.py")}  # it imports its whole folder
            files |= _modules(node.module).union(*(_modules(f"{node.module}.{alias.name}") for alias in node.names))
        elif isinstance(node, ast.Import):
            files = files.union(*(_modules(alias.name) for alias in node.names))
        elif isinstance(node, ast.Constant) and isinstance(node.value, str) and node.value.endswith((".csv", ".bib", ".html")):
            files |= {folder / node.value for folder in (path.parent, PACKAGE / TABLES) if (folder / node.value).is_file()}
    return files


def _modules(name: str) -> set[Path]:
    """Files that importing a dotted name runs, its packages' own included."""
    top, *parts = name.split(".")
    if top != PACKAGE.name:
        return set()
    stems = [PACKAGE.joinpath(*parts[:k]) for k in range(1, len(parts) + 1)]
    return {file for stem in stems for file in (stem.with_suffix(".py"), stem / "__init__.py") if file.is_file()}
