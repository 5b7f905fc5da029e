"""Single discrete-element scenes: files of config/scenes, run by `silostudy dem`."""

from silostudy.stages.family import Kind, Stage

KIND = Kind(
    key="dem",
    title="one discrete-element scene",
    model="silostudy.config.dem:DemScene",
    variants=("silostudy.config.spheres:SphereScene",),
    traits="silostudy.choice.dem:dem_traits",
    stages=(
        Stage(
            key="dem",
            title="wall forces, force chains and discharge of one scene",
            rooms=("compute/dem", "compute/dem_cube", "compute/paraview"),
        ),
    ),
)
