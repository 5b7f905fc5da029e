"""Builds a frozen seismic scene in SI from a study's units: the tube, its base motion and its measured answer."""

from collections.abc import Callable
from dataclasses import dataclass, replace
from functools import cache
from pathlib import Path
from typing import Any

from silostudy.config.seismic import Imitation, Motion, SeismicScene, SeismicStudy, Series, TubeConfig
from silostudy.errors import BadInput
from silostudy.seismic.beam import Tube
from silostudy.seismic.identify import emptied
from silostudy.seismic.readers import read_known, read_record
from silostudy.seismic.records import Record, compressed, in_band, scaled, without_baseline
from silostudy.tables.records import RECORDS

KNOWN = cache(read_known)


@dataclass(frozen=True, kw_only=True)
class Shaken:
    """One shaken silo, in SI units; measured is None where `imitation` takes its place, or nothing was measured.

    empty_frequency is None where the tube keeps its whole stiffness.
    """

    tube: Tube
    empty_frequency: float | None
    damping_ratio: float
    base: Record
    measured: Record | None
    imitation: Imitation | None
    source: str  # of the base motion; empty for a user's file
    files: tuple[Path, ...]


def seismic_builder(study: SeismicStudy, folder: Path, where: str) -> Callable[[SeismicScene, dict], Shaken]:
    """Builds the scenes of a seismic study; BadInput for a file that cannot be read or does not fit the study."""

    def build_one(config: SeismicScene, settings: dict[str, Any]) -> Shaken:
        base, measured, tube = _base(config.motion, folder), config.measured, _tube(config)
        _check_frequencies(study, config, tube, where)
        if study.identification:
            _check_band(study.identification.band_Hz, base, where)
        return Shaken(
            tube=tube,
            empty_frequency=config.empty_frequency_Hz,
            damping_ratio=config.damping_ratio,
            base=base,
            measured=_measured(measured, folder, base) if measured and measured.file else None,
            imitation=measured.imitation if measured else None,
            source=RECORDS[config.motion.record].source if config.motion.record else "",
            files=tuple(folder / part.file for part in (config.motion, measured) if part and part.file),
        )

    return build_one


def _check_band(band: tuple[float, float], base: Record, where: str) -> None:
    if band[1] > 0.5 / base.dt:
        allowed = f"must end below {0.5 / base.dt:g} Hz, half the sampling rate of the base motion"
        raise BadInput("identification.band_Hz", list(band), allowed, where)


def _check_frequencies(study: SeismicStudy, config: SeismicScene, tube: Tube, where: str) -> None:
    """BadInput for an empty tube measured to be stiffer than its whole stiffness, by more than its frequency's rounding."""
    whole, asked, sine = emptied(tube), study.identification, study.sine
    measured = [
        ("scene.empty_frequency_Hz", config.empty_frequency_Hz, asked.empty_frequency_rounding_Hz if asked else 0.0),
        ("sine.empty_frequency_Hz", sine.empty_frequency_Hz if sine else None, sine.rounding_Hz if sine else 0.0),
    ]
    for key, frequency, rounding in measured:
        if frequency is not None and frequency - rounding > whole * (1 + 1e-9):
            allowed = f"must not be above {whole:.4g} Hz, the empty tube's with its whole stiffness: silo and wall are softer"
            raise BadInput(key, frequency, allowed, where)


def _tube(config: SeismicScene) -> Tube:
    size: TubeConfig = config.silo
    return Tube(
        radius=size.mid_wall_radius_m,
        thickness=size.wall_thickness_mm / 1e3,
        height=size.height_m,
        fill_height=size.fill_height_m or size.height_m,
        wall_density=config.wall.density_kg_m3,
        youngs_modulus=config.wall.youngs_modulus_GPa * 1e9,
        poisson_ratio=config.wall.poisson_ratio,
        shear_factor=config.wall.shear_factor,
        contents_density=config.contents.density_kg_m3,
    )


def _base(motion: Motion, folder: Path) -> Record:
    """The base motion: baseline first, then time, band and peak."""
    record = KNOWN(motion.record) if motion.record else _read(motion, folder)
    if motion.synthetic:
        record = replace(record, origin=f"{record.origin} (synthetic)")
    record = compressed(without_baseline(record, motion.baseline), motion.time_compression)
    if motion.band_Hz:
        record = in_band(record, *motion.band_Hz)
    return scaled(record, motion.peak_acceleration_gal / 100) if motion.peak_acceleration_gal else record


def _measured(series: Series, folder: Path, base: Record) -> Record:
    """The measured top acceleration, sampled as the base motion is."""
    record = _read(series, folder)
    fits = len(record.acceleration) == len(base.acceleration) and abs(record.dt / base.dt - 1) < 1e-3
    if not fits:
        told = f"{len(base.acceleration)} samples at {base.dt:g} s"
        allowed = f"must be sampled as the base motion is after time compression: {told}"
        raise BadInput("measured.file", f"{len(record.acceleration)} samples at {record.dt:g} s", allowed, record.origin)
    return record


def _read(series: Series, folder: Path) -> Record:
    assert series.file is not None  # callers come here only with a file
    return read_record(folder / series.file, series.format, series.acceleration_unit, series.channel)
