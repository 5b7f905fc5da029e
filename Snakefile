"""From studies to cubes to figures: `uv run snakemake --cores 2`, or `snakemake -n` to see what would be done."""

from pathlib import Path

from silostudy.config.load import load_project
from silostudy.config.study import SweepStudy
from silostudy.errors import BadInput
from silostudy.files import check_writable
from silostudy.figures import OUTPUTS
from silostudy.scene.expand import expand_file
from silostudy.stamp import STAGES, stamp

PROJECT = Path(config.get("project", "config/config.yaml"))
RESULTS = config.get("results", "results")

try:  # every mistake of every study is told before any job starts
    STUDIES, SCENES = load_project(PROJECT)
    EXPANSIONS = {name: expand_file(path) for name, path in STUDIES.items()}
    SWEEPS = [name for name, expansion in EXPANSIONS.items() if isinstance(expansion.study, SweepStudy)]
    for name, expansion in EXPANSIONS.items():
        asked = getattr(expansion.study, "earthquake", None)
        if asked and asked.study not in STUDIES:
            raise BadInput("earthquake.study", asked.study, f"must be named in {PROJECT} too", name)
    check_writable(Path(RESULTS))
except BadInput as error:
    raise WorkflowError(str(error)) from None


wildcard_constraints:
    study="|".join(STUDIES),
    scene="|".join(SCENES) or "none",
    figure="|".join(key for key, row in OUTPUTS.items() if row.kind == "figure"),
    table="|".join(key for key, row in OUTPUTS.items() if row.kind == "table"),


def study_files(wildcards):
    """The study file and the user's own files that it names."""
    path, expansion = STUDIES[wildcards.study], EXPANSIONS[wildcards.study]
    materials = getattr(expansion.study, "materials", None)
    return [path, *([path.parent / materials] if materials else []), *expansion.files]


def wanted(name):
    """Every file that a study asks for."""
    files = [f"{RESULTS}/{name}/cases.csv", *(f"{RESULTS}/{name}/{stage}.nc" for stage in EXPANSIONS[name].study.stages)]
    for key in EXPANSIONS[name].study.outputs:
        kind = OUTPUTS[key].kind
        endings = ("png", "svg", "csv") if kind == "figure" else ("csv",)
        files += [f"{RESULTS}/{name}/{kind}s/{key}.{ending}" for ending in endings]
    return files + ([f"{RESULTS}/{name}/parts/{EXPANSIONS[name].study.kind}-verdict"] if name in SWEEPS else [])


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


rule pressure:
    input:
        study_files,
    output:
        RESULTS + "/{study}/pressure.nc",
    params:
        code=stamp(*STAGES["pressure"]),
    log:
        RESULTS + "/{study}/logs/pressure.log",
    shell:
        "python -m silostudy pressure {input[0]} {output} > {log} 2>&1"


rule uncertainty:
    input:
        study_files,
    output:
        RESULTS + "/{study}/uncertainty.nc",
    params:
        code=stamp(*STAGES["uncertainty"]),
    log:
        RESULTS + "/{study}/logs/uncertainty.log",
    shell:
        "python -m silostudy uncertainty {input[0]} {output} > {log} 2>&1"


rule buckling:
    input:
        study_files,
    output:
        RESULTS + "/{study}/buckling.nc",
    params:
        code=stamp(*STAGES["buckling"]),
    log:
        RESULTS + "/{study}/logs/buckling.log",
    shell:
        "python -m silostudy buckling {input[0]} {output} > {log} 2>&1"


def earthquake_of(wildcards):
    """The seismic cube of the study that a shell study names; none where it names none."""
    asked = EXPANSIONS[wildcards.study].study.earthquake
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


rule seismic:
    input:
        study_files,
    output:
        RESULTS + "/{study}/seismic.nc",
    params:
        code=stamp(*STAGES["seismic"]),
    log:
        RESULTS + "/{study}/logs/seismic.log",
    shell:
        "python -m silostudy seismic {input[0]} {output} > {log} 2>&1"


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


rule grains:
    input:
        study_files,
    output:
        RESULTS + "/{study}/grains.nc",
    params:
        code=stamp(*STAGES["grains"]),
    log:
        RESULTS + "/{study}/logs/grains.log",
    shell:
        "python -m silostudy grains {input[0]} {output} > {log} 2>&1"


rule stability:
    input:
        study_files,
    output:
        RESULTS + "/{study}/stability.nc",
    params:
        code=stamp(*STAGES["stability"]),
    log:
        RESULTS + "/{study}/logs/stability.log",
    shell:
        "python -m silostudy stability {input[0]} {output} > {log} 2>&1"


def cubes_of(wildcards):
    """The cube that a figure or table is drawn from, and further ones that it shows where the study has them."""
    row = OUTPUTS[getattr(wildcards, "figure", None) or wildcards.table]
    stages = [row.stage, *(stage for stage in row.also if stage in EXPANSIONS[wildcards.study].study.stages)]
    return [f"{RESULTS}/{wildcards.study}/{stage}.nc" for stage in stages]


rule figure:
    input:
        cubes_of,
    output:
        report(RESULTS + "/{study}/figures/{figure}.png", category="{study}"),
        RESULTS + "/{study}/figures/{figure}.svg",
        RESULTS + "/{study}/figures/{figure}.csv",
    params:
        code=stamp(*STAGES["draw"]),
        stem=RESULTS + "/{study}/figures/{figure}",
    log:
        RESULTS + "/{study}/logs/{figure}.log",
    shell:
        "python -m silostudy draw {wildcards.figure} {input} {params.stem} > {log} 2>&1"


rule table:
    input:
        cubes_of,
    output:
        report(RESULTS + "/{study}/tables/{table}.csv", category="{study}"),
    params:
        code=stamp(*STAGES["draw"]),
        stem=RESULTS + "/{study}/tables/{table}",
    log:
        RESULTS + "/{study}/logs/{table}.log",
    shell:
        "python -m silostudy draw {wildcards.table} {input} {params.stem} > {log} 2>&1"


include: "silostudy/rules/sweep.smk"


rule gallery:
    """Refreshes the few pictures that the front README shows: `snakemake --cores 1 gallery`."""
    input:
        RESULTS + "/wheat-silo/figures/fig_4_2_11.png",
    output:
        "results/gallery/fig_4_2_11.png",
    shell:
        "cp {input} {output}"
