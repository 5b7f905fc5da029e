"""Several kinds of discs in one scene as a user writes them: radii, densities and shares, and contacts of pairs."""

from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING, Any

from silostudy.config.contact import ContactConfig
from silostudy.config.fields import KeyMistake, Strict, described
from silostudy.config.mixture import Share, check_pairs, check_shares
from silostudy.config.surfaces import apart_from

if TYPE_CHECKING:
    DiscPairApart = Any
else:
    DiscPairApart = apart_from("DiscPairApart", "What two bodies do to each other that are not like the others.", ContactConfig)


class OtherDiscConfig(Strict):
    """A kind of discs beside `grain`, that radius_m and density_kg_m3 are of: its radius, density, and share."""

    radius_m: float = described("radius", "m", gt=0)
    density_kg_m3: float = described("density", "kg m-3", gt=0)
    mass_share: Share | None = described("share of the mass of all discs; the rest is `grain`", default=None)
    number_share: Share | None = described("share of the number of all discs, in place of mass_share", default=None)


class DiscPairConfig(DiscPairApart):
    """Contact of two kinds of discs, or of a kind and a surface, where it differs from `discs` or `walls`."""

    between: tuple[str, str] = described("two names: of a kind (grain or another), and of a kind or a surface (or walls)", "")

    @property
    def given(self) -> dict[str, Any]:
        """Values by field, of those that are given."""
        return {name: value for name, value in super().given.items() if name != "between"}


def check_disc_kinds(others: Mapping[str, OtherDiscConfig], pairs: Sequence[DiscPairConfig], from_file: bool) -> None:
    """KeyMistake for kinds without a name or a share of their own, or that a file cannot tell, and for pairs of none."""
    check_pairs(others, pairs)
    if others and from_file:
        raise KeyMistake("other_grains", "a file of discs does not tell their kinds; take another packing")
    for name, kind in others.items():
        if (kind.mass_share is None) == (kind.number_share is None):
            raise KeyMistake(f"other_grains.{name}", "give either mass_share or number_share")
    check_shares(others)
