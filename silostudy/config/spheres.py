"""A scene of spheres in a silo as a user writes it, in the user's units."""

from typing import TYPE_CHECKING, Any, ClassVar, Literal, Self, TypeAlias

from pydantic import model_validator

from silostudy.catalogue import Family
from silostudy.config.asked import Asked
from silostudy.config.elastic import GrainConfig, MaterialConfig, TouchConfig
from silostudy.config.fields import KeyMistake, Strict, described, one_of
from silostudy.config.mixture import GRAIN, WALLS, OtherGrainConfig, PairConfig, SizesConfig, SphereSurfaceConfig, check_kinds
from silostudy.config.observers import Cells
from silostudy.config.run import MEANS, GrainScene, Recorded
from silostudy.config.scene import Silo
from silostudy.config.sphere_events import SphereEventConfig
from silostudy.config.surfaces import in_place
from silostudy.contact import SPHERE_LAWS
from silostudy.dem.space.inserts import INSERTS
from silostudy.packing.filling import FILLINGS
from silostudy.tables.constants import ROUNDED_GRAVITY
from silostudy.tables.outputs import OUTPUTS

DRAWN = tuple(key for key, row in OUTPUTS.items() if row.stage == "dem" and "only_discs" not in row.demands)
OutputKey: TypeAlias = Literal[DRAWN]  # type: ignore[valid-type]
if TYPE_CHECKING:
    FillingConfig = Any
    InsertConfig = Any
else:
    FillingConfig = one_of(FILLINGS, "Filling")
    InsertConfig = one_of(INSERTS, "Insert")


class OutletConfig(Strict):
    """An outlet of a flat floor."""

    name: str = described("name that events open it by", "", min_length=1, default="outlet")
    width_m: float = described("diameter; where it has a length its width along x", "m", gt=0)
    length_m: float | None = described(
        "length along y; null: a round outlet. A slot may run across a rectangular floor one way, from wall to wall",
        "m",
        gt=0,
        default=None,
    )
    middle_m: tuple[float, float] | None = described(
        "x and y of its middle; null: silo.outlet_eccentricity_m off the axis towards x", "m", default=None
    )


class SphereRecordConfig(Recorded):
    """Records of a run of spheres; everything is off unless asked for."""

    pressure_cells: tuple[Cells, Cells] = described(
        "parts along the height and around of each surface, whose pressure and shear are recorded with wall_force_window_s",
        default=(10, 12),
    )


