"""Tests that Sasaki and Yoshimura print, and what their numbers say about each other."""

from dataclasses import dataclass
from math import nan

from silostudy.tables.read import HERE, rows


@dataclass(frozen=True, kw_only=True)
class PrintedTest:
    """One test of the source in SI units; NaN where it prints nothing."""

    test: str
    peak_acceleration: float
    empty_frequency: float
    full_frequency: float
    stiffness_reduction: float
    effective_mass_coefficient: float
    source: str
    locator: str
    damping_ratio: float = nan

    @property
    def implied_mass_ratio(self) -> float:
        """Contents' mass over wall mass (1) with which the printed frequencies and coefficient agree, at equal stiffness.

        Source: sasaki_yoshimura_effective_mass, equation (1): f_empty^2 / f_full^2 = 1 + C_eff rho_s r / rho_w.
        """
        return ((self.empty_frequency / self.full_frequency) ** 2 - 1) / self.effective_mass_coefficient


def printed_tests() -> dict[str, PrintedTest]:
    """The source's tests by name."""
    tests = rows(HERE / "sasaki_1991.csv", text=("test",))
    return {raw["test"]: PrintedTest(**{name: value for name, value in raw.items() if name != "where"}) for raw in tests}


def printed_at(peak_acceleration: float) -> PrintedTest | None:
    """The earthquake test of the source with this peak base acceleration (m s-2), if there is one."""
    earthquakes = (test for name, test in printed_tests().items() if name != "sine")
    return next((test for test in earthquakes if abs(test.peak_acceleration / peak_acceleration - 1) < 1e-6), None)
