"""For each kind of study, how a validated scene configuration becomes a frozen scene.

A builder takes (study, folder of the study file, name for errors) once and returns build(config, settings) -> scene.
"""

from collections.abc import Callable

from silostudy.scene.build import pressure_builder
from silostudy.scene.grains import grains_builder
from silostudy.scene.seismic import seismic_builder
from silostudy.scene.shell import buckling_builder, shell_builder

BUILDERS: dict[str, Callable[..., Callable]] = {
    "pressure": pressure_builder,
    "buckling": buckling_builder,
    "shell": shell_builder,
    "seismic": seismic_builder,
    "grains": grains_builder,
}
