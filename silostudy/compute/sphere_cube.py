"""The cube of everything that the run of a scene of spheres recorded."""

from collections.abc import Mapping
from math import nan

import numpy as np

from silostudy.compute.lid_cube import lid_arrays
from silostudy.compute.outlet_cube import outlet_arrays, outlet_notes
from silostudy.config.spheres import SphereScene
from silostudy.dem.ledger import ENTRIES
from silostudy.dem.model import Model
from silostudy.dem.run import Run
from silostudy.dem.space.cells import Face, areas, cuts, faces, middles
from silostudy.dem.space.felt import LOAD, TORQUE
from silostudy.dem.space.level import Outline
from silostudy.scene.space_silo import LID, SpaceSilo
from silostudy.scene.spheres import space_silo_of

FELT = (
    ("normal", "pressure"),
    ("shear", "shear_stress"),
    ("cross", "cross_shear_stress"),
)  # what a cell feels, and over its area
SPIN = 2  # of what is recorded of a surface that moves
MOTION = ("x", "y", "z", "u", "v", "w", "spin_x", "spin_y", "spin_z")


def sphere_arrays(run: Run, scene: SphereScene) -> dict[str, np.ndarray]:
    """Arrays of the cube by name."""
    model = run.engine.model
    data = {"grain": np.arange(len(model.x)), "grain_radius": np.array(model.radius), "grain_mass": model.mass}
    if model.kind is not None:
        data |= {"grain_kind": np.asarray(model.kind, np.int32)}
    space = space_silo_of(scene)
    named = space.openings if scene.outlets else {}
    spans = {name: opening.chord for name, opening in named.items()}
    outlets = outlet_arrays(run, widths(space), spans) | outlet_places(named)
    return data | _windows(run) | _snapshots(run) | outlets | insert_arrays(scene)


def outlet_places(openings: Mapping[str, Outline]) -> dict[str, np.ndarray]:
    """Middles and widths (m) along x and y of outlets with names."""
    if not openings:
        return {}
    middles, halves = (np.array([getattr(opening, name) for opening in openings.values()]).T for name in ("middle", "half"))
    named = {"outlet_x": middles[0], "outlet_y": middles[1]}
    return named | {"outlet_width_x": 2.0 * halves[0], "outlet_width_y": 2.0 * halves[1]}


def sphere_notes(scene: SphereScene, run: Run) -> dict[str, float | str]:
    """Attributes that figures draw the silo by, m and s."""
    space = space_silo_of(scene)
    cut = next(iter(space.openings.values()), space.opening)
    return {
        **({} if scene.outlets else outlet_notes(run, widths(space))),
        "half_width_m": space.plan.half[0],
        "outlet_half_width_m": cut.half[0] if cut else 0.0,
        "outlet_middle_m": cut.middle[0] if cut else 0.0,
        "transition_height_m": space.bottom,
        "top_height_m": space.top,
        "hydraulic_radius_m": space.silo.hydraulic_radius,
        "plan_area_m2": space.silo.area,
        **{f"gravity_{way}_m_s2": pull for way, pull in zip("xyz", scene.gravity_m_s2, strict=True)},
        **({"grain_kinds": ", ".join(scene.grain_kinds)} if scene.other_grains else {}),
    }


def insert_arrays(scene: SphereScene) -> dict[str, np.ndarray]:
    """Lines (m) in which the slice through the axis along x cuts the inserts, one after the other with a gap after each."""
    lines = [(insert.name, line) for insert in space_silo_of(scene).inserts for line in cuts(insert)]
    if not lines:
        return {}
    x, z = np.vstack([np.vstack([line, (np.nan, np.nan)]) for _, line in lines]).T
    names = np.repeat([name for name, _ in lines], [len(line) + 1 for _, line in lines])
    return {"insert_point": np.arange(len(x)), "insert_name": names, "insert_x": x, "insert_z": z}


def widths(space: SpaceSilo) -> dict[str, float]:
    """Width (m) along x of each outlet by its name, by which those grow that open at a speed."""
    return {name: 2.0 * opening.half[0] for name, opening in space.openings.items()}


def _windows(run: Run) -> dict[str, np.ndarray]:
    """Forces of the cells over windows, their pressures, and the totals of each surface."""
    record, model = run.recording, run.engine.model
    if not record.window:
        return {}
    data = {"window_time": np.array(record.window_time)}
    if model.booked:
        data |= {"energy": np.array(record.energy), "energy_entry": np.array(ENTRIES)}
    data |= _felt(np.array(record.window), np.array(record.whole), model) if model.watched else {}
    if model.moving and model.watched:
        walls = [face.wall for face in faces(model.walls, LID)]
        data |= {"surface_spin": np.array(record.motion)[:, walls, SPIN]}
    return data | lid_arrays(run)


def load_at_end(run: Run) -> float:
    """Load (N) on all surfaces, mean over the last window; NaN where none was kept."""
    record, model = run.recording, run.engine.model
    if not (record.window and model.watched):
        return nan
    return float(_felt(np.array(record.window[-1:]), np.array(record.whole[-1:]), model)["surface_load"].sum())


