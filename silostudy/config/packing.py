"""A packing study: discs laid in rows, brought to rest and let out through a slit, again and again with other offsets."""

from typing import ClassVar, Literal, TypeAlias

from silostudy.config.asked import Asked
from silostudy.config.fields import Strict, described
from silostudy.config.run import IntegratorKey
from silostudy.config.study import BaseStudy
from silostudy.contact import DEFAULTS, LAWS
from silostudy.dem.integrate import PLAIN
from silostudy.tables import kiyama_1983 as kiyama

LINEAR = tuple(key for key, law in LAWS["normal"].items() if law.linear)
SpringKey: TypeAlias = Literal[LINEAR]  # type: ignore[valid-type]  # a packing study's walls are stiffer by a factor


class SlitSilo(Strict):
    """A plane box with a slit in the middle of its flat floor."""

    width_m: float = described("inner width", "m", gt=0, default=kiyama.SILO_WIDTH)
    height_m: float = described(
        "height of the walls, of which ten layers have their force recorded", "m", gt=0, default=kiyama.SILO_HEIGHT
    )
    slit_width_m: float = described("width of the slit", "m", gt=0, default=kiyama.SLIT_WIDTH)


class RowDiscs(Strict):
    """The discs, by default those of Kiyama and Fujimura (1983), Table 2; walls are twice as stiff."""

    radius_m: float = described("radius", "m", gt=0, default=kiyama.RADIUS)
    density_kg_m3: float = described("density", "kg m-3", gt=0, default=kiyama.DENSITY)
    youngs_modulus_MPa: float = described("Young's modulus", "MPa", gt=0, default=kiyama.YOUNGS_MODULUS / 1e6)
    poissons_ratio: float = described("Poisson's ratio", gt=-1, le=0.5, default=kiyama.POISSONS_RATIO)
    contact_load_N_m: float = described(
        "load at which the contact's stiffness is taken", "N m-1", gt=0, default=kiyama.CONTACT_LOAD
    )
    damping_ratio: float = described("normal dashpot over 2 sqrt(m K)", ge=0, default=kiyama.DAMPING_RATIO)
    stiffness_ratio: float = described(
        "tangential over normal stiffness; dashpots have its root", gt=0, default=kiyama.STIFFNESS_RATIO
    )
    disc_friction: float = described("friction between discs", ge=0, default=kiyama.DISC_FRICTION)
    wall_friction: float = described("friction at walls and floor", ge=0, default=kiyama.WALL_FRICTION)


class PackingMarch(Strict):
    """Settings of the computation of forces and motions."""

    normal: SpringKey = described("law of the normal force", default=DEFAULTS["normal"])
    integrator: IntegratorKey = described("how velocities and places follow from forces", default=PLAIN.key)
    step_s: float | None = described("time step; null: half the bound of the discs as laid", "s", gt=0, default=None)


class PackingScene(Strict):
    """One silo, its packing and its slit."""

    silo: SlitSilo = described("the silo", "", default=SlitSilo())
    across: int = described("s of the packing (s-1)/s: discs in the lowest row", ge=2)
    disc_count: int = described(
        "discs wanted; rows are laid until it is met as nearly as can be", ge=4, default=kiyama.DISC_COUNT
    )
    gap_m: float | None = described(
        "gap between neighbours of the ideal start; null: the source's for 11/12 and 17/18, between them by equal ratios",
        "m",
        ge=0,
        default=None,
    )
    discs: RowDiscs = described("the discs", "", default=RowDiscs())
    march: PackingMarch = described("laws and time step", "", default=PackingMarch())
    remedy: bool = described("whether a disc of the arch's roof is taken out where the flow has stopped", "", default=False)


class Detail(Strict):
    """A run that is kept frame by frame."""

    across: int = described("s of its packing", ge=2)
    run: int = described("number of the run; 0: the ideal start", ge=0, default=0)


class PackingStudy(Asked, BaseStudy):
    """Discs at rest and in discharge: ensembles of starts for every case."""

    fronts: ClassVar[tuple[str, ...]] = ("packing",)

    kind: Literal["packing"] = described("packing: rows of discs at rest and in discharge", "")
    scene: PackingScene = described("the base scene", "")
    runs: int | None = described(
        "runs of each case that start from offsets, beside the ideal start; null: for the accuracy", ge=1, le=1000, default=40
    )
    offset_m: float = described("offset of every disc at those starts, each way, at random", "m", gt=0, default=1e-4)
    offset_gap_m: float = described("gap between neighbours at those starts", "m", gt=0, default=kiyama.GAPS[kiyama.PASSIVE])
    discharge_s: float = described("time that each discharge is followed", "s", gt=0.5, default=1.2)
    stopped_s: float = described("time without a disc passing after which the flow has stopped", "s", gt=0, default=0.2)
    rest_limit_s: float = described("longest time for a packing to come to rest", "s", gt=0, default=2.5)
    detailed: tuple[Detail, ...] = described("runs that are kept frame by frame, for figures and animations", "", default=())
