"""Flow of silos of grains beside codes: windows in which they are still full, Beverloo's law, and forces on the hopper."""

import numpy as np
import pytest
import xarray as xr

from silostudy.compute.beside_around import around_mean
from silostudy.compute.beside_flow import in_full_flow
from silostudy.compute.beside_hopper import forces
from silostudy.scene.outflow import beverloo
from tests.test_compute.made_walls import GAMMA, LOADS
from tests.test_compute.test_beside import codes_of, swept
from tests.test_figures.small_cubes import cube_of

WINDOWS = np.arange(1, 5) * 0.1  # s


def emptying(left):
    """A silo of 1000 spheres of which so many are left after 0.4 s."""
    return xr.Dataset(
        {"grains_at_start": 1000.0, "grains_left": left, "first_event_time": 1.0, "end_time": 1.4,
         "flow_window_end": ("flow_window", WINDOWS)},
        {"flow_window": np.arange(4)},
    )  # fmt: skip


@pytest.mark.parametrize(("left", "count"), [(1000.0, 4), (800.0, 2), (700.0, 1), (0.0, 1)])
def test_the_mean_in_flow_ends_when_a_tenth_is_out(left, count):
    """Of an even flow that takes out a share in four windows; the first window counts however fast it is."""
    values = in_full_flow(xr.DataArray(np.arange(4.0), dims="flow_window"), emptying(left))
    assert values.notnull().values.tolist() == [True] * count + [False] * (4 - count)


def test_beverloo_s_law_is_that_of_its_numbers():
    """815.5 kg/m3 through 40 mm less 1.5 grains of 5 mm: 0.58 x 815.5 x 3.132 x 0.0325^2.5 = 0.2821 kg/s."""
    assert beverloo(0.04, 0.005, 815.5, 0.58, 1.5) == pytest.approx(0.58 * 815.5 * 3.13209 * 1.90419e-4, rel=1e-4)
    assert beverloo(0.01, 0.005, 815.5, 0.58, 2.5) == 0.0


def test_a_silo_s_outlet_and_solid_enter_the_law():
    cube = cube_of("silo-of-spheres", "beside")
    law = beverloo(0.05, 0.005, GAMMA / 9.81, 0.55, 2.0)
    assert cube["least_law_mass_flow"].values == pytest.approx(law)
    flat = cube_of("silo-of-spheres-eccentric", "beside")
    assert flat["largest_law_mass_flow"].values == pytest.approx(beverloo(0.04, 0.005, GAMMA / 9.81, 0.65, 1.0))


def test_a_ring_force_is_of_the_force_on_the_hopper(tmp_path):
    _, grains, codes = swept(tmp_path, codes_of(methods=["jenike_1969", "en1991_4"]))
    codes = codes.drop_vars("silo")
    wall = codes["hopper_wall_force"]
    ringed = codes.assign(
        ring_force=xr.where(wall["pressure_method"] == "jenike_1969", 2.0, np.nan) + 0.0 * codes["ring_force"].fillna(0.0)
    )
    ratio = forces(ringed, grains)["code_over_grains_hopper_force"].isel(filling=0)
    for method, ring in (("jenike_1969", 2.0), ("en1991_4", 0.0)):
        for phase, felt in (("filling", LOADS[0, 1]), ("discharge", LOADS[1, 1])):
            expected = (wall.sel(pressure_method=method, phase=phase) + ring) / felt
            told = ratio.sel(pressure_method=method, phase=phase)
            assert told.values == pytest.approx(expected.values, nan_ok=True)
    assert ratio.notnull().any()


def test_zones_about_a_channel_come_to_the_static_pressure_all_around():
    """Integrated by hand over the three zones of every channel of EN 1991-4."""
    codes = cube_of("silo-of-spheres-eccentric-codes", "pressure").sel(pressure_method="en1991_4_eccentric", phase="discharge")
    half = codes["channel_half_width"]
    channel, beside, far = (codes[f"{zone}_normal_pressure"] for zone in ("channel", "adjacent", "static"))
    mean = (half * channel + half * beside + (np.pi - 2.0 * half) * far) / np.pi
    known = mean.notnull() & (far > 0.0)
    assert known.any()
    even = around_mean(codes)
    assert (mean / even).where(known).max() == pytest.approx(1.0)
    assert (mean / even).where(known).min() == pytest.approx(1.0)
    assert (codes["wall_normal_pressure"] > 1.2 * even).any()
