"""Words for computing times."""

import pytest

from silostudy.scene.costs import told_time


@pytest.mark.parametrize(
    ("seconds", "told"), [(0.3, "0.005 min"), (7140.0, "119 min"), (7200.0, "2.0 h"), (15000.0, "4.2 h"), (3.6e5, "100.0 h")]
)
def test_computing_times_are_told_in_minutes_and_from_two_hours_on_in_hours(seconds, told):
    assert told_time(seconds) == told
