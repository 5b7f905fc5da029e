"""The plan of a silo of grains beside codes: round, or a plane slot."""

from dataclasses import dataclass
from math import pi

import xarray as xr

from silostudy.config.scenes import ScenesStudy


@dataclass(frozen=True)
class Plan:
    """Width (m) of the silo, its hydraulic radius (m), and the way (m) around its wall; around 0: of a plane slot."""

    width: float
    hydraulic_radius: float
    around: float

    def side(self, height: xr.DataArray, share: float) -> xr.DataArray:
        """Root (m) of an area so high (m) over a share of the way around; on a plane wall, of no length, its height."""
        return (height * share * self.around) ** 0.5 if self.around else height


def plan_of(study: ScenesStudy) -> Plan:
    """The plan of a study's silos."""
    wide = study.silo_width
    return Plan(wide, wide / 2, 0.0) if study.scene.grains == "discs" else Plan(wide, wide / 4, pi * wide)
