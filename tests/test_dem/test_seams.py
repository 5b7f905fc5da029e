"""Shut outlets of a floor of discs change no bit, wherever they are, also while others open: springs go on over their seams."""

from pathlib import Path

import numpy as np
import pytest

from silostudy.compute.dem import run_of, scene_model
from silostudy.dem.engine import Engine
from silostudy.dem.snapshot import wall_contacts
from silostudy.dem.stability import longest_step
from silostudy.dem.walls import sums_by_wall
from silostudy.scene.plane_silo import PlaneSilo, Slit

from .scenes import RADIUS, contact, free
from .small import scene_of

ROLLING = {
    "record__fields": None, "record__snapshots_s": [], "march__step_s": None, "gravity_m_s2": [3.0, -9.0],
    "packing": {"kind": "loose", "count": 30, "radius_spread": 0.1},
}  # fmt: skip
SHUT = {"silo": {"width_m": 0.17, "height_m": 0.4, "wall_cells": 5}}
OUT = {"name": "out", "width_m": 0.04, "middle_m": 0.145}


def slit(name, middle, width=0.03):
    return {"name": name, "width_m": width, "middle_m": middle}


FLOORS = {
    "middle": [slit("a", 0.1)],
    "left": [slit("a", 0.05)],
    "three": [slit("c", 0.11), slit("a", 0.05), slit("b", 0.08, 0.02)],
}


def stop_at(time):
    return {"when": "time", "value": time, "do": "stop"}


def ended(outlets, *events, **changes):
    """A run of discs that roll over a floor with these outlets."""
    scene = scene_of(events=[*events, stop_at(0.3)], outlets=outlets, **ROLLING | SHUT | changes)
    run = run_of(scene, scene_model(scene, Path()))
    run.go()
    return run


def of_walls(run):
    """Springs at the floor, body after body, and windows of the forces on the other walls."""
    near = wall_contacts(run.engine)
    on_floor = np.array([wall.name.startswith("floor") for wall in run.engine.model.walls])[near.second.astype(int)]
    sides = [[sums_by_wall(run.engine.model, window)[name] for name in ("left", "right")] for window in run.recording.window]
    return near.table[on_floor][:, [0, 2, 3, 4, 5]], np.array(sides)


def check_same(run, other):
    assert np.array_equal(run.engine.labels, other.engine.labels)
    assert np.array_equal(run.engine.bodies.rows[: run.engine.n], other.engine.bodies.rows[: other.engine.n])
    for found, expected in zip(of_walls(run), of_walls(other), strict=True):
        assert expected.any()
        assert np.array_equal(found, expected)


@pytest.fixture(scope="module")
def whole():
    return ended([], record__energy=True)


@pytest.mark.parametrize("floor", FLOORS)
def test_discs_roll_over_shut_outlets_as_over_a_whole_floor(floor, whole):
    run = ended(FLOORS[floor], record__energy=True)
    check_same(run, whole)
    assert np.array_equal(run.recording.energy, whole.recording.energy)


ROLL = {"rolling": "spring-dashpot-slider", "rolling_friction": 0.1}


@pytest.mark.long
@pytest.mark.parametrize("laws", [
    {f"{touch}__{key}": value for touch in ("discs", "walls") for key, value in ROLL.items()},
    {"surfaces": {"left": {"sliding_friction": 0.1}}},
    {"march__step": "follow"},
])  # fmt: skip
def test_so_they_do_with_other_springs_frictions_and_steps(laws):
    whole, *others = (ended(outlets, **laws) for outlets in ([], *FLOORS.values()))
    for run in others:
        check_same(run, whole)
        assert run.recording.steps == whole.recording.steps


@pytest.mark.long
@pytest.mark.parametrize("speed", [None, 0.5])
def test_an_outlet_opens_as_if_those_that_stay_shut_were_not_there(speed):
    opens = {"when": "time", "value": 0.1, "do": "open_slit", "outlets": ["out"], "speed_m_s": speed}
    alone = ended([OUT], opens)
    assert alone.dropped > 0.0
    for others in ([slit("a", 0.1)], [slit("b", 0.08), slit("a", 0.05, 0.02)]):
        run = ended([*others, OUT], opens)
        check_same(run, alone)
        assert run.dropped == alone.dropped


@pytest.mark.long
@pytest.mark.parametrize("skin", [0.0005, 0.015])
def test_any_skin(skin):
    scene = scene_of(events=[stop_at(0.3)], **ROLLING | SHUT, outlets=FLOORS["three"])
    model = scene_model(scene, Path())
    one, other = Engine(model), Engine(model, skin=skin)
    for engine in (one, other):
        engine.step_to(round(0.3 / model.dt))
    assert np.array_equal(one.bodies.rows[: one.n], other.bodies.rows[: other.n])


def test_a_disc_on_a_seam_is_pushed_once():
    """Also where its middle stands on the seam to the bit, and by the bound of the step."""
    slits = tuple(Slit(str(n), middle, 0.01) for n, middle in enumerate((0.03, 0.1 / 3, 0.7 * 0.1)))[1:]
    for x in (slits[0].middle, slits[1].middle, np.nextafter(slits[1].middle, 0.0), np.nextafter(slits[1].middle, 1.0)):
        parted, whole = (
            free([x], [0.999 * RADIUS], walls=silo.walls(), wall_contact=contact(2.0, 0.5), dt=1e-5)
            for silo in (PlaneSilo(0.1, 0.2, slits=slits), PlaneSilo(0.1, 0.2))
        )
        assert longest_step(parted) == longest_step(whole)


def test_discs_of_these_tests_come_over_seams_in_touch():
    """What they would tell of without: rolling discs are on the floor on both sides of each middle."""
    scene, crossed = scene_of(events=[stop_at(0.3)], **ROLLING | SHUT), set()
    run, middles = run_of(scene, scene_model(scene, Path())), (0.05, 0.08, 0.1, 0.11)
    before = np.full(30, np.nan)
    while not run.done:
        run.go(until=run.engine.step + 200)
        near, now = wall_contacts(run.engine), np.full(30, np.nan)
        low = near.first[near.second == run.engine.model.wall_number("floor")].astype(int)
        now[low] = run.engine.places[low, 0]
        crossed |= {middle for middle in middles if ((before - middle) * (now - middle) < 0.0).any()}
        before = now
    assert crossed == set(middles)
