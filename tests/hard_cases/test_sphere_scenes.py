"""Hard scenes of spheres before they run: what cannot be is refused in a line that names the field."""

from math import inf, nan, radians
from pathlib import Path

import numpy as np
import pytest
import xarray as xr

from silostudy.compute.dem import scene_model
from silostudy.errors import BadInput
from silostudy.scene.mixture import drawn
from silostudy.scene.outflow import narrow
from silostudy.scene.silo import Hopper, Silo
from silostudy.scene.space_silo import Outlet, SpaceSilo
from tests.test_spheres.small import scene_of

FLAT = {"silo__hopper": None, "events": [{"when": "time", "value": 0.1, "do": "stop"}]}


def refused(told, folder="", **changes):
    """A scene whose content, or whose model, is refused with these words."""
    with pytest.raises(BadInput, match=told):
        scene_model(scene_of(**changes), Path(folder), "small.yaml")


def test_outlet_tangent_to_the_wall():
    silo = Silo(plan="circular", diameter=0.1, wall_depth=0.1)
    with pytest.raises(BadInput, match=r"outlets\.0\.middle_m.*touches the wall: all of it must lie inside the floor"):
        SpaceSilo(silo=silo, outlets=(Outlet(width=0.05, middle=(0.025, 0.0)),))
    SpaceSilo(silo=silo, outlets=(Outlet(width=0.05, middle=(0.0249, 0.0)),))


def test_outlets_tangent_to_each_other():
    silo = Silo(plan="circular", diameter=0.1, wall_depth=0.1)
    pair = [Outlet(width=0.03125, middle=(x, 0.0), name=name) for name, x in (("one", -0.015625), ("two", 0.015625))]
    with pytest.raises(BadInput, match=r"outlets = 'one, two': must not overlap or touch"):
        SpaceSilo(silo=silo, outlets=tuple(pair))


@pytest.mark.parametrize("eccentricity", [0.0099, 0.01])
def test_eccentric_cone_that_stands_upright_on_one_side(eccentricity):
    """A joint so flat, along one line, that both walls would push a sphere about."""
    told = "outlet_eccentricity.* degrees off the wall above it: at least 5 all around a cone"
    refused(told, silo__outlet_eccentricity_m=eccentricity)


@pytest.mark.parametrize("degrees", [1.0, 4.9])
def test_cone_next_to_upright(degrees):
    """A joint so flat that both walls would push a sphere about."""
    hopper = Hopper(half_angle=radians(degrees), outlet_width=0.05)
    with pytest.raises(BadInput, match=r"degrees off the wall above it: at least 5"):
        SpaceSilo(silo=Silo(plan="circular", diameter=0.06, wall_depth=0.1, hopper=hopper))


@pytest.mark.parametrize("degrees", [0.0, 90.0, nan, inf, -30.0])
def test_cone_of_no_angle(degrees):
    refused("half_angle", silo__hopper__half_angle_deg=degrees)


def test_cone_of_89_degrees():
    hopper = Hopper(half_angle=radians(89.0), outlet_width=0.02)
    space = SpaceSilo(silo=Silo(plan="circular", diameter=0.06, wall_depth=0.1, hopper=hopper))
    assert space.bottom == pytest.approx(0.02 * np.tan(radians(1.0)), rel=1e-12)


@pytest.mark.parametrize("sides", [25, 1000])
def test_polygon_with_corners_too_flat(sides):
    with pytest.raises(BadInput, match=r"silo\.sides = .*from 3 to 24"):
        SpaceSilo(silo=Silo(plan="polygonal", sides=sides, diameter=0.06, wall_depth=0.1))


@pytest.mark.long
def test_insertion_into_a_full_bin():
    """Told beforehand, with how many there is room for."""
    refused(r"filling\.count = 100000.*no room below the plane for more than \d+ of these", filling__count=100_000)
    loose = FLAT | {"filling": {"kind": "loose", "count": 100_000}}
    refused(r"filling\.count = 100000.*no room for sphere \d+", **loose)


