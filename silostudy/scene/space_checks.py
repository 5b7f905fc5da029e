"""Silos that have no surfaces in space are refused, each in one line."""

from __future__ import annotations

from dataclasses import replace
from itertools import combinations
from math import atan2, degrees, pi, radians
from typing import TYPE_CHECKING

from silostudy.dem.space.cells import faces
from silostudy.dem.space.joints import ends, flat_joints
from silostudy.dem.space.level import Outline
from silostudy.dem.space.rows import CIRCLE, RECTANGLE
from silostudy.dem.space.walls import FlatPiece, Surface, TurnedLine
from silostudy.errors import BadInput

if TYPE_CHECKING:
    from silostudy.scene.space_silo import Outlet, SpaceSilo

PLANS = ("circular", "square", "rectangular", "polygonal")
MOST_SIDES = 24  # with more, a sphere pressed in by 1/cos(15 degrees) - 1 = 3.5 % of its radius passes a corner with a jump
SHALLOWEST = radians(5.0)  # between a wall and the hopper below it: both push where less turns the sphere about
FLATTEST = 1e-6  # height of a hopper over the silo's width


def require_surfaces(space: SpaceSilo) -> None:
    """BadInput for a plan, a hopper or an outlet that cannot be built, or that the engine has no surfaces for."""
    silo = space.silo
    if silo.plan not in PLANS:
        raise BadInput("silo.plan", silo.plan, f"has no end walls, which grains in space need; known: {', '.join(PLANS)}")
    if silo.plan == "polygonal" and not 3 <= silo.sides <= MOST_SIDES:
        allowed = f"must be from 3 to {MOST_SIDES}: corners of more sides are too flat for spheres; take a circular plan"
        raise BadInput("silo.sides", silo.sides, allowed)
    if not silo.wall_depth + space.freeboard > 0.0:
        raise BadInput("silo.cylinder_depth_m", silo.wall_depth, "the vertical walls must have a height")
    if silo.hopper:
        require_hopper(space)
    else:
        require_floor(space)
    require_inserts(space)


def require_hopper(space: SpaceSilo) -> None:
    """BadInput for a hopper without a height, an outlet that leaves it, or a wall next to upright."""
    silo, hopper = space.silo, space.silo.hopper
    assert hopper is not None
    if space.outlets:
        raise BadInput(
            "outlets", space.outlets[0].name, "is of a flat floor; the hopper has its own, silo.hopper.outlet_width_m"
        )
    if space.wedge and space.plan.sides != RECTANGLE:
        raise BadInput("wedge", space.wedge, f"stands below a square or rectangular plan, not a {silo.plan} one")
    if not 0.0 <= hopper.outlet_width <= silo.diameter:
        allowed = f"must be from 0 to below the width of the hopper's top, {silo.diameter:g} m"
        raise BadInput("silo.hopper.outlet_width_m", hopper.outlet_width, allowed)
    angle = float(f"{degrees(hopper.half_angle):.12g}")
    if not 0.0 < hopper.half_angle < pi / 2:
        raise BadInput("silo.hopper.half_angle_deg", angle, "must be above 0 and below 90: the hopper must have a height")
    if not silo.hopper_height > FLATTEST * silo.diameter:
        allowed = f"the hopper must have a height: an outlet narrower than its top, {silo.diameter:g} m, at {angle:g} degrees"
        raise BadInput("silo.hopper.outlet_width_m", hopper.outlet_width, allowed)
    most, opening = (silo.diameter - hopper.outlet_width) / 2, space.opening
    assert opening is not None
    if space.plan.room_for(opening) < -1e-12 * silo.diameter:
        allowed = f"must not be above {most:g} m: the outlet must not leave the floor"
        raise BadInput("silo.outlet_eccentricity_m", silo.outlet_eccentricity, allowed)
    turn, is_cone = shallowest_joint(space), space.plan.sides == CIRCLE
    if turn < SHALLOWEST and (is_cone or turn > 0.0):  # flat faces may go on in the wall's plane
        allowed = f"the hopper's wall stands {round(degrees(turn), 6):.2g} degrees off the wall above it: at least 5"
        allowed += " all around a cone" if is_cone else ", or none at all"
        if silo.outlet_eccentricity:
            raise BadInput("silo.outlet_eccentricity_m", silo.outlet_eccentricity, allowed)
        raise BadInput("silo.hopper.half_angle_deg", angle, allowed)


def shallowest_joint(space: SpaceSilo) -> float:
    """Least angle (rad) between a face of the hopper and the wall above it, of those that are not one plane."""
    opening, plan = space.opening, space.plan
    assert opening is not None
    high = space.silo.hopper_height
    if plan.sides == CIRCLE:
        return atan2(max(plan.room_for(opening), 0.0), high)
    spans = plan.half * 2 if plan.sides == RECTANGLE else plan.half[:1] * plan.sides
    runs = [span - opening.reach(way) for span, way in zip(spans, plan.normals, strict=True)]
    return min((atan2(run, high) for run in runs if run > FLATTEST * space.silo.diameter), default=0.0)


