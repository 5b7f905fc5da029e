"""Observers of a scene of grains: coarse-grained fields and statistics of contacts, as asked for and as arrays of the cube."""

from functools import partial
from typing import Any

import numpy as np

from silostudy.config.dem import DemScene
from silostudy.config.grain_scenes import AnyScene
from silostudy.config.observers import MOST, FieldsConfig
from silostudy.dem.coarse import KERNEL, LINES, POINTS, Fields, fields_now
from silostudy.dem.contact_statistics import Statistics, statistics
from silostudy.dem.grid import Grid
from silostudy.dem.model import Model
from silostudy.dem.observer import Observer
from silostudy.dem.run import Run
from silostudy.dem.stable_now import stable_now
from silostudy.errors import BadInput
from silostudy.scene.cautions import DEEP
from silostudy.scene.spheres import space_silo_of

# keys of the section `record`
FIELDS = "fields"
STATISTICS = "contact_statistics"
STABLE = "contacts_stable_step"  # read with the statistics
SOURCES = ("goldhirsch_2010", "weinhart_2012")  # of the fields


def observers_of(scene: AnyScene, model: Model) -> tuple[Observer, ...]:
    """The observers that a scene asks for."""
    observers = []
    if asked := scene.record.fields:
        width, grid = width_of(asked, model), grid_of(scene, asked, model)
        if grid.cells > MOST:
            told = (
                f"spreads over {grid.cells} cells with those beyond the walls; at most {MOST}: a smaller width, or fewer cells"
            )
            raise BadInput("record.fields.width_mm", 1e3 * width, told)
        read = partial(fields_now, grid=grid, width=width)
        observers.append(Observer(FIELDS, _steps(asked.every_s, model.dt), read))
    if scene.record.contact_statistics is not None:
        every = _steps(scene.record.contact_statistics.every_s, model.dt)
        observers += [Observer(STATISTICS, every, statistics), Observer(STABLE, every, lambda engine: (stable_now(engine),))]
    return tuple(observers)


def _steps(every: float, dt: float) -> int:
    return max(1, round(every / dt))


def width_of(asked: FieldsConfig, model: Model) -> float:
    """Width (m) of the kernel."""
    return 2.0 * float(model.radius.mean()) if asked.width_mm is None else asked.width_mm / 1e3


def grid_of(scene: AnyScene, asked: FieldsConfig, model: Model) -> Grid:
    """Cells of the inside of the silo, and around them as far as the kernel reaches."""
    cells, margin = asked.cells, 2.0 * width_of(asked, model)
    if isinstance(scene, DemScene):
        top = float(max(max(wall.start[1], wall.end[1]) for wall in model.walls))
        return Grid.around((0.0, 0.0), (scene.silo.width_m, top), cells, margin)
    space = space_silo_of(scene)
    a, b = space.plan.half
    if len(cells) == 2:
        return Grid.around((0.0, 0.0), (a, space.top), cells, margin, round=True)
    return Grid.around((-a, -b, 0.0), (a, b, space.top), cells, margin)


def observed(run: Run, scene: AnyScene) -> dict[str, np.ndarray]:
    """Arrays of the cube by name of what a run's observers read."""
    arrays: dict[str, np.ndarray] = {}
    asked, model = scene.record.fields, run.engine.model
    if asked and (readings := run.recording.readings.get(FIELDS)):
        arrays |= _fields(*_columns(readings), grid_of(scene, asked, model), model)
    if readings := run.recording.readings.get(STATISTICS):
        arrays |= _statistics(*_columns(readings), run.engine.space.ways)
        arrays[STABLE] = _columns(run.recording.readings[STABLE])[1][0]
    return arrays


def _columns(readings: list) -> tuple[np.ndarray, list[np.ndarray]]:
    """Times (s), and each thing that was read at all of them."""
    times, read = zip(*readings, strict=True)
    return np.array(times), [np.array(column) for column in zip(*read, strict=True)]


def _fields(times: np.ndarray, read: list[np.ndarray], grid: Grid, model: Model) -> dict[str, np.ndarray]:
    ways, volume = np.array(grid.ways), "field_cell_volume" if model.space.ways == 3 else "field_cell_area"
    data = {f"field_{name}": values for name, values in zip(Fields._fields, read, strict=True)}
    data |= {f"field_{name}": column for name, column in zip(grid.coordinates, grid.middles.T, strict=True)}
    data |= {"field_time": times, "field_cell": np.arange(grid.cells), "field_way": ways, "field_of": ways}
    return data | {volume: grid.volumes}


def _statistics(times: np.ndarray, read: list[np.ndarray], ways: int) -> dict[str, np.ndarray]:
    data = {f"contact_{name}": values for name, values in zip(Statistics._fields, read, strict=True)}
    names = np.array(list("xyz"[:ways]))
    return data | {"statistics_time": times, "fabric_way": names, "fabric_of": names}


def observers_notes(run: Run, scene: AnyScene, data: dict[str, np.ndarray]) -> dict[str, Any]:
    """Attributes: the kernel of the fields, and a warning where overlaps are deep."""
    notes: dict[str, Any] = {}
    if asked := scene.record.fields:
        notes = {
            "field_width_m": width_of(asked, run.engine.model),
            "field_kernel": f"{KERNEL}; by {POINTS} points, times {LINES} along a branch",
        }
    overlaps = [data[name] for name in ("contact_deepest_overlap", "deepest_overlap") if name in data]
    deepest = max((float(np.nanmax(values, initial=0.0)) for values in overlaps), default=0.0)
    if deepest > DEEP:
        notes["deep_overlaps"] = (
            f"up to {deepest:.1%} of a radius where records look, beyond {DEEP:.0%}: contacts are soft for what they carry"
        )
    return notes
