"""Contact laws of a scene of spheres in LAMMPS' words, in the ways that its input leaves open."""

from dataclasses import dataclass, replace
from math import exp, pi, sqrt

from silostudy.config.elastic import TouchConfig
from silostudy.config.spheres import SphereScene
from silostudy.contact import NO_COHESION, NO_ROLLING, NO_TWISTING
from silostudy.contact.cohesion import jkr
from silostudy.contact.elastic import contact_modulus, damping_where_cut
from silostudy.contact.normal import hertz
from silostudy.contact.rolling import spring_dashpot_slider
from silostudy.contact.tangential import mindlin, mindlin_rescaled
from silostudy.contact.twisting import marshall
from silostudy.scene.spheres import grain_of, material_of
from silostudy.tables.materials import Material

# words of a law by its key, of the laws of the normal force and of cohesion by both
NORMAL = {
    (hertz.ROW.key, NO_COHESION): "hertz/material {modulus} {restitution} {poisson}",
    (hertz.ROW.key, jkr.ROW.key): "jkr {modulus} {viscosity} {poisson} {surface_energy}",
}
TANGENTIAL = {
    mindlin.ROW.key: "tangential mindlin/force NULL 1.0 {friction}",
    mindlin_rescaled.ROW.key: "tangential mindlin_rescale/force NULL 1.0 {friction}",
}
ROLLING = {
    NO_ROLLING: "",
    spring_dashpot_slider.ROW.key: "rolling sds {rolling_stiffness} {rolling_damping} {rolling_friction}",
}
TWISTING = {NO_TWISTING: "", marshall.ROW.key: "twisting marshall"}
VISCOELASTIC = "viscoelastic"  # the damping that goes with cohesion: it takes no restitution


class CannotSay(Exception):
    """Reason why LAMMPS cannot be told a scene."""


@dataclass(frozen=True)
class Way:
    """A way to tell LAMMPS a scene.

    damping: its word; own_modulus: whether walls are given their own modulus, which it takes for both bodies of a contact, or
    the one that makes the contact's; cut: whether the dashpot never pulls, as here, with the restitution that was asked for.
    """

    damping: str = "coeff_restitution"
    own_modulus: bool = False
    cut: bool = False

    def title(self, scene: SphereScene) -> str:
        """Name the way, as it is of a scene."""
        damping = VISCOELASTIC if scene.walls.cohesion != NO_COHESION else self.damping
        told = [f"damping {damping}", "walls of their own modulus" * self.own_modulus, "limit_damping" * self.cut]
        return ", ".join(filter(None, told))


PLAIN = Way()
SAME_LAW = Way(cut=True)
OTHERS = (Way(damping="tsuji"), Way(own_modulus=True))


def words(scene: SphereScene, way: Way, radius: float) -> tuple[str, str]:
    """Contact of two spheres, and of spheres and walls, in LAMMPS' words; radius (m) of the spheres."""
    grain, wall = grain_of(scene), material_of(scene.wall)
    if not way.own_modulus:
        modulus = contact_modulus(grain.youngs_modulus, grain.poissons_ratio, wall.youngs_modulus, wall.poissons_ratio)
        wall = replace(grain, youngs_modulus=2.0 * (1.0 - grain.poissons_ratio**2) * modulus)
    mass = grain.density * 4.0 / 3.0 * pi * radius**3
    return (_of_touch(scene.spheres, grain, 0.5 * radius, 0.5 * mass, way), _of_touch(scene.walls, wall, radius, mass, way))


def _of_touch(touch: TouchConfig, material: Material, radius: float, mass: float, way: Way) -> str:
    """Words of a contact of two bodies of a material; radius (m), mass (kg): reduced ones."""
    said = touch.model_dump()
    values = {
        "modulus": material.youngs_modulus, "poisson": material.poissons_ratio,
        "restitution": told_where_cut(touch.restitution) if way.cut else touch.restitution,
        "friction": touch.sliding_friction, "rolling_friction": said.get("rolling_friction"),
        # moments over the radius are forces, and angles times it are ways
        "rolling_stiffness": (said.get("rolling_stiffness_N_m") or 0.0) / radius**2,
        "rolling_damping": (said.get("rolling_damping_N_m_s") or 0.0) / radius**2,
    }  # fmt: skip
    damping = way.damping
    if adhesion := said.get("work_of_adhesion_J_m2"):
        assert touch.restitution is not None
        dashpot = viscosity(material, touch.restitution, adhesion, radius, mass)
        values |= {"surface_energy": 0.5 * adhesion, "viscosity": dashpot}
        damping = VISCOELASTIC
    parts = (
        _word(NORMAL, (touch.normal, touch.cohesion)), _word(TANGENTIAL, touch.tangential), _word(ROLLING, touch.rolling),
        _word(TWISTING, touch.twisting),
    )  # fmt: skip
    cut = " limit_damping" if way.cut else ""
    return " ".join([*(part.format(**values) for part in parts if part), f"damping {damping}{cut}"])


def told_where_cut(restitution: float | None) -> float:
    """Restitution (1) by which LAMMPS makes the dashpot that has another one where it never pulls.

    Its dashpot is that of Antypov & Elliott (2011), whose damping number is -sqrt(5) ln e/sqrt(ln^2 e + pi^2).
    """
    assert restitution is not None
    damping = damping_where_cut(restitution)
    if damping >= sqrt(5.0):
        raise CannotSay(f"no dashpot that is cut is so strong as for a restitution of {restitution:g}")
    return exp(-pi * damping / sqrt(5.0 - damping**2))


def viscosity(material: Material, restitution: float, adhesion: float, radius: float, mass: float) -> float:
    """Number (1/(m s)) of LAMMPS' viscoelastic dashpot, as strong as that of the restitution where the contact bears no load.

    Its dashpot goes with mass and contact radius, ours with the root of both; that radius is JKR's,
    (9 pi w R^2 / (2 E*))^(1/3).
    """
    modulus = material.youngs_modulus / (2.0 * (1.0 - material.poissons_ratio**2))
    wide = (4.5 * pi * adhesion * radius**2 / modulus) ** (1.0 / 3.0)
    return damping_where_cut(restitution) * sqrt(4.0 / 3.0 * modulus / (mass * wide))


def _word(words_of: dict, law) -> str:
    if law not in words_of:
        raise CannotSay(f"the law {law} is not told here")
    return words_of[law]
