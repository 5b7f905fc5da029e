"""The front of discrete-element scenes: errors of the forces on the walls of silos at rest, and trials on other silos.

Where discs come to rest hangs on every rounding.  So a silo is filled many times, its discs a little elsewhere each time, and
its error is the one that 95 % of its fillings keep: of the force on each sixth of the walls, over the largest, against
velocity Verlet at a finer step.  Steps are longer as discs settle, of which errors hardly come.
"""

import time
from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass
from typing import Any

import numpy as np

from silostudy.accuracy.certificates import asked_at_random
from silostudy.accuracy.silo import wall_force
from silostudy.accuracy.trial import Trial, front_row, worthwhile
from silostudy.choice.choose import choose
from silostudy.choice.dem import restlessness, scene_traits
from silostudy.compute.dem import run_of
from silostudy.config.dem import DemScene
from silostudy.contact import MEASURED as MEASURED_LAWS
from silostudy.dem.integrate import PLAIN, SMOOTHED, VERLET
from silostudy.scene.dem_model import placed, unshaken_scene_model
from silostudy.tables.kiyama_1983 import DENSITY, NORMAL_STIFFNESS, RADIUS, width_as_steep

STEPS = tuple(2.0 ** (-k / 2) for k in range(11))  # factors of the step that the engine chooses
COARSE = {VERLET.key: STEPS[:7], PLAIN.key: STEPS, SMOOTHED.key: STEPS}
FINE = {PLAIN.key: (2.0**-6, 2.0**-7)}  # on fewer fillings
# factors of the references' steps, by velocity Verlet; a trial's errs by far less than what is asked there
FINEST = {"coarse": 2.0**-6, "fine": 2.0**-7.5, "trial": 2.0**-4}
SHARE = 0.95  # of fillings that keep an error
LARGE = 0.5  # factor of the step from which on errors of smoothed increments, being large, go with the root of the trait
KEPT = 0.92  # share of all fillings of all silos that a row keeps; a step chosen is finer: more keep it
REST = 0.25  # s to rest
PARTS = 6  # of a wall
MEASURED = 40  # silos that the front is measured on
UNSEEN = 20  # other silos that the choice is tried on
FILLINGS = 8  # of each silo that is measured
FINE_FILLINGS = 4  # of them, at the steps of FINE
UNSEEN_FILLINGS = 60  # of each silo that the choice is tried on: of 20 the error that 95 % keep is known to a fifth only
ASKED = (0.03, 0.3)  # errors asked for lie between
ASKS = 20  # errors asked of each silo
SPAN = {"damping_ratio": (0.5, 1.0), "wall_stiffness_ratio": (1.0, 2.0), "stiffness_ratio": (0.2, 0.5),
        "disc_friction": (0.3, 0.6), "wall_friction": (0.1, 0.4)}  # fmt: skip
GAPS = (1e-5, 8e-5)  # of discs of RADIUS
SOURCE = "kiyama_fujimura_1983"

Setting = tuple[str, float]  # integrator, factor of the step while discs move


@dataclass(frozen=True)
class Found:
    """Errors of a silo's fillings, and the CPU seconds of one filling, its model's making with it, by setting."""

    error: dict[Setting, np.ndarray]
    cost: dict[Setting, float]

    def error_kept(self, setting: Setting) -> float:
        """Error that 95 % of the fillings keep."""
        return float(np.quantile(self.error[setting], SHARE))


def silos(seed: int, count: int) -> Iterator[dict[str, Any]]:
    """Contents of scenes of many widths, heights, gaps and contacts; other seeds give others."""
    random = np.random.default_rng(seed)
    for _ in range(count):
        across, layers = int(random.integers(5, 8)), float(random.uniform(5, 16))
        gap = float(np.exp(random.uniform(*np.log(GAPS))))
        own = {name: float(random.uniform(*span)) for name, span in SPAN.items()}
        shared: dict[str, Any] = {**MEASURED_LAWS} | {name: own[name] for name in ("damping_ratio", "stiffness_ratio")}
        yield {
            "kind": "dem", "title": "a silo to measure accuracy on", "radius_m": RADIUS, "density_kg_m3": DENSITY,
            "silo": {"width_m": width_as_steep(across), "height_m": 2.0 * layers * RADIUS + 0.1},
            "packing": {"kind": "rows", "across": across, "fill_height_m": 2.0 * layers * RADIUS, "gap_m": gap,
                        "offset_m": gap * float(random.choice([0.3, 0.1, 0.01]))},
            "discs": shared | {"normal_stiffness_N_m2": NORMAL_STIFFNESS, "sliding_friction": own["disc_friction"]},
            "walls": shared | {"normal_stiffness_N_m2": NORMAL_STIFFNESS * own["wall_stiffness_ratio"],
                               "sliding_friction": own["wall_friction"]},
            "march": {"limit_s": REST}, "events": [{"when": "time", "value": REST, "do": "stop"}],
        }  # fmt: skip


