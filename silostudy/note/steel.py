"""The chapters of the note on the steel, from the cube of the checks: actions, strakes, hopper, ring and supports."""

from collections.abc import Iterator

import numpy as np
import xarray as xr

from silostudy.cube.governing import parts
from silostudy.note import below
from silostudy.note.lines import Scope, Written, write
from silostudy.note.loads import Block, Chapter, knowing
from silostudy.note.mathml import rounded
from silostudy.note.uses import Use, at_end, governing, owned, titled, told_of, uses_of_part, uses_of_strake, why, worst


def chapters(cube: xr.Dataset, pressure: xr.Dataset, scope: Scope) -> list[Chapter]:
    """Chapters on the steel of one silo by one method; the ends of the wall friction still in the cubes."""
    told, scope = given(cube, scope)
    steel = Block("Steel, imposed actions, parts below the wall", tuple(told))
    combined = Chapter("Combinations of actions", [_combinations(cube), _by_combination(cube)])
    about_steel = [Chapter("Steel and imposed actions", [steel]), combined]
    if "followed_check" in cube.dims:
        about_steel.append(Chapter("Wall: strakes", list(_strakes(cube, scope))))
    else:
        about_steel.append(Chapter("Wall", [Block(texts=(_whole(cube),))]))
    if "hopper_check" in cube.dims:
        about_steel.append(Chapter("Hopper: wall", list(below.blocks(cube, pressure, scope, "hopper"))))
    return [*about_steel, Chapter("Transition ring, ring beam, anchors", list(below.blocks(cube, pressure, scope, "support")))]


def given(cube: xr.Dataset, scope: Scope) -> tuple[list[Written], Scope]:
    """Lines of what the study gives of the steel, and the scope that knows them, wind and patch load among them."""
    local = knowing(scope, at_end(cube, 0))
    lines = write("steel", local)
    return lines, local.reading(windless="q_w" not in local.known, patched="z_p" in local.known)


def results(cube: xr.Dataset) -> list[tuple[str, str, str, str]]:
    """Check that governs each part: part, check, combination, utilisation."""
    rows = []
    for strake in map(int, cube["strake"].values if "followed_check" in cube.dims else ()):
        most = governing(cube, uses_of_strake(cube, strake))
        rows.append((f"strake {strake}", titled(cube, most.key), most.combination, most.told))
    for part in ("hopper", "support"):
        for use in below.leading([use for use in uses_of_part(cube, part) if np.isfinite(use.utilisation)]):
            where = part if part == "hopper" else "below the wall"
            rows.append((where, titled(cube, use.key), use.combination, use.told))
    return rows


def _combinations(cube: xr.Dataset) -> Block:
    head = ("combination", "", *(str(action).replace("_", " ") for action in cube["action"].values))
    rows = tuple(
        (
            str(key),
            str(of_combination["combination_title"].values),
            *(rounded(float(value)) for value in of_combination["combination_factor"].values),
        )
        for key, of_combination in ((key, cube.sel(combination=key)) for key in cube["combination"].values)
    )
    told = "Each multiplies a characteristic action; the solid's is the largest of its phases, or that of filling."
    return Block(
        "Partial and combination factors on the characteristic actions", head=head, rows=rows, texts=(told,), wordy=True
    )


def _by_combination(cube: xr.Dataset) -> Block:
    """Every part's utilisation in every combination, with the load case of the contents where it is largest."""
    method, keys = str(cube["pressure_method"].values), [str(key) for key in cube["combination"].values]
    uses: dict[str, dict[str, dict]] = {}
    for use in parts(cube.expand_dims("pressure_method"), method, str(cube["rule"].values[0])):
        uses.setdefault(use["part"], {})[use["combination"]] = use
    rows = []
    for part, by_key in uses.items():
        most = max(by_key.values(), key=lambda use: np.nan_to_num(use["utilisation"], nan=-1.0))
        where = (most["combination"], most["load_case"]) if np.isfinite(most["utilisation"]) else ("", "")
        rows.append((part, *(rounded(by_key[key]["utilisation"]) for key in keys), *where))
    note = "Axial buckling by the study's first rule. –: no load for the part, or masked; the chapters on the parts say why."
    head = ("part", *keys, "largest in", "load case of the contents there")
    return Block("Utilisation of every part", head=head, rows=tuple(rows), texts=(note,), wordy=True)


