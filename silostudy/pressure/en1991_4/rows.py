"""EN 1991-4:2006 as methods: the design pressures, and one state of equilibrium for each set of characteristic values."""

from typing import Any

from silostudy.pressure import janssen
from silostudy.pressure.en1991_4 import factors, in_hopper, limits, on_wall, patches
from silostudy.pressure.en1991_4.characteristic import VARIED, described, used
from silostudy.pressure.family import CELLS, ON_HOPPER, SLOT, USUAL_PHASES, PressureMethod

COMMON: dict[str, Any] = {
    "source": "en1991_4_2006",
    "rank": 160,
    "locator": "as public programs carry it (printed standard not seen)",
    "static": janssen.normal_pressure,
    "plans": CELLS - {"polygonal"} | SLOT,
    "table_key": "en1991_4",
    "varies": VARIED,
}
FORMULA = (
    "p_hf = gamma R/mu (1 - exp(-z/z_o)), z_o = R/(K mu), for h_c/d_c >= 2, below it a power law from the highest wall contact "
    "h_o down; discharge times C_h, C_w; hopper p_v = gamma h/(n - 1) [x/h - (x/h)^n] + p_vft (x/h)^n, p_n = F p_v, "
    "n = S (F mu cot beta + F - 1), S = 2 for a cone or a square pyramid, 1 for a wedge; the sum over both pairs of a rectangle"
)
SEEN = "printed standard not seen; no published numbers: checked in 50-digit arithmetic and by equilibrium"
OF_HOPPER = {phase: {ON_HOPPER: used(f"hopper_{phase}", "hopper_wall_friction")} for phase in USUAL_PHASES}
OF_WALL = on_wall.used_by(on_wall.DESIGN_SETS)

DESIGN = PressureMethod(
    key="en1991_4",
    title="EN 1991-4:2006, design",
    phases=on_wall.phases(on_wall.DESIGN_SETS),
    hopper={phase: in_hopper.pressures(phase) for phase in USUAL_PHASES},
    totals={phase: in_hopper.totals(phase) | patches.totals(phase) | on_wall.numbers(phase) for phase in USUAL_PHASES},
    limits=(*limits.ALL, limits.HOPPER, limits.BOTTOM, limits.LOW_PATCH),
    plans_of=patches.PLANS | in_hopper.PLANS,
    values={
        **{quantity: described(name) for quantity, name in on_wall.DESIGN_SETS.items()},
        "hopper in filling": described("hopper_filling"),
        "hopper in discharge": f"{described('hopper_discharge')}, steep or shallow by the lower K and mu as in filling",
        "load on the hopper": described("vertical_load"),
        "every quantity": "unit weight upper; mu at most tan phi of its set unless characteristic_friction is uncapped",
    },
    used={phase: OF_WALL[phase] | OF_HOPPER[phase] for phase in USUAL_PHASES},
    formula=FORMULA,
    validity="discharge in shallow hoppers as filling (two public programs of three); each quantity with the characteristic "
    "values that are unfavourable for it, so that together they are no single state of equilibrium (the sets' own rows are); "
    f"programs disagree on cutting mu to tan phi (one of four does); {SEEN}",
    colour="#2166AC",
    marker="$E$",
    **COMMON,
)


def state(name: str, title: str, colour: str, marker: str) -> PressureMethod:
    """The row of one set: every quantity with the same characteristic values, so that equilibrium holds."""
    sets = dict.fromkeys(on_wall.DESIGN_SETS, name)
    return PressureMethod(
        key=f"en1991_4_{name}",
        title=f"EN 1991-4:2006, {title}",
        phases=on_wall.phases(sets),
        totals={phase: on_wall.numbers(phase) for phase in USUAL_PHASES},
        limits=limits.ALL,
        values={"every quantity": f"{described(name)}, unit weight upper"},
        used=on_wall.used_by(sets),
        formula=FORMULA,
        validity=f"one set of characteristic values throughout; {SEEN}",
        colour=colour,
        marker=marker,
        equilibrium=("filling",),
        drawn="set",
        **COMMON,
    )


SIMPLE_SETS = dict.fromkeys(on_wall.DESIGN_SETS, "mean")
SIMPLE = PressureMethod(
    key="en1991_4_class_1",
    title="EN 1991-4:2006, action assessment class 1 (one source)",
    phases=on_wall.phases(SIMPLE_SETS, factors.SIMPLIFIED),
    hopper={phase: in_hopper.pressures(phase, factors.simplified_bottom_magnifier) for phase in USUAL_PHASES},
    totals={
        phase: in_hopper.totals(phase, factors.simplified_bottom_magnifier) | on_wall.numbers(phase, factors.SIMPLIFIED)
        for phase in USUAL_PHASES
    },
    limits=(*limits.ALL, limits.HOPPER, limits.BOTTOM, *limits.CLASS_1),
    plans_of=in_hopper.PLANS,
    values={**DESIGN.values, **{quantity: described("mean") for quantity in on_wall.DESIGN_SETS}},
    used={phase: on_wall.used_by(SIMPLE_SETS)[phase] | OF_HOPPER[phase] for phase in USUAL_PHASES},
    not_computed=("from memory only: C_h and C_w between squat and slender, C_b where the solid acts dynamically",),
    formula="as the design row, with mean mu and K on the cylinder's wall, no patch, C_h = 1.15 + 1.5 (1 + 0.4 e/d_c) C_op, "
    "C_w = 1.4 (1 + 0.4 e/d_c), C_b = 1.3",
    validity=f"simplified rules that a small silo may take in place of the design row's; one public program has them; {SEEN}",
    colour="#4393C3",
    marker="$1$",
    on_request=True,
    **COMMON,
)
ROWS = (
    DESIGN,
    SIMPLE,
    state("mean", "mean values", "#67A9CF", "1"),
    state("wall_normal", "set for the wall pressure", "#1A3F6B", "2"),
    state("wall_friction", "set for the wall friction", "#5E3C99", "3"),
    state("vertical_load", "set for the vertical load", "#B2ABD2", "4"),
)
