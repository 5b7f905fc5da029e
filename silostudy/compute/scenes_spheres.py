"""Numbers of a scene of spheres in a sweep."""

import numpy as np

from silostudy.compute.outlet_cube import mean_outflow, passages
from silostudy.compute.scenes_windows import Numbers, OfFillings, Swept, at_rest_and_largest, by_body
from silostudy.compute.sphere_cube import downward
from silostudy.dem.leaving import SPILT
from silostudy.dem.run import Run
from silostudy.dem.space.cells import faces
from silostudy.scene.space_silo import FLOOR, HOPPER, LID, WALL

SHARES = np.linspace(0.0, 1.0, 41)  # of the time from the first event to the end, at which what is left is counted
BODIES = {"walls": (WALL,), "hopper": (HOPPER,), "floor": (FLOOR,)}


def numbers(run: Run, opening: float) -> Numbers:
    """The numbers of a run whose first event came at a time (s), by the names of the contract."""
    time, passed, _ = passages(run)
    numbers = {
        "share_left": left(time, passed, float(run.engine.model.mass.sum()), opening, run.engine.time),
        "grains_at_start": np.array(len(run.engine.model.x)),
        "grains_left": np.array(run.engine.n),
        "mean_grain_diameter": np.array(2.0 * run.engine.model.radius.mean()),
        "passed_mass": np.array(passed.sum()),
        "spilt_mass": np.array(run.recording.lost[SPILT]),
        "mean_mass_flow": np.array(mean_outflow(run)),
    }
    for name, sums in felt(run).items():
        numbers[f"{name}_at_rest"], numbers[f"largest_{name}"] = at_rest_and_largest(run, opening, sums)
    return numbers


def left(time: np.ndarray, passed: np.ndarray, whole: float, opening: float, end: float) -> np.ndarray:
    """Mass that has not passed the outlet over the whole (kg), at even shares of the time from an opening to an end (s).

    time, passed: when (s) masses (kg) passed.
    """
    if np.isnan(opening):
        return np.full(len(SHARES), np.nan)
    through = np.concatenate([[0.0], np.cumsum(passed)])
    return 1.0 - through[np.searchsorted(time, opening + SHARES * (end - opening), side="right")] / whole


def felt(run: Run) -> dict[str, np.ndarray]:
    """Normal force and downward force (N) on each body, mean of every window; missing where none were recorded."""
    model, record = run.engine.model, run.recording
    if not (model.watched and record.window):
        missing = np.full((len(record.window), len(BODIES)), np.nan)
        return {"body_normal_force": missing, "body_load": missing}
    force = np.array(record.window)[:, :, :, 0]
    seen = faces(model.walls, LID)
    lean = np.repeat([face.lean for face in seen], [face.count for face in seen], axis=0)
    return {
        "body_normal_force": by_body(run, force[:, :, 0], BODIES),
        "body_load": by_body(run, downward(force, lean), BODIES),
    }


SPHERES = Swept(
    BODIES,
    numbers,
    grains="grains_at_start",
    asked={
        "mean_wall_force": OfFillings(lambda numbers: float(numbers["body_normal_force_at_rest"][0]), scatter=2.3),
        "mean_outflow": OfFillings(lambda numbers: float(numbers["mean_mass_flow"]), scatter=0.57),
    },
)