def _felt(force: np.ndarray, whole: np.ndarray, model: Model) -> dict[str, np.ndarray]:
    """Forces (N; windows, cells, ways, mean and least and largest), pressures and totals of surfaces (least and largest)."""
    data = _cells(model)
    for way, (name, stress) in enumerate(FELT):
        for k, what in enumerate(("mean", "min", "max")):
            data[f"wall_{name}_force_{what}"] = force[:, :, way, k]
            data[f"wall_{stress}_{what}"] = force[:, :, way, k] / data["wall_cell_area"]
    seen = faces(model.walls, LID)
    counts = np.array([face.count for face in seen])
    total = np.add.reduceat(force[:, :, :, 0], np.cumsum(counts) - counts, axis=1)
    data |= {f"surface_{name}_force_mean": total[:, :, way] for way, (name, _) in enumerate(FELT)}
    for way, (name, _) in enumerate(FELT):
        for k, what in enumerate(("min", "max")):
            data[f"surface_{name}_force_{what}"] = whole[:, :, way, k]
    data |= {"surface_load": downward(total, np.array([face.lean for face in seen]))}
    data |= {"surface_torque": total[:, :, TORQUE]} if model.moving else {}
    return data | {"surface": np.array([face.name for face in seen])} | _sheets(seen)


def downward(force: np.ndarray, lean: np.ndarray) -> np.ndarray:
    """Downward force (N; windows, parts) of forces (N; windows, parts, ways) on parts of surfaces, or whole ones, that lean so.

    Beside an eccentric cone it is recorded; else it follows from the forces across and along each part.
    """
    return force[:, :, LOAD] if force.shape[2] > LOAD else (force[:, :, :2] * lean).sum(axis=2)


def _sheets(seen: list[Face]) -> dict[str, np.ndarray]:
    """Name of the curved sheet of each face, where some are facets; of others their own."""
    return {"surface_sheet": np.array([face.sheet or face.name for face in seen])} if any(face.sheet for face in seen) else {}


def _cells(model: Model) -> dict[str, np.ndarray]:
    """Surface, middle, area of each cell, and its angle about the axis."""
    seen = faces(model.walls, LID)
    x, y, z = np.vstack([middles(model.walls[face.wall]) for face in seen]).T
    names = np.repeat([face.name for face in seen], [face.count for face in seen])
    area = np.concatenate([areas(model.walls[face.wall]) for face in seen])
    return {
        "wall_cell": np.arange(len(names)), "wall_name": names, "wall_cell_x": x, "wall_cell_y": y, "wall_cell_z": z,
        "wall_cell_turn": np.arctan2(y, x) % (2.0 * np.pi),
        "wall_cell_area": np.where(area > 0.0, area, np.nan),  # a round floor's box of cells has corners beyond it
    }  # fmt: skip


def _snapshots(run: Run) -> dict[str, np.ndarray]:
    """Places, velocities, spins and contacts of every snapshot, and how deep its deepest overlap is."""
    snapshots, model = run.recording.snapshots, run.engine.model
    if not snapshots:
        return {}
    motion = np.full((len(snapshots), len(model.x), len(MOTION)), np.nan)
    for k, snapshot in enumerate(snapshots):
        motion[k, snapshot["label"]] = snapshot["motion"]
    tables = [(k, on, snapshot[name]) for k, snapshot in enumerate(snapshots) for on, name in enumerate(("pairs", "walls"))]
    table, counts = np.vstack([rows for *_, rows in tables]), [len(rows) for *_, rows in tables]
    data = {f"grain_{name}": motion[:, :, k] for k, name in enumerate(MOTION)}
    data |= {
        "snapshot": np.arange(len(snapshots)),
        "snapshot_time": np.array([float(snapshot["time"]) for snapshot in snapshots]),
    }
    data |= {"contact_snapshot": np.repeat(np.array([k for k, *_ in tables], np.int32), counts)}
    data |= {"contact_on_wall": np.repeat(np.array([on for _, on, _ in tables], np.int8), counts)}
    for k, name in enumerate(("first", "second")):
        data[f"contact_{name}"] = table[:, k].astype(np.int32)
    for k, name in enumerate(("x", "y", "z"), start=2):
        data[f"contact_{name}"], data[f"contact_force_{name}"] = table[:, k], table[:, k + 3]
    return data | {"deepest_overlap": np.array([_deepest(model, motion[k], snapshot) for k, snapshot in enumerate(snapshots)])}


def _deepest(model: Model, motion: np.ndarray, snapshot: dict) -> float:
    """Deepest overlap of two spheres over the smaller radius (1); 0 where none touch."""
    i, j = snapshot["pairs"][:, :2].astype(int).T
    gap = np.linalg.norm(motion[i, :3] - motion[j, :3], axis=1)
    overlap = (model.radius[i] + model.radius[j] - gap) / np.minimum(model.radius[i], model.radius[j])
    return float(overlap.max(initial=0.0))
