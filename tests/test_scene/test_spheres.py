"""Scenes of spheres before they run: materials, sizes, cells, step, and mistakes in one line each."""

from dataclasses import replace
from math import pi, radians, sqrt, tan

import numpy as np
import pytest
import yaml

from silostudy.__main__ import main
from silostudy.compute.dem import scene_model
from silostudy.contact import elastic
from silostudy.dem.space.cells import areas, middles
from silostudy.dem.stability import longest_step
from silostudy.errors import BadInput
from silostudy.packing.sizes import SIZES
from silostudy.pressure import hopper_shape
from silostudy.scene.silo import Hopper, Silo
from silostudy.scene.space_silo import Outlet, SpaceSilo
from silostudy.scene.spheres import contacts_of
from silostudy.scene.spheres_about import rayleigh_time, softening
from silostudy.tables.materials import MATERIALS
from tests.conftest import ROOT
from tests.test_spheres.small import content, scene_of

STOP = {"when": "rest", "do": "stop"}
SHELF = {"kind": "disc", "name": "shelf", "radius_m": 0.02, "height_m": 0.06}
PIPE = {"kind": "cylinder", "name": "pipe", "radius_m": 0.02, "heights_m": [0.06, 0.09]}
OPEN = {"when": "rest", "do": "open_outlet"}
TWO = {"silo__hopper": None,
       "outlets": [{"name": "a", "width_m": 0.02, "middle_m": [0.015, 0.0]},
                   {"name": "b", "width_m": 0.018, "length_m": 0.02, "middle_m": [-0.015, 0.0]}]}  # fmt: skip
OUTLET = Outlet(width=0.1)
CONE = Hopper(half_angle=radians(30.0), outlet_width=0.08)


@pytest.mark.long
def test_coefficients_follow_from_materials_and_their_pair():
    """Dosta's first material on steel: Hertz's modulus of both, restitution and friction of the pair."""
    scene = scene_of(grain={"material": "dosta-m1"}, wall={"material": "dosta-steel"}, spheres={}, walls={})
    between, wall = contacts_of(scene)
    e_star = 1.0 / (2.0 * (1.0 - 0.04) / 1e9), 1.0 / ((1.0 - 0.04) / 1e9 + (1.0 - 0.04) / 210e9)
    for contact, modulus, restitution, friction in ((between, e_star[0], 0.5, 0.3), (wall, e_star[1], 0.4, 0.2)):
        assert contact.coefficients["hertz_stiffness"] == pytest.approx(4.0 / 3.0 * modulus)
        assert contact.coefficients["sliding_friction"] == friction
        damping = contact.coefficients["hertz_damping"] / sqrt(4.0 / 3.0 * modulus)
        assert elastic.restitution_of_cut(damping) == pytest.approx(restitution, rel=1e-6)


@pytest.mark.long
def test_a_scene_s_own_values_replace_the_table_s():
    scene = scene_of(
        grain={"material": "dosta-m1", "youngs_modulus_MPa": 500}, spheres={"sliding_friction": 0.1, "restitution": 0.9}
    )
    between, _ = contacts_of(scene)
    assert between.coefficients["hertz_stiffness"] == pytest.approx(2.0 / 3.0 * 5e8 / 0.96)
    assert between.coefficients["sliding_friction"] == 0.1


@pytest.mark.long
def test_rolling_friction_comes_from_the_pair():
    scene = scene_of(grain={"material": "sunday-glass"}, spheres={"rolling": "constant-torque"})
    assert contacts_of(scene)[0].coefficients["rolling_friction"] == 0.09


