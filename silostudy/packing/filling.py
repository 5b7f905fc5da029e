"""Ways to fill a silo with spheres: a family; where they stand at the start, or that they rain in."""

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from typing import Any

import numpy as np

from silostudy.catalogue import Entry, Family
from silostudy.errors import BadInput
from silostudy.packing.family import PackingField

MOST = 20_000_000  # places of a layer: twice as many as spheres that a scene may have
ROOM = 2.1  # of the largest radius: pitch of the lattice


@dataclass(frozen=True, kw_only=True)
class Filling(Entry):
    """Start of spheres. place(silo, radii, random) -> places (n, 3; m); None where they rain in, or a file says where they are.

    asks: fields of a scene's section `filling`.
    """

    asks: tuple[PackingField, ...]
    place: Callable[..., np.ndarray] | None = None
    rains: bool = False
    from_file: bool = False

    def arguments(self, section: Any) -> Mapping[str, Any]:
        """Values that a section gives, by the names of its arguments."""
        return {field.argument: getattr(section, field.name) for field in self.asks}


def loose(silo, radii, random):
    """Places (m) of spheres on a wide lattice in a silo from its bottom upward, each a little off; BadInput where it is full.

    silo: has `outline(z)`, `top` (m) and `room_at(places, radius)`.
    """
    largest = float(radii.max())
    pitch, places = ROOM * largest, np.empty((0, 3))
    for z in np.arange(1.05 * largest, silo.top - largest, pitch):
        low, high = silo.outline(z).box
        if (across := float(np.prod((high - low) / pitch))) > MOST:
            allowed = f"a layer of spheres of {2e3 * largest:g} mm would hold {across:.2g} of them, at most {MOST:g} can be"
            raise BadInput("silo", f"{high[0] - low[0]:g} m wide", allowed)
        x, y = (
            axis.ravel()
            for axis in np.meshgrid(*(np.arange(a, b, pitch) + 0.5 * pitch for a, b in zip(low, high, strict=True)))
        )
        layer = np.c_[x, y, np.full_like(x, z)]
        places = np.vstack([places, layer[silo.room_at(layer, 1.05 * largest)]])
        if len(places) >= len(radii):
            return places[: len(radii)] + 0.04 * largest * random.uniform(-1.0, 1.0, (len(radii), 3))
    raise BadInput("filling.count", len(radii), f"no room for sphere {len(places)}: the silo holds so many on a loose lattice")


def spread(silo, radii, random):
    """Places (m) of a loose lattice that is drawn out over the whole height, as for a drum that lies on its side.

    silo: as for `loose`; it must not be narrower above.
    """
    place, least = loose(silo, radii, random), ROOM / 2.0 * float(radii.max())
    low, high = place[:, 2].min(), place[:, 2].max()
    place[:, 2] = low + (place[:, 2] - low) * (max(silo.top - least, high) - low) / max(high - low, least)
    return place


COUNT = PackingField(name="count", argument="count", text="number of spheres", kind=int, bounds={"ge": 1, "le": 10_000_000})
FILLINGS: Family[Filling] = Family(
    "filling",
    [
        Filling(
            key="rain",
            title="Rain from a level plane, each where it touches nothing",
            asks=(
                COUNT,
                PackingField(name="rate_1_s", argument="rate", text="spheres a second", unit="s-1", bounds={"gt": 0}),
                PackingField(
                    name="height_m",
                    argument="height",
                    text="height of the plane above the outlet; null: just below the top of the walls",
                    unit="m",
                    kind=float | None,
                    bounds={"gt": 0},
                    default=None,
                ),
                PackingField(
                    name="speed_m_s",
                    argument="speed",
                    text="speed of fall on the plane",
                    unit="m s-1",
                    bounds={"ge": 0},
                    default=1.0,
                ),
                PackingField(
                    name="width_m",
                    argument="width",
                    text="width of the stream, about silo.filling_eccentricity_m off the axis; null: from wall to wall",
                    unit="m",
                    kind=float | None,
                    bounds={"gt": 0},
                    default=None,
                ),
            ),
            rains=True,
        ),
        Filling(key="loose", title="A loose lattice from the bottom upward, to fall", asks=(COUNT,), place=loose),
        Filling(key="spread", title="A loose lattice drawn out over the whole height, to fall", asks=(COUNT,), place=spread),
        Filling(
            key="given",
            title="Positions from a file",
            asks=(
                PackingField(
                    name="file",
                    argument="file",
                    text="netCDF file with grain_x, grain_y, grain_z, grain_radius (m; its last snapshot), beside the scene",
                    unit="",
                    kind=str,
                ),
            ),
            from_file=True,
        ),
    ],
)
