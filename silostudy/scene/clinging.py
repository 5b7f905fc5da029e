"""Overlap to which cohesion alone presses two grains into each other, and a caution where that is deep."""

from collections.abc import Iterator

from scipy.optimize import brentq

from silostudy.contact.family import Touch
from silostudy.dem.contacts import Contact
from silostudy.dem.model import Model
from silostudy.scene.cautions import DEEP
from silostudy.scene.coefficients import named_contacts


def deep_pulls(model: Model, kinds: tuple[str, ...]) -> Iterator[str]:
    """A caution for each contact whose cohesion presses the smallest grains deeper than DEEP of a radius, without any load."""
    least = float(model.radius.min())
    mass = float(model.mass[model.radius.argmin()])
    for name, contact, _, other in named_contacts(model, kinds):
        share = 0.5 if other is not None else 1.0  # of a grain's radius and mass in those of the contact
        law, radius = contact.laws.cohesion, share * least
        if law.acts and (deep := pulled_in(contact, Touch(mass=share * mass, radius=radius, dt=model.step), least)) > DEEP:
            told = "more than the radius" if deep > 1.0 else f"{deep:.1%} of the radius"
            yield f"{name}: {law.key} alone presses them {told} into each other; beyond {DEEP:.0%} contacts are too soft for it"


def pulled_in(contact: Contact, touch: Touch, radius: float) -> float:
    """Overlap over a radius (1) at which the normal law bears the attraction and no load; above 1 where it is deeper."""
    attraction, normal = contact.laws.cohesion, contact.laws.normal
    of_pull, of_normal = attraction.ordered(contact.coefficients), normal.ordered(contact.coefficients)

    def left_over(overlap: float) -> float:
        deep = float(attraction.pressed(overlap, touch.radius, of_pull))
        pressed = touch._replace(overlap=deep, before=deep)
        elastic, _ = normal.law(deep, 0.0, pressed, of_normal)
        return float(elastic - attraction.law(pressed, of_pull))

    if left_over(radius) < 0.0:
        return 2.0
    least = 1e-9 * radius
    return 0.0 if left_over(least) >= 0.0 else float(brentq(left_over, least, radius)) / radius