@pytest.mark.long
def test_softening_is_told_with_its_overlap():
    """Modulus by 20: overlaps by 20^(2/3); Hertz's overlap under a column, by its own formula."""
    scene = scene_of()
    model = scene_model(scene, ROOT)
    ratio, overlap, fall = softening(scene, model)
    assert "a ratio of 20: steps 4.5 times as long, overlaps 7.37 times as deep" in ratio
    speed, mass = sqrt(1.0 + 2.0 * 9.81 * (0.1 + 0.01 / tan(radians(30.0)) - 1.05 * 0.004)), 2500 * 4.0 / 3.0 * pi * 0.004**3
    deepest = (15.0 * mass / 2.0 * speed**2 / (16.0 * 5e6 / (2.0 * 0.9375) * sqrt(0.002))) ** 0.4 / 0.004
    assert f"{deepest:.2%}" in fall
    told = float(overlap.split("m of spheres")[0].split()[-1])
    force = 0.6 * 2500 * 9.81 * told * 0.008**2
    depth = (3.0 * force / (4.0 * 5e6 / (2.0 * (1.0 - 0.25**2)) * sqrt(0.002))) ** (2.0 / 3.0) / 0.004
    assert float(overlap.split("walls: ")[1].split("%")[0]) == pytest.approx(100.0 * depth, rel=0.02)


def test_rayleigh_time_of_a_glass_bead():
    glass = MATERIALS["sunday-glass"]
    shear = 70e6 / 2.48
    assert rayleigh_time(glass, 5e-4) == pytest.approx(pi * 5e-4 * sqrt(2500 / shear) / (0.1631 * 0.24 + 0.8766))


def test_the_bound_of_spheres_that_touch_nothing():
    """Two equal spheres with springs alone: the largest of normal, tangential and rolling motion, velocity before place."""
    scene = scene_of(spheres={"restitution": 1.0, "sliding_friction": 0.5}, walls={"restitution": 1.0, "sliding_friction": 0.5},
                     march={"limit_s": 1.0, "step_s": 1e-6})  # fmt: skip
    model = scene_model(scene, ROOT)
    mass, depth = float(model.mass[0]), 0.02 * 0.004
    root = sqrt(0.002 * depth)
    c = model.pair_contact.coefficients
    pair = 2.0 * max(1.5 * c["hertz_stiffness"], 3.5 * c["mindlin_stiffness"]) * root / mass
    w, root = model.wall_contact.coefficients, sqrt(0.004 * depth)
    wall = max(1.5 * w["hertz_stiffness"], 3.5 * w["mindlin_stiffness"]) * root / mass
    assert longest_step(model) == pytest.approx(2.0 / sqrt(max(pair, wall)), rel=1e-6)


ASKED = {
    "equal": {"diameter": 5.0},
    "uniform": {"least": 3.0, "largest": 6.0},
    "normal": {"mean": 5.0, "deviation": 1.0, "least": 3.0, "largest": 8.0},
    "lognormal": {"median": 5.0, "spread": 1.3, "least": 3.0, "largest": 8.0},
    "sieve": {"openings": (2.0, 4.0, 8.0), "passing": (0.0, 0.3, 1.0)},
}


def drawn(key, count=40_000, **changes):
    return SIZES[key].draw(np.random.default_rng(1), count, **(ASKED[key] | changes))


def test_every_distribution_keeps_its_ends():
    assert set(ASKED) == set(SIZES)
    for key in ASKED:
        found = drawn(key)
        assert found.shape == (40_000,)
        ends = (2.0, 8.0) if key == "sieve" else (5.0, 5.0) if key == "equal" else (3.0, 8.0)
        assert ends[0] <= found.min() <= found.max() <= ends[1], key


def test_distributions_have_their_moments():
    wide = {"least": 1e-6, "largest": 1e6}
    assert drawn("uniform").mean() == pytest.approx(4.5, abs=0.02)
    normal, lognormal = drawn("normal", **wide), np.log(drawn("lognormal", **wide))
    assert (normal.mean(), normal.std()) == pytest.approx((5.0, 1.0), abs=0.02)
    assert (lognormal.mean(), lognormal.std()) == pytest.approx((np.log(5.0), np.log(1.3)), abs=0.01)


def test_a_sieve_curve_gives_its_shares_of_mass():
    found = drawn("sieve")
    mass = found**3
    assert mass[found <= 4.0].sum() / mass.sum() == pytest.approx(0.3, abs=0.005)


