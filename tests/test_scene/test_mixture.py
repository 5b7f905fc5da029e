"""Scenes of several kinds of spheres: how many there are of each, which coefficients pairs have, and what is refused."""

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
import xarray as xr

from silostudy.compute.dem import scene_model
from silostudy.compute.dem_files import given_spheres
from silostudy.contact import elastic
from silostudy.dem.varied import Varied, set_of_pair
from silostudy.errors import BadInput
from silostudy.scene.coefficients import coefficient_lines
from silostudy.scene.mixture import drawn, whole
from silostudy.scene.spheres import contacts_of
from silostudy.scene.spheres_about import shares, wave_times
from tests.test_spheres.scenes import contact, spheres
from tests.test_spheres.small import scene_of

STONES = {
    "youngs_modulus_MPa": 20, "poissons_ratio": 0.3, "density_kg_m3": 3500, "mass_share": 0.4,
    "sizes": {"kind": "uniform", "least_mm": 4, "largest_mm": 7},
}  # fmt: skip
OF_TABLE = {"material": "dosta-m2", "mass_share": 0.2, "sizes": {"kind": "equal", "diameter_mm": 6}}
BEANS = {name: value for name, value in STONES.items() if name != "mass_share"} | {"number_share": 0.25}
WIDE = {"kind": "uniform", "least_mm": 45, "largest_mm": 50}


def mixture(**changes):
    """The small bin with stones; its dashpots follow from the restitution by a formula."""
    pulling = {} if "spheres" in changes else {"spheres__normal": "hertz-tension", "walls__normal": "hertz-tension"}
    return scene_of(**({"other_grains": {"stones": STONES}} | pulling | changes))


def changed(**values):
    return {"stones": {name: value for name, value in (STONES | values).items() if value is not None}}


def test_shares_of_mass():
    scene = mixture(filling__count=4000, other_grains={"stones": STONES, "sand": OF_TABLE})
    radii, kind = drawn(scene, np.random.default_rng(4))
    mass = np.array([2500.0, 3500.0, 2000.0])[kind] * radii**3
    found = np.array([mass[kind == k].sum() for k in range(3)]) / mass.sum()
    assert found == pytest.approx([0.4, 0.4, 0.2], abs=1e-3)
    assert radii[kind == 0] == pytest.approx(4e-3)
    assert 2e-3 <= radii[kind == 1].min() < radii[kind == 1].max() <= 3.5e-3
    assert abs(np.corrcoef(kind == 1, np.arange(4000))[0, 1]) < 0.05  # they come in mixed


def test_shares_of_number():
    _, kind = drawn(mixture(filling__count=1000, other_grains={"beans": BEANS}), np.random.default_rng(4))
    assert np.bincount(kind).tolist() == [750, 250]


def test_whole_numbers_add_up():
    assert whole(np.array([1.0, 1.0, 1.0]), 100).tolist() == [34, 33, 33]
    assert whole(np.array([0.7, 0.25, 0.05]), 10).tolist() == [7, 3, 0]  # of equal remainders the first


@pytest.mark.long
def test_a_mixture_as_the_engine_has_it():
    model = scene_model(mixture(), Path())
    assert model.kinds == 2
    assert model.mass == pytest.approx(np.array([2500.0, 3500.0])[model.kind] * 4 / 3 * np.pi * model.radius**3)
    assert model.pieces.varied == (True, True)
    assert scene_model(scene_of(), Path()).pieces.varied == (False, False)


def test_every_pair_has_its_own_moduli():
    between, walls = contacts_of(mixture())
    grain, stones, wall = (5e6, 0.25), (20e6, 0.3), (100e6, 0.25)
    for (a, b), number in (((grain, grain), 0), ((grain, stones), set_of_pair(0, 1)), ((stones, stones), 2)):
        found = between.sets[number].coefficients["hertz_stiffness"]
        assert found == pytest.approx(4 / 3 * elastic.contact_modulus(*a, *b))
    for kind, of in enumerate((grain, stones)):
        found = walls.sets[3 * kind].coefficients["mindlin_stiffness"]
        assert found == pytest.approx(8 * elastic.contact_shear_modulus(*of, *wall))


