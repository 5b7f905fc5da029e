# Figures and tables: one job draws all of a study that come from one cube, since a process takes longer to start than to draw.

def shown(name, key):
    """Files of an output, the first of them with its caption in the report."""
    return told(files_of(key, RESULTS / name, silos(name)), name, key)


def told(files, name, key):
    """Files of an output, the first of them with its caption in the report.

    Names are short there: the list beside a picture is as wide as its longest line and leaves the picture the rest.
    """
    first, *others = files
    labels = {"output": f"{key.replace('_', ' ')} ({OUTPUTS[key].kind})"}
    return [report(first, CAPTIONS[key].absolute(), name.replace("{", "{\u2060"), labels=labels), *others]  # no wildcard


def drawing(name, stage):
    """Outputs of a study that are drawn from one of its cubes, and the cubes that they show."""
    keys = [key for key in MODELS[name].outputs if OUTPUTS[key].stage == stage]
    also = {other for key in keys for other in OUTPUTS[key].also if other in MODELS[name].stages}
    return keys, [RESULTS / name / f"{one}.nc" for one in (stage, *sorted(also))]


for study in STUDIES:
    for stage in MODELS[study].stages:
        keys, cubes = drawing(study, stage)
        if keys:

            rule:
                name:
                    name_of_rule("draw", study, stage)
                input:
                    cubes,
                output:
                    [file for key in keys for file in shown(study, key)],
                params:
                    code=stamp("figures/style", *(f"figures/{key}" for key in keys)),
                    folder=RESULTS / study,
                    drawings=keys,
                    shown=[" ".join((*OUTPUTS[key].methods, *OUTPUTS[key].rules)) for key in keys],
                log:
                    RESULTS / study / f"logs/draw-{stage}.log",
                shell:
                    command("redraw {params.folder:q} {params.drawings:q}")


for scene in SCENES:
    if outputs := scene_outputs(scene):

        rule:
            name:
                name_of_rule("draw_scene", scene)
            input:
                RESULTS / "dem" / f"{scene}.nc",
            output:
                [file for key, files in outputs.items() for file in told(files, scene, key)],
            params:
                code=stamp("figures/style", *(f"figures/{key}" for key in outputs)),
                folder=RESULTS / "dem" / scene,
                drawings=list(outputs),
            log:
                RESULTS / "dem/logs" / f"draw-{scene}.log",
            shell:
                command("redraw {params.folder:q} {params.drawings:q} --cube {input[0]:q}")


if CAPTIONS:

    rule captions:
        """What the report says of each output."""
        output:
            CAPTIONS.values(),
        params:
            code=stamp("tables/outputs"),
        log:
            RESULTS / "captions/captions.log",
        shell:
            command("captions {output:q}")