@pytest.mark.parametrize(
    ("of", "name", "area"),
    [
        (SpaceSilo(silo=Silo(plan="circular", diameter=0.2, wall_depth=0.3, hopper=CONE)), "wall", pi * 0.2 * 0.3),
        (SpaceSilo(silo=Silo(plan="circular", diameter=0.2, wall_depth=0.3, hopper=CONE)), "hopper", pi * 0.14 * 0.12),
        (SpaceSilo(silo=Silo(plan="square", diameter=0.2, wall_depth=0.3, hopper=CONE)), "hopper_1", 0.14 * 0.12),
        (SpaceSilo(silo=Silo(plan="square", diameter=0.2, wall_depth=0.3), outlets=(OUTLET,)), "floor", 0.04),
        (SpaceSilo(silo=Silo(plan="circular", diameter=0.2, wall_depth=0.3, outlet_eccentricity=0.02), outlets=(OUTLET,)),
         "floor", pi * 0.01),
        (SpaceSilo(silo=Silo(plan="polygonal", diameter=0.2, wall_depth=0.3, sides=6)), "floor", 6 * 0.01 * tan(pi / 6)),
    ],
)  # fmt: skip
def test_cells_cover_a_surface_once(of, name, area):
    (surface,) = [wall for wall in of.walls((4, 6)) if wall.name == name]
    found = areas(surface)
    assert found.shape == (24,)
    assert (found >= 0.0).all()
    assert found.sum() == pytest.approx(area, rel=1e-6)
    low, high = (end(np.array(surface.corners), axis=0) for end in (np.min, np.max))
    assert ((middles(surface) >= low - 1e-12) & (middles(surface) <= high + 1e-12)).all()


@pytest.mark.parametrize("width", [0.08, 0.0])
def test_a_rectangle_s_pyramid_is_that_of_the_codes(width):
    """Its four walls meet in one apex: the outlet is as oblong as the plan, the end walls are flatter than the long ones."""
    silo = Silo(plan="rectangular", diameter=0.2, length=0.3, wall_depth=0.3, hopper=replace(CONE, outlet_width=width))
    of = SpaceSilo(silo=silo)
    assert of.opening.area == pytest.approx(width * 1.5 * width)
    slopes = {}
    for wall in of.walls():
        if wall.name.startswith("hopper"):
            foot, *_, top, other = np.array(wall.corners)
            normal = np.cross(top - foot, other - foot)
            slopes[wall.name] = np.arcsin(abs(normal[2]) / np.linalg.norm(normal))  # half angle, from the vertical
    long, end = CONE.half_angle, hopper_shape.end_half_angle(CONE.half_angle, 1.5)
    assert slopes == pytest.approx({"hopper_1": long, "hopper_2": end, "hopper_3": long, "hopper_4": end})
    assert tan(end) == pytest.approx(1.5 * tan(long))
    assert of.volume_below(of.top) == pytest.approx(silo.volume, rel=1e-12)


def test_a_rectangle_s_wedge_keeps_its_end_walls():
    of = SpaceSilo(silo=Silo(plan="rectangular", diameter=0.2, length=0.3, wall_depth=0.3, hopper=CONE), wedge=True)
    assert of.opening.area == pytest.approx(0.08 * 0.3)
    assert of.volume_below(of.top) == pytest.approx(0.06 * 0.3 + 0.3 * 0.14 * 0.06 / tan(CONE.half_angle))


@pytest.mark.long
def test_the_example_scene_is_valid(capsys):
    assert main(["check", str(ROOT / "config/scenes/wheat-bin.yaml")]) == 0
    told = capsys.readouterr().out
    assert "7000 spheres" in told
    assert "a ratio of 100" in told


