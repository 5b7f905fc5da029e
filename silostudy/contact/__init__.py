"""The contact laws: four families of plain functions of floats, one file a law; a scene picks one of each."""

from collections.abc import Mapping

from silostudy.catalogue import Family
from silostudy.contact.cohesion import constant_pull
from silostudy.contact.cohesion import none as no_cohesion
from silostudy.contact.family import CohesionLaw, Law, NormalLaw, RollingLaw, TangentialLaw
from silostudy.contact.normal import line_contact, spring_dashpot, spring_dashpot_implicit, spring_dashpot_tension
from silostudy.contact.rolling import none as no_rolling
from silostudy.contact.rolling import spring_slider as rolling_slider
from silostudy.contact.tangential import none as frictionless
from silostudy.contact.tangential import spring_slider, spring_slider_implicit, spring_slider_total, viscous_coulomb

NORMAL: Family[NormalLaw] = Family(
    "normal law",
    [spring_dashpot.ROW, spring_dashpot_tension.ROW, spring_dashpot_implicit.ROW, line_contact.ROW],
)
TANGENTIAL: Family[TangentialLaw] = Family(
    "tangential law",
    [frictionless.ROW, spring_slider.ROW, spring_slider_total.ROW, spring_slider_implicit.ROW, viscous_coulomb.ROW],
)
ROLLING: Family[RollingLaw] = Family("rolling law", [no_rolling.ROW, rolling_slider.ROW])
COHESION: Family[CohesionLaw] = Family("cohesion law", [no_cohesion.ROW, constant_pull.ROW])
LAWS: Mapping[str, Family] = {"normal": NORMAL, "tangential": TANGENTIAL, "rolling": ROLLING, "cohesion": COHESION}
NO_TANGENTIAL, NO_ROLLING, NO_COHESION = frictionless.ROW.key, no_rolling.ROW.key, no_cohesion.ROW.key
# what a contact has whose section in a scene names no law
DEFAULTS = {
    "normal": spring_dashpot.ROW.key,
    "tangential": spring_slider.ROW.key,
    "rolling": NO_ROLLING,
    "cohesion": NO_COHESION,
}
# with which the errors behind `accuracy:` of scenes were measured
MEASURED = {name: next(key for key, law in family.items() if law.measured) for name, family in LAWS.items()}

__all__ = [
    "COHESION",
    "DEFAULTS",
    "LAWS",
    "MEASURED",
    "NORMAL",
    "NO_COHESION",
    "NO_ROLLING",
    "NO_TANGENTIAL",
    "ROLLING",
    "TANGENTIAL",
    "Law",
]
