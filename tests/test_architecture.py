"""Who may import whom, and that every stage's source stamp covers everything its numbers depend on."""

import ast
from pathlib import Path

import pytest

from silostudy.stamp import STAGES, stamp
from tests.conftest import ROOT

PACKAGE = ROOT / "silostudy"
BASE = {"catalogue", "errors", "files", "stamp", "__init__"}
# room -> the rooms it may import, besides the base
MAY_IMPORT = {
    "tables": set(),
    "pressure": {"tables"},
    "buckling": set(),
    "seismic": {"tables"},
    "figures": {"cube", "tables"},
    "contact": set(),
    "packing": set(),
    "dem": {"contact", "packing"},
    "config": {"tables", "pressure", "buckling", "figures", "contact", "dem"},
    "scene": {"config", "tables", "pressure", "seismic", "contact", "packing", "dem"},
    "cube": {"tables"},
    "accuracy": {"scene", "config", "tables", "pressure", "buckling", "seismic", "contact", "packing", "dem"},
    "compute": {"accuracy", "scene", "config", "tables", "pressure", "buckling", "seismic", "cube"}
    | {"contact", "packing", "dem"},
}
HEAVY_FREE = {
    "tables",
    "pressure",
    "buckling",
    "seismic",
    "figures/__init__.py",
    "config",
    "scene",
}  # quick to import: no xarray, no matplotlib
ENTRIES = {"cases": ["scene/expand.py"], "pressure": ["compute/pressure.py", "scene/expand.py"]}
ENTRIES["uncertainty"] = ["compute/uncertainty.py", "scene/expand.py"]
ENTRIES |= {stage: [f"compute/{stage}.py", "scene/expand.py"] for stage in ("buckling", "shell", "seismic", "grains")}
ENTRIES["dem"] = ["compute/dem.py", "compute/paraview.py"]
ENTRIES["draw"] = [f"figures/{path.name}" for path in sorted((PACKAGE / "figures").glob("*.py"))]


def imports(path: Path) -> set[str]:
    """Modules that a file imports, dotted."""
    found = set()
    for node in ast.walk(ast.parse(path.read_text())):
        if isinstance(node, ast.ImportFrom) and node.module:
            found.add(node.module)
            found |= {f"{node.module}.{alias.name}" for alias in node.names}
        elif isinstance(node, ast.Import):
            found |= {alias.name for alias in node.names}
    return found


def own_files(path: Path) -> set[Path]:
    """Files of the package that a file imports."""
    found = set()
    for name in imports(path):
        if name.split(".")[0] == "silostudy":
            stem = PACKAGE.joinpath(*name.split(".")[1:])
            found |= {file for file in (stem.with_suffix(".py"), stem / "__init__.py") if file.is_file()}
    return found


def room_of(path: Path) -> str:
    parts = path.relative_to(PACKAGE).parts
    return parts[0] if len(parts) > 1 else path.stem


@pytest.mark.parametrize("room", MAY_IMPORT)
def test_rooms_keep_to_the_architecture(room):
    files = sorted((PACKAGE / room).rglob("*.py"))
    assert files
    for path in files:
        rooms = {room_of(target) for target in own_files(path)} - BASE - {room}
        assert rooms <= MAY_IMPORT[room], f"{path.name} imports {sorted(rooms - MAY_IMPORT[room])}"


def test_light_rooms_stay_light():
    for place in HEAVY_FREE:
        for path in [PACKAGE / place] if place.endswith(".py") else (PACKAGE / place).rglob("*.py"):
            heavy = {name.split(".")[0] for name in imports(path)} & {"xarray", "matplotlib", "pandas"}
            assert not heavy, f"{path.relative_to(PACKAGE)} imports {heavy}"


@pytest.mark.parametrize("stage", ENTRIES)
def test_stamp_of_a_stage_covers_all_it_imports(stage):
    reached, fresh = set(), {PACKAGE / entry for entry in ENTRIES[stage]}
    while fresh:
        reached |= fresh
        fresh = {target for path in fresh for target in own_files(path)} - reached
    for path in reached:
        name = path.relative_to(PACKAGE).as_posix()
        covered = any(name == f"{room}.py" or name.startswith(f"{room}/") for room in STAGES[stage])
        assert covered or name in ("stamp.py", "__init__.py"), f"{name} is not in STAGES[{stage!r}]"


def test_stamp_sees_a_change(tmp_path, monkeypatch):
    (tmp_path / "room").mkdir()
    (tmp_path / "room/law.py").write_text("a = 1\n")
    monkeypatch.setattr("silostudy.stamp.PACKAGE", tmp_path)
    before = stamp("room")
    (tmp_path / "room/law.py").write_text("a = 2\n")
    assert stamp("room") != before
    with pytest.raises(FileNotFoundError, match="no room 'nowhere'"):
        stamp("nowhere")


def test_files_and_functions_keep_their_size():
    for path in PACKAGE.rglob("*.py"):
        text = path.read_text()
        assert text.count("\n") <= 300, path
        for node in ast.walk(ast.parse(text)):
            if isinstance(node, ast.FunctionDef):
                assert node.end_lineno - node.lineno <= 75, f"{path.name}: {node.name}"