def test_sphere_wider_than_the_silo_or_its_outlet():
    refused("is wider than the silo, 60 mm", sizes={"kind": "equal", "diameter_mm": 60.001}, **FLAT)
    refused("does not pass the outlet, 40 mm", sizes={"kind": "equal", "diameter_mm": 40.001})


def test_slot_of_six_diameters():
    """Wide enough not to be warned of; one of less than five is."""
    silo = Silo(plan="square", diameter=0.1, wall_depth=0.1)
    slot = {width: SpaceSilo(silo=silo, outlets=(Outlet(width=width * 0.004, length=0.1),)) for width in (4.9, 6.0)}
    assert narrow(slot[6.0].outlet_widths, 0.004, "sphere") == []
    assert "arch over it" in narrow(slot[4.9].outlet_widths, 0.004, "sphere")[0]


def given(folder, **changes):
    """A file of three spheres in the small bin, some of whose numbers are others."""
    held = {
        "grain_x": [0.0, 0.01, -0.01],
        "grain_y": [0.0, 0.0, 0.0],
        "grain_z": [0.06, 0.06, 0.06],
        "grain_radius": [0.004] * 3,
    }
    for name, (which, value) in changes.items():
        held[name][which] = value
    xr.Dataset({name: ("grain", np.array(value)) for name, value in held.items()}).to_netcdf(folder / "three.nc")
    return {"filling": {"kind": "given", "file": "three.nc"}, "sizes": None, "folder": str(folder)}


@pytest.mark.parametrize(
    ("name", "value"),
    [("grain_radius", nan), ("grain_radius", 0.0), ("grain_radius", -0.004), ("grain_z", inf), ("grain_y", nan)],
)
def test_numbers_in_a_file_of_spheres_that_are_none(tmp_path, name, value):
    changes = given(tmp_path, **{name: (1, value)})
    if name == "grain_y":  # a sphere without any place has left an earlier run; one of half a place is wrong
        changes |= given(tmp_path, grain_y=(1, nan))
    refused(r"filling\.file = 'three\.nc': sphere 1 must have finite places and a positive finite radius", **changes)


def test_file_of_spheres_that_overlap_or_stand_outside(tmp_path):
    refused(r"spheres 0, 1.*overlap by 0\.006 m at the start", **given(tmp_path, grain_x=(1, 0.002)))
    refused(r"sphere 2.*starts in or beyond a wall, at x -0\.029", **given(tmp_path, grain_x=(2, -0.029)))
    refused(r"sphere 0.*starts in or beyond a wall", **given(tmp_path, grain_z=(0, -0.5)))


def test_a_million_grains_of_four_sizes():
    """Shares of mass by size as the sieve curve says, to what a million draws scatter."""
    edges, passing = np.array([1.0, 2.0, 4.0, 8.0, 10.0]), np.array([0.0, 0.1, 0.3, 0.8, 1.0])
    sizes = {"kind": "sieve", "openings_mm": edges.tolist(), "passing": passing.tolist()}
    radii, kind = drawn(scene_of(sizes=sizes, filling__count=1_000_000), np.random.default_rng(0))
    volume = radii**3
    assert kind is None
    shares = [volume[radii <= 0.5e-3 * edge].sum() / volume.sum() for edge in edges]
    assert shares == pytest.approx(passing, abs=5e-3)


@pytest.mark.parametrize("value", [nan, inf])
@pytest.mark.parametrize("field", ["grain__density_kg_m3", "grain__softened_modulus_MPa", "spheres__sliding_friction",
                                   "walls__restitution", "silo__diameter_m", "march__limit_s", "gravity_m_s2"])  # fmt: skip
def test_numbers_in_a_scene_of_spheres_that_are_none(field, value):
    content = (0.0, 0.0, value) if field == "gravity_m_s2" else value
    refused(field.replace("__", "."), **{field: content})
