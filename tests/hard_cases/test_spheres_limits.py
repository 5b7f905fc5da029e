"""Hard cases of spheres where the right answer is a bound, the same bits, or a clear refusal by the engine; one kernel."""

from math import sqrt

import numpy as np
import pytest

from silostudy.dem.engine import Engine
from silostudy.dem.events import Event
from silostudy.dem.explosion import Explosion
from silostudy.dem.run import Run
from silostudy.dem.space.walls import FlatPiece, TurnedLine
from silostudy.dem.stability import longest_step
from silostudy.dem.strength import DEEP
from silostudy.errors import BadInput
from tests.test_spheres.scenes import GRAVITY, MASS, RADIUS, bin_walls, contact, floor, heap, rows, spheres

pytestmark = pytest.mark.long
DOWN = (0.0, 0.0, -GRAVITY)


def test_spheres_without_gravity_and_motion_change_no_bit():
    random = np.random.default_rng(1)
    place = 2.5 * RADIUS * (np.mgrid[:4, :4, :4].reshape(3, -1).T + random.uniform(-0.1, 0.1, (64, 3)) + 1.0)
    engine = Engine(spheres(place, dt=1e-4))
    engine.step_to(20_000)
    assert np.array_equal(rows(engine)[:, :3], place)


@pytest.mark.parametrize("tiny", [5e-324, 1e-310, 1e-200])
def test_sub_normal_numbers_of_spheres(tiny):
    """Sub-normal speeds, spins and gravity move nothing and become no NaN."""
    place = [(0.0, 0.0, 0.5), (1.999 * RADIUS, 0.0, 0.5)]
    still = Engine(spheres(place, [(0.0, tiny, 0.0), (0.0, -tiny, 0.0)], (tiny, 0.0, tiny), gravity=(0.0, 0.0, -tiny)))
    common = [Engine(spheres(place, [(1.0, 0.0, 0.0), (-1.0, 0.0, 0.0)], (tiny * on, 0.0, tiny * on))) for on in (0, 1)]
    for engine in (still, *common):
        engine.step_to(1000)
        assert np.isfinite(rows(engine)).all()
    assert np.array_equal(rows(common[0])[:, [0, 3]], rows(common[1])[:, [0, 3]])
    assert np.abs(rows(common[1])[:, [1, 4, 5]]).max() < 1e3 * tiny


def test_coincident_centres_of_spheres():
    model = spheres([(0.0, 0.0, 0.5), (0.0, 0.0, 0.5)])
    with pytest.raises(BadInput, match=r"x, y, z = .*spheres 0, 1.*same place"):
        longest_step(model)
    with pytest.raises(Explosion, match=r"sphere \d ran away.*overlap"):
        Engine(model).step_to(100)


def test_sphere_too_fast_for_its_wall():
    engine = Engine(spheres([(0.0, 0.0, 0.1)], [(0.0, 0.0, -3000.0)]))
    with pytest.raises(Explosion, match=r"sphere 0 ran away at t = .*time step"):
        engine.step_to(1000)


def test_spheres_too_soft_for_their_speed():
    """At 100 m/s spheres of 10 MPa would pass through each other: it is told, not computed."""
    place = [(0.0, 0.0, 0.5), (2.5 * RADIUS, 0.0, 0.5)]
    engine = Engine(spheres(place, [(50.0, 0.0, 0.0), (-50.0, 0.0, 0.0)]))
    with pytest.raises(Explosion, match="overlap is beyond half a radius"):
        engine.step_to(2000)


def test_sphere_too_heavy_for_its_floor():
    engine = Engine(spheres([(0.0, 0.0, RADIUS)], gravity=DOWN, wall_contact=contact(0.5, 0.5, 1.0), dt=1e-4))
    with pytest.raises(Explosion, match="overlap is beyond half a radius"):
        engine.step_to(20_000)


NONE = [("radius", 1e-120), ("radius", 1e60), ("density", 0.0), ("density", np.nan), ("dt", 0.0),
        ("gravity", (0.0, np.nan, 0.0)), ("z", [np.inf]), ("u", [np.nan])]  # fmt: skip


@pytest.mark.parametrize(("field", "value"), NONE)
def test_spheres_whose_numbers_are_none(field, value):
    with pytest.raises(BadInput, match=rf"^{field} = "):
        spheres([(0.0, 0.0, 0.5)], **{field: np.array([value]) if field == "radius" else value})


def test_surfaces_that_cannot_be():
    """Without an extent, folded, not in one plane, not convex, or at no place."""
    a, b, c, d = (0.0, 0.0, 0.0), (1.0, 0.0, 0.0), (1.0, 1.0, 0.0), (0.0, 1.0, 0.0)
    with pytest.raises(BadInput, match="must have an extent"):
        TurnedLine(name="ring", start=(1.0, 0.0), end=(1.0, 0.0))
    with pytest.raises(BadInput, match="none negative"):
        TurnedLine(name="ring", start=(-1.0, 0.0), end=(1.0, 0.0))
    with pytest.raises(BadInput, match="finite"):
        TurnedLine(name="ring", start=(np.nan, 0.0), end=(1.0, 0.0))
    for corners, told in (
        ((a, b), "three finite corners"),
        ((a, b, (2.0, 0.0, 0.0)), "must have an extent"),
        ((a, b, c, (0.0, 1.0, 0.1)), "must lie in one plane, and do not by"),
        ((a, b, (0.2, 0.2, 0.0), d), "must be convex"),
        ((a, c, b, d), "must be convex|must have an extent"),
    ):
        with pytest.raises(BadInput, match=told):
            FlatPiece(name="face", corners=corners)


