"""The tests of a laboratory as ordinary scenes of discs: a plane cell that is filled, pressed by its lid, and sheared.

Discs fill the cell under gravity; from then on they are weightless, so that floor and lid press alike: under some kPa their
weight would be a part of it.  For internal friction floor and lid are rough and run as belts, against each other, each at half
the speed: what the floor takes to one side the lid takes back, and the solid goes around.  A floor that runs alone drives the
solid against a side, which resists like a retaining wall, and the lid then feels a shear the other way.  Forces are read where
the sides are far, on the middle half of floor and lid.  For wall friction the floor alone runs, as the plate of the silo's
wall: grains slide on it and are held by a rough lid.
"""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np

from silostudy.config.contact import ContactConfig
from silostudy.config.dem import DemScene
from silostudy.contact.rolling import spring_slider
from silostudy.packing.loose import ROOM
from silostudy.scene.dem import contacts_of
from silostudy.scene.laboratory_cell import KPA
from silostudy.scene.laboratory_cell_discs import DiscCase
from silostudy.scene.laboratory_scenes import (
    BORNE,
    LATE,
    PRESSED,
    ROUGH,
    SETTLES,
    SHEAR_WINDOWS,
    SMOOTH,
    YIELDS,
    like,
)
from silostudy.scene.plane_silo import FLOOR, LID, SIDES
from silostudy.tables.constants import ROUNDED_GRAVITY

BASE = "base"  # the plate below an outlet that a heap lies on
PARTS = 16  # of floor and lid, whose middle half counts for internal friction
HOLE = 12.0  # width of the slit that a tray is drained by, in grains: those of 4 to 8 jam at times
DROP = 0.25  # of the base below the tray, over its width: a heap of up to 26 degrees has room
FLOWS = 2.0  # s: longer than a tray takes to drain and to come to rest
DROPPED = 0.3  # m/s: speed of a grain that is dropped
FINELY = 0.1  # of the step of the other tests, in which a fast impact lasts eight steps and loses more than asked
FINE = 2e-4  # strain in a window of wall forces while a cell is pressed: stiff discs bear some kPa at a strain of 0.01
WEIGHTLESS = (0.0, 0.0)
HEAVY = (0.0, -ROUNDED_GRAVITY)


@dataclass(frozen=True)
class Plates:
    """Floor and lid in a shear: surfaces that differ from the wall's material, and which of them run as belts."""

    surfaces: Mapping[str, dict]
    belts: tuple[str, ...]

    @property
    def share(self) -> float:
        """Share (1) of the way of lid past floor that each belt runs."""
        return 1.0 / len(self.belts)


SMOOTH_SIDES = dict.fromkeys(SIDES, like(SMOOTH))
PRESSING = {**SMOOTH_SIDES, FLOOR: like(SMOOTH), LID: like(SMOOTH)}
SHEARING = Plates({**SMOOTH_SIDES, FLOOR: like(ROUGH), LID: like(ROUGH)}, (FLOOR, LID))
SLIDING = Plates({**SMOOTH_SIDES, LID: like(ROUGH)}, (FLOOR,))  # the floor is the plate of the silo's wall


def filling(case: DiscCase) -> DemScene:
    """Discs fall into the cell and come to rest; the lid is put down onto them."""
    lowers = ({"when": "rest", "do": "lower_lid"},)
    return _scene(case, PRESSING, lowers, limit=SETTLES, gravity=HEAVY)


def pressing(case: DiscCase, stress: float, now: float) -> DemScene:
    """The lid presses the cell to a stress (Pa) at a speed, and then bears it; now: time (s) at which it begins."""
    speed = case.speed(stress)
    bears = {"when": "lid_rests", "do": "press_lid", "stress_kPa": stress / KPA}
    events = ({"when": "after", "do": "move_lid", "speed_m_s": speed, "until_stress_kPa": stress / KPA}, bears, bears)
    window, limit = FINE * case.height / speed, now + LATE * PRESSED * case.height / speed
    return _scene(case, PRESSING, events, limit=limit, window=window, lasts=BORNE * window)


def shearing(case: DiscCase, stress: float, now: float, plates: Plates) -> DemScene:
    """Belts shear the cell under a stress (Pa) on its lid: SHEARING or SLIDING; now: when (s) they begin."""
    speed = case.speed(stress)
    time = case.shear_strain * case.height / speed
    events = (
        {"when": "after", "do": "press_lid", "stress_kPa": stress / KPA, "speed_m_s": YIELDS * speed},
        {"when": "after", "do": "run_belt", "speed_m_s": plates.share * speed, "surfaces": plates.belts},
    )
    return _scene(case, plates.surfaces, events, limit=now + LATE * time, window=time / SHEAR_WINDOWS, lasts=time)


