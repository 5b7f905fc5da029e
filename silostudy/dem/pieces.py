"""What a scene calls for: the keys of its laws and the switches of its effects; a kernel is built from exactly these."""

from dataclasses import dataclass

from silostudy.contact import COHESION, NORMAL, ROLLING, TANGENTIAL


@dataclass(frozen=True)
class Laws:
    """Keys of the four contact laws between two bodies."""

    normal: str = "spring-dashpot"
    tangential: str = "none"
    rolling: str = "none"
    cohesion: str = "none"

    @property
    def functions(self):
        return (
            NORMAL[self.normal].law,
            TANGENTIAL[self.tangential].law,
            ROLLING[self.rolling].law,
            COHESION[self.cohesion].law,
        )

    @property
    def drags(self) -> bool:
        return self.tangential != "none"

    @property
    def slides(self) -> bool:
        return TANGENTIAL[self.tangential].stores

    @property
    def rolls(self) -> bool:
        return ROLLING[self.rolling].stores

    @property
    def turns(self) -> bool:
        return self.drags or self.rolling != "none"


@dataclass(frozen=True)
class Pieces:
    """What a scene calls for; everything else is not compiled in."""

    pair_laws: Laws = Laws()
    wall_laws: Laws = Laws()
    integrator: str = "17-18"
    unequal: bool = False  # discs of several sizes
    shaken: bool = False  # the box is accelerated
    watched: bool = False  # wall forces are recorded every step
    booked: bool = False  # the energy ledger is kept

    @property
    def turns(self) -> bool:
        return self.pair_laws.turns or self.wall_laws.turns
