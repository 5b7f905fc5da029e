"""Small scenes that the tests share, so that few kernels are compiled."""

import numpy as np

from silostudy.dem.engine import Engine
from silostudy.dem.model import Contact, Model, Wall
from silostudy.dem.pieces import Laws
from silostudy.packing import PACKINGS

DENSITY, GRAVITY = 2650.0, 9.81
STIFFNESS, DAMPING = 364.0 * DENSITY * GRAVITY, 0.153 * DENSITY * GRAVITY  # Kiyama & Fujimura's Table 2 in SI
SLIDING = Laws.of(tangential="spring-slider")
RADIUS = 0.01


def contact(factor=1.0, friction=0.577, damping=DAMPING, laws=SLIDING, **more):
    """The paper's contact: walls are twice as stiff."""
    coefficients = {
        "normal_stiffness": factor * STIFFNESS,
        "normal_damping": factor * damping,
        "normal_damping_root": 0.0,
    }
    if laws.tangential.acts:
        coefficients |= {
            "tangential_stiffness": 0.25 * factor * STIFFNESS,
            "tangential_damping": 0.5 * factor * damping,
            "tangential_damping_root": 0.0,
            "sliding_friction": friction,
        }
    return Contact(laws, coefficients | more)


def box(width, height, slit=None):
    """Floor, and two sides; with a slit also the two halves that replace the floor."""
    walls = [
        Wall("floor", (0.0, 0.0), (width, 0.0), cells=5),
        Wall("left", (0.0, height), (0.0, 0.0), cells=5),
        Wall("right", (width, 0.0), (width, height), cells=5),
    ]
    if slit:
        walls.append(Wall("floor_left", (0.0, 0.0), ((width - slit) / 2, 0.0), cells=2, live=False))
        walls.append(Wall("floor_right", ((width + slit) / 2, 0.0), (width, 0.0), cells=2, live=False))
    return tuple(walls)


def silo(across=8, height=0.2, slit=0.06, **changes):
    """A small silo after the paper: fifty discs or so."""
    width = (2.0 + (across - 1) * 38.0 / 17.0) * RADIUS
    x, y, radius = PACKINGS["rows"].place(width=width, height=height, radius=RADIUS, across=across, gap=4e-5)
    settings = {
        "x": x,
        "y": y,
        "radius": radius,
        "density": DENSITY,
        "walls": box(width, 2.0 * height, slit),
        "pair_contact": contact(),
        "wall_contact": contact(2.0, 0.176),
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
        "wall_contact": contact(2.0, 0.176),
        "dt": 1e-6,
        "gravity": (0.0, 0.0),
        "u": u,
        "v": v,
        "w": w,
    }
    return Model(**(settings | changes))


def rows(engine: Engine) -> np.ndarray:
    """x, y, u, v, w of the discs that are left, by label."""
    return engine.discs.rows[: engine.n, :5][np.argsort(engine.labels)].copy()
