"""The earthquake's load case on the shell: sums by hand, nothing added by no earthquake, and the same silo in both studies."""

import copy

import numpy as np
import pytest
import yaml

from silostudy.__main__ import main
from silostudy.choice.expand import expand
from silostudy.compute.pressure import pressure_cube
from silostudy.compute.seismic import seismic_cube
from silostudy.compute.shell import shell_cube
from silostudy.compute.shell_earthquake import sides
from silostudy.cube.io import write
from silostudy.errors import BadInput
from silostudy.figures import shell_earthquake
from silostudy.seismic.demand import axial_wall_force
from tests.conftest import expanded
from tests.test_buckling.test_shell import STUDY

SHAKEN = {
    "kind": "seismic",
    "title": "the small steel silo, shaken",
    "scene": {
        "silo": {"mid_wall_radius_m": 4.00375, "wall_thickness_mm": 7.5, "height_m": 20.0},
        "wall": {"density_kg_m3": 7850.0, "youngs_modulus_GPa": 210.0, "poisson_ratio": 0.3},
        "contents": {"density_kg_m3": 800.0},
        "damping_ratio": 0.05,
        "motion": {"record": "akt013_1996_ew", "peak_acceleration_gal": 150.0},
    },
    "relative_depth": {"start": 0.0, "stop": 1.0, "count": 101},
}


@pytest.fixture
def shaken():
    return copy.deepcopy(SHAKEN)


@pytest.fixture
def content():
    return copy.deepcopy(STUDY) | {"earthquake": {"study": "shaken"}}


def together(content, shaken, folder):
    """Expansion of the shell study, its pressure cube, and the seismic cube of the study beside it."""
    (folder / "shaken.yaml").write_text(yaml.safe_dump(shaken, sort_keys=False))
    expansion = expanded(content, folder)
    return expansion, pressure_cube(expansion), seismic_cube(expand(shaken, "shaken", "shaken.yaml", folder))


@pytest.fixture(scope="module")
def cubes(tmp_path_factory):
    content = copy.deepcopy(STUDY) | {"earthquake": {"study": "shaken"}}
    expansion, pressure, seismic = together(content, copy.deepcopy(SHAKEN), tmp_path_factory.mktemp("studies"))
    return expansion, pressure, seismic, shell_cube(expansion, pressure, seismic)


def test_axial_force_of_a_ring_balances_the_moment():
    """n cos(theta) round the ring: its moment about the axis is n pi R^2, by quadrature."""
    moment, radius = 23.4e6, 5.0
    n = axial_wall_force(moment, radius=radius)
    assert n == pytest.approx(moment / (np.pi * 25.0), rel=1e-15)
    angle = 2 * np.pi * np.arange(360) / 360
    lever = radius * np.cos(angle)
    assert np.sum(n * np.cos(angle) * lever) * 2 * np.pi * radius / 360 == pytest.approx(moment, rel=1e-12)


def test_sums_of_both_sides():
    found = sides(np.array([100.0, 200.0]), np.array([5.0, 9.0]), np.array([8.0, 12.0]),
                  seismic_force=np.array([30.0, 250.0]), seismic_pressure=np.array([6.0, 4.0]))  # fmt: skip
    assert [part.tolist() for part in found["pressed"]] == [[130.0, 450.0], [5.0, 9.0], [14.0, 16.0]]
    assert [part.tolist() for part in found["lifted"]] == [[70.0, -50.0], [0.0, 5.0], [8.0, 12.0]]  # the solid cannot pull


def test_loads_and_utilisation_in_the_cube(cubes):
    """Every second depth of the shell is one of the earthquake's: moment over pi R^2 on top of the static force, exactly."""
    _, pressure, seismic, cube = cubes
    here, one = {"pressure_method": "janssen", "phase": "filling"}, seismic.sel(mass_choice="eighty_percent")
    added = one["wall_bending_moment"].values / (np.pi * 4.00375**2)
    force = cube["earthquake_axial_wall_force"].sel(here).isel(depth=slice(None, None, 2))
    static = cube["axial_wall_force"].sel(here).isel(depth=slice(None, None, 2)).values
    np.testing.assert_allclose(force.sel(side="pressed"), static + added, rtol=1e-12)
    np.testing.assert_allclose(force.sel(side="lifted"), static - added, rtol=1e-9, atol=1e-9 * added.max())
    last = cube.sel(here).isel(depth=-1).sel(rule="miller1977", side="pressed")
    by_hand = 1.5 * (static[-1] + added[-1]) / 0.009 / float(last["earthquake_wall_buckling_stress"])
    assert float(last["earthquake_utilisation"]) == pytest.approx(by_hand, rel=1e-12)
    assert by_hand > 1.3 * float(last["utilisation"])
    middle = {"side": "pressed", "depth": 10.0, "pressure_method": "janssen"}
    extra = float(one["seismic_wall_pressure"][50])
    assert float(cube["earthquake_upper_internal_pressure"].sel(middle)) == pytest.approx(
        float(pressure["wall_normal_pressure"].sel(pressure_method="janssen", phase="filling", depth=10.0)) + extra, rel=1e-12
    )
    assert cube.attrs["earthquake_base_moment_N_m"] == float(one["base_moment"])
    assert "K-NET AKT013" in cube.attrs["earthquake_base_motion"]
    assert "EN 1998-4" in cube.attrs["references"]


