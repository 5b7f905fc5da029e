"""A scene of discs as a user writes it, in the user's units."""

from collections.abc import Mapping
from typing import TYPE_CHECKING, Any, ClassVar, Literal, Self, TypeAlias

from pydantic import model_validator

from silostudy.catalogue import Family
from silostudy.config.asked import Asked
from silostudy.config.contact import ContactConfig
from silostudy.config.disc_mixture import DiscPairConfig, OtherDiscConfig, check_disc_kinds
from silostudy.config.fields import KeyMistake, Strict, described, one_of
from silostudy.config.mixture import GRAIN, WALLS
from silostudy.config.moves import MovingEvent, Takes
from silostudy.config.run import MEANS, GrainScene, Recorded
from silostudy.config.surfaces import apart_from, in_place
from silostudy.contact import LAWS
from silostudy.dem.inserts import LINES
from silostudy.packing import PACKINGS
from silostudy.tables.constants import ROUNDED_GRAVITY
from silostudy.tables.outputs import OUTPUTS


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
            raise KeyMistake("slit_width_m", f"must be smaller than the floor, {self.width_m:g} m")
        if self.hopper_half_angle_deg is not None and self.slit_width_m == 0:
            raise KeyMistake("slit_width_m", "must be above 0 in a hopper: it is the width of its outlet")
        return self


class SlitConfig(Strict):
    """A slit of a flat floor, by its name."""

    name: str = described("name that events open it by", "", min_length=1)
    width_m: float = described("width", "m", gt=0)
    middle_m: float = described("distance of its middle from the left wall", "m", gt=0)


if TYPE_CHECKING:
    PackingConfig = Any
    LineConfig = Any
else:
    PackingConfig = one_of(PACKINGS)
    LineConfig = one_of(LINES, "Insert")


class EventConfig(MovingEvent):
    """One event: it waits for the event before it, then for its trigger, then acts."""

    takes: ClassVar[Mapping[str, Takes]] = {
        **MovingEvent.takes,
        "open_slit": Takes("the slit opens, or outlets by name", may=("outlets", "speed_m_s")),
        "remove_disc": Takes("a disc is taken out", may=("disc", "near_m")),
        "set_gravity": Takes("gravity becomes another", ("gravity_m_s2",)),
        "set_friction": Takes("frictions become others", may=("disc_friction", "wall_friction", "surfaces")),
        "run_belt": Takes("the face of a wall runs along it", ("speed_m_s", "surfaces")),
    }

    do: Literal[
        "open_slit",
        "remove_disc",
        "set_gravity",
        "set_friction",
        "lower_lid",
        "press_lid",
        "move_lid",
        "run_belt",
        "feed",
        "stop",
    ] = described("what happens", "")
    speed_m_s: float | None = described(
        "move_lid: downward, negative lifts the lid, 0 stops it; press_lid: where nothing resists, null: 0.1; open_slit: at "
        "which an outlet's width grows from none to all, from its middle, in a floor at rest, null: at once; run_belt: at "
        "which a wall's face runs along it, counter-clockwise around the discs, negative the other way, 0 stops it",
        "m s-1",
        default=None,
    )
    outlets: tuple[str, ...] = described("open_slit: names of the outlets that open; none: all", "", default=())
    disc: int | None = described("number of the disc to remove", "", ge=0, default=None)
    near_m: tuple[float, float] | None = described("x, y of the place whose nearest disc to remove", "m", default=None)
    gravity_m_s2: tuple[float, float] | None = described("new gravity, x and y", "m s-2", default=None)
    disc_friction: float | None = described("new friction between discs", ge=0, default=None)
    wall_friction: float | None = described("new friction at all walls, or at surfaces", ge=0, default=None)
    surfaces: tuple[str, ...] = described(
        "set_friction: where wall_friction changes, by names as in the scene's surfaces, none: all walls; run_belt: walls "
        "that stay where they are while their face runs along them and drags what touches it",
        "",
        default=(),
    )

    @model_validator(mode="after")
    def _has_what_it_needs(self) -> Self:
        if self.do == "remove_disc" and (self.disc is None) == (self.near_m is None):
            raise KeyMistake("do", "needs either disc or near_m")
        if self.do == "set_friction" and self.disc_friction is None and self.wall_friction is None:
            raise KeyMistake("do", "needs disc_friction or wall_friction")
        if self.do == "set_friction" and self.surfaces and self.wall_friction is None:
            raise KeyMistake("surfaces", "are where a wall_friction changes: give that too")
        return self


