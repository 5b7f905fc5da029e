"""The contents as mass added to the wall, and what a change of frequency says about them."""

from silostudy.seismic.family import MassRule


def volume_ratio(*, radius, thickness):
    """Contents' volume over wall volume (1) of a tube with mid-wall radius (m) and wall thickness (m).

    Source: sasaki_yoshimura_effective_mass, equation (2); exact with R as the mid-wall radius.
    """
    p = thickness / (2 * radius)
    return (1 - p) ** 2 / (4 * p)


def equivalent_density(coefficient, *, wall_density, contents_density, volume_ratio):
    """Density (kg m-3) of a wall that carries the share `coefficient` of the contents' mass.

    Source: sasaki_yoshimura_effective_mass, equation (1).
    """
    return wall_density + coefficient * contents_density * volume_ratio


def mass_ratio(*, wall_density, contents_density, volume_ratio):
    """Contents' mass over wall mass (1) of a tube filled over its whole height.

    Source: sasaki_yoshimura_effective_mass, equation (1): rho_s r / rho_w.
    """
    return contents_density * volume_ratio / wall_density


def stiffness_reduction(measured_frequency, unreduced_frequency):
    """Stiffness reduction alpha (1) that brings the empty tube's frequency (Hz) to the measured one (Hz).

    Source: sasaki_yoshimura_effective_mass, section 3; exact because alpha scales the whole stiffness.
    """
    return (measured_frequency / unreduced_frequency) ** 2


def coefficient_from_shift(empty_frequency, full_frequency, *, mass_ratio):
    """Effective mass coefficient (1) from two frequencies (Hz) of a tube filled over its whole height.

    Source: sasaki_yoshimura_effective_mass, equation (1): with equal stiffness f_empty^2 / f_full^2 is rho_e / rho_w.
    """
    return ((empty_frequency / full_frequency) ** 2 - 1) / mass_ratio


ROW = MassRule(
    key="resonance_shift",
    rank=10,
    title="Shift of the first frequency by filling",
    source="sasaki_yoshimura_effective_mass",
    locator="section 3, equations (1) and (2)",
    function=coefficient_from_shift,
    formula="C_eff = ((f_empty / f_full)^2 - 1) / (rho_s r / rho_w), r = (1 - p)^2 / (4 p), p = h / 2R",
    needs=("empty frequency (Hz)", "full frequency (Hz)", "contents' mass over wall mass (1)"),
    validity="equal stiffness empty and full; filled over the whole height (else the beam is solved for it)",
)
