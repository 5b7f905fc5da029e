"""Hard cases of discrete elements where the right answer is a bound, the same bits, or a clear refusal."""

from math import pi

import numpy as np
import pytest

from silostudy.dem.engine import Engine
from silostudy.dem.events import Event
from silostudy.dem.explosion import Explosion
from silostudy.dem.lanes import STRETCH
from silostudy.dem.model import Wall
from silostudy.dem.run import Run
from silostudy.dem.stability import longest_step
from silostudy.errors import BadInput
from silostudy.packing import PACKINGS
from silostudy.scene.dem import check_start
from silostudy.tables.kiyama_1983 import ACTIVE, GAPS, width_as_steep
from tests.test_dem.scenes import DENSITY, RADIUS, STIFFNESS, box, contact, free, rows

MASS = DENSITY * pi * RADIUS**2
FLOOR = (Wall("floor", (-9.0, 0.0), (9.0, 0.0)),)


def pile(across=5, height=0.12, **changes):
    """A few discs in a box, about to settle."""
    width = width_as_steep(across)
    x, y, _ = PACKINGS["rows"].place(width=width, height=height, radius=RADIUS, across=across, gap=GAPS[ACTIVE])
    settings = {"walls": box(width, 0.3), "gravity": (0.0, -9.81), "dt": 2.5e-5}
    return free(x, y, **(settings | changes))


def energy(engine) -> float:
    """Kinetic energy (J/m)."""
    _, _, u, v, w = rows(engine).T
    return float(0.5 * MASS * (u**2 + v**2 + 0.5 * (RADIUS * w) ** 2).sum())


def test_a_million_steps_at_rest():
    """No creep, no drift, no gain: a settled pile stays where it is to the rounding of its places."""
    engine = Engine(pile())
    engine.step_to(100_000)
    before = rows(engine)
    engine.step_to(1_100_000)
    after = rows(engine)
    assert np.abs(after - before)[:, :2].max() < 1e-13
    assert energy(engine) < 1e-12 * len(before) * MASS * 9.81 * MASS * 9.81 / STIFFNESS
    assert np.isfinite(after).all()


@pytest.mark.parametrize(("share", "stays"), [(0.98, True), (1.05, False)])
def test_step_just_below_and_just_above_the_bound(share, stays):
    """Resting discs, a kick of a nanometre a step: below the bound it dies away, above it it grows a thousandfold."""
    settled = Engine(pile())
    settled.step_to(100_000)
    x, y = settled.places.T
    bound = longest_step(_at(x, y))
    engine = Engine(pile(dt=share * bound))
    engine.bodies.rows[: engine.n] = settled.bodies.rows[: engine.n]
    engine.give_memories(*settled.take_memories())
    engine.bodies.rows[: engine.n, 2:4] += 1e-6 * np.random.default_rng(0).standard_normal((engine.n, 2))
    before = energy(engine)
    engine.step_to(20_000)
    assert (energy(engine) < 1e-3 * before) if stays else (energy(engine) > 1e3 * before)


def _at(x, y):
    model = pile()
    return free(x, y, walls=model.walls, gravity=model.gravity, dt=model.dt)


@pytest.mark.parametrize("tiny", [5e-324, 1e-310, 1e-200])
def test_sub_normal_numbers(tiny):
    """Sub-normal speeds, spins and gravity move nothing, become no NaN, and vanish beside a motion of common size."""
    still = Engine(free([0.0, 1.999 * RADIUS], [0.0, 0.0], u=[tiny, -tiny], w=tiny, gravity=(0.0, -tiny), dt=1e-5))
    common = [Engine(free([0.0, 1.999 * RADIUS], [0.0, 0.0], u=[1.0, -1.0], w=[tiny * on, 0.0], dt=1e-6)) for on in (0, 1)]
    for engine in (still, *common):
        engine.step_to(1000)
        assert np.isfinite(rows(engine)).all()
    assert np.array_equal(rows(common[0])[:, [0, 2]], rows(common[1])[:, [0, 2]])
    assert np.abs(rows(common[1])[:, [1, 3, 4]]).max() < 1e3 * tiny


@pytest.mark.parametrize("radius", [1e-170, 1e160])
def test_radius_whose_mass_is_no_number(radius):
    with pytest.raises(BadInput, match=r"radius = .*mass and inertia"):
        free([0.0], [0.0], radius=radius)


@pytest.mark.parametrize(("field", "value"), [("gravity", (0.0, np.nan)), ("gravity", (np.inf, 0.0)),
                                              ("quake", np.array([[0.0, np.nan]]))])  # fmt: skip
def test_gravity_and_shaking_that_are_no_numbers(field, value):
    with pytest.raises(BadInput, match=f"{field}.*must be finite"):
        free([0.0], [0.0], **{field: value})


def test_coincident_centres():
    with pytest.raises(BadInput, match=r"discs 0, 1.*overlap by 0\.02 m"):
        check_start(FLOOR, np.array([0.0, 0.0]), np.array([0.05, 0.05]), np.full(2, RADIUS))
    model = free([0.0, 0.0], [0.5, 0.5])
    with pytest.raises(BadInput, match=r"discs 0, 1.*same place"):
        longest_step(model)
    with pytest.raises(Explosion, match=r"disc \d ran away.*overlap"):
        Engine(model).step_to(100)


def test_disc_too_fast_for_its_wall():
    """A disc that would step over a wall is caught by its way in a step, not carried on beyond."""
    engine = Engine(free([0.0], [0.5], v=-2000.0, dt=1e-5, walls=FLOOR))
    with pytest.raises(Explosion, match=r"disc 0 ran away at t = .*time step"):
        engine.step_to(1000)


