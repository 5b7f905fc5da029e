"""A bin of spheres to time codes on: a cylinder on a cone with a plug in its outlet, filled from a lattice."""

from dataclasses import replace
from math import pi, sqrt, tan

import numpy as np

from silostudy.contact import elastic
from silostudy.contact.coefficient import Given
from silostudy.contact.normal import hertz_tension
from silostudy.contact.tangential import mindlin
from silostudy.dem.model import Contact
from silostudy.dem.pieces import Laws
from silostudy.dem.space.model import SphereModel
from silostudy.scene.silo import Hopper, Silo
from silostudy.scene.space_silo import SpaceSilo
from silostudy.tables.constants import ROUNDED_GRAVITY

DIAMETER, DENSITY = 0.004, 2500.0  # m, kg/m3: glass beads
MODULUS, POISSON = 1e7, 0.2  # Pa: softened, as is usual
RESTITUTION = {"pair": 0.5, "wall": 0.4}
FRICTION = {"pair": 0.3, "wall": 0.2}
STEP = 1e-5  # s
OUTLET = 10.0  # diameters
HALF_ANGLE = pi / 6.0  # of the cone
STEEPNESS = tan(HALF_ANGLE)
LOOSE = 1.06  # of a diameter: pitch of the lattice


def tsuji(restitution: float) -> float:
    """Damping number (1) of a restitution by the polynomial of Tsuji's law as LAMMPS prints it."""
    return float(np.polyval([4.8218, -18.022, 27.467, -22.348, 11.087, -4.2783, 1.2728], restitution))


def contact_of(kind: str) -> Contact:
    """Hertz and Mindlin with the peer's dashpot, between spheres (pair) or at walls (wall)."""
    laws = Laws(normal=hertz_tension.ROW, tangential=mindlin.ROW)
    both = ((MODULUS, POISSON), (MODULUS, POISSON))
    given = Given({"materials": both, "restitution": None, "sliding_friction": FRICTION[kind]}, 0.0, DENSITY, laws.normal)
    values = laws.normal.prepared(given) | laws.tangential.prepared(given)
    return Contact(laws, values | {"hertz_damping": tsuji(RESTITUTION[kind]) * sqrt(elastic.hertz_stiffness(given))})


def bin_silo(wide: float, high: float) -> SpaceSilo:
    """The bin: a cylinder of a radius up to a height (m) above the outlet of its cone, which is closed."""
    hopper = Hopper(half_angle=HALF_ANGLE, outlet_width=OUTLET * DIAMETER)
    silo = Silo(plan="circular", diameter=2.0 * wide, wall_depth=0.0, hopper=hopper)
    return SpaceSilo(silo=replace(silo, wall_depth=high - silo.hopper_height))


def lattice(count: int, wide: float, seed: int) -> np.ndarray:
    """Places (count, 3) of spheres on a cubic lattice in the bin, from below, each a little off by the seed."""
    pitch, outlet, gap = LOOSE * DIAMETER, 0.5 * OUTLET * DIAMETER, 0.6 * DIAMETER
    across = np.arange(-wide, wide, pitch)
    layers = np.arange(gap, 2.5 * count * pitch**3 / (pi * wide**2) + 2.0 * wide / STEEPNESS, pitch)
    z, x, y = (axis.ravel() for axis in np.meshgrid(layers, across, across, indexing="ij"))
    room = np.minimum(wide, outlet + STEEPNESS * z) - gap * sqrt(1.0 + STEEPNESS**2)
    place = np.c_[x, y, z][np.hypot(x, y) < room][:count]
    return place + np.random.default_rng(seed).uniform(-0.02, 0.02, place.shape) * DIAMETER


def bin_of_spheres(count: int, wide: float, seed: int = 1) -> SphereModel:
    """The model of so many spheres in a bin of this radius (m)."""
    place = lattice(count, wide, seed)
    high = float(place[:, 2].max()) + 5.0 * DIAMETER
    return SphereModel(
        x=place[:, 0], y=place[:, 1], z=place[:, 2], radius=np.full(count, 0.5 * DIAMETER), density=DENSITY,
        walls=bin_silo(wide, high).walls(), pair_contact=contact_of("pair"), wall_contact=contact_of("wall"), dt=STEP,
        gravity=(0.0, 0.0, -ROUNDED_GRAVITY),
    )  # fmt: skip
