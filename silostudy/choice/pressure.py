"""Numbers of a pressure study's scenes on which the errors of its depth levels and samples hang: see choice/fronts.py."""

from collections.abc import Iterator, Sequence
from math import log

import numpy as np

from silostudy.pressure import PRESSURE
from silostudy.pressure.calls import call
from silostudy.scene.scene import Scene, parameters_of_scenes, solid_parameters

LEVELS = 257  # of the look at each curve
JUMP = 5.0  # how many times its neighbours a difference must be


def pressure_traits(study, scenes: Sequence[Scene]) -> list[dict[str, float]]:
    """Traits of each scene: the worst of the study's curves for an integral and for a largest value, its heap, its scatter."""
    integral = np.zeros(len(scenes))
    peak, kink = np.zeros(len(scenes)), np.zeros(len(scenes))
    for curves in curves_of(study, scenes):
        if "wall_friction_traction" in curves:
            integral = np.fmax(integral, integral_number(curves["wall_friction_traction"]))
        peak = np.fmax(peak, peak_number(curves["wall_normal_pressure"]))
        kink = np.fmax(kink, kink_number(curves["wall_normal_pressure"]))
    numbers = {"integral_number": integral, "peak_number": peak, "kink_number": kink}
    numbers |= {
        "heap": np.array([scene.silo.top_cone_height for scene in scenes]),
        "scatter": np.array(list(map(scatter, scenes))),
    }
    return [{name: float(values[k]) for name, values in numbers.items()} for k in range(len(scenes))]


def shell_traits(study, scenes: Sequence[Scene]) -> list[dict[str, float]]:
    """Traits of a pressure study, and the worst of the frictions that are summed to an axial force: own, or by the pressure."""
    smooth, jump = np.zeros(len(scenes)), np.zeros(len(scenes))
    for curves in curves_of(study, scenes):
        if "axial_wall_force" not in curves:
            rubbed = curves.get("wall_friction_traction", curves["wall_normal_pressure"])
            smooth, jump = np.fmax(smooth, smooth_number(rubbed)), np.fmax(jump, jump_number(rubbed))
    own = [{"smooth_number": a, "jump_number": b} for a, b in zip(smooth.tolist(), jump.tolist(), strict=True)]
    return [traits | more for traits, more in zip(pressure_traits(study, scenes), own, strict=True)]


def curves_of(study, scenes: Sequence[Scene]) -> Iterator[dict[str, np.ndarray]]:
    """Values by quantity at even levels, shape (scene, level), by method and phase; NaN where the method does not speak."""
    depth = np.array([[scene.silo.cylinder_depth] for scene in scenes])
    z = depth * np.linspace(0.0, 1.0, LEVELS)
    for key in study.method_keys:
        row = study.family(PRESSURE)[key]
        parameters = parameters_of_scenes(scenes, row)
        covered = np.isin(parameters["plan"], list(row.plans))
        for phase in study.phases:
            functions = row.bounded(phase)
            with np.errstate(all="ignore"):  # unknown parameters are NaN
                curves = {name: np.asarray(call(function, z, parameters)) for name, function in functions.items()}
            if curves:
                yield {name: np.where(covered, np.broadcast_to(value, z.shape), np.nan) for name, value in curves.items()}


def integral_number(curve: np.ndarray) -> np.ndarray:
    """Relative error (1) of one trapezoid over the whole depth, if the error went with the square of the step: (scene,).

    From trapezoidal sums of every level, of every second and of every fourth, the larger answer, for a kink may hide from
    one of them; 0 where the curve is masked.
    """
    sums = [every * np.trapezoid(curve[..., ::every], axis=-1) for every in (1, 2, 4)]
    with np.errstate(invalid="ignore", divide="ignore"):
        numbers = [abs(fine - coarse) / 3.0 * ((LEVELS - 1) / every) ** 2 / fine
                   for every, fine, coarse in zip((1, 2), sums, sums[1:], strict=False)]  # fmt: skip
        return np.nan_to_num(np.fmax(*numbers))