def test_discs_too_soft_for_their_speed():
    """At 100 m/s the spring of 9.5 MN/m2 lets a centimetre's discs through each other: must be told, not computed."""
    engine = Engine(free([0.0, 2.5 * RADIUS], [0.0, 0.0], u=[50.0, -50.0], dt=1e-6))
    with pytest.raises(Explosion, match="overlap"):
        engine.step_to(2000)


def test_disc_too_heavy_for_its_floor():
    """A floor of 100 N/m2 lets a disc of 8 N/m through."""
    soft = contact(100.0 / STIFFNESS, damping=1.0)
    engine = Engine(free([0.0], [RADIUS], gravity=(0.0, -9.81), dt=1e-4, walls=FLOOR, wall_contact=soft))
    with pytest.raises(Explosion, match="overlap"):
        engine.step_to(20000)


@pytest.mark.parametrize("across", [2, 10, 13, 20, 28])
def test_lists_that_end_on_and_off_the_lanes(across):
    """Contacts around multiples of the vector width and of the lanes' length: the same bits for any length of the lists."""
    model = pile(across, 0.035 * 6 if across < 20 else 0.26)
    found = []
    for skin in (0.0, 1e-4, 2e-3, 0.012):
        engine = Engine(model, skin=skin)
        engine.step_to(2000)
        found.append(rows(engine))
        listed = engine.parts[0].pairs.begin[engine.blocks_of(engine.parts[0])]
        assert listed % 8 == 0
    assert all(np.array_equal(found[0], other) for other in found[1:])
    if across == 28:
        assert listed > 2 * STRETCH


def test_lists_that_run_out_of_room():
    """Many discs near each other: the lists grow while the scene runs, and the bits stay."""
    x, y = 1.99 * RADIUS * np.mgrid[:40, :40].reshape(2, -1)
    random = np.random.default_rng(2)
    u, v = random.uniform(-1.0, 1.0, (2, len(x)))
    tight, wide = (Engine(free(x, y, u=u, v=v, dt=1e-5), skin=skin) for skin in (0.0, 1.99 * RADIUS))
    room = wide.parts[0].room
    for engine in (tight, wide):
        engine.step_to(300)
    assert wide.parts[0].room > room
    assert np.array_equal(rows(tight), rows(wide))


@pytest.mark.parametrize("threads", [2, 7])
def test_more_threads_than_blocks_of_discs(threads):
    one, many = Engine(pile()), Engine(pile(), threads=threads)
    for engine in (one, many):
        engine.step_to(1000)
    assert np.array_equal(rows(one), rows(many))


def test_disc_in_a_corner_of_joined_walls():
    """Where two walls join, each pushes once: the corner itself adds nothing."""
    walls = (
        Wall("floor", (0.0, 0.0), (1.0, 0.0), joined=(True, False)),
        Wall("left", (0.0, 1.0), (0.0, 0.0), joined=(False, True)),
    )
    smooth = contact(2.0, 0.0)
    engine = Engine(free([RADIUS], [RADIUS], gravity=(-9.81, -9.81), dt=1e-5, walls=walls, wall_contact=smooth))
    engine.step_to(20000)
    x, y = rows(engine)[0, :2]
    assert RADIUS - x == pytest.approx(MASS * 9.81 / (2.0 * STIFFNESS), rel=1e-9)
    assert x == y


def test_last_disc_leaves():
    """A silo whose last disc falls out goes on to its stop, with nothing left and all of the mass counted."""
    model = free(
        [0.0], [RADIUS], gravity=(0.0, -9.81), dt=1e-4, walls=(*FLOOR, Wall("aside", (5.0, 0.0), (6.0, 0.0), live=False))
    )
    run = Run(Engine(model), (Event("time", 0.01, "open", ("floor", "aside")), Event("time", 0.5, "stop")), limit=1.0)
    recording = run.go()
    assert run.engine.n == 0
    assert run.dropped == pytest.approx(MASS, rel=1e-12)
    assert recording.happened[-1][0] == pytest.approx(0.5, rel=1e-9)


def test_event_that_removes_what_is_gone():
    """A disc that has left already is no mistake of the scene: the run says that nothing was removed, and goes on."""
    run = Run(Engine(pile()), (Event("time", 0.0, "remove", (999,)), Event("time", 0.1, "stop")), limit=1.0)
    run.go()
    assert [action for _, _, action in run.recording.happened] == ["remove nothing: the disc was not there", "stop"]
    assert run.engine.n == len(run.engine.model.x)


def test_another_scale():
    """Length, mass and time on other scales give the same motion: nothing in the engine has a size of its own."""
    k = 64.0  # a power of two, so that the bits can be the same
    small = Engine(free([0.0, 1.99 * RADIUS], [0.0, 0.5 * RADIUS], u=[0.25, -0.25], dt=2.0**-20))
    x, y, u = (k * np.array(pair) for pair in ([0.0, 1.99 * RADIUS], [0.0, 0.5 * RADIUS], [0.25, -0.25]))
    far = (Wall("far", (-1e6, -1e6), (1e6, -1e6)),)
    large = Engine(free(x, y, u=u, radius=RADIUS * k, density=DENSITY / k**2, dt=2.0**-20, walls=far))
    for engine in (small, large):
        engine.step_to(2000)
    np.testing.assert_allclose(rows(large)[:, :4], k * rows(small)[:, :4], rtol=1e-12)
