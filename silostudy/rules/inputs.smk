# What the rules read and make: files of the user's own, cubes of other studies, and everything that a study asks for.

import hashlib
from functools import cache
from os.path import abspath

import numpy as np

from silostudy.choice.expand import expand_file
from silostudy.cube.silos import named
from silostudy.scene.scenes import files_of_scene, outputs_of_scene


def cases_held(name):
    """A hash of the cases of a study, where they can be known before anything is made."""
    return "" if waits(name) else digest([(case.id, case.settings) for case in expansion(name).cases])


def digest(content):
    """A short hash of what a file will hold, where many sources stand behind it and few of their changes change it."""
    return hashlib.sha256(str(content).encode()).hexdigest()[:12]


@cache
def expansion(name):
    """A study with its cases."""
    return expand_file(STUDIES[name])


@cache
def made_here():
    """Absolute path -> file of every output of a study of the project that is one file: another study may be made from it."""
    outputs = ((name, key) for name, model in MODELS.items() for key in model.outputs if not OUTPUTS[key].per_silo)
    return {abspath(file): Path(file) for name, key in outputs for file in files_of(key, RESULTS / name)}


def named_by(name):
    """The user's own files that a study itself names; one that the pipeline makes as the pipeline knows it."""
    files = MODELS[name].named_files(STUDIES[name].parent)
    return [made_here().get(abspath(file), file) for file in files]


def waits(name):
    """Whether a study is made from what another one makes, such as a laboratory's solid: its cases are built once it is there."""
    return not set(named_by(name)).isdisjoint(made_here().values())


def silos(name):
    """The cases that name the silos of a study, where an output is of one silo; none else, since they have to be looked for."""
    if not any(OUTPUTS[key].per_silo for key in MODELS[name].outputs):
        return []
    if waits(name):
        raise BadInput("outputs", "a note of each silo", "the study waits for another's solid: no silo of it is known yet", name)
    cases = np.array([case.id for case in expansion(name).cases]).reshape(expansion(name).shape)
    return named(cases, [axis.axis for axis in MODELS[name].sweep])


def study_files(name):
    """The study file and the user's own files that it and its scenes name."""
    return [STUDIES[name], *(named_by(name) if waits(name) else expansion(name).files)]


def scene_files(name):
    """The scene file and the user's own files that it names."""
    return [SCENES[name], *files_of_scene(SCENES[name])]


def scene_outputs(name):
    """Figures that a scene asks for, and the files of each."""
    return {key: files_of(key, RESULTS / "dem" / name) for key in outputs_of_scene(SCENES[name])}


def given(files):
    """Input function of a rule from that of a study's or scene's name, the first of its wildcards.

    It also tells Snakemake, which looks at times alone, what is there but not whole: a dry run plans it and touches nothing.
    """

    def inputs(wildcards):
        workflow.dag.forcefiles.update(UNSOUND)
        return files(wildcards[0])

    return inputs


def held(files):
    """Function of the wildcards that gives a hash of what the user's own files hold: one put in place may be older than results.

    What the pipeline itself makes is an input as any other.
    """
    made = made_here().values()
    return lambda wildcards: digest([file.read_bytes() for file in files(wildcards[0]) if file not in made])


def wanted(name):
    """Every file that a study asks for."""
    model, folder = MODELS[name], RESULTS / name
    cubes = [folder / f"{stage}.nc" for stage in model.stages]
    drawn = [Path(file) for key in model.outputs for file in files_of(key, folder, silos(name))]
    swept = [folder / f"{model.kind}-failed.csv", folder / f"parts/{model.kind}-verdict"] if name in SWEEPS else []
    return [folder / "cases.csv", *cubes, *drawn, *swept]
