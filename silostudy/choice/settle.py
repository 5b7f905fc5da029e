"""Chooses the settings of what asks for an accuracy, once its scenes are known, and puts them in."""

from collections.abc import Sequence
from dataclasses import replace
from pkgutil import resolve_name
from typing import Any, TypeVar

from silostudy.choice.choose import choose
from silostudy.choice.promise import Choice
from silostudy.config.asked import Asked, put
from silostudy.config.load import validated
from silostudy.config.own import OwnMethods
from silostudy.errors import within
from silostudy.scene.expand import Case, Expansion, identity
from silostudy.stages import FILE_KINDS
from silostudy.tables.asked import quantities

A = TypeVar("A", bound=Asked)


def settled(asking: A, scenes: Sequence[Any], where: str) -> tuple[A, Choice]:
    """A study or scene with the settings chosen for it, and the choice; BadInput where scenes or errors were not measured."""
    assert asking.accuracy
    known = quantities(asking.fronts)
    by_front = {name: error for name, error in asking.accuracy.items() if known[name].decides}
    if not by_front:
        return asking, Choice(asking.accuracy, {}, {}, "by the runs themselves")
    traits = resolve_name(FILE_KINDS[asking.kind].traits)
    with within(where):
        choice = choose(asking.fronts, by_front, traits(asking, scenes))
    return with_settings(asking, choice.settings, where), replace(choice, asked=asking.accuracy)


def with_settings(asking: A, settings: dict[str, Any], where: str) -> A:
    """A model with the settings that it left open, validated as if they had been given."""
    content = asking.model_dump(exclude_unset=True, exclude={"accuracy"})
    for key, value in settings.items():
        put(content, key, value)
    families = asking.families if isinstance(asking, OwnMethods) else None
    return validated(type(asking), content, where, families).model_copy(update={"accuracy": asking.accuracy})


def settled_case(case: Case, where: str) -> tuple[Case, Choice | None]:
    """A case of a sweep of scenes with the settings chosen for its scene; as it is where it does not ask."""
    config = case.scene.config
    if not config.accuracy:
        return case, None
    config, choice = settled(config, [config], where)
    return replace(case, id=identity(config), scene=replace(case.scene, config=config)), choice


def settled_study(expansion: Expansion, where: str) -> tuple[Any, tuple[Case, ...], tuple[Choice, ...]]:
    """Study, cases and choices of an expansion: one choice for a study that asks, one for each scene that does."""
    study = expansion.study
    if isinstance(study, Asked):
        study, choice = settled(study, [case.scene for case in expansion.cases], where)
        return study, expansion.cases, (choice,)
    if study.scene.accuracy:  # the base scene
        study = study.model_copy(update={"scene": settled(study.scene, [study.scene], f"{where} (scene)")[0]})
    pairs = [settled_case(case, f"{where} (scene)") for case in expansion.cases]
    return study, tuple(case for case, _ in pairs), tuple(choice for _, choice in pairs if choice)
