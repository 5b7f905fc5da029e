"""The kinds of study: what the key `kind` of a study file may say."""

from silostudy.config.buckling import BucklingStudy
from silostudy.config.grains import GrainsStudy
from silostudy.config.pressure import PressureStudy
from silostudy.config.seismic import SeismicStudy
from silostudy.config.shell import ShellStudy
from silostudy.config.study import BaseStudy

KINDS: dict[str, type[BaseStudy]] = {
    "pressure": PressureStudy,
    "buckling": BucklingStudy,
    "shell": ShellStudy,
    "seismic": SeismicStudy,
    "grains": GrainsStudy,
}
