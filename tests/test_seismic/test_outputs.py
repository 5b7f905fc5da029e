"""Figures and tables of seismic studies: labels, units, notes, and what they show."""

import numpy as np
import pandas as pd
import pytest

from silostudy.compute.seismic import seismic_cube
from silostudy.config.load import read_yaml
from silostudy.cube.io import read, write
from silostudy.figures import (
    sasaki_1991,
    seismic_demand,
    seismic_histories,
    seismic_indices,
    seismic_recovery,
    seismic_resonance,
    seismic_spectra,
)
from silostudy.tables.outputs import OUTPUTS
from tests.conftest import expanded
from tests.test_figures.words import told as words_of
from tests.test_seismic.conftest import SASAKI

FIGURES = (seismic_resonance, seismic_histories, seismic_spectra, seismic_indices, seismic_recovery, seismic_demand)


def test_figures_have_labels_units_and_notes(cube, tmp_path, kept):
    for module in FIGURES:
        stem = tmp_path / module.__name__.split(".")[-1]
        module.draw(cube, stem)
        figure = kept[-1]
        assert all("(" in panel.get_xlabel() or "C_eff" in panel.get_xlabel() or not panel.lines or panel.get_xlabel() == ""
                   or "half-width" in panel.get_xlabel() for panel in figure.axes)  # fmt: skip
        assert "silo.mid_wall_radius_m" in words_of(figure)
        assert len(pd.read_csv(stem.with_suffix(".csv"))) > 0
        for suffix in (".png", ".svg"):
            assert stem.with_suffix(suffix).stat().st_size > 10_000
    assert "synthetic" in words_of(kept[1])


def test_indices_figure_shows_what_the_cube_holds(cube, tmp_path, kept):
    seismic_indices.draw(cube, tmp_path / "indices")
    left = kept[0].axes[0]
    one = cube.isel(level=0)
    assert left.lines[0].get_ydata() == pytest.approx((one["amplitude_error"] / one["amplitude_error"][-1]).values)
    assert len({str(line.get_linestyle()) + str(line._dash_pattern) for line in left.lines[:3]}) == 3  # without colour too
    assert "0.70, f1 = 21.1 Hz" in words_of(kept[0])
    assert "2.62 wall masses" in words_of(kept[0])


def test_demand_figure_runs_downward(cube, tmp_path, kept):
    seismic_demand.draw(cube, tmp_path / "demand")
    assert all(panel.yaxis_inverted() for panel in kept[0].axes[:5])


def test_table_sets_the_print_beside_the_computed(cube, tmp_path):
    sasaki_1991.draw(cube, tmp_path / "table")
    table = pd.read_csv(tmp_path / "table.csv").set_index(["test", "quantity"])
    assert len(table) == 17
    assert table.loc[("earthquake_010g", "full_frequency_Hz"), "computed"] == pytest.approx(21.1, abs=0.06)
    assert table.loc[("sine", "effective_mass_coefficient"), "printed"] == 0.70
    assert "not confirmed" in table.loc[("sine", "effective_mass_coefficient"), "remark"]
    assert table.loc["sine"].loc["stiffness_reduction"].computed == pytest.approx(0.024, abs=1e-4)


def test_every_seismic_output_is_asked_for():
    outputs = {key for key, row in OUTPUTS.items() if row.stage == "seismic"}
    assert outputs == set(read_yaml(SASAKI)["outputs"])


