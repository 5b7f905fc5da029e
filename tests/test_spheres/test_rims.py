"""A sphere over an outlet that opens at a speed, and in the corner of a rectangular one: what the rims do to it."""

from math import sqrt

import numpy as np
import pytest

from silostudy.dem.engine import Engine
from silostudy.dem.space.lanes import VELOCITY
from silostudy.dem.space.level import Hole, LevelPiece, Outline
from tests.test_spheres.scenes import GRAVITY, RADIUS, contact, rows, spheres

pytestmark = pytest.mark.long  # kernels of their own
OPENS = 0.04  # m/s


def over(hole, place, speed=0.0, **changes):
    """The engine of a sphere at a place over a level floor with a hole that is opened at a speed, or at once."""
    floor = LevelPiece(
        name="floor", height=0.0, outline=Outline(sides=4, half=(20.0 * RADIUS,) * 2), holes=(Hole(name="hole", outline=hole),)
    )
    settings = {"gravity": (0.0, 0.0, -GRAVITY), "dt": 5e-6, "moving": True, "wall_contact": contact(0.3, 0.3)}
    engine = Engine(spheres([place], walls=(floor,), **(settings | changes)))
    floor.opened(engine.walls.shape[0], ("hole",), speed)
    return engine


@pytest.mark.parametrize(("sides", "off"), [(0, 0.0), (0, 0.3), (3, 0.0), (4, 0.0), (4, 0.3), (6, 0.0), (6, 0.3)])
def test_it_sinks_between_rims_as_they_part_and_falls_free_after(sides, off):
    """sqrt(r2 - w2) over rims that are 2w apart, wherever it stood; nothing holds it once they are a diameter apart."""
    hole = Outline(sides=sides, half=(3.0 * RADIUS, 10.0 * RADIUS if sides == 4 else 3.0 * RADIUS))
    engine = over(hole, (off * RADIUS, 0.0, 0.9995 * RADIUS), OPENS)
    for share in (0.5, 0.8, 0.9):
        engine.step_to(round(share * RADIUS / (0.5 * OPENS) / 5e-6))
        ((x, _, z, *_),) = rows(engine)
        if off == 0.0 or share > 0.75:  # before, the sphere beside the middle stands on one rim
            assert z == pytest.approx(sqrt(1.0 - share**2) * RADIUS, abs=6e-3 * RADIUS)
            assert abs(x) < 6e-3 * RADIUS
    engine.step_to(round(1.1 * RADIUS / (0.5 * OPENS) / 5e-6))
    before = rows(engine)[0, 5]
    engine.step_to(engine.step + 1000)
    assert rows(engine)[0, 5] - before == pytest.approx(-GRAVITY * 1000 * 5e-6, rel=1e-9)


def test_a_corner_gives_back_what_came_straight_into_it():
    """Along its diagonal: no energy is won or lost where the nearer side changes from step to step."""
    speed, start = 0.3, 4.98 * RADIUS
    engine = over(Outline(sides=4, half=(6.0 * RADIUS,) * 2), (start, start, 0.0), gravity=(0.0, 0.0, 0.0), dt=2e-7,
                  moving=False, wall_contact=contact(None, 0.0))  # fmt: skip
    engine.bodies.rows[0, list(VELOCITY)] = speed * sqrt(0.5), speed * sqrt(0.5), 0.0
    engine.step_to(20000)
    assert rows(engine)[0, 3:6] == pytest.approx(np.array([-1.0, -1.0, 0.0]) * speed * sqrt(0.5), abs=1e-3 * speed)
