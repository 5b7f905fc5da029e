"""Studies that hold scenes of grains against published numbers, computed in parts."""

from silostudy.stages.family import Kind, Parts, Stage

KIND = Kind(
    key="published",
    title="scenes of grains held against published numbers",
    model="silostudy.config.published:PublishedStudy",
    builder="silostudy.scene.published:published_builder",
    stages=(
        Stage(
            key="published",
            title="what published cases come to over fillings",
            parts=Parts(
                measure="silostudy.compute.published:measure",
                coordinates="silostudy.compute.published:coordinates",
                sources="silostudy.compute.published:sources",
                cost="silostudy.scene.costs:cost",
            ),
        ),
    ),
    seconds="silostudy.commands.about:seconds_of_parts",
    about=("silostudy.commands.about:time_of_parts", "silostudy.commands.about_grains:cautions"),
)