if TYPE_CHECKING:
    SurfaceConfig = Any
else:
    SurfaceConfig = apart_from("SurfaceConfig", "How a surface that is not like the other walls pushes discs.", ContactConfig)


DRAWN = tuple(key for key, row in OUTPUTS.items() if row.stage == "dem" and "only_discs" in row.demands)
DiscOutput: TypeAlias = Literal[DRAWN]  # type: ignore[valid-type]


class DemScene(Asked, GrainScene):
    """A discrete-element scene of discs."""

    fronts: ClassVar[tuple[str, ...]] = ("dem", MEANS)
    joins: ClassVar[tuple[Family, ...]] = tuple(LAWS.values())

    kind: Literal["dem"] = described("dem: discrete elements", "")
    grains: Literal["discs"] = described("discs in a plane silo, or spheres in a silo in space", "", default="discs")
    silo: BoxConfig = described("the silo", "")
    outlets: tuple[SlitConfig, ...] = described(
        "slits of a flat floor by names, each with its meter; none: silo.slit_width_m says", "", default=()
    )
    inserts: tuple[LineConfig, ...] = described(
        "lines inside or outside the silo, that push on both sides; discs of a packing that would cut one are left out",
        "",
        default=(),
    )
    packing: PackingConfig = described("how the discs start", "")
    radius_m: float = described("radius of the discs (of the kind `grain`)", "m", gt=0)
    density_kg_m3: float = described("density of the discs (of the kind `grain`)", "kg m-3", gt=0)
    other_grains: dict[str, OtherDiscConfig] = described(
        "kinds of discs beside the one that radius_m and density_kg_m3 are of, by names of your own; each takes places of the "
        "packing, laid for the largest of all",
        "",
        default={},
    )
    pairs: tuple[DiscPairConfig, ...] = described(
        "two kinds, or a kind and a surface, whose contact differs from what discs, walls and surfaces say", "", default=()
    )
    discs: ContactConfig = described("contact between discs", "")
    walls: ContactConfig | None = described("contact of discs and walls; null: as between discs", "", default=None)
    surfaces: dict[str, SurfaceConfig] = described(
        "walls that are not like the others, by their names (`silostudy explain SCENE` lists them); a name stands for its "
        "parts too, hopper for hopper_left and hopper_right; what they do not say is as for walls",
        "",
        default={},
    )
    gravity_m_s2: tuple[float, float] = described("gravity, x and y (up)", "m s-2", default=(0.0, -ROUNDED_GRAVITY))
    events: tuple[EventConfig, ...] = described("what happens, in order; the last is a stop", "", min_length=1)
    record: Recorded = described("what is recorded", "", default=Recorded())
    outputs: tuple[DiscOutput, ...] = described(
        "figures that the pipeline makes beside the cube; they need record.wall_force_window_s and snapshots", "", default=()
    )

    @property
    def touches(self) -> tuple[ContactConfig, ContactConfig]:
        """Sections of the contacts of two discs, and of discs with walls."""
        return self.discs, self.walls or self.discs

    @property
    def named_files(self) -> tuple[str, ...]:
        """Files that the scene is made from."""
        packed = (self.packing.file,) if PACKINGS[self.packing.kind].from_file else ()
        return (*packed, *([self.quake.file] if self.quake else []), *self.branched_from)

    @property
    def kinds(self) -> tuple[str, ...]:
        """Names of all kinds of discs, `grain` first."""
        return GRAIN, *self.other_grains

    def between(self, kind: str, other: str) -> ContactConfig:
        """Section of the contacts between two kinds of discs."""
        return self._apart(self.discs, kind, other)

    def at_surfaces(self, kind: str = GRAIN) -> dict[str, ContactConfig]:
        """Contacts of a kind of discs at surfaces that are not like the other walls; "": at those."""
        walls = self._apart(self.walls or self.discs, kind, WALLS)
        told = {
            name: in_place(self.walls or self.discs, surface.given, f"surfaces.{name}")
            for name, surface in self.surfaces.items()
        }
        named = {name for pair in self.pairs for name in pair.between if name not in self.kinds}
        others = dict.fromkeys([*told, *sorted(named - {WALLS})])
        return {"": walls, **{name: self._apart(told.get(name, walls), kind, name) for name in others}}

    def _apart(self, contact: ContactConfig, *names: str) -> ContactConfig:
        """A contact, or what a pair of these names says in its place."""
        for number, pair in enumerate(self.pairs):
            if sorted(pair.between) == sorted(names):
                return in_place(contact, pair.given, f"pairs.{number}")
        return contact

    @model_validator(mode="after")
    def _records_what_is_drawn(self) -> Self:
        record = self.record
        if self.outputs and not (record.wall_force_window_s and (record.snapshots_s or record.snapshots_every_s)):
            raise KeyMistake("outputs", "need record.wall_force_window_s, and record.snapshots_every_s or snapshots_s")
        return self

    @model_validator(mode="after")
    def _kinds_and_surfaces_are_sound(self) -> Self:
        check_disc_kinds(self.other_grains, self.pairs, PACKINGS[self.packing.kind].from_file)
        for kind in self.kinds:
            self.at_surfaces(kind)  # each is made
            for other in self.kinds:
                self.between(kind, other)
        return self

    @model_validator(mode="after")
    def _one_step(self) -> Self:
        if self.decides("march.step_factor") and self.march.step_s is not None:
            raise KeyMistake("march.step_s", "give either accuracy or this, and not both")
        return self

    @model_validator(mode="after")
    def _cells_of_the_plane(self) -> Self:
        if self.record.fields is not None and len(self.record.fields.cells) != 2:
            raise KeyMistake("record.fields.cells", f"must be two, across and up, not {len(self.record.fields.cells)}")
        return self

    @model_validator(mode="after")
    def _outlets_open(self) -> Self:
        if self.outlets and (self.silo.slit_width_m or self.silo.hopper_half_angle_deg is not None):
            raise KeyMistake("outlets", "are of a flat floor without a silo.slit_width_m")
        shut = known = [outlet.name for outlet in self.outlets]
        for number, event in enumerate(self.events):
            if event.do != "open_slit":
                continue
            if not known and (event.outlets or event.speed_m_s is not None):
                raise KeyMistake(f"events.{number}.do", "names and speeds are of outlets, and the scene has none")
            for place, name in enumerate(event.outlets):
                if name not in known:
                    raise KeyMistake(f"events.{number}.outlets.{place}", f"unknown; known: {', '.join(known)}")
            if known and not (opening := [name for name in shut if name in event.outlets or not event.outlets]):
                raise KeyMistake(f"events.{number}.do", "opens nothing: open by then")
            shut = [name for name in shut if name not in opening] if known else shut
        return self

    @model_validator(mode="after")
    def _events_fit(self) -> Self:
        for number, event in enumerate(self.events):
            if event.do in ("open_slit", "feed") and self.silo.slit_width_m == 0 and not self.outlets:
                raise KeyMistake(f"events.{number}.do", "needs a silo.slit_width_m above 0, or outlets")
            if event.of_lid and not self.silo.lid:
                raise KeyMistake(f"events.{number}.{event.asks_for_lid}", "needs silo.lid: true")
        removed = [event.disc for event in self.events]
        for number, disc in enumerate(removed):
            if disc is not None and disc in removed[:number]:
                raise KeyMistake(f"events.{number}.disc", "is taken out twice")
        return self
