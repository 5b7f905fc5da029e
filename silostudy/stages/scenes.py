"""Sweeps of discrete-element scenes, computed in parts."""

from silostudy.stages.family import Kind, Parts, Stage

KIND = Kind(
    key="scenes",
    title="a sweep of discrete-element scenes",
    model="silostudy.config.scenes:ScenesStudy",
    builder="silostudy.scene.scenes:scenes_builder",
    traits="silostudy.choice.dem:dem_traits",  # its scenes ask
    stages=(
        Stage(
            key="scenes",
            title="forces and discharge of each of many scenes",
            parts=Parts(
                measure="silostudy.compute.scenes:measure",
                coordinates="silostudy.compute.scenes:coordinates",
                sources="silostudy.compute.scenes:sources",
                cost="silostudy.scene.costs:cost",
            ),
        ),
        Stage(
            key="beside",
            title="what the walls of those scenes felt beside theories and codes",
            compute="silostudy.compute.beside:beside_cube",
            section="codes",
            reads=("scenes",),
            borrows={"codes": "pressure"},
        ),
    ),
    seconds="silostudy.commands.about:seconds_of_parts",
    about=("silostudy.commands.about:time_of_parts", "silostudy.commands.about_grains:cautions"),
)
