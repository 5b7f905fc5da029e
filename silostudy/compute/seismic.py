"""The seismic stage: resonance curves, histories, likeness indices, identification, recovery test and demand of every case."""

from collections.abc import Callable

import numpy as np
import xarray as xr

from silostudy.compute.axes import axis_coordinates
from silostudy.compute.variables import attributes
from silostudy.cube.contract import VARIABLES, check
from silostudy.cube.provenance import provenance
from silostudy.scene.expand import Expansion
from silostudy.scene.seismic import Shaken
from silostudy.seismic import identify
from silostudy.seismic.added_mass import mass_ratio, stiffness_reduction, volume_ratio
from silostudy.seismic.beam import modes
from silostudy.seismic.demand import demand
from silostudy.seismic.en1998_4 import contents_share
from silostudy.seismic.likeness import amplitude_error, phase_error, phase_error_as_printed, spectrum
from silostudy.seismic.response import transfer

IDENTIFICATIONS = ("amplitude_error", "amplitude_error_coarse", "phase_error", "phase_error_coarse")
CURVES = ("empty", "full", "all_contents")
MASS_CHOICES = ("identified", "eighty_percent", "all_contents")
BOUNDS = ("lower", "upper")
SOURCES = ("sasaki_yoshimura_effective_mass", "nigam_jennings_1969", "en1998_4_2006")


def seismic_cube(expansion: Expansion, tell: Callable[[str], None] = lambda text: None) -> xr.Dataset:
    """The cube of a seismic study; `tell` hears of each case as it is done."""
    study = expansion.study
    found = []
    for number, case in enumerate(expansion.cases):
        found.append(_case(study, case.scene, np.random.default_rng([study.seed, number])))
        tell(f"case {number + 1} of {len(expansion.cases)}: C_eff = {found[-1]['effective_mass_coefficient'][0]:.3f}")
    found = [{"case": np.array(case.id), **one} for case, one in zip(expansion.cases, found, strict=True)]
    axes = [axis.axis for axis in study.sweep]
    data = {name: (_dims(name, axes), _stacked([one[name] for one in found], expansion.shape), attributes(name))
            for name in found[0] if name != "depth"}  # fmt: skip
    depth = {"standard_name": "depth", "units": "m", "positive": "down", "long_name": "depth below the top of the contents"}
    coords = {
        **axis_coordinates(study),
        **_labels(study),
        "depth": ((*axes, "relative_depth"), _stacked([one["depth"] for one in found], expansion.shape), depth),
    }
    sources = [*SOURCES, *(case.scene.source for case in expansion.cases if case.scene.source)]
    about = provenance(study.title, study.model_dump_json(exclude_defaults=True), sources, "seismic")
    own = {
        "sweep_axes": " ".join(axes),
        "assumed": ", ".join(study.assumed),
        "published": study.published or "",
        "band_Hz": list(study.band_Hz),
    }
    return check(xr.Dataset(data, coords, {**about, **own}))


def _labels(study) -> dict[str, tuple]:
    """Coordinates of the cube's own axes."""
    values = {
        "coefficient": study.fine_coefficients,
        "shown_coefficient": list(study.shown_coefficients),
        "frequency": _listed(study.sine.frequency_Hz),
        "relative_depth": _listed(study.relative_depth),
        "identification": list(IDENTIFICATIONS),
        "contribution": list(identify.CONTRIBUTIONS),
        "curve": list(CURVES),
        "bound": list(BOUNDS),
        "mass_choice": list(MASS_CHOICES),
    }
    coords = {name: (name, listed, attributes(name)) for name, listed in values.items()}
    coords["relative_depth"] = ("relative_depth", values["relative_depth"], {**attributes("relative_depth")})
    return coords


def _listed(values) -> list[float]:
    return values.expand() if hasattr(values, "expand") else list(values)


def _dims(name: str, axes: list[str]) -> tuple[str, ...]:
    inner = ["relative_depth" if dim == "depth" else dim for dim in VARIABLES[name].dims if dim != "..."]
    return (*axes, *inner)


