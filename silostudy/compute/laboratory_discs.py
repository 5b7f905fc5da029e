"""Readings of a laboratory's plane cell: forces on floor, lid and sides, the density inside, slopes, a dropped disc."""

from collections.abc import Callable
from dataclasses import replace
from pathlib import Path

import numpy as np
from scipy.spatial import cKDTree

from silostudy.compute.dem import run_of, scene_model
from silostudy.compute.dem_cube import disc_arrays
from silostudy.compute.laboratory_readings import FLANK, MARGIN, POINTS, Reader, Readings
from silostudy.config.dem import DemScene
from silostudy.dem.lanes import V
from silostudy.dem.outcomes import WAYS, Looks, surface_angle
from silostudy.dem.run import Run
from silostudy.scene.laboratory_cell_discs import DiscCase
from silostudy.scene.laboratory_discs import DROP, DROPPED, HOLE, draining, dropping
from silostudy.scene.plane_silo import FLOOR, LID, SIDES

UP = np.array([0.0, 1.0])


def readings(run: Run, scene: DemScene, case: DiscCase) -> Readings:
    """The readings of a run of a plane cell whose lid moves.

    Inside the solid counts what the middle half of floor and lid feel, along the plate the whole of the floor.
    """
    data = disc_arrays(run)
    cells = {name: np.flatnonzero(data["wall_name"] == name) for name in (FLOOR, LID, *SIDES)}
    normal, shear = data["wall_normal_force_mean"], data["wall_shear_force_mean"]
    pressed = {name: normal[:, own].sum(axis=1) for name, own in cells.items()}
    rubbed = {name: shear[:, own].sum(axis=1) for name, own in cells.items()}
    middle = np.concatenate([_middle(cells[name]) for name in (FLOOR, LID)])
    (left, right), height = SIDES, data["lid_height"]
    return Readings(
        height=height,
        vertical=data["lid_stress"],
        horizontal=0.5 * (pressed[left] + pressed[right]) / height,
        inside=_ratio(shear[:, middle].sum(axis=1), normal[:, middle].sum(axis=1)),
        along=_ratio(rubbed[FLOOR], pressed[FLOOR]),
        load=pressed[FLOOR] - pressed[LID] + rubbed[left] + rubbed[right],
        normal=pressed[FLOOR],
        drive=rubbed[FLOOR],
        drive_left=rubbed[FLOOR] - rubbed[LID] + pressed[left] - pressed[right],
    )


def _ratio(shear: np.ndarray, pressed: np.ndarray) -> np.ndarray:
    """Shear over normal force (1); missing where nothing presses yet."""
    return np.divide(shear, pressed, out=np.full(len(shear), np.nan), where=pressed > 0.0)


def _middle(cells: np.ndarray) -> np.ndarray:
    """The middle half of a wall's cells, of which the first and the last are its ends."""
    inner = cells[1:-1]
    return inner[len(inner) // 4 : len(inner) - len(inner) // 4]


def solid_fraction(run: Run, case: DiscCase, top: float) -> float:
    """Solid fraction (1) of the inside of a plane cell between floor and top (m), layers at walls left out."""
    margin, random = MARGIN * case.grain, np.random.default_rng(0)
    across, up = ((margin, case.width - margin), (margin, top - margin))
    points = cKDTree(np.column_stack([random.uniform(*across, POINTS), random.uniform(*up, POINTS)]))
    radii = np.asarray(run.engine.model.radius)
    return float(points.query_ball_point(run.engine.places, radii, return_length=True).sum() / POINTS)


def slopes(case: DiscCase, carried: Callable[..., Run]) -> tuple[float, float]:
    """Slopes (rad) of the heap below a drained tray, tip and foot left out, and of what stays in the tray, of both flanks."""
    run = carried(draining(case), None, "draining of a tray", spills=True)
    places, half = run.engine.places - np.array([0.5 * case.tray, 0.0]), 0.5 * case.tray
    on_base = (places[:, 1] < 0.0) & (places[:, 1] > -DROP * case.tray)
    heap = _flanks(run, places, on_base, FLANK[0] * half, FLANK[1] * half)
    return heap, _flanks(run, places, places[:, 1] > 0.0, (0.5 * HOLE + 1.0) * case.grain, half - MARGIN * case.grain)


def _flanks(run: Run, places: np.ndarray, which: np.ndarray, near: float, far: float) -> float:
    """Mean slope (rad) of the surface of some discs between two distances (m) from the middle, left and right of it."""
    looks = Looks(
        (places[which],), (np.asarray(run.engine.model.radius)[which],), (run.engine.time,), np.empty(0), np.empty(0), UP
    )
    return float(np.radians(np.mean([surface_angle(looks, WAYS[0], *ends, 0.0) for ends in ((near, far), (-far, -near))])))


def rebound(case: DiscCase, carried: Callable[..., Run]) -> float:
    """Speed of a dropped disc away from the plate over the one towards it (1)."""
    scene = dropping(case)
    model = scene_model(scene, Path())
    run = run_of(scene, replace(model, y=np.array([4.0 * case.grain]), v=np.array([-DROPPED])))
    run.go()
    return float(run.engine.bodies.rows[0, V] / DROPPED)


DISCS = Reader(
    readings, solid_fraction, slopes, rebound, "discs a metre thick: unit weights are the plane's solid fraction times density"
)
