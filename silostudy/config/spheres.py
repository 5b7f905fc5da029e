"""What a user writes to describe a discrete-element scene of spheres in a silo, in the user's units."""

from collections.abc import Mapping
from typing import TYPE_CHECKING, Any, ClassVar, Literal, Self, TypeAlias

from pydantic import model_validator

from silostudy.catalogue import Family
from silostudy.config.contact import LawsConfig
from silostudy.config.fields import Strict, described, one_of
from silostudy.config.observers import Cells
from silostudy.config.own import key_of
from silostudy.config.run import GrainScene, Recorded
from silostudy.config.scene import Silo
from silostudy.config.sphere_events import SphereEventConfig
from silostudy.config.surfaces import apart_from, in_place
from silostudy.contact import NO_COHESION, NO_ROLLING, NO_TWISTING, SPHERE_LAWS
from silostudy.contact.normal import hertz
from silostudy.contact.tangential import mindlin
from silostudy.packing.filling import FILLINGS
from silostudy.packing.sizes import SIZES
from silostudy.tables.constants import ROUNDED_GRAVITY
from silostudy.tables.materials import MATERIALS
from silostudy.tables.outputs import OUTPUTS

OF_MATERIALS = {"materials", "restitution", "sliding_friction"}  # fields that a scene of spheres has for laws to share
LAWS: Mapping[str, Family] = {
    name: Family(
        family.name,
        (
            row
            for row in family.values()
            if all(one.own or {f for g in one.fields for f in g} <= OF_MATERIALS for one in row.coefficients)
        ),
        family.takes,
    )
    for name, family in SPHERE_LAWS.items()
}
MaterialKey: TypeAlias = Literal[tuple(MATERIALS)]  # type: ignore[valid-type]
NormalKey: TypeAlias = key_of(LAWS["normal"])  # type: ignore[valid-type]
TangentialKey: TypeAlias = key_of(LAWS["tangential"])  # type: ignore[valid-type]
RollingKey: TypeAlias = key_of(LAWS["rolling"])  # type: ignore[valid-type]
CohesionKey: TypeAlias = key_of(LAWS["cohesion"])  # type: ignore[valid-type]
TwistingKey: TypeAlias = key_of(LAWS["twisting"])  # type: ignore[valid-type]
OutputKey: TypeAlias = Literal[tuple(key for key, row in OUTPUTS.items() if row.stage == "dem")]  # type: ignore[valid-type]
if TYPE_CHECKING:
    SizesConfig = Any
    FillingConfig = Any
else:
    SizesConfig, FillingConfig = one_of(SIZES), one_of(FILLINGS, "Filling")


class MaterialConfig(Strict):
    """An elastic material: from the table, with values that replace the table's, or all of them one's own."""

    material: MaterialKey | None = described("key of the material (`silostudy list materials`); null: none", "", default=None)
    youngs_modulus_MPa: float | None = described("Young's modulus", "MPa", gt=0, default=None)
    poissons_ratio: float | None = described("Poisson's ratio", gt=-1, lt=0.5, default=None)

    @model_validator(mode="after")
    def _whole(self) -> Self:
        if self.material is None and None in (self.youngs_modulus_MPa, self.poissons_ratio):
            raise ValueError("give a material, or youngs_modulus_MPa and poissons_ratio")
        return self


class GrainConfig(MaterialConfig):
    """The material of the spheres."""

    density_kg_m3: float | None = described("density of a sphere", "kg m-3", gt=0, default=None)
    softened_modulus_MPa: float | None = described(
        "Young's modulus that is computed with in place of the material's: steps grow with the root of the ratio, overlaps by "
        "its power 2/3 (`silostudy explain SCENE` tells both)",
        "MPa",
        gt=0,
        default=None,
    )


class TouchConfig(LawsConfig):
    """How spheres push each other, or walls push them: laws, and what the pair of materials does not say."""

    choices: ClassVar[Mapping[str, Family]] = LAWS

    normal: NormalKey = described("law of the normal force", "", default=hertz.ROW.key)
    tangential: TangentialKey = described("law of the tangential force", "", default=mindlin.ROW.key)
    rolling: RollingKey = described("law of rolling resistance", "", default=NO_ROLLING)
    cohesion: CohesionKey = described("law of cohesion", "", default=NO_COHESION)
    twisting: TwistingKey = described("law of resistance to twisting about the normal", "", default=NO_TWISTING)
    restitution: float | None = described(
        "speed after over speed before a head-on impact; null: of the pair of materials", gt=1e-3, le=1, default=None
    )
    sliding_friction: float | None = described("friction coefficient; null: of the pair of materials", ge=0, default=None)


if TYPE_CHECKING:
    SphereSurfaceConfig = Any
else:
    told = "Material and contact of a surface that is not like the other walls."
    SphereSurfaceConfig = apart_from("SphereSurfaceConfig", told, MaterialConfig, TouchConfig)


