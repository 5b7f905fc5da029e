"""The silo of benches and ladders: Kiyama & Fujimura's discs in rows that fill it, with a slit that may open."""

from dataclasses import replace
from math import sqrt

import numpy as np

from silostudy.contact.family import NormalLaw
from silostudy.contact.normal import spring_dashpot
from silostudy.contact.tangential import spring_slider_total
from silostudy.dem.engine import Engine
from silostudy.dem.model import Contact, Model, Wall
from silostudy.dem.pieces import Laws
from silostudy.dem.snapshot import wall_contacts
from silostudy.packing import PACKINGS

RADIUS, DENSITY, GRAVITY = 0.01, 2650.0, 9.81
STEP = 2.5e-5  # s, half of the bound of the packing at rest
OPEN = ("floor", ("floor_left", "floor_right"))
LEFT, RIGHT = 1, 2  # numbers of the side walls


def contact(factor: float = 1.0, friction: float = 0.577, normal: NormalLaw = spring_dashpot.ROW) -> Contact:
    """Kiyama & Fujimura (1983), Table 2, with Cundall and Strack's slider; walls have twice the factor."""
    weight = factor * DENSITY * GRAVITY
    coefficients = {
        "normal_stiffness": 364 * weight,
        "normal_damping": 0.153 * weight,
        "normal_damping_root": 0.0,
        "tangential_stiffness": 91 * weight,
        "tangential_damping": 0.0765 * weight,
        "tangential_damping_root": 0.0,
        "sliding_friction": friction,
    }
    return Contact(Laws(normal, spring_slider_total.ROW), coefficients)


def walls_of(width: float, height: float, slit: float) -> tuple[Wall, ...]:
    """Floor, sides, and the halves of the floor beside the slit, which wait for it to open."""
    left, right = 0.5 * (width - slit), 0.5 * (width + slit)
    return (
        Wall("floor", (0.0, 0.0), (width, 0.0)),
        Wall("left", (0.0, height), (0.0, 0.0)),
        Wall("right", (width, 0.0), (width, height)),
        Wall("floor_left", (0.0, 0.0), (left, 0.0), live=False),
        Wall("floor_right", (right, 0.0), (width, 0.0), live=False),
    )


def scene(across: int, levels: int, slit_share: float = 0.2, *, gap: float = 4e-5, offset: float = 0.0, seed: int = 0):
    """A model of `levels` rows of `across` and one less discs, each moved at random by `offset` (m); and its slit (m)."""
    width = (2.0 + (across - 1) * 38.0 / 17.0) * RADIUS
    rise = sqrt((2.0 * RADIUS + gap) ** 2 - ((width - 2.0 * (RADIUS + gap)) / (across - 1) / 2.0) ** 2)
    fill = 2.0 * RADIUS + (levels - 0.5) * rise
    rows = {"width": width, "height": fill, "radius": RADIUS, "across": across, "gap": gap, "offset": offset, "seed": seed}
    x, y, radii = PACKINGS["rows"].place(**rows)
    slit = slit_share * width
    walls = walls_of(width, float(y.max()) + 0.1, slit)
    return Model(x, y, radii, DENSITY, walls, contact(), contact(2.0, 0.176), STEP), slit


def softened(model: Model, factor: float) -> Model:
    """The same discs with stiffness times `factor` and the damping ratio kept."""
    pair, wall = (one.scaled(stiffness=factor, damping=sqrt(factor)) for one in (model.pair_contact, model.wall_contact))
    return replace(model, pair_contact=pair, wall_contact=wall)


def with_dashpot(model: Model, normal: NormalLaw) -> Model:
    """The same discs with another law of the normal force that takes the same coefficients."""
    pair, wall = (replace(one, laws=replace(one.laws, normal=normal)) for one in (model.pair_contact, model.wall_contact))
    return replace(model, pair_contact=pair, wall_contact=wall)


def wall_force(engine: Engine, parts: int) -> np.ndarray:
    """Normal force (N/m) on the left and the right wall, (2, parts) from the floor to the fill's first height."""
    touching = wall_contacts(engine)
    height = engine.model.y.max() + engine.model.radius.max()
    edges = np.linspace(0.0, height, parts + 1)
    edges[-1] = np.inf
    sides = [touching.second == number for number in (LEFT, RIGHT)]
    return np.array([np.histogram(touching.y[side], edges, weights=np.abs(touching.fx[side]))[0] for side in sides])
