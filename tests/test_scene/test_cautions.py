"""Cautions on grains: `check` notes frictions beyond what is known and cells too narrow for their test, and refuses none."""

from math import pi
from pathlib import Path

import pytest
import xarray as xr
import yaml

from silostudy.__main__ import main
from silostudy.compute.dem import scene_model
from silostudy.config.load import read_yaml
from silostudy.contact import SPHERE_LAWS
from silostudy.contact.family import Touch
from silostudy.dem.contacts import Contact
from silostudy.dem.explosion import Explosion
from silostudy.dem.pieces import Laws
from silostudy.scene.cautions import HIGH_FRICTION, late_events, opened_again, unit_slips
from silostudy.scene.clinging import pulled_in
from silostudy.scene.idle import untaken
from silostudy.scene.notes import notes as all_notes
from silostudy.scene.scenes import scene_in
from silostudy.tables.materials import PAIRS
from tests.conftest import ROOT
from tests.test_dem.small import scene_of as discs_of
from tests.test_scene.test_springs import SLIDER
from tests.test_spheres.small import content as bin_of_spheres
from tests.test_spheres.small import scene_of as spheres_of

GATE = {"kind": "disc", "name": "gate", "radius_m": 0.01, "height_m": 0.06}


def at(when, value, do="stop"):
    return {"when": when, "value": value, "do": do}


def notes(path, content, capsys):
    """Notes of `check` on a content saved there."""
    path.write_text(yaml.safe_dump(content, sort_keys=False))
    assert main(["check", str(path)]) == 0
    return [line.strip() for line in capsys.readouterr().out.split("\n") if line.strip().startswith("note: ")]


def test_no_row_of_the_tables_is_noted():
    assert max(pair.sliding_friction for pair in PAIRS.values()) < HIGH_FRICTION


@pytest.mark.parametrize(("friction", "told"), [(50.0, ["walls.sliding_friction = 50"]), (1.2, [])])
def test_a_scene_s_high_friction_is_noted(friction, told, tmp_path, capsys):
    content = read_yaml(ROOT / "config/scenes/kiyama-17-18.yaml")
    content["walls"] = content["discs"] | {"sliding_friction": friction}
    found = notes(tmp_path / "scene.yaml", content, capsys)
    assert [note.removeprefix("note: ").split(" is")[0] for note in found] == told


def test_a_study_s_high_friction_is_noted_once(tmp_path, capsys):
    content = read_yaml(ROOT / "config/studies/hopper-of-discs.yaml") | {"codes": None, "outputs": []}
    content["scene"]["walls"]["sliding_friction"] = 50.0
    found = notes(tmp_path / "study.yaml", content, capsys)
    assert found == ["note: scene.walls.sliding_friction = 50 is unusual: grains and walls mostly have less than 1.5"]


@pytest.mark.parametrize(
    ("cells", "height", "count"), [([64, 96], 16, 0), ([63, 96], 8, 1), ([64, 96], 20, 1), ([40, 60], 20, 2)]
)
def test_a_plane_cell_too_narrow_is_noted(cells, height, count, tmp_path, capsys):
    content = read_yaml(ROOT / "config/studies/discs-laboratory.yaml") | {"cells": cells}
    content["scene"]["height_grains"] = height
    found = notes(tmp_path / "study.yaml", content, capsys)
    assert len(found) == count
    for cell, note in zip(cells, found, strict=False):
        assert note.startswith(f"note: a cell of {cell} grains by {height}: narrower than 64 grains or 4 heights")


