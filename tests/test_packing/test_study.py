"""The packing study: forces at rest against statics and Janssen, arches and their remedy, ensembles that repeat bit by bit."""

import numpy as np
import pandas as pd
import pytest

from silostudy.choice.expand import expand_file
from silostudy.compute.arch import find_arch
from silostudy.compute.motion import motion_cube
from silostudy.compute.packing import packing_cube
from silostudy.compute.packing_measure import NORMAL, SHEAR, cells_of, fit_janssen, janssen_force, layers, seen
from silostudy.compute.packing_run import WINDOW, settle
from silostudy.dem.engine import Engine
from silostudy.dem.model import Wall
from silostudy.errors import BadInput
from silostudy.figures import packing_slit
from silostudy.figures.packing_against_codes import code_factors
from silostudy.figures.packing_findings import findings, verdict
from silostudy.tables.claims import kiyama_1983
from silostudy.tables.constants import STANDARD_GRAVITY
from silostudy.tables.kiyama_1983 import DENSITY, RADIUS
from tests.conftest import ROOT, expanded
from tests.test_dem.scenes import free

CONTENT = {
    "kind": "packing",
    "title": "a few discs, let out",
    "scene": {"across": 18, "disc_count": 200},
    "sweep": [
        {"axis": "packing", "values": {"across": [12, 19]}},
        {"axis": "removal", "values": {"remedy": [False, True]}},
    ],
    "runs": 2,
    "discharge_s": 0.6,
    "stopped_s": 0.1,
    "rest_limit_s": 2.0,
    "detailed": [{"across": 19, "run": 0}],
}


@pytest.fixture(scope="module")
def cube():
    return packing_cube(expanded(CONTENT))


@pytest.fixture(scope="module")
def motion():
    return motion_cube(expanded(CONTENT))


@pytest.fixture(scope="module")
def rested():
    expansion = expanded(CONTENT)
    return settle(expansion.study, expansion.cases[0].scene.config, 0)


def test_a_filling_of_few_rows_has_its_numbers_or_none():
    """Five rows need not touch the wall in their lowest quarter: no friction in the corner to speak of."""
    few = CONTENT | {"scene": {"across": 18, "disc_count": 87}, "sweep": [], "runs": 1, "detailed": []}
    found = packing_cube(expanded(few))
    assert np.isfinite(found["rest_side_share"]).all()
    assert np.isnan(found["rest_corner_shear"]).any()


def test_floor_and_walls_carry_the_weight(rested):
    cells = cells_of(rested)
    carried = rested.walls[cells.floor, NORMAL].sum() + rested.walls[cells.sides][..., SHEAR].sum()
    assert carried == pytest.approx(rested.model.mass.sum() * STANDARD_GRAVITY, rel=1e-5)
    assert rested.rested


def test_ideal_start_is_symmetric(rested):
    left, right = rested.walls[cells_of(rested).sides][..., NORMAL]
    assert left == pytest.approx(right, rel=1e-4, abs=1e-4 * left.max())


def test_windows_are_whole_steps(rested):
    assert WINDOW / rested.model.dt == pytest.approx(round(WINDOW / rested.model.dt), rel=1e-12)


def test_janssen_force_is_its_pressure_summed():
    law = {"unit_weight": 2e4, "hydraulic_radius": 0.2, "wall_friction": 0.3, "lateral_ratio": 0.5}
    z, h = 0.3, 1e-5
    slope = (janssen_force(z + h, **law) - janssen_force(z - h, **law)) / (2 * h)
    pressure = 2e4 * 0.2 / 0.3 * (1 - np.exp(-0.3 * 0.5 * z / 0.2))
    assert slope == pytest.approx(pressure, rel=1e-8)


def test_fit_finds_a_known_janssen_law():
    law = {"unit_weight": 2e4, "hydraulic_radius": 0.2}
    depth = np.linspace(0.01, 1.5, 60)
    edges = np.r_[0.0, 0.5 * (depth[1:] + depth[:-1]), depth[-1]]
    force = np.diff(janssen_force(edges, wall_friction=0.3, lateral_ratio=0.5, **law))
    assert fit_janssen(force, depth, **law) == pytest.approx((0.5, 0.3, 0.0), rel=1e-5, abs=1e-5)


