"""Triangles of a mesh as inserts of a scene: polygons of one curved sheet."""

from pathlib import Path
from typing import Any

import numpy as np

from silostudy.errors import BadInput

UNITS = {"m": 1.0, "mm": 1e-3}
MOST = 2000  # triangles: a sphere near a sheet asks each of them
ROUND = 9  # decimals of a metre: corners that differ by less are one
LEAST = 1e-12  # m2: what is smaller is no triangle


def read_triangles(path: Path) -> np.ndarray:
    """Corners (n, 3, 3) of the triangles of a mesh file, in its own unit; BadInput where it cannot be read."""
    try:
        import trimesh
    except ImportError:
        raise BadInput("mesh", str(path), "needs a reader of meshes: uv sync --group meshes") from None
    if not path.is_file():
        raise BadInput("mesh", str(path), "is not there")
    if path.suffix.lower() == ".stl":
        require_whole(path)
    try:
        mesh = trimesh.load_mesh(path)
        return np.asarray(mesh.triangles, float)
    except Exception as error:  # whatever the reader of one format or another raises
        raise BadInput("mesh", str(path), f"is no mesh that can be read: {error}") from None


def require_whole(path: Path) -> None:
    """BadInput for an STL file that is cut off, which readers take as an empty one."""
    content = path.read_bytes()
    said, held = int.from_bytes(content[80:84], "little"), (len(content) - 84) / 50
    if len(content) >= 84 and held == said:
        return
    if not content.lstrip().startswith(b"solid"):
        raise BadInput("mesh", str(path), "is no STL file, or cut off: its length is not that of the triangles it says it has")
    if b"endsolid" not in content[-200:]:
        raise BadInput("mesh", str(path), "is cut off: an STL file in words ends with endsolid")


def facets_of(triangles: np.ndarray, name: str, unit: str, where: str = "") -> list[dict[str, Any]]:
    """Entries of a scene's `inserts`; BadInput for an unknown unit, or for more or fewer triangles than a sheet may have."""
    if unit not in UNITS:
        raise BadInput("--unit", unit, f"unknown; known: {', '.join(UNITS)}")
    corners = np.round(np.asarray(triangles) * UNITS[unit], ROUND) + 0.0
    if len(wrong := np.flatnonzero(~np.isfinite(corners).all(axis=(1, 2)))):
        raise BadInput("mesh", f"triangle {wrong[0] + 1}", "has a corner that is no finite number", where)
    across = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    corners = corners[0.5 * np.linalg.norm(across, axis=1) > LEAST]
    if not 1 <= len(corners) <= MOST:
        told = "a coarser mesh may do" if len(corners) else "none in the file has an area"
        raise BadInput("mesh", f"{len(corners)} triangles", f"must be from 1 to {MOST}: {told}", where)
    return [
        {"kind": "polygon", "name": f"{name}_{number}", "sheet": name, "corners_m": corner.tolist()}
        for number, corner in enumerate(corners, 1)
    ]