class OutletConfig(Strict):
    """An outlet of a flat floor."""

    name: str = described("name that events open it by", "", min_length=1, default="outlet")
    width_m: float = described("diameter; where it has a length its width along x", "m", gt=0)
    length_m: float | None = described("length along y; null: a round outlet", "m", gt=0, default=None)
    middle_m: tuple[float, float] | None = described(
        "x and y of its middle; null: silo.outlet_eccentricity_m off the axis towards x", "m", default=None
    )


class SphereRecordConfig(Recorded):
    """What is recorded; everything is off unless asked for."""

    pressure_cells: tuple[Cells, Cells] = described(
        "parts along the height and around of each surface, whose pressure and shear are recorded with wall_force_window_s",
        default=(10, 12),
    )


class SphereScene(GrainScene):
    """A discrete-element scene of spheres in a silo."""

    joins: ClassVar[tuple[Family, ...]] = tuple(SPHERE_LAWS.values())

    kind: Literal["dem"] = described("dem: discrete elements", "")
    grains: Literal["spheres"] = described("discs in a plane silo, or spheres in a silo in space", "")
    silo: Silo = described(
        "silo as in a study of pressures; its depth is the height of the vertical walls; what only codes read is passed over",
        "",
    )
    outlets: tuple[OutletConfig, ...] = described("outlets of a flat floor; none: closed, or the hopper's", "", default=())
    wedge: bool = described("whether the hopper of a square or rectangle slopes on two sides only", "", default=False)
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
    sizes: SizesConfig = described("sizes of the spheres; a file gives its own", "", default=None)
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
        """How two spheres push each other, and walls push them."""
        return self.spheres, self.walls

    @property
    def surface_contacts(self) -> dict[str, tuple[MaterialConfig, TouchConfig]]:
        """Materials and contacts of the surfaces that are not like the other walls."""
        found = {}
        for name, surface in self.surfaces.items():
            values, key = surface.given, f"surfaces.{name}"
            of_material = {field: values.pop(field) for field in MaterialConfig.model_fields if field in values}
            wall = {} if "material" in of_material else self.wall.model_dump()
            found[name] = MaterialConfig(**(wall | of_material)), in_place(self.walls, values, key)
        return found

    @model_validator(mode="after")
    def _surfaces_are_sound(self) -> Self:
        self.surface_contacts  # noqa: B018  (each is made)
        return self

    @property
    def named_files(self) -> tuple[str, ...]:
        """Files that the scene is made from."""
        filled = (self.filling.file,) if FILLINGS[self.filling.kind].from_file else ()
        return (*filled, *self.branched_from)

    @model_validator(mode="after")
    def _sizes_known(self) -> Self:
        if (self.sizes is None) != FILLINGS[self.filling.kind].from_file:
            told = "must be left out: the file gives them" if self.sizes else "is missing"
            raise ValueError(f"sizes {told}, where filling.kind is {self.filling.kind}")
        return self

    @model_validator(mode="after")
    def _records_what_is_drawn(self) -> Self:
        record = self.record
        if self.outputs and not (record.wall_force_window_s and (record.snapshots_s or record.snapshots_every_s)):
            raise ValueError("outputs need record.wall_force_window_s, and record.snapshots_every_s or snapshots_s")
        for key in self.outputs:
            if "rings" in OUTPUTS[key].demands and (record.fields is None or len(record.fields.cells) != 2):
                raise ValueError(f"{key} needs record.fields with two numbers of cells")
        return self

    @model_validator(mode="after")
    def _cells_of_the_plan(self) -> Self:
        fields = self.record.fields
        if fields is not None and len(fields.cells) == 2 and self.silo.plan != "circular":
            raise ValueError("record.fields.cells must be three, along x, y and z, where silo.plan is not circular")
        return self

    @model_validator(mode="after")
    def _opens(self) -> Self:
        for event in self.events:
            if (event.of_lid or "lid" in event.surfaces) and not self.lid:
                raise ValueError(f"{event.do} when {event.when} needs lid: true")
        known = [outlet.name for outlet in self.outlets]
        hopper = self.silo.hopper is not None and self.silo.hopper.outlet_width_m > 0.0
        shut = ["the hopper's"] if hopper else list(known)
        for number, event in enumerate(self.events):
            if event.do not in ("open_outlet", "feed"):
                continue
            if not (hopper or known):
                raise ValueError(f"{event.do} needs an outlet: silo.hopper.outlet_width_m above 0, or outlets of a flat floor")
            if event.do == "feed":
                continue
            for name in event.outlets:
                if name not in known:
                    raise ValueError(f"events.{number}.outlets: {name} is unknown; known: {', '.join(known) or 'none by name'}")
            if not (opening := [name for name in shut if name in event.outlets or not event.outlets]):
                raise ValueError(f"events.{number} opens nothing: open by then")
            shut = [name for name in shut if name not in opening]
        return self
