"""What a check of a steel wall beside its buckling is: one row with how far a wall is used, and how thick it must be."""

from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass
from functools import partial
from inspect import signature

import numpy as np

from silostudy.catalogue import Row
from silostudy.limits import Limit, Measure
from silostudy.soundness import faults_of_function, faults_of_trial

# Every parameter that a check may ask for: (unit, symbol and meaning, a usual value).
PARAMETERS = {
    "yield_stress": ("Pa", "f_y", 235e6),
    "inner_radius": ("m", "R_i", 5.0),
    "thickness": ("m", "t", 0.01),
    "upper_internal_pressure": ("Pa", "p, largest, with its safety factor", 40000.0),
    "axial_wall_force": ("N m-1", "n, largest, compression positive, without the wall above, with its safety factor", 200000.0),
    "wall_above": ("Pa", "axial stress under the own weight of the wall above, with its safety factor", 0.0),
}
THIN_WALL = Limit(
    measure=Measure("t/r", "1", lambda *, inner_radius, thickness: 1 / (inner_radius / thickness + 0.5)),
    most=1 / 20,
    why="membrane forces are those of thin shells; EN 1993-1-6's r/t of 20, from memory",
)


@dataclass(frozen=True, kw_only=True)
class SteelCheck(Row):
    """A check by the membrane forces of a wall.

    utilisation: function(*, parameters) (1), 1 where the wall just carries; needed: the thickness (m) at which it does.
    """

    utilisation: Callable
    needed: Callable
    formula: str
    validity: str

    @property
    def range(self) -> str:
        """The limit in words, then what else there is to say of the check's range."""
        return f"{THIN_WALL.words()}; {self.validity}"

    @property
    def needs(self) -> frozenset[str]:
        """Names of all parameters that its functions ask for."""
        return frozenset(name for function in (self.utilisation, self.needed) for name in signature(function).parameters)

    def faults(self) -> Iterator[str]:
        """What is wrong with the row, in words."""
        yield from super().faults()
        usual = {key: np.full(2, value) for key, (_, _, value) in PARAMETERS.items()}
        for name, unit in (("utilisation", "1"), ("needed", "m")):
            function = getattr(self, name)
            yield from faults_of_function(name, function, unit, signature(function).parameters, PARAMETERS)
            yield from faults_of_trial(name, partial(call, function, usual))


def call(function: Callable, available: Mapping):
    """The function, handed those of the available parameters that it asks for."""
    return function(**{name: available[name] for name in signature(function).parameters})
