"""The engine against a transcription of the source's algorithm, and what its incremental springs change in the findings."""

import numpy as np
import pytest

from silostudy.compute.packing_measure import NORMAL, cells_of
from silostudy.compute.packing_run import settle
from silostudy.scene.packing import contacts_of, discs_of
from silostudy.tables import kiyama_1983 as kiyama
from silostudy.tables.constants import STANDARD_GRAVITY
from tests.conftest import expanded
from tests.test_packing.literal import march

STUDY = {"kind": "packing", "title": "the source's own words", "scene": {"across": 18}, "runs": 3}


def let_out(across: int, run: int, *, incremental: bool, smoothed: bool, dt: float) -> tuple[float, float]:
    """Largest contact force on the side walls (N/m) after 1.2 s of rest, and in 0.4 s of discharge over that."""
    expansion = expanded({**STUDY, "scene": {"across": across}})
    config = expansion.cases[0].scene.config
    pair = contacts_of(config)[0].coefficients
    x, y, _ = (values.copy() for values in discs_of(expansion.study, config, run))
    mass = config.discs.density_kg_m3 * np.pi * kiyama.RADIUS**2
    springs = pair["normal_stiffness"], pair["normal_damping"], kiyama.STIFFNESS_RATIO
    laws = (kiyama.RADIUS, mass, kiyama.SILO_WIDTH, STANDARD_GRAVITY, *springs, kiyama.DISC_FRICTION, kiyama.WALL_FRICTION, dt)
    _, rest = march(x, y, *laws, round(1.2 / dt), incremental, smoothed, -1.0)
    peak, _ = march(x, y, *laws, round(0.4 / dt), incremental, smoothed, kiyama.SLIT_WIDTH / 2)
    return rest, peak / rest


def test_engine_rests_where_the_transcription_does():
    expansion = expanded(STUDY)
    rested = settle(expansion.study, expansion.cases[0].scene.config, 0)
    engine = rested.walls[cells_of(rested).sides][..., NORMAL].max()
    rest, _ = let_out(18, 0, incremental=False, smoothed=False, dt=2.5e-5)
    assert rest == pytest.approx(engine, rel=1e-3)


@pytest.mark.long
@pytest.mark.parametrize(("incremental", "smoothed", "dt"), [(True, False, 2.5e-5), (False, False, 2.5e-5), (True, True, 1e-4)])
def test_peaks_in_any_step_do_not_hang_on_the_springs(incremental, smoothed, dt):
    """In 17/18 single contacts peak beyond the printed 2 to 5 times static, in 11/12 they do not, whatever the springs."""
    settings = {"incremental": incremental, "smoothed": smoothed, "dt": dt}
    active, passive = (np.median([let_out(across, run, **settings)[1] for run in (1, 2, 3)]) for across in (18, 12))
    assert 5.0 < active < 20.0
    assert passive < 3.0
