"""The scenes of a stability study: discs at rest on a floor, as the engine's models."""

from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np

from silostudy.config.contact import ContactConfig
from silostudy.config.stability import StabilityScene, StabilityStudy
from silostudy.dem.integrate import PLAIN
from silostudy.dem.model import Model
from silostudy.packing import rows
from silostudy.scene.dem import contact_of
from silostudy.scene.plane_silo import PlaneSilo
from silostudy.tables.constants import ROUNDED_GRAVITY
from silostudy.tables.kiyama_1983 import ACTIVE, pitch

TALL = 10  # discs of a column
ACROSS = 6  # discs of the lowest row
PITCH = pitch(ACTIVE)  # of a radius, between discs of a row: a steep packing, far from neighbours in touch
CALMING = 0.7  # of the critical damping
TIGHT = 1e-4  # of a diameter: overlap of neighbours in a hexagonal row, so that they stay in touch


@dataclass(frozen=True)
class RestingDiscs:
    """One case: the configuration it came from, its model, and one with laws that bring the same discs to rest soon.

    Steps are set by whoever steps them.
    """

    config: StabilityScene
    model: Model
    calm: Model

    @property
    def lonely(self) -> bool:
        """Whether nothing holds the discs upright, so that only up and down is a motion about rest."""
        return self.config.network == "column"


def stability_builder(study: StabilityStudy, folder: Path, where: str) -> Callable[[StabilityScene, dict], RestingDiscs]:
    """Builds the scenes of a stability study."""

    def build_one(config: StabilityScene, settings: dict[str, Any]) -> RestingDiscs:
        calm = config.model_copy(update={"discs": calmed(config.discs), "integrator": PLAIN.key})
        return RestingDiscs(config, resting_discs_model(config), resting_discs_model(calm))

    return build_one


def calmed(discs: ContactConfig) -> ContactConfig:
    """The same contact with explicit dashpots of CALMING; the spring of a slider is the same in all of them."""
    laws = {family: law.at_rest for family, law in discs.laws.items()}
    return discs.model_copy(update={**laws, "normal_damping_N_s_m2": None, "restitution": None, "damping_ratio": CALMING})


def resting_discs_model(config: StabilityScene) -> Model:
    """The engine's model of the discs where they nearly rest."""
    x, y, width = network(config.network, config.radius_m)
    top = 2.0 * float(y.max()) + 4.0 * config.radius_m
    contact = contact_of(config.discs, config.radius_m, config.density_kg_m3)
    return Model(
        x=x, y=y, radius=np.full(len(x), config.radius_m), density=config.density_kg_m3, walls=PlaneSilo(width, top).walls(),
        pair_contact=contact, wall_contact=contact, dt=1.0, gravity=(0.0, -ROUNDED_GRAVITY), integrator=config.integrator,
    )  # fmt: skip


def network(arrangement: str, radius: float) -> tuple[np.ndarray, np.ndarray, float]:
    """Places x, y (m) of the discs where they nearly rest, and the width (m) between the side walls."""
    if arrangement in ("disc", "column"):
        number = np.arange(TALL if arrangement == "column" else 1)
        return np.full(len(number), 2.0 * radius), radius * (1.0 + 2.0 * number), 4.0 * radius
    gap = 1e-4 * radius
    pitch = PITCH * radius if arrangement == "rows" else 2.0 * radius * (1.0 - TIGHT)
    width = 2.0 * (radius + gap) + (ACROSS - 1) * pitch
    if arrangement == "rows":
        height = 2.0 * radius + ACROSS * 1.7 * radius
        x, y, _ = rows.place(width=width, height=height, radius=radius, across=ACROSS, gap=gap)
        return x, y, width
    level = np.repeat(np.arange(ACROSS), [ACROSS - level % 2 for level in range(ACROSS)])
    number = np.concatenate([np.arange(ACROSS - level % 2) for level in range(ACROSS)])
    x = radius + (level % 2 + 2 * number) * pitch / 2.0
    return x, radius + level * np.sqrt(3.0) / 2.0 * pitch, 2.0 * radius + (ACROSS - 1) * pitch - 2.0 * radius * TIGHT
