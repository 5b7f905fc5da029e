"""Test over prediction by rule and reading of the source: mean, scatter, least and largest by group of tests."""

from pathlib import Path

import pandas as pd
import xarray as xr

from silostudy.figures.rules import GROUPS, group, is_rival, name
from silostudy.figures.style import save_table

ALL = {"small, all": ("unstiffened", "ringed"), **{label: (key,) for key, (_, label) in GROUPS.items()}}


def draw(cube: xr.Dataset, stem: Path) -> None:
    """Writes a row for each rule and group."""
    save_table(statistics(cube), stem.with_suffix(".csv"))


def statistics(cube: xr.Dataset) -> pd.DataFrame:
    """The statistics of test over prediction; tests that a rule does not cover are counted as masked."""
    groups = group(cube)
    ratio = cube["test_lower_buckling_stress"] / cube["buckling_stress"]
    rows = []
    for rule in map(str, cube["rule"].values):
        for label, members in ALL.items():
            values = pd.Series(
                ratio.sel({"rule": rule}).values[[kind in members for kind in groups]], cube_tests(cube, members)
            )
            rows.append(
                {"rule": rule, "title": name(cube, rule), "rival": is_rival(cube, rule), "group": label, **_summary(values)}
            )
    return pd.DataFrame(rows)


def cube_tests(cube: xr.Dataset, members: tuple[str, ...]) -> list[str]:
    """Names of the tests that belong to some groups."""
    return [str(test) for test, kind in zip(cube["test"].values, group(cube), strict=True) if kind in members]


def _summary(values: pd.Series) -> dict:
    known = values.dropna()
    return {
        "tests": len(known),
        "masked": len(values) - len(known),
        "mean": known.mean(),
        "cov": known.std(ddof=1) / known.mean() if len(known) > 1 else float("nan"),
        "min": known.min(),
        "max": known.max(),
        "weakest_test": known.idxmin() if len(known) else "",
    }
