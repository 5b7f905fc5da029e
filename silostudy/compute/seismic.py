"""The seismic stage: the demand on the wall of every case, and where asked for its resonance curves and identification."""

from collections.abc import Callable

import numpy as np
import xarray as xr

from silostudy.choice.expand import Resolved
from silostudy.compute.axes import stacked, sweep_of
from silostudy.compute.identified import identified, labels
from silostudy.config.fields import expand
from silostudy.cube.assemble import assemble
from silostudy.cube.variables import attributes
from silostudy.scene.seismic import Shaken
from silostudy.seismic import identify
from silostudy.seismic.added_mass import mass_ratio, stiffness_reduction, volume_ratio
from silostudy.seismic.beam import modes
from silostudy.seismic.demand import demand
from silostudy.seismic.en1998_4 import contents_share
from silostudy.seismic.response import transfer
from silostudy.tables.mass_choices import STATED

CURVES = ("empty", "full", "all_contents")
BOUNDS = ("lower", "upper")
SOURCES = ("sasaki_yoshimura_effective_mass", "nigam_jennings_1969", "en1998_4_2006")


def seismic_cube(expansion: Resolved, tell: Callable[[str], None] = lambda text: None) -> xr.Dataset:
    """The cube of a seismic study; `tell` hears of each case as it is done."""
    study = expansion.study
    cases = []
    for number, case in enumerate(expansion.cases):
        cases.append(_case(study, case.scene, np.random.default_rng([study.seed, number])))
        shares = ", ".join(f"{share:.3f}" for share in cases[-1]["mass_choice_coefficient"])
        ends = "; the identified one is an end of the candidates" if cases[-1].get("candidate_end", [0])[0] else ""
        tell(f"case {number + 1} of {len(expansion.cases)}: demand for C_eff = {shares}{ends}")
    data: dict = stacked(cases, expansion.shape) | _labels(study)
    data["depth"] = data["depth"], {**attributes("depth"), "long_name": "depth below the top of the contents"}
    sources = [*SOURCES, *(case.scene.source for case in expansion.cases if case.scene.source)]
    notes = {"assumed": ", ".join(study.assumed), "published": study.published or "", **expansion.promise}
    if study.identification:
        notes["band_Hz"] = list(study.identification.band_Hz)
    return assemble(study, "seismic", data, sources=sources, notes=notes, sweep=sweep_of(expansion))


def _labels(study) -> dict[str, list]:
    """Coordinates of the cube's own axes."""
    choices = ("identified",) if study.identification else ()
    values = {"relative_depth": expand(study.relative_depth), "mass_choice": [*choices, *STATED]}
    if study.sine:
        values |= {"frequency": expand(study.sine.frequency_Hz), "curve": list(CURVES), "bound": list(BOUNDS)}
    if study.identification:
        values |= labels(study.identification)
    return values


def _case(study, scene: Shaken, random: np.random.Generator) -> dict[str, np.ndarray]:
    """Everything of one case, by the names of the contract: what the study asks for and no more."""
    unreduced = identify.emptied(scene.tube)
    alpha = stiffness_reduction(scene.empty_frequency or unreduced, unreduced)
    choices = dict(STATED)
    arrays = _given(scene, alpha, unreduced)
    if study.sine is not None:
        arrays |= _resonance(study.sine, scene, unreduced)
    if study.identification is not None:
        arrays |= identified(study.identification, scene, alpha, random)
        choices = {"identified": float(arrays["effective_mass_coefficient"][0]), **choices}
    return arrays | _demand(study, scene, alpha, list(choices.values()))


def _given(scene: Shaken, alpha: float, unreduced: float) -> dict:
    tube, base = scene.tube, scene.base
    ratio = volume_ratio(radius=tube.radius, thickness=tube.thickness)
    densities = {"wall_density": tube.wall_density, "contents_density": tube.contents_density}
    return {
        "tube_radius": tube.radius,
        "tube_thickness": tube.thickness,
        "tube_height": tube.height,
        "fill_height": tube.fill_height,
        "contents_density": tube.contents_density,
        "mass_ratio": mass_ratio(volume_ratio=ratio, **densities),
        "unreduced_frequency": unreduced,
        "empty_frequency": scene.empty_frequency or unreduced,
        "stiffness_reduction": alpha,
        "damping_ratio": scene.damping_ratio,
        "base_motion": base.origin,
        "elapsed_time": base.dt * np.arange(len(base.acceleration)),
        "base_acceleration": base.acceleration,
        "code_contents_share": contents_share(tube.fill_height / (2 * tube.radius - tube.thickness)),
    }


def _resonance(sine, scene: Shaken, unreduced: float) -> dict:
    """Resonance curves of the empty tube, of the full one with the coefficient its frequency gives, and with all contents."""

    def shifted(empty: float, full: float) -> float:
        return identify.coefficient_of_frequency(scene.tube, stiffness_reduction(empty, unreduced), full)

    alpha, error = stiffness_reduction(sine.empty_frequency_Hz, unreduced), sine.rounding_Hz
    coefficients = [0.0, shifted(sine.empty_frequency_Hz, sine.full_frequency_Hz), 1.0]
    shapes = [modes(scene.tube, share, alpha) for share in coefficients]
    gains = [transfer(expand(sine.frequency_Hz), shape, sine.damping_ratio)[:, 0] for shape in shapes]
    bounds = [(sine.empty_frequency_Hz - s * error, sine.full_frequency_Hz + s * error) for s in (1, -1)]
    return {
        "sine_stiffness_reduction": alpha,
        "sine_damping_ratio": sine.damping_ratio,
        "sine_base_acceleration": sine.base_acceleration_gal / 100,
        "sine_coefficient": np.array(coefficients),
        "sine_frequency": np.array([shape.frequency[0] for shape in shapes]),
        "sine_coefficient_bound": np.array([shifted(*pair) for pair in bounds]),
        "resonance": np.abs(gains) * sine.base_acceleration_gal / 100,
    }


def _demand(study, scene: Shaken, alpha: float, shares: list[float]) -> dict:
    """Demand on the wall while these shares of the contents move with it."""
    tube = scene.tube
    depth = np.array(expand(study.relative_depth)) * tube.fill_height
    heights = np.append(tube.fill_height - depth, 0.0)  # the base last: the depths need not reach it
    demands = [demand(tube, alpha, share, scene.damping_ratio, scene.base, heights) for share in shares]
    return {
        "depth": depth,
        "mass_choice_coefficient": np.array(shares),
        "wall_shear_force": np.array([answer.shear_force[:-1] for answer in demands]),
        "wall_bending_moment": np.array([answer.bending_moment[:-1] for answer in demands]),
        "seismic_axial_wall_force": np.array([answer.axial_wall_force[:-1] for answer in demands]),
        "wall_acceleration": np.array([answer.acceleration[:-1] for answer in demands]),
        "seismic_wall_pressure": np.array([answer.wall_pressure[:-1] for answer in demands]),
        "base_shear": np.array([answer.shear_force[-1] for answer in demands]),
        "base_moment": np.array([answer.bending_moment[-1] for answer in demands]),
        "top_peak": np.array([answer.top_peak for answer in demands]),
        "top_peak_sampled": np.array([answer.top_peak_sampled for answer in demands]),
    }
