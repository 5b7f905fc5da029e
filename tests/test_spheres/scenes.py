"""Small scenes of spheres that the tests share, so that few kernels are compiled."""

from math import pi

import numpy as np

from silostudy.contact.coefficient import Given
from silostudy.dem.engine import Engine
from silostudy.dem.model import Contact
from silostudy.dem.pieces import Laws
from silostudy.dem.space.lanes import PLACE, SPIN, VELOCITY
from silostudy.dem.space.model import SphereModel
from silostudy.dem.space.walls import TurnedLine

RADIUS, DENSITY, MODULUS, POISSON, GRAVITY = 0.002, 2500.0, 1e7, 0.25, 9.81
MASS = DENSITY * 4.0 / 3.0 * pi * RADIUS**3
INERTIA = 0.4 * MASS * RADIUS**2
LAWS = Laws.of(normal="hertz", tangential="mindlin")


def contact(restitution=None, friction=0.5, modulus=MODULUS, laws=LAWS, materials=None) -> Contact:
    """Hertz and Mindlin between equal materials, or between two that are given."""
    both = materials or ((modulus, POISSON), (modulus, POISSON))
    given = Given({"materials": both, "restitution": restitution, "sliding_friction": friction}, 0.0, DENSITY, laws.normal)
    return Contact(laws, laws.normal.prepared(given) | laws.tangential.prepared(given))


def floor(wide=1.0) -> TurnedLine:
    """A level disc, its upper side at a height of zero."""
    return TurnedLine(name="floor", start=(0.0, 0.0), end=(wide, 0.0), joined=(True, True))


def bin_walls(wide: float, high: float) -> tuple[TurnedLine, ...]:
    """Floor and cylinder that meet, with cells for what they feel."""
    return (
        TurnedLine(name="floor", start=(0.0, 0.0), end=(wide, 0.0), joined=(True, True), cells=(2, 4)),
        TurnedLine(name="cylinder", start=(wide, 0.0), end=(wide, high), joined=(True, False), cells=(5, 8)),
    )


def spheres(place, velocity=(0.0, 0.0, 0.0), spin=(0.0, 0.0, 0.0), **changes) -> SphereModel:
    """Spheres at these places (n, 3) over a floor far below, without gravity."""
    place = np.atleast_2d(np.asarray(place, float))
    (x, y, z), (u, v, w), (p, q, r) = (np.broadcast_to(np.asarray(of, float), place.shape).T for of in (place, velocity, spin))
    settings = {
        "x": x, "y": y, "z": z, "u": u, "v": v, "w": w, "p": p, "q": q, "r": r,
        "radius": np.full(len(place), RADIUS), "density": DENSITY, "walls": (floor(),),
        "pair_contact": contact(), "wall_contact": contact(), "dt": 1e-6, "gravity": (0.0, 0.0, 0.0), "watched": True,
    }  # fmt: skip
    return SphereModel(**(settings | changes))


def heap(layers=12, wide=6.2 * RADIUS, **changes) -> SphereModel:
    """Spheres that fall from a lattice into a cylinder."""
    pitch = 2.1 * RADIUS
    across = np.array([-pitch, 0.0, pitch])
    z, x, y = (axis.ravel() for axis in np.meshgrid(RADIUS * 1.1 + pitch * np.arange(layers), across, across, indexing="ij"))
    place = np.c_[x, y, z] + np.random.default_rng(3).uniform(-0.04, 0.04, (len(x), 3)) * RADIUS
    high = float(z.max()) + 4.0 * RADIUS
    settings = {"walls": bin_walls(wide, high), "gravity": (0.0, 0.0, -GRAVITY), "dt": 1e-5,
                "pair_contact": contact(0.5), "wall_contact": contact(0.5, 0.3)}  # fmt: skip
    return spheres(place, **(settings | changes))


def rows(engine: Engine) -> np.ndarray:
    """Place, velocity and spin of every sphere by its number."""
    order = np.argsort(engine.labels)
    return engine.bodies.rows[: engine.n][order][:, [*PLACE, *VELOCITY, *SPIN]]


def stepped(engine: Engine, steps: int) -> tuple[np.ndarray, np.ndarray]:
    """Rows and window of wall forces after so many steps."""
    engine.step_to(steps)
    return rows(engine), engine.record.window.copy()


def same(a, b) -> bool:
    """Whether all arrays of two runs have the same bits."""
    return all(np.array_equal(one, other) for one, other in zip(a, b, strict=True))
