"""A stability study: arrangements of discs at rest, and the largest time step at which they stay so."""

from typing import ClassVar, Literal, Self

from pydantic import Field, model_validator

from silostudy.config.contact import ContactConfig
from silostudy.config.fields import Strict, described
from silostudy.config.run import IntegratorKey
from silostudy.config.study import BaseStudy
from silostudy.dem.integrate import PLAIN

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
    integrator: IntegratorKey = described("how velocities and places follow from forces", "", default=PLAIN.key)


class SiloTrial(Strict):
    """Kiyama and Fujimura's 17/18 silo, settled at several steps by every integrator and dashpot of the sweep."""

    steps_ms: tuple[float, ...] = described("time steps", "ms", min_length=1)
    reference_step_ms: float = described("short step that the others are held against", "ms", gt=0)
    fillings: int = described("fillings, which differ by the random offset of every disc", ge=2, le=1000, default=16)
    rest_s: float = described("time to come to rest", "s", gt=0, default=1.0)
    parts: int = described("parts of the fill's height whose wall force is summed", ge=1, le=100, default=10)

    @model_validator(mode="after")
    def _rising(self) -> Self:
        if list(self.steps_ms) != sorted(set(self.steps_ms)) or self.steps_ms[0] <= self.reference_step_ms:
            raise ValueError("steps_ms must rise, from above reference_step_ms")
        return self


class StabilityStudy(BaseStudy):
    """Largest stable step by bisection, against the engine's bound and LAMMPS."""

    unasked: ClassVar[str] = "it looks for the largest step itself"

    kind: Literal["stability"] = described("stability: largest stable step of discs at rest", "")
    scene: StabilityScene = described("the base scene", "")
    trial_steps: int = described("steps of each trial, before and after a kick", ge=100, le=1_000_000, default=20_000)
    resolution: float = described("ratio to which the bisection closes in, less one", gt=0, le=0.5, default=0.01)
    silo: SiloTrial | None = Field(default=None, description="how the wall forces of a silo at rest move with the step")
    peer: bool = Field(default=False, description="whether LAMMPS is tried on the same arrangements (dependency group peers)")
