"""From studies to cubes to figures: `uv run snakemake --cores 2`, or `snakemake -n` to see what would be done."""

from functools import cache
from pathlib import Path

from silostudy.config.load import load_project, read_study
from silostudy.config.study import SweepStudy
from silostudy.errors import BadInput
from silostudy.files import alone, check_writable, end_future, remove_damaged
from silostudy.figures import OUTPUTS, files_of
from silostudy.scene.expand import expand_file
from silostudy.scene.plan import make_plan
from silostudy.stamp import STAGES, stamp

PROJECT = Path(config.get("project", "config/config.yaml"))
RESULTS = config.get("results", "results")
AT_ONCE = workflow.resource_settings.nodes or workflow.resource_settings.cores or 1  # jobs


@cache
def expansion(name):
    """A study with its cases."""
    return expand_file(STUDIES[name])


try:  # every mistake of every study is told before any job starts
    STUDIES, SCENES = load_project(PROJECT)
    MODELS = {name: read_study(path) for name, path in STUDIES.items()}
    SWEEPS = [name for name, model in MODELS.items() if isinstance(model, SweepStudy)]
    for name, model in MODELS.items():
        asked = getattr(model, "earthquake", None)
        if asked and asked.study not in STUDIES:
            raise BadInput("earthquake.study", asked.study, f"must be named in {PROJECT} too", name)
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
    """The study file and the user's own files that it names."""
    path, materials = STUDIES[wildcards.study], getattr(MODELS[wildcards.study], "materials", None)
    return [path, *([path.parent / materials] if materials else []), *expansion(wildcards.study).files]


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


rule cases:
    input:
        study_files,
    output:
        RESULTS + "/{study}/cases.csv",
    params:
        code=stamp(*STAGES["cases"]),
    log:
        RESULTS + "/{study}/logs/cases.log",
    shell:
        "python -m silostudy cases {input[0]} {output} > {log} 2>&1"


for stage in ("pressure", "uncertainty", "buckling", "seismic", "grains", "profile", "stability"):

    rule:
        name:
            stage
        input:
            study_files,
        output:
            f"{RESULTS}/{{study}}/{stage}.nc",
        params:
            code=stamp(*STAGES[stage]),
            stage=stage,
        log:
            f"{RESULTS}/{{study}}/logs/{stage}.log",
        shell:
            "python -m silostudy {params.stage} {input[0]} {output} > {log} 2>&1"


def earthquake_of(wildcards):
    """The seismic cube of the study that a shell study names; none where it names none."""
    asked = MODELS[wildcards.study].earthquake
    return f"{RESULTS}/{asked.study}/seismic.nc" if asked else []


rule shell:
    input:
        study_files,
        pressure=RESULTS + "/{study}/pressure.nc",
        earthquake=earthquake_of,
    output:
        RESULTS + "/{study}/shell.nc",
    params:
        code=stamp(*STAGES["shell"]),
    log:
        RESULTS + "/{study}/logs/shell.log",
    shell:
        "python -m silostudy shell {input[0]} {input.pressure} {output} {input.earthquake} > {log} 2>&1"


rule dem:
    input:
        lambda wildcards: SCENES[wildcards.scene],
    output:
        RESULTS + "/dem/{scene}.nc",
    params:
        code=stamp(*STAGES["dem"]),
    log:
        RESULTS + "/dem/logs/{scene}.log",
    shell:
        "python -m silostudy dem {input} {output} > {log} 2>&1"


rule accuracy:
    input:
        study_files,
    output:
        RESULTS + "/{study}/accuracy.nc",
    params:
        code=stamp(*STAGES["accuracy"]),
    threads: workflow.cores  # alone, as far as the pipeline goes: what it measures is time
    log:
        RESULTS + "/{study}/logs/accuracy.log",
    shell:
        "python -m silostudy accuracy {input[0]} {output} > {log} 2>&1"


include: "silostudy/rules/draw.smk"
include: "silostudy/rules/sweep.smk"
include: "silostudy/rules/packing.smk"


rule gallery:
    """Refreshes the few pictures that the front README shows: `snakemake --cores 1 gallery`."""
    input:
        RESULTS + "/wheat-silo/figures/fig_4_2_11.png",
    output:
        "results/gallery/fig_4_2_11.png",
    shell:
        "cp {input} {output}"
