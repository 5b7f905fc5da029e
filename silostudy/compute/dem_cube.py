"""The cube of everything that the run of a discrete-element scene recorded."""

from typing import Any

import numpy as np
import xarray as xr

from silostudy.choice.promise import Choice, promises
from silostudy.compute.expected import notes_of, verdicts
from silostudy.compute.lid_cube import lid_arrays
from silostudy.compute.observers import SOURCES, observed, observers_notes
from silostudy.compute.outlet_cube import mean_outflow, outlet_arrays, outlet_notes
from silostudy.compute.sphere_cube import sphere_arrays, sphere_notes
from silostudy.config.dem import DemScene
from silostudy.config.grain_scenes import AnyScene
from silostudy.config.spheres import SphereScene
from silostudy.cube.assemble import assemble
from silostudy.dem.follow import steps_made
from silostudy.dem.integrate import INTEGRATORS
from silostudy.dem.ledger import ENTRIES
from silostudy.dem.model import Model
from silostudy.dem.run import Run
from silostudy.dem.walls import faces
from silostudy.dem.watch import first_of_faces
from silostudy.scene.dem import plane_silo_of


def cube_of(run: Run, scene: AnyScene, choice: Choice | None = None) -> xr.Dataset:
    """The cube of everything that a run recorded; choice: that of its settings, where the scene asked for an accuracy."""
    model, record = run.engine.model, run.recording
    body = model.space.body
    data = disc_arrays(run) | slit_arrays(run, scene) if isinstance(scene, DemScene) else sphere_arrays(run, scene)
    data |= (
        observed(run, scene)
        | steps_of(run)
        | {
            "event_time": np.array([time for time, _, _ in record.happened], float),
            "event_action": np.array([f"{trigger}: {action}" for _, trigger, action in record.happened], dtype=str),
        }
    )
    filled = {name: values for name, values in data.items() if values.size}
    notes = {
        **promises([choice] if choice else []),
        **scene.own_methods,
        "time_step_s": model.step,
        "steps": steps_made(run),
        f"{body}s_left": run.engine.n,
        **{f"{body}s_{way}": count for way, count in record.left.items()},
        **begun(run),
        **notes_of(verdicts(run, scene)),
        **observers_notes(run, scene, data),
    }
    if not np.isnan(rate := mean_outflow(run)):
        notes["mean_outflow_kg_s" if isinstance(scene, SphereScene) else "mean_outflow_kg_m_s"] = rate
    notes |= sphere_notes(scene, run) if isinstance(scene, SphereScene) else disc_notes(scene, run)
    if run.trouble:
        notes["stopped"] = run.trouble
    return assemble(scene, "dem", filled, sources=[*sources_of(model), *(SOURCES if scene.record.fields else ())], notes=notes)


def begun(run: Run) -> dict[str, float]:
    """Attributes of a run that goes on from another: when it began (s), and the mass of all there or yet to come."""
    engine = run.engine
    if not run.began:
        return {}
    mass = engine.mass.sum() + engine.model.mass[run.come :].sum() + sum(run.recording.lost.values())
    return {"began_s": run.began * engine.model.dt, "began_with_kg": float(mass)}


def steps_of(run: Run) -> dict[str, np.ndarray]:
    """Arrays by name of the steps of a run whose steps change; none of one whose step stays."""
    if not run.engine.model.pace.changes:
        return {}
    tick, ticks = np.array(run.recording.steps).T
    return {"step_time": tick * run.engine.model.dt, "step_from_then": ticks * run.engine.model.dt}


def disc_notes(scene: DemScene, run: Run) -> dict[str, Any]:
    """Attributes of a scene of discs: its kinds, and when its outlet opened where that has no name."""
    kinds = {"grain_kinds": ", ".join(scene.kinds)} if scene.other_grains else {}
    return kinds | ({} if scene.outlets else outlet_notes(run, plane_silo_of(scene).outlet_widths))


def disc_arrays(run: Run) -> dict[str, np.ndarray]:
    """Arrays by name of a scene of discs."""
    model = run.engine.model
    data = {"disc": np.arange(len(model.x)), "disc_radius": np.array(model.radius), "disc_mass": model.mass}
    data |= {} if model.kind is None else {"disc_kind": np.asarray(model.kind, np.int32)}
    return data | _windows(run) | _snapshots(run)


