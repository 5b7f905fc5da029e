"""A ring beam on equally spaced columns under an even vertical load, by statics."""

import numpy as np

from silostudy.checks.family import SUPPORT, SteelCheck


def support_moment(*, support_force, inner_radius, column_count):
    """Moment (N m) over a column, hogging: q R^2 (1 - ph cot ph), ph = pi/n. Source: statics, two tables of circular beams."""
    half = np.pi / column_count
    return support_force * inner_radius**2 * (1 - half / np.tan(half))


def midspan_moment(*, support_force, inner_radius, column_count):
    """Moment (N m) midway, sagging: q R^2 (ph/sin ph - 1). Source: statics, two tables of circular beams."""
    half = np.pi / column_count
    return support_force * inner_radius**2 * (half / np.sin(half) - 1)


def shear_force(*, support_force, inner_radius, column_count):
    """Shear force (N) beside a column: q R ph. Source: statics, two tables of circular beams."""
    return support_force * inner_radius * np.pi / column_count


def largest_torque(*, support_force, inner_radius, column_count):
    """Largest torque (N m): q R^2 (ph sin s/sin ph - s), cos s = sin(ph)/ph. Source: statics, two tables of circular beams."""
    half = np.pi / column_count
    place = np.arccos(np.sin(half) / half)
    return support_force * inner_radius**2 * (half * np.sin(place) / np.sin(half) - place)


def stress(*, support_force, inner_radius, column_count, section_modulus):
    """Bending stress (Pa) of the beam over a column: M / W. Source: statics."""
    moment = support_moment(support_force=support_force, inner_radius=inner_radius, column_count=column_count)
    return moment / section_modulus


def yield_strength(*, yield_stress, partial_yield):
    """Stress (Pa) at which the beam yields: f_y / gamma_M0. Source: en1993_4_1, two programs for gamma_M0."""
    return yield_stress / partial_yield


ROW = SteelCheck(
    key="ring_beam",
    part=SUPPORT,
    title="ring beam on columns, bending",
    source="en1993_4_1",
    locator="ring girder, statics",
    effect=stress,
    resistance=yield_strength,
    formula="q R^2 (1 - ph cot ph)/W <= f_y/gamma_M0, ph = pi/n; moments, shear and torque stand in the cube",
    validity="equal spans, three columns at least, a beam of one section whose centre lies under the wall; even load, which "
    "only a stiff ring gives: the wall's local stress above a column, the ring's thrust and torsion are not checked; two "
    "printed tables agree with the statics",
)
