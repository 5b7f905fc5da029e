"""Snapshots for ParaView: discs as points with radius and velocity, contacts as lines with force, written by meshio."""

from pathlib import Path

import meshio
import numpy as np

from silostudy.dem.run import Run
from silostudy.files import replacing


def export(run: Run, folder: Path) -> list[Path]:
    """Two files a snapshot in the folder, NNN-discs.vtu and NNN-forces.vtu; gives their names."""
    written = []
    for k, snapshot in enumerate(run.recording.snapshots):
        written.append(_write(folder / f"{k:03d}-discs.vtu", discs_mesh(run, snapshot)))
        written.append(_write(folder / f"{k:03d}-forces.vtu", forces_mesh(snapshot)))
    return written


def discs_mesh(run: Run, snapshot: dict) -> meshio.Mesh:
    """A vertex a disc: radius (m), velocity (m/s), spin (rad/s), label."""
    motion, label = snapshot["motion"], snapshot["label"]
    flat = np.zeros(len(label))
    return meshio.Mesh(
        np.column_stack([motion[:, :2], flat]),
        [("vertex", np.arange(len(label))[:, None])],
        point_data={
            "radius": np.asarray(run.engine.model.radius)[label],
            "velocity": np.column_stack([motion[:, 2:4], flat]),
            "spin": motion[:, 4],
            "label": label,
        },
    )


def forces_mesh(snapshot: dict) -> meshio.Mesh:
    """A line a contact between discs, from centre to centre: the force (N/m) on its first disc."""
    place = dict(zip(snapshot["label"].tolist(), snapshot["motion"][:, :2], strict=True))
    pairs = snapshot["pairs"]
    ends = np.array([[place[int(a)], place[int(b)]] for a, b in pairs[:, :2]]).reshape(-1, 2)
    lines = np.arange(len(ends)).reshape(-1, 2)
    force = np.column_stack([pairs[:, 4:6], np.zeros(len(pairs))])
    return meshio.Mesh(np.column_stack([ends, np.zeros(len(ends))]), [("line", lines)], cell_data={"force": [force]})


def _write(path: Path, mesh: meshio.Mesh) -> Path:
    with replacing(path) as temporary:
        mesh.write(temporary, file_format="vtu")
    return path
