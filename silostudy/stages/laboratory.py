"""Studies of a bulk solid's properties: tests on its grains in virtual cells, computed in parts."""

from silostudy.stages.family import Kind, Parts, Stage

KIND = Kind(
    key="laboratory",
    title="a bulk solid's properties by tests on its grains",
    model="silostudy.config.laboratory:LaboratoryStudy",
    builder="silostudy.scene.laboratory:laboratory_builder",
    stages=(
        Stage(
            key="laboratory",
            title="unit weight, lateral pressure ratio, internal and wall friction of grains in cells",
            parts=Parts(
                measure="silostudy.compute.laboratory:measure",
                coordinates="silostudy.compute.laboratory:coordinates",
                sources="silostudy.compute.laboratory:sources",
                cost="silostudy.scene.laboratory:cost",
            ),
        ),
    ),
    seconds="silostudy.commands.about:seconds_of_parts",
    about=(
        "silostudy.commands.about:time_of_parts",
        "silostudy.commands.about:tests",
        "silostudy.commands.about_grains:cautions",
    ),
)
