"""Labels of axes: the units in them, and axes that have none."""

import re
from collections.abc import Iterator

import numpy as np
from matplotlib.axes import Axes
from matplotlib.category import StrCategoryFormatter
from matplotlib.figure import Figure
from matplotlib.ticker import FuncFormatter

from silostudy.tables.constants import STANDARD_GRAVITY

# unit as an axis writes it -> (dimension, size in SI)
UNITS = {
    "m": ("m", 1.0), "cm": ("m", 1e-2), "mm": ("m", 1e-3), "s": ("s", 1.0), "ms": ("s", 1e-3), "Hz": ("Hz", 1.0),
    "Pa": ("Pa", 1.0), "kPa": ("Pa", 1e3), "MPa": ("Pa", 1e6), "t/m²": ("Pa", 9806.65), "kN": ("N", 1e3), "N": ("N", 1.0),
    "N/m": ("N/m", 1.0), "kN/m": ("N/m", 1e3), "kN m": ("N m", 1e3), "N m": ("N m", 1.0), "disc weights": ("disc", 1.0),
    "m/s": ("m/s", 1.0), "cm/s": ("m/s", 1e-2), "m/s²": ("m/s²", 1.0), "gal": ("m/s²", 1e-2),
    "g": ("m/s²", STANDARD_GRAVITY), "°": ("rad", np.pi / 180),
    "kg": ("kg", 1.0), "kg/m": ("kg/m", 1.0), "rad": ("rad", 1.0), "%": ("1", 1e-2), "1": ("1", 1.0),
    "kg m⁻¹ s⁻¹": ("kg/m/s", 1.0), "kg/s": ("kg/s", 1.0),
}  # fmt: skip
IN_NAMES = {"t_m2": "t/m²", "m_s2": "m/s²", "m_s": "m/s", "deg": "°", "percent": "%", "disc_weights": "disc weights",
            "kN_m": "kN/m", "N_m": "N/m", "cm_s": "cm/s", "kg_m_s": "kg m⁻¹ s⁻¹", "kg_s": "kg/s", "kg_m": "kg/m"}  # fmt: skip
IN_CUBES = {"m s-2": "m/s²", "m s-1": "m/s", "N m-1": "N/m", "kg m-1 s-1": "kg m⁻¹ s⁻¹", "kg s-1": "kg/s"}
QUOTIENT = re.compile(
    r"\b(over|ratio|relative|factor|coefficient|share|chance|index|number|utilisation|C_eff)\b|/|=|²"
)  # has no unit
DEPTH = re.compile(r"^(relative )?depth\b")


def unit_of(label: str) -> tuple[str, float] | None:
    """(dimension, size in SI) of the unit that a label names; of a quotient, one; None where it says neither."""
    named = [UNITS[text] for text in re.findall(r"\(([^()]*)\)", label) if text in UNITS]
    named += [UNITS[label]] if label in UNITS else []
    return named[0] if named else ("1", 1.0) if QUOTIENT.search(label) else None


def unit_of_column(name: str, units: dict[str, str]) -> tuple[str, float] | None:
    """(dimension, size in SI) of the unit at the end of a column's name, or of the cube's variable of that name; else one."""
    parts = name.split("_")
    for length in (3, 2, 1):
        end = "_".join(parts[-length:])
        text = IN_NAMES.get(end, end)
        if len(parts) > length and text in UNITS:
            return UNITS[text]
    text = units.get(name, "1")
    return UNITS.get(IN_CUBES.get(text, text))


def is_categorical(axes: Axes, way: str) -> bool:
    """Whether an axis counts names instead of a quantity: its ticks, or those of an axis that it is shared with, are words."""
    axis = getattr(axes, f"{way}axis")
    if not isinstance(axis.get_major_formatter(), FuncFormatter | StrCategoryFormatter):  # what set_xticks with labels makes
        return False
    texts = [text.get_text() for one in _sharing(axes, way) for text in getattr(one, f"get_{way}ticklabels")()]
    return any(text and not _is_number(text) for text in texts)


def _sharing(axes: Axes, way: str) -> list[Axes]:
    """Axes, and those that they share an axis with."""
    others = getattr(axes, f"get_shared_{way}_axes")().get_siblings(axes) if axes.name == "rectilinear" else []
    return [axes, *(one for one in others if one is not axes)]


def _is_number(text: str) -> bool:
    try:
        float(text.replace("\N{MINUS SIGN}", "-"))
    except ValueError:
        return False
    return True


def label_of(axes: Axes, way: str) -> str:
    """The label that an axis carries, or another that it is shared with, or the figure."""
    labels = [getattr(one, f"get_{way}label")() for one in _sharing(axes, way)]
    labels.append(getattr(axes.get_figure(), f"get_sup{way}label")())
    return next((label for label in labels if label), "")


def panels(figure: Figure) -> list[Axes]:
    """The axes that are seen, with the further scales on their edges."""
    seen = [axes for axes in figure.axes if axes.get_visible() and axes.axison]
    return [one for axes in seen for one in (axes, *axes.child_axes)]


def unlabelled(figure: Figure, drawn: set[str]) -> Iterator[str]:
    """Axes with tick labels whose label names no unit and no quotient."""
    for axes in panels(figure):
        for way in "xy":
            axis = getattr(axes, f"{way}axis")
            shown = [text for text in (*axis.get_ticklabels(), *axis.get_ticklabels(minor=True)) if id(text) in drawn]
            label = label_of(axes, way)
            if shown and not is_categorical(axes, way) and unit_of(label) is None:
                yield f"{way} axis of {axes.get_title()!r} says {label!r}: no unit"


def rising_depths(figure: Figure) -> Iterator[str]:
    """Axes of depth that do not run down."""
    for axes in panels(figure):
        if DEPTH.match(axes.get_xlabel()):
            yield f"{axes.get_xlabel()!r} runs across"
        if DEPTH.match(label_of(axes, "y")) and not axes.yaxis_inverted():
            yield f"{label_of(axes, 'y')!r} runs up"


# ---- data ----
