"""Twisting resistance: a rotational spring and dashpot about the normal behind a slider: the law of rolling."""

from silostudy.contact.coefficient import Coefficient
from silostudy.contact.family import TwistingLaw
from silostudy.contact.rolling import spring_dashpot_slider
from silostudy.contact.twisting import constant_torque

ROW = TwistingLaw(
    key="spring-dashpot-slider",
    rank=2,
    title="Rotational spring and dashpot behind a slider",
    source="lammps_granular",
    locator="twisting sds, with a cap on the spring alone",
    law=spring_dashpot_slider.law,
    stiffness=spring_dashpot_slider.ROW.stiffness,
    damping=spring_dashpot_slider.damping,
    coefficients=(
        Coefficient(
            name="twisting_stiffness",
            unit="N m",
            fields=(("twisting_stiffness_N_m",),),
            text="stiffness against twisting",
            default=0.0,
            stiffness_power=1.0,
        ),
        Coefficient(
            name="twisting_damping",
            unit="N m s",
            fields=(("twisting_damping_N_m_s",),),
            text="dashpot against twisting",
            default=0.0,
            damping_power=1.0,
        ),
        constant_torque.FRICTION,
    ),
    stores=True,
    dissipates=("dashpot", "sliding"),
)