@pytest.mark.parametrize("away", [(1024.0, 0.0), (700.0, -700.0)])
def test_spheres_far_from_the_axis(away):
    """A pile a kilometre off: what rounding of places leaves, and no more."""
    place = np.array([(0.0, 0.0, 1.0), (2.0, 0.0, 1.0), (1.0, sqrt(3.0), 1.0), (1.0, 1.0 / sqrt(3.0), 1.0 + sqrt(8.0 / 3.0))])
    near, far = (
        Engine(spheres(place * RADIUS + (*shift, 0.0), walls=(floor(2000.0),), gravity=DOWN, dt=5e-6,
                       pair_contact=contact(0.5), wall_contact=contact(0.5)))
        for shift in ((0.0, 0.0), away)
    )  # fmt: skip
    for engine in (near, far):
        engine.step_to(3000)
    assert np.abs(rows(near)[:, :2] - place[:, :2] * RADIUS).max() > 1e-8
    assert rows(far)[:, :3] - (*away, 0.0) == pytest.approx(rows(near)[:, :3], abs=1e5 * np.spacing(1024.0))


@pytest.mark.parametrize("threads", [2, 7])
def test_more_threads_than_blocks_of_spheres(threads):
    one, many = Engine(heap(layers=2)), Engine(heap(layers=2), threads=threads)
    for engine in (one, many):
        engine.step_to(1000)
    assert np.array_equal(rows(one), rows(many))


def test_lists_of_spheres_that_run_out_of_room():
    """Many near each other: lists grow while the scene runs, and the bits stay."""
    place = 1.99 * RADIUS * (np.mgrid[:8, :8, :8].reshape(3, -1).T + 1.0)
    velocity = np.random.default_rng(2).uniform(-0.3, 0.3, place.shape)
    tight, wide = (Engine(spheres(place, velocity, dt=5e-6), skin=skin) for skin in (0.0, 1.99 * RADIUS))
    room = wide.parts[0].room
    for engine in (tight, wide):
        engine.step_to(300)
    assert wide.parts[0].room > room
    assert np.array_equal(rows(tight), rows(wide))


def test_last_sphere_leaves():
    """A silo runs empty: the run goes on to its stop with all mass counted."""
    plug = TurnedLine(name="plug", start=(0.0, 0.0), end=(0.01, 0.0))
    model = spheres([(0.0, 0.0, RADIUS)], gravity=DOWN, dt=1e-5, walls=(plug,), wall_contact=contact(0.5))
    run = Run(Engine(model), (Event("time", 0.01, "open", ("plug",)), Event("time", 0.5, "stop")), limit=1.0)
    recording = run.go()
    assert run.engine.n == 0
    assert run.dropped == pytest.approx(MASS, rel=1e-12)
    assert recording.happened[-1][0] == pytest.approx(0.5, rel=1e-9)


@pytest.mark.parametrize(("share", "stays"), [(0.98, True), (1.02, False)])
def test_step_just_below_and_just_above_the_bound_of_spheres(share, stays):
    """A sphere gripped by two plates, as deep as the bound looks at: its swing stays as small as it began, or grows."""
    high = 2.0 * RADIUS * (1.0 - DEEP)
    plates = (floor(), TurnedLine(name="lid", start=(0.0, high), end=(1.0, high), joined=(True, True)))
    start, grip = [(0.0, 0.0, 0.5 * high)], contact(None, 1e6)
    bound = longest_step(spheres(start, walls=plates, wall_contact=grip))
    engine = Engine(spheres(start, spin=(1e-3, 0.0, 0.0), walls=plates, wall_contact=grip, dt=share * bound))
    spins = []
    for step in range(1, 2001):
        engine.step_to(step)
        spins.append(abs(rows(engine)[0, 6]))
    assert (max(spins) < 0.02) if stays else (max(spins) > 1.0)


def test_a_bin_of_spheres_turned_by_a_quarter():
    """Nothing prefers a direction: the same bin, gravity aslant, turned by 90 degrees about its axis."""
    pull = np.array([2.0, 1.0, -9.0])

    def settled(quarter):
        model = heap(layers=3)
        place = np.c_[model.x, model.y, model.z]
        velocity = np.random.default_rng(4).normal(size=place.shape) * 0.5
        if quarter:
            place, velocity, gravity = (np.c_[-of[:, 1], of[:, 0], of[:, 2]] for of in (place, velocity, pull[None]))
        else:
            gravity = pull[None]
        engine = Engine(spheres(place, velocity, walls=bin_walls(6.2 * RADIUS, 0.05), gravity=tuple(gravity[0]), dt=5e-6,
                                pair_contact=contact(0.5), wall_contact=contact(0.5, 0.3)))  # fmt: skip
        engine.step_to(2000)
        return rows(engine)

    straight, turned = settled(False), settled(True)
    assert np.abs(straight[:, 6:]).max() > 0.1
    assert np.c_[-straight[:, 1], straight[:, 0], straight[:, 2]] == pytest.approx(turned[:, :3], abs=1e-9 * RADIUS)


def test_density_beyond_all_reason_still_falls():
    """Spheres of 1e-6 and 1e12 kg/m3 fall alike."""
    for density in (1e-6, 1e12):
        engine = Engine(spheres([(0.0, 0.0, 0.5)], density=density, gravity=DOWN, dt=1e-5))
        engine.step_to(10_000)
        assert rows(engine)[0, 5] == pytest.approx(-GRAVITY * 0.1, rel=1e-12)
