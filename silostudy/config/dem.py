"""What a user writes to describe one discrete-element scene, in the user's units."""

from functools import reduce
from operator import or_
from typing import TYPE_CHECKING, Annotated, Any, ClassVar, Literal, Self, TypeAlias

from pydantic import Field, create_model, model_validator

from silostudy.catalogue import Family
from silostudy.config.asked import Asked
from silostudy.config.contact import ContactConfig
from silostudy.config.fields import Strict, described
from silostudy.config.own import OwnMethods
from silostudy.contact import LAWS
from silostudy.dem.events import TRIGGERS
from silostudy.dem.integrate import INTEGRATORS, PLAIN
from silostudy.dem.rest import REST
from silostudy.packing import PACKINGS
from silostudy.packing.family import Packing
from silostudy.tables.constants import ROUNDED_GRAVITY

CriterionKey: TypeAlias = Literal[tuple(REST)]  # type: ignore[valid-type]
TriggerKey: TypeAlias = Literal[tuple(TRIGGERS)]  # type: ignore[valid-type]
Cells: TypeAlias = Annotated[int, Field(ge=1, le=1000)]
IntegratorKey: TypeAlias = Literal[tuple(INTEGRATORS)]  # type: ignore[valid-type]


class BoxConfig(Strict):
    """A plane silo: vertical walls, a flat floor or a hopper, a slit in the middle of the bottom."""

    width_m: float = described("inner width", "m", gt=0)
    height_m: float = described("height of the vertical walls", "m", gt=0)
    slit_width_m: float = described("width of the slit; 0: none", "m", ge=0, default=0.0)
    hopper_half_angle_deg: float | None = described(
        "half angle of hopper walls from the vertical, down to the slit; null: a flat floor", "deg", gt=0, lt=90, default=None
    )
    lid: bool = described("whether a lid closes the top", "", default=False)
    wall_cells: int = described("parts of each wall whose force is recorded", ge=1, le=10_000, default=10)

    @model_validator(mode="after")
    def _slit_in_floor(self) -> Self:
        if self.slit_width_m >= self.width_m:
            raise ValueError(f"slit_width_m must be smaller than the floor, {self.width_m:g} m")
        if self.hopper_half_angle_deg is not None and self.slit_width_m == 0:
            raise ValueError("a hopper needs a slit_width_m: it is the width of its outlet")
        return self


def _section(packing: Packing) -> Any:
    """Model of the section `packing` that chooses this packing and gives what it asks for."""
    fields: dict[str, Any] = {"kind": (Literal[packing.key], described(f"{packing.key}: {packing.title}", ""))}
    for one in packing.asks:
        fields[one.name] = one.kind, described(one.text, one.unit, default=one.default, **one.bounds)
    return create_model(f"{packing.key.capitalize()}Config", __base__=Strict, __doc__=f"{packing.title}.", **fields)


if TYPE_CHECKING:
    PackingConfig = Any
else:
    PackingConfig = Annotated[reduce(or_, map(_section, PACKINGS.values())), Field(discriminator="kind")]


class MarchConfig(Strict):
    """The march in time."""

    integrator: IntegratorKey | None = described(
        "how velocities and places follow from forces; null: for the accuracy", "", default=PLAIN.key
    )
    step_s: float | None = described("time step; null: from the stability bound", "s", gt=0, default=None)
    step_factor: float | None = described(
        "time step over the one that the engine chooses where step_s is null; null: for the accuracy", gt=0, le=1, default=1.0
    )
    beyond_stability: bool = described("take a step_s beyond the stability bound all the same", "", default=False)
    limit_s: float = described("time at which the run ends at the latest", "s", gt=0)


class RestConfig(Strict):
    """When the discs count as at rest."""

    criterion: CriterionKey = described(
        "unbalanced-force: mean force left over on a disc over mean contact force; kinetic-over-potential: kinetic energy over "
        "the energy that lifts every disc by its radius; displacement: mean displacement of a step over dt^2 g, Kiyama and "
        "Fujimura's own, which loose discs keep from",
        "",
        default="unbalanced-force",
    )
    below: float | None = described("what it must come below; null: the criterion's own", gt=0, default=None)


