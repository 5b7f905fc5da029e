"""Translates the user's words on a lid of any scene of grains: how it is put down, pressed and moved."""

from collections.abc import Sequence
from math import inf

from silostudy.config.moves import OF_LID, MovingEvent
from silostudy.dem.model import Lid
from silostudy.errors import BadInput

KPA = 1e3  # Pa
SPEED = 0.1  # m/s: of a lid that is pressed and meets nothing, where a scene does not say
MOVING = (*OF_LID, "rotate", "run_belt")


def moves(events: Sequence[MovingEvent]) -> bool:
    """Whether walls move in a scene."""
    return slides(events) or any(event.do in MOVING or event.of_lid for event in events)


def slides(events: Sequence[MovingEvent]) -> bool:
    """Whether an outlet opens at a speed."""
    return any(event.do in ("open_outlet", "open_slit") and event.speed_m_s is not None for event in events)


def feeds(events: Sequence[MovingEvent]) -> bool:
    """Whether a feeder draws grains in a scene."""
    return any(event.do == "feed" for event in events)


def lid_of(events: Sequence[MovingEvent], area: float, touching: float, mass: float) -> Lid | None:
    """The lid (area in m2, in the plane m) that events ask for; touching: grains that fit below it, mass: of all grains, kg."""
    if not any(event.of_lid for event in events):
        return None
    masses = [event.lid_mass_kg or mass for event in events if event.do == "press_lid"]
    return Lid(area=area, touching=touching, mass=min(masses, default=inf))


def lid_action(event: MovingEvent, area: float, mass: float, low: float, high: float) -> tuple[str, tuple]:
    """Action of the engine on the lid.

    area: of the lid (m2, in the plane m); mass: of all grains (kg); low, high: where the vertical walls begin and end (m).
    """
    speed = SPEED if event.speed_m_s is None else event.speed_m_s
    if event.do == "lower_lid":
        return "lower", ()
    if event.do == "press_lid":
        assert event.stress_kPa is not None  # the model asks for it
        return "press", (event.stress_kPa * KPA * area, event.lid_mass_kg or mass, speed, low)
    force = inf if event.until_stress_kPa is None else event.until_stress_kPa * KPA * area
    end = low if speed > 0.0 else high
    return "move", (-speed, force, end if event.until_height_m is None else event.until_height_m)


def check_lid(events: Sequence[MovingEvent], low: float, high: float, where: str) -> None:
    """BadInput for a height that the lid cannot stand at."""
    for number, event in enumerate(events):
        height = event.until_height_m
        if height is not None and not low <= height <= high:
            allowed = f"must be from {low:.4g} to {high:.4g} m, where the vertical walls begin and end"
            raise BadInput(f"events.{number}.until_height_m", height, allowed, where)