def smooth_number(curve: np.ndarray) -> np.ndarray:
    """The integral's number of a curve without jumps; 0 for one with."""
    return np.where(jump_number(curve) > 0, 0.0, integral_number(curve))


def jump_number(curve: np.ndarray) -> np.ndarray:
    """Relative error (1) that the jumps of a curve make, if one step were the whole depth: half of them over the mean.

    A jump is a difference of two levels that is much larger than those on both sides of it; 0 where the curve is masked.
    """
    steps = np.abs(np.diff(curve, axis=-1))
    beside = np.maximum(np.roll(steps, 1, axis=-1), np.roll(steps, -1, axis=-1))
    beside[..., 0], beside[..., -1] = steps[..., 1], steps[..., -2]
    with np.errstate(invalid="ignore", divide="ignore"):
        jumps = np.where(steps > JUMP * beside, steps, 0.0).sum(axis=-1)
        return np.nan_to_num(0.5 * jumps / np.mean(curve, axis=-1))


def peak_number(curve: np.ndarray) -> np.ndarray:
    """Loss (1, relative) of a rounded peak half a step away, if that step were the whole depth: (scene,).

    0 where the curve is largest at its end, which is a level, where it has a kink there, or where it is masked.
    """
    before, here, after = _around(curve, (-1, 0, 1))
    rounded = (2.0 * here - before - after) * (LEVELS - 1) ** 2 / (8.0 * here)
    return np.where(_peaks_inside(curve) & (kink_number(curve) == 0), rounded, 0.0)


def kink_number(curve: np.ndarray) -> np.ndarray:
    """Largest loss (1, relative) of a peak with a kink between two levels, if their distance were the whole depth: (scene,).

    There the slopes on both sides do not fall to nothing towards the peak; 0 elsewhere.
    """
    *left, here = _around(curve, (-3, -2, -1, 0))
    *right, _ = _around(curve, (3, 2, 1, 0))
    (far_left, near_left), (far_right, near_right) = np.diff(left, axis=0), np.diff(right, axis=0)
    rise, drop = near_left + 1.5 * (near_left - far_left), near_right + 1.5 * (near_right - far_right)
    kinked = _peaks_inside(curve) & (rise > 0.5 * near_left) & (drop > 0.5 * near_right) & (rise > 0) & (drop > 0)
    with np.errstate(invalid="ignore", divide="ignore"):
        return np.where(kinked, rise * drop / (rise + drop) * (LEVELS - 1) / here, 0.0)


def _place(curve: np.ndarray) -> np.ndarray:
    """Number of the last of the largest values."""
    return LEVELS - 1 - np.argmax(np.where(np.isfinite(curve), curve, -np.inf)[..., ::-1], axis=-1)


def _peaks_inside(curve: np.ndarray) -> np.ndarray:
    """Whether a curve without a gap is largest between its ends."""
    return (_place(curve) > 0) & (_place(curve) < LEVELS - 1) & np.isfinite(curve).all(axis=-1)


def _around(curve: np.ndarray, steps: tuple[int, ...]) -> list[np.ndarray]:
    """The values some steps from the largest."""
    places = np.clip(_place(curve), 3, LEVELS - 4)[..., None]
    return [np.take_along_axis(curve, places + step, axis=-1)[..., 0] for step in steps]


def scatter(scene: Scene) -> float:
    """Scatter (1) of the solid's properties; 0 where it is not known."""
    values = solid_parameters(scene, "")
    lightest = values["unit_weight_lower"] / values["unit_weight"]
    number = spread_number(values["a_phi"], values["a_K"], values["a_mu"], lightest)
    return number if np.isfinite(number) else 0.0


def spread_number(a_phi: float, a_K: float, a_mu: float, lightest: float) -> float:
    """Sum of the logarithms of the spreads (upper over mean) and of half the unit weight's (1), the largest counted a tenth.

    In a single dimension a Sobol sequence hardly errs.
    """
    terms = sorted((log(a_phi), log(a_K), log(a_mu), -0.5 * log(lightest)))
    return sum(terms) - 0.9 * terms[-1]
