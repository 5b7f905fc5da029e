# Figures and tables: one job draws all of a study that come from one cube, since a process takes longer to start than to draw.

from silostudy.stamp import PACKAGE
from silostudy.tables.outputs import captions, files_of

CAPTIONS = captions(Path(RESULTS, "captions", stamp("tables/outputs"))) if workflow.is_main_process else {}


def shown(name, key):
    """Files of an output, the first of them with its caption in the report."""
    first, *others = files_of(key, f"{RESULTS}/{name}")
    row, category = OUTPUTS[key], f"{MODELS[name].title} ({name})"
    return [report(first, CAPTIONS.get(key), category, labels={"output": f"{row.title} ({row.kind})"}), *others]


def drawing(name, stage):
    """Outputs of a study that are drawn from one of its cubes, and the cubes that they show."""
    keys = [key for key in MODELS[name].outputs if OUTPUTS[key].stage == stage]
    also = {other for key in keys for other in OUTPUTS[key].also if other in MODELS[name].stages}
    return keys, [f"{RESULTS}/{name}/{one}.nc" for one in (stage, *sorted(also))]


for study in STUDIES:
    for stage in MODELS[study].stages:
        keys, cubes = drawing(study, stage)
        if keys:

            rule:
                name:
                    f"draw_{study}_{stage}".replace("-", "_")
                input:
                    cubes,
                output:
                    [file for key in keys for file in shown(study, key)],
                params:
                    code=stamp("figures/style", *(f"figures/{key}" for key in keys)),
                    folder=f"{RESULTS}/{study}",
                    drawings=keys,
                    python=sys.executable,
                log:
                    f"{RESULTS}/{study}/logs/draw-{stage}.log",
                shell:
                    command("redraw {params.folder:q} {params.drawings:q}")
