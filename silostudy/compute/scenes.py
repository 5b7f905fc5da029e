"""Numbers of one scene of grains of a sweep: forces on walls and floor at rest and after it, and the discharge."""

from functools import partial
from pathlib import Path
from typing import Any

import numpy as np

from silostudy.compute.dem import carry_through, run_of, scene_model
from silostudy.compute.scenes_discs import DISCS
from silostudy.compute.scenes_means import mean_numbers
from silostudy.compute.scenes_spheres import SHARES, SPHERES
from silostudy.compute.scenes_walls import contents_now, keeps_walls, to_the_first_event, wall_coordinates, wall_numbers
from silostudy.compute.scenes_windows import Numbers, Swept
from silostudy.config.grain_scenes import AnyScene
from silostudy.config.scenes import ScenesStudy
from silostudy.dem.follow import mean_step
from silostudy.scene.scenes import SceneCase

SWEPT: dict[str, Swept] = {"discs": DISCS, "spheres": SPHERES}


def coordinates(study: ScenesStudy) -> dict[str, Any]:
    """The dimensions that a case's numbers have of their own."""
    walls = wall_coordinates(study.scene) if keeps_walls(study.scene) else {}
    flow = {"flow_share": SHARES} if study.scene.grains == "spheres" else {}
    means = {"asked_quantity": list(study.of_fillings)} if study.of_fillings else {}
    return {"body": list(SWEPT[study.scene.grains].bodies), **flow, **walls, **means}


def sources(study: ScenesStudy) -> list[str]:
    """References of the laws that the base scene names."""
    from silostudy.dem.integrate import INTEGRATORS

    scene = study.scene
    assert scene.march.integrator is not None, "scene.march.integrator is not chosen yet"
    laws = [law for touch in scene.touches for law in touch.laws.values()]
    return sorted({INTEGRATORS[scene.march.integrator].source, *(law.source for law in laws if law.acts)})


def measure(study: ScenesStudy, case: SceneCase) -> Numbers:
    """The numbers of one case, by the names of the contract; Explosion or BadInput where it cannot be computed."""
    scene, of_filling = case.config, partial(numbers_of, folder=case.folder)
    return mean_numbers(scene, of_filling, SWEPT[scene.grains]) if scene.of_fillings else of_filling(scene)


def numbers_of(scene: AnyScene, folder: Path) -> Numbers:
    """The numbers of one run of a scene."""
    run = run_of(scene, scene_model(scene, folder))
    at_rest: Numbers = {}
    if keeps_walls(scene):
        to_the_first_event(run)
        at_rest = contents_now(run, scene)
    carry_through(run, scene, None, lambda step: None)
    if run.recording.explosion is not None:
        raise run.recording.explosion
    first, trigger, _ = run.recording.happened[0]
    opening = np.nan if trigger == "limit" else first
    return {
        "time_step": np.array(mean_step(run)),
        "first_event_time": np.array(opening),
        "end_time": np.array(run.engine.time),
        "limit_reached": np.array(float(run.recording.waiting is not None)),
        **SWEPT[scene.grains].numbers(run, opening),
        **at_rest,
        **(wall_numbers(run, scene, opening) if keeps_walls(scene) else {}),
    }
