"""Studies of wall pressures: by theories and design codes, and the solid's scatter sampled through them."""

from silostudy.stages.family import Kind, Stage

PRESSURES = Stage(
    key="pressure",
    title="wall pressures by theories and design codes",
    compute="silostudy.compute.pressure:pressure_cube",
)
SCATTER = Stage(
    key="uncertainty",
    title="the solid's scatter, sampled through the methods",
    compute="silostudy.compute.uncertainty:uncertainty_cube",
    section="uncertainty",
)
LOADS = Stage(
    key="loads",
    title="the load cases as fields over depth and angle, for finite elements",
    compute="silostudy.compute.loads:loads_cube",
    section="loads",
)
KIND = Kind(
    key="pressure",
    title="wall pressures of silos by theories and design codes",
    model="silostudy.config.pressure:PressureStudy",
    builder="silostudy.scene.build:pressure_builder",
    traits="silostudy.choice.pressure:pressure_traits",
    stages=(PRESSURES, SCATTER, LOADS),
    about=("silostudy.commands.about:pressures", "silostudy.commands.about:cautions"),
)
