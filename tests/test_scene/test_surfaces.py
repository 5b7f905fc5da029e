"""Surfaces that a scene tells from the other walls: whose coefficients they have, and what is refused."""

import copy

import numpy as np
import pytest

from silostudy.config.dem import DemScene
from silostudy.config.load import validated
from silostudy.contact import elastic
from silostudy.dem.varied import Varied
from silostudy.errors import BadInput
from silostudy.scene.coefficients import coefficient_lines
from silostudy.scene.dem import contacts_of as contacts_of_discs
from silostudy.scene.dem import events_of, wall_names
from silostudy.scene.dem_model import placed, unshaken_scene_model
from silostudy.scene.sphere_events import sphere_events
from silostudy.scene.spheres import contacts_of, space_silo_of
from silostudy.scene.surfaces import by_surface
from tests.test_spheres.small import scene_of

DISCS = {
    "kind": "dem", "title": "a slit", "silo": {"width_m": 0.4, "height_m": 0.6, "slit_width_m": 0.08},
    "packing": {"kind": "rows", "across": 18, "fill_height_m": 0.1, "gap_m": 4e-5}, "radius_m": 0.01, "density_kg_m3": 2650,
    "discs": {"normal_stiffness_N_m2": 1e7, "damping_ratio": 0.3, "sliding_friction": 0.5},
    "walls": {"normal_stiffness_N_m2": 2e7, "damping_ratio": 0.3, "sliding_friction": 0.2},
    "march": {"limit_s": 1.0}, "events": [{"when": "time", "value": 0.5, "do": "stop"}],
}  # fmt: skip
STOP = {"when": "time", "value": 0.5, "do": "stop"}


def discs(**changes) -> DemScene:
    return validated(DemScene, copy.deepcopy(DISCS) | changes, "slit.yaml")


def pulling(**changes):
    """The small bin of spheres with dashpots that follow from the restitution by a formula."""
    return scene_of(spheres__normal="hertz-tension", walls__normal="hertz-tension", **changes)


def at_discs_walls(scene: DemScene) -> dict:
    _, walls = contacts_of_discs(scene, np.array([0.01]))
    names = wall_names(scene)
    return {name: walls.numbered(number).coefficients for number, name in enumerate(names)} | {"": walls}


def test_a_scene_that_does_not_ask_has_one_set_of_coefficients():
    assert not isinstance(at_discs_walls(discs())[""], Varied)
    assert not isinstance(contacts_of(pulling())[1], Varied)


def test_discs_have_what_a_surface_says_and_else_what_walls_say():
    found = at_discs_walls(discs(surfaces={"floor": {"sliding_friction": 0.4}, "floor_left": {"normal_stiffness_N_m2": 5e7}}))
    assert [found[name]["sliding_friction"] for name in ("floor", "floor_right", "floor_left", "left")] == [0.4, 0.4, 0.2, 0.2]
    assert found["floor_left"]["normal_stiffness"] == 5e7  # what it does not say is the walls', not the whole floor's
    assert found["floor_left"]["normal_damping"] == pytest.approx(found["left"]["normal_damping"] * 2.5**0.5)


def test_a_field_that_stands_for_others_drops_those_of_the_walls():
    found = at_discs_walls(discs(surfaces={"left": {"restitution": 0.5}}))
    assert found["left"]["normal_damping"] == 0.0
    assert found["left"]["normal_damping_root"] > 0.0
    assert found["right"]["normal_damping"] > 0.0


def test_friction_at_one_surface_keeps_the_law_that_smooth_walls_leave_out():
    smooth = {"normal_stiffness_N_m2": 2e7, "damping_ratio": 0.3, "sliding_friction": 0.0}
    assert not at_discs_walls(discs(walls=smooth))[""].laws.tangential.acts
    found = at_discs_walls(discs(walls=smooth, surfaces={"floor": {"sliding_friction": 0.4}}))
    assert found[""].laws.tangential.acts
    assert found["left"]["sliding_friction"] == 0.0


