"""Lines that stand free in a scene of discs: exact motions on them, over their ends, and where they meet."""

from itertools import pairwise
from math import atan2, cos, pi, radians, sin

import numpy as np
import pytest

from silostudy.dem.checkpoint import checkpoint, restore
from silostudy.dem.engine import Engine
from silostudy.dem.model import Wall
from silostudy.dem.network import all_from_wall
from silostudy.dem.snapshot import wall_contacts
from silostudy.dem.stability import longest_step
from silostudy.dem.walls import faces, nearest, shape_of
from silostudy.dem.watch import first_of_faces
from silostudy.scene.plane_silo import PlaneSilo
from silostudy.tables.constants import ROUNDED_GRAVITY as GRAVITY

from .scenes import DENSITY, RADIUS, STIFFNESS, contact, free, rows, silo

MASS = DENSITY * pi * RADIUS**2
WEIGHT = (0.0, -GRAVITY)


def line(name, start, end, cells=1):
    return Wall(name, tuple(map(float, start)), tuple(map(float, end)), cells, faces=2)


def chain(*places, name="line"):
    """Lines from each place to the next."""
    return tuple(line(f"{name} {number}", *ends) for number, ends in enumerate(pairwise(places)))


def lying(angle, end=0.0, factor=2.0):
    """Place of a disc above the start of a slope, pressed in as its weight does."""
    deep = RADIUS - MASS * GRAVITY * cos(angle) / (factor * STIFFNESS)
    return end * cos(angle) - deep * sin(angle), end * sin(angle) + deep * cos(angle)


def felt(engine, steps):
    """Mean force (N/m) along x and y of each face on the discs over some steps."""
    engine.clear_window()
    engine.step_to(engine.step + steps)
    mean = np.add.reduceat(engine.record.window[:, :, 0] / steps, first_of_faces(engine.walls.cells), axis=0)
    found = {}
    for (name, wall), (push, drag) in zip(faces(engine.model.walls), mean, strict=True):
        way = np.subtract(wall.end, wall.start) / np.hypot(*np.subtract(wall.end, wall.start))
        normal = np.array([-way[1], way[0]]) * (-1.0 if name.endswith("_back") else 1.0)
        found[name] = push * normal + drag * way * (-1.0 if way[1] < 0.0 else 1.0)
    return found


@pytest.mark.parametrize("reverse", [False, True])
@pytest.mark.parametrize(("angle", "mu"), [(20.0, 0.6), (35.0, 0.1)])
def test_rolling_down_a_line(angle, mu, reverse):
    """At 2/3 g sin while the slope's tangent is three times the friction at most, else sliding; on either face."""
    tilt = radians(angle)
    x, y = lying(tilt, 3.0)
    ends = [(0.0, 0.0), (4.0 * cos(tilt), 4.0 * sin(tilt))]
    slope = line("slope", *(ends[::-1] if reverse else ends))
    engine = Engine(free([x], [y], gravity=WEIGHT, dt=1e-5, walls=(slope,), wall_contact=contact(2.0, mu), watched=True))
    engine.step_to(20000)
    ((_, _, u, v, w),) = rows(engine)
    speed = 2.0 / 3.0 * GRAVITY * sin(tilt) if np.tan(tilt) <= 3.0 * mu else GRAVITY * (sin(tilt) - mu * cos(tilt))
    assert np.hypot(u, v) / engine.time == pytest.approx(speed, rel=5e-3)
    assert atan2(-v, -u) == pytest.approx(tilt, abs=1e-4)
    assert w > 0.0
    forces = felt(engine, 1000)
    push, none = (forces[name] for name in (("slope_back", "slope") if reverse else ("slope", "slope_back")))
    assert push @ [-sin(tilt), cos(tilt)] == pytest.approx(MASS * GRAVITY * cos(tilt), rel=1e-4)
    assert not none.any()


@pytest.mark.parametrize(("left", "right"), [(30.0, 30.0), (20.0, 60.0)])
def test_resting_in_a_trough(left, right):
    """Two smooth lines carry a disc with forces that close the triangle of its weight; their point pushes nobody."""
    a, b = radians(left), radians(right)
    walls = chain((-0.3 * cos(a), 0.3 * sin(a)), (0.0, 0.0), (0.3 * cos(b), 0.3 * sin(b)))
    off = RADIUS / sin((pi - a - b) / 2.0)
    middle = (b + pi - a) / 2.0
    smooth = contact(2.0, 0.0)
    engine = Engine(
        free([off * cos(middle)], [off * sin(middle)], gravity=WEIGHT, dt=2e-5, walls=walls, wall_contact=smooth, watched=True)
    )
    engine.step_to(40000)
    forces = felt(engine, 100)
    expected = {"line 0": MASS * GRAVITY * sin(b) / sin(a + b), "line 1": MASS * GRAVITY * sin(a) / sin(a + b)}
    for name, value in expected.items():
        assert np.hypot(*forces[name]) == pytest.approx(value, rel=1e-6)
        assert not forces[f"{name}_back"].any()
    assert not engine.record.window[engine.walls.cells[:, 0]].any()  # starts of lines, the shared point among them
    assert sum(forces.values()) == pytest.approx([0.0, MASS * GRAVITY], rel=1e-9, abs=1e-9)


