"""What is told of a scene's contacts: the laws and their coefficients, of contacts that differ each its own."""

from collections.abc import Iterator, Sequence

from silostudy.dem.contacts import Contact
from silostudy.dem.varied import Varied


def coefficient_lines(bodies: str, between: Contact, at_walls: Contact | Varied, walls: Sequence[str]) -> list[str]:
    """Lines on the laws between bodies and with walls of these names, and on their coefficients."""
    return [line(bodies, between), *(line(", ".join(names), contact) for names, contact in by_contact(at_walls, walls))]


def line(name: str, contact: Contact) -> str:
    """Laws that act, and their coefficients with units."""
    units = {one.name: "" if one.unit == "1" else f" {one.unit}" for row in contact.rows for one in row.coefficients}
    values = ", ".join(f"{key} {value:.6g}{units[key]}" for key, value in contact.coefficients.items())
    return f"{name}: {', '.join(row.key for row in contact.rows if row.acts)}: {values}"


def by_contact(contact: Contact | Varied, walls: Sequence[str]) -> Iterator[tuple[list[str], Contact]]:
    """Names of walls that have one contact, and that."""
    if isinstance(contact, Contact):
        yield ["walls"], contact
        return
    for number, one in enumerate(contact.sets):
        if one not in contact.sets[:number]:
            yield [wall for wall, other in zip(walls, contact.sets, strict=True) if other == one], one
