"""A seismic study from YAML to cube to figures, its mistakes, and its sub-commands."""

import copy

import numpy as np
import pandas as pd
import pytest
import yaml

from silostudy.__main__ import main
from silostudy.compute.seismic import seismic_cube
from silostudy.config.load import read_yaml
from silostudy.cube.io import read, write
from silostudy.errors import BadInput
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
from tests.conftest import ROOT, expanded

SASAKI = ROOT / "config/studies/sasaki-1991.yaml"
FIGURES = (seismic_resonance, seismic_histories, seismic_spectra, seismic_indices, seismic_recovery, seismic_demand)


def quick() -> dict:
    """The default study, with few candidates and trials."""
    content = copy.deepcopy(read_yaml(SASAKI))
    content["identification"] |= {"refinement": 2, "recovery_trials": 5}
    return content


@pytest.fixture
def content() -> dict:
    return quick()


@pytest.fixture(scope="module")
def cube():
    return seismic_cube(expanded(quick()))


def test_cube_holds_the_sources_cases(cube):
    assert cube["amplitude_error"].dims == ("level", "coefficient")
    assert list(cube["level_peak_acceleration"].values) == pytest.approx([0.99, 2.28])
    assert np.abs(cube["base_acceleration"]).max("sample").values == pytest.approx([0.99, 2.28], rel=1e-12)
    found = cube["effective_mass_coefficient"].sel(identification="amplitude_error_coarse")
    assert found.values == pytest.approx([0.70, 0.60])
    assert np.all(np.abs(cube["effective_mass_coefficient"][:, 0].values - [0.7, 0.6]) < cube["uncertainty"].values)
    assert float(cube["sine_coefficient"].isel(level=0).sel(curve="full")) == pytest.approx(0.765, abs=5e-4)
    peaks = cube["frequency"][cube["resonance"].isel(level=0).argmax("frequency")]
    assert peaks.values[:2] == pytest.approx([33, 19], abs=0.06)


def test_cube_says_what_is_assumed_and_synthetic(cube):
    assert "silo.mid_wall_radius_m" in cube.attrs["assumed"]
    assert all(str(text).startswith("synthetic: model with C_eff") for text in cube["measured_origin"].values)
    assert all("K-NET AKT013" in str(text) and "time / 8" in str(text) for text in cube["base_motion"].values)
    for words in ("Sasaki", "K-NET strong-motion record", "EN 1998-4"):
        assert words in cube.attrs["references"]


def test_true_peaks_are_no_lower_than_sampled(cube):
    assert np.all(cube["top_peak"].values >= cube["top_peak_sampled"].values)
    assert np.all(cube["base_shear"] == cube["wall_shear_force"].isel(relative_depth=-1))


def test_round_trip(cube, tmp_path):
    path = tmp_path / "seismic.nc"
    write(cube, path)
    assert read(path).identical(cube)


@pytest.mark.long
def test_equal_inputs_give_equal_cubes(cube):
    assert seismic_cube(expanded(quick())).identical(cube)


def test_figures_have_labels_units_and_notes(cube, tmp_path, kept):
    for module in FIGURES:
        stem = tmp_path / module.__name__.split(".")[-1]
        module.draw(cube, stem)
        figure = kept[-1]
        assert all("(" in panel.get_xlabel() or "C_eff" in panel.get_xlabel() or not panel.lines or panel.get_xlabel() == ""
                   or "half-width" in panel.get_xlabel() for panel in figure.axes)  # fmt: skip
        assert "silo.mid_wall_radius_m" in figure.get_supxlabel()
        assert len(pd.read_csv(stem.with_suffix(".csv"))) > 0
        for suffix in (".png", ".svg"):
            assert stem.with_suffix(suffix).stat().st_size > 10_000
    assert "synthetic" in kept[1].get_supxlabel()


def test_indices_figure_shows_what_the_cube_holds(cube, tmp_path, kept):
    seismic_indices.draw(cube, tmp_path / "indices")
    left = kept[0].axes[0]
    one = cube.isel(level=0)
    assert left.lines[0].get_ydata() == pytest.approx((one["amplitude_error"] / one["amplitude_error"][-1]).values)
    assert len({str(line.get_linestyle()) + str(line._dash_pattern) for line in left.lines[:3]}) == 3  # without colour too
    texts = " ".join(text.get_text() for text in left.texts)
    assert "0.70, f1 = 21.1 Hz" in texts
    assert "2.62 wall masses" in texts


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
    assert "Measured" not in kept[-1].get_supxlabel()


def test_whole_stiffness_without_a_measured_frequency(content):
    content["scene"]["empty_frequency_Hz"] = None
    for part in ("identification", "published", "sine"):
        content.pop(part)
    content["scene"].pop("measured")
    content |= {"sweep": [], "assumed": [], "outputs": []}
    cube = seismic_cube(expanded(content))
    assert float(cube["stiffness_reduction"]) == 1
    assert float(cube["empty_frequency"]) == float(cube["unreduced_frequency"])


def put(content: dict, dotted: str, value) -> None:
    *parents, last = dotted.split(".")
    for parent in parents:
        content = content.setdefault(parent, {})
    content[last] = value


