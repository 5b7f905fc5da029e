"""A seismic study from YAML to cube, its mistakes, and its sub-commands."""

import numpy as np
import pytest
import yaml

from silostudy.__main__ import main
from silostudy.compute.seismic import seismic_cube
from silostudy.cube.io import read, write
from silostudy.errors import BadInput
from tests.conftest import expanded
from tests.test_seismic.conftest import SASAKI, quick


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
