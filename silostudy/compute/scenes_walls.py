"""Forces on the walls of a round silo of spheres, over height and angle: at rest, and window by window in flow."""

from typing import TypeGuard

import numpy as np

from silostudy.compute.scenes_windows import Numbers, whole_windows
from silostudy.config.grain_scenes import AnyScene
from silostudy.config.spheres import SphereScene
from silostudy.cube.contents import levelled
from silostudy.dem.run import CHECK_EVERY, Run
from silostudy.dem.space.cells import areas, faces, middles
from silostudy.scene.space_silo import HOPPER, LID, WALL
from silostudy.scene.spheres import space_silo_of

ROUND = (WALL, HOPPER)  # surfaces whose cells are levels and turns


def keeps_walls(scene: AnyScene) -> TypeGuard[SphereScene]:
    """Whether the pressures on the walls of a scene are kept: of spheres in a round silo whose wall forces are recorded."""
    return isinstance(scene, SphereScene) and scene.silo.plan == "circular" and scene.record.wall_force_window_s is not None


def windows_in_flow(scene: SphereScene) -> int:
    """Number of whole windows after the first event: up to the stop where that comes after a time, else up to the limit."""
    last, window = scene.events[-1], scene.record.wall_force_window_s
    assert window is not None
    span = last.value if last.when == "after" and last.value is not None else scene.march.limit_s
    return max(1, int(span / window + 1e-6) - 1)  # the outlet opens within a window, which is no whole one of the flow


def wall_coordinates(scene: SphereScene) -> dict[str, np.ndarray]:
    """Number of the level from below, angle about the axis (rad), number of the whole window after the first event."""
    levels, turns = scene.record.pressure_cells
    return {
        "wall_level": np.arange(levels),
        "wall_turn": 2.0 * np.pi * (np.arange(turns) + 0.5) / turns,
        "flow_window": np.arange(windows_in_flow(scene)),
    }


def to_the_first_event(run: Run) -> None:
    """Carry a run until its first event has come."""
    while not run.done and not run.recording.happened:
        run.go(until=run.engine.step + CHECK_EVERY)


def contents_now(run: Run, scene: SphereScene) -> Numbers:
    """Height (m) of the level surface above the transition, and unit weight (N/m3), of the spheres where they are."""
    space, engine = space_silo_of(scene), run.engine
    weight = engine.mass * -scene.gravity_m_s2[2]
    surface, unit_weight = levelled(engine.places[:, 2], weight, space.bottom, space.silo.area)
    return {"filled_height_at_rest": np.array(surface - space.bottom), "unit_weight_at_rest": np.array(unit_weight)}


def wall_numbers(run: Run, scene: SphereScene, opening: float) -> Numbers:
    """Pressure and shear (Pa) on the cells of wall and hopper: in the last window at rest, in each after the first event at a
    time (s), and the largest pressure of any step after it."""
    before, after, count = *_windows(run, opening), windows_in_flow(scene)
    ends = np.full(count, np.nan)
    ends[: len(after[:count])] = np.array(run.recording.window_time)[after[:count]] - opening
    numbers: Numbers = {"flow_window_end": ends}
    seen = faces(run.engine.model.walls, LID)
    starts = np.cumsum([0, *(face.count for face in seen)])
    for stem in ROUND:
        cells, height = np.full((len(run.recording.window), *scene.record.pressure_cells, 2, 3), np.nan), None
        for face, start in zip(seen, starts, strict=False):
            if face.name == stem:
                surface = run.engine.model.walls[face.wall]
                force = np.array([window[start : start + face.count, :2] for window in run.recording.window])
                cells = (force / areas(surface)[:, None, None]).reshape(cells.shape)
                height = middles(surface)[:, 2].reshape(scene.record.pressure_cells)[:, 0]
        numbers |= _of_surface(stem, cells, before, after, count)
        numbers[f"{stem}_level_height"] = np.full(cells.shape[1], np.nan) if height is None else height
    return numbers


def _windows(run: Run, opening: float) -> tuple[np.ndarray, np.ndarray]:
    """Numbers of the last whole window at rest (one or none), and of those whole ones that begin after the first event."""
    end, whole = np.array(run.recording.window_time), whole_windows(run)
    begun = end - run.window * run.engine.model.dt
    at_rest, flowing = np.flatnonzero(whole & (end <= opening + 1e-9)), np.flatnonzero(whole & (begun >= opening - 1e-9))
    return at_rest[-1:], flowing


def _of_surface(stem: str, cells: np.ndarray, before: np.ndarray, after: np.ndarray, count: int) -> Numbers:
    """Numbers of a surface by what its cells felt (windows, levels, turns, pressure and shear, mean and least and largest)."""
    shape = cells.shape[1:3]
    rest = cells[before[0]] if len(before) else np.full(cells.shape[1:], np.nan)
    flow = np.full((count, *cells.shape[1:]), np.nan)
    flow[: len(after[:count])] = cells[after[:count]]
    peak = cells[after, :, :, 0, 2].max(axis=0) if len(after) else np.full(shape, np.nan)
    return {
        f"{stem}_pressure_at_rest": rest[:, :, 0, 0],
        f"{stem}_shear_at_rest": rest[:, :, 1, 0],
        f"{stem}_pressure_in_flow": flow[:, :, :, 0, 0],
        f"{stem}_shear_in_flow": flow[:, :, :, 1, 0],
        f"{stem}_largest_pressure": peak,
    }
