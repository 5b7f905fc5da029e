"""The row of a contact law: functions, coefficients and where they come from, stiffness, damping, losses."""

import hashlib
from abc import abstractmethod
from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass, replace
from functools import cached_property
from pathlib import Path
from typing import Any, ClassVar, NamedTuple, Self

from numba import njit
from numba.core.registry import cpu_target
from numba.extending import register_jitable

from silostudy.catalogue import Row
from silostudy.contact.coefficient import Coefficient, Given
from silostudy.errors import BadInput
from silostudy.soundness import faults_of_function, faults_of_trial


class Touch(NamedTuple):
    """State of a contact for its laws: reduced mass (kg/m; of spheres kg), reduced radius (m), time step (s), overlap (m),
    closing speed (m/s), overlap a step before (m).

    Overlaps are those that the normal law presses with: larger than the bodies' own where an attraction widens the contact.
    """

    mass: float
    radius: float
    dt: float
    overlap: float = 0.0
    closing: float = 0.0
    before: float = 0.0


USUAL = Touch(mass=1.0, radius=0.01, dt=1e-5)  # a contact that laws are tried on: 1 kg/m, 1 cm, 10 us


def _is_jitable(function: Callable) -> bool:
    """Whether numba takes a function into the kernels that call it."""
    context = cpu_target.typing_context
    context.refresh()
    try:
        context.resolve_value_type(function)
    except ValueError:
        return False
    return True


def _as_python(function: Callable) -> Callable:
    return function


def _as_compiled(function: Callable) -> Callable:
    """The function as kernels have it: one that makes arrays or texts is refused, since none counts references to them."""
    options: dict[str, Any] = {"error_model": "numpy", "_nrt": False}
    return njit(**options)(function)


@register_jitable
def no_energy(stretch, touch, c):
    """Energy (J/m) of a law without a spring: zero."""
    return 0.0


@register_jitable
def no_stiffness(overlap, touch, c):
    """Stiffness of a law without a spring: zero."""
    return 0.0


@register_jitable
def no_attraction(touch, c):
    """Energy (J/m) of a contact without attraction: zero."""
    return 0.0


def no_damping(touch, c):
    """Damping of a law without a dashpot: zero."""
    return 0.0 * touch.mass


@dataclass(frozen=True, kw_only=True)
class Law(Row):
    """A contact law: its function, the coefficients it takes in order, and what its users need to know of it.

    stiffness(overlap, touch, c) is compiled into the energy balance and bounds the time step, damping(touch, c) bounds it
    too: the dashpot as it acts, the least that a semi-implicit one becomes at touch.dt.
    """

    unit: ClassVar[str]  # of what the function gives

    law: Callable
    stiffness: Callable = no_stiffness
    damping: Callable = no_damping
    coefficients: tuple[Coefficient, ...] = ()
    grains: tuple[str, ...] = ("discs", "spheres")  # of which it is the law
    acts: bool = True  # False: the law that a scene without this effect has
    stores: bool = False  # whether it carries a history
    implicit: bool = False  # whether its dashpot depends on the time step
    dissipates: tuple[str, ...] = ()  # entries of the energy balance that take what it costs
    restless: bool = False  # whether what it gives changes its sign from step to step at rest
    measured: bool = False  # whether the errors behind `accuracy:` of scenes were measured with it
    explicit_key: str = ""  # another row with the same spring, under which the same discs rest; empty: this one

    def faults(self) -> Iterator[str]:
        """Faults of the row, in words."""
        yield from super().faults()
        unit = self.unit if "discs" in self.grains else self.unit.removesuffix(" m-1")
        yield from faults_of_function("law", self.law, unit, (), ())
        for coefficient in self.coefficients:
            if not coefficient.unit:
                yield f"coefficient {coefficient.name}: has no unit"
            if coefficient.own and not (coefficient.fields and coefficient.text):
                yield f"coefficient {coefficient.name}: needs a field of its own and a text, or says how it is prepared"
        for name, function in self.compiled.items():
            if not _is_jitable(function):
                yield f"{name}: must be decorated with numba's register_jitable"
        faults = list(faults_of_trial("law", lambda: self.tried(_as_python, (1.0,) * len(self.coefficients))))
        yield from faults or faults_of_trial("law, compiled", lambda: self.tried(_as_compiled, (1.0,) * len(self.coefficients)))

    @property
    def compiled(self) -> dict[str, Callable]:
        """The functions that kernels are built from."""
        return {"law": self.law, "stiffness": self.stiffness}

    @abstractmethod
    def tried(self, made: Callable[[Callable], Callable], c: tuple[float, ...]) -> None:
        """Calls the law on a usual contact; made: what is made of its functions before they are called."""
        float(made(self.stiffness)(1e-6, USUAL, c))

    @property
    def of_spheres(self) -> Self:
        """The law with the units and fields that its coefficients have in scenes of spheres."""
        return replace(self, coefficients=tuple(coefficient.of_spheres for coefficient in self.coefficients))

    @property
    def at_rest(self) -> str:
        """Key of the law with an explicit dashpot under which discs rest as under this one."""
        return self.explicit_key or self.key

    def ordered(self, values: Mapping[str, float]) -> tuple[float, ...]:
        """Coefficients in the order that the law's function takes; BadInput names one that is missing or out of range."""
        for coefficient in self.coefficients:
            if coefficient.name not in values:
                raise BadInput(coefficient.name, None, f"missing: the law {self.key} takes it, in {coefficient.unit}")
            coefficient.check(values[coefficient.name], self)
        return tuple(float(values[coefficient.name]) for coefficient in self.coefficients)

    def prepared(self, given: Given) -> dict[str, float]:
        """Coefficients by name from what a scene gives."""
        return {coefficient.name: coefficient.value(given) for coefficient in self.coefficients}

    @cached_property
    def fingerprint(self) -> str:
        """Key and a hash of the file of the law: kernels of two laws of one key must not be taken for each other."""
        if self.origin:
            return f"{self.key} {self.origin}"
        code = self.law.__code__
        file = Path(code.co_filename)
        text = file.read_bytes() if file.is_file() else code.co_code + repr(code.co_consts).encode()
        return f"{self.key} {hashlib.sha256(text).hexdigest()[:12]}"