def test_layers_sum_their_cells():
    cells = np.arange(40.0)
    assert layers(np.stack([cells, 2 * cells]))[1].tolist() == (2 * cells.reshape(10, 4).sum(axis=1)).tolist()


def over_slit(lift: float) -> Engine:
    """Five discs that span a slit of 5 cm, feet on the floor's halves, and one apart; the roof raised by `lift` (m)."""
    walls = (Wall("floor_left", (-0.3, 0.0), (-0.025, 0.0)), Wall("floor_right", (0.025, 0.0), (0.3, 0.0)))
    x = [-0.03, -0.0165, 0.0, 0.0165, 0.03, 0.2]
    y = [0.0099, 0.0245, 0.0355 + lift, 0.0245, 0.0099, 0.3]
    engine = Engine(free(x, y, walls=walls))
    engine.step_to(0)
    return engine


def test_arch_is_the_chain_over_the_slit():
    arch = find_arch(over_slit(0.0))
    assert arch is not None
    assert (arch.discs, arch.roof) == ((0, 1, 2, 3, 4), 2)
    assert (arch.span, arch.height) == pytest.approx((0.06, 0.0355), rel=1e-12)
    assert find_arch(over_slit(1e-3)) is None  # the roof touches its neighbours no more


def test_rarer_looks_see_smaller_peaks():
    force = np.array([[1.0, 2.0], [9.0, 3.0], [4.0, 5.0], [1.0, 1.0]] * 25)
    found = seen(force, 2 * force)
    assert found.tolist() == [18.0, 9.0, 9.0, 9.0, 1.0, 9.0, 1.0]  # every step, then each 1, 5, 10, 20, 50, 100 windows
    assert found[0] >= found[1:].max()


def test_opening_lets_discs_out_and_arches_stop_them(cube):
    stopped = cube["flow_stopped"].isel(removal=0)
    assert np.all(stopped.isel(packing=1) == 1)  # 18/19 is blocked by its own order
    passed = cube["passed_discs"]
    assert np.all(np.diff(passed.values, axis=-1) >= 0)
    assert np.all(passed.isel(sample=0) == 0)
    assert np.all(passed.isel(packing=0, removal=0, sample=-1) > 10)


def test_remedy_takes_discs_out_where_the_flow_stopped(cube):
    without, treated = (cube.isel(packing=1, removal=k) for k in (0, 1))
    assert np.all(without["discs_removed"] == 0)
    assert np.all(treated["discs_removed"] >= 1)
    assert np.all(treated["stop_time"] == without["stop_time"])
    before = int(float(without["stop_time"].max()) * 100)
    assert np.array_equal(treated["passed_discs"][:, :before], without["passed_discs"][:, :before])


def test_side_walls_feel_flat_packings_most(cube):
    share = cube["rest_side_share"].isel(removal=0)
    assert np.all(share.isel(packing=0) > 2 * share.isel(packing=1))


def test_runs_differ_and_repeat(cube):
    passed = cube["passed_discs"].isel(packing=0, removal=0).values
    assert not np.array_equal(passed[1], passed[2])
    assert packing_cube(expanded(CONTENT)).identical(cube)


def test_film_is_the_run_of_the_ensemble(cube, motion):
    film = int(np.flatnonzero((motion["film_across"] == 19) & (motion["film_remedy"] == 1))[-1])
    shots = np.flatnonzero(motion["snapshot_film"] == film)
    below = [int((~(motion["disc_y"][shot] > 0)).sum()) for shot in shots]
    start = below[0]
    removed = float(cube["discs_removed"].isel(packing=1, removal=1, run=0))
    passed = cube["passed_discs"].isel(packing=1, removal=1, run=0).values
    assert below[-1] - start == passed[-1] + removed


def test_film_at_rest_holds_the_fill(motion):
    rest = int(np.flatnonzero(motion["film_across"] == 12)[0])
    shot = int(np.flatnonzero(motion["snapshot_film"] == rest)[0])
    here = motion["contact_snapshot"].values == shot
    wall = here & (motion["contact_on_wall"].values == 1)
    weight = np.isfinite(motion["disc_x"][shot]).sum() * np.pi * RADIUS**2 * DENSITY * STANDARD_GRAVITY
    assert motion["contact_force_y"].values[wall].sum() == pytest.approx(float(weight), rel=1e-5)