class EventConfig(Strict):
    """One event: it waits for the event before it, then for its trigger, then acts."""

    when: TriggerKey = described("; ".join(f"{row.key}: {row.title}" for row in TRIGGERS.values()), "")
    value: float = described("seconds or share that the trigger takes", "", ge=0, default=0.0)
    do: Literal["open_slit", "remove_disc", "set_gravity", "set_friction", "stop"] = described("what happens", "")
    disc: int | None = described("number of the disc to remove", "", ge=0, default=None)
    near_m: tuple[float, float] | None = described("x, y of the place whose nearest disc to remove", "m", default=None)
    gravity_m_s2: tuple[float, float] | None = described("new gravity, x and y", "m s-2", default=None)
    disc_friction: float | None = described("new friction between discs", ge=0, default=None)
    wall_friction: float | None = described("new friction at the walls", ge=0, default=None)

    @model_validator(mode="after")
    def _has_what_it_needs(self) -> Self:
        if self.do == "remove_disc" and (self.disc is None) == (self.near_m is None):
            raise ValueError("remove_disc needs either disc or near_m")
        if self.do == "set_gravity" and self.gravity_m_s2 is None:
            raise ValueError("set_gravity needs gravity_m_s2")
        if self.do == "set_friction" and self.disc_friction is None and self.wall_friction is None:
            raise ValueError("set_friction needs disc_friction or wall_friction")
        if self.value and not TRIGGERS[self.when].takes_value:
            raise ValueError(f"value must be left out where when is {self.when}")
        most = TRIGGERS[self.when].most
        if most is not None and self.value > most:
            raise ValueError(f"value must be a share, {most:g} or less, where when is {self.when}")
        return self


class RecordConfig(Strict):
    """What is recorded; everything is off unless asked for."""

    wall_force_window_s: float | None = described(
        "wall forces of every step, as mean, minimum and maximum over windows of this length; the last ends with the run",
        "s",
        gt=0,
        default=None,
    )
    snapshots_s: tuple[Annotated[float, Field(ge=0)], ...] = described(
        "times at which places and force chains are written; 0: the start", "s", default=()
    )
    stress_cells: tuple[Cells, Cells] | None = described("cells across and up of the coarse-grained stress", default=None)
    energy: bool = described("whether the energy ledger is kept", "", default=False)
    paraview: bool = described("whether the snapshots are also written for ParaView", "", default=False)
    checkpoint_every_s: float | None = described("model time between checkpoints", "s", gt=0, default=None)


class QuakeConfig(Strict):
    """Acceleration of the box."""

    file: str = described(
        "CSV file whose first line names its columns, time_s (equal steps), x_m_s2, y_m_s2, relative to the scene file; "
        "the box is at rest before and after",
        "",
    )


class DemScene(Asked, OwnMethods):
    """A discrete-element scene."""

    fronts: ClassVar[tuple[str, ...]] = ("dem",)
    joins: ClassVar[tuple[Family, ...]] = tuple(LAWS.values())

    kind: Literal["dem"] = described("dem: discrete elements", "")
    title: str = described("title of the scene", "")
    silo: BoxConfig = described("the silo", "")
    packing: PackingConfig = described("how the discs start", "")
    radius_m: float = described("radius of the discs", "m", gt=0)
    density_kg_m3: float = described("density of the discs", "kg m-3", gt=0)
    discs: ContactConfig = described("contact between discs", "")
    walls: ContactConfig | None = described("contact of discs and walls; null: as between discs", "", default=None)
    gravity_m_s2: tuple[float, float] = described("gravity, x and y (up)", "m s-2", default=(0.0, -ROUNDED_GRAVITY))
    quake: QuakeConfig | None = described("acceleration of the box", "", default=None)
    march: MarchConfig = described("the march in time", "")
    rest: RestConfig = described("what `when: rest` waits for", "", default=RestConfig())
    events: tuple[EventConfig, ...] = described("what happens, in order; the last is a stop", "", min_length=1)
    record: RecordConfig = described("what is recorded", "", default=RecordConfig())
    seed: int = described("seed of the random numbers; beyond 2^53 numbers of a sweep coincide", ge=0, le=2**53, default=0)

    @model_validator(mode="after")
    def _one_step(self) -> Self:
        if self.accuracy is not None and self.march.step_s is not None:
            raise ValueError("give either accuracy or march.step_s, and not both")
        return self

    @model_validator(mode="after")
    def _recorded_in_time(self) -> Self:
        limit, window = self.march.limit_s, self.record.wall_force_window_s
        if window is not None and window > limit:
            raise ValueError(f"record.wall_force_window_s = {window:g} must not be longer than march.limit_s = {limit:g}")
        for time in self.record.snapshots_s:
            if time > limit:
                raise ValueError(f"record.snapshots_s = {time:g} lies beyond march.limit_s = {limit:g}")
        if len(set(self.record.snapshots_s)) < len(self.record.snapshots_s):
            raise ValueError("record.snapshots_s names a time twice")
        return self

    @model_validator(mode="after")
    def _events_fit(self) -> Self:
        if self.events[-1].do != "stop":
            raise ValueError("the last event must be a stop")
        if any(event.do == "open_slit" for event in self.events) and self.silo.slit_width_m == 0:
            raise ValueError("open_slit needs a silo.slit_width_m above 0")
        removed = [event.disc for event in self.events if event.disc is not None]
        if len(set(removed)) < len(removed):
            raise ValueError("events remove a disc twice")
        return self
