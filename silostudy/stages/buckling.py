"""Studies of shells: their strength by theories and design codes."""

from silostudy.stages.family import Kind, Stage

KIND = Kind(
    key="buckling",
    title="strength of shells by theories and design codes",
    model="silostudy.config.buckling:BucklingStudy",
    builder="silostudy.scene.shell:buckling_builder",
    stages=(
        Stage(
            key="buckling",
            title="strength of shells by buckling rules",
            compute="silostudy.compute.buckling:buckling_cube",
        ),
    ),
    about=("silostudy.commands.about:rules",),
    table="silostudy.commands.compare_steel:buckling",
)
