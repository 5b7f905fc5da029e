"""Twisting resistance of one moment against any twisting, however slow: the law of rolling, about the normal."""

from silostudy.contact.coefficient import Coefficient
from silostudy.contact.family import TwistingLaw
from silostudy.contact.rolling import constant_torque

FRICTION = Coefficient(
    name="twisting_friction", unit="1", fields=(("twisting_friction",),), text="twisting friction coefficient", default=0.0
)
ROW = TwistingLaw(
    key="constant-torque",
    rank=3,
    title="One moment against any twisting",
    source=constant_torque.ROW.source,
    locator="model A, about the normal",
    law=constant_torque.law,
    restless=True,
    coefficients=(FRICTION,),
    dissipates=constant_torque.ROW.dissipates,
)
