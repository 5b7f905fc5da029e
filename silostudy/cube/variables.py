"""Attributes of the cube's variables, from the contract."""

from collections.abc import Iterable, Sequence

import numpy as np

from silostudy.cube.contract import variable

DEPTH = {"standard_name": "depth", "positive": "down"}


def attributes(name: str, beside: Iterable = ()) -> dict[str, str]:
    """Unit and long name of a variable in a cube of these names, and of a depth which way it runs."""
    known = variable(name, beside)
    return {"units": known.units, "long_name": known.long_name, **(DEPTH if name == "depth" else {})}


def flags(long_name: str, meanings: Sequence[str]) -> dict:
    """Attributes of a variable whose values are positions in a list of meanings."""
    return {
        "long_name": long_name,
        "standard_name": "status_flag",
        "flag_values": np.arange(len(meanings), dtype=np.int8),
        "flag_meanings": " ".join(meanings),
    }
