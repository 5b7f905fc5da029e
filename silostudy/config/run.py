"""Sections of every scene of grains: time stepping, rest, triggers of events, records."""

from abc import abstractmethod
from typing import TYPE_CHECKING, Annotated, Any, Literal, Self, TypeAlias

from pydantic import Field, model_validator

from silostudy.config.contact import LawsConfig
from silostudy.config.fields import KeyMistake, Strict, described, one_of
from silostudy.config.observers import FieldsConfig, StatisticsConfig
from silostudy.config.own import OwnMethods
from silostudy.dem.events import TRIGGERS
from silostudy.dem.integrate import INTEGRATORS, PLAIN
from silostudy.dem.outcomes import OUTCOMES
from silostudy.dem.rest import REST
from silostudy.tables.asked import quantities

FLOWS = ("open_slit", "open_outlet", "feed")  # events that let grains out of an outlet

CriterionKey: TypeAlias = Literal[tuple(REST)]  # type: ignore[valid-type]
TriggerKey: TypeAlias = Literal[tuple(TRIGGERS)]  # type: ignore[valid-type]
IntegratorKey: TypeAlias = Literal[tuple(INTEGRATORS)]  # type: ignore[valid-type]
MEANS = "fillings"  # what tables/asked.csv files quantities under that are means over fillings
MOST_SNAPSHOTS = 100_000  # of a scene: they are listed, and kept in memory until the end
if TYPE_CHECKING:
    ExpectedConfig = Any
else:
    ExpectedConfig = one_of(OUTCOMES, "Expected")


class MarchConfig(Strict):
    """Time stepping."""

    integrator: IntegratorKey | None = described(
        "how velocities and places follow from forces; null: for the accuracy", "", default=PLAIN.key
    )
    step_s: float | None = described("time step; null: from the stability bound", "s", gt=0, default=None)
    step_factor: float | None = described(
        "time step over the one that the engine chooses where step_s is null; null: for the accuracy", gt=0, le=1, default=1.0
    )
    step: Literal["fixed", "follow", "longer_at_rest"] | None = described(
        "fixed: one time step throughout; follow: as long as the contacts bear that there are, looked at every so often, from "
        "a 16th to four times the step that is chosen for the start; longer_at_rest: step_factor holds while grains move, and "
        "the slower the fastest, the longer are steps, up to the one that is chosen; null: for the accuracy",
        "",
        default="fixed",
    )
    beyond_stability: bool = described("take a step_s beyond the stability bound all the same", "", default=False)
    limit_s: float = described("time at which the run ends at the latest", "s", gt=0)

    @model_validator(mode="after")
    def _one_step(self) -> Self:
        if self.step_s is not None and "step_factor" in self.model_fields_set and self.step_factor not in (None, 1.0):
            raise KeyMistake("step_factor", "does nothing beside step_s: leave one of both out")
        return self

    @model_validator(mode="after")
    def _changes_alone(self) -> Self:
        if self.step in ("follow", "longer_at_rest"):
            for name in ("step_s", "beyond_stability"):
                if getattr(self, name):
                    raise KeyMistake(name, f"must be left out: step: {self.step} chooses the time step")
        return self


class QuakeConfig(Strict):
    """Acceleration of the box."""

    file: str = described(
        "CSV file whose first line names its columns, time_s (equal steps), x_m_s2, y_m_s2 and, of spheres, z_m_s2, relative "
        "to the scene file; the box is at rest before and after",
        "",
    )


class RestConfig(Strict):
    """Measure by which the grains count as at rest."""

    criterion: CriterionKey | None = described(
        "unbalanced-force: mean force left over on a grain over mean contact force; kinetic-over-potential: kinetic energy "
        "over the energy that lifts every grain by its radius; displacement: mean displacement of a step over dt^2 g, Kiyama "
        "and Fujimura's own, which loose grains keep from; drift: mean way since the last look over that of a fall meanwhile; "
        "null: unbalanced-force, or drift where a constant torque changes its sign from step to step and forces never balance",
        "",
        default=None,
    )
    below: float | None = described("what it must come below; null: the criterion's own", gt=0, default=None)


class Waiting(Strict):
    """Trigger that an event waits for."""

    when: TriggerKey = described("; ".join(f"{row.key}: {row.title}" for row in TRIGGERS.values()), "")
    value: float = described("seconds, share or kPa that the trigger takes", "", ge=0, default=0.0)

    @model_validator(mode="after")
    def _as_the_trigger_takes(self) -> Self:
        if self.value and not TRIGGERS[self.when].takes_value:
            raise KeyMistake("value", f"must be left out where when is {self.when}")
        most = TRIGGERS[self.when].most
        if most is not None and self.value > most:
            raise KeyMistake("value", f"must be a share, {most:g} or less, where when is {self.when}")
        return self


class Recorded(Strict):
    """Records of a run of any grains; everything is off unless asked for."""

    wall_force_window_s: float | None = described(
        "wall forces of every step, as mean, minimum and maximum over windows of this length; the last ends with the run",
        "s",
        gt=0,
        default=None,
    )
    snapshots_s: tuple[Annotated[float, Field(ge=0)], ...] = described(
        "times at which places and force chains are written; 0: the start", "s", default=()
    )
    snapshots_every_s: float | None = described("time between further snapshots, from the start on", "s", gt=0, default=None)
    fields: FieldsConfig | None = described("coarse-grained fields of the grains; null: none", "", default=None)
    contact_statistics: StatisticsConfig | None = described("statistics of the contacts; null: none", "", default=None)
    energy: bool = described(
        "whether the energy balance is kept; it sums in one order, so that the run takes 1 thread and no more",
        "",
        default=False,
    )
    paraview: bool = described("whether the snapshots are also written for ParaView", "", default=False)
    checkpoint_every_s: float | None = described("model time between checkpoints", "s", gt=0, default=None)
    keep_end: bool = described(
        "whether where the run ends is kept beside the cube (SCENE.end), for scenes that start_from it", "", default=False
    )


