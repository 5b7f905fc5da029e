"""The note of one silo as an HTML page that stands alone: no scripts, no other files."""

import re
from collections.abc import Sequence
from pathlib import Path

import jinja2
import xarray as xr
from markupsafe import Markup  # what Jinja2 brings

from silostudy.cube.silos import at_silo
from silostudy.note import cases, left_out, loads, steel
from silostudy.note.lines import Written, result_of
from silostudy.note.loads import Block, Chapter
from silostudy.note.mathml import prose
from silostudy.note.sources import short
from silostudy.note.uses import at_end
from silostudy.pressure import PRESSURE

CAVEAT = (
    "The printed standards were not seen. The formulas come second-hand, from public programs and accounts that agree with "
    "each other or with statics; what a single source has is marked. Editions: EN 1991-4:2006 (a second generation, "
    "EN 1991-4:2026, exists), EN 1993-4-1 and EN 1993-1-6:2007. Partial factors and limits of classes are national choices. "
    "Whoever signs must compare with the standards in force."
)


def page(pressure: xr.Dataset, checks: xr.Dataset | None, case: str) -> str:
    """The note of a silo; pressure, checks: the cubes of a study."""
    method = loads.method_of(pressure)
    silo_cube = at_silo(pressure, case).sel(pressure_method=method)
    steel_cube = at_silo(checks, case).sel(pressure_method=method) if checks is not None else None
    parts = chapters(silo_cube, steel_cube, method)
    lines = [line for chapter in parts for block in chapter.blocks for line in block.lines]
    return _template().render(
        title=pressure.attrs["title"], running=_running(pressure.attrs["title"]), case=case,
        about=_about(pressure, checks, silo_cube, method), caveat=CAVEAT, recomputed=recomputed(lines),
        chapters=parts, result_of=result_of, source_of=source_of,
        missing=cases.not_asked_for(at_end(steel_cube, 0)) if steel_cube is not None else [],
        results=steel.results(steel_cube) if steel_cube is not None else [], prose=lambda text: Markup(prose(text)),
    )  # fmt: skip


def chapters(silo_cube: xr.Dataset, checks: xr.Dataset | None, method: str) -> list[Chapter]:
    """All chapters of a note, of a silo's parts of the cubes by one method."""
    with_strakes = checks is not None and int(checks["place_strake"].max()) > 0
    drawn = at_end(checks, 0) if checks is not None and with_strakes else None
    parts, scope = loads.chapters(at_end(silo_cube, 0), method, drawn)
    if method in PRESSURE:
        row = PRESSURE[method]
        parts[2].blocks.append(Block("The method", texts=(f"Formula: {row.formula}.", f"Range and evidence: {row.validity}.")))
    parts.append(cases.chapter(None if checks is None else at_end(checks, 0)))
    if checks is not None:
        parts += steel.chapters(checks, silo_cube, scope)
    parts.append(left_out.chapter(method, checks))
    cited = dict.fromkeys(
        line for cube in (silo_cube, checks) if cube is not None for line in cube.attrs["references"].split("\n")
    )
    return [*parts, Chapter("References", [Block(items=tuple(cited))])]


def recomputed(lines: Sequence[Written]) -> str:
    """Number of formulas that were evaluated again with the numbers shown, and how well they agree with the cube."""
    again = [line for line in lines if line.value == line.value]
    off = [line.line.name for line in again if not line.agrees]
    told = (
        f"{len(lines)} lines, every result read from the cubes; {len(again)} formulas evaluated again with the numbers put in: "
    )
    return told + (f"DISAGREEING: {', '.join(off)}." if off else "all give the cubes' results.")


def source_of(line: Written) -> str:
    """Source and place of a line."""
    return f"{short(line.line.source)}, {line.line.locator}"


def _running(title: str) -> str:
    """The title as it stands in the head of every page, within a style sheet."""
    return re.sub(r"[^\w .,:;()/-]", "\u2019", title)[:90]


def _about(pressure: xr.Dataset, checks: xr.Dataset | None, silo_cube: xr.Dataset, method: str) -> list[tuple[str, str]]:
    title = str(silo_cube["pressure_method_title"].values)
    facts = [
        ("study", pressure.attrs["title"]),
        ("silo (case)", str(silo_cube["case"].values.ravel()[0])),
        ("actions by", title),
    ]
    if checks is not None:
        facts.append(("steel by", ", ".join(map(str, checks["rule_title"].values)) + "; the first governs"))
    facts.append(("computed by", f"{pressure.attrs['source']}; study {pressure.attrs['study_hash']}"))
    stamps = ", ".join(f"{cube.attrs['stage']} {cube.attrs['source_stamp']}" for cube in (pressure, checks) if cube is not None)
    return [*facts, ("provenance", f"cubes and stamps of their sources: {stamps}; {pressure.attrs['package_versions']}")]


def _template() -> jinja2.Template:
    folder = jinja2.FileSystemLoader(Path(__file__).parent)
    environment = jinja2.Environment(loader=folder, autoescape=True, undefined=jinja2.StrictUndefined, trim_blocks=True)
    return environment.get_template("page.html")