def test_pairs_say_what_differs_and_else_sections_do():
    pairs = [
        {"between": ["stones", "grain"], "restitution": 0.8},
        {"between": ["hopper", "stones"], "sliding_friction": 0.05},
        {"between": ["stones", "walls"], "sliding_friction": 0.06},
    ]
    scene = mixture(pairs=pairs, surfaces={"hopper": {"sliding_friction": 0.1}})
    between, walls = contacts_of(scene)
    friction = [one.coefficients["sliding_friction"] for one in walls.sets]
    assert friction == [0.3, 0.1, 0.3, 0.06, 0.05, 0.06]  # of grain and of stones at floor, hopper and wall
    dampings = [one.coefficients["hertz_damping"] / one.coefficients["hertz_stiffness"] ** 0.5 for one in between.sets]
    assert dampings[0] == pytest.approx(dampings[2])
    assert dampings[1] == pytest.approx(elastic.damping_where_pulled(0.8))


def test_a_pair_of_one_kind_and_a_surface_leaves_other_kinds_their_pair_with_the_walls():
    pairs = [
        {"between": ["grain", "hopper"], "sliding_friction": 0.05},
        {"between": ["stones", "walls"], "sliding_friction": 0.06},
    ]
    _, walls = contacts_of(mixture(pairs=pairs))
    friction = [one.coefficients["sliding_friction"] for one in walls.sets]
    assert friction == [0.3, 0.05, 0.3, 0.06, 0.06, 0.06]  # of grain and of stones at floor, hopper and wall


def test_laws_bring_their_fields_to_pairs_and_surfaces():
    rolls = {
        "normal": "hertz-tension",
        "rolling": "spring-slider",
        "rolling_stiffness_N_m": 1e-3,
        "restitution": 0.3,
        "sliding_friction": 0.5,
    }
    scene = mixture(
        spheres=rolls | {"rolling_friction": 0.1}, walls=rolls | {"rolling_friction": 0.2},
        surfaces={"hopper": {"rolling_friction": 0.3}}, pairs=[{"between": ["grain", "stones"], "rolling_friction": 0.4}],
    )  # fmt: skip
    between, walls = contacts_of(scene)
    assert [one.coefficients["rolling_friction"] for one in between.sets] == [0.1, 0.4, 0.1]
    assert [one.coefficients["rolling_friction"] for one in walls.sets] == [0.2, 0.3, 0.2] * 2


def test_a_model_says_of_which_kind_each_sphere_is():
    model = spheres([(0.0, 0.0, 0.1), (0.0, 0.0, 0.2)])
    with pytest.raises(BadInput, match="kind = None: must be given for each sphere"):
        replace(model, pair_contact=Varied((contact(),)))
    with pytest.raises(BadInput, match="pair_contact = 1: must be 3 sets"):
        replace(model, pair_contact=Varied((contact(),)), kind=np.array([0, 1]))
    with pytest.raises(BadInput, match=r"kind = .*must be a number from 0 for each"):
        replace(model, kind=np.array([0, -1]))


def test_pairs_of_materials_of_the_table():
    """What no section says is that of the pair; a pair that no table holds must be told."""
    material, law = {"material": "dosta-m1"}, {"normal": "hertz-tension"}
    scene = scene_of(grain=material, wall={"material": "dosta-steel"}, spheres=law, walls=law)
    assert contacts_of(scene)[0].coefficients["sliding_friction"] == 0.3
    with pytest.raises(BadInput, match=r"spheres.restitution = None: must be given: no table .* M2 and .* M1"):
        contacts_of(scene_of(grain=material, wall=material, spheres=law, walls=law, other_grains={"two": OF_TABLE}))


@pytest.mark.long
def test_what_is_told_of_a_mixture():
    scene = mixture(surfaces={"hopper": {"sliding_friction": 0.1}})
    model = scene_model(scene, Path())
    names = [line.partition(":")[0] for line in coefficient_lines(model, tuple(scene.grain_kinds))]
    assert names == ["grain and grain", "grain and stones", "stones and stones", "grain at floor, wall", "grain at hopper",
                     "stones at floor, wall", "stones at hopper"]  # fmt: skip
    assert shares(scene, model)[1].startswith(f"stones: {(model.kind == 1).sum()} spheres, 40.")
    assert wave_times(scene, model).count(" s (") == 2


