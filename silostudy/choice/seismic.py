"""Numbers of a seismic study's scenes on which the errors of its settings hang."""

from collections.abc import Sequence

from silostudy.config.seismic import SeismicStudy
from silostudy.scene.seismic import Shaken
from silostudy.seismic.added_mass import mass_ratio, volume_ratio
from silostudy.seismic.beam import Tube

POWER = 3.5  # of the step, that errors go with where amplitudes are interpolated between candidates: measured


def seismic_traits(study: SeismicStudy, scenes: Sequence[Shaken]) -> list[dict[str, float]]:
    """Number that the error of the identified coefficient goes with, of each scene; 0 where none is sought."""
    sought = study.identification
    if sought is None:
        return [{"valley_number": 0.0} for _ in scenes]
    coarse = sought.coefficients
    step, middle = (coarse.stop - coarse.start) / (coarse.count - 1), 0.5 * (coarse.start + coarse.stop)
    truths = [scene.imitation.effective_mass_coefficient if scene.imitation else middle for scene in scenes]
    numbers = (valley_number(scene.tube, scene.damping_ratio, step, truth) for scene, truth in zip(scenes, truths, strict=True))
    return [{"valley_number": number} for number in numbers]


def valley_number(tube: Tube, damping_ratio: float, step: float, coefficient: float) -> float:
    """Candidates' step over the valley's width to the power of POWER, times that width over the coefficient (1).

    The valley of the likeness index is as wide as the coefficient must change to move the first frequency by its half-power
    width: 2 zeta (1 + m C) / m with the mass ratio m of contents and wall.
    """
    volumes = volume_ratio(radius=tube.radius, thickness=tube.thickness)
    ratio = mass_ratio(volume_ratio=volumes, wall_density=tube.wall_density, contents_density=tube.contents_density)
    width = 2.0 * damping_ratio * (1.0 + ratio * coefficient) / ratio
    return (step / width) ** POWER * width / max(coefficient, step)
