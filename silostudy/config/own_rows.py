"""Reads a Python file of the user's own: its rows join the families of one study, and no other study sees them.

The file declares ROW or ROWS as a module of the package does.  It is run anew for every content that it has, under a name of
its own, and leaves no compiled file behind.
"""

import ast
import hashlib
import sys
import traceback
from collections.abc import Iterable
from dataclasses import replace
from functools import lru_cache
from importlib.util import find_spec
from pathlib import Path
from types import ModuleType

import silostudy
from silostudy.catalogue import Family, Row, declared
from silostudy.errors import BadInput
from silostudy.tables.references import own_references, own_source

INSTALLED = [Path(home).resolve() for home in (sys.prefix, sys.base_prefix, Path(silostudy.__file__).parent)]
Families = dict[str, Family]  # by the name of the family


def joined(families: Iterable[Family], path: Path, where: str = "") -> Families:
    """The families with the rows of a user's file; BadInput names file, row and what is wrong with it."""
    rows, shipped = own_rows(path, where), {family.name: family for family in families}
    joint = {name: family.joined(_joining(family, rows, path, where)) for name, family in shipped.items()}
    if all(len(joint[name]) == len(family) for name, family in shipped.items()):
        raise _refused(path, f"holds no {' and no '.join(joint)}", where)
    return joint


def _joining(family: Family, rows: Iterable[Row], path: Path, where: str) -> list[Row]:
    mine, taken = [row for row in rows if family.takes(row)], set(family)
    for row in mine:
        if row.key in taken:
            raise _refused(path, f"row {row.key}: this key is already taken by another {family.name}", where)
        taken.add(row.key)
    return mine


def own_rows(path: Path, where: str = "") -> tuple[Row, ...]:
    """The rows of a user's file, each sound; BadInput for a file that cannot be read or run, or a row with a fault."""
    try:
        content = path.read_bytes()
    except OSError as error:
        raise _refused(path, f"must be a readable Python file ({error.strerror})", where) from None
    return _rows(path, content, own_references(path), where)


@lru_cache(maxsize=64)  # the scenes of a sweep are validated one by one
def _rows(path: Path, content: bytes, references: str, where: str) -> tuple[Row, ...]:
    module = vars(_run(path, content, where))
    if not isinstance(module.get("ROWS", ()), (tuple, list)):
        raise _refused(path, "ROWS must be a tuple or a list of rows", where)
    rows = declared(module)
    if not rows:
        raise _refused(path, "declares neither ROW nor ROWS", where)
    return tuple(_sound(row, path, content, references, where) for row in rows)


def _refused(path: Path, why: str, where: str) -> BadInput:
    return BadInput("methods_from", path.name, why, where)


def _digest(content: bytes) -> str:
    return hashlib.sha256(content).hexdigest()[:12]


def _run(path: Path, content: bytes, where: str) -> ModuleType:
    name = f"silostudy_own_{_digest(str(path.absolute()).encode() + content)}"
    if name in sys.modules:
        return sys.modules[name]
    module = ModuleType(name)
    module.__file__ = str(path)
    sys.modules[name] = module  # dataclasses and pickle look there
    try:
        tree = ast.parse(content, str(path))
        for node in ast.walk(tree):
            _check_import(node, path, where)
        exec(compile(tree, str(path), "exec"), vars(module))
    except BadInput:
        del sys.modules[name]
        raise
    except (Exception, SystemExit) as error:
        del sys.modules[name]
        line = _line(error, path)
        raise _refused(path, f"line {line}: {_one_line(error)}" if line else _one_line(error), where) from None
    return module


def _check_import(node: ast.AST, path: Path, where: str) -> None:
    """BadInput for an import of another file of the user's own: a change in it would not be seen."""
    names = [alias.name for alias in node.names] if isinstance(node, ast.Import) else []
    if isinstance(node, ast.ImportFrom):
        names = ["." * node.level + (node.module or "")]
    for name in names:
        if name.startswith(".") or _beside(name.split(".")[0], path.parent):
            why = "is no installed package, and a change in it would not be seen: put what it holds into this file"
            raise _refused(path, f"line {node.lineno}: imports {name}, which {why}", where)  # type: ignore[attr-defined]


def _beside(top: str, folder: Path) -> bool:
    """Whether a module would come from the folder of the user's file, or from where the command runs."""
    spec = find_spec(top)
    if spec is None:
        return (folder / f"{top}.py").exists() or (folder / top).is_dir()
    places = [Path(place).resolve() for place in (spec.submodule_search_locations or [spec.origin or ""])]
    near = [place for place in (folder.resolve(), Path.cwd()) if any(file.is_relative_to(place) for file in places)]
    return bool(near) and not any(file.is_relative_to(home) for file in places for home in INSTALLED)


def _line(error: BaseException, path: Path) -> int | None:
    """The line of the user's file at which running it failed."""
    if isinstance(error, SyntaxError) and error.filename == str(path):
        return error.lineno
    frames = traceback.extract_tb(error.__traceback__)
    return next((frame.lineno for frame in reversed(frames) if frame.filename == str(path)), None)


def _one_line(error: BaseException) -> str:
    text = error.msg if isinstance(error, SyntaxError) else str(error)
    return f"{type(error).__name__}: {' '.join(str(text).split())}"


def _sound(row: object, path: Path, content: bytes, references: str, where: str) -> Row:
    """The row with its origin, and its source as `cite` takes it."""
    if not isinstance(row, Row):
        raise _refused(path, f"ROWS holds {row!r:.60}: must be rows of a family", where)
    try:
        fault = next(row.faults(), None)
    except Exception as error:  # a field of a kind that no check expects
        fault = _one_line(error)
    if fault:
        raise _refused(path, f"row {row.key}: {fault}", where)
    told = f"{where}: methods_from = {path.name!r}: row {row.key}".removeprefix(": ")
    source = own_source(row.source, path, references, told)
    return replace(row, source=source, origin=f"{path.name} {_digest(content)}")
