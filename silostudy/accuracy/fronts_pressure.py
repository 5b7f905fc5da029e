"""The fronts of pressure studies: depth levels for what is integrated or sought along a wall, samples for a quantile."""

from collections.abc import Callable

from silostudy.accuracy import fronts_levels, fronts_samples
from silostudy.accuracy.trial import Trial


def measured_fronts(tell: Callable[[str], None]) -> list[dict]:
    """Rows of tables/fronts.csv."""
    return fronts_levels.measured_fronts(tell) + fronts_samples.measured_fronts(tell)


def trials(tell: Callable[[str], None]) -> list[Trial]:
    """How the shipped fronts' choices do on studies that they were not measured on."""
    return fronts_levels.trials(tell) + fronts_samples.trials(tell)