def test_the_modulus_of_a_surface_enters_its_pair():
    scene = pulling(surfaces={"hopper": {"youngs_modulus_MPa": 7.0, "restitution": 0.6}})
    floor, hopper, wall = contacts_of(scene)[1].sets
    assert hopper.coefficients["hertz_stiffness"] == pytest.approx(4 / 3 * elastic.contact_modulus(5e6, 0.25, 7e6, 0.25))
    assert hopper.coefficients["mindlin_stiffness"] == pytest.approx(8 * elastic.contact_shear_modulus(5e6, 0.25, 7e6, 0.25))
    assert hopper.coefficients["sliding_friction"] == wall.coefficients["sliding_friction"]
    assert floor == wall


def test_a_material_of_the_table_is_whole():
    """Its Poisson's ratio is not that of the wall that it stands in for."""
    scene = pulling(surfaces={"floor": {"material": "dosta-steel"}}, wall__poissons_ratio=0.4)
    floor, _, wall = contacts_of(scene)[1].sets
    assert floor.coefficients["hertz_stiffness"] == pytest.approx(4 / 3 * elastic.contact_modulus(5e6, 0.25, 210e9, 0.2))
    assert wall.coefficients["hertz_stiffness"] == pytest.approx(4 / 3 * elastic.contact_modulus(5e6, 0.25, 1e8, 0.4))


def test_the_step_is_that_of_the_stiffest_surface():
    stiff = DISCS["walls"] | {"normal_stiffness_N_m2": 1e9}
    plain, one, every = (
        unshaken_scene_model(scene, placed(scene)).dt
        for scene in (discs(), discs(surfaces={"floor_left": {"normal_stiffness_N_m2": 1e9}}), discs(walls=stiff))
    )
    assert every <= one < 0.5 * plain


def test_lines_say_which_walls_have_which_coefficients():
    scene = discs(surfaces={"left": {"sliding_friction": 0.1}})
    lines = coefficient_lines(unshaken_scene_model(scene, placed(scene)))
    assert [line.partition(":")[0] for line in lines] == ["discs", "floor, floor_left, floor_right, right", "left"]
    assert lines[2].endswith("sliding_friction 0.1")


def test_a_name_of_its_own_goes_before_that_of_the_whole():
    names = ["floor", "wall_1", "wall_2", "wall_10"]
    assert by_surface({"wall_1": "b", "wall": "a"}, names, "c") == ["c", "b", "a", "a"]


@pytest.mark.parametrize(
    ("surfaces", "message"),
    [
        (
            {"hoper": {"sliding_friction": 0.1}},
            "surfaces = 'hoper': unknown; known: floor, floor_left, .* right",
        ),
        (
            {"left": {"friction": 0.1}},
            "surfaces.left.friction = .*: unknown key; known: normal_stiffness_N_m2, .*laws",
        ),
        ({"left": {"sliding_friction": -0.1}}, "surfaces.left.sliding_friction = -0.1: must be greater than or equal to 0"),
        ({"left": {"restitution": 0.5, "damping_ratio": 0.1}}, "surfaces.left: give either .*damping_ratio or restitution"),
        ({"left": {"rolling_friction": -1.0}}, "surfaces.left.rolling_friction = .*: must be greater"),
    ],
)
def test_surfaces_that_are_none(surfaces, message):
    with pytest.raises(BadInput, match=message):
        at_discs_walls(discs(surfaces=surfaces))


def test_an_event_may_name_a_surface():
    event = {"when": "time", "value": 0.1, "do": "set_friction", "wall_friction": 0.7, "surfaces": ["floor"]}
    scene = discs(events=[event, STOP])
    assert isinstance(at_discs_walls(scene)[""], Varied)
    assert events_of(scene, 1.0)[0].what == (None, 0.7, ("floor", "floor_left", "floor_right"))
    spheres = scene_of(events=[event | {"surfaces": ["hopper"]}, STOP])
    assert sphere_events(spheres, space_silo_of(spheres), 1.0)[0].what == (None, 0.7, ("hopper",))


@pytest.mark.parametrize(
    ("changes", "message"),
    [
        ({"surfaces": ["roof"], "wall_friction": 0.7}, "events.0.surfaces = 'roof': unknown; known: floor, "),
        ({"surfaces": ["floor"], "disc_friction": 0.7}, r"events\.0\.surfaces = .*: are where a wall_friction changes"),
    ],
)
def test_events_at_surfaces_that_are_none(changes, message):
    with pytest.raises(BadInput, match=message):
        events_of(discs(events=[{"when": "time", "value": 0.1, "do": "set_friction"} | changes, STOP]), 1.0)
