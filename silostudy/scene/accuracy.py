"""The one case of an accuracy study: what is to be measured, as it was asked."""

from collections.abc import Callable
from pathlib import Path
from typing import Any

from silostudy.config.accuracy import AccuracyStudy, Measuring


def accuracy_builder(study: AccuracyStudy, folder: Path, where: str) -> Callable[[Measuring, dict], Measuring]:
    """Problems hold their own scenes, so there is nothing to build."""

    def build_one(config: Measuring, settings: dict[str, Any]) -> Measuring:
        return config

    return build_one
