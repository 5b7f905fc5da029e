"""Numbers that a run comes to, which a scene may expect beforehand: a family, each found from what the run recorded."""

from collections.abc import Callable
from dataclasses import dataclass
from math import nan
from typing import Literal

import numpy as np

from silostudy.catalogue import Entry, Family
from silostudy.packing.family import PackingField

WAYS = ("x", "y", "z")
STEADY = (0.2, 0.8)  # share of what came out between which a flow counts as steady


@dataclass(frozen=True)
class Looks:
    """Record of a run: places (n, d; m) and radii (m) at snapshots; mass (kg, discs kg/m) that had left by times (s)."""

    places: tuple[np.ndarray, ...]
    radii: tuple[np.ndarray, ...]
    times: tuple[float, ...]
    left_time: np.ndarray
    left_mass: np.ndarray
    up: np.ndarray  # unit vector against gravity at the end
    load: float = nan  # N, downward on all surfaces of a scene of spheres, mean over the last window


@dataclass(frozen=True, kw_only=True)
class Outcome(Entry):
    """Quantity of a run. find(looks, **arguments) -> the number, NaN where the run did not show it; of_snapshots, of_windows:
    whether it is seen on snapshots, or in windows of wall forces; of_outflow: whether it is one of what leaves.

    unit: of the number; suffix: of the names of its fields in a scene, and of its attributes in a cube; grains: of which it
    is the quantity.
    """

    unit: str
    suffix: str
    find: Callable[..., float]
    asks: tuple[PackingField, ...]
    of_snapshots: bool = False
    of_windows: bool = False
    of_outflow: bool = False
    grains: tuple[str, ...] = ("discs", "spheres")


def mass_out(looks: Looks) -> float:
    """Mass (kg, of discs kg/m) that had left through the outlet at the end."""
    return float(looks.left_mass.max(initial=0.0))


def load_at_end(looks: Looks) -> float:
    """Load (N) on all surfaces in the last window."""
    return looks.load


def steady_outflow(looks: Looks) -> float:
    """Rate (kg/s, of discs kg/(m s)) of the mass that left: slope of a line through the middle three fifths of it."""
    mass, most = looks.left_mass, looks.left_mass.max(initial=0.0)
    steady = (mass >= STEADY[0] * most) & (mass <= STEADY[1] * most)
    return float(np.polyfit(looks.left_time[steady], mass[steady], 1)[0]) if steady.sum() > 2 else np.nan


def heap_height(looks: Looks, floor: float) -> float:
    """Height (m) of the topmost grain above a floor (m), at the last snapshot."""
    tops = looks.places[-1] @ looks.up + looks.radii[-1] if looks.places else np.empty(0)
    return float(tops.max() - floor) if len(tops) else np.nan


def surface_angle(looks: Looks, along: str, start: float, end: float, after: float) -> float:
    """Inclination (degrees) of the free surface along a direction between two places (m), mean over the snapshots after a time.

    The surface is a line through the topmost grains of strips as wide as the largest grain.
    """
    way = WAYS.index(along)
    slopes = [
        _slope(places[:, way], places @ looks.up + radii, start, end, 2.0 * radii.max())
        for places, radii, time in zip(looks.places, looks.radii, looks.times, strict=True)
        if time >= after and len(radii)
    ]
    return float(np.mean(np.degrees(np.arctan(np.abs(slopes))))) if slopes else np.nan


def _slope(across: np.ndarray, tops: np.ndarray, start: float, end: float, width: float) -> float:
    """Slope (1) of a line through the highest top of each strip of a width (m) between two places (m)."""
    count = max(3, int((end - start) / width))
    strip = np.floor((across - start) / (end - start) * count).astype(int)
    inside = (strip >= 0) & (strip < count)
    highest = np.full(count, -np.inf)
    np.maximum.at(highest, strip[inside], tops[inside])
    there = np.isfinite(highest)
    middle = start + (np.arange(count) + 0.5) * (end - start) / count
    return float(np.polyfit(middle[there], highest[there], 1)[0]) if there.sum() > 2 else np.nan


def _published(suffix: str, unit: str) -> tuple[PackingField, ...]:
    """Fields that every quantity asks for: its published number, how far a run may be off, and where it stands."""
    return (
        PackingField(name=f"value_{suffix}", text="published number", unit=unit),
        PackingField(name=f"tolerance_{suffix}", text="how far from it a run may come out", unit=unit, bounds={"gt": 0}),
        PackingField(name="source", text="key in references.bib, or a citation in words", kind=str, unit=""),
        PackingField(name="locator", text="where it stands there", kind=str, unit=""),
    )


SURFACE = (
    PackingField(name="along", argument="along", text="way along which it falls", kind=Literal["x", "y", "z"], unit=""),
    PackingField(name="from_m", argument="start", text="where the line through the surface begins", unit="m"),
    PackingField(name="to_m", argument="end", text="where it ends", unit="m"),
    PackingField(name="after_s", argument="after", text="snapshots before this time do not count", unit="s", default=0.0),
)
OUTCOMES: Family[Outcome] = Family(
    "quantity",
    [
        Outcome(
            key="steady-outflow",
            title="Rate of the mass that leaves, over its middle three fifths",
            suffix="kg_s",
            unit="kg s-1",
            find=steady_outflow,
            asks=_published("kg_s", "kg s-1"),
            of_outflow=True,
        ),
        Outcome(
            key="discharged-mass",
            title="Mass that had left through the outlet at the end",
            suffix="kg",
            unit="kg",
            find=mass_out,
            asks=_published("kg", "kg"),
            of_outflow=True,
        ),
        Outcome(
            key="wall-load",
            title="Downward load on all surfaces, mean over the last window",
            suffix="N",
            unit="N",
            find=load_at_end,
            asks=_published("N", "N"),
            of_windows=True,
            grains=("spheres",),
        ),
        Outcome(
            key="heap-height",
            title="Height of the topmost grain at the last snapshot",
            suffix="m",
            unit="m",
            find=heap_height,
            asks=(
                *_published("m", "m"),
                PackingField(name="floor_m", argument="floor", text="level of the floor below it", unit="m", default=0.0),
            ),
            of_snapshots=True,
        ),
        Outcome(
            key="surface-angle",
            title="Inclination of the free surface, mean of snapshots",
            suffix="deg",
            unit="degree",
            find=surface_angle,
            asks=(*_published("deg", "degree"), *SURFACE),
            of_snapshots=True,
        ),
    ],
)
