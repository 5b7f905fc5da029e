"""Refusals of scenes name keys that scenes have: every one in the rooms that a scene goes through is held to the schema."""

import ast
import re
from collections.abc import Iterator
from pathlib import Path

import pytest

from silostudy.compute.dem import DISC_KEYS, SPHERE_KEYS, scene_model
from silostudy.config.dem import DemScene
from silostudy.config.spheres import SphereScene
from silostudy.errors import BadInput
from silostudy.packing import PACKINGS
from silostudy.scene.dem_model import SIZES
from tests.conftest import ROOT
from tests.test_dem.small import scene_of

ROOMS = ("dem", "packing", "scene", "compute", "config")
OTHERS = {  # files of these rooms that other studies than scenes go through
    "scene": ("accuracy", "beside", "build", "expand", "facets", "grains", "packing", "possible", "published", "shares"),
    "compute": ("beside_codes", "calculix", "checks", "grains", "laboratory", "loads", "motion", "scenes_means", "shell"),
}
HOLE = "<hole>"


def rooms() -> Iterator[Path]:
    """Files that a scene goes through."""
    for room in ROOMS:
        for path in sorted((ROOT / "silostudy" / room).rglob("*.py")):
            if path.stem not in OTHERS.get(room, ()):
                yield path


def words(node: ast.expr) -> str | None:
    """A key as it is written, with HOLE for what is filled in; None for one that is passed on."""
    if isinstance(node, ast.Constant):
        return str(node.value)
    if isinstance(node, ast.JoinedStr):
        return "".join(part.value if isinstance(part, ast.Constant) else HOLE for part in node.values)
    return None


def refusals(*names: str) -> set[tuple[str, str]]:
    """File and key of every refusal by these callables."""
    found = set()
    for path in rooms():
        for node in ast.walk(ast.parse(path.read_text())):
            if isinstance(node, ast.Call) and isinstance(node.func, ast.Name) and node.func.id in names and node.args:
                key = words(node.args[0])
                if key is not None:
                    found.add((str(path.relative_to(ROOT / "silostudy")), key))
    return found


def paths(schema, whole, depth=0) -> set[str]:
    """Dotted keys of a schema; * stands for a place in a list, or a name of one's own."""
    found = set()
    for node in plain(schema, whole):
        for key, below in node.get("properties", {}).items():
            found |= {key, *(f"{key}.{further}" for further in paths(below, whole, depth + 1))}
        inner = [node[name] for name in ("items", "additionalProperties") if isinstance(node.get(name), dict)]
        for below in [*inner, *node.get("prefixItems", ())]:
            found |= {"*", *(f"*.{further}" for further in paths(below, whole, depth + 1))}
    return found


def plain(node, whole):
    branches = [*node.get("anyOf", ()), *node.get("oneOf", ())]
    if "$ref" in node:
        branches.append(whole["$defs"][node["$ref"].rpartition("/")[2]])
    return [below for branch in branches for below in plain(branch, whole)] if branches else [node]


KEYS = {path for model in (DemScene, SphereScene) for path in paths(model.model_json_schema(), model.model_json_schema())}


def is_key(written: str, *, anywhere: bool = False) -> bool:
    """Whether a key may be one of a scene's, or of a section of it."""
    form = ".".join(re.escape(part).replace(HOLE, r"[^.]+") for part in written.split("."))
    return any(re.fullmatch((r"(.*\.)?" if anywhere else "") + form, path) for path in KEYS)


NO_SCENE = {  # refusals that no scene file meets: what they are about comes from code or from another command
    "compute/shell_earthquake.py",
    "config/load.py",
    "dem/engine.py",
    "dem/events.py",
    "dem/model.py",
    "dem/space/level.py",
    "dem/space/walls.py",
    "dem/varied.py",
    "scene/earthquake.py",
    "scene/laboratory.py",
    "scene/seismic.py",
    "scene/shell.py",
    "scene/silo_from.py",
}
TOLD_AGAIN = {  # and those whose key a caller knows and puts in
    "dem/contacts.py": "cohesion",  # scene/dem.py: keys_of
    "dem/space/inserts.py": f"{HOLE}.radii_m",  # scene/dem.py: inserted
    "scene/space_checks.py": f"{HOLE}.name",  # its caller gives inserts.0
}


