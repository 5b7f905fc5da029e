"""The silo of benches and ladders: Kiyama & Fujimura's discs in rows that fill it, with a slit that may open."""

from dataclasses import replace
from math import sqrt

import numpy as np

from silostudy.contact.family import NormalLaw
from silostudy.contact.normal import spring_dashpot
from silostudy.contact.tangential import spring_slider_total
from silostudy.dem.engine import Engine
from silostudy.dem.model import Contact, Model
from silostudy.dem.pieces import Laws
from silostudy.dem.snapshot import wall_contacts
from silostudy.packing import rows
from silostudy.scene.plane_silo import FLOOR, HALVES, SIDES, PlaneSilo
from silostudy.tables.constants import ROUNDED_GRAVITY
from silostudy.tables.kiyama_1983 import (
    ACTIVE,
    DENSITY,
    DISC_FRICTION,
    GAPS,
    NORMAL_DAMPING,
    NORMAL_STIFFNESS,
    RADIUS,
    STIFFNESS_RATIO,
    WALL_FRICTION,
    WALL_STIFFNESS_RATIO,
    width_as_steep,
)

LEVELS = 20  # rows of 18 and 17 discs in turn: about as many discs as in the source
STEP = 2.5e-5  # s, half of the bound of the packing at rest
OPEN = (FLOOR, HALVES)
DOWN = (0.0, -ROUNDED_GRAVITY)  # m s-2


def contact_of_discs(
    friction: float = DISC_FRICTION, *, normal: NormalLaw = spring_dashpot.ROW, factor: float = 1.0
) -> Contact:
    """Contact between the source's discs, with Cundall and Strack's slider; stiffness and dashpots times `factor`."""
    coefficients = {
        "normal_stiffness": factor * NORMAL_STIFFNESS,
        "normal_damping": factor * NORMAL_DAMPING,
        "normal_damping_root": 0.0,
        "tangential_stiffness": factor * STIFFNESS_RATIO * NORMAL_STIFFNESS,
        "tangential_damping": factor * sqrt(STIFFNESS_RATIO) * NORMAL_DAMPING,
        "tangential_damping_root": 0.0,
        "sliding_friction": friction,
    }
    return Contact(Laws(normal, spring_slider_total.ROW), coefficients)


def contact_with_walls(friction: float = WALL_FRICTION) -> Contact:
    """Contact of the source's discs with its walls, which are stiffer."""
    return contact_of_discs(friction, factor=WALL_STIFFNESS_RATIO)


def silo_of_rows(
    across: int, levels: int, slit_share: float = 0.2, *, gap: float = GAPS[ACTIVE], offset: float = 0.0, seed: int = 0
) -> tuple[Model, float]:
    """A model of `levels` rows of `across` and one less discs, each moved at random by `offset` (m); and its slit (m).

    The discs of a row stand as far apart as those of 17/18.
    """
    width = width_as_steep(across)
    rise = sqrt((2.0 * RADIUS + gap) ** 2 - ((width - 2.0 * (RADIUS + gap)) / (across - 1) / 2.0) ** 2)
    fill = 2.0 * RADIUS + (levels - 0.5) * rise
    laid = {"width": width, "height": fill, "radius": RADIUS, "across": across, "gap": gap, "offset": offset, "seed": seed}
    x, y, radii = rows.place(**laid)
    silo = PlaneSilo(width, float(y.max()) + 0.1, slit_share * width)
    return Model(x, y, radii, DENSITY, silo.walls(), contact_of_discs(), contact_with_walls(), STEP, DOWN), silo.slit


def softened(model: Model, factor: float) -> Model:
    """The same discs with stiffness times `factor` and the damping ratio kept."""
    pair, wall = (
        contact.scaled(stiffness=factor, damping=sqrt(factor)) for contact in (model.pair_contact, model.wall_contact)
    )
    return replace(model, pair_contact=pair, wall_contact=wall)


def with_dashpot(model: Model, normal: NormalLaw) -> Model:
    """The same discs with another law of the normal force that takes the same coefficients."""
    pair, wall = (
        replace(contact, laws=replace(contact.laws, normal=normal)) for contact in (model.between(0, 0), model.at_wall(0, 0))
    )
    return replace(model, pair_contact=pair, wall_contact=wall)


def wall_force(engine: Engine, parts: int) -> np.ndarray:
    """Normal force (N/m) on the left and the right wall, (2, parts) from the floor to the fill's first height."""
    touching = wall_contacts(engine)
    height = engine.model.y.max() + engine.model.radius.max()
    edges = np.linspace(0.0, height, parts + 1)
    edges[-1] = np.inf
    sides = [touching.second == engine.model.wall_number(name) for name in SIDES]
    height_of, push = touching.place[:, 1], np.abs(touching.force[:, 0])
    return np.array([np.histogram(height_of[side], edges, weights=push[side])[0] for side in sides])