def require_floor(space: SpaceSilo) -> None:
    """BadInput for an outlet that does not lie in the flat floor with floor about it; a slot may run from wall to wall."""
    if space.wedge:
        raise BadInput("wedge", space.wedge, "is a hopper's; the silo has none")
    names = [outlet.name for outlet in space.outlets]
    if len(set(names)) < len(names):
        raise BadInput("outlets", names, "each outlet needs a name of its own")
    for number, outlet in enumerate(space.outlets):
        require_outlet(space, f"outlets.{number}", outlet)
    for (name, low), (other, high) in combinations(space.openings.items(), 2):
        if not (room := low.gap_to(high)) > 0.0:
            raise BadInput("outlets", f"{name}, {other}", f"must not overlap or touch, and do by {-room:.4g} m")


def require_outlet(space: SpaceSilo, field: str, outlet: Outlet) -> None:
    """BadInput for an outlet that is no smaller than the floor, or leaves it; a slot may run across a rectangle one way."""
    plan, opening = space.plan, space.openings[outlet.name]
    rectangles = plan.sides == RECTANGLE and outlet.length is not None
    across = plan.crossed_by(opening) if rectangles else (False, False)
    for name, size, half in zip(("width", "length"), (outlet.width, outlet.length), plan.half, strict=True):
        whole = sum(across) == 1 and size == 2 * half
        if size is not None and not (0.0 < size < 2 * half or whole):
            allowed = f"must be above 0 and below the width of the floor there, {2 * half:g} m"
            slot = "; a slot may be as long as that one way, to run from wall to wall" if rectangles else ""
            raise BadInput(f"{field}.{name}_m", size, allowed + slot)
    room = room_beside(plan, opening, across) if any(across) else plan.room_for(opening)
    if not room > 0.0:
        key = "silo.outlet_eccentricity_m" if outlet.middle is None else f"{field}.middle_m"
        allowed = f"the outlet must not leave the floor, and stands out by {-room:g} m"
        if room > -FLATTEST * space.silo.diameter:
            allowed = "the outlet touches the wall: all of it must lie inside the floor"
        raise BadInput(key, opening.middle[0] if outlet.middle is None else outlet.middle, allowed)


def room_beside(plan: Outline, slot: Outline, across: tuple[bool, bool]) -> float:
    """Least distance (m) from a rectangle to the sides of a slot in it; negative where that leaves it.

    across: the ways that it runs from wall to wall, where it has no distance unless it is off the middle.
    """
    beside = across.index(False)
    aside = abs(slot.middle[1 - beside])
    return -aside if aside else plan.half[beside] - slot.half[beside] - abs(slot.middle[beside])


def require_inserts(space: SpaceSilo) -> None:
    """BadInput for an insert without a name of its own, or that leaves the silo, or that folds on others at one side."""
    named = [surface.name for surface in replace(space, inserts=()).walls()] if space.inserts else []
    parts = {name.partition("_")[0] for name in named}
    for number, insert in enumerate(space.inserts):
        field = f"inserts.{number}"
        if insert.name in named or insert.name.partition("_")[0] in parts:
            raise BadInput(f"{field}.name", insert.name, f"is taken; taken by then: {', '.join(named)}")
        own = [face.name for face in faces((insert,), "")]
        if taken := [name for name in own if name in named]:
            told = f"has a back recorded as {taken[0]}, which is taken"
            raise BadInput(f"{field}.name", insert.name, told)
        named += own
        for z, outline in brims(insert):
            inside = space.outline(z)
            (x, y), (mx, my) = outline.middle, inside.middle
            around = replace(outline, middle=(x - mx, y - my))
            if not (0.0 <= z <= space.top and inside.room_for(around) > -FLATTEST * space.silo.diameter):
                raise BadInput(field, insert.name, f"leaves the silo at x {x:.4g}, y {y:.4g}, z {z:.4g} m")
    sides = [side for first, second, k, n in flat_joints(space.inserts) for side in ((first, k), (second, n))]
    for number, side in sides:
        if sides.count((number, side)) > 1:
            told = f"meets more than one polygon along its side {side + 1}"
            raise BadInput(f"inserts.{number}", space.inserts[number].name, told)


def brims(insert: Surface) -> list[tuple[float, Outline]]:
    """Heights (m) and circles that span an insert: of a polygon its corners, circles of no radius."""
    if isinstance(insert, TurnedLine):
        return [(z, Outline(sides=int(CIRCLE), half=(r, r), middle=insert.axis)) for r, z in ends(insert)]
    assert isinstance(insert, FlatPiece)
    return [(z, Outline(sides=int(CIRCLE), half=(0.0, 0.0), middle=(x, y))) for x, y, z in insert.corners]
