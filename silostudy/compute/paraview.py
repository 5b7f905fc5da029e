"""Snapshots for ParaView: grains as points with radius and velocity, contacts as lines with force, written by meshio."""

from pathlib import Path
from xml.etree import ElementTree

import meshio
import numpy as np

from silostudy.dem.run import Run
from silostudy.files import replacing


def export(run: Run, folder: Path) -> list[Path]:
    """Writes two files a snapshot into the folder, NNN-discs.vtu or NNN-spheres.vtu, and NNN-forces.vtu; gives their names.

    discs.pvd or spheres.pvd, and forces.pvd, list them with their times (s).
    """
    space, snapshots = run.engine.space, run.recording.snapshots
    meshes = {
        f"{space.body}s": lambda snapshot: grains_mesh(run, snapshot),
        "forces": lambda snapshot: forces_mesh(snapshot, space.ways),
    }
    written, times = [], [float(snapshot["time"]) for snapshot in snapshots]
    for name, mesh_of in meshes.items():
        files = [_write(folder / f"{k:03d}-{name}.vtu", mesh_of(snapshot)) for k, snapshot in enumerate(snapshots)]
        _list(folder / f"{name}.pvd", dict(zip((file.name for file in files), times, strict=True)))
        written.append(files)
    return [file for both in zip(*written, strict=True) for file in both]


def solid(vectors: np.ndarray) -> np.ndarray:
    """Vectors (n, d) as (n, 3): those of the plane lie at a height of zero."""
    return np.column_stack([vectors, np.zeros((len(vectors), 3 - vectors.shape[1]))])


def grains_mesh(run: Run, snapshot: dict) -> meshio.Mesh:
    """A vertex a grain: radius (m), velocity (m/s), spin (rad/s), label, and kind where there are several."""
    motion, label, space, model = snapshot["motion"], snapshot["label"], run.engine.space, run.engine.model
    spin = motion[:, space.spin]
    return meshio.Mesh(
        solid(motion[:, space.place]),
        [("vertex", np.arange(len(label))[:, None])],
        point_data={
            "radius": np.asarray(model.radius)[label],
            "velocity": solid(motion[:, space.velocity]),
            "spin": spin if spin.shape[1] > 1 else spin[:, 0],
            "label": label,
        }
        | ({} if model.kind is None else {"kind": np.asarray(model.kind)[label]}),
    )


def forces_mesh(snapshot: dict, ways: int) -> meshio.Mesh:
    """A line a contact between grains, from centre to centre: the force (N/m, N) on its first grain."""
    place = dict(zip(snapshot["label"].tolist(), snapshot["motion"][:, :ways], strict=True))
    pairs = snapshot["pairs"]
    ends = np.array([[place[int(a)], place[int(b)]] for a, b in pairs[:, :2]]).reshape(-1, ways)
    lines = np.arange(len(ends)).reshape(-1, 2)
    return meshio.Mesh(solid(ends), [("line", lines)], cell_data={"force": [solid(pairs[:, 2 + ways :])]})


def _list(path: Path, times: dict[str, float]) -> None:
    """Write the list of files that ParaView reads as one series in time (s)."""
    root = ElementTree.Element("VTKFile", type="Collection", version="0.1")
    collection = ElementTree.SubElement(root, "Collection")
    for file, time in times.items():
        ElementTree.SubElement(collection, "DataSet", timestep=f"{time:.9g}", file=file)
    with replacing(path) as temporary:
        ElementTree.ElementTree(root).write(temporary)


def _write(path: Path, mesh: meshio.Mesh) -> Path:
    with replacing(path) as temporary:
        mesh.write(temporary, file_format="vtu")
    return path
