"""Studies of the longest stable time step of resting discs."""

from silostudy.stages.family import Kind, Stage

KIND = Kind(
    key="stability",
    title="largest stable step of discs at rest",
    model="silostudy.config.stability:StabilityStudy",
    builder="silostudy.scene.stability:stability_builder",
    stages=(
        Stage(
            key="stability",
            title="largest stable steps of resting discs",
            compute="silostudy.accuracy.stability:stability_cube",
            tells=True,
        ),
        Stage(
            key="profile",
            title="wall profiles of a stability study's silo over the time step",
            compute="silostudy.accuracy.profile:profile_cube",
            tells=True,
            section="silo",
        ),
    ),
)
