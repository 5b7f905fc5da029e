"""The chapters of the note on the steel, from the cube of the checks: actions, strakes, hopper, ring and supports."""

from collections.abc import Iterator, Mapping
from dataclasses import dataclass

import numpy as np
import xarray as xr

from silostudy.buckling import BUCKLING
from silostudy.checks import CHECKS
from silostudy.cube.contract import SCOPE
from silostudy.cube.silos import END
from silostudy.note.lines import Scope, Written, every_line, write
from silostudy.note.loads import Block, Chapter, knowing
from silostudy.note.mathml import rounded


@dataclass(frozen=True)
class Use:
    """How far a check uses a part: utilisation, combination, and where in the cube that stands."""

    key: str
    utilisation: float
    combination: str
    at: Mapping

    @property
    def told(self) -> str:
        """The utilisation in digits."""
        return rounded(self.utilisation) if np.isfinite(self.utilisation) else "–"


def chapters(cube: xr.Dataset, pressure: xr.Dataset, scope: Scope) -> list[Chapter]:
    """Chapters on the steel of one silo by one method; the ends of the wall friction still in the cubes."""
    scope = knowing(scope, _end(cube, 0))
    given = Block("Steel, imposed actions, parts below the wall", tuple(write("steel", scope)))
    scope = scope.at(windless="q_w" not in scope.known)
    found = [Chapter("Steel and imposed actions", [given]), Chapter("Combinations of actions", [_combinations(cube)])]
    if "followed_check" in cube.dims:
        found.append(Chapter("Wall: strakes", list(_strakes(cube, scope))))
    else:
        found.append(Chapter("Wall", [Block(texts=(_whole(cube),))]))
    if "hopper_check" in cube.dims:
        found.append(Chapter("Hopper: wall", list(_parts(cube, pressure, scope, "hopper"))))
    return [*found, Chapter("Transition ring, ring beam, anchors", list(_parts(cube, pressure, scope, "support")))]


def results(cube: xr.Dataset) -> list[tuple[str, str, str, str]]:
    """What governs each part: part, check, combination, utilisation."""
    found = []
    for strake in map(int, cube["strake"].values if "followed_check" in cube.dims else ()):
        most = governing(cube, uses(cube, strake))
        found.append((f"strake {strake}", titled(cube, most.key), most.combination, most.told))
    for part in ("hopper", "support"):
        dim = f"{part}_check"
        each = [_used(cube, f"{dim}_utilisation", dim, key) for key in map(str, cube[dim].values)] if dim in cube.dims else []
        for use in _leading([use for use in each if np.isfinite(use.utilisation)]):
            found.append(
                (
                    use.key.split("_")[0] if part == "hopper" else "below the wall",
                    titled(cube, use.key),
                    use.combination,
                    use.told,
                )
            )
    return found


def _end(cube: xr.Dataset, number: int) -> xr.Dataset:
    return cube.isel({END: number}) if END in cube.dims else cube


def _combinations(cube: xr.Dataset) -> Block:
    head = ("combination", "", *(str(one).replace("_", " ") for one in cube["action"].values))
    rows = tuple(
        (str(key), str(one["combination_title"].values), *(rounded(float(value)) for value in one["combination_factor"].values))
        for key, one in ((key, cube.sel(combination=key)) for key in cube["combination"].values)
    )
    told = "Each multiplies a characteristic action; the solid's is the largest of its phases, or that of filling."
    return Block(
        "Partial and combination factors on the characteristic actions", head=head, rows=rows, texts=(told,), wordy=True
    )


def _whole(cube: xr.Dataset) -> str:
    thickness = rounded(float(cube["design_thickness"].isel(rule=0).max()) * 1e3)
    return f"No strakes are given: a wall of one thickness needs {thickness} mm; checks are not written out."


def uses(cube: xr.Dataset, strake: int) -> list[Use]:
    """Every check of a strake at its worst end of the wall friction, as the cube has them in order."""
    found = []
    for key in map(str, cube["followed_check"].values):
        one = cube.sel(followed_check=key, strake=strake)
        end, used = worst(one["followed_utilisation"])
        here = _end(one, end)
        combination = here["followed_combination"].attrs["flag_meanings"].split()[int(here["followed_combination"])]
        at = {"followed_check": key, "strake": strake, "end": end, "place": int(here["followed_place"])}
        found.append(Use(key, used, combination if np.isfinite(used) else "", at))
    return found