@pytest.mark.parametrize(
    ("events", "told"),
    [
        (
            [at("time", 0.5, "open_slit"), at("time", 0.1)],
            ["events.1 is told for 0.1 s, and waits for the one before it, at 0.5 s"],
        ),
        ([at("time", 0.5, "open_slit"), at("time", 0.5)], []),
        (
            [at("time", 0.5, "open_slit"), at("after", 9.0)],
            ["events.1 comes at 9.5 s or later: the run ends before, at march.limit_s"],
        ),
        ([at("time", 3.0, "open_slit"), at("after", 1.0)], []),
    ],
)
def test_events_out_of_order_or_beyond_the_limit_are_noted(events, told, tmp_path, capsys):
    content = read_yaml(ROOT / "config/scenes/kiyama-17-18.yaml")
    assert content["march"]["limit_s"] == 4.0
    found = notes(tmp_path / "scene.yaml", content | {"events": events}, capsys)
    assert [note.removeprefix("note: ")[: len(words)] for note, words in zip(found, told, strict=True)] == told


@pytest.mark.parametrize("path", sorted((ROOT / "config/scenes").rglob("*.yaml")), ids=lambda path: path.stem)
def test_no_shipped_scene_says_what_cannot_come_as_told(path):
    scene = scene_in(path)
    assert [*late_events(scene), *opened_again(scene), *untaken(scene), *unit_slips(scene)] == []


STONES = {"radius_m": 2.0, "density_kg_m3": 2650, "mass_share": 0.2}


@pytest.mark.parametrize(
    ("scene_of", "changes", "told"),
    [
        (
            spheres_of,
            {"sizes__diameter_mm": 0.004},
            "sizes.diameter_mm = 0.004 looks like a unit slip: grains have 0.01 to 2000",
        ),
        (spheres_of, {"grain__youngs_modulus_MPa": 1e7}, "grain.youngs_modulus_MPa = 1e+07 looks like a unit slip"),
        (spheres_of, {"wall__youngs_modulus_MPa": 2e11}, "wall.youngs_modulus_MPa = 2e+11 looks like a unit slip"),
        (spheres_of, {"grain__density_kg_m3": 1.2}, "grain.density_kg_m3 = 1.2 looks like a unit slip"),
        (
            spheres_of,
            {"sizes": {"kind": "sieve", "openings_mm": [0.004, 8.0], "passing": [0.0, 1.0]}},
            "sizes.openings_mm = 0.004 looks like a unit slip",
        ),
        (discs_of, {"density_kg_m3": 2.65}, "density_kg_m3 = 2.65 looks like a unit slip: grains have 20 to 23000"),
        (discs_of, {"radius_m": 10.0}, "radius_m = 10 looks like a unit slip"),
        (discs_of, {"other_grains": {"stones": STONES}}, "other_grains.stones.radius_m = 2 looks like a unit slip"),
    ],
)
def test_a_value_that_no_grain_has_is_warned_of(scene_of, changes, told):
    (slip,) = unit_slips(scene_of(**changes))
    assert slip.startswith(told)


def test_a_study_s_slip_is_warned_of_once(tmp_path, capsys):
    content = read_yaml(ROOT / "config/studies/hopper-of-discs.yaml") | {"codes": None, "outputs": []}
    content["scene"]["density_kg_m3"] = 1.35
    path = tmp_path / "study.yaml"
    path.write_text(yaml.safe_dump(content, sort_keys=False))
    assert main(["check", str(path)]) == 0
    assert capsys.readouterr().out.count("warning: scene.density_kg_m3 = 1.35 looks like a unit slip") == 1


TWO = [{"name": "a", "width_m": 0.05, "middle_m": 0.05}, {"name": "b", "width_m": 0.05, "middle_m": 0.12}]
SLOWLY = {"when": "time", "value": 0.1, "do": "open_slit", "outlets": ["a"], "speed_m_s": 0.1}  # for half a second
AGAIN = "events.1 opens outlet a again, which may grow until then: what is left of it "


