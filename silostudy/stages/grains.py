"""Studies of discs or spheres in a box that is shaken."""

from silostudy.stages.family import Kind, Stage

KIND = Kind(
    key="grains",
    title="effective mass of discs or spheres in a shaken box",
    model="silostudy.config.grains:GrainsStudy",
    builder="silostudy.scene.grains:grains_builder",
    stages=(
        Stage(
            key="grains",
            title="contents of a shaken box of grains",
            compute="silostudy.compute.grains:grains_cube",
            tells=True,
        ),
    ),
    seconds="silostudy.commands.about_grains:seconds",
    about=("silostudy.commands.about_grains:runs", "silostudy.commands.about_grains:cautions"),
    timed=("silostudy.commands.about_grains:prices_of_effects",),
)