def _whole(cube: xr.Dataset) -> str:
    thickness = rounded(float(cube["design_thickness"].isel(rule=0).max()) * 1e3)
    return f"No strakes are given: a wall of one thickness needs {thickness} mm; checks are not written out."


def _strakes(cube: xr.Dataset, scope: Scope) -> Iterator[Block]:
    rules = [str(key) for key in cube["rule"].values]
    yield _strake_summary(cube)
    for strake in map(int, cube["strake"].values):
        uses = uses_of_strake(cube, strake)
        most = governing(cube, uses)
        yield _strake_table(cube, uses, most, strake, rules)
        if np.isfinite(most.utilisation):
            yield Block(f"Strake {strake}, governing check in full: {titled(cube, most.key)}, combination {most.combination}",
                        tuple(in_full(cube, scope, most, rules)), texts=told_of(most.key))  # fmt: skip


def _strake_summary(cube: xr.Dataset) -> Block:
    rows = []
    for strake in map(int, cube["strake"].values):
        most = governing(cube, uses_of_strake(cube, strake))
        here = cube.sel(strake=strake).isel(rule=0)
        end, needed = worst(here["design_strake_thickness"])
        there = at_end(here, end)
        built = float(cube["place_thickness"].values.ravel()[int(np.argmax(cube["place_strake"].values.ravel() == strake))])
        by = [there[f"design_strake_thickness_{what}"] for what in ("check", "combination")]
        check, combination = (flag.attrs["flag_meanings"].split()[int(flag)] for flag in by)
        told = f"{titled(cube, check)} in {combination}" if np.isfinite(needed) else "masked"
        rows.append((str(strake), rounded(built * 1e3), most.told, f"{titled(cube, most.key)} in {most.combination}",
                     rounded(needed * 1e3), told))  # fmt: skip
    head = ("strake", "built (mm)", "utilisation", "governing check", "needed (mm)", "asked for by")
    note = "needed: if the whole wall were so thick; a strake may do with less where thicker ones below and above steady it"
    return Block("Summary", head=head, rows=tuple(rows), texts=(note,), wordy=True)


def _strake_table(cube: xr.Dataset, uses: list[Use], most: Use, strake: int, rules: list[str]) -> Block:
    rows = []
    for use in uses:
        depth = float(at_end(cube, use.where["end"])["place_depth"].sel(place=max(use.where["place"], 1)))
        reason = why(cube, use.key, rules, strake)
        place = rounded(depth) if use.combination else ""
        rows.append((titled(cube, use.key), use.told, use.combination or reason, place, _mark(use, most, rules)))
    head = ("check", "utilisation", "combination", "at z (m)", "")
    return Block(f"Strake {strake}, all checks", head=head, rows=tuple(rows), strong=(uses.index(most),), wordy=True)


def _mark(use: Use, most: Use, rules: list[str]) -> str:
    return "governs" if use is most else "for comparison" if use.key in rules[1:] else ""


def in_full(cube: xr.Dataset, scope: Scope, use: Use, rules: list[str]) -> list[Written]:
    """The lines of a check of a strake at the place and in the combination of its largest utilisation."""
    here = at_end(cube, use.where["end"]).sel(followed_check=use.key, strake=use.where["strake"], combination=use.combination)
    here = here.sel(place=use.where["place"])
    here = here.sel(rule=use.key) if use.key in rules else here.sel(steel_check=use.key)
    local = scope.reading(
        here,
        full=str(here["combination_contents"].values) == "full",
        shaken=float(here["combination_factor"].sel(action="earthquake")) > 0,
    )
    owner = use.key if owned(use.key) else "other_rule"
    return [line for section in ("place", "axial", "wall") for line in write(section, local, owner)]
