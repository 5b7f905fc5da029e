"""Anchors at the foot of an empty or shaken silo."""

import numpy as np

from silostudy.checks.family import SUPPORT, SteelCheck
from silostudy.limits import Limit, Measure


def tension(bending, lift, *, inner_radius, circle_diameter, anchor_count):
    """Tension (N) of one anchor: 4 M/(n d) + 2 pi r lift/n, at least 0. Source: statics, two codes of tanks.

    bending: M/(pi r^2) (N/m) in the wall; lift: what else pulls there (N/m), a weight negative; the anchors' circle d need not
    be the wall's.
    """
    round_wall = 2 * np.pi * inner_radius / anchor_count
    return np.maximum((bending * 2 * inner_radius / circle_diameter + lift) * round_wall, 0.0)


def acting(*, anchor_tension):
    """Tension (N) of the anchor that is drawn most. Source: statics, two codes of tanks."""
    return anchor_tension


def resistance(*, anchor_resistance):
    """Tension (N) that an anchor bears: given by the user, a design value. Source: the study."""
    return anchor_resistance


def _count(*, anchor_count):
    return anchor_count


ROW = SteelCheck(
    key="anchors",
    part=SUPPORT,
    title="anchors, uplift",
    source="as_nzs_1170_2",
    locator="App. C for the wind round the wall; else statics",
    effect=acting,
    resistance=resistance,
    unit="N",
    limits=(Limit(measure=Measure("n", "1", _count), least=8.0, why="fewer anchors are no elastic ring; two codes of tanks"),),
    acts_in=frozenset({"wind", "earthquake"}),
    idle_with=frozenset({"wind", "solids"}),  # the empty silo lifts as much, and nothing of the solid is counted
    formula="4 M/(n d) - W/n <= F_Rd, W the structure's weight alone; wind also lifts by q L^2/(2 r) kappa sum m^2 C_m "
    "from m = 2 (membrane theory), kappa 1/4 where the top is held round, 1 where it is free",
    validity="the contents do not hold the wall down, which is safe; wind's harmonics of AS/NZS 1170.2 for a closed cylinder "
    "as high as wide (two copies); the wind's lift leaves out the bending stiffness of the wall, which is safe",
)
