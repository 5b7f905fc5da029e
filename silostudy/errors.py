"""Errors of bad input: always with the field, the value and what is allowed, before any long work starts."""

from collections.abc import Iterable


class BadInput(ValueError):
    """A mistake in what the user asked for; the command line prints it as one line and stops with status 2."""

    def __init__(self, field: str, value: object, allowed: str, where: str = ""):
        self.field, self.value, self.allowed, self.where = field, value, allowed, where
        super().__init__(f"{where}: {self.reason}" if where else self.reason)

    @property
    def reason(self) -> str:
        return f"{self.field} = {self.value!r}: {self.allowed}"

    def __reduce__(self):
        return type(self), (self.field, self.value, self.allowed, self.where)


class NotYet(BadInput):
    """A file that is not there yet, and is made by the study `maker`."""

    def __init__(self, field: str, value: object, allowed: str, where: str = "", maker: str = ""):
        super().__init__(field, value, allowed, where)
        self.maker = maker

    def __reduce__(self):
        return type(self), (self.field, self.value, self.allowed, self.where, self.maker)


def unknown(field: str, value: object, known: Iterable[str], where: str = "") -> BadInput:
    """The error for a key that no table or family holds; it lists the known ones."""
    return BadInput(field, value, f"unknown; known: {', '.join(known)}", where)
