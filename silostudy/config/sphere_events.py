"""Events of a scene of spheres as a user writes them."""

from collections.abc import Mapping
from typing import ClassVar, Literal, Self

from pydantic import model_validator

from silostudy.config.fields import KeyMistake, described
from silostudy.config.moves import MovingEvent, Takes


class SphereEventConfig(MovingEvent):
    """One event: it waits for the event before it, then for its trigger, then acts."""

    takes: ClassVar[Mapping[str, Takes]] = {
        **MovingEvent.takes,
        "open_outlet": Takes("the outlet opens, or outlets by name", may=("outlets", "speed_m_s")),
        "set_gravity": Takes("gravity becomes another", ("gravity_m_s2",)),
        "set_friction": Takes("frictions become others", may=("sphere_friction", "wall_friction", "surfaces")),
        "remove_sphere": Takes("a sphere is taken out", may=("sphere", "near_m")),
        "rotate": Takes("surfaces turn about the upright axis", ("spin_rad_s", "surfaces")),
        "run_belt": Takes("the face of a flat wall runs along it", ("velocity_m_s", "surfaces")),
        "take_away": Takes("inserts are taken away", ("surfaces",)),
    }

    do: Literal[
        "open_outlet",
        "set_gravity",
        "set_friction",
        "lower_lid",
        "press_lid",
        "move_lid",
        "feed",
        "remove_sphere",
        "rotate",
        "run_belt",
        "take_away",
        "stop",
    ] = described("what happens", "")
    speed_m_s: float | None = described(
        "move_lid: downward, negative lifts the lid, 0 stops it; press_lid: where nothing resists, null: 0.1; open_outlet: at "
        "which the outlet's width grows from none to all, from its middle, in a floor or a plug at rest: along x of one with "
        "four sides, all around of others; null: at once",
        "m s-1",
        default=None,
    )
    outlets: tuple[str, ...] = described("open_outlet: names of the outlets of a flat floor; none: all", "", default=())
    sphere: int | None = described("number of the sphere to remove, in the order in which they come in", "", ge=0, default=None)
    near_m: tuple[float, float, float] | None = described(
        "x, y, z of the place whose nearest sphere to remove", "m", default=None
    )
    gravity_m_s2: tuple[float, float, float] | None = described("new gravity, x, y and z", "m s-2", default=None)
    sphere_friction: float | None = described("new friction between spheres", ge=0, default=None)
    wall_friction: float | None = described("new friction at all walls, or at surfaces", ge=0, default=None)
    spin_rad_s: float | None = described(
        "rotate: of surfaces of a circular silo about its upright axis, counter-clockwise from above; they stay where they "
        "are and drag what touches them. A drum is such a silo with gravity across its axis",
        "s-1",
        default=None,
    )
    velocity_m_s: tuple[float, float, float] | None = described(
        "run_belt: x, y and z, along the surfaces; 0, 0, 0 stops them", "m s-1", default=None
    )
    surfaces: tuple[str, ...] = described(
        "rotate: the surfaces that turn: of a drum wall, floor and lid, of a shear cell the lid alone; set_friction: those "
        "where wall_friction changes, by names as in the scene's surfaces, none: all walls; run_belt: flat ones that stay "
        "where they are while their face runs along them and drags what touches it; take_away: inserts that stand there no "
        "more, as a gate that is pulled",
        "",
        default=(),
    )

    @model_validator(mode="after")
    def _has_what_it_needs(self) -> Self:
        if self.do == "remove_sphere" and (self.sphere is None) == (self.near_m is None):
            raise KeyMistake("do", "needs either sphere or near_m")
        if self.do == "set_friction" and self.sphere_friction is None and self.wall_friction is None:
            raise KeyMistake("do", "needs sphere_friction or wall_friction")
        if self.do == "set_friction" and self.surfaces and self.wall_friction is None:
            raise KeyMistake("surfaces", "are where a wall_friction changes: give that too")
        return self