def worst(values: xr.DataArray) -> tuple[int, float]:
    """(number of the end of the wall friction with the largest value, that value); 0 and NaN where all are masked."""
    each = np.atleast_1d(values.values)
    end = int(np.argmax(np.where(np.isnan(each), -np.inf, each)))
    return end, float(each[end])


def governing(cube: xr.Dataset, found: list[Use]) -> Use:
    """The check that governs: by the study's first rule of buckling, or a check that is not of buckling."""
    others = [str(key) for key in cube["rule"].values[1:]]
    counted = [use for use in found if use.key not in others and np.isfinite(use.utilisation)]
    return max(counted, key=lambda use: use.utilisation, default=found[0])


def _strakes(cube: xr.Dataset, scope: Scope) -> Iterator[Block]:
    rules = [str(key) for key in cube["rule"].values]
    yield _strake_summary(cube)
    for strake in map(int, cube["strake"].values):
        found = uses(cube, strake)
        most = governing(cube, found)
        yield _strake_table(cube, found, most, strake, rules)
        if np.isfinite(most.utilisation):
            yield Block(f"Strake {strake}, governing check in full: {titled(cube, most.key)}, combination {most.combination}",
                        tuple(_in_full(cube, scope, most, rules)), texts=_told(most.key))  # fmt: skip


def _strake_summary(cube: xr.Dataset) -> Block:
    rows = []
    for strake in map(int, cube["strake"].values):
        most = governing(cube, uses(cube, strake))
        one = cube.sel(strake=strake).isel(rule=0)
        end, needed = worst(one["design_strake_thickness"])
        at = _end(one, end)
        built = float(cube["place_thickness"].values.ravel()[int(np.argmax(cube["place_strake"].values.ravel() == strake))])
        by = [at[f"design_strake_thickness_{what}"] for what in ("check", "combination")]
        check, combination = (flag.attrs["flag_meanings"].split()[int(flag)] for flag in by)
        told = f"{titled(cube, check)} in {combination}" if np.isfinite(needed) else "masked"
        rows.append((str(strake), rounded(built * 1e3), most.told, f"{titled(cube, most.key)} in {most.combination}",
                     rounded(needed * 1e3), told))  # fmt: skip
    head = ("strake", "built (mm)", "utilisation", "governing check", "needed (mm)", "asked for by")
    note = "needed: if the whole wall were so thick; a strake may do with less where thicker ones below and above steady it"
    return Block("Summary", head=head, rows=tuple(rows), texts=(note,), wordy=True)


def _strake_table(cube: xr.Dataset, found: list[Use], most: Use, strake: int, rules: list[str]) -> Block:
    rows = []
    for use in found:
        depth = float(_end(cube, use.at["end"])["place_depth"].sel(place=max(use.at["place"], 1)))
        why = _why(cube, use.key, rules)
        place = rounded(depth) if use.combination else ""
        rows.append((titled(cube, use.key), use.told, use.combination or why, place, _mark(use, most, rules)))
    head = ("check", "utilisation", "combination", "at z (m)", "")
    return Block(f"Strake {strake}, all checks", head=head, rows=tuple(rows), strong=(found.index(most),), wordy=True)


def _mark(use: Use, most: Use, rules: list[str]) -> str:
    return "governs" if use is most else "for comparison" if use.key in rules[1:] else ""


def _why(cube: xr.Dataset, key: str, rules: list[str]) -> str:
    """Why a check is nowhere made, in words: the reason that stands most often."""
    name, dim = ("design_buckling_utilisation", "rule") if key in rules else ("design_check_utilisation", "steel_check")
    flags = cube[name + SCOPE].sel({dim: key})
    return flags.attrs["flag_meanings"].split()[int(np.bincount(flags.values.ravel()).argmax())].replace("_", " ")


def titled(cube: xr.Dataset, key: str) -> str:
    """A check or rule in words."""
    rules = [str(rule) for rule in cube["rule"].values]
    if key == "buckling":
        key = rules[0]
    if key in rules:
        return f"axial buckling, {cube['rule_title'].values[rules.index(key)]}"
    return key.replace("_", " ")


