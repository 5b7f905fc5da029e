"""The kinds of study and their stages, a kind a file of this room: rules, commands, stamps, schema and tests loop over them."""

from importlib import import_module
from pkgutil import iter_modules

from silostudy.catalogue import Family
from silostudy.stages.family import Kind, Stage

_FILES = sorted(module.name for module in iter_modules(__path__) if module.name != "family")
FILE_KINDS: Family[Kind] = Family("kind", (import_module(f"{__name__}.{name}").KIND for name in _FILES))
KINDS: Family[Kind] = Family("kind", (kind for kind in FILE_KINDS.values() if kind.builder))  # studies, with cases
STAGES: Family[Stage] = Family("stage", dict.fromkeys(stage for kind in FILE_KINDS.values() for stage in kind.stages))


def called_for(study) -> tuple[str, ...]:
    """Keys of the cubes that a study asks for, in order: results/<study>/<stage>.nc."""
    return tuple(row.key for row in KINDS[study.kind].stages if not row.section or getattr(study, row.section))


def borrowed(study) -> list[tuple[str, str, str]]:
    """Section, study and stage of each cube that a study takes from another one."""
    asked = {section: stage for key in study.stages for section, stage in STAGES[key].borrows.items()}
    return [(section, getattr(study, section).study, stage) for section, stage in asked.items() if getattr(study, section)]
