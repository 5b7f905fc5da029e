"""Errors of bad input: always with the field, the value and what is allowed, before any long work starts."""

from collections.abc import Iterable, Iterator, Mapping
from contextlib import contextmanager


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

    def placed(self, where: str, keys: Mapping[str, str]) -> None:
        """Let the message name a file where it names none, and the file's own key in place of a first word in `keys`."""
        first, dot, further = self.field.partition(".")
        self.field, self.where = keys.get(first, first) + dot + further, self.where or where
        self.args = (f"{self.where}: {self.reason}" if self.where else self.reason,)


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


@contextmanager
def within(where: str = "", keys: Mapping[str, str] | None = None) -> Iterator[None]:
    """Errors of bad input from within name this file where they name none, and its own keys in place of arguments.

    keys: the file's key of the first word of a field.
    """
    try:
        yield
    except BadInput as error:
        error.placed(where, keys or {})
        raise
