"""Slits of a floor by names: shut they are floor, open they are holes of their own, each with its meter."""

import numpy as np
import pytest

from silostudy.compute.dem import run_of, scene_model
from silostudy.compute.dem_cube import cube_of
from silostudy.dem.change import open_holes
from silostudy.dem.checkpoint import checkpoint, restore
from silostudy.dem.engine import Engine
from silostudy.dem.joints import REACH
from silostudy.dem.model import Wall
from silostudy.dem.walls import nearest, shape_of, square_apart, widen
from silostudy.errors import BadInput
from silostudy.scene.plane_silo import PlaneSilo, Slit
from silostudy.tables import kiyama_1983 as kiyama
from silostudy.tables.constants import ROUNDED_GRAVITY as GRAVITY
from tests.conftest import ROOT

from .scenes import RADIUS, contact, free, rows, silo
from .small import SMALL, carried, scene_of

WEIGHT = (0.0, -GRAVITY)
SLITS = (Slit("one", 0.04, 0.03), Slit("two", 0.12, 0.05))
TWO = [{"name": "one", "width_m": 0.03, "middle_m": 0.04}, {"name": "two", "width_m": 0.05, "middle_m": 0.12}]
BOX = {**SMALL["silo"], "slit_width_m": 0.0}


def floor_of(opened=(), share=1.0):
    """Rows of the parts of a floor, some of whose slits are open by a share."""
    walls = [wall for wall in PlaneSilo(0.17, 0.4, slits=SLITS).walls(4) if wall.name.startswith("floor")]
    shape = shape_of(walls)
    for row, wall in zip(shape, walls, strict=True):
        wall.opened(row, opened, 0.0 if share == 1.0 else 1.0)
    if share < 1.0:
        for number in range(len(walls)):
            widen(shape, number, 2.0 * share * 0.05 / 2.0)
    return walls, shape


@pytest.mark.parametrize(("opened", "share", "gaps"), [
    ((), 1.0, []), (("one",), 1.0, [(0.025, 0.055)]), (("one", "two"), 1.0, [(0.025, 0.055), (0.095, 0.145)]),
    (("two",), 0.5, [(0.1075, 0.1325)]),
])  # fmt: skip
def test_what_stands_pushes_once(opened, share, gaps):
    """Every place has one push from the floor's nearest point, or two across a gap: from its edges."""
    _, shape = floor_of(opened, share)
    for x in np.linspace(-0.01, 0.18, 200):
        found = [away for n in range(3) if abs((away := np.array(nearest(shape, n, x, 0.008)[:2]))[0]) < 1.0]
        gap = next(((a, b) for a, b in gaps if a < x < b), None)
        near = [np.hypot(*away) for away in found if np.hypot(*away) < 0.0085]
        if gap is None:
            assert np.isclose(near, 0.008).sum() == (1 if 0.0 <= x <= 0.17 else 0)
        else:
            expected = sorted(np.hypot(x - edge, 0.008) for edge in gap)
            assert sorted(np.hypot(*away) for away in found)[:2] == pytest.approx(expected, rel=1e-9)
        assert min(square_apart(shape, n, x, 0.008) for n in range(3)) <= min(map(np.hypot, *np.array(found).T)) ** 2 + 1e-12


def test_opening_slowly_ends_where_opening_at_once_does():
    _, at_once = floor_of(("one", "two"))
    walls, shape = floor_of()
    for row, wall in zip(shape, walls, strict=True):
        wall.opened(row, ("one", "two"), 0.1)
    for step in range(1, 601):
        for number in range(3):
            assert not widen(shape, number, 1e-3)
        if step == 100:
            assert shape[0, REACH + 1] == pytest.approx(0.04 - 0.05 * 0.1)
    np.testing.assert_allclose(shape, at_once, rtol=0.0, atol=1e-13)


@pytest.mark.parametrize(("speed", "friction"), [(0.4, 0.0), (0.6, 0.3)])
def test_a_disc_goes_over_a_shut_slit_as_over_a_floor(speed, friction):
    how = {"u": [speed], "gravity": WEIGHT, "dt": 1e-5, "wall_contact": contact(2.0, friction)}
    slits = PlaneSilo(0.17, 0.4, slits=SLITS).walls()
    parted, whole = (Engine(free([0.02], [RADIUS], walls=walls, **how)) for walls in (slits, PlaneSilo(0.17, 0.4).walls()))
    for step in range(0, 30001, 500):
        for engine in (parted, whole):
            engine.step_to(step)
        assert np.array_equal(rows(parted), rows(whole))
    assert rows(whole)[0, 0] > 0.13


