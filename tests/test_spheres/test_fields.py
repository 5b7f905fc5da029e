"""Coarse-grained fields on arrangements whose sums and balances are known; the loop runs in Python, so nothing is compiled."""

from types import SimpleNamespace

import numpy as np
import pytest

from silostudy.compute.observers import observers_of
from silostudy.dem import coarse
from silostudy.dem.coarse import Instant, fields, sample
from silostudy.dem.contact_statistics import coordination, fabric_of
from silostudy.dem.grid import Grid
from silostudy.dem.snapshot import ContactForces
from silostudy.errors import BadInput
from tests.test_spheres.small import scene_of

RADIUS, MASS, GRAVITY = 0.004, 0.002, 9.81
VOLUME = 4.0 / 3.0 * np.pi * RADIUS**3
NOTHING = np.empty((0, 3))
BOXES = Grid((-0.05, -0.05, -0.05), (0.02, 0.02, 0.01), (5, 5, 20))
RINGS = Grid((0.0, -0.05), (0.01, 0.01), (7, 20), round=True)


@pytest.fixture(autouse=True)
def in_python(monkeypatch):
    monkeypatch.setattr(coarse, "share", coarse.share.py_func)


def bodies(count: int) -> tuple[np.ndarray, np.ndarray]:
    """Masses and volumes."""
    return np.full(count, MASS), np.full(count, VOLUME)


def flying(place, velocity) -> Instant:
    """Grains that touch nothing."""
    place = np.asarray(place, float)
    speed = np.broadcast_to(np.asarray(velocity, float), place.shape)
    return Instant(*bodies(len(place)), place, speed, NOTHING, NOTHING, NOTHING, NOTHING, NOTHING)


def stack(count: int, x=0.0) -> Instant:
    """Spheres that lie on a floor and on each other, at rest."""
    z = RADIUS * (2.0 * np.arange(count) + 1.0)
    place = np.column_stack([np.full(count, x), np.zeros(count), z])
    end, branch, force = place - [0.0, 0.0, 2.0 * RADIUS], np.tile([0.0, 0.0, 2.0 * RADIUS], (count, 1)), np.zeros((count, 3))
    end[0, 2], branch[0, 2] = 0.0, RADIUS
    force[:, 2] = MASS * GRAVITY * (count - np.arange(count))
    return Instant(*bodies(count), place, np.zeros_like(place), end, branch, force, end[:1], force[:1])


def summed(grid, values):
    """Integral over all cells."""
    return np.tensordot(grid.volumes, np.nan_to_num(values), axes=1)


@pytest.mark.parametrize("grid", [BOXES, RINGS])
@pytest.mark.parametrize("count", [1, 2])
def test_mass_and_stress_add_up_to_those_of_grains_and_contacts(grid, count):
    now = stack(count, x=0.013)
    found = fields(now, grid, 0.006)
    assert summed(grid, found.density) == pytest.approx(count * MASS, rel=1e-12)
    assert summed(grid, found.solid_fraction) == pytest.approx(count * VOLUME, rel=1e-12)
    carried = (now.branch[:, :, None] * now.force[:, None, :]).sum(axis=0)
    assert summed(grid, found.contact_stress)[2, 2] == pytest.approx(carried[2, 2], rel=1e-12)
    assert summed(grid, found.wall_force)[2] == pytest.approx(count * MASS * GRAVITY, rel=1e-12)


def test_a_slanting_contact_keeps_its_trace_in_rings_and_its_tensor_in_boxes():
    end, branch, force = np.array([[[0.01, 0.02, 0.01]], [[0.003, -0.004, 0.005]], [[3.0, 1.0, -2.0]]])
    now = flying([end[0]], 0.0)._replace(end=end, branch=branch, force=force)
    whole = np.outer(branch, force)
    assert summed(BOXES, fields(now, BOXES, 0.006).contact_stress) == pytest.approx(whole, rel=1e-12)
    turned = summed(RINGS, fields(now, RINGS, 0.006).contact_stress)
    assert np.trace(turned) == pytest.approx(np.trace(whole), rel=1e-12)
    assert turned[2, 2] == pytest.approx(whole[2, 2], rel=1e-12)


def test_a_translation_is_one_velocity_without_kinetic_stress():
    place = np.random.default_rng(1).uniform(-0.03, 0.03, (30, 3))
    found = fields(flying(place, (1.0, -2.0, 0.5)), BOXES, 0.008)
    there = found.density > 0.0
    assert np.isnan(found.velocity[~there]).all()
    assert found.velocity[there] == pytest.approx(np.tile([1.0, -2.0, 0.5], (there.sum(), 1)), rel=1e-12)
    assert np.abs(found.kinetic_stress).max() < 1e-12 * found.density.max()


def test_a_rotation_is_found_again():
    z, y, x = (axis.ravel() for axis in np.meshgrid([-0.006, 0.0, 0.006], *[np.arange(-4, 5) * 0.006] * 2, indexing="ij"))
    place = np.column_stack([x, y, z])
    found = fields(flying(place, 30.0 * np.column_stack([-y, x, 0.0 * z])), RINGS, 0.004)
    speed, r = found.velocity.reshape(7, 20, 3), RINGS.middles[:, 0].reshape(7, 20)
    middle = (slice(1, 3), slice(4, 6))
    assert speed[middle][..., 1] == pytest.approx(30.0 * r[middle], rel=0.05)
    assert np.abs(speed[middle][..., [0, 2]]).max() < 0.01 * 30.0 * 0.03


