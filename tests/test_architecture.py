"""Who may import whom, and that every stage's source stamp covers everything its numbers depend on."""

import ast
import subprocess
import sys
from pathlib import Path
from pkgutil import resolve_name
from typing import Literal

import pytest

from silostudy.stages import FILE_KINDS, KINDS, STAGES
from silostudy.stamp import CHECKED, sources, stamp
from tests.conftest import ROOT

PACKAGE = ROOT / "silostudy"
BASE = {"catalogue", "soundness", "limits", "errors", "files", "say", "stages", "stamp", "__init__"}
# room -> the rooms it may import, besides the base
MAY_IMPORT = {
    "stages": set(),
    "tables": set(),
    "pressure": {"tables"},
    "buckling": set(),
    "checks": {"buckling"},
    "seismic": {"tables"},
    "figures": {"cube", "tables", "note"},
    "note": {"cube", "tables", "pressure", "buckling", "checks"},
    "explore": {"cube", "figures", "tables", "pressure", "buckling", "checks"},
    "contact": set(),
    "packing": set(),
    "dem": {"contact", "packing"},
    "config": {"tables", "pressure", "buckling", "checks", "contact", "packing", "dem"},
    "scene": {"config", "tables", "pressure", "checks", "seismic", "contact", "packing", "dem"},
    "cube": {"tables"},
    "choice": {"scene", "config", "contact", "packing", "tables", "pressure", "seismic"},
    "compute": {
        "choice",
        "scene",
        "config",
        "tables",
        "pressure",
        "buckling",
        "checks",
        "seismic",
        "cube",
        "contact",
        "packing",
        "dem",
    },
    "sweep": {"compute", "choice", "scene", "config", "cube"},
    "accuracy": {
        "compute",
        "choice",
        "scene",
        "config",
        "tables",
        "pressure",
        "buckling",
        "seismic",
        "cube",
        "contact",
        "packing",
        "dem",
    },
}
HEAVY_FREE = {
    "tables",
    "pressure",
    "buckling",
    "seismic",
    "stages",
    "config",
    "scene",
    "choice",
}  # quick to import: no xarray, no matplotlib
STAGES_OF_KINDS = [(kind, stage) for kind in FILE_KINDS for stage in FILE_KINDS[kind].stages]


def places(kind: str, stage) -> tuple[str, ...]:
    return FILE_KINDS[kind].places(stage)


def shipped(kind: str) -> Path | None:
    """A shipped study of a kind; the first in the alphabet."""
    files = sorted((ROOT / "config/studies").glob("*.yaml"))
    return next((file for file in files if f"kind: {kind}\n" in file.read_text()), None)


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


LOADED = """
import sys
from importlib import import_module
from pathlib import Path
from silostudy.choice.expand import expand_file
for name in sys.argv[2:]:
    import_module("silostudy." + name.replace("/", "."))
if sys.argv[1]:
    expand_file(Path(sys.argv[1]))
print(*(module.__file__ for name, module in sys.modules.items() if name.startswith("silostudy")), sep="\\n")
"""


def test_every_function_that_a_kind_names_is_there():
    for kind in FILE_KINDS.values():
        named = [kind.model, kind.builder, kind.traits, *kind.about, *kind.timed]
        for stage in kind.stages:
            named += stage.references
            assert all(other in STAGES for other in (*stage.reads, *stage.borrows.values()))
        assert all(callable(resolve_name(reference)) for reference in named if reference)
        assert kind.study.model_fields["kind"].annotation == Literal[kind.key]


def test_every_kind_of_study_has_a_shipped_study():
    assert all(shipped(kind) for kind in KINDS)


@pytest.mark.long
@pytest.mark.parametrize(("kind", "stage"), STAGES_OF_KINDS, ids=lambda value: getattr(value, "key", value))
def test_stamp_of_a_stage_covers_all_that_it_loads(kind, stage):
    """What Python really imports, a study of the kind expanded, is behind the stamp."""
    study, rooms = str(shipped(kind)) if kind in KINDS else "", places(kind, stage)
    done = subprocess.run([sys.executable, "-c", LOADED, study, *rooms], cwd=ROOT, capture_output=True, text=True, check=True)
    loaded = {Path(line) for line in done.stdout.split()}
    behind = set(sources(*rooms, "choice/expand", "tables/outputs")) | CHECKED
    assert len(loaded) > 10
    assert loaded <= behind, sorted(str(path.relative_to(PACKAGE)) for path in loaded - behind)


def test_a_stamp_covers_the_tables_that_its_code_names():
    names = {path.name for path in sources(*places("seismic", STAGES["seismic"]))}
    assert {"records.csv", "variables.csv", "references.bib"} <= names


def test_a_stamp_covers_nothing_else():
    """A change in the theories of wall pressure leaves discrete elements alone, and the other way round."""
    rooms = {
        stage.key: {path.relative_to(PACKAGE).parts[0] for path in sources(*places(kind, stage))}
        for kind, stage in reversed(STAGES_OF_KINDS)
    }
    assert not rooms["dem"] & {"pressure", "buckling", "seismic"}
    assert not rooms["grains"] & {"pressure", "buckling"}
    assert not rooms["pressure"] & {"dem", "contact", "packing", "buckling", "seismic"}


def test_measured_fronts_rerun_only_what_may_ask_for_an_accuracy():
    for kind, stage in STAGES_OF_KINDS:
        hangs = PACKAGE / "tables/fronts.csv" in sources(*places(kind, stage))
        assert hangs == bool(FILE_KINDS[kind].traits), f"{kind}, {stage.key}"


def test_what_is_computed_comes_with_its_settings_chosen():
    """A study as asked, its cases or not, stays within the rooms that make it."""
    for path in PACKAGE.rglob("*.py"):
        asked = {"silostudy.scene.expand.as_asked", "silostudy.scene.expand.file_as_asked"} & imports(path)
        assert not asked or room_of(path) in {"scene", "choice"}, f"{path.relative_to(PACKAGE)} imports {asked}"


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