@pytest.mark.parametrize(
    ("second", "told"),
    [
        ({"when": "after", "value": 0.4, "do": "open_slit", "speed_m_s": 0.2}, [AGAIN + "goes on at 0.2 m/s"]),
        ({"when": "time", "value": 0.5, "do": "open_slit"}, [AGAIN + "opens at once"]),
        ({"when": "rest", "do": "open_slit"}, [AGAIN + "opens at once"]),
        ({"when": "after", "value": 0.5, "do": "open_slit", "speed_m_s": 0.2}, []),
        ({"when": "time", "value": 0.6, "do": "open_slit"}, []),
        ({"when": "rest", "do": "open_slit", "outlets": ["b"]}, []),
    ],
)
def test_an_outlet_that_grows_and_is_opened_again_is_noted(second, told):
    events = [SLOWLY, second, {"when": "after", "value": 0.1, "do": "stop"}]
    assert list(opened_again(discs_of(silo__slit_width_m=0.0, outlets=TWO, events=events))) == told


@pytest.mark.parametrize(
    ("changes", "told"),
    [
        ({"spheres__rolling_friction": 0.1}, "spheres.rolling_friction = 0.1: no chosen law takes it: rolling is none"),
        ({"walls__twisting_friction": 0.1}, "walls.twisting_friction = 0.1: no chosen law takes it: twisting is none"),
        (
            {"spheres__work_of_adhesion_J_m2": 0.1},
            "spheres.work_of_adhesion_J_m2 = 0.1: no chosen law takes it: cohesion is none",
        ),
        (
            {"spheres__rolling": "spring-dashpot-slider", "spheres__rolling_friction": 0.1},
            "spheres: rolling = spring-dashpot-slider with rolling_stiffness 0, rolling_damping 0: it resists nothing",
        ),
        (
            {"spheres__twisting": "spring-dashpot-slider", "spheres__twisting_friction": 0.1},
            "spheres: twisting = spring-dashpot-slider with twisting_stiffness 0, twisting_damping 0: it resists nothing",
        ),
        ({"walls__rolling": "constant-torque"}, "walls: rolling = constant-torque with rolling_friction 0: it resists nothing"),
        ({"spheres__cohesion": "constant-pull"}, "spheres: cohesion = constant-pull with pull 0: it pulls nothing"),
        ({"pairs": [{"between": ["grain", "grain"]}]}, "pairs.0 says nothing: all is as elsewhere"),
        ({"surfaces": {"wall": {}}}, "surfaces.wall says nothing: all is as elsewhere"),
        (
            {"pairs": [{"between": ["grain", "wall"], "rolling_friction": 0.2}]},
            "pairs.0.rolling_friction = 0.2: no chosen law takes it: rolling is none",
        ),
        (
            {"record": {"wall_force_window_s": 1e-9}, "march": {"limit_s": 1.0, "step_s": 1e-6}},
            "record.wall_force_window_s = 1e-09 is shorter than a step of 1e-06 s: every step is recorded, 1,000,000 of them",
        ),
        (
            {"record": {"fields": {"cells": [3, 4], "every_s": 1e-9}}, "march": {"limit_s": 1.0, "step_s": 1e-6}},
            "record.fields.every_s = 1e-09 is shorter than a step",
        ),
        (
            {"spheres__cohesion": "jkr", "spheres__work_of_adhesion_J_m2": 1e6},
            "spheres: jkr alone presses them more than the radius into each other",
        ),
        ({"grain__softened_modulus_MPa": 0.001}, "overlap at the foot of "),
        ({"spheres__rolling": "constant-torque", "spheres__rolling_friction": 0.1}, ""),
        ({"spheres__cohesion": "jkr", "spheres__work_of_adhesion_J_m2": 0.1}, ""),
        (SLIDER | {"spheres__rolling_damping_N_m_s": 1e-3}, "spheres: rolling_damping 0.001 N m s: without it steps could be "),
        (SLIDER | {"spheres__rolling_damping_N_m_s": 1e-6}, ""),
        (
            {"events": [at("time", 0.1, "open_outlet") | {"speed_m_s": 1e-12}, at("after", 0.1)]},
            "events.0.speed_m_s = 1e-12: 0.04 m take 4e+10 s, and the run ends at march.limit_s = ",
        ),
        (
            {"lid": True, "events": [{"when": "lid_rests", "do": "lower_lid"}, at("after", 0.1)]},
            "events.0 waits for the lid to rest, and no event before it moves the lid",
        ),
        (
            {"inserts": [GATE], "events": [at("time", 0.1, "take_away") | {"surfaces": ["gate"]}] * 2 + [at("after", 0.1)]},
            "events.1 takes gate away, which events.0 has done",
        ),
    ],
)
def test_what_does_nothing_or_cannot_be_meant_is_noted(changes, told, tmp_path, capsys):
    found = notes(tmp_path / "bin.yaml", bin_of_spheres(**changes), capsys)
    assert bool(found) == bool(told)
    assert all(told in note for note in found[:1])


