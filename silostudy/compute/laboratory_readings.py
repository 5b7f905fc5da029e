"""Readings of a laboratory's cell: forces on its surfaces over the windows of a run, and the density inside."""

from collections.abc import Callable
from dataclasses import dataclass
from math import pi
from typing import Any

import numpy as np
from scipy.spatial import cKDTree

from silostudy.compute.sphere_cube import sphere_arrays
from silostudy.config.spheres import SphereScene
from silostudy.dem.outcomes import WAYS, Looks, surface_angle
from silostudy.dem.run import Run
from silostudy.dem.space.lanes import VELOCITY
from silostudy.scene.laboratory_cell import LaboratoryCase
from silostudy.scene.laboratory_scenes import HOLE, drained_tray, draining, dropping, heaping
from silostudy.scene.space_silo import FLOOR, WALL

POINTS = 100_000  # at which the inside is looked at: its solid fraction is then known to some 0.3 % of itself
FLANK = (0.2, 0.7)  # of the tray's radius: the part of a heap between tip and foot
SECTORS = 8  # in which profiles of a crater are taken
MARGIN = 1.5  # mean diameters from every surface: grains stand in layers there


@dataclass(frozen=True)
class Readings:
    """Means over windows: height (m) of the lid, stresses (Pa) on lid and wall; shear over normal stress (1).

    inside: of the solid in itself; along: on the floor as the wall's plate; load: downward on all surfaces, normal: on the
    floor (N); drive: shear on the floor, and drive_left: on all surfaces (N m of spheres, N of discs).
    Of discs all is a metre thick.
    """

    height: np.ndarray
    vertical: np.ndarray
    horizontal: np.ndarray
    inside: np.ndarray
    along: np.ndarray
    load: np.ndarray
    normal: np.ndarray
    drive: np.ndarray
    drive_left: np.ndarray

    def imbalance(self, weight: float, late: slice) -> float:
        """Difference of the load on all surfaces and a weight (N), over the load on the floor (1), mean of late windows."""
        return float((self.load[late].mean() - weight) / self.normal[late].mean())

    def twist(self, late: slice) -> float:
        """Shear on all surfaces together over that on the floor (1), mean of late windows."""
        return float(self.drive_left[late].mean() / self.drive[late].mean())


@dataclass(frozen=True)
class Reader:
    """Readings of the tests of one sort of grains.

    readings(run, scene, case) -> Readings; solid_fraction(run, case, top) -> that of the inside below a top (m);
    slopes(case, carried) -> those (rad) of a poured heap and of a drained tray; rebound(case, carried) -> speed of a grain away
    from the plate over that towards it (1); carried(scene, end, test, spills=) -> the finished run of a scene; remark: on
    the row.
    """

    readings: Callable[[Run, Any, Any], Readings]
    solid_fraction: Callable[[Run, Any, float], float]
    slopes: Callable[[Any, Callable[..., Run]], tuple[float, float]]
    rebound: Callable[[Any, Callable[..., Run]], float]
    remark: str


def readings_of_spheres(run: Run, scene: SphereScene, case: LaboratoryCase) -> Readings:
    """The readings of a run of a round cell whose lid moves.

    A solid yields under its lid, where it is pressed least; it slides on the plate under its own weight too.
    """
    data = sphere_arrays(run, scene)
    place = {str(name): number for number, name in enumerate(data["surface"])}
    height, vertical, torque = data["lid_height"], data["lid_stress"], data["surface_torque"]
    normal, shear = data["surface_normal_force_mean"], torque[:, place[FLOOR]] / (case.area * case.lever)
    return Readings(
        height=height,
        vertical=vertical,
        horizontal=normal[:, place[WALL]] / (pi * case.width * height),
        inside=shear / vertical,
        along=shear * case.area / normal[:, place[FLOOR]],
        load=data["surface_load"].sum(axis=1),
        normal=normal[:, place[FLOOR]],
        drive=torque[:, place[FLOOR]],
        drive_left=torque.sum(axis=1),
    )


