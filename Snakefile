"""From studies to cubes to figures: `uv run snakemake --cores 2`, or `snakemake -n` to see what would be done.

Nothing is written while this file is read: what a real run changes besides its jobs' outputs stands in `onstart`.
"""

import atexit
import sys
from itertools import chain
from pathlib import Path

from silostudy import PACKAGE
from silostudy.commands.failures import ending
from silostudy.config.load import check_lenders, load_project, read_study
from silostudy.cube.fingerprint import damaged
from silostudy.errors import BadInput
from silostudy.files import alone, check_sent, check_there, check_writable, end_future, set_aside
from silostudy.stages import FILE_KINDS, KINDS, STAGES, borrowed
from silostudy.stamp import stamp
from silostudy.sweep.plan import planned, write_plan
from silostudy.tables.outputs import OUTPUTS, files_of

PYTHON = sys.executable  # no parameter of a rule: with another one nothing has to be made again
AT_ONCE = workflow.resource_settings.nodes or workflow.resource_settings.cores or 1  # jobs


include: str(PACKAGE / "rules/names.smk")
include: str(PACKAGE / "rules/inputs.smk")


try:  # every mistake of every study is told before any job starts
    PROJECT, RESULTS = path_of("project", "config/config.yaml"), path_of("results", "results")
    STUDIES, SCENES = load_project(PROJECT)
    MODELS = {carried("studies", name): read_study(path) for name, path in STUDIES.items()}
    SWEEPS = [name for name, model in MODELS.items() if KINDS[model.kind].parts]
    WANTED = [file for name in STUDIES for file in wanted(name)]
    WANTED += [RESULTS / "dem" / f"{carried('scenes', name)}.nc" for name in SCENES]
    WANTED += [Path(file) for name in SCENES for files in scene_outputs(name).values() for file in files]
    ASKED = [*(model.outputs for model in MODELS.values()), *map(scene_outputs, SCENES)]
    CAPTIONS = {key: RESULTS / "captions" / f"{key}.rst" for outputs in ASKED for key in outputs}
    if SCENES and "dem" in STUDIES:
        raise BadInput("studies", "dem", "the folder of this name is for scenes: rename the study", str(PROJECT))
    for name, model in MODELS.items():
        check_lenders(name, model, STUDIES, PROJECT)
    PLANS, DAMAGED = {}, []
    if workflow.is_main_process:  # and not in the jobs that it starts elsewhere
        check_writable(RESULTS)
        for name in STUDIES:
            check_there(file for file in study_files(name) if file not in made_here().values())
        for name in SCENES:
            check_there(scene_files(name))
        PLANS = {name: planned(expansion(name), RESULTS / name / "parts", AT_ONCE) for name in SWEEPS}
        DAMAGED = damaged(WANTED)
    UNSOUND = [str(file) for file in chain(DAMAGED, *(marks for _, marks in PLANS.values()))]
except BadInput as error:
    raise WorkflowError(str(error)) from None


onstart:
    try:
        if workflow.non_local_exec:
            check_sent([*STUDIES, *SCENES], [PROJECT, RESULTS, Path.cwd()])
        alone(RESULTS)
    except BadInput as error:
        raise WorkflowError(str(error)) from None
    end_future(RESULTS)
    for path in DAMAGED:
        set_aside(path)
    for name, (plan, _) in PLANS.items():
        write_plan(plan, RESULTS / name / "parts")


onerror:
    if workflow.is_main_process:  # said last, after all of Snakemake's own
        atexit.register(print, *ending("".join(Path(file).read_text() for file in log), sys.argv), sep="\n", file=sys.stderr)


report: str(PACKAGE / "rules/report.rst")


wildcard_constraints:
    study=one_of(STUDIES),
    scene=one_of(SCENES),


rule all:
    input:
        WANTED,
        CAPTIONS.values(),


def code_of(stage):
    """Function of the wildcards that gives the hash of the sources behind a stage of a study."""
    return lambda wildcards: KINDS[MODELS[wildcards.study].kind].stamp(stage)


def command(words):
    """A shell command that runs `silostudy` by this Python into the log, whose last line is shown where it fails."""
    return "{PYTHON:q} -m silostudy " + words + " > {log:q} 2>&1 || (tail -n 1 {log:q} >&2; false)"


rule cases:
    input:
        given(study_files),
    output:
        RESULTS / "{study}/cases.csv",
    params:
        holds=lambda wildcards: cases_held(wildcards.study),
        given=held(study_files),
    log:
        RESULTS / "{study}/logs/cases.log",
    shell:
        command("cases {input[0]:q} {output:q}")


def taken(stage):
    """Function of the wildcards that gives the cubes which a stage takes from the study itself and from others."""

    def cubes(wildcards):
        others = [one for one in borrowed(MODELS[wildcards.study]) if one[0] in stage.borrows]
        borrows = [RESULTS / study / f"{other}.nc" for _, study, other in others]
        return [RESULTS / wildcards.study / f"{other}.nc" for other in stage.reads], borrows

    return cubes


for stage in STAGES.values():
    if stage.compute:

        rule:
            name:
                stage.key
            input:
                given(study_files),
                reads=lambda wildcards, stage=stage: taken(stage)(wildcards)[0],
                borrows=lambda wildcards, stage=stage: taken(stage)(wildcards)[1],
            output:
                RESULTS / f"{{study}}/{stage.key}.nc",
            params:
                code=code_of(stage),
                given=held(study_files),
                stage=stage.key,
            threads: workflow.cores if stage.alone else stage.threads
            log:
                RESULTS / f"{{study}}/logs/{stage.key}.log",
            benchmark:
                RESULTS / f"{{study}}/cost/{stage.key}.tsv"
            shell:
                command("{params.stage} {input[0]:q} {input.reads:q} {output:q} {input.borrows:q}")


rule dem:
    input:
        given(scene_files),
    output:
        RESULTS / "dem/{scene}.nc",
    params:
        code=FILE_KINDS["dem"].stamp(STAGES["dem"]),
        given=held(scene_files),
    log:
        RESULTS / "dem/logs/{scene}.log",
    shell:
        command("dem {input[0]:q} {output:q}")


include: str(PACKAGE / "rules/draw.smk")
include: str(PACKAGE / "rules/sweep.smk")


PICTURES = {  # that the guides show -> study
    "fig_4_2_11": "wheat-silo",
    "peaks_over_area": "silo-of-spheres-hopper",
    "flow_in_silos": "silo-of-spheres-hopper",
    "switch_in_time": "silo-of-spheres-switch",
}


rule gallery:
    """Refreshes the pictures that the guides show, those of the project's studies: `snakemake --cores 1 gallery`."""
    input:
        [RESULTS / study / f"figures/{key}.png" for key, study in PICTURES.items() if study in STUDIES],
    shell:
        "cp {input:q} results/gallery"
