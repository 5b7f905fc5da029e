"""A seismic study: a tube with contents, the motion of its base, and what was measured on it."""

from typing import Any, ClassVar, Literal, Self, TypeAlias

from pydantic import field_validator, model_validator

from silostudy.config.asked import Asked
from silostudy.config.fields import Numbers, Strict, ValueRange, described, expand
from silostudy.config.study import BaseStudy
from silostudy.tables.outputs import OUTPUTS
from silostudy.tables.records import RECORDS

RecordKey: TypeAlias = Literal[tuple(RECORDS)]  # type: ignore[valid-type]
Baseline = Literal["none", "mean", "linear"]
Unit = Literal["g", "gal", "m_s2"]
Form = Literal["obspy", "peer_at2", "two_columns"]


class TubeConfig(Strict):
    """The silo's wall as a tube clamped at its base."""

    mid_wall_radius_m: float = described("radius of the wall's middle surface", "m", gt=0)
    wall_thickness_mm: float = described("thickness of the wall", "mm", gt=0)
    height_m: float = described("height of the wall above its clamped base", "m", gt=0)
    fill_height_m: float | None = described("height of the contents; null: filled to the top", "m", gt=0, default=None)

    @model_validator(mode="after")
    def _possible(self) -> Self:
        if self.wall_thickness_mm / 1e3 >= 2 * self.mid_wall_radius_m:
            raise ValueError("wall_thickness_mm must be smaller than the diameter")
        if (self.fill_height_m or 0) > self.height_m:
            raise ValueError("fill_height_m must not be above height_m")
        return self


class TubeMaterial(Strict):
    """The wall's material."""

    density_kg_m3: float = described("mass density of the wall", "kg m-3", gt=0)
    youngs_modulus_GPa: float = described("Young's modulus before the stiffness reduction", "GPa", gt=0)
    poisson_ratio: float = described("Poisson's ratio of the wall", ge=0, lt=0.5)
    shear_factor: float = described("shear factor of the section; 0.5 for a thin ring", gt=0, le=1, default=0.5)


class Contents(Strict):
    """The stored solid."""

    density_kg_m3: float = described("bulk density of the contents", "kg m-3", gt=0)


class Series(Strict):
    """A file with an acceleration history."""

    file: str | None = described("the file, relative to the study file", "", default=None)
    format: Form = described(
        "obspy: K-NET, KiK-net and all that obspy reads; peer_at2; two_columns: equally spaced times (s) and accelerations",
        "",
        default="obspy",
    )
    acceleration_unit: Unit | None = described(
        "unit in the file, refused where the file says another; null where the file says it (K-NET, PEER AT2)", "", default=None
    )
    channel: str | None = described(
        "which of several traces in an obspy file, by its channel or NET.STA.LOC.CHA; null: the only one", "", default=None
    )

    @model_validator(mode="after")
    def _unit_stated(self) -> Self:
        if self.file and self.format == "two_columns" and self.acceleration_unit is None:
            raise ValueError("two_columns needs acceleration_unit: g, gal or m_s2")
        if self.channel is not None and not (self.file and self.format == "obspy"):
            raise ValueError("channel goes with a file of format obspy")
        return self


class Motion(Series):
    """Acceleration of the base."""

    record: RecordKey | None = described("a record at hand (`silostudy list records`), in place of file", "", default=None)
    synthetic: bool = described("whether the file holds no real record; figures and cube then say so", "", default=False)
    baseline: Baseline = described("what to take off first: its mean, the best straight line, or nothing", "", default="mean")
    time_compression: float = described("how many times as fast to run it: n for a model of scale 1/n", gt=0, default=1.0)
    band_Hz: tuple[float, float] | None = described("filter to this band, after compression; null: none", "Hz", default=None)
    peak_acceleration_gal: float | None = described("scale to this peak; null: as recorded", "gal", gt=0, default=None)

    @model_validator(mode="after")
    def _one_source(self) -> Self:
        if (self.file is None) == (self.record is None):
            raise ValueError(f"give either file or record ({', '.join(RECORDS)}), and not both")
        if self.synthetic and self.record:
            raise ValueError("synthetic goes with file: the records at hand are real")
        return self


class Imitation(Strict):
    """A synthetic response in place of a measured one: the model with known values, and white noise."""

    effective_mass_coefficient: float = described("the truth to be found again", ge=0)
    damping_ratio: float = described("damping of the imitation, which the judge does not know", gt=0, lt=1)
    noise_ratio: float = described("rms of the white noise over rms of the response", ge=0)
    seed: int = described("seed of the noise", ge=0, default=0)


class MeasuredTop(Series):
    """Acceleration of the top: measured, or imitated."""

    imitation: Imitation | None = described("a synthetic response in place of a file; labelled as such", "", default=None)

    @model_validator(mode="after")
    def _one_source(self) -> Self:
        if (self.file is None) == (self.imitation is None):
            raise ValueError("give either file or imitation, and not both")
        return self


class SeismicScene(Strict):
    """One tube with contents, its shaking, and its measured answer."""

    silo: TubeConfig = described("shape and size", "")
    wall: TubeMaterial = described("material of the wall", "")
    contents: Contents = described("the stored solid", "")
    empty_frequency_Hz: float | None = described(
        "measured first frequency of the empty tube, not above that of its whole stiffness: gives the stiffness reduction; "
        "null: the whole stiffness",
        "Hz",
        gt=0,
        default=None,
    )
    damping_ratio: float = described("damping ratio of every mode, from the empty tube", gt=0, lt=1)
    motion: Motion = described("acceleration of the base", "")
    measured: MeasuredTop | None = described("acceleration of the top, for an identification", "", default=None)


