"""Calling the functions of pressure methods by the names of their parameters."""

from collections.abc import Callable, Iterable, Mapping
from inspect import Parameter, Signature, signature


def parameters_of(function: Callable) -> tuple[str, ...]:
    """The keyword parameters of a method function, in order (all but the depth z or the height x)."""
    return tuple(name for name in signature(function).parameters if name not in ("z", "x"))


def asking(function: Callable, names: Iterable[str], doc: str, place: str | None = "z") -> Callable:
    """The function of (place, **parameters) with its parameters and docstring spelled out, as a method's table needs it."""
    first = [Parameter(place, Parameter.POSITIONAL_OR_KEYWORD)] if place else []
    keywords = [Parameter(name, Parameter.KEYWORD_ONLY) for name in dict.fromkeys(names)]
    function.__doc__ = doc
    setattr(function, "__signature__", Signature([*first, *keywords]))  # noqa: B010
    return function


def first_line(function: Callable) -> str:
    """First line of a function's docstring: what it gives."""
    return (function.__doc__ or "").splitlines()[0]


def call(function: Callable, place, available: Mapping):
    """The function at a depth or height (None: it has no place), handed the available parameters that it asks for."""
    handed = {name: available[name] for name in parameters_of(function)}
    return function(**handed) if place is None else function(place, **handed)
