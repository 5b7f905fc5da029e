"""The option `--methods-from` of the commands that show rows: a Python file of the user's own, whose rows join for the call."""

from pathlib import Path
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from silostudy.catalogue import Family
    from silostudy.config.own_rows import Families


def add_methods_from(command) -> None:
    """Gives a command the option."""
    command.add_argument("--methods-from", type=Path, metavar="FILE", help="Python file with further methods of your own")


def families(chosen) -> "Families":
    """The families that a user's rows may join, by name, with those of the file that a call names."""
    from silostudy.buckling import BUCKLING, RIVALS
    from silostudy.config.own_rows import joined
    from silostudy.contact import FAMILIES
    from silostudy.pressure import PRESSURE

    shipped: tuple[Family, ...] = (PRESSURE, BUCKLING, RIVALS, *FAMILIES.values())
    return joined(shipped, chosen.methods_from) if chosen.methods_from else {family.name: family for family in shipped}
