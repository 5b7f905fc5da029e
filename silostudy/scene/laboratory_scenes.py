"""The tests of a laboratory as ordinary scenes of spheres: a round cell that is filled, pressed by its lid, and sheared by it.

All tests are done in one cell, so that one filling serves them all.  Its wall is smooth.  Its ends are smooth while it is
pressed: rough ones would take over much of what the wall of a cell of few grains should bear.  For shear the lid is rough and
turns, and the floor is rough too, or the plate of the silo's wall: a torsional cell, since what moves along itself in this
engine are surfaces that turn in place.  A rough end holds what touches it against sliding and rolling, as if it were glued on.
"""

from collections.abc import Mapping, Sequence
from math import pi, sqrt
from typing import Any

from silostudy.config.elastic import TouchConfig
from silostudy.config.spheres import SphereScene
from silostudy.contact.rolling import spring_slider
from silostudy.scene.laboratory_cell import KPA, LOOSE, LaboratoryCase
from silostudy.scene.outflow import beverloo
from silostudy.scene.space_silo import FLOOR, LID, WALL
from silostudy.scene.spheres import contacts_of
from silostudy.tables.constants import ROUNDED_GRAVITY

ROOM = 1.8  # height of the cell over that of the filling: what rains in needs room
RESTS = ({"when": "rest", "do": "lower_lid"},)
STREAM = 5.0  # width of the stream onto a heap, in grains
POURED = 0.3  # its speed (m/s)
HOLE = 6.0  # width of the hole that a tray is drained by, in grains
BESIDE_HOLE = 8.0  # least width of a drained tray on each side of the hole, in grains: a slope needs room to be seen
DRAWN_DEPTH = 0.25  # depth of the tray's filling over its width
FLUX = 0.15  # solid fraction of the rain
FLOW = (0.58, 1.5)  # constant and edge (grains) of Beverloo's law, about
SETTLES = 10.0  # s: a filling comes to rest by then, or the run ends
LATE = 5.0  # times that a test may take over what it should at most
PRESSED = 0.5  # strain that no pressing comes to
BORNE = 10  # windows in which the pressed cell is looked at
FINE = 0.002  # strain in a window of wall forces while a cell is pressed
YIELDS = 20.0  # speed of a lid that nothing resists over that of the shear: it gives way to grains at its load
SHEAR_WINDOWS = 60  # windows of wall forces in the shear
STIFF = 0.1  # rotational stiffness at walls over E r^3: of a spring as Mindlin's on the radius as its arm, about
ROUGH = 5.0  # sliding and rolling friction of what holds grains fast
SMOOTH = 0.0  # of what lets them slide


def like(friction: float) -> dict[str, float]:
    """A surface of a sliding and rolling friction."""
    return {"sliding_friction": friction, spring_slider.FRICTION.field: friction}


PRESSING = {WALL: like(SMOOTH), FLOOR: like(SMOOTH), LID: like(SMOOTH)}
SHEARING = {WALL: like(SMOOTH), FLOOR: like(ROUGH), LID: like(ROUGH)}
SLIDING = {WALL: like(SMOOTH), LID: like(ROUGH)}  # the floor is the plate of the silo's wall


def filling(case: LaboratoryCase) -> SphereScene:
    """Grains rain into the cell and come to rest."""
    return _scene(case, PRESSING, RESTS, limit=SETTLES)


def heaping(case: LaboratoryCase) -> SphereScene:
    """Grains are poured onto the middle of a rough tray and come to rest as a heap."""
    width, stream = case.tray, STREAM * case.grain
    across = 0.25 * pi * stream**2 * POURED * FLUX / case.grain_volume
    pour = {"kind": "rain", "count": case.heap_count, "speed_m_s": POURED, "rate_1_s": across, "width_m": stream}
    silo = {"plan": "circular", "diameter_m": width, "cylinder_depth_m": 0.5 * width}
    return _scene(case, SHEARING, RESTS, limit=SETTLES, silo=silo, rain=pour)


def drained_tray(case: LaboratoryCase) -> float:
    """Width (m) of the tray that is drained: that of a heap's, or wider where the hole would take most of it."""
    return max(case.tray, (HOLE + 2.0 * BESIDE_HOLE) * case.grain)


def draining(case: LaboratoryCase) -> SphereScene:
    """Grains fill a rough tray and flow out of a hole in its floor; what stays is a crater."""
    width, hole = drained_tray(case), HOLE * case.grain
    count = round(LOOSE * 0.25 * pi * width**2 * DRAWN_DEPTH * width / case.grain_volume)
    free = float(beverloo(hole, case.grain, 1.0, *FLOW))  # m3/s, about
    lasts = 0.25 * pi * width**2 * DRAWN_DEPTH * width / free
    fall = sqrt(2.0 * ROUNDED_GRAVITY * DRAWN_DEPTH * width)
    across = 0.25 * pi * width**2 * fall * FLUX / case.grain_volume
    rain = {"kind": "rain", "count": count, "speed_m_s": fall, "rate_1_s": across}
    silo = {"plan": "circular", "diameter_m": width, "cylinder_depth_m": 2.0 * DRAWN_DEPTH * width}
    opens = ({"when": "rest", "do": "open_outlet"},)
    limit = SETTLES + lasts
    return _scene(case, SHEARING, opens, limit=limit, lasts=lasts, silo=silo, rain=rain, outlets=[{"width_m": hole}])