class Sine(Strict):
    """A steady sine sweep on the empty and on the filled tube."""

    empty_frequency_Hz: float = described("resonance of the empty tube", "Hz", gt=0)
    full_frequency_Hz: float = described("resonance of the filled tube", "Hz", gt=0)
    rounding_Hz: float = described("half of the last digit of both frequencies: the least they may be off by", "Hz", ge=0)
    damping_ratio: float = described("damping ratio of every mode", gt=0, lt=1)
    base_acceleration_gal: float = described("amplitude of the base's acceleration", "gal", gt=0)
    frequency_Hz: ValueRange | Numbers = described("frequencies of the resonance curves", "Hz")

    @model_validator(mode="after")
    def _ordered(self) -> Self:
        if self.full_frequency_Hz + self.rounding_Hz >= self.empty_frequency_Hz - self.rounding_Hz:
            raise ValueError("full_frequency_Hz must be below empty_frequency_Hz by more than their rounding")
        return self


class Identification(Strict):
    """Search for the effective mass coefficient in a measured response, and its uncertainty."""

    coefficients: ValueRange = described(
        "effective mass coefficients to try; an answer at their end is flagged and its uncertainty is infinite"
    )
    refinement: int | None = described("finer steps in each of theirs; null: for the accuracy", ge=1, le=1000, default=10)
    shown_coefficients: Numbers = described("coefficients whose histories and spectra are kept and drawn")
    band_Hz: tuple[float, float] = described("band of the likeness indices", "Hz")
    damping_mismatch: float = described("relative half-width within which the damping ratio is known", ge=0, lt=1)
    empty_frequency_rounding_Hz: float = described(
        "half-width within which the empty tube's frequency is known, and with it the stiffness", "Hz", ge=0
    )
    recovery_trials: int = described("trials of the recovery test", ge=2, le=100_000, default=100)
    recovery_noise_ratio: float = described("rms of the noise over rms of the response in the trials", ge=0)

    @field_validator("band_Hz")
    @classmethod
    def _band(cls, band):
        if not 0 <= band[0] < band[1]:
            raise ValueError("must be two increasing frequencies, the first not negative")
        return band

    @field_validator("coefficients")
    @classmethod
    def _rising(cls, coefficients):
        if not 0 <= coefficients.start < coefficients.stop or coefficients.spacing != "linear":
            raise ValueError("must rise in equal steps from 0 or more")
        return coefficients

    @property
    def fine_coefficients(self) -> list[float]:
        """The coefficients with `refinement` steps in each of theirs."""
        coarse = self.coefficients
        assert self.refinement is not None, "identification.refinement is not chosen yet"
        return ValueRange(start=coarse.start, stop=coarse.stop, count=(coarse.count - 1) * self.refinement + 1).expand()


class SeismicStudy(Asked, BaseStudy):
    """Demand of an earthquake on a silo's wall and, where a response was measured, the effective mass of the contents."""

    fronts: ClassVar[tuple[str, ...]] = ("seismic",)

    kind: Literal["seismic"] = described("seismic: a silo in an earthquake, and the effective mass of its contents", "")
    scene: SeismicScene = described("the base scene", "")
    assumed: tuple[str, ...] = described(
        "dotted keys of the scene or sine whose values the source does not print", "", default=()
    )
    published: Literal["sasaki_1991"] | None = described("published results to show beside the computed", "", default=None)
    sine: Sine | None = described("the sine sweep; null: none", "", default=None)
    identification: Identification | None = described(
        "find the effective mass coefficient from scene.measured; null: only the demand on the wall", "", default=None
    )
    seed: int = described("seed of noise and trials", ge=0, default=0)
    relative_depth: ValueRange | Numbers | None = described(
        "depths over the height of the contents, 0 ... 1, for the demand on the wall; null: for the accuracy"
    )

    @field_validator("relative_depth")
    @classmethod
    def _inside(cls, depths):
        if depths is None:
            return None
        listed = expand(depths)
        if listed != sorted(set(listed)) or listed[0] < 0 or listed[-1] > 1:
            raise ValueError("must rise within 0 ... 1, none twice")
        return depths

    @model_validator(mode="after")
    def _assumed_exist(self) -> Self:
        for dotted in self.assumed:
            node: Any = self.sine if dotted.startswith("sine.") else self.scene
            for part in dotted.removeprefix("sine.").split("."):
                if part not in type(node).model_fields if isinstance(node, Strict) else True:
                    raise ValueError(f"assumed names {dotted}, which is no key of the scene or of sine")
                node = getattr(node, part)
        return self

    @model_validator(mode="after")
    def _measured_to_identify(self) -> Self:
        if (self.identification is None) != (self.scene.measured is None):
            raise ValueError("identification and scene.measured need each other")
        if self.identification is not None and self.scene.empty_frequency_Hz is None:
            raise ValueError("identification needs scene.empty_frequency_Hz")
        for key in self.outputs:
            for part in sorted(OUTPUTS[key].demands & {"sine", "identification"}):
                if getattr(self, part) is None:
                    raise ValueError(f"output {key} needs the section {part}")
        return self
