"""Figures of silos of grains beside codes say what the table of findings says of the same cube."""

import pandas as pd
import pytest
import xarray as xr
from matplotlib.colors import to_rgba

from silostudy.figures import flow_in_silos, grains_beside_codes, peaks_over_area, pressure_around, switch_in_hopper
from silostudy.figures.beside import MAY_COVER, SHORT, settings
from silostudy.figures.silo_findings import findings
from silostudy.figures.style import AID
from tests.test_figures.small_cubes import cube_of

AROUND = "least pressure over the grains' largest mean on an area"
METHOD = "as3774_1996"  # says something of flow


@pytest.fixture(scope="module")
def untold():
    """A cube of one setting where a method's mean is 1.1 times the grains', and its interval holds 1; all others are short."""
    cube = cube_of("silo-of-spheres", "beside")
    deep = cube["code_over_grains_peak"].notnull().any([dim for dim in cube["code_over_grains_peak"].dims if dim != "silo"])
    cube = cube.isel(silo=[int(deep.argmax("silo"))])
    ratios = cube["code_over_grains_peak"]
    split = 0.4 * (ratios["filling"] % 2) + 0.9
    made = (0.5 + 0.0 * ratios + 0.001 * ratios["filling"]).where(ratios["pressure_method"] != METHOD, split + 0.0 * ratios)
    return cube.assign(code_over_grains_peak=made.transpose(*ratios.dims))


def test_verdicts_are_those_of_the_table(untold, tmp_path, kept):
    """A mean above 1 whose interval reaches below does not cover the grains: it may."""
    table = findings(untold)
    told = table[(table["quantity"] == AROUND) & (table["phase"] == "discharge") & (table["area"] == "ring")]
    said = told.set_index("of")["verdict"].to_dict()
    assert said.pop(METHOD) == MAY_COVER
    assert set(said.values()) == {SHORT}
    grains_beside_codes.draw(untold, tmp_path / "beside")
    numbers = pd.read_csv(tmp_path / "beside.csv").dropna(subset=["verdict"])
    assert numbers.set_index("of")["verdict"].to_dict() == said | {METHOD: MAY_COVER}
    headline = " ".join(kept[0].get_suptitle().split())
    assert f"0 of {len(numbers)} methods cover the grains' largest mean around the wall (1 more may)" in headline


def test_methods_that_do_not_cover_are_told_apart_by_their_marks(untold, tmp_path, kept):
    grains_beside_codes.draw(untold, tmp_path / "beside")
    _, flow, ranks = kept[0].axes
    grey = to_rgba(grains_beside_codes.VERDICTS[SHORT]["color"])
    marks = {line.get_marker() for line in flow.lines if to_rgba(line.get_color()) == grey and line.get_gid() != AID}
    own = untold["pressure_method_marker"]
    assert marks == {str(own.sel(pressure_method=method).item()) for method in _short(ranks, untold)}


def _short(ranks, cube):
    """Methods that the panel of ranks names, but the one that may cover."""
    titles = {label.get_text() for label in ranks.get_yticklabels()}
    number, name = cube["pressure_method_number"].values, cube["pressure_method_title"].values
    of = zip(cube["pressure_method"].values, number, name, strict=True)
    return {str(key) for key, number, name in of if f"{number}  {name}".strip() in titles} - {METHOD}


def test_the_rise_on_the_hopper_is_the_table_s(tmp_path, kept):
    cube = cube_of("silo-of-spheres", "beside")
    other = cube["hopper_switch_factor"].copy()
    other[{"filling": 0, "wall_level": -1}] *= 3.0  # the largest of the mean is not the mean of the largest any more
    cube = cube.assign(hopper_switch_factor=other)
    table = findings(cube)
    rise = table[table["quantity"] == "largest ring mean on the hopper in flow over that at rest"]["mean"]
    switch_in_hopper.draw(cube, tmp_path / "switch")
    panels = kept[0].axes[: len(list(settings(cube)))]
    assert [panel.get_title().split(": ")[-1] for panel in panels] == [f"{mean:.1f}" for mean in rise]


