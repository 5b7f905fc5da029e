"""Readings of a laboratory's cell: forces on its surfaces over the windows of a run, and the density inside."""

from dataclasses import dataclass
from math import pi
from typing import Self

import numpy as np
from scipy.spatial import cKDTree

from silostudy.compute.sphere_cube import sphere_arrays
from silostudy.config.spheres import SphereScene
from silostudy.dem.outcomes import WAYS, Looks, surface_angle
from silostudy.dem.run import Run
from silostudy.dem.space.lanes import VELOCITY
from silostudy.scene.laboratory_cell import LaboratoryCase
from silostudy.scene.laboratory_scenes import HOLE, drained_tray
from silostudy.scene.space_silo import FLOOR, WALL

POINTS = 100_000  # at which the inside is looked at: its solid fraction is then known to some 0.3 % of itself
FLANK = (0.2, 0.7)  # of the tray's radius: the part of a heap between tip and foot
SECTORS = 8  # in which profiles of a crater are taken
MARGIN = 1.5  # mean diameters from every surface: grains stand in layers there


@dataclass(frozen=True)
class Readings:
    """Means over windows: height (m) of the lid, stresses (Pa) on lid, wall and along the floor.

    load: downward on all surfaces (N); normal: on the floor (N); torque: on the floor, and on all surfaces (N m).
    """

    height: np.ndarray
    vertical: np.ndarray
    horizontal: np.ndarray
    shear: np.ndarray
    load: np.ndarray
    normal: np.ndarray
    torque: np.ndarray
    whole_torque: np.ndarray

    @classmethod
    def of(cls, run: Run, scene: SphereScene, case: LaboratoryCase) -> Self:
        """The readings of a run of a cell whose lid moves."""
        data = sphere_arrays(run, scene)
        place = {str(name): number for number, name in enumerate(data["surface"])}
        height, normal, torque = data["lid_height"], data["surface_normal_force"], data["surface_torque"]
        return cls(
            height=height,
            vertical=data["lid_stress"],
            horizontal=normal[:, place[WALL]] / (pi * case.width * height),
            shear=torque[:, place[FLOOR]] / (case.area * case.lever),
            load=data["surface_load"].sum(axis=1),
            normal=normal[:, place[FLOOR]],
            torque=torque[:, place[FLOOR]],
            whole_torque=torque.sum(axis=1),
        )

    def imbalance(self, weight: float, late: slice) -> float:
        """Difference of the load on all surfaces and a weight (N), over the load on the floor (1), mean of late windows."""
        return float((self.load[late].mean() - weight) / self.normal[late].mean())

    def twist(self, late: slice) -> float:
        """Torque on all surfaces together over that on the floor (1), mean of late windows."""
        return float(self.whole_torque[late].mean() / self.torque[late].mean())


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
