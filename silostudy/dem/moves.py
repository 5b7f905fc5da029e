"""Moves of walls that begin between two steps: a lid put down, pressed or moved, surfaces that turn or run as belts."""

from collections.abc import Callable

import numpy as np

from silostudy.dem.drive import DRAG, HELD, LOAD, MASS, STOP_FORCE, STOP_HEIGHT, pressing
from silostudy.dem.engine import Engine
from silostudy.dem.events import Event
from silostudy.dem.space.rows import TURN

CALM = 0.01  # of the load, and of the speed that nothing resists: a lid under less is at rest


def lower_lid(engine: Engine) -> None:
    """Put the lid down onto the highest body at once; it stays where it is if that is higher."""
    lid, shape = engine.lid, engine.walls.shape
    highest = float((engine.bodies.rows[: engine.n, engine.space.place[-1]] + engine.radius).max(initial=-np.inf))
    way = highest - engine.space.height_of(shape, lid)
    if np.isfinite(way) and way < 0.0:
        memories = engine.take_memories()
        engine.space.lift(shape, lid, way)
        engine.give_memories(*memories)


def press_lid(engine: Engine, load: float, mass: float, speed: float, lowest: float) -> None:
    """Press the lid down with a load (N) as a body of a mass (kg), at a speed (m/s) where nothing resists, to a height (m)."""
    drive = engine.walls.drive[engine.lid]
    drive[[LOAD, MASS, DRAG, STOP_FORCE, STOP_HEIGHT]] = load, mass, load / speed, np.inf, lowest
    drive[HELD] = engine.walls.shape[engine.lid, engine.space.rise]


def move_lid(engine: Engine, speed: float, force: float, height: float) -> None:
    """Move the lid upward at a speed (m/s) until a force (N) presses it, or to a height (m)."""
    engine.walls.drive[engine.lid] = 0.0, 0.0, 0.0, 0.0, force, height
    engine.walls.shape[engine.lid, engine.space.rise] = speed


def turn_walls(engine: Engine, spin: float, *names: str) -> None:
    """Turn surfaces about the upright axis at a spin (rad/s)."""
    engine.walls.shape[[engine.model.wall_number(name) for name in names], TURN] = spin


def run_belts(engine: Engine, speed: float | tuple[float, float, float], *names: str) -> None:
    """Run the faces of straight walls along them at a speed, of surfaces in space at a velocity (m/s)."""
    engine.space.run(engine.walls.shape, [engine.model.wall_number(name) for name in names], speed)


MOVES: dict[str, Callable[..., None]] = {
    "lower": lower_lid, "press": press_lid, "move": move_lid, "turn": turn_walls, "run": run_belts
}  # fmt: skip
OF_LID = ("lower", "press", "move")


def force_on_lid(engine: Engine) -> float:
    """Force (N) that pressed the lid in the last step."""
    return float(pressing(engine.walls.cells, engine.record, engine.lid))


def lid_stress(engine: Engine) -> float:
    """Mean pressure (Pa; in the plane N/m a metre) on the lid in the last step."""
    lid = engine.model.lid
    assert lid is not None
    return force_on_lid(engine) / lid.area


def lid_height(engine: Engine) -> float:
    """Height (m) of the lid."""
    return float(engine.space.height_of(engine.walls.shape, engine.lid))


def lid_standing(engine: Engine) -> str:
    """Height of the lid, and what lies under it."""
    return f"the lid stands {lid_height(engine):.4g} m high under {1e-3 * lid_stress(engine):.4g} kPa"


def lid_meets(engine: Engine, event: Event) -> bool:
    """Whether the lid does what an event waits for."""
    return lid_rests(engine) if event.trigger == "lid_rests" else lid_stress(engine) >= event.value


def lid_rests(engine: Engine) -> bool:
    """Whether the lid stands: it has stopped, or it bears its load and hardly moves."""
    drive, speed = engine.walls.drive[engine.lid], engine.walls.shape[engine.lid, engine.space.rise]
    if not drive[MASS] > 0.0:
        return bool(speed == 0.0)
    left = abs(force_on_lid(engine) - drive[LOAD])
    return bool(max(left, drive[DRAG] * abs(speed)) < CALM * drive[LOAD])
