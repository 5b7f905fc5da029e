"""Studies of what accuracy costs in time."""

from silostudy.stages.family import Kind, Stage

KIND = Kind(
    key="accuracy",
    title="error against CPU time, measured on this machine",
    model="silostudy.config.accuracy:AccuracyStudy",
    builder="silostudy.scene.accuracy:accuracy_builder",
    stages=(
        Stage(
            key="accuracy",
            title="error against CPU time of an accuracy study's problems",
            compute="silostudy.accuracy.cube:accuracy_cube",
            tells=True,
            alone=True,  # as far as the pipeline goes: what it measures is time
            rooms=("accuracy/problems",),
        ),
    ),
)