@pytest.mark.parametrize(
    ("changes", "message"),
    [
        ({"silo__hopper__outlet_width_m": 0.07}, "silo.hopper.outlet_width_m = 0.07: must be smaller than the silo's width"),
        ({"silo__hopper": None, "outlets": [{"width_m": 0.07}]}, "outlets.0.width_m = 0.07: must be above 0 and below"),
        ({"silo__hopper": None}, "events.0.do = 'open_outlet': needs an outlet"),
        (TWO | {"events": [{"when": "rest", "do": "open_outlet", "outlets": ["c"]}, STOP]},
         "events.0.outlets.0 = 'c': unknown; known: a, b"),
        (TWO | {"events": [OPEN, {"when": "after", "do": "open_outlet", "outlets": ["b"]}, STOP]},
         "events.1.do = 'open_outlet': opens nothing"),
        ({"events": [OPEN, OPEN, STOP]}, "events.1.do = 'open_outlet': opens nothing: open by then"),
        ({"events": [{"when": "rest", "do": "open_outlet", "outlets": ["a"]}, STOP]},
         "events.0.outlets.0 = 'a': unknown; known: none by name"),
        (TWO | {"events": [{"when": "rest", "do": "stop", "outlets": ["b"]}]}, "stop takes no outlets; it takes nothing"),
        ({"inserts": [{"kind": "disc", "name": "plate", "radius_m": 0.02, "height_m": 0.112}]},
         "inserts.0 = 'plate': stands in the plane that spheres come in on, at 0.1131 m"),
        ({"inserts": [{"kind": "disc", "name": "plate", "radius_m": 0.031, "height_m": 0.05}]},
         "inserts.0 = 'plate': leaves the silo"),
        ({"inserts": [{"kind": "cone", "name": "hat", "radii_m": [0.01, 0.01], "heights_m": [0.05, 0.05]}]},
         "inserts.0 = 'hat': a surface must have an extent"),
        ({"inserts": [{"kind": "sieve", "name": "plate"}]}, "inserts.0.kind = 'sieve': unknown; known: "),
        ({"inserts": [{"kind": "polygon", "name": "plate", "corners_m": [[0, 0, 0.05], [0.01, 0, 0.05], [0, 0.01, 0.05]],
                       "side": "left"}]}, "inserts.0.side = 'left': must be 'both' or 'front'"),
        (TWO | {"sizes__diameter_mm": 19}, "sizes.diameter_mm = 19.0: a sphere of 19 mm does not pass the outlet b, 18 mm"),
        ({"filling__height_m": 0.2}, "filling.height_m = 0.2: must be from 0.004 to .* the plane lies outside the silo"),
        ({"filling__height_m": 0.001}, "filling.height_m = 0.001: must be from"),
        ({"filling__count": 2000}, "filling.count = 2000: no room below the plane for more than 797 of these spheres"),
        ({"filling": {"kind": "loose", "count": 900}}, "filling.count = 900: no room for sphere ..."),
        ({"filling__width_m": 0.005}, "filling.width_m = 0.005: must be 0.008 m or more"),
        ({"silo__filling_eccentricity_m": 0.01}, "silo.filling_eccentricity_m = 0.01: of a stream that is as wide as the silo"),
        ({"filling__width_m": 0.02, "silo__filling_eccentricity_m": 0.028}, "= 0.028: the stream lies outside the silo"),
        ({"grain__youngs_modulus_MPa": 0}, "grain.youngs_modulus_MPa = 0: must be greater than 0"),
        ({"grain__softened_modulus_MPa": 200}, "grain.softened_modulus_MPa = 200.0: must not be above the material's 100"),
        ({"grain__poissons_ratio": 0.5}, "grain.poissons_ratio = 0.5: must be less than 0.5"),
        ({"grain__density_kg_m3": None}, "grain.density_kg_m3 = None: must be given"),
        ({"grain": {"material": "straw"}}, "grain.material = 'straw': must be 'dosta-m1'"),
        ({"spheres": {"sliding_friction": 0.5}}, "spheres.restitution = None: must be given: no table holds the pair"),
        ({"spheres__normal": "spring-dashpot"}, "spheres.normal_stiffness_N_m: must be given: the law spring-dashpot needs it"),
        ({"spheres__cohesion": "jkr"}, "spheres.work_of_adhesion_J_m2: must be given: the law jkr needs it"),
        ({"sizes__diameter_mm": 45}, "sizes.diameter_mm = 45.0: a sphere of 45 mm does not pass the outlet, 40 mm"),
        ({"sizes__diameter_mm": 65}, "sizes.diameter_mm = 65.0: a sphere of 65 mm is wider than the silo, 60 mm"),
        ({"sizes": {"kind": "uniform", "least_mm": 5, "largest_mm": 4}}, "yaml: sizes.largest_mm = 4: must not be below"),
        ({"sizes": {"kind": "normal", "mean_mm": 5, "deviation_mm": 0.01, "least_mm": 7, "largest_mm": 8}},
         "yaml: sizes.least_mm = 7: next to nothing of this distribution"),
        ({"sizes": {"kind": "sieve", "openings_mm": [4, 8], "passing": [0, 0.9]}}, "yaml: sizes.passing = .*: must rise"),
        ({"sizes": None}, "yaml: sizes: is missing, where filling.kind is rain"),
        ({"silo": {"plan": "slot", "width_m": 0.06, "cylinder_depth_m": 0.1}, "events": [STOP], "record": {}},
         "silo.plan = 'slot': has no end walls"),
        ({"silo__top_cone_height_m": 0.01}, "silo.top_cone_height_m = 0.01: spheres make their heap themselves"),
        pytest.param({"march__step_s": 1e-3}, "march.step_s = 0.001: beyond the stability bound", marks=pytest.mark.long),
        ({"walls__tangential": "none", "events": [{"when": "rest", "do": "set_friction", "wall_friction": 0.2}, STOP]},
         "events.0.wall_friction = 0.2: the tangential law none takes no friction"),
        ({"inserts": [SHELF], "events": [{"when": "rest", "do": "take_away", "surfaces": ["floor"]}, STOP]},
         "events.0.surfaces = 'floor': unknown; known: shelf"),
        ({"inserts": [SHELF, PIPE], "events": [{"when": "rest", "do": "take_away", "surfaces": ["shelf"]}, STOP]},
         "events.0.surfaces = 'shelf': shares a side with another surface"),
        ({"inserts": [SHELF], "events": [{"when": "rest", "do": "take_away"}, STOP]},
         "events.0.surfaces: must be given where do is take_away"),
        ({"grains": "cubes"}, "grains = 'cubes': unknown; known: discs, spheres"),
    ],
)  # fmt: skip
def test_mistakes_are_one_line_before_the_run(changes, message, tmp_path):
    path = tmp_path / "bin.yaml"
    path.write_text(yaml.safe_dump(content(**changes)))
    from silostudy.choice.dem import load

    with pytest.raises(BadInput, match=message) as refused:
        scene_model(load(path)[0], tmp_path, "bin.yaml")
    assert "\n" not in str(refused.value)


