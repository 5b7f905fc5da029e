"""Pieces of a kernel: the rows of the laws and the switches of the effects that a scene calls for, and nothing else."""

from dataclasses import dataclass

from silostudy.contact import (
    COHESION,
    DEFAULTS,
    FAMILIES,
    NO_COHESION,
    NO_ROLLING,
    NO_TANGENTIAL,
    NO_TWISTING,
    NORMAL,
    ROLLING,
    TANGENTIAL,
    TWISTING,
)
from silostudy.contact.family import CohesionLaw, NormalLaw, RollingLaw, TangentialLaw, TwistingLaw
from silostudy.dem.dimension import Dimension


@dataclass(frozen=True, repr=False)
class Laws:
    """The contact laws between two bodies; an effect whose law is not given is left out."""

    normal: NormalLaw = NORMAL[DEFAULTS["normal"]]
    tangential: TangentialLaw = TANGENTIAL[NO_TANGENTIAL]
    rolling: RollingLaw = ROLLING[NO_ROLLING]
    cohesion: CohesionLaw = COHESION[NO_COHESION]
    twisting: TwistingLaw = TWISTING[NO_TWISTING]

    @classmethod
    def of(cls, **keys: str) -> "Laws":
        """The package's laws by their keys."""
        return cls(**{family: FAMILIES[family][key] for family, key in keys.items()})

    def __repr__(self) -> str:
        """Name of the laws in the file names of kept kernels: the same in every process."""
        return f"Laws({', '.join(row.fingerprint for row in self.rows)})"

    @property
    def rows(self) -> tuple[NormalLaw, TangentialLaw, RollingLaw, CohesionLaw, TwistingLaw]:
        return self.normal, self.tangential, self.rolling, self.cohesion, self.twisting

    @property
    def keys(self) -> tuple[str, ...]:
        return tuple(row.key for row in self.rows)

    @property
    def drags(self) -> bool:
        return self.tangential.acts

    @property
    def brakes(self) -> bool:
        return self.rolling.acts or self.twists

    @property
    def slides(self) -> bool:
        return self.tangential.stores

    @property
    def rolls(self) -> bool:
        return self.rolling.stores

    @property
    def twists(self) -> bool:
        return self.twisting.acts

    @property
    def winds(self) -> bool:
        return self.twisting.stores

    @property
    def clings(self) -> bool:
        return self.cohesion.holds_on

    @property
    def turns(self) -> bool:
        return self.drags or self.brakes

    @property
    def stores(self) -> bool:
        return self.slides or self.rolls or self.winds or self.clings


@dataclass(frozen=True)
class Pieces:
    """Laws and effects that a scene calls for; everything else is not compiled in."""

    space: Dimension
    pair_laws: Laws
    wall_laws: Laws
    integrator: str
    unequal: bool = False  # discs of several sizes
    shaken: bool = False  # the box is accelerated
    watched: bool = False  # wall forces are recorded every step
    booked: bool = False  # the energy balance is kept
    varied: tuple[bool, bool] = (False, False)  # coefficients differ among pairs, among contacts with walls
    moving: bool = False  # walls move; what they feel is recorded then

    @property
    def turns(self) -> bool:
        return self.pair_laws.turns or self.wall_laws.turns
