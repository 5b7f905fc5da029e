"""Units of acceleration: those a user may name, and whether a file that says its own agrees."""

import re
from collections.abc import Iterable

from silostudy.errors import BadInput
from silostudy.tables.constants import STANDARD_GRAVITY

UNITS = {"g": STANDARD_GRAVITY, "gal": 0.01, "m_s2": 1.0}  # accelerations a user may name, in m s-2
# how files spell them, after `_plain`
SPELLINGS = {"g": "g", "gal": "gal", "gals": "gal", "cm/s2": "gal", "cm/s/s": "gal", "cms-2": "gal",
             "m/s2": "m_s2", "m/s/s": "m_s2", "ms-2": "m_s2"}  # fmt: skip
# what files may say and no user may name: other accelerations, speeds, counts of a digitiser, lengths
OTHERS = ("mg", "mm/s2", "mm/s/s", "in/s2", "ft/s2", "cm/s", "m/s", "mm/s", "in/s", "ft/s", "count", "counts")
LENGTHS = ("m", "cm", "mm")


def said_unit(text: str) -> str | None:
    """The key of the unit that a text spells; the text itself where it is a unit of another kind; None where it is none."""
    plain = _plain(text)
    return SPELLINGS.get(plain) or (text.strip() if plain in (*OTHERS, *LENGTHS) else None)


def unit_in(texts: Iterable[str]) -> str | None:
    """The one unit in brackets, or at the end of a column's name, above the numbers; None where there are none or several."""
    brackets = [part for text in texts for part in re.findall(r"[(\[]([^()\[\]]+)[)\]]", text)]
    endings = [part.replace("_", "/") for text in texts for part in re.findall(r"^\w+_(g|gal|[cm]?m_s2?|counts?)$", text)]
    said = {said_unit(part) for part in (*brackets, *endings)} - {None, *LENGTHS}  # lengths: of a station, not of the motion
    return said.pop() if len(said) == 1 else None


def agreed(told: str | None, said: str | None, where: str) -> float:
    """Factor to m s-2 of the unit that the study tells and the file says; BadInput where neither does, or the two disagree."""
    if said is not None and said not in UNITS:
        raise BadInput("unit", said, f"the file says it, and it is no acceleration in {', '.join(UNITS)}", where)
    if told and said and told != said:
        raise BadInput("acceleration_unit", told, f"disagrees with the file, which says {said}", where)
    unit = told or said
    if unit is None:
        raise BadInput("acceleration_unit", None, f"the file does not say it; one of {', '.join(UNITS)}", where)
    return UNITS[unit]


def _plain(text: str) -> str:
    """A unit's spelling without blanks, powers' signs and long words: cm/sec^2 and cm/s**2 are cm/s2."""
    lower = re.sub(r"\s|\*\*|\^|\*|\.$", "", text.lower()).replace("²", "2")
    return re.sub(r"se?c", "s", lower)