@pytest.mark.long
def test_the_step_is_that_of_the_stiffest_pair():
    stiff = scene_model(mixture(other_grains=changed(youngs_modulus_MPa=2000)), Path())
    assert stiff.dt < 0.5 * scene_model(mixture(), Path()).dt


@pytest.mark.parametrize(
    ("changes", "message"),
    [
        ({"other_grains": changed(sizes=None)}, "other_grains.stones.sizes: is missing"),
        ({"other_grains": changed(mass_share=None)}, "other_grains.stones: give either mass_share or number_share"),
        ({"other_grains": changed(mass_share=1.0)}, "other_grains.stones.mass_share = 1.0: must be less than 1"),
        ({"other_grains": {"stones": STONES, "beans": BEANS}}, "give the mass_share of every kind, or of none"),
        ({"other_grains": {"a": STONES, "b": STONES | {"mass_share": 0.6}}}, "mass_share adds up to 1; it must leave a rest"),
        ({"other_grains": {"grain": STONES}}, "other_grains.grain: the name is taken"),
        ({"other_grains": changed(density_kg_m3=None)}, "other_grains.stones.density_kg_m3 = None: must be given"),
        ({"other_grains": changed(softened_modulus_MPa=50)}, "other_grains.stones.softened_modulus_MPa = 50"),
        ({"other_grains": changed(mass_share=1e-6)}, "filling.count = 150: so few .* leave none to stones"),
        ({"pairs": [{"between": ["stnes", "hopper"]}]}, "pairs.0.between = .*: names no kind of grains; known: grain, stones"),
        ({"pairs": [{"between": ["stones", "hoper"]}]}, "'hoper': unknown; known: grain, stones, floor, hopper, wall"),
        ({"other_grains": {"wall": STONES}}, "other_grains = 'wall': is a kind of grains and a surface"),
        (
            {"other_grains": changed(sizes=WIDE, mass_share=None, number_share=0.3)},
            r"other_grains.stones.sizes.largest_mm = 50.0: a sphere of [\d.]+ mm does not pass the outlet",
        ),
        (
            {"pairs": [{"between": ["stones", "grain"]}, {"between": ["grain", "stones"]}]},
            "pairs.1.between = .*: the pair .* twice",
        ),
        ({"pairs": [{"between": ["stones", "grain"], "frction": 1.0}]}, "pairs.0.frction = 1.0: unknown key"),
        ({"filling": {"kind": "given", "file": "a.nc"}, "sizes": None}, "stones: sizes and shares must be left out"),
    ],
)
def test_mixtures_that_are_none(changes, message):
    with pytest.raises(BadInput, match=message):
        scene_model(mixture(**changes), Path())


@pytest.mark.long
def test_kinds_from_a_file(tmp_path):
    held = {name: ("grain", np.array([0.0, np.nan, 0.01])) for name in ("grain_x", "grain_y", "grain_z")}
    held |= {"grain_radius": ("grain", np.full(3, 0.001)), "grain_kind": ("grain", np.array([0, 0, 1]))}
    xr.Dataset(held).to_netcdf(tmp_path / "a.nc")
    xr.Dataset(held).drop_vars("grain_kind").to_netcdf(tmp_path / "b.nc")
    assert given_spheres("a.nc", tmp_path, 2)[2].tolist() == [0, 1]
    assert given_spheres("a.nc", tmp_path)[2] is None
    with pytest.raises(BadInput, match="must hold grain_kind: the scene has 2 kinds"):
        given_spheres("b.nc", tmp_path, 2)
    xr.Dataset(held | {"grain_kind": ("grain", np.array([0, 0, 2]))}).to_netcdf(tmp_path / "c.nc")
    with pytest.raises(BadInput, match="grain_kind must be from 0 to 1"):
        given_spheres("c.nc", tmp_path, 2)
