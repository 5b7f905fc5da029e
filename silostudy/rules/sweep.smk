# Sweeps whose cases are costly: planned in parts, each computed by a job, merged into the cube of the study.

from silostudy.sweep.plan import DONE, read_plan


localrules:
    cases,
    verdict,


wildcard_constraints:
    part="[0-9a-f]+-[0-9a-f]+",
    sweep=one_of({MODELS[name].kind for name in SWEEPS}),


@cache
def plan_of(name):
    """The plan of a sweep; in a job that was started elsewhere, the one that was written for it."""
    return PLANS[name][0] if workflow.is_main_process else read_plan(RESULTS / name / "parts")


def marks(name):
    """A mark for every part of the plan."""
    return [RESULTS / name / f"parts/{part}{DONE}" for part in plan_of(name)]


def contents(wildcards):
    """A hash of the study and its cases in their order: what the cube holds."""
    rows = sorted(row for rows in plan_of(wildcards.study).values() for row in rows)
    return digest((MODELS[wildcards.study].model_dump_json(), rows))


rule part:
    output:
        touch(RESULTS / f"{{study}}/parts/{{part}}{DONE}"),
    params:
        study=lambda wildcards: STUDIES[wildcards.study],
        folder=lambda wildcards: RESULTS / wildcards.study / "parts",
    log:
        RESULTS / "{study}/logs/{part}.log",
    shell:
        "{PYTHON:q} -m silostudy part {params.study:q} {params.folder:q} {wildcards.part} 2>&1 | tee -a {log:q}"


rule merge:
    input:
        given(marks),
    output:
        RESULTS / "{study}/{sweep}.nc",
        RESULTS / "{study}/{sweep}-failed.csv",
    params:
        code=lambda wildcards: stamp("sweep/merge", *KINDS[wildcards.sweep].places(STAGES[wildcards.sweep])),
        study=lambda wildcards: STUDIES[wildcards.study],
        contents=contents,
        folder=lambda wildcards: RESULTS / wildcards.study / "parts",
    log:
        RESULTS / "{study}/logs/{sweep}.log",
    shell:
        command("merge {params.study:q} {params.folder:q} {output[0]:q}")


rule verdict:
    """Fails where cases failed, after everything else of the study is made."""
    input:
        RESULTS / "{study}/{sweep}-failed.csv",
    output:
        touch(RESULTS / "{study}/parts/{sweep}-verdict"),
    shell:
        "{PYTHON:q} -m silostudy verdict {input:q}"
