"""Studies of the checks made small, and their cubes."""

import yaml

from silostudy.compute.checks import checks_cube
from silostudy.compute.pressure import pressure_cube
from tests.conftest import ROOT, expanded

SLENDER = ROOT / "config/studies/steel-wheat-checks.yaml"


def study(levels=7, **changes) -> dict:
    content = yaml.safe_load(SLENDER.read_text(encoding="utf-8"))
    content["outputs"], content["relative_depth"]["count"] = [], levels
    del content["loads"]
    content["rules"], content["methods"] = ["en1993_4_1_2007", "en1993_1_6_2007"], ["en1991_4", "janssen"]
    for key, value in changes.items():
        place, *inner = key.split("__")
        held = content["scene"] if place in content["scene"] or place not in content else content
        if inner:
            held[place][inner[0]] = value
        else:
            held[place] = value
    return content


def cube_of(content):
    expansion = expanded(content)
    return checks_cube(expansion, pressure_cube(expansion))


def words(one, name):
    return one[name].attrs["flag_meanings"].split()[int(one[name])]