def test_over_an_end():
    """A disc slides off a smooth line: round its end the centre keeps on a circle, its energy is kept, and the end alone
    pushes until it flies."""
    smooth = contact(2.0, 0.0, damping=0.0)
    x, y = lying(0.0, 0.0)
    table = line("table", (-0.5, 0.0), (0.0, 0.0))
    engine = Engine(free([x - 0.02], [y], u=[0.1], gravity=WEIGHT, dt=2e-6, walls=(table,), wall_contact=smooth, watched=True))
    energy, seen = GRAVITY * y + 0.5 * 0.1**2, 0
    for _ in range(400):
        engine.clear_window()
        engine.step_to(engine.step + 500)
        ((x, y, u, v, _),) = rows(engine)
        start, table, end, *back = engine.record.window[:, 0, 2]
        assert max(start, *back) <= 0.0
        assert GRAVITY * y + 0.5 * (u**2 + v**2) == pytest.approx(energy, rel=1e-3)
        if x > 1e-4 and end > 0.0:
            seen += 1
            assert np.hypot(x, y) == pytest.approx(RADIUS, rel=2e-3)
            assert table <= 0.0 or x < 5e-4
    assert seen > 20
    assert x > RADIUS


def test_a_disc_thrown_at_an_end_comes_straight_back():
    spear = line("spear", (0.0, 0.0), (0.3, 0.0))
    engine = Engine(
        free([-1.5 * RADIUS, -1.5 * RADIUS], [0.0, -2.01 * RADIUS], u=[1.0, 1.0], dt=2e-6, walls=(spear,),
             wall_contact=contact(2.0, 0.5, damping=0.0), pair_contact=contact(damping=0.0))
    )  # fmt: skip
    engine.step_to(20000)
    thrown, beside = rows(engine)
    assert thrown[2:] == pytest.approx([-1.0, 0.0, 0.0], abs=1e-4)
    assert beside[2:] == pytest.approx([1.0, 0.0, 0.0], abs=0.0)  # it passes below the line and is not touched


@pytest.mark.parametrize("angle", [0.0, 33.0])
def test_a_joint_of_a_straight_line_is_none(angle):
    """Two lines of one slope, and one line: a smooth disc slides over the joint on the same way to the last bits."""
    tilt = radians(angle)
    along, start = np.array([cos(tilt), sin(tilt)]), np.array(lying(tilt, 0.02))
    ends = [tuple(part * along) for part in (-0.5, 0.0, 0.5)]
    how = {"u": -0.4 * along[:1], "v": -0.4 * along[1:], "gravity": WEIGHT, "dt": 1e-5, "wall_contact": contact(2.0, 0.0)}
    engines = [Engine(free(start[:1], start[1:], walls=walls, **how)) for walls in (chain(*ends), chain(ends[0], ends[2]))]
    for step in range(0, 20000, 500):
        for engine in engines:
            engine.step_to(step)
        np.testing.assert_allclose(*map(rows, engines), rtol=1e-10, atol=1e-13)
    assert rows(engines[0])[0, :2] @ along < -0.02


@pytest.mark.long  # a reader of its own
def test_a_disc_exactly_over_a_joint_has_one_contact():
    flat = chain((-0.1, 0.0), (0.0, 0.0), (0.1, 0.0))
    engine = Engine(free([0.0], [0.999 * RADIUS], walls=flat, gravity=WEIGHT))
    assert len(wall_contacts(engine).first) == 1
    ridge = chain((-0.1, -0.1), (0.0, 0.0), (0.1, -0.1))
    engine = Engine(free([0.0], [0.999 * RADIUS], walls=ridge, gravity=WEIGHT))
    assert len(wall_contacts(engine).first) == 1


def stars() -> list:
    """Lines that meet in one point, two to five, also with a line that stands on another, at random."""
    random, found = np.random.default_rng(4), []
    for count in (2, 2, 2, 2, 3, 3, 3, 4, 5):
        turns, at = random.uniform(-pi, pi, count), random.uniform(-1.0, 1.0, 2)
        tips = [at + random.uniform(0.5, 1.0) * np.array([cos(turn), sin(turn)]) for turn in turns]
        met = (line(f"{n}", *((at, tip) if random.random() < 0.5 else (tip, at))) for n, tip in enumerate(tips))
        found.append((tuple(met), at))
    at = np.array([0.3, 0.1])
    return [*found, ((line("base", (-1.0, 0.1), (1.0, 0.1)), line("post", at, (0.8, 0.9))), at)]


