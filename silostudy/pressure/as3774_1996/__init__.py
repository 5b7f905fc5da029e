"""AS 3774-1996, loads on bulk solids containers, second-hand: walls, hopper, floor, eccentric discharge, special loads.

The printed standard was not seen; the public draft pages of a wiki are the account, a second program agrees where that is
said.  What h_b counts is taken as the depth of the cylinder and r_c as the hydraulic radius (with it the initial state is in
vertical equilibrium); both are readings.
"""

from silostudy.pressure import janssen
from silostudy.pressure.as3774_1996 import cooling, eccentric, floor, hopper, rapid_filling, swelling, wall
from silostudy.pressure.family import CIRCULAR, SLOT, USUAL_PHASES, PressureMethod

ROW = PressureMethod(
    key="as3774_1996",
    rank=170,
    title="AS 3774-1996 (second-hand)",
    source="as3774_1996",
    locator="second-hand account (printed standard not seen)",
    phases={"filling": wall.INITIAL, "discharge": wall.FLOW},
    hopper={phase: hopper.pressures(phase) for phase in USUAL_PHASES},
    floor={"filling": floor.PRESSURES},
    totals={
        "filling": hopper.totals("filling") | {"bottom_pressure": floor.LOAD},
        "discharge": hopper.totals("discharge") | eccentric.TOTALS,
    },
    static=janssen.normal_pressure,
    plans=CIRCULAR | SLOT,
    plans_of=dict.fromkeys((*floor.PRESSURES, *eccentric.TOTALS), CIRCULAR),
    formula="p_ni = gamma r_c/mu (1 - exp(-z/z_o)), z_o = r_c/(mu k), k from phi and mu, squat: a ramp from h_o to 1.5 h_o; "
    "flow times max(7.6 (h_b/d_c)^0.06 - 6.4, 1.2) c_c, friction times 1.2 (planar 1.4); hopper p_n = k_h p_v, "
    "k_h = tan a/(tan a + mu_h), in flow EN 1991-4's F_e with the exponent j = c_h [k_hf (mu_h cot a + 1) - 1]; "
    "floor 1.25 p_vi [1 - 1.6 (x/d_c)^2]",
    used={phase: janssen.for_state({"lateral_pressure_ratio": wall.lateral_ratio}) for phase in USUAL_PHASES},
    validity="properties as handed over; second-hand: the printed standard was not seen; no published numbers: "
    "checked in 50-digit arithmetic and by equilibrium",
    colour="#FDB863",
    marker="8",
    equilibrium=("filling",),
)
ROWS = (swelling.ROW, cooling.ROW, rapid_filling.ROW)