@pytest.mark.parametrize(
    ("change", "told"),
    [
        ({"silo": {"slit_width_m": 0.4}}, "slit_width_m = 0.4: must be below the floor"),
        ({"disc_count": 500}, "disc_count = 500: fills"),
        ({"disc_count": 60}, "disc_count = 60: lays 3 rows"),
        ({"discs": {"radius_m": 0.004}}, "radius_m = 0.004"),
        ({"across": 30}, "across = 30: 30 discs"),
        ({"march": {"normal": "line-contact"}}, "march.normal = 'line-contact': must be 'spring-dashpot'"),
    ],
)
def test_mistakes_are_told(change, told):
    with pytest.raises(BadInput, match=told.replace("(", r"\(")):
        expanded({**CONTENT, "sweep": [], "scene": {**CONTENT["scene"], **change}})


def test_animation_shows_every_other_snapshot(motion, tmp_path):
    from PIL import Image

    from silostudy.figures import packing_motion

    packing_motion.draw(motion.isel(snapshot=motion["snapshot_film"] != 3), tmp_path / "motion")
    with Image.open(tmp_path / "motion.webp") as image:
        assert image.format == "WEBP"
        assert image.n_frames > 1


def test_findings_judge_every_claim(cube):
    table = findings(cube)
    assert set(table["claim"]) == {claim.claim for claim in kiyama_1983()} - {
        claim.claim for claim in kiyama_1983() if claim.across == 18
    }
    falls = table[table["claim"].str.startswith("side-wall force falls")].iloc[0]
    assert falls["median"] == 1
    assert falls["verdict"] == "reproduced"
    assert table["runs"].max() == 2


def test_verdict_follows_from_the_runs():
    assert [verdict(meet, 10) for meet in (0, 1, 2, 7, 8, 10)] == [
        "not reproduced", "not reproduced", "in some runs", "in some runs", "reproduced", "reproduced",
    ]  # fmt: skip
    assert verdict(0, 0) == "no run to judge by"


def test_codes_of_the_table_raise_static_janssen():
    factors = code_factors()
    assert factors["aij_load_draft"] == pytest.approx(2.6, rel=1e-3)
    assert min(factors.values()) > 1.0


def test_beverloo_fit_finds_known_constants():
    slit = np.array([0.04, 0.06, 0.08, 0.12])
    law = {"density": 1800.0, "diameter": 0.02}
    known = packing_slit.rate(slit, 0.6, 1.3, **law)
    assert packing_slit.fit(slit, known, np.full(4, 9), **law) == pytest.approx((0.6, 1.3), rel=1e-6)
    assert packing_slit.rate(0.02, 0.6, 1.3, **law) == 0.0
    near, far = (packing_slit.rate(0.02 + free, 0.6, 1.0, **law) for free in (0.03, 0.06))
    assert far / near == pytest.approx(2**1.5, rel=1e-12)
    assert np.isnan(packing_slit.fit(slit[:2], known[:2], np.full(2, 9), **law)).all()


def test_slits_share_a_filling(tmp_path):
    """A sweep over the slit: wider slits let more out; the figure and its fit are drawn."""
    content = {**CONTENT, "runs": 1, "detailed": [], "sweep": [
        {"axis": "packing", "values": {"across": [12]}}, {"axis": "slit", "values": {"silo.slit_width_m": [0.06, 0.1, 0.14]}},
    ]}  # fmt: skip
    cube = packing_cube(expanded(content))
    assert len(np.unique(cube["rest_side_share"].isel(run=1))) == 1
    assert np.all(np.diff(cube["passed_discs"].isel(packing=0, run=1, sample=-1)) > 0)
    packing_slit.draw(cube, tmp_path / "slit")
    assert set(pd.read_csv(tmp_path / "slit.csv")["runs"]) == {1}


def test_studies_are_valid():
    for path in sorted((ROOT / "config/studies").glob("kiyama-1983*.yaml")):
        assert expand_file(path).cases