MISTAKES = {
    "both sources of motion": ({"scene.motion.file": "a.txt"}, "give either file or record (akt013_1996_ew), and not both"),
    "unknown record": ({"scene.motion.record": "elcentro"}, "scene.motion.record = 'elcentro': must be 'akt013_1996_ew'"),
    "no unit": (
        {"scene.motion": {"file": "a.txt", "format": "two_columns"}},
        "two_columns needs acceleration_unit: g, gal or m_s2",
    ),
    "missing file": ({"scene.motion": {"file": "nowhere.AT2", "format": "peer_at2"}}, "must be a readable file"),
    "band above the sampling": ({"identification.band_Hz": [5.0, 500.0]}, "must end below 400 Hz, half the sampling rate"),
    "band upside down": ({"identification.band_Hz": [60.0, 5.0]}, "must be two increasing frequencies"),
    "overfilled": ({"scene.silo.fill_height_m": 2.0}, "fill_height_m must not be above height_m"),
    "no damping": ({"scene.damping_ratio": 0}, "scene.damping_ratio = 0: must be greater than 0"),
    "assumed what is not there": ({"assumed": ["silo.colour"]}, "assumed names silo.colour, which is no key"),
    "full above empty": ({"sine.full_frequency_Hz": 33.0}, "full_frequency_Hz must be below empty_frequency_Hz"),
    "falling coefficients": (
        {"identification.coefficients": {"start": 1.0, "stop": 0.5, "count": 11}},
        "must rise in equal steps",
    ),
    "nothing to identify from": ({"scene.measured": None, "assumed": []}, "identification and scene.measured need each other"),
    "no stiffness to identify with": ({"scene.empty_frequency_Hz": None}, "identification needs scene.empty_frequency_Hz"),
    "an output of a section left out": ({"sine": None, "assumed": []}, "output seismic_resonance needs the section sine"),
    "depth outside": ({"relative_depth": [0.5, 1.5]}, "must rise within 0 ... 1"),
    "stiffer than stiff": ({"scene.empty_frequency_Hz": 300.0}, "scene.empty_frequency_Hz = 300.0: must not be above 212.7 Hz"),
    "stiffer than stiff in the sweep": (
        {"sine.empty_frequency_Hz": 300.0},
        "sine.empty_frequency_Hz = 300.0: must not be above",
    ),
    "channel without traces": (
        {"scene.motion": {"file": "a.txt", "format": "two_columns", "acceleration_unit": "g", "channel": "HNE"}},
        "channel goes with a file of format obspy",
    ),
    "an output of another stage": ({"outputs": ["fig_4_2_11"]}, "output fig_4_2_11 is drawn from a pressure cube"),
}


@pytest.mark.parametrize("name", MISTAKES)
def test_mistakes(content, name):
    changes, expected = MISTAKES[name]
    content["sweep"] = []
    for dotted, value in changes.items():
        put(content, dotted, value)
    with pytest.raises(BadInput) as caught:
        expanded(content)
    assert expected in str(caught.value)


def test_measured_file_must_fit_the_base(content, tmp_path):
    (tmp_path / "top.txt").write_text("0.0 1.0\n0.01 2.0\n0.02 0.5\n")
    content["sweep"] = []
    content["assumed"] = []
    content["scene"]["measured"] = {"file": "top.txt", "format": "two_columns", "acceleration_unit": "g"}
    with pytest.raises(BadInput, match="must be sampled as the base motion is after time compression: 5900 samples"):
        expanded(content, tmp_path)


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
    assert f"{word} candidate: may lie beyond" in " ".join(text.get_text() for text in indices.axes[0].texts)
    assert "are not judged" in " ".join(text.get_text() for text in indices.axes[0].texts)
    assert "open: reaches an end" in " ".join(text.get_text() for text in recovery.axes[1].texts)
    assert f"{word} candidate" in " ".join(text.get_text() for text in demand.axes[5].get_legend().get_texts())
    assert f"{word} candidate" in histories.axes[0].get_title()


def test_answers_between_the_candidates_stay_closed(cube):
    assert not cube["candidate_end"].any()
    assert np.isfinite(cube["uncertainty"]).all()


def test_check_tells_an_unlikely_record(capsys, content, tmp_path):
    (tmp_path / "base.txt").write_text("".join(f"{10 * n} {(-1) ** n}\n" for n in range(50)))
    content["scene"]["motion"] = {"file": "base.txt", "format": "two_columns", "acceleration_unit": "g"}
    content |= {"sweep": [], "outputs": [], "identification": None, "sine": None, "published": None, "assumed": []}
    content["scene"].pop("measured")
    (tmp_path / "study.yaml").write_text(yaml.safe_dump(content))
    assert main(["check", str(tmp_path / "study.yaml")]) == 0
    assert "base.txt (unlikely: steps of 10 s)" in capsys.readouterr().out


def test_commands(capsys, content, tmp_path):
    assert main(["check", str(SASAKI)]) == 0
    said = capsys.readouterr().out
    assert "2 case(s): level 2" in said
    assert "note: the measured response is synthetic" in said
    assert "note: assumed are silo.mid_wall_radius_m" in said
    for what, expected in (
        ("mass-rules", "resonance_shift"),
        ("mass-rules", "wall_carried_ring"),
        ("records", "akt013_1996_ew"),
        ("outputs", "seismic_indices"),
    ):
        assert main(["list", what]) == 0
        assert expected in capsys.readouterr().out
    assert main(["explain", "amplitude_error"]) == 0
    assert "E_A = sum |X' - X| / (n sum X)" in capsys.readouterr().out
    assert main(["explain", "wall_carried_ring"]) == 0
    assert "C_eff = min(1, mu N / W)" in capsys.readouterr().out
    path = tmp_path / "quick.yaml"
    content["identification"] |= {"recovery_trials": 2, "refinement": 1}
    path.write_text(yaml.safe_dump(content, sort_keys=False))
    assert main(["seismic", str(path), str(tmp_path / "seismic.nc")]) == 0
    assert main(["draw", "seismic_resonance", str(tmp_path / "seismic.nc"), str(tmp_path / "resonance")]) == 0
    assert (tmp_path / "resonance.png").is_file()
