"""Cautions on contacts that do nothing of what a scene says: values that no law takes, laws that resist nothing."""

from collections.abc import Iterator
from typing import Any

from silostudy.config.contact import LawsConfig
from silostudy.config.surfaces import Apart
from silostudy.contact.family import USUAL, CohesionLaw, Law
from silostudy.dem.model import Model
from silostudy.scene.cautions import parts
from silostudy.scene.coefficients import named_contacts

RESISTING = ("rolling", "twisting", "cohesion")  # families whose laws a scene chooses for what they do
PRESSED = USUAL._replace(overlap=1e-4, before=1e-4)  # a contact that laws are tried on


def untaken(config: Any, above: str = "") -> Iterator[str]:
    """A caution for each value of a section, and further in, that no law chosen there takes, and for differences of nothing."""
    if isinstance(config, LawsConfig):
        yield from _told(above.removesuffix("."), config, config.untaken)
    for name, value in parts(config):
        if name in ("pairs", "surfaces") and hasattr(config, "touches"):
            yield from _of_differences(config, value, f"{above}{name}.")
        else:
            yield from untaken(value, f"{above}{name}.")


def _of_differences(scene: Any, sections: Any, above: str) -> Iterator[str]:
    grains, walls = scene.touches
    for name, apart in parts(sections):
        if not apart.given:
            yield f"{above}{name} says nothing: all is as elsewhere"
            continue
        base = grains if _between_grains(scene, apart) else walls
        given = {field: value for field, value in apart.given.items() if field in base.model_dump()}
        families = base.with_values(given).untaken
        yield from _told(f"{above}{name}", apart, {field: family for field, family in families.items() if field in given})


def _between_grains(scene: Any, apart: Apart) -> bool:
    kinds = scene.grain_kinds if hasattr(scene, "grain_kinds") else scene.kinds
    return set(getattr(apart, "between", ("",))) <= set(kinds)


def _told(section: str, config: Any, families: dict[str, tuple[str, str]]) -> Iterator[str]:
    for field, (family, law) in families.items():
        yield f"{section}.{field} = {getattr(config, field):g}: no chosen law takes it: {family} is {law}"


def powerless(model: Model, kinds: tuple[str, ...]) -> Iterator[str]:
    """A caution for each law of rolling, twisting or cohesion that does nothing, with the coefficients that are zero."""
    for name, contact, *_ in named_contacts(model, kinds):
        for family in RESISTING:
            law = getattr(contact.laws, family)
            zero = [key.name for key in law.coefficients if contact.coefficients[key.name] == 0.0]
            if law.acts and zero and not _does(law, law.ordered(contact.coefficients)):
                does = "pulls" if isinstance(law, CohesionLaw) else "resists"
                yield f"{name}: {family} = {law.key} with {', '.join(f'{key} 0' for key in zero)}: it {does} nothing"


def _does(law: Law, c: tuple[float, ...]) -> bool:
    """Whether a law gives a force or a moment on a contact that is pressed and turns."""
    force = law.law(PRESSED, c) if isinstance(law, CohesionLaw) else law.law(0.0, 0.1, PRESSED, 1.0, c)[1]
    return bool(force != 0.0)
