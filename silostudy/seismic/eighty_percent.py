"""The share that codes accept where nothing better is known."""

from silostudy.seismic.family import MassRule


def eighty_percent(slenderness):
    """Effective mass coefficient (1) that codes accept where nothing better is known, for any height over diameter.

    Source: sasaki_yoshimura_effective_mass, section 1, on ACI 313 and the AIJ recommendation.
    """
    return 0.8 + 0 * slenderness


ROW = MassRule(
    key="eighty_percent",
    rank=40,
    title="Eighty per cent of the contents",
    source="sasaki_yoshimura_effective_mass",
    locator="section 1",
    function=eighty_percent,
    formula="C_eff = 0.80",
    needs=(),
    validity="the least that ACI 313 and the AIJ recommendation accept unless better is known",
)
