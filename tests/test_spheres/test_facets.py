"""A sphere in a cylinder of facets beside one in the exact cylinder: the same force on the wall."""

from math import cos, pi, sin

import numpy as np
import pytest

from silostudy.dem.engine import Engine
from silostudy.dem.space.inserts import polygon
from silostudy.dem.space.walls import TurnedLine
from silostudy.scene.facets import facets_of
from tests.test_scene.test_facets import SIDES, WIDE, cylinder
from tests.test_spheres.scenes import GRAVITY, MASS, RADIUS, contact, spheres

pytestmark = pytest.mark.long
EXACT = (TurnedLine(name="exact", start=(WIDE, 0.0), end=(WIDE, 0.1)),)
STEPS, DT = 16_000, 1e-5


def mesh() -> tuple:
    entries = facets_of(cylinder(), "mesh", "m")
    return tuple(polygon(of["name"], tuple(map(tuple, of["corners_m"])), "both", of["sheet"]) for of in entries)


def test_a_sphere_comes_to_rest_under_its_weight():
    """It lies in the lowest joint of two facets, where neither pushes beside the other, or on the lowest line."""
    turn = 0.3
    way = np.array([cos(turn), sin(turn), 0.0])
    start = (WIDE - 1.5 * RADIUS) * np.array([cos(turn - 0.05), sin(turn - 0.05), 0.0]) + (0.0, 0.0, 0.045)
    felt, rest = [], []
    for walls in (EXACT, mesh()):
        model = spheres([start], walls=walls, gravity=tuple(GRAVITY * way), dt=DT, wall_contact=contact(0.3, 0.5))
        engine = Engine(model)
        engine.step_to(STEPS // 2)
        engine.clear_window()
        engine.step_to(STEPS)
        felt.append(engine.record.window[:, 0, 0].sum() / (STEPS - STEPS // 2))
        rest.append(engine.bodies.rows[0, :3].copy())
    assert felt[0] == pytest.approx(MASS * GRAVITY, rel=1e-2)
    assert felt[1] == pytest.approx(felt[0], rel=2e-2)
    assert np.linalg.norm(rest[1] - rest[0]) < 1.5 * pi / SIDES * WIDE
