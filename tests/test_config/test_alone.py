"""A key or a choice that scenes of other grains know is refused as theirs, with its place there."""

import pytest

from silostudy.config.load import read_yaml, study_of
from silostudy.errors import BadInput
from tests.conftest import ROOT
from tests.test_dem.small import scene_of as discs_of
from tests.test_spheres.small import scene_of as spheres_of

STOP = {"when": "after", "value": 0.1, "do": "stop"}


def events(do, **given):
    return {"events": [{"when": "rest", "do": do, **given}, STOP]}


@pytest.mark.parametrize(
    ("scene_of", "changes", "told"),
    [
        (spheres_of, events("remove_disc"), "remove_disc is of scenes of discs alone"),
        (spheres_of, events("stop", disc=1), "disc is of scenes of discs alone"),
        (spheres_of, {"radius_m": 0.01}, "radius_m is of scenes of discs alone"),
        (spheres_of, {"spheres__damping_ratio": 0.1}, "damping_ratio is of scenes of discs alone, as discs.damping_ratio"),
        (spheres_of, {"spheres__normal": "line-contact"}, "line-contact is of scenes of discs alone, as discs.normal"),
        (
            spheres_of,
            {"spheres__tangential": "spring-slider-implicit"},
            "spring-slider-implicit is of scenes of discs alone, as discs.tangential",
        ),
        (spheres_of, {"silo__wedge": True}, "wedge is known as wedge"),
        (spheres_of, {"silo__lid": True}, "silo.lid is of scenes of discs alone, here it is lid"),
        (discs_of, events("take_away"), "take_away is of scenes of spheres alone"),
        (discs_of, {"packing": {"kind": "rain"}}, "rain is of scenes of spheres alone, as filling.kind"),
        (discs_of, {"sizes": {"kind": "normal"}}, "sizes is of scenes of spheres alone"),
        (discs_of, {"inserts": [{"kind": "cone"}]}, "cone is of scenes of spheres alone"),
        (discs_of, {"discs__material": "steel"}, "material is of scenes of spheres alone, as grain.material"),
        (discs_of, {"surfaces": {"floor": {"material": "steel"}}}, "material is of scenes of spheres alone, as grain.material"),
        (discs_of, {"outputs": ["bin_motion"]}, "bin_motion is of scenes of spheres alone"),
        (discs_of, {"discs__normal": "hrtz"}, ""),
        (discs_of, {"outpts": []}, ""),
    ],
)
def test_what_other_grains_know_is_told_so(scene_of, changes, told):
    with pytest.raises(BadInput) as refused:
        scene_of(**changes)
    line = str(refused.value).split("\n")[0]
    assert line.endswith(f"; {told}") if told else " alone" not in line


@pytest.mark.parametrize(
    ("study", "section", "key", "told"),
    [
        ("wheat-silo", "silo", "wedge", "wedge is of scenes of spheres alone, as wedge"),
        ("silo-of-spheres", "silo", "wedge", "wedge is known as scene.wedge"),
        (
            "silo-of-spheres",
            "spheres",
            "damping_ratio",
            "damping_ratio is of scenes of discs alone, as scene.discs.damping_ratio",
        ),
        ("hopper-of-discs", "discs", "material", "material is of scenes of spheres alone, as scene.grain.material"),
    ],
)
def test_studies_are_told_alike(study, section, key, told):
    path = ROOT / f"config/studies/{study}.yaml"
    content = read_yaml(path)
    content["scene"][section][key] = True
    with pytest.raises(BadInput) as refused:
        study_of(content, "s.yaml", path.parent)
    assert str(refused.value).startswith(f"s.yaml: scene.{section}.{key} = True: unknown key")
    assert str(refused.value).endswith(f"; {told}")