def measured(content: dict[str, Any], ladders: Mapping[str, tuple[float, ...]], finest: float, seeds: range) -> Found:
    """Errors and costs of every setting on one silo; finest: factor of the reference's step."""
    settings = [(integrator, factor) for integrator, factors in ladders.items() for factor in factors]
    errors, spent = np.empty((len(settings), len(seeds))), np.empty((len(settings), len(seeds)))
    for number, seed in enumerate(seeds):
        exact, _ = forces(content, (VERLET.key, finest), seed)
        for k, setting in enumerate(settings):
            force, spent[k, number] = forces(content, setting, seed)
            errors[k, number] = np.abs(force - exact).max() / exact.max()
    cost = np.median(spent, axis=1)
    return Found(dict(zip(settings, errors, strict=True)), dict(zip(settings, cost.tolist(), strict=True)))


def scale_of(setting: Setting) -> str:
    """Trait that the errors of a setting go with."""
    integrator, factor = setting
    return "restlessness_root" if integrator == SMOOTHED.key and factor >= LARGE else "restlessness"


def forces(content: dict[str, Any], setting: Setting, seed: int) -> tuple[np.ndarray, float]:
    """Force (N/m) on the parts of both walls of a filling at rest, and CPU seconds; infinite where the discs run away."""
    scene = DemScene.model_validate(content | {"march": content["march"] | march_of(setting), "seed": seed})
    start = time.process_time()
    run = run_of(scene, unshaken_scene_model(scene, placed(scene)))
    if run.go().explosion:
        return np.array(np.inf), np.inf
    spent = time.process_time() - start
    return wall_force(run.engine, PARTS), spent


def march_of(setting: Setting) -> dict[str, Any]:
    """Keys of time stepping that a setting is."""
    integrator, factor = setting
    step = "longer_at_rest" if factor < 1.0 else "fixed"
    return {"integrator": integrator, "step_factor": float(f"{factor:.4g}"), "step": step}


def measured_fronts(tell: Callable[[str], None]) -> list[dict]:
    """Rows of tables/fronts.csv: the error over the trait that it goes with, which most of all fillings of all silos keep."""
    errors: list[tuple[dict[str, float], Found]] = []
    for number, content in enumerate(silos(0, MEASURED), 1):
        traits = scene_traits(DemScene.model_validate(content))
        errors += [(traits, measured(content, COARSE, FINEST["coarse"], range(FILLINGS)))]
        errors += [(traits, measured(content, FINE, FINEST["fine"], range(FINE_FILLINGS)))]
        tell(f"dem: silo {number} of {MEASURED}")
    fall = float(f"{1.05 * max(traits['fall'] for traits, _ in errors):.2g}")
    most = restlessness(fall, SPAN["damping_ratio"][0], SPAN["wall_friction"][1])
    spans = {"restlessness": (0.0, float(f"{1.05 * most:.2g}"))}
    spans["restlessness_root"] = (0.0, float(f"{1.05 * spans['restlessness'][1] ** 0.5:.2g}"))
    rows = []
    for setting in dict.fromkeys(setting for _, measures in errors for setting in measures.error):
        scale = scale_of(setting)
        over = np.concatenate(
            [measures.error[setting] / traits[scale] for traits, measures in errors if setting in measures.error]
        )
        cost = float(np.median([measures.cost[setting] for _, measures in errors if setting in measures.cost]))
        settings = {f"march.{key}": value for key, value in march_of(setting).items()}
        row = front_row("dem", "wall_force", settings, float(np.quantile(over, KEPT)), cost, len(over), SOURCE,
                        scaled_by=scale, within=SPAN | {"fall": (0.0, fall), scale: spans[scale]})  # fmt: skip
        rows.append(row)
    return worthwhile(rows)


def trials(tell: Callable[[str], None], count: int = UNSEEN, fillings: int = UNSEEN_FILLINGS) -> list[Trial]:
    """Fillings of silos that the front was not measured on; the cheapest is what 95 % of the fillings of a silo ask for."""
    tried, random = [], np.random.default_rng(2)
    for number, content in enumerate(silos(1, count), 1):
        traits = scene_traits(DemScene.model_validate(content))
        measures = measured(content, COARSE, FINEST["trial"], range(fillings))
        for asked in asked_at_random(random, ASKED, ASKS):
            tried += _tried(measures, asked, choose(["dem"], {"wall_force": asked}, [traits]).settings)
        tell(f"dem: silo {number} of {count}, {sum(trial.met for trial in tried)} of {len(tried)} met")
    return tried


def _tried(measures: Found, asked: float, chosen: Mapping[str, Any]) -> list[Trial]:
    """Trials of one error asked for, on each filling of a silo."""
    integrator, factor = chosen["march.integrator"], chosen["march.step_factor"]
    setting = min(measures.error, key=lambda rung: (rung[0] != integrator, abs(rung[1] - factor)))
    cheapest = min((measures.cost[rung] for rung in measures.error if measures.error_kept(rung) <= asked), default=np.nan)
    return [
        Trial("dem", "wall_force", asked, float(error), measures.cost[setting], cheapest) for error in measures.error[setting]
    ]
