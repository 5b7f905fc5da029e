"""Lines that tell a scene's contacts: the laws and their coefficients, those of contacts that differ one by one."""

from collections.abc import Iterator, Sequence
from dataclasses import replace
from math import hypot, sqrt

from silostudy.dem.contacts import Contact
from silostudy.dem.impact import restitutions
from silostudy.dem.model import Model
from silostudy.dem.varied import Varied
from silostudy.tables.constants import ROUNDED_GRAVITY

FINE = 32.0  # steps in one, for an impact without its error


def coefficient_lines(model: Model, kinds: Sequence[str] = ()) -> list[str]:
    """Lines on the laws between bodies and with walls, and on their coefficients; kinds: names of several kinds of bodies."""
    return [line(name, contact) for name, contact, *_ in named_contacts(model, kinds)]


def named_contacts(model: Model, kinds: Sequence[str] = ()) -> Iterator[tuple[str, Contact, int, int | None]]:
    """Contacts with names for them, the number of the kind, and of the other, None at walls; kinds: names of several kinds."""
    many = model.kinds > 1
    for kind in range(model.kinds):
        for other in range(kind + 1):
            name = f"{kinds[other]} and {kinds[kind]}" if many else f"{model.space.body}s"
            yield name, model.between(kind, other), kind, other
    for kind in range(model.kinds):
        prefix = f"{kinds[kind]} at " if many else ""
        for walls, contact in by_contact(model, kind):
            yield prefix + ", ".join(walls), contact, kind, None


def impact_lines(model: Model, kinds: Sequence[str] = ()) -> list[str]:
    """Lines on what the step makes of a restitution: least and largest of head-on impacts, by where in a step they begin."""
    speed = sqrt(2.0 * (hypot(*model.gravity) or ROUNDED_GRAVITY) * 2.0 * float(model.radius.min()))
    lines = []
    for kind in range(model.kinds):
        if model.between(kind, kind).laws.cohesion.acts:
            continue  # what clings does not come apart at every speed
        least, most = (of(restitutions(model, speed, kind)) for of in (min, max))
        fine = float(restitutions(replace(model, dt=model.dt / FINE), speed, kind).mean())
        name = f"{kinds[kind]} on {kinds[kind]}" if model.kinds > 1 else f"two {model.space.body}s"
        told = f"restitution of {name} that meet at {speed:.2g} m/s, after a fall of a diameter"
        lines.append(f"{told}: {least:.3f} to {most:.3f} at this step, {fine:.3f} at a fine one")
    return lines


def line(name: str, contact: Contact) -> str:
    """Laws that act, and their coefficients with units."""
    units = {
        coefficient.name: "" if coefficient.unit == "1" else f" {coefficient.unit}"
        for row in contact.rows
        for coefficient in row.coefficients
    }
    values = ", ".join(f"{key} {value:.6g}{units[key]}" for key, value in contact.coefficients.items())
    return f"{name}: {', '.join(row.key for row in contact.rows if row.acts)}: {values}"


def by_contact(model: Model, kind: int) -> Iterator[tuple[list[str], Contact]]:
    """Names of walls at which bodies of a kind have one contact, and that."""
    every = [model.at_wall(kind, number) for number in range(len(model.walls))]
    if not isinstance(model.wall_contact, Varied) or all(contact == every[0] for contact in every):
        yield ["walls"], every[0]
        return
    for number, contact in enumerate(every):
        if contact not in every[:number]:
            yield [wall.name for wall, other in zip(model.walls, every, strict=True) if other == contact], contact