def dropping(case: LaboratoryCase) -> SphereScene:
    """One grain meets the plate at a speed, without gravity."""
    height = 4.0 * case.grain
    drop = {"kind": "rain", "count": 1, "speed_m_s": POURED, "rate_1_s": 1.0 / POURED, "height_m": height}
    lasts = 3.0 * height / POURED
    still = (0.0, 0.0, 0.0)
    return _scene(case, {}, (), limit=2.0 * lasts, lasts=lasts, rain=drop, gravity=still)


def pressing(case: LaboratoryCase, stress: float, now: float) -> SphereScene:
    """The lid presses the cell to a stress (Pa) at a speed, and then bears it; now: time (s) at which it begins."""
    speed = case.speed(stress)
    events = (
        {"when": "after", "do": "move_lid", "speed_m_s": speed, "until_stress_kPa": stress / KPA},
        {"when": "lid_rests", "do": "press_lid", "stress_kPa": stress / KPA},
        {"when": "lid_rests", "do": "press_lid", "stress_kPa": stress / KPA},  # comes to rest, and then bears it
    )
    window, limit = FINE * case.height / speed, now + LATE * PRESSED * case.height / speed
    return _scene(case, PRESSING, events, limit=limit, window=window, lasts=BORNE * window)


def shearing(case: LaboratoryCase, stress: float, now: float, surfaces: Mapping[str, dict]) -> SphereScene:
    """The lid turns under a stress (Pa), over a floor that surfaces say: SHEARING or SLIDING; now: when (s) it begins."""
    speed = case.speed(stress)
    time = case.shear_strain * case.height / speed
    events = (
        {"when": "after", "do": "press_lid", "stress_kPa": stress / KPA, "speed_m_s": YIELDS * speed},
        {"when": "after", "do": "rotate", "spin_rad_s": speed / case.lever, "surfaces": [LID]},
    )
    return _scene(case, surfaces, events, limit=now + LATE * time, window=time / SHEAR_WINDOWS, lasts=time)


def _scene(
    case: LaboratoryCase, surfaces: Mapping[str, dict], events: tuple[dict, ...], *, limit: float, window: float | None = None,
    lasts: float = 0.0, silo: Mapping[str, Any] | None = None, rain: Mapping[str, Any] | None = None,
    outlets: Sequence[Mapping[str, Any]] = (), gravity: tuple[float, float, float] = (0.0, 0.0, -ROUNDED_GRAVITY),
) -> SphereScene:  # fmt: skip
    """A scene of the laboratory; silo, rain: what holds the grains and how they come in, None: the cell and its filling.

    window: of wall forces (s), limit: latest end, lasts: time from the last event to the stop (s).
    """
    config = case.config
    content = {
        "kind": "dem", "grains": config.grains, "title": "a cell of the laboratory", "methods_from": config.methods_from,
        "silo": silo or cell(case), "lid": True, "filling": rain or cell_rain(case),
        "grain": config.grain, "wall": config.wall, "spheres": config.spheres, "walls": plate(case), "surfaces": surfaces,
        "sizes": config.sizes, "seed": config.seed, "march": {"limit_s": limit, "step_factor": config.step_factor},
        "outlets": outlets, "gravity_m_s2": gravity, "events": [*events, {"when": "after", "value": lasts, "do": "stop"}],
        "record": {"wall_force_window_s": window, "pressure_cells": [1, 1]},
    }  # fmt: skip
    return SphereScene.model_validate(content, context={"families": config.families})


def cell(case: LaboratoryCase) -> dict[str, Any]:
    """The cell, as a silo."""
    return {"plan": "circular", "diameter_m": case.width, "cylinder_depth_m": ROOM * case.height}


def cell_rain(case: LaboratoryCase) -> dict[str, Any]:
    """Rain of grains into the cell."""
    return column_rain(case.count, case.height)


def check(case: LaboratoryCase, where: str) -> None:
    """BadInput for contacts that neither sections nor tables tell of."""
    contacts_of(filling(case), where)


def column_rain(count: int, height: float) -> dict[str, Any]:
    """Rain of so many grains that fill a column to a height (m), as fast as if they fell through it."""
    fall = sqrt(2.0 * ROUNDED_GRAVITY * height)
    return {"kind": "rain", "count": count, "speed_m_s": fall, "rate_1_s": count * FLUX * fall / (LOOSE * height)}


def plate(case: LaboratoryCase) -> TouchConfig:
    """Contact of spheres and the silo's wall, of a rolling law that can hold them fast: a spring behind a slider.

    Where the wall has none, or one without a spring, that law is put in its place with the same rolling friction.
    """
    walls = case.config.walls
    law, spring = walls.laws["rolling"], spring_slider.STIFFNESS.of_spheres.field
    holds = law.stores and spring_slider.FRICTION in law.coefficients
    values = walls.model_dump()
    stiffness = values.get(spring) or STIFF * case.modulus * float(case.radii.mean()) ** 3
    return walls.with_values({"rolling": law.key if holds else spring_slider.ROW.key, spring: stiffness})
