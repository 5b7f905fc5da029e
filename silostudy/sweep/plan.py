"""Plan of a sweep's jobs: parts of about half a minute's work, kept when the sweep grows.

The plan is a file beside the journals.  A case stays where its record is, or where it was planned; the others make new parts.
"""

import csv
import hashlib
from collections import Counter
from collections.abc import Iterable, Iterator, Sequence
from itertools import accumulate
from pathlib import Path

from silostudy.errors import BadInput
from silostudy.files import replacing
from silostudy.scene.expand import Expansion
from silostudy.stages import KINDS
from silostudy.stages.family import Parts
from silostudy.sweep.journal import ENDING, sound

PLAN = "plan.csv"  # name of the plan's file
DONE = ".done"  # ending of the file that stands when a part is done
Plan = dict[str, list[tuple[int, str]]]  # part -> positions and keys of its cases


def parts_of(study) -> Parts:
    """Functions of a kind of study that compute its cases in parts."""
    parts = KINDS[study.kind].parts
    assert parts is not None, study.kind
    return parts


def case_keys(expansion: Expansion) -> list[str]:
    """A key for each case: changed code, settings, scene or file of the user gives another key."""
    digests = {file: hashlib.sha256(file.read_bytes()).hexdigest() for file in expansion.files if file.is_file()}
    named = [digests[file] for file in expansion.named]
    about = " ".join([parts_of(expansion.study).stamp, expansion.study.settings, *named])
    files = (" ".join(digests.get(file, "missing") for file in getattr(case.scene, "files", ())) for case in expansion.cases)
    texts = (f"{about} {case.id} {more}" for case, more in zip(expansion.cases, files, strict=True))
    return [hashlib.sha256(text.encode()).hexdigest()[:20] for text in texts]


def planned(expansion: Expansion, folder: Path, cores: int) -> tuple[Plan, list[Path]]:
    """The plan of a sweep, and the marks that stand by parts which lack a case's record; nothing is written."""
    study, keys, parts = expansion.study, case_keys(expansion), parts_of(expansion.study)
    code = parts.stamp
    held = {key: path.stem for path in sorted(folder.glob(f"{code}-*{ENDING}")) for key, _ in sound(path)}
    before = {key: part for part, rows in read_plan(folder).items() for _, key in rows}
    places = [held.get(key) or before.get(key) for key in keys]
    fresh = [position for position, place in enumerate(places) if place is None]
    costs = [study.case_s or parts.call("cost", expansion.cases[position].scene) for position in fresh]
    for group in grouped(fresh, costs, study, cores):
        name = f"{code}-{hashlib.sha256(' '.join(keys[position] for position in group).encode()).hexdigest()[:8]}"
        for position in group:
            places[position] = name
    plan: Plan = {}
    for position, place in enumerate(places):
        plan.setdefault(str(place), []).append((position, keys[position]))
    lacking = [part for part, rows in plan.items() if any(key not in held for _, key in rows)]
    return plan, [mark for part in lacking if (mark := folder / f"{part}{DONE}").exists()]


def grouped(positions: Sequence[int], costs: Sequence[float], study, cores: int) -> Iterable[list[int]]:
    """Neighbouring cases in groups of about equal work: as many as there are cores where each has half a minute or more."""
    whole = sum(costs)
    count = max(1, round(whole / study.part_s), min(cores, int(whole / LEAST)))
    parts: dict[int, list[int]] = {}
    for position, end, cost in zip(positions, accumulate(costs), costs, strict=True):
        parts.setdefault(int((end - 0.5 * cost) / whole * count), []).append(position)
    return parts.values()


LEAST = 30.0  # s of work in a job: its start takes 1 to 2 s


def read_plan(folder: Path) -> Plan:
    """The plan in a folder, empty where there is none."""
    plan: Plan = {}
    for part, position, key in _rows(folder):
        plan.setdefault(part, []).append((int(position), key))
    return plan


def _rows(folder: Path) -> Iterator[list[str]]:
    if (folder / PLAN).exists():
        with (folder / PLAN).open(newline="", encoding="utf-8") as stream:
            rows = csv.reader(stream)
            next(rows)
            yield from rows


def sizes(folder: Path) -> Counter[str]:
    """Number of cases of each part of the plan."""
    return Counter(part for part, _, _ in _rows(folder))


def rows_of(part: str, folder: Path) -> list[tuple[int, str]]:
    """Positions and keys of a part's cases; BadInput for a part that is not planned."""
    rows = [(int(position), key) for name, position, key in _rows(folder) if name == part]
    if not rows:
        raise BadInput("part", part, f"is not in {folder / PLAN}")
    return rows


def write_plan(plan: Plan, folder: Path) -> None:
    """Writes a plan where it changed."""
    if plan == read_plan(folder):
        return
    with replacing(folder / PLAN) as temporary, temporary.open("w", newline="", encoding="utf-8") as stream:
        table = csv.writer(stream)
        table.writerow(["part", "position", "case_key"])
        table.writerows([part, position, key] for part, rows in plan.items() for position, key in rows)