def test_a_sweep_s_case_that_takes_no_value_is_no_reason_for_a_note(tmp_path, capsys):
    """Of a sweep over laws only what no case takes is noted."""
    content = read_yaml(ROOT / "config/studies/silo-of-spheres.yaml") | {"codes": None, "outputs": []}
    content["scene"]["spheres"]["rolling_friction"] = 0.1
    idle = "note: scene.spheres.rolling_friction = 0.1: no chosen law takes it: rolling is none"
    assert notes(tmp_path / "silo.yaml", content, capsys) == [idle]
    laws = [{"title": key, "spheres.rolling": key} for key in ("none", "constant-torque")]
    assert notes(tmp_path / "silo.yaml", content | {"sweep": [{"axis": "law", "points": laws}]}, capsys) == []


@pytest.mark.parametrize(("first", "count"), [("open_outlet", 0), ("set_gravity", 1)])
def test_a_share_discharged_before_anything_is_let_out_is_noted(first, count, tmp_path, capsys):
    given = {"gravity_m_s2": [0.0, 0.0, -9.81]} if first == "set_gravity" else {}
    events = [{"when": "time", "value": 0.05, "do": first, **given}, {"when": "discharged", "value": 0.5, "do": "stop"}]
    found = notes(tmp_path / "bin.yaml", bin_of_spheres(events=events), capsys)
    assert found == ["note: events.1 waits for a share discharged, and no event before it lets grains out"] * count


@pytest.mark.parametrize(("do", "count"), [("open_outlet", 0), ("lower_lid", 1)])
def test_a_number_expected_of_what_leaves_is_noted_where_nothing_does(do, count, tmp_path, capsys):
    asked = {"kind": "discharged-mass", "value_kg": 1.0, "tolerance_kg": 0.1, "source": "hand", "locator": "none"}
    events = [{"when": "time", "value": 0.3, "do": do}, {"when": "after", "value": 0.1, "do": "stop"}]
    found = notes(tmp_path / "bin.yaml", bin_of_spheres(events=events, expected=[asked], lid=True), capsys)
    assert found == ["note: expected.0.kind = discharged-mass: no event lets grains out"] * count


@pytest.mark.parametrize(("lid", "count"), [(False, 1), (True, 0)])
def test_gravity_that_points_up_is_noted_of_an_open_silo(lid, count, tmp_path, capsys):
    up = {"when": "time", "value": 0.3, "do": "set_gravity", "gravity_m_s2": [0.0, 0.0, 9.81]}
    content = bin_of_spheres(events=[up, {"when": "after", "value": 0.1, "do": "stop"}], lid=lid)
    told = "note: events.0.gravity_m_s2 points up: grains fall out of a silo whose top is open"
    assert notes(tmp_path / "bin.yaml", content, capsys) == [told] * count


@pytest.mark.parametrize(("filling", "count"), [({"kind": "loose", "count": 60}, 1), ({}, 0)])
def test_an_eccentric_filling_that_does_not_rain_is_warned_of(filling, count, capsys):
    aside = {"filling": filling} if filling else {"filling__width_m": 0.02, "filling__rate_1_s": 100}
    scene = spheres_of(silo__filling_eccentricity_m=0.01, **aside)
    told = "warning: silo.filling_eccentricity_m = 0.01: a filling loose begins all over the silo, without a heap"
    assert [line for line in all_notes(scene, scene_model(scene, Path())) if "eccentricity" in line] == [told] * count