def test_bands_of_fillings_are_told_apart(tmp_path, kept):
    switch_in_hopper.draw(cube_of("silo-of-spheres", "beside"), tmp_path / "switch")
    panel = kept[0].axes[0]
    bands = [band for band in panel.collections if str(band.get_label()).startswith("fillings, ")]
    assert len({(band.get_hatch(), band.get_facecolor().tobytes()) for band in bands}) == len(bands) == 3
    assert panel.get_ylabel() == "height above the outlet\nover that of the transition"


def test_areas_of_peaks_are_told_as_a_range_where_silos_have_other_levels(tmp_path, kept):
    """Cells are 1/12 of 0.1 to 0.48 m high and 1/16 of the girth of 0.1 m wide."""
    peaks_over_area.draw(cube_of("silo-of-spheres", "beside"), tmp_path / "peaks")
    names = [label.get_text() for label in kept[0].axes[0].get_xticklabels()]
    assert [name.splitlines()[1] for name in names] == ["0.13 to 0.28 D", "0.26 to 0.56 D", "0.51 to 1.1 D", "0.51 to 1.1 D"]


@pytest.mark.parametrize(
    ("study", "told"), [("silo-of-spheres", "angle around the wall (°)"),
                        ("silo-of-spheres-eccentric", "angle from the outlet's side (°)")],
)  # fmt: skip
def test_angles_are_from_the_outlet_where_it_is_off_the_axis(study, told, tmp_path, kept):
    pressure_around.draw(cube_of(study, "beside"), tmp_path / "around")
    labels = [panel.get_xlabel() for panel in kept[0].axes if panel.axison]
    assert labels[-1] == told
    assert set(labels) <= {"", told}


def test_flow_is_the_table_s_and_one_silo_of_three_flows_faster_than_the_law(tmp_path, kept):
    """Mass flows of 0.5, 0.9 and 1.2 times the most that the law gives, in every filling."""
    cube = cube_of("silo-of-spheres-eccentric", "beside")
    most = cube["largest_law_mass_flow"]
    made = most * xr.DataArray([0.5, 0.9, 1.2], dims="silo")
    cube = cube.assign(filling_mass_flow=made.transpose(*most.dims))
    flow_in_silos.draw(cube, tmp_path / "flow")
    headline = " ".join(kept[0].get_suptitle().split())
    assert (
        headline == "Grains flow at 0.5 to 1.2 times the most that Beverloo's law gives of a flat floor: 2 of 3 silos within it"
    )
    numbers, table = pd.read_csv(tmp_path / "flow.csv"), findings(cube)
    for panel, quantity in ((flow_in_silos.RATE, "mass flow"), (flow_in_silos.HEIGHT, "height up to which")):
        ends = [f"{name}{flow_in_silos.UNITS[panel]}" for name in flow_in_silos.ENDS]
        drawn = numbers[(numbers["panel"] == panel) & (numbers["what"] == "grains")][ends]
        told = table[table["quantity"].str.startswith(quantity) & (table["of"] == "grains")][list(flow_in_silos.ENDS)]
        assert drawn.to_numpy() == pytest.approx(told.to_numpy())


def test_how_uneven_the_wall_is_is_told_as_a_range_of_the_silos(tmp_path, kept):
    cube = cube_of("silo-of-spheres", "beside")
    silos = xr.DataArray([0.2, 0.3, 0.5, 0.6, 0.7, 0.8, 0.9, 1.1], dims="silo")
    made = (silos + 0.0 * cube["largest_over_ring"]).transpose(*cube["largest_over_ring"].dims)
    cube = cube.assign(largest_over_ring=made.fillna(0.6))
    pressure_around.draw(cube, tmp_path / "around")
    told = " ".join(kept[0].get_suptitle().split())
    low, high = (round(100.0 * float(end)) for end in (made.fillna(0.6).min(), made.fillna(0.6).max()))
    expected = f"{low} to {high} % more"
    assert told == f"The largest cell presses {expected} than the mean around its level at rest, {expected} in flow"