@dataclass(frozen=True, kw_only=True)
class NormalLaw(Law):
    """Normal force. law(overlap, closing speed, touch, c) -> elastic and total (N/m); energy(overlap, touch, c) -> J/m.

    damped(restitution) -> dashpot over 2 sqrt(m K), m the reduced mass; None where no restitution holds at every speed.
    """

    unit: ClassVar[str] = "N m-1"

    energy: Callable
    linear: bool = False  # whether the elastic force is proportional to the overlap
    of_hertz: bool = False  # whether the elastic force is that of Hertz's contact
    one_size: bool = False  # whether its coefficients hold for discs of one size alone
    damped: Callable[[float], float] | None = None

    @property
    def compiled(self) -> dict[str, Callable]:
        """The functions that kernels are built from."""
        return super().compiled | {"energy": self.energy}

    def tried(self, made: Callable[[Callable], Callable], c: tuple[float, ...]) -> None:
        """Calls the law on a usual contact."""
        super().tried(made, c)
        elastic, total = made(self.law)(1e-6, 0.1, USUAL, c)
        float(elastic), float(total), float(made(self.energy)(1e-6, USUAL, c))


@dataclass(frozen=True, kw_only=True)
class TangentialLaw(Law):
    """Tangential force. law(stored, sliding speed, touch, elastic, normal, c) -> stored and total (N/m)."""

    unit: ClassVar[str] = "N m-1"

    def tried(self, made: Callable[[Callable], Callable], c: tuple[float, ...]) -> None:
        """Calls the law on a usual contact."""
        super().tried(made, c)
        stored, total = made(self.law)(0.0, 0.1, USUAL, 1.0, 1.0, c)
        float(stored), float(total)


@dataclass(frozen=True, kw_only=True)
class RollingLaw(Law):
    """Rolling resistance. law(stored, difference of spins, touch, elastic, c) -> stored and total moment (N m/m)."""

    unit: ClassVar[str] = "N m m-1"

    def tried(self, made: Callable[[Callable], Callable], c: tuple[float, ...]) -> None:
        """Calls the law on a usual contact."""
        super().tried(made, c)
        stored, total = made(self.law)(0.0, 0.1, USUAL, 1.0, c)
        float(stored), float(total)


@dataclass(frozen=True, kw_only=True)
class TwistingLaw(RollingLaw):
    """Twisting resistance. law(stored, difference of spins about the normal, touch, elastic, c) -> stored, total (N m)."""

    unit: ClassVar[str] = "N m"

    grains: tuple[str, ...] = ("spheres",)


@register_jitable
def no_gap(radius, c):
    """Gap (m) across which an attraction holds on: none."""
    return 0.0


@register_jitable
def as_pressed(overlap, radius, c):
    """Overlap (m) that the normal law presses with: the bodies' own."""
    return overlap


@register_jitable
def without_pull(force, pull, touch, c):
    """Normal force (N/m) that friction takes: that of the normal law, so that the attraction adds to what presses outside."""
    return force


@dataclass(frozen=True, kw_only=True)
class CohesionLaw(Law):
    """Attraction (N/m) while in touch: law(touch, c); energy(touch, c) -> J/m that it holds, zero where bodies just touch.

    One that holds on keeps bodies in touch that have touched, up to the gap(reduced radius, c) (m), and may widen the contact:
    pressed(overlap, reduced radius, c) -> overlap (m) that the normal law presses with, rubbed(force, attraction, touch, c) ->
    normal force (N) that friction takes.
    """

    unit: ClassVar[str] = "N m-1"

    energy: Callable = no_attraction
    holds_on: bool = False
    gap: Callable = no_gap
    pressed: Callable = as_pressed
    rubbed: Callable = without_pull
    of_hertz: bool = False  # whether it stands on Hertz's contact alone

    @property
    def compiled(self) -> dict[str, Callable]:
        """The functions that kernels are built from."""
        own = {"energy": self.energy, "gap": self.gap, "pressed": self.pressed, "rubbed": self.rubbed}
        return super().compiled | own

    def tried(self, made: Callable[[Callable], Callable], c: tuple[float, ...]) -> None:
        """Calls the law on a usual contact."""
        super().tried(made, c)
        float(made(self.law)(USUAL, c)), float(made(self.energy)(USUAL, c))
        float(made(self.gap)(0.01, c)), float(made(self.pressed)(1e-6, 0.01, c)), float(made(self.rubbed)(1.0, 1.0, USUAL, c))
