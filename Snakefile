"""From studies to cubes to figures: `uv run snakemake --cores 2`, or `snakemake -n` to see what would be done."""

import sys
from functools import cache
from pathlib import Path

from silostudy.config.load import load_project, read_study
from silostudy.errors import BadInput
from silostudy.files import alone, check_writable, end_future, remove_damaged
from silostudy.choice.expand import expand_file
from silostudy.sweep.plan import make_plan
from silostudy.tables.outputs import OUTPUTS, files_of
from silostudy.stages import FILE_KINDS, KINDS, STAGES
from silostudy.stamp import stamp

PROJECT = Path(config.get("project", "config/config.yaml"))
RESULTS = config.get("results", "results")
AT_ONCE = workflow.resource_settings.nodes or workflow.resource_settings.cores or 1  # jobs


@cache
def expansion(name):
    """A study with its cases."""
    return expand_file(STUDIES[name])


def borrowed(model):
    """(section, study, stage) of each cube that a study takes from another one."""
    rows = [STAGES[stage].borrows for stage in model.stages]
    asked = [(section, getattr(model, section), stage) for row in rows for section, stage in row.items()]
    return [(section, given.study, stage) for section, given, stage in asked if given]


try:  # every mistake of every study is told before any job starts
    STUDIES, SCENES = load_project(PROJECT)
    MODELS = {name: read_study(path) for name, path in STUDIES.items()}
    SWEEPS = [name for name, model in MODELS.items() if KINDS[model.kind].parts]
    for name, model in MODELS.items():
        for section, other, _ in borrowed(model):
            if other not in STUDIES:
                raise BadInput(f"{section}.study", other, f"must be named in {PROJECT} too", name)
    if workflow.is_main_process:  # and not in the jobs that it starts elsewhere
        check_writable(Path(RESULTS))
        end_future(Path(RESULTS))
        for name in STUDIES:
            expansion(name)
            remove_damaged(Path(RESULTS, name))
        remove_damaged(Path(RESULTS, "dem"))
        for name in SWEEPS:
            make_plan(expansion(name), Path(RESULTS, name, "parts"), AT_ONCE)
except BadInput as error:
    raise WorkflowError(str(error)) from None


onstart:
    try:
        alone(Path(RESULTS))
    except BadInput as error:
        raise WorkflowError(str(error)) from None


report: "silostudy/rules/report.rst"


wildcard_constraints:
    study="|".join(STUDIES),
    scene="|".join(SCENES) or "none",


def study_files(wildcards):
    """The study file and the user's own files that it and its scenes name."""
    return [STUDIES[wildcards.study], *expansion(wildcards.study).files]


def wanted(name):
    """Every file that a study asks for."""
    model, folder = MODELS[name], f"{RESULTS}/{name}"
    cubes = [f"{folder}/{stage}.nc" for stage in model.stages]
    drawn = [file for key in model.outputs for file in files_of(key, folder)]
    return [f"{folder}/cases.csv", *cubes, *drawn, *([f"{folder}/parts/{model.kind}-verdict"] if name in SWEEPS else [])]


rule all:
    input:
        [file for name in STUDIES for file in wanted(name)],
        [f"{RESULTS}/dem/{name}.nc" for name in SCENES],


def code_of(stage=None):
    """Function of the wildcards that gives the hash of the sources behind a stage of a study, or behind its cases alone."""
    return lambda wildcards: KINDS[MODELS[wildcards.study].kind].stamp(stage)


def command(words):
    """A shell command that runs `silostudy` by this Python into the log, whose last line is shown where it fails."""
    return "{params.python:q} -m silostudy " + words + " > {log:q} 2>&1 || (tail -n 1 {log:q} >&2; false)"


rule cases:
    input:
        study_files,
    output:
        RESULTS + "/{study}/cases.csv",
    params:
        code=code_of(),
        python=sys.executable,
    log:
        RESULTS + "/{study}/logs/cases.log",
    shell:
        command("cases {input[0]:q} {output:q}")


def taken(stage):
    """Function of the wildcards that gives the cubes which a stage takes from the study itself and from others."""

    def cubes(wildcards):
        others = [f"{RESULTS}/{study}/{other}.nc" for _, study, other in borrowed(MODELS[wildcards.study])]
        return [f"{RESULTS}/{wildcards.study}/{other}.nc" for other in stage.reads], others if stage.borrows else []

    return cubes


for stage in STAGES.values():
    if stage.compute:

        rule:
            name:
                stage.key
            input:
                study_files,
                reads=lambda wildcards, stage=stage: taken(stage)(wildcards)[0],
                borrows=lambda wildcards, stage=stage: taken(stage)(wildcards)[1],
            output:
                f"{RESULTS}/{{study}}/{stage.key}.nc",
            params:
                code=code_of(stage),
                python=sys.executable,
                stage=stage.key,
            threads: workflow.cores if stage.alone else stage.threads
            log:
                f"{RESULTS}/{{study}}/logs/{stage.key}.log",
            benchmark:
                f"{RESULTS}/{{study}}/cost/{stage.key}.tsv"
            shell:
                command("{params.stage} {input[0]:q} {input.reads:q} {output:q} {input.borrows:q}")


rule dem:
    input:
        lambda wildcards: SCENES[wildcards.scene],
    output:
        RESULTS + "/dem/{scene}.nc",
    params:
        code=FILE_KINDS["dem"].stamp(STAGES["dem"]),
        python=sys.executable,
    log:
        RESULTS + "/dem/logs/{scene}.log",
    shell:
        command("dem {input[0]:q} {output:q}")


include: "silostudy/rules/draw.smk"
include: "silostudy/rules/sweep.smk"


rule gallery:
    """Refreshes the few pictures that the front README shows: `snakemake --cores 1 gallery`."""
    input:
        RESULTS + "/wheat-silo/figures/fig_4_2_11.png",
    output:
        "results/gallery/fig_4_2_11.png",
    shell:
        "cp {input} {output}"
