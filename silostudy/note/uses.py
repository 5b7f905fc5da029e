"""Utilisation of each part of a silo by each check, where, and in which combination, as the cube of the checks has it."""

from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np
import xarray as xr

from silostudy.buckling import BUCKLING
from silostudy.checks import BUCKLING as BY_RULE
from silostudy.checks import CHECKS
from silostudy.cube.contract import SCOPE
from silostudy.cube.silos import END
from silostudy.note.lines import every_line
from silostudy.note.mathml import rounded


@dataclass(frozen=True)
class Use:
    """Utilisation (1) of a part by a check, the combination, and where in the cube that stands."""

    key: str
    utilisation: float
    combination: str
    where: Mapping

    @property
    def told(self) -> str:
        """The utilisation in digits."""
        return rounded(self.utilisation) if np.isfinite(self.utilisation) else "–"


def uses_of_strake(cube: xr.Dataset, strake: int) -> list[Use]:
    """Every check of a strake at its worst end of the wall friction, as the cube has them in order."""
    uses = []
    for key in map(str, cube["followed_check"].values):
        followed = cube.sel(followed_check=key, strake=strake)
        end, used = worst(followed["followed_utilisation"])
        here = at_end(followed, end)
        combination = here["followed_combination"].attrs["flag_meanings"].split()[int(here["followed_combination"])]
        where = {"followed_check": key, "strake": strake, "end": end, "place": int(here["followed_place"])}
        uses.append(Use(key, used, combination if np.isfinite(used) else "", where))
    return uses


def worst(values: xr.DataArray) -> tuple[int, float]:
    """Number of the end of the wall friction with the largest value, and that value; 0 and NaN where all are masked."""
    ends = np.atleast_1d(values.values)
    end = int(np.argmax(np.where(np.isnan(ends), -np.inf, ends)))
    return end, float(ends[end])


def governing(cube: xr.Dataset, uses: list[Use]) -> Use:
    """The check that governs: by the study's first rule of buckling, or a check that is not of buckling."""
    others = [str(key) for key in cube["rule"].values[1:]]
    counted = [use for use in uses if use.key not in others and np.isfinite(use.utilisation)]
    return max(counted, key=lambda use: use.utilisation, default=uses[0])


def _used(cube: xr.Dataset, name: str, dim: str, key: str) -> Use:
    values = cube[name].sel({dim: key})
    dims = [axis for axis in ("combination", END, "hopper_position") if axis in values.dims]
    values = values.transpose(*dims)
    if values.isnull().all():
        return Use(key, np.nan, "", {})
    place = dict(zip(dims, np.unravel_index(int(np.nanargmax(values.values)), values.shape), strict=True))
    combination = str(cube["combination"].values[place["combination"]])
    where = {"end": int(place.get(END, 0)), "place": int(place.get("hopper_position", 0))}
    return Use(key, float(values.max()), combination, where)


def why_of_part(cube: xr.Dataset, part: str, key: str) -> str:
    """Reason, in words, why a check of hopper or support is nowhere made: the one that stands most often."""
    return _commonest(cube[f"{part}_check_utilisation{SCOPE}"].sel({f"{part}_check": key}))


def _commonest(flags: xr.DataArray) -> str:
    return flags.attrs["flag_meanings"].split()[int(np.bincount(flags.values.ravel()).argmax())].replace("_", " ")


def why(cube: xr.Dataset, key: str, rules: list[str], strake: int) -> str:
    """Reason, in words, why a check is nowhere made in a strake: the one that stands most often."""
    name, dim = ("design_buckling_utilisation", "rule") if key in rules else ("design_check_utilisation", "steel_check")
    return _commonest(cube[name + SCOPE].sel({dim: key}).isel(place=at_end(cube, 0)["place_strake"].values == strake))


def at_end(cube: xr.Dataset, number: int) -> xr.Dataset:
    """The part of a cube at an end of the wall friction; all of it where the study sweeps none."""
    return cube.isel({END: number}) if END in cube.dims else cube


def titled(cube: xr.Dataset, key: str) -> str:
    """A check or rule in words."""
    rules = [str(rule) for rule in cube["rule"].values]
    if key == BY_RULE:
        key = rules[0]
    if key in rules:
        return f"axial buckling, {cube['rule_title'].values[rules.index(key)]}"
    return key.replace("_", " ")


def told_of(key: str) -> tuple[str, ...]:
    """Formula of a check or a rule, as `silostudy explain` has it, and its range."""
    row = CHECKS[key] if key in CHECKS else BUCKLING.get(key)
    if row is None:
        return ()
    formula = () if owned(key) else (f"Formula: {row.formula}.",)
    return (*formula, f"Range and evidence: {row.validity}.")


def owned(key: str) -> bool:
    """Whether a rule or check has lines of its own."""
    return any(key in line.owner for line in every_line())


def uses_of_part(cube: xr.Dataset, part: str) -> list[Use]:
    """Every check of hopper or support at its worst, as the cube has them in order."""
    dim = f"{part}_check"
    return [_used(cube, f"{dim}_utilisation", dim, key) for key in map(str, cube[dim].values if dim in cube.dims else ())]
