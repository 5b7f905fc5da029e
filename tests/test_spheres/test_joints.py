"""A sphere that the engine takes over the joint of cylinder and cone and over the outlet's rim."""

import numpy as np
import pytest

from silostudy.contact import elastic
from silostudy.dem.engine import Engine
from silostudy.dem.space.surfaces import nearest
from silostudy.dem.space.walls import FlatPiece
from silostudy.scene.silo import Hopper, Silo
from silostudy.scene.space_silo import FLOOR, SpaceSilo
from tests.test_spheres.scenes import INERTIA, MASS, MODULUS, POISSON, RADIUS, contact, rows, spheres

pytestmark = pytest.mark.long  # one kernel, but a large one

E_STAR = elastic.contact_modulus(MODULUS, POISSON, MODULUS, POISSON)
PULL = np.array([3.0, 0.5, -9.81])  # gravity that also presses the sphere on the wall (m/s2)
SPACE = SpaceSilo(silo=Silo(plan="circular", diameter=0.04, wall_depth=0.02, hopper=Hopper(half_angle=0.5, outlet_width=0.016)))


def travel(friction):
    """Depth in each surface (m), energy (J) and the walls' force (N), step by step until the sphere has left the silo.

    The energy is without that of the tangential springs.
    """
    walls = tuple(wall for wall in SPACE.walls() if wall.name != FLOOR)
    start = (0.02 - RADIUS, 0.0, SPACE.bottom + 0.006)
    touch, dt = contact(friction=friction), 4e-6
    engine = Engine(spheres([start], walls=walls, wall_contact=touch, gravity=tuple(PULL), dt=dt))
    found, limit = [], 60000
    while engine.step < limit:
        engine.step_to(engine.step + 1)
        found.append(rows(engine)[0])
        if found[-1][2] < -2.0 * RADIUS:
            break
    found = np.array(found)
    assert found[-1, 2] < -2.0 * RADIUS
    place, velocity, spin = found[:, :3], found[:, 3:6], found[:, 6:]
    beside = np.array([[nearest(engine.walls.shape, q, *point) for q in range(len(walls))] for point in place])
    depth = np.maximum(RADIUS - np.linalg.norm(beside[..., :3], axis=-1), 0.0)
    pressed = (8.0 / 15.0 * E_STAR * np.sqrt(RADIUS / (1.0 - RADIUS * beside[..., 3])) * depth**2.5).sum(axis=1)
    moving = 0.5 * MASS * (velocity**2).sum(axis=1) + 0.5 * INERTIA * (spin**2).sum(axis=1)
    force = MASS * (np.diff(velocity, axis=0) / dt - PULL)
    return depth, pressed + moving - MASS * place @ PULL, force


@pytest.mark.parametrize("friction", [0.0, 0.5])
def test_over_joint_and_rim(friction):
    depth, energy, force = travel(friction)
    names = [wall.name for wall in SPACE.walls() if wall.name != FLOOR]
    touched = (depth > 0.0).any(axis=0)
    assert dict(zip(names, touched, strict=True)) == {"hopper": True, "wall": True}
    assert (depth > 0.0).all(axis=1).any()  # both at once
    fallen = MASS * 9.81 * (SPACE.bottom + 0.006 + 2.0 * RADIUS)
    free = energy[(depth == 0.0).all(axis=1)]
    assert np.diff(free).max() < 1e-4 * fallen
    if not friction:
        assert np.ptp(energy) < 1e-3 * fallen
    size, change = np.linalg.norm(force, axis=1), np.linalg.norm(np.diff(force, axis=0), axis=1)
    assert change.max() < 0.05 * size.max()


def test_rolling_over_a_joint_in_one_plane():
    """As on the undivided plane: no jump in force, the whole history kept, and each piece feels what acts on it."""
    a, b, c, d = ((-0.01, -0.02, 0.0), (0.05, -0.02, 0.0), (0.05, 0.02, 0.0), (-0.01, 0.02, 0.0))
    halves = FlatPiece(name="one", corners=(a, b, c)), FlatPiece(name="two", corners=(a, c, d))
    touch, start = contact(friction=0.5), (0.0, -0.010, 0.999 * RADIUS)
    whole, parted = (
        Engine(spheres([start], walls=walls, wall_contact=touch, gravity=tuple(PULL), dt=4e-6))
        for walls in ((FlatPiece(name="whole", corners=(a, b, c, d)),), halves)
    )
    over = []
    for step in range(2500, 25001, 2500):
        whole.step_to(step)
        parted.step_to(step)
        (row,), (same,) = rows(parted), rows(whole)
        assert row == pytest.approx(same, rel=1e-9, abs=1e-12)
        over.append((row[1] - a[1]) / (row[0] - a[0]) > 0.04 / 0.06)
    assert over[0]
    assert not over[-1]
    felt, all_of_it = (engine.record.window[:, :, 0] for engine in (parted, whole))
    assert (felt[:, 0] > 0.2 * all_of_it[0, 0]).all()
    assert felt[:, 0].sum() == pytest.approx(all_of_it[0, 0], rel=1e-9)
