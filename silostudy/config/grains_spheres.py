"""Spheres in a round silo that is shaken, as a user writes them."""

from typing import Literal

from silostudy.config.elastic import GrainConfig, MaterialConfig, TouchConfig
from silostudy.config.fields import Strict, described
from silostudy.config.mixture import SizesConfig
from silostudy.config.shaking import Shaking


class RoundBox(Strict):
    """A round silo with a flat floor."""

    diameter_m: float = described("inner diameter", "m", gt=0)
    slenderness: float = described("height of the fill, about, over the diameter", gt=0, le=10)


class ShakenSpheres(Strict):
    """One round silo that spheres are rained into, and its shaking."""

    grains: Literal["spheres"] = described("spheres in a round silo; without this key the scene is of discs in a plane box", "")
    box: RoundBox = described("the silo", "")
    grain: GrainConfig = described("material of the spheres", "")
    wall: MaterialConfig = described("material of wall and floor", "")
    spheres: TouchConfig = described("contact between spheres", "", default=TouchConfig())
    walls: TouchConfig = described("contact of spheres with wall and floor", "", default=TouchConfig())
    sizes: SizesConfig = described("sizes of the spheres", "")
    shaking: Shaking = described("horizontal acceleration of the silo", "")
    step_factor: float = described("time step over the one that the engine chooses", gt=0, le=1, default=1.0)