def test_one_of_two_slits_opens_and_is_metered():
    events = [
        {"when": "time", "value": 0.05, "do": "open_slit", "outlets": ["two"]},
        {"when": "after", "value": 0.25, "do": "stop"},
    ]
    scene = scene_of(silo=BOX, outlets=TWO, events=events)
    run = carried(scene)
    cube = cube_of(run, scene)
    assert run.dropped > 0.0
    assert cube["outlet"].to_numpy().tolist() == ["one", "two"]
    through = cube["outlet_outflow_mass"].to_numpy()
    assert not through[:, 0].any()
    np.testing.assert_allclose(through[:, 1], cube["outflow_mass"], rtol=1e-12)
    assert np.isnan(cube["outlet_opened"].to_numpy()).tolist() == [True, False]
    time, mass = cube["outflow_time"].to_numpy(), cube["outflow_mass"].to_numpy()
    assert (time[0], mass[0]) == (0.0, 0.0)
    rate = (mass[-1] - mass[1]) / (time[-1] - time[1])
    np.testing.assert_allclose(cube["outlet_mean_outflow"], [np.nan, rate], rtol=1e-12)
    assert cube.attrs["mean_outflow_kg_m_s"] == pytest.approx(rate)
    assert cube["surface"].to_numpy().tolist() == ["floor_1", "floor_2", "floor_3", "left", "right"]


def test_where_nothing_has_left_the_meter_stands_at_none():
    scene = scene_of(silo=BOX, outlets=TWO, events=[{"when": "time", "value": 0.01, "do": "stop"}])
    cube = cube_of(carried(scene), scene)
    assert cube["outflow_mass"].to_numpy().tolist() == [0.0]
    assert cube["outlet_outflow_mass"].to_numpy().tolist() == [[0.0, 0.0]]
    scene = scene_of(silo=BOX, events=[{"when": "time", "value": 0.01, "do": "stop"}])
    assert "outflow_mass" not in cube_of(carried(scene), scene)


WRONG = {
    "off the floor": (
        {"outlets": [{"name": "a", "width_m": 0.1, "middle_m": 0.03}]},
        "outlets.0.middle_m = 0.03: must leave",
    ),
    "overlap": ({"outlets": [*TWO, {"name": "a", "width_m": 0.02, "middle_m": 0.06}]}, "one, a.*must not overlap"),
    "one name": ({"outlets": [TWO[0], {**TWO[1], "name": "one"}]}, "each outlet needs a name of its own"),
    "beside a slit": ({"outlets": TWO, "silo": SMALL["silo"]}, "outlets.*: are of a flat floor without a silo.slit_width_m"),
    "unknown": ({"outlets": TWO, "do": {"outlets": ["three"]}}, "events.0.outlets.0 = 'three': unknown; known: one, two"),
    "a speed of a slit": ({"silo": SMALL["silo"], "do": {"speed_m_s": 0.1}}, "names and speeds are of outlets"),
    "none": ({}, "needs a silo.slit_width_m above 0, or outlets"),
}


@pytest.mark.parametrize("case", WRONG)
def test_bad_slits(case):
    changes, told = WRONG[case]
    do = {"when": "time", "value": 0.05, "do": "open_slit", **changes.get("do", {})}
    changes = {"silo": BOX, **{key: value for key, value in changes.items() if key != "do"}}
    with pytest.raises(BadInput, match=told):
        scene_model(scene_of(events=[do, {"when": "after", "value": 0.1, "do": "stop"}], **changes), ROOT)


def stepped(how):
    """A silo whose slits open one after the other, the second at a speed."""
    model = silo(walls=PlaneSilo(kiyama.width_as_steep(8), 0.4, slits=SLITS).walls(4), moving=True)
    engine = Engine(model, **(how if isinstance(how, dict) else {}))
    engine.step_to(1000)
    open_holes(engine, "floor", ("one",), 0.0)
    engine.step_to(1500)
    open_holes(engine, "floor", ("two",), 0.5)
    if how == "restart":
        engine.step_to(2111)
        saved, engine = checkpoint(engine), Engine(model, threads=2)
        restore(engine, saved)
    for step in range(2500, 6001, 500 if isinstance(how, dict) else 50):
        engine.step_to(step)
    return rows(engine), engine.record.window, engine.walls.shape


@pytest.mark.long
@pytest.mark.parametrize("how", [{"skin": 0.0005}, {"skin": 0.015}, {"threads": 2}, "chunks", "restart"])
def test_the_same_bits_while_slits_open(how):
    reference = stepped({})
    assert (reference[0][:, 1] < -RADIUS).any()
    assert all(np.array_equal(one, other) for one, other in zip(stepped(how), reference, strict=True))


@pytest.mark.long
def test_a_slit_opens_at_a_speed_in_a_scene():
    slowly = {"when": "time", "value": 0.05, "do": "open_slit", "speed_m_s": 0.2}
    scene = scene_of(silo=BOX, outlets=TWO, events=[slowly, {"when": "after", "value": 0.3, "do": "stop"}])
    run = run_of(scene, scene_model(scene, ROOT))
    run.go(until=round(0.1 / run.engine.model.dt))
    shape = run.engine.walls.shape
    assert shape[1, REACH] - shape[0, REACH + 1] == pytest.approx(0.2 * 0.05, rel=1e-2)
    run.go()
    shape = run.engine.walls.shape
    assert shape[1, REACH] - shape[0, REACH + 1] == pytest.approx(0.03, rel=1e-12)
    assert run.dropped > 0.0
    assert isinstance(run.engine.model.walls[0], Wall)
