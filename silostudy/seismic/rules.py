"""The family of ways to an effective mass coefficient: identified from responses, or set by a code."""

from collections.abc import Callable
from dataclasses import dataclass

from silostudy.catalogue import Family, Row
from silostudy.seismic.added_mass import coefficient_from_shift
from silostudy.seismic.en1998_4 import contents_share
from silostudy.seismic.grains import wall_carried_ring
from silostudy.seismic.likeness import amplitude_error, phase_error


@dataclass(frozen=True, kw_only=True)
class MassRule(Row):
    """One way to the share of the contents' mass that an earthquake moves with the wall."""

    function: Callable
    formula: str
    needs: tuple[str, ...]
    validity: str


def eighty_percent(slenderness):
    """Effective mass coefficient (1) that codes accept where nothing better is known, for any height over diameter.

    Source: sasaki_yoshimura_effective_mass, section 1, on ACI 313 and the AIJ recommendation.
    """
    return 0.8 + 0 * slenderness


SOURCE = "sasaki_yoshimura_effective_mass"
MASS_RULES: Family[MassRule] = Family(
    "effective mass rule",
    [
        MassRule(
            key="resonance_shift",
            title="Shift of the first frequency by filling",
            source=SOURCE,
            locator="section 3, equations (1) and (2)",
            function=coefficient_from_shift,
            formula="C_eff = ((f_empty / f_full)^2 - 1) / (rho_s r / rho_w), r = (1 - p)^2 / (4 p), p = h / 2R",
            needs=("empty frequency (Hz)", "full frequency (Hz)", "contents' mass over wall mass (1)"),
            validity="equal stiffness empty and full; filled over the whole height (else the beam is solved for it)",
        ),
        MassRule(
            key="amplitude_error",
            title="Least error of Fourier amplitudes, E_A",
            source=SOURCE,
            locator="equations (3) and (5)",
            function=amplitude_error,
            formula="E_A = sum |X' - X| / (n sum X): measured X, computed X', n bins of the band",
            needs=("measured top acceleration (m s-2)", "base acceleration (m s-2)", "damping ratio (1)", "band (Hz)"),
            validity="while contents and wall move as one; the deciding index here",
        ),
        MassRule(
            key="phase_error",
            title="Least error of wrapped Fourier phases, E_P",
            source=SOURCE,
            locator="equations (4) and (5), without their division by the phase",
            function=phase_error,
            formula="E_P = sum |wrap(Phi' - Phi)| X / (pi n sum X)",
            needs=("measured top acceleration (m s-2)", "base acceleration (m s-2)", "damping ratio (1)", "band (Hz)"),
            validity="a second opinion: a disagreement with E_A is reported, not resolved",
        ),
        MassRule(
            key="eighty_percent",
            title="Eighty per cent of the contents",
            source=SOURCE,
            locator="section 1",
            function=eighty_percent,
            formula="C_eff = 0.80",
            needs=(),
            validity="the least that ACI 313 and the AIJ recommendation accept unless better is known",
        ),
        MassRule(
            key="en1998_4",
            title="EN 1998-4, additional pressure on a circular wall",
            source="en1998_4_2006",
            locator="additional dynamic pressure, circular silo with a flat bottom",
            function=contents_share,
            formula="dp = (a/g) gamma min(min(h_b, d_c/2), 3x) cos(theta); summed: 5h/(6R) for h <= R, 1 - R/(6h) above",
            needs=("height over diameter (1)",),
            validity="circular, flat bottom, rigid; one acceleration over the height for the summed share",
        ),
        MassRule(
            key="wall_carried_ring",
            title="The ring that wall friction carries",
            source="silvestri_ring",
            locator="simplest form",
            function=wall_carried_ring,
            formula="C_eff = min(1, mu N / W): static wall pressure summed N, weight W; mu K H / R where p_h = K gamma z",
            needs=("static wall force (N)", "contents' weight (N)", "wall friction coefficient (1)"),
            validity="a core that carries itself; shown beside shaken discs in the studies of kind grains",
        ),
    ],
)
