"""Effective mass from first principles: what shaken contents hand to the walls and the floor of their box."""

import numpy as np

from silostudy.seismic.family import MassRule

LEAST_SHARE = 0.5  # of the contents that must move with the box to count as added mass


def carried_share(force, acceleration, *, mass):
    """Share (1, complex) of the contents' inertia that a force (N) carries, under a base acceleration (m s-2) sampled alike.

    Real part: in phase with the acceleration; imaginary part: a quarter period ahead of it.  The least-squares answer
    over the record: cross-spectrum over power spectrum, means taken off; for a sine it is the ratio of the two phasors.
    """
    pushed = np.fft.rfft(force - np.mean(force, axis=-1, keepdims=True), axis=-1)
    shaken = np.fft.rfft(acceleration - np.mean(acceleration))
    return (pushed * np.conj(shaken)).sum(axis=-1) / (mass * (np.abs(shaken) ** 2).sum())


def equivalent_damping(share):
    """Damping ratio (1) of contents that carry `share` (1, complex): energy lost in a cycle over 4 pi times the kinetic energy.

    A force in phase with the velocity, which lags the acceleration by a quarter period, takes energy out of the motion.
    NaN where less than LEAST_SHARE moves with the box: near and beyond their own frequency the contents are no added mass.
    """
    moved = np.real(share)
    return np.where(moved >= LEAST_SHARE, -np.imag(share) / (2 * np.where(moved == 0, 1, moved)), np.nan)


def wall_carried_ring(static_wall_force, *, weight, wall_friction):
    """Effective mass coefficient (1) when only the ring moves with the wall that wall friction can carry.

    Source: silvestri_ring, in its simplest form: friction times the static wall pressure, summed over the wall (N), over
    the weight (N), at most 1; for a constant ratio of pressures in a circular silo that is mu K H / R.
    """
    return np.minimum(1.0, wall_friction * np.asarray(static_wall_force) / weight)


ROW = MassRule(
    key="wall_carried_ring",
    rank=60,
    title="The ring that wall friction carries",
    source="silvestri_ring",
    locator="simplest form",
    function=wall_carried_ring,
    formula="C_eff = min(1, mu N / W): static wall pressure summed N, weight W; mu K H / R where p_h = K gamma z",
    needs=("static wall force (N)", "contents' weight (N)", "wall friction coefficient (1)"),
    validity="a core that carries itself; shown beside shaken discs in the studies of kind grains",
)
