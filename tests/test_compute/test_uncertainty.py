"""Scatter of the stored solid: reproducible, right where it is known in closed form, and asked for with its spreads."""

import copy

import numpy as np
import pytest
from scipy.stats import sobol_indices, uniform

from silostudy.compute.evaluate import methods_of
from silostudy.compute.pressure import depths_in_metres
from silostudy.compute.uncertainty import SAMPLED, indices, pressure_of, scattered, sequence, spreads, uncertainty_cube
from silostudy.config.load import study_of
from silostudy.errors import BadInput
from silostudy.figures.uncertainty_bands import missing
from tests.conftest import expanded
from tests.test_figures.test_hopper_figures import BIN


@pytest.fixture
def sampled():
    content = copy.deepcopy(BIN) | {"methods": ["janssen"], "phases": ["filling"], "hopper_position": None}
    return content | {"uncertainty": {"log2_samples": 10, "seed": 5}, "depth_m": [0.001, 10.0]}


def test_same_seed_same_numbers(sampled):
    first, second = uncertainty_cube(expanded(sampled)), uncertainty_cube(expanded(sampled))
    for name in ("wall_normal_pressure_quantile", "sobol_first", "sobol_total"):
        np.testing.assert_array_equal(first[name].values, second[name].values)
    sampled["uncertainty"]["seed"] = 6
    other = uncertainty_cube(expanded(sampled))
    assert not np.array_equal(first["sobol_first"].values, other["sobol_first"].values)


@pytest.mark.parametrize(("log2", "count"), [(9, 512), (9.5, 724)])
def test_indices_of_any_sample_size_are_scipy_s(sampled, log2, count):
    """By scipy's own estimator from 8192 other points; each column is drawn from the sequence's first points."""
    expansion = expanded(sampled | {"uncertainty": {"log2_samples": log2, "seed": 5}})
    assert expansion.study.uncertainty.samples == count
    assert np.array_equal(sequence(3, count, 5), sequence(3, 1024, 5)[:count])
    (method,) = methods_of(expansion)
    pressure = pressure_of(expansion, method, "filling", depths_in_metres(expansion))
    whole = np.array([True, True])
    right = sobol_indices(
        func=lambda points: pressure(points.T)[0].max(axis=1), n=8192, dists=[uniform()] * len(SAMPLED), rng=7
    )
    found = indices(pressure, whole, expansion.study.uncertainty)
    assert np.abs(found - np.array([right.first_order, right.total_order])).max() < 0.02
    assert found[1].max() > 0.3


def test_close_to_the_surface_the_pressure_is_k_gamma_z(sampled):
    """There only K (log-uniform) and the unit weight (uniform) matter, and quantiles and indices follow by hand."""
    sampled["depth_m"] = [0.0005, 0.001]
    cube = uncertainty_cube(expanded(sampled)).sel(pressure_method="janssen", phase="filling")
    a_k, low = 1.11, 7500 / 9000
    share_k, share_w = np.random.default_rng(1).random((2, 2_000_000))
    pressure = 0.54 * a_k ** (2 * share_k - 1) * 9000 * (low + (1 - low) * share_w) * 0.001
    assert cube["wall_normal_pressure_quantile"][:, -1].values == pytest.approx(
        np.quantile(pressure, [0.05, 0.5, 0.95]), rel=2e-3
    )
    own_k = np.var(a_k ** (2 * share_k - 1)) / np.mean(a_k ** (2 * share_k - 1)) ** 2
    own_w = np.var(low + (1 - low) * share_w) / np.mean(low + (1 - low) * share_w) ** 2
    variance = (1 + own_k) * (1 + own_w) - 1  # of a product of independent factors, over its mean squared
    first = dict(zip(SAMPLED, cube["sobol_first"].values, strict=True))
    assert first["lateral_pressure_ratio"] == pytest.approx(own_k / variance, abs=0.01)
    assert first["unit_weight"] == pytest.approx(own_w / variance, abs=0.01)
    assert abs(first["wall_friction"]) < 0.01
    total = cube["sobol_total"].values
    assert np.all(total >= cube["sobol_first"].values - 0.02)


def test_samples_stay_between_lower_and_upper(sampled):
    expansion = expanded(sampled)
    base = spreads(expansion)
    one = {name: np.array([1.0]) for name in (*SAMPLED, "hopper_wall_friction", "unit_weight_lower", "a_phi", "a_K", "a_mu")}
    one["internal_friction_angle"] = np.array([0.9])
    ends = scattered(one, base, np.array([[0.0] * 4, [1.0] * 4]))
    assert ends["lateral_pressure_ratio"].ravel() == pytest.approx([1 / 1.11, 1.11])
    assert ends["unit_weight"].ravel() == pytest.approx([7.5 / 9, 1.0])
    assert ends["internal_friction_angle"].ravel() == pytest.approx([0.9 / 1.12, 0.9 * 1.12])
    assert ends["wall_friction"].ravel() == pytest.approx([1 / 1.16, 1.16])
    low, high = scattered(one | {"wall_friction": np.array([1.3])}, base, np.array([[0, 1, 0, 0], [1, 1, 0, 0]]))[
        "wall_friction"
    ]
    assert float(low[0]) == pytest.approx(np.tan(0.9 / 1.12))  # never above tan(phi) of the same sample
    assert float(high[0]) == pytest.approx(min(1.3 * 1.16, np.tan(0.9 * 1.12)))


def test_masked_quantiles_say_why(sampled):
    """Deutsch speaks for one silo alone, ACI not for so wide a bin, Janssen not of discharge."""
    content = sampled | {"methods": ["janssen", "aci313_1977", "deutsch"], "phases": ["filling", "discharge"]}
    cube = uncertainty_cube(expanded(content | {"uncertainty": {"log2_samples": 6, "seed": 5}}))
    flags = cube["wall_normal_pressure_quantile_scope"]
    assert flags.dims == cube["wall_normal_pressure_quantile"].dims
    np.testing.assert_array_equal(flags == 0, cube["wall_normal_pressure_quantile"].notnull())
    meanings = flags.attrs["flag_meanings"].split()
    told = {name: [meanings[i] for i in flags.sel(pressure_method=name).values[:, 0, 0]] for name in ("janssen", "deutsch")}
    assert told == {"janssen": ["in_scope", "phase_not_covered"], "deutsch": ["phase_not_covered", "outside_published_range"]}
    assert missing(cube) == ["not shown, a sample masked (outside published range): 3  ACI 313-77, 11  Deutsch"]
    surface = {"pressure_method": 0, "phase": 0, "depth": 0}
    cube["wall_normal_pressure_quantile"][surface], flags[surface] = np.nan, meanings.index("solid_property_missing")
    assert missing(cube)[0] == "shown in part, a sample masked (solid property missing): 6  Janssen"


def test_spreads_must_be_known(study):
    study["uncertainty"] = {}
    with pytest.raises(BadInput, match=r"small.yaml: scene.properties.a_phi = None: solid wheat_benchmark has none"):
        expanded(study)


def test_one_silo_only(sampled):
    sampled["sweep"] = [{"axis": "d", "values": {"silo.diameter_m": [3.0, 4.0]}}]
    with pytest.raises(BadInput, match="uncertainty needs a study without sweep"):
        study_of(sampled, "small.yaml")
