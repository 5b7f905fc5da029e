# Sweeps whose cases are costly: planned in parts, each computed by a job, merged into the cube of the study.

import hashlib

from silostudy.sweep.plan import DONE, read_plan


localrules:
    cases,
    verdict,


wildcard_constraints:
    part="[0-9a-f]+-[0-9a-f]+",
    sweep="|".join({MODELS[name].kind for name in SWEEPS}) or "none",


def marks(wildcards):
    """A mark for every part of the plan."""
    folder = Path(RESULTS, wildcards.study, "parts")
    return [f"{folder}/{part}{DONE}" for part in read_plan(folder)]


def contents(wildcards):
    """A hash of the study and its cases in their order: what the cube holds."""
    plan = read_plan(Path(RESULTS, wildcards.study, "parts"))
    rows = sorted(row for rows in plan.values() for row in rows)
    return hashlib.sha256(f"{MODELS[wildcards.study].model_dump_json()} {rows}".encode()).hexdigest()[:12]


rule part:
    output:
        touch(RESULTS + "/{study}/parts/{part}" + DONE),
    params:
        study=lambda wildcards: STUDIES[wildcards.study],
        folder=RESULTS + "/{study}/parts",
        python=sys.executable,
    log:
        RESULTS + "/{study}/logs/{part}.log",
    shell:
        "{params.python:q} -m silostudy part {params.study:q} {params.folder:q} {wildcards.part} 2>&1 | tee -a {log:q}"


rule merge:
    input:
        marks,
    output:
        RESULTS + "/{study}/{sweep}.nc",
        RESULTS + "/{study}/{sweep}-failed.csv",
    params:
        code=lambda wildcards: stamp("sweep/merge", *KINDS[wildcards.sweep].places(STAGES[wildcards.sweep])),
        study=lambda wildcards: STUDIES[wildcards.study],
        contents=contents,
        folder=RESULTS + "/{study}/parts",
        python=sys.executable,
    log:
        RESULTS + "/{study}/logs/{sweep}.log",
    shell:
        command("merge {params.study:q} {params.folder:q} {output[0]:q}")


rule verdict:
    """Fails where cases failed, after everything else of the study is made."""
    input:
        RESULTS + "/{study}/{sweep}-failed.csv",
    output:
        touch(RESULTS + "/{study}/parts/{sweep}-verdict"),
    params:
        python=sys.executable,
    shell:
        "{params.python:q} -m silostudy verdict {input:q}"
