"""Flow out of silos of grains by a law."""

from collections.abc import Mapping

import numpy as np

from silostudy.tables.constants import ROUNDED_GRAVITY

FLOWS = 5.0  # largest diameters in an outlet's width: below it arches are to be expected
OUTLET = "outlet"  # name of the one outlet of a silo


def beverloo(width, grain, density, constant: float, edge: float):
    """Mass flow (kg/s) through a round outlet: C rho_b sqrt(g) (D - k d)^(5/2). Source: mankoc_2007 (Beverloo's law)."""
    return constant * density * np.sqrt(ROUNDED_GRAVITY) * np.maximum(width - edge * grain, 0.0) ** 2.5


def narrow(widths: Mapping[str, float], largest: float, body: str) -> list[str]:
    """A warning for each outlet, by its name and width (m), that bodies up to a diameter (m) do not pass, or arch over."""
    lines = []
    for name, wide in ((name, width / largest) for name, width in widths.items() if width < FLOWS * largest):
        arch = f"below {FLOWS:g} or so {body}s may arch over it and stay"
        told = arch if wide >= 1.0 else f"the largest {body}s do not pass it"
        lines.append(f"the {called(name)} is {wide:.2g} of the largest diameters wide: {told}")
    return lines


def called(name: str) -> str:
    """Words for an outlet of a name."""
    return name if name == OUTLET else f"outlet {name}"
