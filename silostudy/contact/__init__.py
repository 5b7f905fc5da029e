"""The contact laws: four families of plain functions of floats; a scene picks one of each for discs and one for walls."""

from collections.abc import Callable
from dataclasses import dataclass

from silostudy.catalogue import Family, Row
from silostudy.contact import cohesion, line, linear, none, rolling, sliding


@dataclass(frozen=True, kw_only=True)
class Law(Row):
    """A contact law: its function, the coefficients it takes in order, and whether it carries a history."""

    law: Callable
    energy: Callable = linear.energy  # of a normal law: what its spring holds at an overlap
    coefficients: tuple[str, ...] = ()
    stores: bool = False


KIYAMA = "kiyama_fujimura_1983"
_SPRING = ("normal_stiffness", "normal_damping", "normal_damping_root")
_SLIDER = ("tangential_stiffness", "tangential_damping", "tangential_damping_root", "sliding_friction")

NORMAL: Family[Law] = Family(
    "normal law",
    [
        Law(
            key="spring-dashpot",
            title="Linear spring and dashpot, no tension",
            source=KIYAMA,
            locator="eqs. (6)-(9)",
            law=linear.cut,
            coefficients=_SPRING,
        ),
        Law(
            key="spring-dashpot-tension",
            title="Linear spring and dashpot, the dashpot may pull",
            source=KIYAMA,
            locator="eqs. (6)-(9) without the cut of the sum",
            law=linear.pulling,
            coefficients=_SPRING,
        ),
        Law(
            key="spring-dashpot-implicit",
            title="Linear spring and semi-implicit dashpot, no tension",
            source=KIYAMA,
            locator="eqs. (6)-(9), dashpot at the new speed",
            law=linear.implicit,
            coefficients=_SPRING,
        ),
        Law(
            key="line-contact",
            title="Elastic line contact on its own curve, dashpot, no tension",
            source=KIYAMA,
            locator="eqs. (22a), (22b)",
            law=line.law,
            energy=line.energy,
            coefficients=("line_compliance", "line_bracket", "normal_damping", "normal_damping_root"),
        ),
    ],
)

TANGENTIAL: Family[Law] = Family(
    "tangential law",
    [
        Law(key="none", title="Frictionless", source=KIYAMA, locator="mu = 0", law=none.sliding),
        Law(
            key="spring-slider",
            title="Spring and dashpot, the elastic part capped",
            source=KIYAMA,
            locator="eqs. (10)-(14)",
            law=sliding.elastic_cap,
            coefficients=_SLIDER,
            stores=True,
        ),
        Law(
            key="spring-slider-total",
            title="Spring and dashpot, their sum capped",
            source="cundall_strack_1979",
            locator="force-displacement law",
            law=sliding.total_cap,
            coefficients=_SLIDER,
            stores=True,
        ),
        Law(
            key="spring-slider-implicit",
            title="Spring and semi-implicit dashpot, the elastic part capped",
            source=KIYAMA,
            locator="eqs. (10)-(14), dashpot at the new speed",
            law=sliding.implicit_cap,
            coefficients=_SLIDER,
            stores=True,
        ),
        Law(
            key="viscous-coulomb",
            title="Dashpot capped by Coulomb friction",
            source="haff_werner_1986",
            locator="tangential force",
            law=sliding.viscous,
            coefficients=("tangential_damping", "tangential_damping_root", "sliding_friction"),
        ),
    ],
)

ROLLING: Family[Law] = Family(
    "rolling law",
    [
        Law(key="none", title="No rolling resistance", source=KIYAMA, locator="eq. (15c)", law=none.rolling),
        Law(
            key="spring-slider",
            title="Rotational spring behind a slider",
            source="iwashita_oda_1998",
            locator="rolling resistance, without dashpot",
            law=rolling.spring_slider,
            coefficients=("rolling_stiffness", "rolling_friction"),
            stores=True,
        ),
    ],
)

COHESION: Family[Law] = Family(
    "cohesion law",
    [
        Law(key="none", title="No cohesion", source=KIYAMA, locator="eq. (8)", law=none.cohesion),
        Law(
            key="constant-pull",
            title="Constant pull-off force while in touch",
            source="luding_2008",
            locator="cohesive contact, constant limit",
            law=cohesion.constant_pull,
            coefficients=("pull",),
        ),
    ],
)