class SphereScene(Asked, GrainScene):
    """A discrete-element scene of spheres in a silo."""

    fronts: ClassVar[tuple[str, ...]] = (MEANS,)
    joins: ClassVar[tuple[Family, ...]] = tuple(SPHERE_LAWS.values())

    kind: Literal["dem"] = described("dem: discrete elements", "")
    grains: Literal["spheres"] = described("discs in a plane silo, or spheres in a silo in space", "")
    silo: Silo = described(
        "silo as in a study of pressures; its depth is the height of the vertical walls; what only codes read is passed over",
        "",
    )
    outlets: tuple[OutletConfig, ...] = described("outlets of a flat floor; none: closed, or the hopper's", "", default=())
    inserts: tuple[InsertConfig, ...] = described("surfaces inside, that push on both sides", "", default=())
    wedge: bool = described(
        "whether the hopper of a square or rectangle slopes on two sides only, else on all four to one apex; of grains alone: "
        "theories and codes have a wedge below silo.plan: slot",
        "",
        default=False,
    )
    lid: bool = described("whether a lid closes the top", "", default=False)
    grain: GrainConfig = described("material of the spheres", "")
    wall: MaterialConfig = described("material of the walls", "")
    spheres: TouchConfig = described("contact between spheres", "", default=TouchConfig())
    walls: TouchConfig = described("contact of spheres and walls", "", default=TouchConfig())
    surfaces: dict[str, SphereSurfaceConfig] = described(
        "surfaces that are not like the other walls, by their names (`silostudy explain SCENE` lists them); a name stands for "
        "its parts too, hopper for hopper_1, hopper_2, ...; what they do not say is as for wall and walls",
        "",
        default={},
    )
    sizes: SizesConfig = described("sizes of the spheres (of the kind `grain`); a file gives its own", "", default=None)
    other_grains: dict[str, OtherGrainConfig] = described(
        "kinds of spheres beside the one that grain and sizes are of, by names of your own", "", default={}
    )
    pairs: tuple[PairConfig, ...] = described(
        "two kinds, or a kind and a surface, whose contact differs from what spheres, walls and surfaces say", "", default=()
    )
    filling: FillingConfig = described("how the spheres come in", "")
    gravity_m_s2: tuple[float, float, float] = described(
        "gravity, x, y and z (up)", "m s-2", default=(0.0, 0.0, -ROUNDED_GRAVITY)
    )
    events: tuple[SphereEventConfig, ...] = described("what happens, in order; the last is a stop", "", min_length=1)
    record: SphereRecordConfig = described("what is recorded", "", default=SphereRecordConfig())
    outputs: tuple[OutputKey, ...] = described(
        "figures that the pipeline makes beside the cube; they need record.wall_force_window_s and snapshots", "", default=()
    )

    @property
    def touches(self) -> tuple[TouchConfig, TouchConfig]:
        """Sections of the contacts of two spheres, and of spheres with walls."""
        return self.spheres, self.walls

    @property
    def grain_kinds(self) -> dict[str, GrainConfig]:
        """Materials of all kinds of spheres by their names, `grain` first."""
        return {GRAIN: self.grain, **self.other_grains}

    def between(self, kind: str, other: str) -> tuple[str, TouchConfig]:
        """Section that says how two kinds of spheres push each other, and what it says."""
        return self._apart("spheres", self.spheres, kind, other)

    def at_surfaces(self, kind: str) -> dict[str, tuple[str, MaterialConfig, TouchConfig]]:
        """Section, material and contact of a kind of spheres at surfaces that are not like the other walls; "": at those."""
        walls = {"": ("walls", self.wall, self.walls)}
        walls |= {name: (f"surfaces.{name}", *self._surface(name)) for name in self.surfaces}
        named = {name for pair in self.pairs for name in pair.between if name not in self.grain_kinds}
        sections = {}
        for name in dict.fromkeys([*walls, *sorted(named - {WALLS})]):
            section, wall, touch = walls.get(name, walls[""])
            if name not in self.surfaces:  # one of the other walls, whatever a pair of another kind says of it
                section, touch = self._apart(section, touch, kind, WALLS)
            sections[name] = wall, *(self._apart(section, touch, kind, name) if name else (section, touch))
        return {name: (section, wall, touch) for name, (wall, section, touch) in sections.items()}

    def _surface(self, name: str) -> tuple[MaterialConfig, TouchConfig]:
        """Material and contact of a surface that is not like the other walls."""
        values = self.surfaces[name].given
        of_material = {field: values.pop(field) for field in MaterialConfig.model_fields if field in values}
        wall = {} if "material" in of_material else self.wall.model_dump()
        return MaterialConfig(**(wall | of_material)), in_place(self.walls, values, f"surfaces.{name}")

    def _apart(self, section: str, touch: TouchConfig, *names: str) -> tuple[str, TouchConfig]:
        """A section and what it says, or what a pair of these names says in its place."""
        for number, pair in enumerate(self.pairs):
            if sorted(pair.between) == sorted(names):
                return f"pairs.{number}", in_place(touch, pair.given, f"pairs.{number}")
        return section, touch

    @model_validator(mode="after")
    def _kinds_and_surfaces_are_sound(self) -> Self:
        check_kinds(self.other_grains, self.pairs, FILLINGS[self.filling.kind].from_file)
        for kind in self.grain_kinds:
            self.at_surfaces(kind)  # each is made
            for other in self.grain_kinds:
                self.between(kind, other)
        return self

    @property
    def named_files(self) -> tuple[str, ...]:
        """Files that the scene is made from."""
        filled = (self.filling.file,) if FILLINGS[self.filling.kind].from_file else ()
        return (*filled, *([self.quake.file] if self.quake else []), *self.branched_from)

    @model_validator(mode="after")
    def _sizes_known(self) -> Self:
        if (self.sizes is None) != FILLINGS[self.filling.kind].from_file:
            told = "must be left out: the file gives them" if self.sizes else "is missing"
            raise KeyMistake("sizes", f"{told}, where filling.kind is {self.filling.kind}")
        return self

    @model_validator(mode="after")
    def _records_what_is_drawn(self) -> Self:
        record = self.record
        if self.outputs and not (record.wall_force_window_s and (record.snapshots_s or record.snapshots_every_s)):
            raise KeyMistake("outputs", "need record.wall_force_window_s, and record.snapshots_every_s or snapshots_s")
        for key in self.outputs:
            if "rings" in OUTPUTS[key].demands and (record.fields is None or len(record.fields.cells) != 2):
                raise KeyMistake("outputs", f"{key} needs record.fields with two numbers of cells")
        return self

    @model_validator(mode="after")
    def _cells_of_the_plan(self) -> Self:
        fields = self.record.fields
        if fields is not None and len(fields.cells) == 2 and self.silo.plan != "circular":
            raise KeyMistake("record.fields.cells", "must be three, along x, y and z, where silo.plan is not circular")
        return self

    @model_validator(mode="after")
    def _opens(self) -> Self:
        for number, event in enumerate(self.events):
            if (event.of_lid or "lid" in event.surfaces) and not self.lid:
                raise KeyMistake(f"events.{number}.{event.asks_for_lid}", "needs lid: true")
        known = [outlet.name for outlet in self.outlets]
        hopper = self.silo.hopper is not None and self.silo.hopper.outlet_width_m > 0.0
        shut = ["the hopper's"] if hopper else list(known)
        for number, event in enumerate(self.events):
            if event.do not in ("open_outlet", "feed"):
                continue
            if not (hopper or known):
                told = "needs an outlet: silo.hopper.outlet_width_m above 0, or outlets of a flat floor"
                raise KeyMistake(f"events.{number}.do", told)
            if event.do == "feed":
                continue
            for place, name in enumerate(event.outlets):
                if name not in known:
                    told = f"unknown; known: {', '.join(known) or 'none by name'}"
                    raise KeyMistake(f"events.{number}.outlets.{place}", told)
            if not (opening := [name for name in shut if name in event.outlets or not event.outlets]):
                raise KeyMistake(f"events.{number}.do", "opens nothing: open by then")
            shut = [name for name in shut if name not in opening]
        return self