def slit_arrays(run: Run, scene: DemScene) -> dict[str, np.ndarray]:
    """Arrays by name of outlets of a scene of discs and of what left by them."""
    silo = plane_silo_of(scene)
    return outlet_arrays(run, silo.outlet_widths, {slit.name: slit.edges for slit in silo.slits})


def sources_of(model: Model) -> list[str]:
    """Sources of the laws and the integrator that the model uses."""
    laws = (*model.pair_contact.rows, *model.wall_contact.rows)
    return sorted({INTEGRATORS[model.integrator].source, *(law.source for law in laws if law.acts)})


def _windows(run: Run) -> dict[str, np.ndarray]:
    record, model = run.recording, run.engine.model
    if not record.window:
        return {}
    data = {"window_time": np.array(record.window_time)}
    if model.watched:
        force, cells = np.array(record.window), _cells(model)
        length = np.where(cells["wall_cell_length"] > 0.0, cells["wall_cell_length"], np.nan)  # an end has none
        for way, (name, stress) in enumerate((("normal", "pressure"), ("shear", "shear_stress"))):
            for k, what in enumerate(("mean", "min", "max")):
                data[f"wall_{name}_force_{what}"] = force[:, :, way, k]
                data[f"wall_{stress}_{what}"] = force[:, :, way, k] / length
        data |= cells | _wholes(force[:, :, :, 0], np.array(record.whole), model)
    if model.booked:
        data |= {"energy": np.array(record.energy), "energy_entry": np.array(ENTRIES)}
    return data | lid_arrays(run)


def _wholes(mean: np.ndarray, extremes: np.ndarray, model: Model) -> dict[str, np.ndarray]:
    """Forces (N/m) on whole walls, from mean forces of cells (windows, cells, ways), and least and largest of walls."""
    first = first_of_faces(model.space.walls_of(model.walls).cells)
    total = np.add.reduceat(mean, first, axis=1)
    data = {"surface": np.array([name for name, _ in faces(model.walls)])}
    for way, name in enumerate(("normal", "shear")):
        for what, values in (("mean", total), ("min", extremes[..., 0]), ("max", extremes[..., 1])):
            data[f"surface_{name}_force_{what}"] = values[:, :, way]
    return data


def _cells(model: Model) -> dict[str, np.ndarray]:
    """Wall, middle and length of each cell: a wall's start, its parts, its end."""
    names, places, lengths = [], [], []
    for name, wall in faces(model.walls):
        start, end = np.array(wall.start), np.array(wall.end)
        middle = np.r_[0.0, (np.arange(wall.cells) + 0.5) / wall.cells, 1.0]
        names += [name] * len(middle)
        places.append(start + middle[:, None] * (end - start))
        lengths += [0.0, *[float(np.hypot(*(end - start))) / wall.cells] * wall.cells, 0.0]
    x, y = np.vstack(places).T
    data = {"wall_name": np.array(names), "wall_cell_x": x, "wall_cell_y": y, "wall_cell_length": np.array(lengths)}
    return data | {"wall_cell": np.arange(len(names))}


def _snapshots(run: Run) -> dict[str, np.ndarray]:
    snapshots = run.recording.snapshots
    if not snapshots:
        return {}
    motion = np.full((len(snapshots), len(run.engine.model.x), 5), np.nan)
    for k, snapshot in enumerate(snapshots):
        motion[k, snapshot["label"]] = snapshot["motion"]
    contacts = [(k, on, row) for k, s in enumerate(snapshots) for on, name in enumerate(("pairs", "walls")) for row in s[name]]
    table = np.array([row for _, _, row in contacts]).reshape(-1, 6)
    data = {f"disc_{name}": motion[:, :, k] for k, name in enumerate(("x", "y", "u", "v", "spin"))}
    data |= {
        "snapshot": np.arange(len(snapshots)),
        "snapshot_time": np.array([float(snapshot["time"]) for snapshot in snapshots]),
    }
    data |= {"contact_snapshot": np.array([k for k, _, _ in contacts], np.int32)}
    data |= {"contact_on_wall": np.array([on for _, on, _ in contacts], np.int8)}
    for k, name in enumerate(("first", "second")):
        data[f"contact_{name}"] = table[:, k].astype(np.int32)
    for k, name in enumerate(("x", "y", "force_x", "force_y"), start=2):
        data[f"contact_{name}"] = table[:, k]
    return data
