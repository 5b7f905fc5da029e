"""What one discrete-element scene of a sweep comes to: forces on walls and floor at rest and after it, and the discharge."""

import numpy as np

from silostudy.compute.dem import carry_through, run_of, scene_model
from silostudy.config.scenes import ScenesStudy
from silostudy.dem.leaving import SPILT
from silostudy.dem.run import Run
from silostudy.dem.walls import sums_by_wall
from silostudy.scene.plane_silo import FLOOR, HALVES, HOPPER, SIDES
from silostudy.scene.scenes import SceneCase

BODIES = ("walls", "floor")
Numbers = dict[str, np.ndarray]


def coordinates(study: ScenesStudy) -> dict[str, list[str]]:
    """The dimensions that a case's numbers have of their own."""
    return {"body": list(BODIES)}


def sources(study: ScenesStudy) -> list[str]:
    """References of the laws that the base scene names."""
    from silostudy.dem.integrate import INTEGRATORS

    scene = study.scene
    assert scene.march.integrator is not None, "scene.march.integrator is not chosen yet"
    laws = [law for contact in (scene.discs, scene.walls or scene.discs) for law in contact.laws.values()]
    return sorted({INTEGRATORS[scene.march.integrator].source, *(law.source for law in laws if law.acts)})


def measure(study: ScenesStudy, case: SceneCase) -> Numbers:
    """The numbers of one case, by the names of the contract; Explosion or BadInput where it cannot be computed."""
    scene = case.config
    run = run_of(scene, scene_model(scene, case.folder))
    carry_through(run, scene, None, lambda step: None)
    if run.recording.explosion is not None:
        raise run.recording.explosion
    (first, trigger, _), end = run.recording.happened[0], run.engine.time
    opening = np.nan if trigger == "limit" else first
    resting, largest = forces(run, opening)
    return {
        "discs_at_start": np.array(len(run.engine.model.x)),
        "discs_left": np.array(run.engine.n),
        "time_step": np.array(run.engine.model.dt),
        "first_event_time": np.array(opening),
        "end_time": np.array(end),
        "resting_normal_force": resting,
        "largest_normal_force": largest,
        "mass_let_out": np.array(run.dropped),
        "mass_spilt": np.array(run.recording.lost[SPILT]),
        "limit_reached": np.array(float(run.recording.waiting is not None)),
        "mean_discharge_rate": np.array(run.dropped / (end - opening) if end > opening else np.nan),
    }


def forces(run: Run, opening: float) -> tuple[np.ndarray, np.ndarray]:
    """Normal force (N/m) on side walls and on the bottom: (mean of the last window before `opening` (s), largest mean after).

    Of whole windows: a mean over less is no match for them.  NaN where no forces were recorded, or none before or after, or
    no event came.
    """
    record, model = run.recording, run.engine.model
    whole = np.isclose(np.diff(record.window_time, prepend=0.0), run.window * model.dt)
    if not model.watched or not whole.any() or np.isnan(opening):
        return np.full(2, np.nan), np.full(2, np.nan)
    each = sums_by_wall(model, np.array(record.window)[whole, :, 0, 0], axis=1)
    sums = np.column_stack([_together(each, (*HOPPER, *SIDES)), _together(each, (FLOOR, *HALVES))])
    before = np.searchsorted(np.array(record.window_time)[whole], opening + 1e-9)
    missing = np.full(2, np.nan)
    return (sums[before - 1] if before else missing), (sums[before:].max(axis=0) if before < len(sums) else missing)


def _together(each: dict[str, np.ndarray], names: tuple[str, ...]) -> np.ndarray:
    """Sum over the walls of these names that the silo has."""
    return np.sum([each[name] for name in names if name in each], axis=0)
