"""Forces on the walls of a silo of grains, level by level: at rest, and window by window in flow."""

import numpy as np

from silostudy.compute.scenes_walls_plane import PLANE
from silostudy.compute.scenes_walls_round import ROUND
from silostudy.compute.scenes_windows import Numbers, Walled, begins, whole_windows
from silostudy.config.grain_scenes import AnyScene
from silostudy.dem.run import Run

WALLED: dict[str, Walled] = {"discs": PLANE, "spheres": ROUND}
SURFACES = ("wall", "hopper")


def keeps_walls(scene: AnyScene) -> bool:
    """Whether the pressures on a scene's walls are kept: of round silos of spheres, of plane ones of discs over a wedge."""
    return WALLED[scene.grains].keeps(scene)


def windows_in_flow(scene: AnyScene) -> int:
    """Number of whole windows after the first event: up to the stop where that comes after a time, else up to the limit."""
    last, window = scene.events[-1], scene.record.wall_force_window_s
    assert window is not None
    span = last.value if last.when == "after" and last.value is not None else scene.march.limit_s
    return max(1, int(span / window + 1e-6) - 1)  # the outlet opens within a window, which is no whole one of the flow


def wall_coordinates(scene: AnyScene) -> dict[str, np.ndarray]:
    """Number of the level from below, angle about the axis (rad), number of the whole window after the first event."""
    levels, turns = WALLED[scene.grains].cells(scene)
    return {"wall_level": np.arange(levels), "wall_turn": turns, "flow_window": np.arange(windows_in_flow(scene))}


def to_the_first_event(run: Run) -> None:
    """Carry a run until its first event has come."""
    while not run.done and not run.recording.happened:
        run.go(until=run.engine.step + run.check)


def contents_now(run: Run, scene: AnyScene) -> Numbers:
    """Height (m) of the level surface above the transition, and unit weight (N/m3), of the grains where they are."""
    height, unit_weight = WALLED[scene.grains].contents(run, scene)
    return {"filled_height_at_rest": np.array(height), "unit_weight_at_rest": np.array(unit_weight)}


def wall_numbers(run: Run, scene: AnyScene, opening: float) -> Numbers:
    """Pressure and shear (Pa) on the cells of wall and hopper: in the last window at rest, in each after the first event at a
    time (s), and the largest pressure of any step after it."""
    walled = WALLED[scene.grains]
    before, after, count = *_windows(run, opening), windows_in_flow(scene)
    ends = np.full(count, np.nan)
    ends[: len(after[:count])] = np.array(run.recording.window_time)[after[:count]] - opening
    numbers: Numbers = {"flow_window_end": ends}
    levels, turns = walled.cells(scene)
    missing = np.full((len(run.recording.window), levels, len(turns), 2, 3), np.nan)
    seen = walled.felt(run, scene)
    for stem in SURFACES:
        numbers |= _of_surface(stem, seen[stem].cells if stem in seen else missing, before, after, count)
        numbers[f"{stem}_level_height"] = seen[stem].height if stem in seen else np.full(levels, np.nan)
    return numbers


def _windows(run: Run, opening: float) -> tuple[np.ndarray, np.ndarray]:
    """Numbers of the last whole window at rest (one or none), and of those whole ones that begin after the first event."""
    end, whole = np.array(run.recording.window_time), whole_windows(run)
    begun = begins(run)
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