def _stacked(arrays: list[np.ndarray], shape: tuple[int, ...]) -> np.ndarray:
    """The cases' arrays in one, shorter histories filled up with NaN."""
    arrays = [np.asarray(array) for array in arrays]
    longest = np.max([array.shape for array in arrays], axis=0).astype(int)
    if any(array.shape != tuple(longest) for array in arrays):
        gaps = [[(0, most - size) for most, size in zip(longest, array.shape, strict=True)] for array in arrays]
        arrays = [np.pad(array, gap, constant_values=np.nan) for array, gap in zip(arrays, gaps, strict=True)]
    return np.array(arrays).reshape((*shape, *longest))


def _case(study, scene: Shaken, random: np.random.Generator) -> dict[str, np.ndarray]:
    """Everything of one case, by the names of the contract."""
    unreduced = identify.emptied(scene.tube)
    question = identify.Question(
        tube=scene.tube,
        stiffness_reduction=stiffness_reduction(scene.empty_frequency, unreduced),
        damping_ratio=scene.damping_ratio,
        base=scene.base,
        band=study.band_Hz,
        coefficients=np.array(study.fine_coefficients),
        damping_mismatch=study.damping_mismatch,
    )
    bank = identify.bank(question)
    measured = _measured(scene, question)
    answers = _identified(bank, measured, study.refinement, random)
    return {
        **_given(scene, question, unreduced),
        **_resonance(study.sine, scene, unreduced),
        **_histories(study, question, measured),
        **answers,
        **_recovered(study, bank, random),
        **_demand(study, question, float(answers["effective_mass_coefficient"][0])),
    }


def _given(scene: Shaken, question: identify.Question, unreduced: float) -> dict:
    tube = scene.tube
    ratio = volume_ratio(radius=tube.radius, thickness=tube.thickness)
    densities = {"wall_density": tube.wall_density, "contents_density": tube.contents_density}
    true = scene.imitation
    said = f"{scene.measured.origin}" if scene.measured else ""
    if true:
        said = f"synthetic: model with C_eff = {true.effective_mass_coefficient:g} and damping ratio {true.damping_ratio:g}, "
        said += f"and white noise of {true.noise_ratio:.0%} of its rms"
    return {
        "tube_radius": tube.radius,
        "tube_thickness": tube.thickness,
        "tube_height": tube.height,
        "fill_height": tube.fill_height,
        "mass_ratio": mass_ratio(volume_ratio=ratio, **densities),
        "unreduced_frequency": unreduced,
        "empty_frequency": scene.empty_frequency,
        "stiffness_reduction": question.stiffness_reduction,
        "damping_ratio": scene.damping_ratio,
        "base_motion": scene.base.origin,
        "measured_origin": said,
        "code_contents_share": contents_share(tube.fill_height / (2 * tube.radius - tube.thickness)),
    }


def _measured(scene: Shaken, question: identify.Question) -> np.ndarray:
    """The measured top acceleration (m s-2), from the user's file or imitated."""
    if scene.measured:
        return scene.measured.acceleration
    true = scene.imitation
    assert true is not None  # the configuration asks for one of the two
    random = np.random.default_rng(true.seed)
    return identify.imitation(question, true.effective_mass_coefficient, true.damping_ratio, true.noise_ratio, random)


def _resonance(sine, scene: Shaken, unreduced: float) -> dict:
    """Resonance curves of the empty tube, of the full one with the coefficient its frequency gives, and with all contents."""

    def shifted(empty: float, full: float) -> float:
        return identify.coefficient_of_frequency(scene.tube, stiffness_reduction(empty, unreduced), full)

    alpha, error = stiffness_reduction(sine.empty_frequency_Hz, unreduced), sine.rounding_Hz
    coefficients = [0.0, shifted(sine.empty_frequency_Hz, sine.full_frequency_Hz), 1.0]
    shapes = [modes(scene.tube, one, alpha) for one in coefficients]
    gains = [transfer(_listed(sine.frequency_Hz), one, sine.damping_ratio)[:, 0] for one in shapes]
    bounds = [(sine.empty_frequency_Hz - s * error, sine.full_frequency_Hz + s * error) for s in (1, -1)]
    return {
        "sine_stiffness_reduction": alpha,
        "sine_damping_ratio": sine.damping_ratio,
        "sine_base_acceleration": sine.base_acceleration_gal / 100,
        "sine_coefficient": np.array(coefficients),
        "sine_frequency": np.array([one.frequency[0] for one in shapes]),
        "sine_coefficient_bound": np.array([shifted(*pair) for pair in bounds]),
        "resonance": np.abs(gains) * sine.base_acceleration_gal / 100,
    }