@pytest.mark.parametrize(
    ("place", "message"),
    [
        ([(0, 0, 0.05), (0, 0.003, 0.05)], "filling = 'spheres 0, 1': overlap by 0.005 m at the start"),
        ([(0, 0, 0.05), (0.028, 0, 0.05)], "filling = 'sphere 1': starts in or beyond a wall"),
        ([(0, 0, 0.3)], "filling = 'sphere 0': starts in or beyond a wall"),
        ([(0, 0, -0.01)], "filling = 'sphere 0': starts in or beyond a wall"),
    ],
)
def test_starts_that_cannot_be(place, message, tmp_path):
    import xarray as xr

    columns = dict(zip(("grain_x", "grain_y", "grain_z"), np.array(place, float).T, strict=True))
    columns["grain_radius"] = np.full(len(place), 0.004)
    xr.Dataset({name: ("grain", values) for name, values in columns.items()}).to_netcdf(tmp_path / "given.nc")
    scene = scene_of(filling={"kind": "given", "file": "given.nc"}, sizes=None)
    with pytest.raises(BadInput, match=message):
        scene_model(scene, tmp_path)


def test_a_hopper_of_its_own_friction_is_no_sheet_with_the_wall_above_it():
    """The ends of a wedge stand in the walls' planes."""
    silo = {"silo__plan": "square", "silo__width_m": 0.06, "silo__diameter_m": None, "wedge": True, "record": {}}
    like, unlike = scene_of(**silo), scene_of(**silo, surfaces={"hopper": {"sliding_friction": 0.1}})
    coats = [[wall.coat for wall in scene_model(scene, ROOT).walls] for scene in (like, unlike)]
    assert coats[0] == [0] * 9
    assert coats[1] == [0, 1, 1, 1, 1, 0, 0, 0, 0]


def test_a_narrow_outlet_is_warned_of(tmp_path, capsys):
    path = tmp_path / "bin.yaml"
    path.write_text(yaml.safe_dump(content(silo__hopper__outlet_width_m=0.02)))
    assert main(["check", str(path)]) == 0
    assert "warning: the outlet is 2.5 of the largest diameters wide" in capsys.readouterr().out
