"""Several kinds of spheres in one scene as a user writes them: materials, sizes and shares, and contacts of pairs."""

from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING, Annotated, Any

import numpy as np
from pydantic import AfterValidator, Field

from silostudy.config.elastic import GrainConfig, MaterialConfig, TouchConfig
from silostudy.config.fields import KeyMistake, described, one_of
from silostudy.config.surfaces import apart_from
from silostudy.errors import BadInput
from silostudy.packing.sizes import SIZES

GRAIN = "grain"  # name of the kind that the sections grain and sizes are of
WALLS = "walls"  # name of all surfaces that a scene does not tell from the others
TRIED = 1000  # spheres drawn to see whether sizes give any


def _drawable(sizes: Any) -> Any:
    """The section of sizes; an error with the key that leaves nothing to draw."""
    try:
        SIZES[sizes.kind].radii(np.random.default_rng(0), TRIED, sizes)
    except BadInput as error:
        raise KeyMistake(error.field.removeprefix("sizes."), error.allowed) from None
    return sizes


if TYPE_CHECKING:
    SizesConfig = Any
    SphereSurfaceConfig = Any
    PairApart = Any
else:
    SizesConfig = Annotated[one_of(SIZES), AfterValidator(_drawable)]
    told = "Material and contact of a surface that is not like the other walls."
    SphereSurfaceConfig = apart_from("SphereSurfaceConfig", told, MaterialConfig, TouchConfig)
    PairApart = apart_from("PairApart", "What two bodies do to each other that are not like the others.", TouchConfig)
Share = Annotated[float, Field(gt=0, lt=1)]


class OtherGrainConfig(GrainConfig):
    """A kind of spheres beside `grain`: its material, sizes, and share."""

    sizes: SizesConfig = described("sizes of its spheres; a file gives its own", "", default=None)
    mass_share: Share | None = described("share of the mass of all spheres; the rest is `grain`", default=None)
    number_share: Share | None = described("share of the number of all spheres, in place of mass_share", default=None)


class PairConfig(PairApart):
    """Contact of two kinds of spheres, or of a kind and a surface, where it differs from `spheres` or `walls`."""

    between: tuple[str, str] = described("two names: of a kind (grain or another), and of a kind or a surface (or walls)", "")

    @property
    def given(self) -> dict[str, Any]:
        """Values by field, of those that are given."""
        return {name: value for name, value in super().given.items() if name != "between"}


def check_kinds(others: Mapping[str, OtherGrainConfig], pairs: Sequence[PairConfig], from_file: bool) -> None:
    """KeyMistake for kinds without a name, sizes or a share of their own, and for pairs of none."""
    check_pairs(others, pairs)
    for name, kind in others.items():
        told = (kind.sizes, kind.mass_share, kind.number_share)
        if from_file and told != (None, None, None):
            raise KeyMistake(f"other_grains.{name}", "sizes and shares must be left out: the file gives them")
        if not from_file and kind.sizes is None:
            raise KeyMistake(f"other_grains.{name}.sizes", "is missing")
        if not from_file and (kind.mass_share is None) == (kind.number_share is None):
            raise KeyMistake(f"other_grains.{name}", "give either mass_share or number_share")
    check_shares(others)


def check_pairs(others: Mapping[str, Any], pairs: Sequence[Any]) -> None:
    """KeyMistake for kinds without a name of their own, and for pairs of none, or that stand twice."""
    for name in others:
        if name in (GRAIN, WALLS):
            raise KeyMistake(f"other_grains.{name}", "the name is taken")
    kinds, met = (GRAIN, *others), [tuple(sorted(pair.between)) for pair in pairs]
    for number, (pair, names) in enumerate(zip(pairs, met, strict=True)):
        if not set(pair.between) & set(kinds):
            raise KeyMistake(f"pairs.{number}.between", f"names no kind of grains; known: {', '.join(kinds)}")
        if names in met[:number]:
            raise KeyMistake(f"pairs.{number}.between", "the pair stands twice")


def check_shares(others: Mapping[str, Any]) -> None:
    """KeyMistake for shares of mass beside shares of number, or that leave nothing for `grain`."""
    for share in ("mass_share", "number_share"):
        given = [value for kind in others.values() if (value := getattr(kind, share)) is not None]
        if given and len(given) < len(others):
            raise KeyMistake("other_grains", f"give the {share} of every kind, or of none")
        if not sum(given) < 1.0:
            raise KeyMistake("other_grains", f"{share} adds up to {sum(given):g}; it must leave a rest to {GRAIN}")
