"""Quantities of a run against what its arrays were made with."""

from math import radians, tan

import numpy as np
import pytest

from silostudy.choice.dem import load
from silostudy.compute.expected import Verdict, notes_of
from silostudy.config.load import own_validated
from silostudy.config.spheres import SphereScene
from silostudy.dem.outcomes import OUTCOMES, Looks
from silostudy.errors import BadInput
from silostudy.tables.references import references
from tests.conftest import ROOT
from tests.test_spheres.small import content

UP = np.array([0.0, 0.0, 1.0])
PUBLISHED = {"value_deg": 26.0, "tolerance_deg": 3.0, "source": "somebody", "locator": "page 1"}
SURFACE = {"kind": "surface-angle", "along": "x", "from_m": -0.1, "to_m": 0.1}


def looks(*places, radius=0.002, **others):
    """What a run recorded, of equal grains."""
    told = {"left_time": np.empty(0), "left_mass": np.empty(0), "up": UP} | others
    radii = tuple(np.full(len(place), radius) for place in places)
    return Looks(places=places, radii=radii, times=tuple(map(float, range(len(places)))), **told)


def heap(slope):
    """Places under a plane that falls along x, which some of them touch everywhere."""
    random = np.random.default_rng(1)
    x, y = random.uniform(-0.1, 0.1, (2, 40000))
    return np.c_[x, y, slope * x - np.where(random.uniform(size=x.size) < 0.5, 0.0, random.uniform(0.0, 0.1, x.size))]


@pytest.mark.parametrize("angle", [0.0, 12.0, -26.0])
def test_angle_of_a_plane_surface(angle):
    found = OUTCOMES["surface-angle"].find(looks(heap(tan(radians(angle)))), along="x", start=-0.09, end=0.09, after=0.0)
    assert found == pytest.approx(abs(angle), abs=0.3)


def test_angle_is_the_mean_of_the_snapshots_after_a_time():
    surface = looks(*(heap(tan(radians(angle))) for angle in (40.0, 20.0, 30.0)))
    assert OUTCOMES["surface-angle"].find(surface, along="x", start=-0.09, end=0.09, after=1.0) == pytest.approx(25.0, abs=0.3)


def test_an_emptied_silo_has_no_surface_and_costs_no_result():
    surface = looks(heap(tan(radians(20.0))), np.empty((0, 3)))
    assert OUTCOMES["surface-angle"].find(surface, along="x", start=-0.09, end=0.09, after=0.0) == pytest.approx(20.0, abs=0.3)
    assert np.isnan(OUTCOMES["surface-angle"].find(surface, along="x", start=-0.09, end=0.09, after=1.0))
    assert np.isnan(OUTCOMES["heap-height"].find(surface, floor=0.0))


def test_angle_with_gravity_along_another_way():
    turned = heap(tan(radians(20.0)))[:, [2, 1, 0]]
    surface = looks(turned, up=np.array([1.0, 0.0, 0.0]))
    assert OUTCOMES["surface-angle"].find(surface, along="z", start=-0.09, end=0.09, after=0.0) == pytest.approx(20.0, abs=0.3)


def test_height_counts_the_radius_and_the_floor():
    place = np.array([[0.0, 0.0, -0.56], [0.1, 0.0, -0.3]])
    assert OUTCOMES["heap-height"].find(looks(place * 9.0, place), floor=-0.57) == pytest.approx(0.272, rel=1e-12)


def test_outflow_leaves_out_the_start_and_the_end():
    time = np.linspace(1.0, 3.0, 201)
    mass = 0.5 * (time - 1.0) + 0.05 * np.where(time < 1.2, np.sin(40.0 * time), 0.0)  # kg, unsteady at first
    late = np.where(time > 2.9, 0.5 * 1.9, mass)  # and held back at last
    found = OUTCOMES["steady-outflow"].find(looks(left_time=time, left_mass=late))
    assert found == pytest.approx(0.5, rel=1e-9)


def test_mass_out_is_all_that_left_and_none_where_nothing_did():
    found = OUTCOMES["discharged-mass"].find
    assert found(looks(left_time=np.array([1.0, 2.0]), left_mass=np.array([0.2, 0.5]))) == 0.5
    assert found(looks()) == 0.0


@pytest.mark.parametrize("quantity", ["steady-outflow", "wall-load", "heap-height", "surface-angle"])
def test_nothing_recorded_gives_no_number(quantity):
    given = {"heap-height": {"floor": 0.0}, "surface-angle": {"along": "x", "start": 0.0, "end": 1.0, "after": 0.0}}
    assert np.isnan(OUTCOMES[quantity].find(looks(), **given.get(quantity, {})))


@pytest.mark.parametrize(
    ("expected", "told"),
    [
        ({**PUBLISHED, **SURFACE, "along": "w"}, "along"),
        ({**PUBLISHED, **SURFACE, "tolerance_deg": 0.0}, "tolerance_deg"),
        ({**PUBLISHED, **SURFACE, "kind": "angle"}, "steady-outflow"),
        ({**PUBLISHED, **SURFACE}, "needs record.snapshots_s"),
        (
            {"kind": "wall-load", "value_N": 1.0, "tolerance_N": 0.1, "source": "statics", "locator": "weight"},
            "needs record.wall_force_window_s",
        ),
    ],
)
def test_what_cannot_be_expected(expected, told):
    scene = content() | {"expected": [expected], "record": {}}
    with pytest.raises(BadInput, match=told):
        own_validated(SphereScene, scene, "scene.yaml", None)


def test_the_rate_that_the_hopper_expects_is_that_of_the_published_masses():
    """A sixth of the hopper is what the source ran; both slopes are over the same share of the mass."""
    time, mass = np.loadtxt(ROOT / "tests/published/scenes/anand-hopper.csv", delimiter=",", skiprows=2).T
    read = looks(left_time=time, left_mass=6e-3 * mass)
    (asked,) = load(ROOT / "config/scenes/anand-hopper.yaml")[0].expected
    assert asked.value_kg_s == pytest.approx(OUTCOMES["steady-outflow"].find(read), abs=5e-4)
    assert asked.tolerance_kg_s == pytest.approx(0.12 * asked.value_kg_s, rel=0.01)
    assert asked.source in references().entries


def test_the_angle_that_the_draw_down_expects_is_that_of_the_formula():
    """A rolling friction times the reduced radius, half a radius of two spheres, is the length that the formula means."""
    scene, _ = load(ROOT / "config/scenes/draw-down.yaml")
    diameter = scene.sizes.diameter_mm
    lengths = [scene.spheres.rolling_friction * diameter / 4.0, scene.walls.rolling_friction * diameter / 2.0]
    frictions = [scene.spheres.sliding_friction, scene.walls.sliding_friction]
    angle = 68.61 * np.prod(np.power([*frictions, *lengths, diameter], [0.27, 0.22, 0.06, 0.12, -0.2]))
    assert [asked.value_deg for asked in scene.expected] == pytest.approx([angle, angle], abs=0.05)


def test_a_quantity_that_is_expected_twice_is_told_twice():
    row = OUTCOMES["surface-angle"]
    notes = notes_of([Verdict(row, 20.0, 3.0, 21.0, "a"), Verdict(row, 20.0, 3.0, 22.0, "a")])
    assert (notes["found_surface_angle_deg"], notes["found_surface_angle_2_deg"]) == (21.0, 22.0)
