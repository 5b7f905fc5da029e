"""A bin of spheres in the engine and in LAMMPS, from the same start, both read alike from where spheres are."""

from pathlib import Path

import numpy as np

from silostudy.accuracy.arrivals import Arrival, followed
from silostudy.accuracy.laws_in_lammps import SAME_LAW
from silostudy.accuracy.scene_in_lammps import SceneInLammps
from silostudy.compute.dem import run_of, scene_model
from silostudy.compute.outlet_cube import mean_rate
from silostudy.config.spheres import SphereScene
from silostudy.cube.areas import AVERAGED, largest_mean
from silostudy.cube.contents import levelled
from silostudy.dem.model import Model
from silostudy.dem.run import Run
from silostudy.errors import BadInput
from silostudy.scene.space_silo import WALL, SpaceSilo
from silostudy.scene.spheres import space_silo_of

LOOKS = 40  # at a window of wall forces
AT_REST = "body_normal_force_at_rest"  # names of the contract
LARGEST = "largest_wall_force_in_flow"
AREA = "largest_pressure_{}"  # on areas of cells, in flow


def of_codes(scene: SphereScene, folder: Path) -> dict[str, dict[str, float]]:
    """Quantities of a scene by the code that computes it."""
    model, space = scene_model(scene, folder), space_silo_of(scene)
    if scene.record.wall_force_window_s is None or scene.silo.plan != "circular":
        raise BadInput("record.wall_force_window_s", None, "must be given, of a round silo")
    run = run_of(scene, model)
    came = followed(run)
    opening, stop = (time for time, _, _ in run.recording.happened)
    steps = looked_at(round(scene.record.wall_force_window_s / model.dt), round(opening / model.dt), round(stop / model.dt))
    places = {"silostudy": _here(scene, model, steps), "LAMMPS": _there(scene, run, came, steps)}
    times = steps * model.dt
    return {code: readings(model, space, scene, times - opening, of) for code, of in places.items()}


def looked_at(window: int, opening: int, stop: int) -> np.ndarray:
    """Steps at which places are looked at, equally often in each window of so many: from the last whole one at rest on."""
    begin = (opening // window - 1) * window
    looks = np.arange(1, (stop - begin) * LOOKS // window + 1)
    return begin + np.rint(looks * window / LOOKS).astype(int)


def _here(scene: SphereScene, model: Model, steps: np.ndarray) -> np.ndarray:
    """Places (look, sphere, 3; m) in the engine at steps; NaN of spheres that have left."""
    run = run_of(scene, model)
    places = []
    for step in steps.tolist():
        run.go(until=step)
        places.append(run.engine.places)
    return np.array(places)


def _there(scene: SphereScene, run: Run, came: list[Arrival], steps: np.ndarray) -> np.ndarray:
    """The same in LAMMPS."""
    peer = SceneInLammps(scene, run, came, SAME_LAW, steps.tolist())
    peer.go()
    places = np.full((len(steps), len(run.engine.model.x), 3), np.nan)
    for look, (_, numbers, of) in zip(places, peer.seen, strict=True):
        look[numbers] = of
    return places


def readings(model: Model, space: SpaceSilo, scene: SphereScene, times: np.ndarray, places: np.ndarray) -> dict[str, float]:
    """Quantities of a bin by name; times (s) of the looks from the opening of its outlet on, places (look, sphere, 3; m).

    In flow they are of windows that begin after the opening, as in the cube of a sweep.
    """
    force = in_windows(np.array([wall_forces(model, space, scene, look) for look in places]), LOOKS)
    ends = times[LOOKS - 1 :: LOOKS][: len(force)]
    flow = force[ends - (ends[1] - ends[0]) >= -0.5 * model.dt]
    weight = model.mass * -scene.gravity_m_s2[2]
    area = space.plan.half[0] * 2.0 * np.pi * (space.top - space.bottom) / force[0].size  # of a cell
    return {
        AT_REST: float(force[0].sum()),
        "unit_weight_at_rest": levelled(places[times <= 0.0][-1][:, 2], weight, space.bottom, space.silo.area)[1],
        "mean_mass_flow": mean_rate(*passages(model, times, places)),
        LARGEST: float(flow.sum(axis=(1, 2)).max()),
    } | {AREA.format(name): float(np.nanmax(largest_mean(flow, name))) / area for name in AVERAGED}


def in_windows(force: np.ndarray, looks: int) -> np.ndarray:
    """Means of forces over whole windows of so many looks (the first axis)."""
    count = len(force) // looks
    return force[: count * looks].reshape(count, looks, *force.shape[1:]).mean(axis=1)


def wall_forces(model: Model, space: SpaceSilo, scene: SphereScene, places: np.ndarray) -> np.ndarray:
    """Hertz's normal force (N; levels, turns) on the cells of the upright wall, from the overlaps."""
    wide, radius = space.plan.half[0], model.radius
    stiffness = model.at_wall(0, model.wall_number(WALL)).coefficients["hertz_stiffness"]
    depth = np.maximum(0.0, np.hypot(places[:, 0], places[:, 1]) + radius - wide)
    reduced = radius / (1.0 - 0.5 * radius / wide)  # a cylinder bends about the sphere in one of two directions
    force = stiffness * np.sqrt(reduced * depth) * depth
    at_wall = (force > 0.0) & (places[:, 2] > space.bottom)  # NaN of those that have left is not
    turn = np.arctan2(places[:, 1], places[:, 0]) % (2.0 * np.pi)
    box = ((space.bottom, space.top), (0.0, 2.0 * np.pi))
    return np.histogram2d(
        places[at_wall, 2], turn[at_wall], bins=scene.record.pressure_cells, range=box, weights=force[at_wall]
    )[0]


def passages(model: Model, times: np.ndarray, places: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Times (s) of the looks at which spheres were below the outlet's level first, in order, and their masses (kg)."""
    below = ~(places[:, :, 2] > 0.0)
    through = below[-1]
    first = np.argmax(below[:, through], axis=0)
    order = np.argsort(first)
    return times[first[order]], model.mass[through][order]