def test_every_refusal_names_a_key_of_scenes():
    arguments = {row.argument: f"packing.{row.name}" for packing in PACKINGS.values() for row in packing.asks if row.argument}
    found = refusals("BadInput", "unknown")
    for file, key in found:
        first, dot, further = key.partition(".")
        forms = {keys.get(first, first) + dot + further for keys in (DISC_KEYS, SPHERE_KEYS, SIZES | arguments)}
        assert any(map(is_key, forms)) or file in NO_SCENE or TOLD_AGAIN.get(file) == key, (file, key)
    assert len(found) > 60


def test_every_mistake_below_a_section_names_a_key_of_scenes():
    found = refusals("KeyMistake")
    for file, key in found:
        assert is_key(key, anywhere=True) or file == "config/fields.py", (file, key)  # the spacing of a range: of studies
    assert len(found) > 30


FRICTION = [{"when": "time", "value": 0.1, "do": "set_friction", "wall_friction": 0.1, "surfaces": ["nope"]}]
STOP = {"when": "after", "value": 0.1, "do": "stop"}
REFUSED = {
    "surface of an event": ({"events": [*FRICTION, STOP]}, "events.0.surfaces = 'nope': unknown; known: floor, floor_left"),
    "discs wider than the silo": (
        {"packing": {"kind": "loose", "count": 5}, "radius_m": 0.2},
        "radius_m = 0.2: not one disc of this size fits the width 0.17 m",
    ),
    "no shaking": ({"quake": {"file": "none.csv"}}, "quake.file = 'none.csv': must be a readable file of text"),
    "no row": ({"packing__fill_height_m": 0.001}, "packing.fill_height_m = 0.001: must be 0.02004 m or more"),
    "offset": ({"packing__offset_m": 0.1}, "packing.offset_m = 0.1: must lie in 0 ... 1.414e-05 m"),
    "across": (
        {"packing__across": 9},
        "packing.across = 9: 9 discs of radius 0.01 m and their gaps do not fit 0.17 m, which has room for 8",
    ),
    "more discs than have room": (
        {"packing": {"kind": "loose", "count": 500}},
        "packing = 'disc 498': starts at x 0.03723 m, y 1.646 m, outside walls from x 0 to 0.17 m and y 0 to 0.4 m; 119 of 500 "
        "discs start inside",
    ),
    "a quantity of spheres": (
        {"expected": [{"kind": "wall-load", "value_N": 1.0, "tolerance_N": 0.1, "source": "none", "locator": "none"}]},
        "expected.0.kind = 'wall-load': is of scenes of spheres alone",
    ),
    "damping": (
        {"discs__normal_damping_N_s_m2": None, "discs__damping_ratio": 1e308},
        "discs.normal_damping_N_s_m2 = inf: must be zero or more",
    ),
    "last event": (
        {"events": [{"when": "rest", "do": "open_slit"}]},
        "events.0.do = 'open_slit': the last event must be a stop",
    ),
    "a stop on the way": ({"events": [STOP, STOP]}, "events.0.do = 'stop': ends the run: only the last event is a stop"),
    "a feeder under an open outlet": (
        {
            "events": [
                {"when": "rest", "do": "open_slit"},
                {"when": "after", "value": 0.1, "do": "feed", "rate_kg_s": 1.0},
                STOP,
            ]
        },
        "events.1.do = 'feed': an outlet is open by then",
    ),
    "snapshots without end": (
        {"march__limit_s": 1e9, "record__snapshots_every_s": 0.1},
        "record.snapshots_every_s = 0.1: asks for 1e+10 snapshots until march.limit_s, 1e+09 s: at most 100,000",
    ),
    "keys beside a kind": ({"packing": {"kind": "rows", "rows": 3}}, "packing.across: is missing"),
    "a section as a whole": ({"discs__damping_ratio": 0.5}, "discs: give either normal_damping_N_s_m2 or"),
}


@pytest.mark.parametrize("case", REFUSED)
def test_a_refusal_names_file_key_and_value(case):
    changes, told = REFUSED[case]
    with pytest.raises(BadInput) as refused:
        scene_model(scene_of(**changes), Path(), "small.yaml")
    assert str(refused.value).startswith(f"small.yaml: {told}")
