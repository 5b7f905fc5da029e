"""The solid of a laboratory's cube: means and scatter over fillings, its row, and what must hold."""

from collections.abc import Iterator
from dataclasses import dataclass
from math import degrees, sin, tan

import numpy as np
import xarray as xr

from silostudy.errors import BadInput

# axes of every laboratory's cube
CELL = "cell"
FILLING = "filling"
FRACTILE = 1.28  # standard deviations from the mean to the fractiles of 10 and 90 % of a normal distribution
OWN_AXES = {CELL, FILLING}


@dataclass(frozen=True)
class Scatter:
    """A quantity over the fillings of a cell: mean, standard deviation, and how many fillings."""

    mean: float
    deviation: float
    count: int

    @classmethod
    def of(cls, values: xr.DataArray) -> "Scatter":
        """Scatter over the fillings that were computed; BadInput for fewer than two."""
        known = values.values[np.isfinite(values.values)]
        if len(known) < 2:
            told = f"{len(known)} of {values.size} fillings of a cell show it: a scatter needs two"
            raise BadInput(str(values.name), values.values.tolist(), told)
        return cls(float(known.mean()), float(known.std(ddof=1)), len(known))

    @property
    def factor(self) -> float:
        """Upper characteristic value over the mean (1), and the mean over the lower one: fractiles of 90 and 10 %.

        Source: en1991_4_2006, conversion factors from scatter; from memory, not checked.
        """
        return 1.0 + FRACTILE * self.deviation / self.mean


@dataclass(frozen=True)
class MeasuredSolid:
    """Properties of the solid by the tests of one cell: unit weights (N/m3), angles (rad), friction, pressure ratio (1).

    flow_angle: of steady shear; a solid without cohesion flows with it at any stress, so it is its effective friction angle.
    """

    loose: Scatter
    repose_angle: Scatter
    unit_weight: Scatter
    friction_angle: Scatter
    flow_angle: Scatter
    wall_friction: Scatter
    lateral_pressure_ratio: Scatter

    @classmethod
    def of(cls, cube: xr.Dataset, cell: int = -1) -> "MeasuredSolid":
        """The solid of the cell at a position, the last one's: the widest; BadInput for a cube with further axes."""
        if others := set(cube.attrs["sweep_axes"].split()) - OWN_AXES:
            raise BadInput("sweep", ", ".join(sorted(others)), "one solid is one row: select a position on it first")
        tested = cube.isel({CELL: cell})
        upright = tested.sel(normal_stress=float(tested["row_vertical_stress"]))
        on_wall = tested.sel(normal_stress=float(tested["row_horizontal_stress"]))
        return cls(
            loose=Scatter.of(tested["loose_unit_weight"]),
            repose_angle=Scatter.of(tested["tested_repose_angle"]),
            unit_weight=Scatter.of(upright["tested_unit_weight"]),
            friction_angle=Scatter.of(xr.apply_ufunc(np.arctan, upright["internal_peak_shear_ratio"])),
            flow_angle=Scatter.of(xr.apply_ufunc(np.arctan, upright["internal_steady_shear_ratio"])),
            wall_friction=Scatter.of(on_wall["wall_steady_shear_ratio"]),
            lateral_pressure_ratio=Scatter.of(upright["tested_lateral_pressure_ratio"]),
        )

    def row(self, cube: xr.Dataset) -> dict[str, str | float]:
        """The row of the solid, in the columns of the solids table."""
        fillings, width = self.loose.count, float(cube[CELL][-1])
        vertical, horizontal = (1e-3 * float(cube[f"row_{way}_stress"]) for way in ("vertical", "horizontal"))
        return {
            "solid": str(cube["row_solid"].item()),
            "title": cube.attrs["title"],
            "grain": str(cube["row_grain"].item()),
            "unit_weight_kN_m3": 1e-3 * self.unit_weight.mean * self.unit_weight.factor,
            "unit_weight_lower_kN_m3": 1e-3 * self.loose.mean / self.loose.factor,
            "internal_friction_angle_deg": degrees(self.friction_angle.mean),
            "effective_friction_angle_deg": degrees(self.flow_angle.mean),
            "repose_angle_deg": degrees(self.repose_angle.mean),
            "wall_friction": self.wall_friction.mean,
            "lateral_pressure_ratio": self.lateral_pressure_ratio.mean,
            "a_phi": self.friction_angle.factor,
            "a_K": self.lateral_pressure_ratio.factor,
            "a_mu": self.wall_friction.factor,
            "source": f"virtual laboratory of silostudy, study {cube.attrs['study_hash']}",
            "locator": f"{fillings} fillings of a cell {width:g} grains wide",
            "remark": f"{cube['row_remark'].item()}; at {vertical:g} kPa, wall friction steady at {horizontal:g} kPa; "
            f"lower unit weight as filled, effective friction angle of steady shear; "
            f"factors 1 + {FRACTILE} deviation/mean",
        }


@dataclass(frozen=True)
class Check:
    """Something that must hold of tests: what is looked at, its value, and between which ends it must lie."""

    what: str
    value: float
    least: float
    greatest: float

    @property
    def holds(self) -> bool:
        """Whether the value lies between the ends."""
        return self.least <= self.value <= self.greatest

    def __str__(self) -> str:
        told = "holds" if self.holds else "does not hold"
        return f"{self.what}: {self.value:.3g}, to be from {self.least:.3g} to {self.greatest:.3g}: {told}"


def active_ratio(sine: float) -> float:
    """Lateral pressure ratio (1) at which a solid of a friction angle of this sine yields: Rankine's active one."""
    return (1.0 - sine) / (1.0 + sine)


def checks(cube: xr.Dataset) -> Iterator[Check]:
    """Conditions that the tests of the widest cell must meet.

    The row's angle is that of the largest shear over the normal stress on the sheared plane.  As that plane keeps its length,
    the ratio is rather the angle's sine: a K below the active ratio of that angle is out of reach, but for the scatter.  Below
    the active ratio of the row's own angle it may well be.
    """
    solid = MeasuredSolid.of(cube)
    ratio, angle = solid.lateral_pressure_ratio, solid.friction_angle
    upper, steep = ratio.mean * ratio.factor, angle.mean * angle.factor
    yield Check("upper K over Rankine's of upper phi, tau/sigma for its sine", upper / active_ratio(tan(steep)), 1.0, np.inf)
    yield Check("K over Rankine's active ratio of the row's phi", ratio.mean / active_ratio(sin(angle.mean)), 1.0, np.inf)
    yield Check("K over 1.1 (1 - sin phi)", ratio.mean / (1.1 * (1.0 - sin(angle.mean))), 0.0, 1.0)
    wide = cube.isel({CELL: -1})
    back = wide["tested_restitution"] / wide["asked_restitution"]
    if back.notnull().any():
        yield Check("restitution of a dropped grain over that asked for", float(back.mean()), 0.98, 1.02)
    drawn = Scatter.of(wide["tested_drawn_angle"])
    yield Check("drawn-down over poured angle of repose", drawn.mean / solid.repose_angle.mean, 1.0, np.inf)
    steady = cube.isel({CELL: -1})[["internal_steady_shear_ratio", "wall_steady_shear_ratio"]].mean(FILLING)
    for stress, inside, wall in zip(steady["normal_stress"].values, *(steady[name].values for name in steady), strict=True):
        yield Check(f"wall over internal friction, steady at {1e-3 * stress:g} kPa", wall / inside, 0.0, 1.0)