def draining(case: DiscCase) -> DemScene:
    """Discs fill a rough tray and flow out of a slit in its floor onto a rough base: a crater stays, and a heap lies below."""
    wide, deep, count = case.tray, DROP * case.tray, case.heap_count
    base = {"kind": "line", "name": BASE, "ends_m": [[0.0, -deep], [wide, -deep]]}
    return _scene(
        case, {**SMOOTH_SIDES, FLOOR: like(ROUGH), BASE: like(ROUGH)}, ({"when": "rest", "do": "open_slit"},),
        limit=SETTLES, lasts=FLOWS, gravity=HEAVY, inserts=[base], count=count,
        silo={"width_m": wide, "height_m": _packed_height(case, wide, count), "slit_width_m": HOLE * case.grain},
    )  # fmt: skip


def dropping(case: DiscCase) -> DemScene:
    """One disc over the plate, without gravity; who carries it through gives it its speed."""
    high = 4.0 * case.grain
    return _scene(
        case, {}, (), limit=6.0 * high / DROPPED, lasts=3.0 * high / DROPPED, step=FINELY, count=1,
        silo={"width_m": case.width, "height_m": 2.0 * high},
    )  # fmt: skip


def check(case: DiscCase, where: str) -> None:
    """BadInput for contacts that laws cannot be made of."""
    spread = case.config.radius_spread
    contacts_of(filling(case), case.config.radius_m * np.array([1.0 - spread, 1.0 + spread]), where)


def _scene(
    case: DiscCase, surfaces: Mapping[str, dict], events: tuple[dict, ...], *, limit: float, window: float | None = None,
    lasts: float = 0.0, step: float = 1.0, gravity: tuple[float, float] = WEIGHTLESS, silo: Mapping[str, Any] | None = None,
    inserts: Sequence[Mapping[str, Any]] = (), count: int | None = None,
) -> DemScene:  # fmt: skip
    """A scene of the laboratory; silo, count: what holds how many discs, None: the cell and its filling.

    window: of wall forces (s), limit: latest end, lasts: time from the last event to the stop (s), step: over the usual one.
    """
    config, lid = case.config, silo is None
    cell = {"width_m": case.width, "height_m": _packed_height(case, case.width, case.count)}
    content = {
        "kind": "dem", "grains": config.grains, "title": "a cell of the laboratory", "methods_from": config.methods_from,
        "silo": {**(silo or cell), "lid": lid, "wall_cells": PARTS if lid else 1}, "inserts": inserts,
        "packing": {"kind": "loose", "count": count or case.count, "radius_spread": config.radius_spread},
        "radius_m": config.radius_m, "density_kg_m3": config.density_kg_m3, "discs": config.discs, "walls": plate(case),
        "surfaces": surfaces, "seed": config.seed, "gravity_m_s2": gravity,
        "march": {"limit_s": limit, "step_factor": step * config.step_factor},
        "events": [*events, {"when": "after", "value": lasts, "do": "stop"}], "record": {"wall_force_window_s": window},
    }  # fmt: skip
    return DemScene.model_validate(content, context={"families": config.families})


def _packed_height(case: DiscCase, width: float, count: int) -> float:
    """Height (m) over a width (m) that so many discs start in, loose, with a row to spare."""
    side = ROOM * case.config.radius_m * (1.0 + case.config.radius_spread)
    return side * (count // int(width / side) + 2)


def plate(case: DiscCase) -> ContactConfig:
    """Contact of discs and the silo's wall, of a rolling law that can hold them fast: a spring behind a slider.

    Where the wall has none, or one without a spring, that law is put in its place with the same rolling friction; the spring is
    then one along the contact with the radius as its arm.
    """
    walls = case.config.walls
    law, spring = walls.laws["rolling"], spring_slider.STIFFNESS.field
    holds = law.stores and spring_slider.FRICTION in law.coefficients
    values = walls.model_dump()
    stiffness = values.get(spring) or walls.stiffness_ratio * case.stiffness(wall=True) * case.config.radius_m**2
    return walls.with_values({"rolling": law.key if holds else spring_slider.ROW.key, spring: stiffness})