@pytest.mark.parametrize("work", [0.05, 1.0, 50.0])
def test_the_overlap_of_jkr_without_load_is_that_of_its_closed_form(work):
    """At no load a^3 = 9 pi w R^2/(2 E*), and the overlap a^2/(3 R)."""
    stiff, radius = 1e8, 2e-3
    contact = Contact(
        Laws(normal=SPHERE_LAWS["normal"]["hertz"], cohesion=SPHERE_LAWS["cohesion"]["jkr"]),
        {"hertz_stiffness": 4.0 / 3.0 * stiff, "hertz_damping": 0.0, "work_of_adhesion": work},
    )
    wide = (9.0 * pi * work * radius**2 / (2.0 * stiff)) ** (1.0 / 3.0)
    found = pulled_in(contact, Touch(mass=1e-4, radius=radius, dt=1e-6), 2.0 * radius)
    assert found * 2.0 * radius == pytest.approx(wide**2 / (3.0 * radius), rel=1e-6)


def test_explain_tells_an_explosion_in_a_line(monkeypatch, tmp_path, capsys):
    def exploding(model):
        raise Explosion(29, 377, 1e-6, "its overlap is beyond half a radius", "sphere")

    monkeypatch.setattr("silostudy.accuracy.prices.price_of_step", exploding)
    path = tmp_path / "bin.yaml"
    path.write_text(yaml.safe_dump(bin_of_spheres(spheres__rolling_friction=0.1)))
    assert main(["explain", str(path)]) == 0
    told = capsys.readouterr().out
    assert "no cost is told, since a sample of these grains does not come to rest: sphere 29 ran away" in told
    assert "note: spheres.rolling_friction = 0.1: no chosen law takes it" in told


@pytest.mark.parametrize(("speed", "told"), [(0.1, ["its grain_u are left: all start at rest"]), (0.0, [])])
def test_motion_in_the_file_of_a_given_start_is_left_and_told(speed, told, tmp_path, capsys):
    columns = dict.fromkeys(("grain_x", "grain_y"), 0.0) | {"grain_z": 0.05, "grain_radius": 0.004, "grain_u": speed}
    xr.Dataset({name: ("grain", [value]) for name, value in columns.items()}).to_netcdf(tmp_path / "one.nc")
    content = bin_of_spheres(filling={"kind": "given", "file": "one.nc"}, sizes=None)
    found = notes(tmp_path / "bin.yaml", content, capsys)
    assert [note.removeprefix("note: one.nc: ")[: len(words)] for note, words in zip(found, told, strict=True)] == told


@pytest.mark.parametrize(
    ("changes", "told"),
    [
        ({"silo__slit_width_m": 0.03}, "the outlet is 1.5 of the largest diameters wide: below 5 or so discs may arch over it"),
        ({"silo__slit_width_m": 0.015}, "the outlet is 0.75 of the largest diameters wide: the largest discs do not pass it"),
        ({"silo__slit_width_m": 0.11}, None),
        (
            {"silo__slit_width_m": 0.0, "outlets": [{"name": "a", "width_m": 0.01, "middle_m": 0.05}],
             "events": [{"when": "rest", "do": "stop"}]},
            "the outlet a is 0.5 of the largest diameters wide",
        ),
    ],
)  # fmt: skip
def test_an_outlet_too_narrow_for_its_discs_is_warned_of(changes, told):
    scene = discs_of(**changes)
    warned = [line for line in all_notes(scene, scene_model(scene, ROOT)) if line.startswith("warning: ")]
    assert [line.startswith(f"warning: {told}") for line in warned] == [True] * (told is not None)
