"""The contact laws: families of plain functions of floats, one file a law; a scene picks one of each."""

from collections.abc import Callable, Mapping

from silostudy.catalogue import Family
from silostudy.contact.cohesion import COHESION
from silostudy.contact.cohesion import none as no_cohesion
from silostudy.contact.family import Law
from silostudy.contact.normal import NORMAL, spring_dashpot
from silostudy.contact.rolling import ROLLING
from silostudy.contact.rolling import none as no_rolling
from silostudy.contact.tangential import TANGENTIAL, spring_slider
from silostudy.contact.tangential import none as frictionless
from silostudy.contact.twisting import TWISTING
from silostudy.contact.twisting import none as no_twisting

FAMILIES: Mapping[str, Family] = {
    "normal": NORMAL,
    "tangential": TANGENTIAL,
    "rolling": ROLLING,
    "cohesion": COHESION,
    "twisting": TWISTING,
}


def of_grains(grains: str, told: Callable[[Law], Law]) -> Mapping[str, Family]:
    """The laws of `discs` or of `spheres`, by the names of their families here; not of a family that has none for them.

    told: what a law says of itself in scenes of these grains.
    """
    families = {
        name: Family(family.name, (told(row) for row in family.values() if grains in row.grains), family.takes)
        for name, family in FAMILIES.items()
    }
    return {name: family for name, family in families.items() if family}


LAWS = of_grains("discs", lambda row: row)
SPHERE_LAWS = of_grains("spheres", lambda row: row.of_spheres)
NO_TANGENTIAL = frictionless.ROW.key
NO_ROLLING = no_rolling.ROW.key
NO_COHESION = no_cohesion.ROW.key
NO_TWISTING = no_twisting.ROW.key
# what a contact has whose section in a scene names no law
DEFAULTS = {
    "normal": spring_dashpot.ROW.key,
    "tangential": spring_slider.ROW.key,
    "rolling": NO_ROLLING,
    "cohesion": NO_COHESION,
    "twisting": NO_TWISTING,
}
# with which the errors behind `accuracy:` of scenes were measured
MEASURED = {name: next(key for key, law in family.items() if law.measured) for name, family in LAWS.items()}

__all__ = [
    "COHESION",
    "DEFAULTS",
    "FAMILIES",
    "LAWS",
    "MEASURED",
    "NORMAL",
    "NO_COHESION",
    "NO_ROLLING",
    "NO_TANGENTIAL",
    "NO_TWISTING",
    "ROLLING",
    "SPHERE_LAWS",
    "TANGENTIAL",
    "TWISTING",
    "Law",
]
