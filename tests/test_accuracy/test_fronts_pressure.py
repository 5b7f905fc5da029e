"""The fronts of pressure studies: numbers that errors go with, and trials on studies that they were not measured on."""

import numpy as np
import pytest

from silostudy.accuracy import fronts_pressure, fronts_samples
from silostudy.accuracy.fronts_levels import Curve, studies, trials_of
from silostudy.choice.pressure import LEVELS, integral_number, kink_number, peak_number

Z = np.linspace(0.0, 1.0, LEVELS)


def test_numbers_of_curves():
    """A parabola's single trapezoid errs by half of its integral; a peak loses an eighth of its curvature."""
    assert integral_number(Z**2) == pytest.approx(0.5, rel=1e-4)
    assert peak_number(4 - (Z - 0.4) ** 2) == pytest.approx(2 / 8 / 4, rel=1e-4)
    assert peak_number(Z) == 0
    assert kink_number(Z * (2 - Z)) == 0
    tent = np.minimum(3 * Z, 3 - 2 * Z * 1.5)
    assert kink_number(tent) == pytest.approx(1.5 / 1.5)
    assert peak_number(tent) == 0
    assert kink_number(np.minimum(3 * Z, 1.0)) == 0  # a plateau to the foot, which is a level


@pytest.mark.long
@pytest.mark.parametrize("quantity", fronts_pressure.QUANTITIES, ids=lambda quantity: quantity.name)
def test_levels_meet_what_was_asked_on_other_silos(quantity):
    """With few more levels than would have met it."""
    found = trials_of(quantity, studies(1, 50, 4), lambda text: None)
    assert len(found) >= 20
    assert np.mean([trial.met for trial in found]) >= 0.95
    assert np.mean([trial.setting <= 1.5 * trial.least for trial in found]) >= 0.8


def test_no_study_of_the_trial_was_measured_on():
    measured = [content["scene"] for content in studies(0, fronts_pressure.MEASURED)]
    assert not any(content["scene"] in measured for content in studies(1, fronts_pressure.UNSEEN, 4))


def test_an_integral_over_a_jump():
    """1 above a depth that no panel's end meets, 3 below."""
    curve = Curve(lambda z: np.where(z < 0.7123, 1.0, 3.0), {}, 2.0)
    assert curve.integrals()[-1] == pytest.approx(0.7123 + 3 * (2.0 - 0.7123), rel=1e-9)


@pytest.mark.long
def test_samples_meet_what_was_asked_of_other_solids():
    found = fronts_samples.trials(lambda text: None)
    assert np.mean([trial.met for trial in found]) >= 0.95
    assert np.median([trial.setting / trial.least for trial in found]) <= 2


def test_quantile_of_a_solid_that_hardly_scatters_is_its_mean():
    solid = next(fronts_samples.solids(0, 1, 1.5))
    still = fronts_samples.Solid(solid.means, solid.depth, 1 + 1e-9, 1 + 1e-9, 1 - 1e-9)
    np.testing.assert_allclose(fronts_samples.exact(still), still.pressure(still.depths, 1.0, 1.0, 1.0), rtol=1e-8)
