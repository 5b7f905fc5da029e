"""Small scenes that the tests share, so that few kernels are compiled."""

import numpy as np

from silostudy.dem.engine import Engine
from silostudy.dem.model import Contact, Model, Wall
from silostudy.dem.pieces import Laws
from silostudy.packing import PACKINGS
from silostudy.scene.plane_silo import PlaneSilo
from silostudy.tables import kiyama_1983 as kiyama
from silostudy.tables.constants import ROUNDED_GRAVITY as GRAVITY
from silostudy.tables.kiyama_1983 import DENSITY, RADIUS

STIFFNESS, DAMPING = kiyama.NORMAL_STIFFNESS, kiyama.NORMAL_DAMPING
SLIDING = Laws.of(tangential="spring-slider")


def contact(factor=1.0, friction=kiyama.DISC_FRICTION, damping=DAMPING, laws=SLIDING, **more):
    """The paper's contact, with stiffness and dashpots times a factor."""
    coefficients = {
        "normal_stiffness": factor * STIFFNESS,
        "normal_damping": factor * damping,
        "normal_damping_root": 0.0,
    }
    if laws.tangential.acts:
        coefficients |= {
            "tangential_stiffness": kiyama.STIFFNESS_RATIO * factor * STIFFNESS,
            "tangential_damping": kiyama.STIFFNESS_RATIO**0.5 * factor * damping,
            "tangential_damping_root": 0.0,
            "sliding_friction": friction,
        }
    return Contact(laws, coefficients | more)


def against_walls():
    """The paper's contact with walls, which are stiffer."""
    return contact(kiyama.WALL_STIFFNESS_RATIO, kiyama.WALL_FRICTION)


def box(width, height, slit=0.0):
    """Floor, and two sides; with a slit also the two halves that replace the floor."""
    return PlaneSilo(width, height, slit).walls(cells=5, half_cells=2)


def silo(across=8, height=0.2, slit=0.06, **changes):
    """A small silo after the paper: fifty discs or so."""
    width = kiyama.width_as_steep(across)
    x, y, radius = PACKINGS["rows"].place(
        width=width, height=height, radius=RADIUS, across=across, gap=kiyama.GAPS[kiyama.ACTIVE]
    )
    settings = {
        "x": x,
        "y": y,
        "radius": radius,
        "density": DENSITY,
        "walls": box(width, 2.0 * height, slit),
        "pair_contact": contact(),
        "wall_contact": against_walls(),
        "dt": 2.5e-5,
        "gravity": (0.0, -GRAVITY),
        "watched": True,
    }
    return Model(**(settings | changes))


def free(x, y, u=0.0, v=0.0, w=0.0, **changes):
    """Discs without walls or gravity."""
    settings = {
        "x": np.asarray(x, float),
        "y": np.asarray(y, float),
        "radius": RADIUS,
        "density": DENSITY,
        "walls": (Wall("far", (-1e3, -1e3), (1e3, -1e3)),),
        "pair_contact": contact(),
        "wall_contact": against_walls(),
        "dt": 1e-6,
        "gravity": (0.0, 0.0),
        "u": u,
        "v": v,
        "w": w,
    }
    return Model(**(settings | changes))


def rows(engine: Engine) -> np.ndarray:
    """x, y, u, v, w of the discs that are left, by label."""
    return engine.bodies.rows[: engine.n, :5][np.argsort(engine.labels)].copy()
