"""Numbers of a scene of discs in a sweep."""

import numpy as np

from silostudy.compute.scenes_windows import Numbers, OfFillings, Swept, at_rest_and_largest, by_body
from silostudy.dem.leaving import SPILT
from silostudy.dem.run import Run
from silostudy.scene.plane_silo import FLOOR, HOPPER, SIDES

BODIES = {"walls": (*HOPPER, *SIDES), "floor": (FLOOR,)}


def numbers(run: Run, opening: float) -> Numbers:
    """The numbers of a run whose first event came at a time (s), by the names of the contract."""
    resting, largest = forces(run, opening)
    end = run.engine.time
    return {
        "discs_at_start": np.array(len(run.engine.model.x)),
        "discs_left": np.array(run.engine.n),
        "mean_grain_diameter": np.array(2.0 * run.engine.model.radius.mean()),
        "resting_normal_force": resting,
        "largest_normal_force": largest,
        "mass_let_out": np.array(run.dropped),
        "mass_spilt": np.array(run.recording.lost[SPILT]),
        "mean_discharge_rate": np.array(run.dropped / (end - opening) if end > opening else np.nan),
    }


def forces(run: Run, opening: float) -> tuple[np.ndarray, np.ndarray]:
    """Normal force (N/m) on side walls and on the bottom: (mean of the last window before `opening` (s), largest mean after).

    NaN where no forces were recorded.
    """
    if not (run.engine.model.watched and run.recording.window):
        return np.full(2, np.nan), np.full(2, np.nan)
    return at_rest_and_largest(run, opening, by_body(run, np.array(run.recording.window)[:, :, 0, 0], BODIES))


DISCS = Swept(
    BODIES,
    numbers,
    grains="discs_at_start",
    asked={
        "mean_wall_force": OfFillings(lambda numbers: float(numbers["resting_normal_force"][0]), scatter=2.5),
        "mean_outflow": OfFillings(lambda numbers: float(numbers["mean_discharge_rate"]), scatter=3.0),
    },
)