def test_momentum_flow_is_that_of_the_grains():
    random = np.random.default_rng(2)
    now = flying(random.uniform(-0.03, 0.03, (20, 3)), random.normal(size=(20, 3)))
    found = fields(now, BOXES, 0.01)
    mean = np.nan_to_num(found.velocity)
    flow = found.kinetic_stress + found.density[:, None, None] * mean[:, :, None] * mean[:, None, :]
    assert summed(BOXES, flow) == pytest.approx(MASS * now.velocity.T @ now.velocity, rel=1e-12)
    heat = np.trace(found.kinetic_stress, axis1=1, axis2=2)
    assert heat.min() > -1e-12 * heat.max()


def test_every_slice_of_a_stack_carries_what_is_above_less_what_the_floor_gives(monkeypatch):
    """The boundary term closes the balance also where the kernel reaches through the floor; a fine sample, for one stack."""
    fine = sample.__wrapped__
    monkeypatch.setattr(coarse, "POINTS", 256)
    monkeypatch.setattr(coarse, "LINES", 16)
    monkeypatch.setattr(coarse, "sample", fine)
    now, high = stack(5), 0.001
    grid = Grid((-0.02, -0.02, -0.02), (0.04, 0.04, high), (1, 1, 90))
    found, width = fields(now, grid, 0.006), 0.04**2
    loads = (found.density * GRAVITY - found.wall_force[:, 2]) * width * high
    above = np.cumsum(loads[::-1])[::-1] - 0.5 * loads
    weight = 5 * MASS * GRAVITY
    assert above[0] == pytest.approx(0.0, abs=1e-9 * weight)
    assert np.abs(found.contact_stress[:, 2, 2] * width - above).max() < 0.02 * weight
    assert above.max() > 0.7 * weight


def test_discs_have_the_same_sums():
    grid = Grid((-0.05, -0.05), (0.01, 0.01), (10, 20))
    place, branch, force = np.array([[[0.013, RADIUS]], [[0.0, RADIUS]], [[1.0, 5.0]]])
    end = place - branch
    found = fields(Instant(*bodies(1), place, 0.0 * place, end, branch, force, end, force), grid, 0.01)
    assert summed(grid, found.contact_stress) == pytest.approx(np.outer(branch, force), rel=1e-12)
    assert summed(grid, found.density) == pytest.approx(MASS, rel=1e-12)
    assert summed(grid, found.wall_force) == pytest.approx(force[0], rel=1e-12)
    assert found.velocity.shape == (200, 2)


@pytest.mark.parametrize(("ways", "square"), [(2, 5.0 / 28.0), (3, 0.25)])
def test_the_sample_is_lucy_s_kernel(ways, square):
    """Mean square distance over the reach: ratios of beta functions, worked out by hand."""
    points = sample(ways)
    assert (points[:, :3] ** 2).sum(axis=1).mean() == pytest.approx(square, rel=0.02)
    assert np.abs(points[:, :3].mean(axis=0)).max() < 1e-15
    spread = (points[:, :ways] ** 2).mean(axis=0)
    assert spread == pytest.approx(np.full(ways, square / ways), rel=0.12)


def test_cells_beyond_the_walls_take_the_kernel_and_rings_fill_the_cylinder():
    grid = Grid.around((0.0, 0.0), (0.3, 0.8), (3, 4), 0.25, round=True)
    assert (grid.low, grid.count) == ((0.0, -0.4), (6, 8))
    inner = (grid.middles[:, 0] < 0.3) & (grid.middles[:, 1] > 0.0) & (grid.middles[:, 1] < 0.8)
    assert grid.volumes[inner].sum() == pytest.approx(np.pi * 0.3**2 * 0.8, rel=1e-12)


def test_a_cubic_lattice_has_an_isotropic_fabric():
    assert np.array_equal(fabric_of(np.vstack([np.eye(3), -2.0 * np.eye(3)])), np.eye(3) / 3.0)
    assert np.isnan(fabric_of(np.empty((0, 3)))).all()


def test_a_grain_of_one_contact_is_a_rattler():
    """Three in a ring on the floor, a fourth that only leans on the first, and a fifth that touches nothing."""
    pairs = ContactForces(np.array([0, 1, 2, 3]), np.array([1, 2, 0, 0]), np.zeros((4, 3)), np.ones((4, 3)))
    walls = ContactForces(np.array([0, 1, 2]), np.zeros(3, int), np.zeros((3, 3)), np.ones((3, 3)))
    mean, held, rattlers = coordination(SimpleNamespace(n=5, most=5), pairs, walls)
    assert (mean, held, rattlers) == pytest.approx((11 / 5, 3.0, 0.4))


REFUSED = {
    "one cell": ({"cells": [4], "every_s": 0.1}, "record.fields.cells = \\[4\\]: must hold 2 or more"),
    "four cells": ({"cells": [4, 4, 4, 4], "every_s": 0.1}, "must hold 3 at most"),
    "too late": ({"cells": [4, 4], "every_s": 9.0}, "every_s = 9.0: must not be longer than march.limit_s, 1 s"),
    "rings of a square": ({"cells": [4, 4], "every_s": 0.1}, "must be three, along x, y and z"),
    "a wide kernel": ({"cells": [4, 4, 4], "width_mm": 1000, "every_s": 0.1}, "width_mm = 1000.0: spreads over"),
}


@pytest.mark.parametrize("case", REFUSED)
def test_what_cannot_be_is_refused_in_one_line(case):
    fields, told = REFUSED[case]
    square = {"plan": "square", "width_m": 0.06, "cylinder_depth_m": 0.1}

    def asked():
        scene = scene_of(record__fields=fields, silo=square, events=[{"when": "rest", "do": "stop"}])
        return observers_of(scene, SimpleNamespace(radius=np.array([RADIUS]), dt=1e-5))

    with pytest.raises(BadInput, match=told):
        asked()
