"""Studies of steel silos: the pressures first, then the shell under them."""

from silostudy.stages.family import Kind, Stage
from silostudy.stages.pressure import KIND as PRESSURE

KIND = Kind(
    key="shell",
    title="wall pressures, and the steel wall that carries them",
    model="silostudy.config.shell:ShellStudy",
    builder="silostudy.scene.shell:shell_builder",
    traits="silostudy.choice.pressure:shell_traits",
    stages=(
        *PRESSURE.stages,
        Stage(
            key="shell",
            title="the steel wall of a silo under its pressures",
            compute="silostudy.compute.shell:shell_cube",
            reads=("pressure",),
            borrows={"earthquake": "seismic"},
        ),
        Stage(
            key="checks",
            title="every check of the steel under combinations of actions",
            compute="silostudy.compute.checks:checks_cube",
            section="checks",
            reads=("pressure",),
            borrows={"earthquake": "seismic"},
        ),
    ),
    about=(
        *PRESSURE.about,
        "silostudy.commands.about:earthquake",
        "silostudy.commands.about:rules",
        "silostudy.commands.about:rings",
        "silostudy.commands.about:checks",
    ),
    table="silostudy.commands.compare_steel:shell",
)
