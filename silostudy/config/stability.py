"""A stability study: networks of discs at rest, and the largest time step at which they stay so."""

from typing import Literal

from pydantic import Field

from silostudy.config.dem import ContactConfig, IntegratorKey
from silostudy.config.fields import Strict, described
from silostudy.config.study import BaseStudy

NetworkKey = Literal["disc", "column", "rows", "hexagonal"]


class StabilityScene(Strict):
    """Equal discs resting on a floor, a few contacts each."""

    network: NetworkKey = described(
        "disc: one disc; column: discs on top of each other, moved up and down only (it would topple); "
        "rows: rows of s and s - 1 discs between walls; hexagonal: the same with neighbours in touch",
        "",
    )
    radius_m: float = described("radius of the discs", "m", gt=0)
    density_kg_m3: float = described("density of the discs", "kg m-3", gt=0)
    discs: ContactConfig = described("contact between discs, and with the walls", "")
    integrator: IntegratorKey = described("how velocities and places follow from forces", "", default="17-18")


class StabilityStudy(BaseStudy):
    """Largest stable step by bisection, against the engine's bound and LAMMPS."""

    kind: Literal["stability"] = described("stability: largest stable step of discs at rest", "")
    scene: StabilityScene = described("the base scene", "")
    trial_steps: int = described("steps of each trial, before and after a kick", ge=100, le=1_000_000, default=20_000)
    resolution: float = described("ratio to which the bisection closes in, less one", gt=0, le=0.5, default=0.01)
    peer: bool = Field(default=False, description="whether LAMMPS is tried on the same networks (dependency group peers)")
