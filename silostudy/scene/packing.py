"""The scenes of a packing study: a silo, its rows of discs, its slit; walls, contacts and where the discs start."""

from collections.abc import Callable
from dataclasses import dataclass
from math import sqrt
from pathlib import Path
from typing import Any

from silostudy.config.contact import ContactConfig, LineContactConfig
from silostudy.config.packing import PackingScene, PackingStudy, RowDiscs, SlitSilo
from silostudy.dem.model import Contact, Wall
from silostudy.errors import BadInput
from silostudy.packing import rows
from silostudy.scene.dem import contact_of
from silostudy.scene.plane_silo import PlaneSilo
from silostudy.tables.kiyama_1983 import GAPS, WALL_STIFFNESS_RATIO

LEAST_ROWS = 5  # with fewer, walls have too few contacts to say anything of the depth
LAYERS = 10  # of a side wall: the paper's cell grid, 4 cm
CELLS_IN_LAYER = 4  # each no higher than a radius, so that it never holds two contacts: see packing_builder
EDGE_CELLS = 16  # parts of each half of the floor


@dataclass(frozen=True)
class SlitScene:
    """One case: the configuration it came from, and its filling (equal text, equal filling)."""

    config: PackingScene
    filling: str


def packing_builder(study: PackingStudy, folder: Path, where: str) -> Callable[[PackingScene, dict], SlitScene]:
    """Builds the scenes of a packing study; BadInput for discs or a slit that do not fit the silo."""

    def build_one(config: PackingScene, settings: dict[str, Any]) -> SlitScene:
        silo, radius = config.silo, config.discs.radius_m
        if silo.slit_width_m >= silo.width_m:
            raise BadInput("silo.slit_width_m", silo.slit_width_m, f"must be below the floor, {silo.width_m:g} m", where)
        if silo.height_m / (LAYERS * CELLS_IN_LAYER) > 1.9 * radius:
            least = silo.height_m / (LAYERS * CELLS_IN_LAYER) / 1.9
            raise BadInput("discs.radius_m", radius, f"must be {least:.3g} or more, or a wall cell holds two contacts", where)
        if (rows := rows_of(config)) < LEAST_ROWS:
            raise BadInput("disc_count", config.disc_count, f"lays {rows} rows: forces over the depth need {LEAST_ROWS}", where)
        for run in (0, 1):
            top = float(discs_of(study, config, run)[1].max()) + radius
            if top > silo.height_m:
                raise BadInput("disc_count", config.disc_count, f"fills {top:.3g} m of walls {silo.height_m:g} m high", where)
        return SlitScene(config, config.model_dump_json(exclude={"remedy": True, "silo": {"slit_width_m": True}}))

    return build_one


def ideal_gap(across: int) -> float:
    """Gap (m) of the ideal start: the source's for 12 and 18 discs across, else by equal ratios (assumed)."""
    (low, wide), (high, narrow) = sorted(GAPS.items())
    return wide * (narrow / wide) ** ((across - low) / (high - low))


def rows_of(config: PackingScene) -> int:
    """Rows of s and s - 1 discs in turn that come nearest to the number of discs wanted."""
    return max(1, round(config.disc_count / (config.across - 0.5)))


def discs_of(study: PackingStudy, config: PackingScene, run: int):
    """Places x, y and radius (m) of the discs: run 0 starts from the ideal packing, others from offsets, the run as seed."""
    gap = (ideal_gap(config.across) if config.gap_m is None else config.gap_m) if run == 0 else study.offset_gap_m
    radius, width, across = config.discs.radius_m, config.silo.width_m, config.across
    pitch = (width - 2.0 * (radius + gap)) / max(1, across - 1)
    rise = sqrt(max(0.0, (2.0 * radius + gap) ** 2 - (pitch / 2.0) ** 2))
    levels = rows_of(config)
    return rows.place(
        width=width, height=2.0 * radius + gap + (levels - 0.5) * rise, radius=radius, across=across, gap=gap,
        offset=0.0 if run == 0 else study.offset_m, seed=run,
    )  # fmt: skip


def packing_walls(silo: SlitSilo) -> tuple[Wall, ...]:
    """The silo's walls with cells for their forces."""
    built = PlaneSilo(silo.width_m, silo.height_m, silo.slit_width_m)
    return built.walls(LAYERS * CELLS_IN_LAYER, EDGE_CELLS)


def contacts_of(config: PackingScene) -> tuple[Contact, Contact]:
    """Contact between discs, and of discs with walls: stiffness and dashpots are larger there by the source's ratio."""
    discs, radius, density = config.discs, config.discs.radius_m, config.discs.density_kg_m3
    between = contact_of(_contact(discs, config, discs.disc_friction), radius, density)
    wall = contact_of(_contact(discs, config, discs.wall_friction), radius, density)
    return between, wall.scaled(stiffness=WALL_STIFFNESS_RATIO, damping=WALL_STIFFNESS_RATIO)


def _contact(discs: RowDiscs, config: PackingScene, friction: float) -> ContactConfig:
    return ContactConfig(
        normal=config.march.normal,
        line_contact=LineContactConfig(
            youngs_modulus_Pa=discs.youngs_modulus_MPa * 1e6,
            poissons_ratio=discs.poissons_ratio,
            load_N_m=discs.contact_load_N_m,
        ),
        damping_ratio=discs.damping_ratio,
        stiffness_ratio=discs.stiffness_ratio,
        sliding_friction=friction,
    )
