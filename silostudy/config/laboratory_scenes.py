"""Grains, wall and cell of a virtual laboratory as a user writes them: spheres in a round cell, or discs in a plane one."""

from typing import Annotated, Any, ClassVar, Literal, TypeAlias

from pydantic import AfterValidator, Discriminator, Tag

from silostudy.catalogue import Family
from silostudy.config.contact import ContactConfig
from silostudy.config.elastic import GrainConfig, MaterialConfig, TouchConfig
from silostudy.config.fields import chosen_by, described
from silostudy.config.mixture import SizesConfig
from silostudy.config.own import OwnMethods
from silostudy.contact import LAWS, SPHERE_LAWS

LEAST_CELL = 5.0  # mean diameters: EN 1991-4's rule for the uniaxial cell, from memory
SPEED = (
    "strain rate times mean diameter times root of density over stress, at which cells are pressed and sheared: how fast "
    "the tests are; 0.001 and below counts as quasi-static"
)
STEP = "time step over the one that the engine chooses"


def _rubs(walls: ContactConfig | TouchConfig) -> ContactConfig | TouchConfig:
    """The wall's contact; ValueError where it has no friction, which the tests look for."""
    if walls.sliding_friction == 0.0:
        raise ValueError("sliding_friction must be above 0: the friction of this wall is tested")
    return walls


class LaboratoryScene(OwnMethods):
    """One filling of one round cell: spheres, the wall that they are tested against, and how fast the tests are."""

    joins: ClassVar[tuple[Family, ...]] = tuple(SPHERE_LAWS.values())

    grains: Literal["spheres"] = described("spheres in round cells, or discs in plane ones", "")
    grain: GrainConfig = described("material of the spheres", "")
    wall: MaterialConfig = described("material of the silo's wall, of which the tested plate is made", "")
    spheres: TouchConfig = described("contact between spheres", "", default=TouchConfig())
    walls: Annotated[TouchConfig, AfterValidator(_rubs)] = described(
        "contact of spheres and the wall's material", "", default=TouchConfig()
    )
    sizes: SizesConfig = described("sizes of the spheres", "")
    cell_grains: float = described("width of the cell over the mean diameter", ge=LEAST_CELL, le=200, default=16.0)
    height_grains: float = described("height of the filling over the mean diameter", ge=LEAST_CELL, le=200, default=8.0)
    inertial_number: float = described(SPEED, gt=0, le=0.01, default=0.001)
    step_factor: float = described(STEP, gt=0, le=1, default=1.0)
    seed: int = described("seed of the filling", ge=0, le=2**53, default=0)


class DiscLaboratory(OwnMethods):
    """One filling of one plane cell: discs, the wall that they are tested against, and how fast the tests are."""

    joins: ClassVar[tuple[Family, ...]] = tuple(LAWS.values())

    grains: Literal["discs"] = described("discs in plane cells, or spheres in round ones", "")
    radius_m: float = described("mean radius of the discs", "m", gt=0)
    radius_spread: float = described("radii lie between radius_m (1 - spread) and radius_m (1 + spread)", ge=0, le=0.5)
    density_kg_m3: float = described("density of the discs", "kg m-3", gt=0)
    discs: ContactConfig = described("contact between discs", "")
    walls: Annotated[ContactConfig, AfterValidator(_rubs)] = described("contact of discs and the wall's material", "")
    cell_grains: float = described(
        "width of the cell over the mean diameter; internal friction asks for four heights at least", ge=LEAST_CELL, le=400,
        default=64.0,
    )  # fmt: skip
    height_grains: float = described("height of the filling over the mean diameter", ge=LEAST_CELL, le=200, default=16.0)
    inertial_number: float = described(SPEED, gt=0, le=0.01, default=3e-4)
    step_factor: float = described(STEP, gt=0, le=1, default=1.0)
    seed: int = described("seed of the filling", ge=0, le=2**53, default=0)


MODELS = {"spheres": LaboratoryScene.__name__, "discs": DiscLaboratory.__name__}


def _model_of(scene: Any) -> str | None:
    """Name of the model that a scene, or its content, is of, as its key `grains` says."""
    return MODELS.get(str(scene.get("grains"))) if isinstance(scene, dict) else type(scene).__name__


AnyLaboratory: TypeAlias = Annotated[
    Annotated[LaboratoryScene, Tag(LaboratoryScene.__name__)] | Annotated[DiscLaboratory, Tag(DiscLaboratory.__name__)],
    Discriminator(_model_of, **chosen_by("grains", *MODELS)),
]
