"""The stability map: the step found by bisection is never below the engine's bound, and the figure says what it shows."""

import copy

import numpy as np
import pandas as pd
import pytest

from silostudy.accuracy.peers import available
from silostudy.accuracy.stability import stability_cube
from silostudy.accuracy.stability_map import largest_step, peer_step, settled
from silostudy.errors import BadInput
from silostudy.figures.stability_map import draw
from tests.conftest import expanded

RESTING = {
    "kind": "stability",
    "title": "resting discs",
    "scene": {
        "network": "rows",
        "radius_m": 0.01,
        "density_kg_m3": 2650.0,
        "discs": {"normal_stiffness_N_m2": 9.46e6, "damping_ratio": 0.7, "sliding_friction": 0.577},
    },
    "sweep": [
        {"axis": "network", "values": {"network": ["column", "hexagonal"]}},
        {"axis": "damping", "values": {"discs.damping_ratio": [0.1, 1.0]}},
        {"axis": "march", "points": [
            {"integrator": "17-18", "discs.normal": "spring-dashpot", "discs.tangential": "spring-slider"},
            {"integrator": "17-19", "discs.normal": "spring-dashpot-implicit", "discs.tangential": "spring-slider-implicit"},
        ]},
    ],
    "trial_steps": 5000,
}  # fmt: skip


@pytest.fixture(scope="module")
def cube():
    return stability_cube(expanded(copy.deepcopy(RESTING)))


def test_the_bound_is_one_and_is_sharp(cube):
    ratio = (cube["stable_step"] / cube["stability_bound"]).to_numpy()
    assert ratio.min() > 0.985  # the bisection closes in to one per cent
    assert ratio.max() < 1.1
    assert cube["contact_number"].sel(network="column").to_numpy() == pytest.approx(1.9)
    assert float(cube["contact_number"].sel(network="hexagonal").min()) > 4.5


def test_semi_implicit_dashpots_and_smoothed_increments_pay_where_damping_is_strong(cube):
    plain, implicit = (cube["stable_step"].isel(march=march).sel(network="hexagonal") for march in (0, 1))
    assert float(implicit.sel(damping=1.0)) > 4.0 * float(plain.sel(damping=1.0))
    assert float(implicit.sel(damping=0.1)) < float(plain.sel(damping=0.1))


def test_the_bisection_finds_an_edge():
    assert largest_step(lambda dt: dt < 0.3, 0.01, 1e-3) == pytest.approx(0.3, rel=1.1e-3)
    assert largest_step(lambda dt: dt < 0.3, 5.0, 1e-3) == pytest.approx(0.3, rel=1.1e-3)
    assert np.isnan(largest_step(lambda dt: True, 1.0, 1e-3))
    assert np.isnan(largest_step(lambda dt: False, 1.0, 1e-3))


def test_the_figure_has_a_panel_a_network_and_names_its_axes(cube, tmp_path, monkeypatch):
    seen = []
    monkeypatch.setattr("silostudy.figures.stability_map.save", lambda figure, numbers, stem: seen.append((figure, numbers)))
    draw(cube, tmp_path / "map")
    figure, numbers = seen[0]
    assert [panel.get_title().split("\n")[0] for panel in figure.axes] == ["column", "hexagonal"]
    assert figure.axes[0].get_ylabel() == "largest stable step (ms)"
    assert "(1)" in figure.axes[0].get_xlabel()
    assert len(figure.axes[0].lines) == 4  # bound and marks of two ways; LAMMPS was not asked for
    assert isinstance(numbers, pd.DataFrame)
    assert (numbers["found_over_bound"] > 0.98).all()


def test_mistakes():
    with pytest.raises(BadInput, match="'disc', 'column', 'rows' or 'hexagonal'"):
        expanded(copy.deepcopy(RESTING) | {"scene": RESTING["scene"] | {"network": "square"}, "sweep": []})
    with pytest.raises(BadInput, match="resolution"):
        expanded(copy.deepcopy(RESTING) | {"resolution": 0.0})


@pytest.mark.skipif(bool(available()), reason=available())
def test_lammps_takes_the_step_of_the_plain_march():
    """It looks at dashpots with half-step speeds, which makes its velocity Verlet the march (17), (18) in rows of discs."""
    (case,) = expanded(copy.deepcopy(RESTING) | {"sweep": []}).cases
    rest = settled(case.scene.calm)
    kick = 1e-5 * np.random.default_rng(0).standard_normal((len(rest.places), 3))
    step = peer_step(case.scene.calm, case.scene.model, rest, kick, 3000, 0.02)
    assert step == pytest.approx(5.3e-5, rel=0.05)
