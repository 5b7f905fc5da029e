"""Studies of packings of discs: ensembles at rest and in discharge, and single runs in detail."""

from silostudy.stages.family import Kind, Stage

KIND = Kind(
    key="packing",
    title="rows of discs at rest and in discharge",
    model="silostudy.config.packing:PackingStudy",
    builder="silostudy.scene.packing:packing_builder",
    traits="silostudy.choice.packing:packing_traits",
    stages=(
        Stage(
            key="packing",
            title="ensembles of discs at rest and in discharge",
            compute="silostudy.compute.packing:packing_cube",
            tells=True,
            threads=2,
        ),
        Stage(
            key="motion",
            title="single runs of a packing study in detail",
            compute="silostudy.compute.motion:motion_cube",
            tells=True,
            section="detailed",
        ),
    ),
)
