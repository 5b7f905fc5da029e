"""The coefficients of contact laws: what they are made from in a scene, and in which range they lie."""

from collections.abc import Callable, Mapping
from dataclasses import dataclass, replace
from math import isfinite
from typing import TYPE_CHECKING, Any

from silostudy.errors import BadInput, unknown

if TYPE_CHECKING:
    from silostudy.contact.family import Law, NormalLaw


@dataclass(frozen=True)
class Given:
    """Input to a contact's coefficients: the fields of its section in a scene, radius (m), density (kg/m3).

    normal: the law of its normal force; wall: whether the other body is a wall; uneven: whether the discs differ in size, so
    that dashpots have to follow the masses of each pair.
    """

    fields: Mapping[str, Any]
    radius: float
    density: float
    normal: "NormalLaw"
    wall: bool = False
    uneven: bool = False

    def get(self, field: str) -> Any:
        """Value of a field; None where it is not given, or sections of these grains do not have it."""
        return self.fields.get(field)

    def __getitem__(self, field: str) -> Any:
        if field not in self.fields:
            raise unknown("contact field", field, self.fields)
        return self.fields[field]


@dataclass(frozen=True, kw_only=True)
class Coefficient:
    """A coefficient that a law takes: its name and unit there, its range, and the YAML fields it comes from.

    One that is prepared comes from fields that laws share.  Any other is read from a field of its own, which the contact
    section takes because of this row: `text` describes it, `default` None asks for it.
    """

    name: str
    unit: str
    fields: tuple[tuple[str, ...], ...] = ()  # of each group one
    positive: bool = False  # else zero or more
    prepare: Callable[[Given], float] | None = None
    text: str = ""
    default: float | None = None
    stiffness_power: float = 0.0  # of the factor by which a contact's springs are made stiffer
    damping_power: float = 0.0  # of the factor by which its dashpots are made stronger
    in_space: tuple[str, tuple[tuple[str, ...], ...]] | None = None  # unit and fields of spheres, where they are others

    @property
    def of_spheres(self) -> "Coefficient":
        """The coefficient with the unit and the fields that it has in scenes of spheres."""
        if self.in_space is None:
            return self
        unit, fields = self.in_space
        return replace(self, unit=unit, fields=fields, in_space=None)

    @property
    def own(self) -> bool:
        """Whether the field it comes from is its own."""
        return self.prepare is None

    @property
    def field(self) -> str:
        """The field of its own."""
        return self.fields[0][0]

    @property
    def range(self) -> str:
        return "positive" if self.positive else "zero or more"

    def check(self, value: float, law: "Law") -> None:
        """BadInput for a value out of range."""
        if not (isfinite(value) and (value > 0.0 or (value == 0.0 and not self.positive))):
            raise BadInput(self.name, value, f"must be {self.range} ({self.unit}), for the law {law.key}")

    def value(self, given: Given) -> float:
        """The value in SI from what a scene gives."""
        return float(given[self.field]) if self.prepare is None else self.prepare(given)
