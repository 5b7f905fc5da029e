"""The laws between two bodies with their coefficients."""

from collections.abc import Mapping
from dataclasses import dataclass, replace
from functools import cached_property

from silostudy.contact import NORMAL, Law
from silostudy.dem.pieces import Laws
from silostudy.errors import BadInput


@dataclass(frozen=True)
class Contact:
    """The laws between two bodies and their coefficients by name, SI per metre thickness."""

    laws: Laws
    coefficients: dict[str, float]

    def __post_init__(self):
        needed = {coefficient.name for row in self.rows for coefficient in row.coefficients}
        for name in sorted(self.coefficients.keys() - needed):
            raise BadInput(name, self.coefficients[name], f"unknown; these laws take {', '.join(sorted(needed))}")
        self.ordered  # noqa: B018  (each law looks at its own)
        if self.laws.cohesion.of_hertz and not self.laws.normal.of_hertz:
            fitting = ", ".join(key for key, row in NORMAL.items() if row.of_hertz)
            raise BadInput(
                "cohesion", self.laws.cohesion.key, f"stands on {fitting} as normal law, not on {self.laws.normal.key}"
            )

    @classmethod
    def taking(cls, laws: Laws, values: Mapping[str, float]) -> "Contact":
        """A contact with those of the values that its laws take."""
        needed = {coefficient.name for row in laws.rows for coefficient in row.coefficients}
        return cls(laws, {name: value for name, value in values.items() if name in needed})

    @property
    def rows(self) -> tuple[Law, ...]:
        """Rows of the laws."""
        return self.laws.rows

    @cached_property
    def ordered(self) -> tuple[tuple[float, ...], ...]:
        """Coefficients of the laws in the order that their functions take."""
        return tuple(row.ordered(self.coefficients) for row in self.rows)

    def gap(self, radius: float) -> float:
        """Gap (m) across which two bodies that have touched hold on, of a reduced radius (m)."""
        return float(self.laws.cohesion.gap(radius, self.ordered[3]))

    @property
    def sets(self) -> "tuple[Contact]":
        """Sets of coefficients: this only one."""
        return (self,)

    def numbered(self, number: int) -> "Contact":
        """The contact of a number: itself for any."""
        return self

    def changed(self, values: Mapping[str, float]) -> "Contact":
        """A copy with other values of coefficients."""
        return replace(self, coefficients={**self.coefficients, **values})

    def scaled(self, *, stiffness: float, damping: float) -> "Contact":
        """The same laws with springs and dashpots stronger by these factors."""
        powers = {
            coefficient.name: (coefficient.stiffness_power, coefficient.damping_power)
            for row in self.rows
            for coefficient in row.coefficients
        }
        changed = {
            name: value * (stiffness ** powers[name][0] * damping ** powers[name][1])
            for name, value in self.coefficients.items()
        }
        return replace(self, coefficients=changed)
