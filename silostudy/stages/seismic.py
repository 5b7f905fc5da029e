"""Studies of silos in an earthquake."""

from silostudy.stages.family import Kind, Stage

KIND = Kind(
    key="seismic",
    title="earthquakes: demand on the wall, effective mass of the contents",
    model="silostudy.config.seismic:SeismicStudy",
    builder="silostudy.scene.seismic:seismic_builder",
    traits="silostudy.choice.seismic:seismic_traits",
    stages=(
        Stage(
            key="seismic",
            title="earthquakes: demand on the wall, effective mass of the contents",
            compute="silostudy.compute.seismic:seismic_cube",
            tells=True,
        ),
    ),
    about=("silostudy.commands.about:shaking",),
    table="silostudy.commands.compare_steel:seismic",
)