def test_added_pressure_makes_the_foot_yield_sooner_and_a_lifted_wall_lose_its_support(cubes):
    cube = cubes[3].sel(pressure_method="janssen", rule="en1993_4_1_2007").isel(depth=slice(20, 200))
    elastic = cube["earthquake_wall_buckling_stress"]
    assert np.all(elastic.sel(side="lifted") <= cube["wall_buckling_stress"])
    assert float((elastic.sel(side="lifted") / cube["wall_buckling_stress"]).min()) < 0.95
    assert np.all(elastic.sel(side="pressed") <= cube["wall_buckling_stress"])


def test_no_earthquake_adds_nothing_to_the_last_bit(cubes):
    expansion, pressure, seismic, cube = cubes
    still = seismic.copy()
    for name in ("seismic_axial_wall_force", "seismic_wall_pressure"):
        still[name] = 0 * still[name]
    found = shell_cube(expansion, pressure, still)
    doubled = [str(name) for name in found if str(name).startswith("earthquake_")]
    assert len(doubled) == 17  # twelve quantities, five of them with their scope
    for name in doubled:
        for side in ("pressed", "lifted"):
            np.testing.assert_array_equal(found[name].sel(side=side), found[name.removeprefix("earthquake_")], err_msg=name)
    static = [name for name in cube if not str(name).startswith("earthquake_")]
    assert found[static].identical(cube[static].assign_attrs(found.attrs))


def test_static_studies_stay_as_they_are(cubes, content):
    """Not one variable more without the section, and the same numbers."""
    _, _, _, cube = cubes
    content.pop("earthquake")
    expansion = expanded(content)
    alone = shell_cube(expansion, pressure_cube(expansion))
    assert "side" not in alone.dims
    for name in alone:
        np.testing.assert_array_equal(alone[name], cube[name], err_msg=str(name))


MISTAKES = {
    "no such study": ({"study": "elsewhere"}, {}, "earthquake.study = 'elsewhere': unknown; known: shaken"),
    "nothing identified": ({"mass_choice": "identified"}, {}, "earthquake.mass_choice = 'identified': shaken identifies none"),
    "another silo": ({}, {"silo": {"mid_wall_radius_m": 5.0}}, "its inner radius of 4.99625 must be the silo's 4 "),
    "half filled": ({}, {"silo": {"fill_height_m": 10.0}}, "its depth of the contents of 10 must be the silo's 20 "),
    "another solid": ({}, {"contents": {"density_kg_m3": 900.0}}, "its unit weight of 8825.98 must be the silo's 7845.32 "),
}


@pytest.mark.parametrize("name", MISTAKES)
def test_mistakes(content, shaken, tmp_path, name):
    asked, changes, expected = MISTAKES[name]
    content["earthquake"] |= asked
    for part, values in changes.items():
        shaken["scene"][part] |= values
    with pytest.raises(BadInput) as caught:
        together(content, shaken, tmp_path)
    assert expected in str(caught.value)


def test_a_sweep_or_a_gap_in_depth_is_refused(content, shaken, tmp_path):
    swept = shaken | {"sweep": [{"axis": "peak", "values": {"motion.peak_acceleration_gal": [100.0, 200.0]}}]}
    with pytest.raises(BadInput, match="must be a seismic study without sweep"):
        together(content, swept, tmp_path)
    with pytest.raises(BadInput, match="must run from 0 to 1"):
        together(content, shaken | {"relative_depth": [0.0, 0.5]}, tmp_path)


def test_cube_of_another_earthquake_is_refused(cubes, content, shaken, tmp_path):
    expansion, pressure, _, _ = cubes
    with pytest.raises(BadInput, match="earthquake = 'shaken': needs the seismic cube"):
        shell_cube(expansion, pressure)
    shaken["scene"]["motion"]["peak_acceleration_gal"] = 100.0
    _, _, other = together(content, shaken, tmp_path)
    with pytest.raises(BadInput, match="is of another study than shaken"):
        shell_cube(expansion, pressure, other)


def test_figure_and_commands(cubes, content, shaken, tmp_path, capsys):
    _, _, seismic, cube = cubes
    together(content, shaken, tmp_path)
    (tmp_path / "small.yaml").write_text(yaml.safe_dump(content | {"outputs": ["shell_earthquake"]}, sort_keys=False))
    shell_earthquake.draw(cube, tmp_path / "figure")
    assert (tmp_path / "figure.png").stat().st_size > 10_000
    head, *rows = (tmp_path / "figure.csv").read_text().splitlines()
    assert head.startswith("rule,pressure_method,depth,static,pressed,lifted,worst_side,")
    assert head.endswith(",needed_static_mm,needed_with_earthquake_mm")
    assert len(rows) > 500
    assert main(["check", str(tmp_path / "small.yaml")]) == 0
    said = capsys.readouterr().out
    assert "earthquake: shaken, eighty_percent" in said
    assert "no combination or partial factors" in said
    assert main(["explain", "earthquake"]) == 0
    assert "n = M / (pi R^2)" in capsys.readouterr().out
    write(seismic, tmp_path / "seismic.nc")
    study = expanded(yaml.safe_load((tmp_path / "small.yaml").read_text()), tmp_path)
    write(pressure_cube(study), tmp_path / "pressure.nc")
    names = [str(tmp_path / name) for name in ("small.yaml", "pressure.nc", "shell.nc", "seismic.nc")]
    assert main(["shell", *names]) == 0
