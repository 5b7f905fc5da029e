"""A pressure study: which methods, phases and depths."""

from itertools import pairwise
from math import prod
from typing import ClassVar, Literal, Self, TypeAlias

from pydantic import Field, ValidationInfo, field_validator, model_validator

from silostudy.catalogue import Family
from silostudy.config.asked import Asked
from silostudy.config.fields import Numbers, Strict, ValueRange, described, expand
from silostudy.config.own import OwnMethods, families_of, key_of, keys_of
from silostudy.config.scene import SceneConfig
from silostudy.config.study import BaseStudy, distinct
from silostudy.pressure import PRESSURE
from silostudy.pressure.family import PHASES, USUAL_PHASES, usual
from silostudy.tables.load_cases import LOAD_CASES
from silostudy.tables.outputs import OUTPUTS

MOST_SILOS = 100  # whose loads one cube holds
FIELD_METHODS = tuple(dict.fromkeys(key for row in LOAD_CASES.values() for key in row.methods))
MethodKey: TypeAlias = key_of(PRESSURE)  # type: ignore[valid-type]
MethodKeys: TypeAlias = keys_of(PRESSURE)  # type: ignore[valid-type]
PhaseKey: TypeAlias = Literal[PHASES]  # type: ignore[valid-type]


class Uncertainty(Strict):
    """Scatter of the stored solid, sampled: mean times or over the solid's a_phi, a_K, a_mu, and its unit weights."""

    log2_samples: float | None = described(
        "sample size as a power of two, whole or not; null: for the accuracy", ge=6, le=16, default=10
    )
    seed: int = described("seed of the quasi-random sequence: the same seed gives the same numbers", ge=0, default=1)

    @property
    def samples(self) -> int:
        """Sample size."""
        assert self.log2_samples is not None, "uncertainty.log2_samples is not chosen yet"
        return round(2**self.log2_samples)


class Loads(Strict):
    """The load cases as fields for finite elements."""

    levels: int = described("levels between which each part of a load runs straight", ge=11, le=2001, default=201)


class PressureStudy(Asked, OwnMethods, BaseStudy):
    """Wall pressures of silos by theories and design codes."""

    fronts: ClassVar[tuple[str, ...]] = ("pressure",)
    joins: ClassVar[tuple[Family, ...]] = (PRESSURE,)

    kind: Literal["pressure"] = described("pressure: wall pressures by theories and design codes", "")
    scene: SceneConfig = described("the base scene", "")
    materials: str | None = described(
        "CSV file with further solids, relative to the study file, in the columns of the solids table", "", default=None
    )
    methods: MethodKeys = described("pressure methods, or all (but for those that stand on one source alone: name them)", "")
    as_printed: tuple[MethodKey, ...] = described(
        "methods to give a second time with the source's misprints left in", "", default=()
    )
    phases: tuple[PhaseKey, ...] = Field(default=USUAL_PHASES, min_length=1, description="phases of operation")
    depth_m: ValueRange | Numbers | None = described("depths below the equivalent surface", "m", default=None)
    relative_depth: ValueRange | Numbers | None = described(
        "depths over the depth of the transition below the equivalent surface, 0 ... 1", default=None
    )
    hopper_position: ValueRange | Numbers | None = described(
        "places on the hopper wall, 0 the transition ... 1 the outlet; null: no results for the hopper wall", default=None
    )

    floor_position: ValueRange | Numbers | None = described(
        "places on a flat circular floor, 0 the middle ... 1 the wall; null: no results for the floor", default=None
    )
    loads: Loads | None = described(
        "give every load case of EN 1991-4 as a field over depth and angle, for finite elements (a stage of its own); null: do "
        "not",
        "",
        default=None,
    )
    uncertainty: Uncertainty | None = described(
        "sample the solid's scatter through every method (a stage of its own); null: do not", "", default=None
    )

    @field_validator("methods")
    @classmethod
    def _some_method(cls, methods):
        if not methods:
            raise ValueError(f"a study needs a method; known: {', '.join(PRESSURE)}")
        return methods

    @field_validator("methods", "as_printed", "phases")
    @classmethod
    def _no_twin_keys(cls, keys):
        return distinct(keys)

    @field_validator("as_printed")
    @classmethod
    def _has_misprint(cls, keys, info: ValidationInfo):
        methods = families_of(info).get(PRESSURE.name, PRESSURE)
        for key in keys:
            if not methods[key].has_misprint:
                known = ", ".join(k for k, row in methods.items() if row.has_misprint)
                raise ValueError(f"{key} has no misprint in the source; known: {known}")
        return keys

    @field_validator("depth_m", "relative_depth")
    @classmethod
    def _increasing(cls, depths):
        listed = expand(depths) if depths is not None else []
        if any(b <= a for a, b in pairwise(listed)):
            raise ValueError("depths must increase, none twice")
        if listed and listed[0] < 0:
            raise ValueError("depths must not be negative")
        return depths

    @field_validator("hopper_position", "floor_position")
    @classmethod
    def _on_the_bottom(cls, places):
        listed = expand(places) if places is not None else []
        if any(b <= a for a, b in pairwise(listed)) or any(not 0 <= place <= 1 for place in listed):
            raise ValueError("places on a bottom must increase from 0 to 1, none twice")
        return places

    @model_validator(mode="after")
    def _one_depth_axis(self) -> Self:
        if self.decides("relative_depth") and self.depth_m is not None:
            raise ValueError("give either depth_m or an accuracy that decides relative_depth, and not both")
        if not self.decides("relative_depth") and (self.depth_m is None) == (self.relative_depth is None):
            raise ValueError("give either depth_m or relative_depth, and not both")
        if self.relative_depth is not None and expand(self.relative_depth)[-1] > 1:
            raise ValueError("relative_depth ends at 1, the transition")
        return self

    @model_validator(mode="after")
    def _curves_of_outputs(self) -> Self:
        for key in self.outputs:
            for what, wanted, given in (
                ("methods", OUTPUTS[key].methods, self.method_keys),
                ("phases", OUTPUTS[key].phases, self.phases),
            ):
                if without := set(wanted) - set(given):
                    raise ValueError(f"output {key} needs the {what} {', '.join(sorted(without))}")
            if OUTPUTS[key].hopper and self.hopper_position is None:
                raise ValueError(f"output {key} shows the hopper: give hopper_position")
        return self

    @model_validator(mode="after")
    def _one_case_to_sample(self) -> Self:
        if self.uncertainty is not None and self.sweep:
            raise ValueError("uncertainty needs a study without sweep")
        return self

    @model_validator(mode="after")
    def _few_loads(self) -> Self:
        silos = prod(len(axis.settings()) for axis in self.sweep)
        if self.loads is not None and silos > MOST_SILOS:
            raise ValueError(f"loads are for {MOST_SILOS} silos at most; this study has {silos}")
        if self.loads is not None and not self.loaded_by:
            raise ValueError(f"loads need one of the methods {', '.join(FIELD_METHODS)}")
        return self

    @property
    def loaded_by(self) -> tuple[str, ...]:
        """The methods asked for that give load cases."""
        return tuple(key for key in self.method_keys if key in FIELD_METHODS)

    @property
    def method_keys(self) -> tuple[str, ...]:
        """The methods asked for, in order."""
        return usual(self.family(PRESSURE)) if self.methods == "all" else self.methods

    @property
    def depths(self) -> list[float]:
        """The depth axis: metres, or relative depths."""
        given = self.depth_m if self.depth_m is not None else self.relative_depth
        assert given is not None, "relative_depth is not chosen yet"  # else the validator above asks for one of the two
        return expand(given)