def _in_full(cube: xr.Dataset, scope: Scope, use: Use, rules: list[str]) -> list[Written]:
    """The lines of a check of a strake at the place and in the combination of its largest utilisation."""
    one = _end(cube, use.at["end"]).sel(followed_check=use.key, strake=use.at["strake"], combination=use.combination)
    one = one.sel(place=use.at["place"])
    one = one.sel(rule=use.key) if use.key in rules else one.sel(steel_check=use.key)
    local = scope.at(
        one,
        full=str(one["combination_contents"].values) == "full",
        shaken=float(one["combination_factor"].sel(action="earthquake")) > 0,
    )
    owner = use.key if owned(use.key) else "other_rule"
    return [line for section in ("place", "axial", "wall") for line in write(section, local, owner)]


def _told(key: str) -> tuple[str, ...]:
    """What else there is to say of a check or a rule: its formula as `silostudy explain` has it, and its range."""
    row = CHECKS[key] if key in CHECKS else BUCKLING[key] if key in BUCKLING else None
    formula = () if owned(key) else (f"Formula: {row.formula}.",) if row else ()
    return (*formula, f"Range and evidence: {row.validity}.") if row else ()


def owned(key: str) -> bool:
    """Whether a rule or check has lines of its own."""
    return any(key in line.owner for line in every_line())


def _parts(cube: xr.Dataset, pressure: xr.Dataset, scope: Scope, part: str) -> Iterator[Block]:
    """Hopper or supports: a table of all checks, then each in full where it is used most."""
    name, dim = f"{part}_check_utilisation", f"{part}_check"
    found = [_used(cube, name, dim, key) for key in map(str, cube[dim].values)]
    known = [use for use in found if np.isfinite(use.utilisation)]
    rows = tuple((use.key.replace("_", " "), use.told, use.combination or _reason(cube, name, dim, use.key)) for use in found)
    most = max(known, key=lambda use: use.utilisation, default=None)
    strong = (found.index(most),) if most else ()
    yield Block("All checks", head=("check", "utilisation", "combination"), rows=rows, strong=strong, wordy=True)
    for use in _leading(known):
        one = _end(cube, use.at["end"]).sel({dim: use.key, "combination": use.combination})
        cubes = (one,)
        if part == "hopper":
            one = one.isel(hopper_position=use.at["place"])
            normal = _end(pressure, use.at["end"]).isel(hopper_position=use.at["place"])
            phase = int(normal["hopper_normal_pressure"].argmax("phase"))
            cubes = one, normal.isel(phase=phase)
        lines = write(f"{part} check" if part == "hopper" else part, scope.at(*cubes), use.key)
        heading = f"{use.key.replace('_', ' ').capitalize()}, combination {use.combination}"
        yield Block(heading, tuple(lines), texts=_told(use.key))


def _leading(found: list[Use]) -> list[Use]:
    """Of the checks that share lines, so of one part, the one by which it is used most."""
    kept: list[Use] = []
    for use in sorted(found, key=lambda use: -use.utilisation):
        if not any({use.key, other.key} <= set(line.owner) or "hopper" in use.key for line in every_line() for other in kept):
            kept.append(use)
    return kept


def _used(cube: xr.Dataset, name: str, dim: str, key: str) -> Use:
    values = cube[name].sel({dim: key})
    dims = [one for one in ("combination", END, "hopper_position") if one in values.dims]
    values = values.transpose(*dims)
    if values.isnull().all():
        return Use(key, np.nan, "", {})
    place = dict(zip(dims, np.unravel_index(int(np.nanargmax(values.values)), values.shape), strict=True))
    combination = str(cube["combination"].values[place["combination"]])
    at = {"end": int(place.get(END, 0)), "place": int(place.get("hopper_position", 0))}
    return Use(key, float(values.max()), combination, at)


def _reason(cube: xr.Dataset, name: str, dim: str, key: str) -> str:
    flags = cube[name + SCOPE].sel({dim: key})
    return flags.attrs["flag_meanings"].split()[int(np.bincount(flags.values.ravel()).argmax())].replace("_", " ")