@pytest.mark.parametrize(("walls", "at"), stars())
def test_every_place_is_pushed_and_the_point_pushes_once(walls, at):
    shape = shape_of(walls)
    places = at + np.random.default_rng(1).uniform(-0.3, 0.3, (500, 2))
    true = np.array([np.hypot(*all_from_wall(shape, n, places).T) for n in range(len(walls))]).min(axis=0)
    for place, distance in zip(places, true, strict=True):
        found = np.array([nearest(shape, n, *place)[:2] for n in range(len(walls))])
        away = np.hypot(*found.T)
        assert away.min() == pytest.approx(distance, rel=1e-9)  # nothing leaks
        of_point = [n for n in range(len(walls)) if np.allclose(found[n], place - at, rtol=0.0, atol=1e-12)]
        assert len(of_point) <= 1
        assert not of_point or away[of_point[0]] == pytest.approx(distance, rel=1e-9)  # nor does it push beside a nearer line


def hopper_of_lines(cells=3):
    """Two inclined lines in a box, a slit between them, and a base and a post below."""
    width, low = 0.155, 0.05
    return (
        line("left slope", (0.0, 0.1), (0.05, low), cells), line("right slope", (width, 0.1), (0.105, low), cells),
        line("base", (-0.2, -0.05), (0.4, -0.05), cells), line("post", (0.0775, 0.02), (0.0775, 0.07), cells),
    )  # fmt: skip


def held(**changes):
    """Some discs that fall into a hopper of lines whose slit is narrower than they are, over a closed floor."""
    random = np.random.default_rng(2)
    x, y = (np.mgrid[0:6, 0:9] * 2.3 + 1.2).reshape(2, -1) * RADIUS + random.uniform(0.0, 0.2 * RADIUS, (2, 54))
    walls = (*PlaneSilo(0.155, 0.4).walls(3), *hopper_of_lines())
    clear = np.ones(54, bool)
    shape = shape_of(walls)
    for number in range(len(walls)):
        clear &= np.hypot(*all_from_wall(shape, number, np.c_[x, y]).T) > RADIUS
    return silo(x=x[clear], y=y[clear], radius=RADIUS, walls=walls, **changes)


def test_lines_and_floor_carry_the_weight():
    engine = Engine(held())
    engine.step_to(60000)
    forces = felt(engine, 200)
    assert sum(forces.values()) == pytest.approx([0.0, engine.model.mass.sum() * GRAVITY], rel=1e-5, abs=1e-2)
    for name in ("left slope", "right slope_back", "floor"):
        assert forces[name][1] > 0.05 * engine.model.mass.sum() * GRAVITY
    assert not forces["base"].any()


def test_the_bound_counts_contacts_with_lines():
    """A disc in a crevice of lines has a stiffer frame than on one."""
    alone = free([0.0], [RADIUS], walls=(line("flat", (-1.0, 0.0), (1.0, 0.0)),))
    lines = (*alone.walls, *(line(f"{x}", (x, -1.0), (x, 1.0)) for x in (-RADIUS, RADIUS)))
    assert longest_step(free([0.0], [RADIUS], walls=lines)) < 0.9 * longest_step(alone)


def stepped(model, **how):
    engine = Engine(model, **how)
    engine.step_to(8000)
    return rows(engine), engine.record.window.copy()


@pytest.mark.parametrize("how", [{"skin": 0.0005}, {"skin": 0.015}, {"threads": 2}, "chunks", "restart"])
def test_the_same_bits_beside_lines(how):
    reference = stepped(held())
    if how in ("chunks", "restart"):
        engine = Engine(held())
        for step in range(0, 3001, 37):
            engine.step_to(step)
        if how == "restart":
            saved, engine = checkpoint(engine), Engine(held(), threads=2)
            restore(engine, saved)
        engine.step_to(8000)
        found = rows(engine), engine.record.window
    else:
        found = stepped(held(), **how)
    assert reference[1][engine_cells(held()), 0, 2].max() > 0.0
    assert all(np.array_equal(one, other) for one, other in zip(found, reference, strict=True))


def engine_cells(model):
    """Cells of the lines."""
    first = model.space.walls_of(model.walls).cells[-4, 0]
    return slice(first, None)


def test_python_twin_over_a_joint():
    walls = chain((-0.1, -0.05), (0.0, 0.0), (0.1, -0.02))
    model = free([-0.005, 0.004], [1.02 * RADIUS, 3.05 * RADIUS], gravity=WEIGHT, walls=walls, dt=2.5e-5, watched=True)
    compiled, plain = Engine(model), Engine(model)
    plain._kernel = plain._kernel.py_func
    for engine in (compiled, plain):
        engine.step_to(300)
    assert np.array_equal(rows(compiled), rows(plain))
    assert np.array_equal(compiled.record.window, plain.record.window)
