"""A bin of spheres filled and come to rest: how hard they press on the walls and how high they lie, by step and precision.

Where each sphere comes to lie is chance: fillings differ by their seed, and their means are compared.
"""

from functools import partial

import numpy as np

from silostudy.accuracy.bin_of_spheres import Bin, GrainTouch, bin_of_spheres
from silostudy.accuracy.single_precision import SINGLE, timed_in_double
from silostudy.dem.engine import Engine
from silostudy.dem.snapshot import wall_contacts
from silostudy.dem.space.model import SphereModel
from silostudy.scene.space_silo import WALL
from silostudy.tables.constants import ROUNDED_GRAVITY

COUNT = 300
WIDE = 0.014  # m, radius of the bin: 3.5 diameters
OUTLET = 0.02  # m, closed
REST = 0.5  # s to rest
MODULI = {"10 MPa": 1e7, "1 GPa": 1e9}  # Pa
STEPS = {"10 MPa": (2e-5, 1e-5, 5e-6), "1 GPa": (2e-6,)}  # s
LADDERS = STEPS | {f"{modulus}, {SINGLE}": steps for modulus, steps in STEPS.items()}


def prepare(ladder: str, setting: float, members: int):
    """An ensemble of fillings; the seeds are equal on every rung."""
    modulus, *precision = ladder.split(", ")
    run = partial(_rested, _fillings(MODULI[modulus], setting, range(members)))
    return timed_in_double(run) if precision else partial(run, Engine.step_to)


def reference(members: int):
    """Four times the members at half the finest step of the softer spheres, with seeds of their own."""
    return _rested(_fillings(MODULI["10 MPa"], STEPS["10 MPa"][-1] / 2.0, range(10_000, 10_000 + 4 * members)), Engine.step_to)


def _fillings(modulus: float, step: float, seeds: range) -> list[SphereModel]:
    spheres, walls = GrainTouch(modulus, 0.5, 0.3), GrainTouch(modulus, 0.4, 0.2)
    of = Bin(count=COUNT, wide=WIDE, outlet=OUTLET, spheres=spheres, walls=walls, step=step)
    return [bin_of_spheres(of, seed) for seed in seeds]


def _rested(models: list[SphereModel], march) -> dict[str, np.ndarray]:
    """Horizontal force on the cylinder over the weight, and height of the centre of mass (m), of each filling."""
    pushes, heights = zip(*(_at_rest(model, march) for model in models), strict=True)
    return {"wall_push": np.array(pushes), "centre_height": np.array(heights)}


def _at_rest(model: SphereModel, march) -> tuple[float, float]:
    engine = Engine(model)
    march(engine, round(REST / model.dt))
    touching = wall_contacts(engine)
    side = touching.second == model.wall_number(WALL)
    push = np.hypot(*touching.force[side, :2].T).sum()
    return float(push / (engine.mass.sum() * ROUNDED_GRAVITY)), float(engine.places[:, 2].mean())
