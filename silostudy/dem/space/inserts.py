"""Inserts of a silo of spheres: a family; surfaces inside it that push on both sides, and what each asks of the user."""

from typing import Literal, TypeAlias

from silostudy.catalogue import Family
from silostudy.dem.inserts import NAME, Insert, Pair
from silostudy.dem.space.walls import FlatPiece, TurnedLine
from silostudy.errors import BadInput
from silostudy.packing.family import PackingField

BOTH = "both"  # sides of an insert that push
FRONT = "front"


def polygon(name: str, corners: tuple, side: str, sheet: str = "") -> FlatPiece:
    """A flat piece that pushes on both sides, or on the side that its corners run counter-clockwise from."""
    return FlatPiece(name=name, corners=corners, front_only=side == FRONT, faces=1 if side == FRONT else 2, sheet=sheet)


def cone(name: str, radii: tuple[float, float], heights: tuple[float, float], axis: tuple[float, float]) -> TurnedLine:
    """A cone or frustum; its line starts where it is narrower, so that its front looks up."""
    if not max(radii) > 0.0:
        raise BadInput(f"{name}.radii_m", radii, "one of both must be above 0")
    start, end = sorted(zip(radii, heights, strict=True))
    return TurnedLine(name=name, start=start, end=end, axis=axis, faces=2)


def cylinder(name: str, radius: float, heights: tuple[float, float], axis: tuple[float, float]) -> TurnedLine:
    """A piece of a cylinder; its front looks inward."""
    low, high = sorted(heights)
    return TurnedLine(name=name, start=(radius, low), end=(radius, high), axis=axis, faces=2)


def disc(name: str, radius: float, hole: float, height: float, axis: tuple[float, float]) -> TurnedLine:
    """A level disc, or a ring about a hole; its front looks up."""
    if not hole < radius:
        raise BadInput(name, hole, f"the radius of its hole must be less than its own, {radius:g} m")
    return TurnedLine(name=name, start=(hole, height), end=(radius, height), axis=axis, faces=2)


Corner: TypeAlias = tuple[float, float, float]
AXIS = PackingField(name="axis_m", argument="axis", text="x and y of its upright axis", unit="m", kind=Pair, default=(0.0, 0.0))
HEIGHTS = PackingField(
    name="heights_m", argument="heights", text="heights of its two ends above the outlet", unit="m", kind=Pair
)
RADIUS = PackingField(name="radius_m", argument="radius", text="radius", unit="m", bounds={"gt": 0})
INSERTS: Family[Insert] = Family(
    "insert",
    [
        Insert(
            key="polygon",
            title="A convex plane polygon",
            asks=(
                NAME,
                PackingField(
                    name="corners_m", argument="corners", text="corners in order, x, y, z each", unit="m",
                    kind=tuple[Corner, ...],
                ),
                PackingField(
                    name="side", argument="side", unit="", kind=Literal[BOTH, FRONT], default=BOTH,
                    text="whether both sides push, or the front alone, from which its corners run counter-clockwise: then "
                    "nothing behind it may reach it",
                ),
                PackingField(
                    name="sheet", argument="sheet", unit="", kind=str, default="",
                    text="name of a curved sheet: facets of one name that share a side and turn there by less than 15 degrees "
                    "push once, from their nearest point (`silostudy facets` writes them from a mesh)",
                ),
            ),
            make=polygon,
        ),
        Insert(
            key="cone",
            title="A cone or frustum, upright or inverted",
            asks=(
                NAME,
                PackingField(name="radii_m", argument="radii", text="radii of its two ends, 0 at an apex", unit="m", kind=Pair),
                HEIGHTS,
                AXIS,
            ),
            make=cone,
        ),
        Insert(key="cylinder", title="A piece of a cylinder", asks=(NAME, RADIUS, HEIGHTS, AXIS), make=cylinder),
        Insert(
            key="disc",
            title="A level disc or ring",
            asks=(
                NAME,
                RADIUS,
                PackingField(name="hole_radius_m", argument="hole", text="radius of the hole in it", unit="m", default=0.0,
                             bounds={"ge": 0}),
                PackingField(name="height_m", argument="height", text="height above the outlet", unit="m"),
                AXIS,
            ),
            make=disc,
        ),
    ],
)  # fmt: skip
