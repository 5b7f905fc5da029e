"""Effects of the engine whose prices are listed: each law and each effect added to grains near rest with friction alone."""

from collections.abc import Mapping
from dataclasses import replace
from functools import cache
from typing import Any

import numpy as np

from silostudy.accuracy.bin_of_spheres import Bin, bin_of_spheres
from silostudy.accuracy.prices import APART, FRICTION, LAW_EFFECTS, Pair, still, without
from silostudy.accuracy.silo import LEVELS, silo_of_rows
from silostudy.contact import LAWS, SPHERE_LAWS, Law
from silostudy.dem.model import Contact, Model
from silostudy.dem.varied import Varied
from silostudy.tables.kiyama_1983 import ACTIVE

SPHERES = ", of spheres"
COUNT = 2000  # spheres
# coefficients of the laws that are added, of the order of what the grains weigh
OF_DISCS = {"rolling_stiffness": 10.0, "rolling_damping": 1e-3, "rolling_friction": 0.1, "pull": 1.0}
OF_SPHERES = {
    "rolling_stiffness": 1.0, "rolling_damping": 1e-4, "rolling_friction": 0.05, "pull": 1e-4, "work_of_adhesion": 1e-3,
    "cohesion_energy_density": 1e3, "twisting_stiffness": 1e-4, "twisting_damping": 1e-7, "twisting_friction": 0.05,
}  # fmt: skip


@cache
def base(body: str) -> Model:
    """Discs of the bench's silo, or spheres of a bin, near rest with friction and nothing else."""
    return still(silo_of_rows(ACTIVE, LEVELS)[0] if body == "disc" else bin_of_spheres(Bin(count=COUNT, wide=0.03)))


def priced_effects() -> dict[str, Pair]:
    """Pairs of models with an effect and without it, by its name in the price list."""
    discs, spheres = _effects(base("disc"), LAWS, OF_DISCS), _effects(base("sphere"), SPHERE_LAWS, OF_SPHERES)
    recorded = without(replace(base("disc"), watched=True))[FRICTION]
    return {
        **discs,
        f"{FRICTION} (wall forces recorded)": recorded,
        **{name + SPHERES: pair for name, pair in spheres.items()},
    }


def label(effect: str, law: str) -> str:
    """Name of an effect in the price list: each law has its price, but friction as a whole has one."""
    return f"{effect}: {law}" if law and effect in LAW_EFFECTS.values() else effect


def _effects(model: Model, laws: Mapping[str, Mapping[str, Law]], values: dict[str, float]) -> dict[str, Pair]:
    pairs = {FRICTION: without(model)[FRICTION]}
    for family, name in LAW_EFFECTS.items():
        for law in laws.get(family, {}).values():
            if law.acts:
                pairs[label(name, law.key)] = without(_with_law(model, family, law, values))[name]
    return pairs | {name: without(replace(model, **changes))[name] for name, changes in _others(model).items()}


def _others(model: Model) -> dict[str, dict[str, Any]]:
    """Changes of a model that give it an effect which is no law, by the effect's name."""
    body, count = model.space.body, len(model.walls)
    pair, wall, alternate = model.between(0, 0), model.at_wall(0, 0), np.arange(len(model.x)) % 2
    kinds = {"kind": alternate, "pair_contact": Varied((pair,) * 3), "wall_contact": Varied((wall,) * 2 * count)}
    return {
        "walls of several coefficients": {"wall_contact": Varied((wall,) * count)},
        f"several kinds of {body}s": kinds,
        f"{body}s of several sizes": {"radius": model.radius * (1.0 + APART * alternate)},
        "shaking": {"quake": np.zeros((2, model.space.ways))},
        "wall forces every step": {"watched": True},
        "walls that move": {"moving": True},
        "energy balance": {"booked": True},
    }


def _with_law(model: Model, family: str, law: Any, values: dict[str, float]) -> Model:
    pair, wall = (
        Contact.taking(replace(contact.laws, **{family: law}), contact.coefficients | values)
        for contact in (model.between(0, 0), model.at_wall(0, 0))
    )
    return replace(model, pair_contact=pair, wall_contact=wall)