def _histories(study, question: identify.Question, measured: np.ndarray) -> dict:
    """Histories of base and top, and their Fourier amplitudes in the stated band."""
    base = question.base
    tops = np.array([identify.top_acceleration(question, one) for one in study.shown_coefficients])
    frequency, transform = spectrum(np.vstack([measured, tops]), base.dt, question.band)
    return {
        "elapsed_time": base.dt * np.arange(len(base.acceleration)),
        "base_acceleration": base.acceleration,
        "measured_acceleration": measured,
        "top_acceleration": tops,
        "spectrum_frequency": frequency,
        "measured_spectrum": np.abs(transform[0]),
        "top_spectrum": np.abs(transform[1:]),
    }


def _identified(bank: identify.Bank, measured: np.ndarray, refinement: int, random: np.random.Generator) -> dict:
    """Indices over the coefficients, the coefficients of least error at fine and coarse step, and how sure they are."""
    question = bank.question
    wanted = identify.transform(question, measured)
    amplitude, phase = amplitude_error(bank.known, wanted), phase_error(bank.known, wanted)
    fine, coarse = question.coefficients, question.coefficients[::refinement]
    found = [
        *(identify.vertex(amplitude, fine), identify.least(amplitude[::refinement], coarse)),
        *(identify.vertex(phase, fine), identify.least(phase[::refinement], coarse)),
    ]
    estimate = identify.estimate(bank, wanted, random)
    return {
        "candidate_frequency": bank.first_frequency,
        "amplitude_error": amplitude,
        "phase_error": phase,
        "phase_error_as_printed": phase_error_as_printed(bank.known, wanted),
        "effective_mass_coefficient": np.array(found),
        "uncertainty": estimate.uncertainty,
        "coarse_uncertainty": estimate.uncertainty + (refinement - 1) * estimate.contributions[-1],
        "uncertainty_contribution": estimate.contributions,
    }


def _recovered(study, bank: identify.Bank, random: np.random.Generator) -> dict:
    truth, answer, half_width = identify.recovery(bank, study.recovery_trials, study.recovery_noise_ratio, random)
    return {
        "recovery_truth": truth,
        "recovery_answer": answer,
        "recovery_uncertainty": half_width,
        "recovery_coverage": np.mean(np.abs(answer - truth) <= half_width),
    }


def _demand(study, question: identify.Question, identified: float) -> dict:
    """Demand on the wall with the identified share, with 80 % and with all of the contents."""
    depth = np.array(_listed(study.relative_depth)) * question.tube.fill_height
    choices = [identified, 0.8, 1.0]
    alpha, damping, base = question.stiffness_reduction, question.damping_ratio, question.base
    heights = np.append(question.tube.fill_height - depth, 0.0)  # the base last: the depths need not reach it
    found = [demand(question.tube, alpha, one, damping, base, heights) for one in choices]
    return {
        "depth": depth,
        "mass_choice_coefficient": np.array(choices),
        "wall_shear_force": np.array([one.shear_force[:-1] for one in found]),
        "wall_bending_moment": np.array([one.bending_moment[:-1] for one in found]),
        "seismic_axial_wall_force": np.array([one.axial_wall_force[:-1] for one in found]),
        "wall_acceleration": np.array([one.acceleration[:-1] for one in found]),
        "seismic_wall_pressure": np.array([one.wall_pressure[:-1] for one in found]),
        "base_shear": np.array([one.shear_force[-1] for one in found]),
        "base_moment": np.array([one.bending_moment[-1] for one in found]),
        "top_peak": np.array([one.top_peak for one in found]),
        "top_peak_sampled": np.array([one.top_peak_sampled for one in found]),
    }
