"""A bin of spheres to hold codes beside each other: a cylinder on a cone with a plug in its outlet, filled from a lattice."""

from dataclasses import dataclass, replace
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
from silostudy.tables.materials import MATERIALS, PAIRS

SOFT = 1e7  # Pa: softened, as is usual
LOOSE = 1.06  # of a diameter: pitch of the lattice


@dataclass(frozen=True)
class GrainTouch:
    """Contact of a sphere with another body: its Young's modulus (Pa), restitution and sliding friction."""

    modulus: float
    restitution: float
    friction: float


@dataclass(frozen=True, kw_only=True)
class Bin:
    """Bin of equal spheres in a cylinder (radius wide, m) on a cone with an outlet (m): glass beads of 4 mm, if not told.

    high: height (m) of the walls above the outlet, None: just above the lattice; step: s.
    """

    count: int
    wide: float
    high: float | None = None
    outlet: float = 0.04
    half_angle: float = pi / 6.0
    diameter: float = 0.004
    density: float = 2500.0
    poisson: float = 0.2  # of spheres and walls
    spheres: GrainTouch = GrainTouch(SOFT, 0.5, 0.3)
    walls: GrainTouch = GrainTouch(SOFT, 0.4, 0.2)
    step: float = 1e-5

    @property
    def contact_moduli(self) -> dict[str, float]:
        """Modulus E* (Pa) of the contacts of spheres (pair) and of spheres and walls (wall)."""
        own = self.spheres.modulus, self.poisson
        others = {"pair": self.spheres.modulus, "wall": self.walls.modulus}
        return {kind: elastic.contact_modulus(*own, other, self.poisson) for kind, other in others.items()}

    def touch(self, kind: str) -> GrainTouch:
        """Contact of two spheres (pair) or of a sphere with walls (wall)."""
        return self.spheres if kind == "pair" else self.walls


def benchmark_bin(material: str, outlet: float, diameter: float, softening: float, step: float) -> Bin:
    """The silo of Dosta et al. (2024) and a material of theirs: as much of it, of spheres of a diameter (m), so much softer."""
    grain, steel = MATERIALS[f"dosta-{material}"], MATERIALS["dosta-steel"]
    pair, wall = (PAIRS[frozenset((grain.key, other))] for other in (grain.key, steel.key))
    return Bin(
        count=round(100_000 * (0.004 / diameter) ** 3), wide=0.1, high=0.3 + 0.1 - outlet / 2.0, outlet=outlet,
        half_angle=pi / 4.0, diameter=diameter, density=grain.density, poisson=grain.poissons_ratio, step=step,
        spheres=GrainTouch(grain.youngs_modulus / softening, pair.restitution, pair.sliding_friction),
        walls=GrainTouch(steel.youngs_modulus, wall.restitution, wall.sliding_friction),
    )  # fmt: skip


def tsuji(restitution: float) -> float:
    """Damping number (1) of a restitution by the polynomial of Tsuji's law as LAMMPS prints it."""
    return float(np.polyval([4.8218, -18.022, 27.467, -22.348, 11.087, -4.2783, 1.2728], restitution))


def contact_of(of: Bin, kind: str) -> Contact:
    """Hertz and Mindlin with the peer's dashpot, between spheres (pair) or at walls (wall)."""
    laws, touch = Laws(normal=hertz_tension.ROW, tangential=mindlin.ROW), of.touch(kind)
    both = ((of.spheres.modulus, of.poisson), (touch.modulus, of.poisson))
    given = Given({"materials": both, "restitution": None, "sliding_friction": touch.friction}, 0.0, of.density, laws.normal)
    values = laws.normal.prepared(given) | laws.tangential.prepared(given)
    return Contact(laws, values | {"hertz_damping": tsuji(touch.restitution) * sqrt(elastic.hertz_stiffness(given))})


def bin_silo(of: Bin, high: float) -> SpaceSilo:
    """Walls of the bin up to a height (m) above the outlet of its cone, which is closed."""
    hopper = Hopper(half_angle=of.half_angle, outlet_width=of.outlet)
    silo = Silo(plan="circular", diameter=2.0 * of.wide, wall_depth=0.0, hopper=hopper)
    return SpaceSilo(silo=replace(silo, wall_depth=high - silo.hopper_height))


def lattice(of: Bin, seed: int) -> np.ndarray:
    """Places (count, 3) of its spheres on a cubic lattice, from below, each a little off by the seed."""
    pitch, gap, steep = LOOSE * of.diameter, 0.6 * of.diameter, tan(of.half_angle)
    across = np.arange(-of.wide, of.wide, pitch)
    layers = np.arange(gap, 2.5 * of.count * pitch**3 / (pi * of.wide**2) + 2.0 * of.wide / steep, pitch)
    z, x, y = (axis.ravel() for axis in np.meshgrid(layers, across, across, indexing="ij"))
    room = np.minimum(of.wide, 0.5 * of.outlet + steep * z) - gap * sqrt(1.0 + steep**2)
    place = np.c_[x, y, z][np.hypot(x, y) < room][: of.count]
    return place + np.random.default_rng(seed).uniform(-0.02, 0.02, place.shape) * of.diameter


def bin_of_spheres(of: Bin, seed: int = 1) -> SphereModel:
    """The model of a bin, filled by a seed."""
    place = lattice(of, seed)
    high = float(place[:, 2].max()) + 5.0 * of.diameter if of.high is None else of.high
    return SphereModel(
        x=place[:, 0], y=place[:, 1], z=place[:, 2], radius=np.full(of.count, 0.5 * of.diameter), density=of.density,
        walls=bin_silo(of, high).walls(), pair_contact=contact_of(of, "pair"), wall_contact=contact_of(of, "wall"), dt=of.step,
        gravity=(0.0, 0.0, -ROUNDED_GRAVITY),
    )  # fmt: skip