def slopes_of_spheres(case: LaboratoryCase, carried: Callable[..., Run]) -> tuple[float, float]:
    """Slopes (rad) of a poured heap, and of what stays in a drained tray."""
    heap = heap_angle(carried(heaping(case), None, "pouring of a heap"), case)
    return heap, crater_angle(carried(draining(case), None, "draining of a tray", spills=True), case)


def rebound_of_sphere(case: LaboratoryCase, carried: Callable[..., Run]) -> float:
    """Speed of a dropped sphere away from the plate over the one towards it (1)."""
    drop = dropping(case)
    return rebound(carried(drop, None, "drop of a grain"), drop.filling.speed_m_s)


def solid_fraction_of_spheres(run: Run, case: LaboratoryCase, top: float) -> float:
    """Solid fraction (1) of the inside of a round cell below a top (m)."""
    return solid_fraction(run.engine.places, np.asarray(run.engine.model.radius), 0.5 * case.width, top, case.grain)


def solid_fraction(places: np.ndarray, radii: np.ndarray, radius: float, top: float, grain: float) -> float:
    """Solid fraction (1) of the inside of a round cell of a radius (m) between floor and top (m), layers at surfaces left out.

    Volumes of spheres, overlaps counted twice: so it is their mass over density and volume.
    """
    margin = MARGIN * grain
    random = np.random.default_rng(0)
    turn, off = random.uniform(0.0, 2.0 * pi, POINTS), (radius - margin) * np.sqrt(random.uniform(0.0, 1.0, POINTS))
    height = random.uniform(margin, top - margin, POINTS)
    points = cKDTree(np.column_stack([off * np.cos(turn), off * np.sin(turn), height]))
    return float(points.query_ball_point(places, radii, return_length=True).sum() / POINTS)


def heap_angle(run: Run, case: LaboratoryCase) -> float:
    """Slope (rad) of a heap about the axis: mean of its profiles towards and against x and y, tip and foot left out."""
    reach = 0.5 * case.tray
    up = np.array([0.0, 0.0, 1.0])
    looks = Looks(
        (run.engine.places,), (np.asarray(run.engine.model.radius),), (run.engine.time,), np.empty(0), np.empty(0), up
    )
    near, far = FLANK[0] * reach, FLANK[1] * reach
    ways = [(along, *ends) for along in WAYS[:2] for ends in ((near, far), (-far, -near))]
    return float(np.radians(np.mean([surface_angle(looks, along, start, end, 0.0) for along, start, end in ways])))


def crater_angle(run: Run, case: LaboratoryCase) -> float:
    """Slope (rad) of what stays in a drained tray: mean of its profiles in sectors, from beside the hole up to the wall."""
    stayed = np.isfinite(run.engine.places).all(axis=1)  # what fell through the hole has no place any more
    places, radii = run.engine.places[stayed], np.asarray(run.engine.model.radius)[stayed]
    off, turn = np.hypot(places[:, 0], places[:, 1]), np.arctan2(places[:, 1], places[:, 0])
    sector = np.floor((turn + pi) / (2.0 * pi) * SECTORS).astype(int) % SECTORS
    near, far = 0.5 * HOLE * case.grain + case.grain, 0.5 * drained_tray(case) - MARGIN * case.grain
    slopes = []
    for number in range(SECTORS):
        own = sector == number
        profile = np.column_stack([off[own], np.zeros(own.sum()), places[own, 2]])
        looks = Looks((profile,), (radii[own],), (run.engine.time,), np.empty(0), np.empty(0), np.array([0.0, 0.0, 1.0]))
        slopes.append(surface_angle(looks, WAYS[0], near, far, 0.0))
    return float(np.radians(np.nanmean(slopes)))


def rebound(run: Run, speed: float) -> float:
    """Speed away from the floor over the one towards it (1), of one grain that met it at a speed (m/s)."""
    upward = run.engine.bodies.rows[0, VELOCITY[-1]]
    return float(upward / speed)


SPHERES = Reader(readings_of_spheres, solid_fraction_of_spheres, slopes_of_spheres, rebound_of_sphere, "spheres")