@pytest.mark.long
def test_measured_file_and_partly_filled(content, tmp_path):
    """A user's own measurement: the base record itself stands for it, so the answer only has to be one of the candidates."""
    times = 0.01 * np.arange(400)
    rows = [f"{t:.4f} {np.sin(20 * t):.6f}" for t in times]
    (tmp_path / "base.txt").write_text("\n".join(rows))
    (tmp_path / "top.txt").write_text("\n".join(rows))
    content["scene"] |= {
        "motion": {"file": "base.txt", "format": "two_columns", "acceleration_unit": "g", "synthetic": True},
        "measured": {"file": "top.txt", "format": "two_columns", "acceleration_unit": "gal"},
    }
    content["scene"]["silo"]["fill_height_m"] = 0.8
    content |= {"sweep": [], "assumed": [], "published": None, "outputs": []}
    content["identification"]["band_Hz"] = [1.0, 40.0]
    expansion = expanded(content, tmp_path)
    assert [file.name for file in expansion.files] == ["base.txt", "top.txt"]
    cube = seismic_cube(expansion)
    assert "(synthetic)" in str(cube["base_motion"].values)
    assert str(cube["measured_origin"].values) == "top.txt"
    assert np.abs(cube["measured_acceleration"]).max() == pytest.approx(0.01, rel=1e-3)
    assert float(cube["depth"].max()) == pytest.approx(0.8)
    for module in FIGURES:
        module.draw(cube, tmp_path / module.__name__)


@pytest.mark.long
def test_demand_alone(content, tmp_path, kept):
    """Without anything measured the cube holds the demand on the wall, the same to the last bit, and nothing else."""
    whole = seismic_cube(expanded(content))
    for part in ("sine", "identification", "published"):
        content.pop(part)
    content["scene"].pop("measured")
    content["sweep"][0]["points"] = [
        {key: value for key, value in point.items() if not key.startswith("measured")}
        for point in content["sweep"][0]["points"]
    ]
    content |= {"assumed": [], "outputs": ["seismic_demand"]}
    cube = seismic_cube(expanded(content))
    assert not {"amplitude_error", "resonance", "measured_acceleration"} & set(cube)
    assert list(cube["mass_choice"].values) == ["eighty_percent", "all_contents"]
    for name in ("wall_shear_force", "seismic_wall_pressure", "base_moment", "stiffness_reduction"):
        same = whole[name].sel(mass_choice=cube["mass_choice"].values) if "mass_choice" in whole[name].dims else whole[name]
        np.testing.assert_array_equal(cube[name].values, same.values)
    seismic_demand.draw(cube, tmp_path / "demand")
    assert "Measured" not in words_of(kept[-1])


@pytest.mark.long
@pytest.mark.parametrize(("truth", "candidates", "end"), [(0.4, (0.5, 1.0), -1), (0.8, (0.4, 0.7), 1)])
def test_an_answer_at_the_end_of_the_candidates_is_open(content, tmp_path, kept, truth, candidates, end):
    """A truth of 0.40 under candidates of 0.50 ... 1.00 was stated as 0.5000 +- 0.0071."""
    start, stop = candidates
    content |= {"sweep": [], "published": None}
    content["scene"]["measured"]["imitation"]["effective_mass_coefficient"] = truth
    content["identification"] |= {
        "coefficients": {"start": start, "stop": stop, "count": 11},
        "shown_coefficients": [start, stop],
    }
    told = []
    cube = seismic_cube(expanded(content), told.append)
    by_amplitude = cube.sel(identification="amplitude_error")
    assert float(by_amplitude["effective_mass_coefficient"]) == (start if end < 0 else stop)
    assert int(by_amplitude["candidate_end"]) == int(cube["candidate_end"].sel(identification="phase_error")) == end
    assert np.isinf([cube["uncertainty"], cube["coarse_uncertainty"]]).all()
    assert "the identified one is an end of the candidates" in told[0]
    write(cube, tmp_path / "cube.nc")
    assert np.isinf(read(tmp_path / "cube.nc")["uncertainty"])
    for module in (seismic_indices, seismic_recovery, seismic_demand, seismic_histories):
        module.draw(cube, tmp_path / module.__name__)
    indices, recovery, demand, histories = kept
    word = "lowest" if end < 0 else "highest"
    assert f"{word} candidate: may lie beyond" in words_of(indices)
    assert "are not judged" in words_of(indices)
    assert "open: reaches an end" in " ".join(text.get_text() for text in recovery.axes[1].texts)
    assert f"{word} candidate" in words_of(demand)
    assert f"{word} candidate" in histories.axes[0].get_title()