class GrainScene(OwnMethods):
    """A discrete-element scene."""

    title: str = described("title of the scene", "")
    march: MarchConfig = described("time stepping", "")
    rest: RestConfig = described("what `when: rest` waits for", "", default=RestConfig())
    start_from: str | None = described(
        "end of an earlier run (record.keep_end), relative to this file: this one goes on from there with the clock; grains, "
        "laws, stiffness and what stands of the silo must be the same; frictions, gravity, outlets that are shut there, "
        "events, records and the limit may be others; what moves there goes on, and events whose time had come there are not "
        "done again; null: it starts",
        "",
        default=None,
    )
    quake: QuakeConfig | None = described("acceleration of the box", "", default=None)
    seed: int = described("seed of the random numbers; beyond 2^53 numbers of a sweep coincide", ge=0, le=2**53, default=0)
    expected: tuple[ExpectedConfig, ...] = described(
        "published numbers that the run is held against at its end", "", default=()
    )
    if TYPE_CHECKING:
        grains: str  # each kind of grains has its own
        events: Any
        record: Any

    @property
    @abstractmethod
    def touches(self) -> tuple[LawsConfig, LawsConfig]:
        """Sections of the contacts of two grains, and of grains with walls."""

    @property
    def branched_from(self) -> tuple[str, ...]:
        """The file of the end that the scene goes on from, where it does."""
        return (self.start_from,) if self.start_from else ()

    @model_validator(mode="after")
    def _recorded_in_time(self) -> Self:
        limit, window = self.march.limit_s, self.record.wall_force_window_s
        if window is not None and window > limit:
            raise KeyMistake("record.wall_force_window_s", f"must not be longer than march.limit_s, {limit:g} s")
        for name in ("fields", "contact_statistics"):
            asked = getattr(self.record, name)
            if asked is not None and asked.every_s > limit:
                raise KeyMistake(f"record.{name}.every_s", f"must not be longer than march.limit_s, {limit:g} s")
        every = self.record.snapshots_every_s
        if every is not None and limit / every > MOST_SNAPSHOTS:
            told = f"asks for {limit / every:.3g} snapshots until march.limit_s, {limit:g} s: at most {MOST_SNAPSHOTS:,}"
            raise KeyMistake("record.snapshots_every_s", told)
        for number, time in enumerate(self.record.snapshots_s):
            if time > limit:
                raise KeyMistake(f"record.snapshots_s.{number}", f"lies beyond march.limit_s, {limit:g} s")
        if len(set(self.record.snapshots_s)) < len(self.record.snapshots_s):
            raise KeyMistake("record.snapshots_s", "names a time twice")
        return self

    @model_validator(mode="after")
    def _shows_what_is_expected(self) -> Self:
        for number, outcome in enumerate(self.expected):
            if self.grains not in (known := OUTCOMES[outcome.kind].grains):
                raise KeyMistake(f"expected.{number}.kind", f"is of scenes of {' and '.join(known)} alone")
        looked = self.record.snapshots_s or self.record.snapshots_every_s
        unseen = [outcome.kind for outcome in self.expected if OUTCOMES[outcome.kind].of_snapshots and not looked]
        if unseen:
            raise KeyMistake("expected", f"{', '.join(unseen)} needs record.snapshots_s or record.snapshots_every_s")
        unfelt = [
            outcome.kind
            for outcome in self.expected
            if OUTCOMES[outcome.kind].of_windows and not self.record.wall_force_window_s
        ]
        if unfelt:
            raise KeyMistake("expected", f"{', '.join(unfelt)} needs record.wall_force_window_s")
        return self

    @property
    def of_fillings(self) -> dict[str, float]:
        """Relative errors asked for of means over fillings, by quantity."""
        asked = getattr(self, "accuracy", None) or {}
        return {name: error for name, error in asked.items() if name in quantities((MEANS,))}

    @model_validator(mode="after")
    def _records_what_means_are_of(self) -> Self:
        window, first = self.record.wall_force_window_s, self.events[0]
        if self.of_fillings and not window:
            raise KeyMistake("accuracy", f"{', '.join(self.of_fillings)} needs record.wall_force_window_s")
        if "mean_outflow" in self.of_fillings and not any(event.do in FLOWS for event in self.events):
            raise KeyMistake("accuracy", f"mean_outflow: no event lets grains out, as {', '.join(FLOWS)} do")
        if "mean_wall_force" in self.of_fillings and window and first.when == "time" and first.value < window:
            told = "mean_wall_force: is of the last window before the first event, which comes at"
            raise KeyMistake("accuracy", f"{told} {first.value:g} s, before any is whole")
        return self

    @model_validator(mode="after")
    def _ends_with_a_stop(self) -> Self:
        if self.events[-1].do != "stop":
            raise KeyMistake(f"events.{len(self.events) - 1}.do", "the last event must be a stop")
        for number, event in enumerate(self.events[:-1]):
            if event.do == "stop":
                raise KeyMistake(f"events.{number}.do", "ends the run: only the last event is a stop")
        return self

    @model_validator(mode="after")
    def _feeds_through_shut_outlets(self) -> Self:
        done = [event.do for event in self.events]
        for number, name in enumerate(done):
            if name == "feed" and {"open_slit", "open_outlet"} & set(done[:number]):
                raise KeyMistake(
                    f"events.{number}.do", "an outlet is open by then, through which grains leave at their own rate"
                )
        return self
