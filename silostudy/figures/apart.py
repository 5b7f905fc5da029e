"""Places of words beside a panel, so that names of lines close together stand clear of one another."""

from collections.abc import Iterable


def apart(values: Iterable[float], least: float) -> list[float]:
    """Places of rising values, each at least so far above the one before."""
    places: list[float] = []
    for value in values:
        places.append(max(value, places[-1] + least) if places else value)
    return places
