"""The stages that the pipeline's rules call (`check`, `cases`, `pressure`, `uncertainty`, `draw`, `schema`); by hand too."""

from pathlib import Path

from silostudy.commands import grains, seismic, shells


def add(sub) -> None:
    check = sub.add_parser("check", help="validate a study and count its cases, without computing anything")
    check.add_argument("study", type=Path, help="a study file, or its name in config/studies")
    check.add_argument("--price", action="store_true", help="of a grains study: settle and time one filling")
    check.set_defaults(run=run_check)

    cases = sub.add_parser("cases", help="write the table of cases of a study")
    pressure = sub.add_parser("pressure", help="compute the pressure cube of a study")
    uncertainty = sub.add_parser("uncertainty", help="sample the solid's scatter through the methods of a study")
    stages = ((cases, run_cases, "CSV"), (pressure, run_pressure, "netCDF"), (uncertainty, run_uncertainty, "netCDF"))
    for command, run, what in stages:
        command.add_argument("study", type=Path)
        command.add_argument("output", type=Path, help=f"{what} file to write")
        command.set_defaults(run=run)

    draw = sub.add_parser("draw", help="draw a figure or table from a cube")
    draw.add_argument("key", help="see `silostudy list outputs`")
    draw.add_argument("cube", type=Path, nargs="+", help="the cube, and further ones that the figure can show")
    draw.add_argument("stem", type=Path, help="file to write, without its ending")
    draw.set_defaults(run=run_draw)

    redraw = sub.add_parser("redraw", help="draw figures and tables of a study anew")
    redraw.add_argument("folder", type=Path, help="results/STUDY")
    redraw.add_argument("keys", nargs="+", metavar="key", help="see `silostudy list outputs`")
    redraw.set_defaults(run=run_redraw)

    schema = sub.add_parser("schema", help="write the JSON schema of study files, for editors")
    schema.add_argument("output", type=Path)
    schema.set_defaults(run=run_schema)


def run_check(chosen) -> None:
    from silostudy.scene.expand import expand_file

    path = chosen.study if chosen.study.suffix else Path("config/studies") / f"{chosen.study}.yaml"
    expansion = expand_file(path)
    study = expansion.study
    axes = " x ".join(f"{axis.axis} {len(axis.settings())}" for axis in study.sweep) or "no sweep"
    print(f"{path}: {study.title}")
    print(f"  {len(expansion.cases)} case(s): {axes}")
    for line in (*counts(expansion), *cautions(expansion)) if "pressure" in study.stages else ():
        print(f"  {line}")
    for line in seismic.told(expansion) if "seismic" in study.stages else ():
        print(f"  {line}")
    for line in grains.told(expansion, chosen.price) if "grains" in study.stages else ():
        print(f"  {line}")
    for line in shells.told(expansion) if "shell" in study.stages else ():
        print(f"  {line}")
    if hasattr(study, "case_s"):
        print(f"  {price(expansion)}")
    if rules := getattr(study, "rule_keys", ()):
        print(f"  {len(rules)} buckling rule(s)")


def price(expansion) -> str:
    """About what a sweep costs: from the measured time of a case where the study states it, else from discs and steps."""
    from silostudy.scene.kinds import cost_of

    study, cost = expansion.study, cost_of(expansion.study.kind)
    seconds = sum(study.case_s or cost(case.scene) for case in expansion.cases)
    return f"at most about {seconds / 60:.3g} min of one core, a kernel's compiling apart"


def counts(expansion) -> list[str]:
    """How much a pressure study computes."""
    study = expansion.study
    methods = len(study.method_keys) + len(study.as_printed)
    values = len(expansion.cases) * methods * len(study.phases) * len(study.depths)
    return [f"{methods} method(s) x {len(study.phases)} phase(s) x {len(study.depths)} depths: {values} values a quantity"]


def cautions(expansion) -> list[str]:
    """What a study's author should know although it is no mistake."""
    from silostudy.scene.scene import solid_parameters

    found: dict[str, int] = {}
    for case in expansion.cases:
        parameters = solid_parameters(case.scene, "")
        wall = case.scene.wall.key if case.scene.wall else "its own wall friction"
        if parameters["wall_friction"] < parameters["wall_friction_uncapped"]:
            text = f"{case.scene.solid.key} on {wall}: wall friction {parameters['wall_friction_uncapped']:.3g} capped at "
            found[f"{text}tan(phi) = {parameters['wall_friction']:.3g}"] = 1
        for name in ("wall_friction", "poisson_ratio"):
            if parameters[name] != parameters[name]:
                text = f"{case.scene.solid.key} on {wall}: no {name} in the tables; methods that need it are masked"
                found[text] = 1
    return [f"note: {text}" for text in found]


def run_cases(chosen) -> None:
    import csv
    import json

    from silostudy.files import replacing
    from silostudy.scene.expand import expand_file

    expansion = expand_file(chosen.study)
    keys = list(expansion.cases[0].settings)
    with replacing(chosen.output) as temporary, temporary.open("w", newline="", encoding="utf-8") as stream:
        table = csv.writer(stream)
        table.writerow(["case", *keys])
        for case in expansion.cases:
            values = (case.settings[key] for key in keys)
            table.writerow(
                [case.id, *(value if isinstance(value, (str, int, float)) else json.dumps(value) for value in values)]
            )


def run_pressure(chosen) -> None:
    import time

    from silostudy.compute.pressure import pressure_cube
    from silostudy.cube.io import write
    from silostudy.scene.expand import expand_file

    expansion = expand_file(chosen.study)
    start = time.perf_counter()
    cube = pressure_cube(expansion)
    seconds = time.perf_counter() - start
    write(cube, chosen.output)
    size = cube["wall_normal_pressure"].size
    print(f"{expansion.name}: {len(expansion.cases)} case(s), {size} values a quantity in {seconds:.2f} s -> {chosen.output}")


def run_uncertainty(chosen) -> None:
    from silostudy.compute.uncertainty import uncertainty_cube
    from silostudy.cube.io import write
    from silostudy.errors import BadInput
    from silostudy.scene.expand import expand_file

    expansion = expand_file(chosen.study)
    if "uncertainty" not in expansion.study.stages:
        raise BadInput("uncertainty", None, "the study has no such section", str(chosen.study))
    write(uncertainty_cube(expansion), chosen.output)
    asked = expansion.study.uncertainty
    print(f"{expansion.name}: {2**asked.log2_samples} samples, seed {asked.seed} -> {chosen.output}")


def run_draw(chosen) -> None:
    from silostudy.cube.io import read

    _draw(chosen.key, [read(path) for path in chosen.cube], chosen.stem)


def run_redraw(chosen) -> None:
    from functools import cache

    from silostudy.cube.io import read
    from silostudy.figures import OUTPUTS

    once = cache(read)
    for key in chosen.keys:
        row = OUTPUTS[key]
        files = [chosen.folder / f"{stage}.nc" for stage in (row.stage, *row.also)]
        _draw(key, [once(file) for file in files[:1] + [file for file in files[1:] if file.exists()]],
              chosen.folder / f"{row.kind}s" / key)  # fmt: skip


def _draw(key: str, cubes: list, stem: Path) -> None:
    from importlib import import_module

    from silostudy.figures import OUTPUTS

    import_module(f"silostudy.figures.{OUTPUTS[key].key}").draw(cubes[0], stem, *cubes[1:])


def run_schema(chosen) -> None:
    from silostudy.config.schema import study_schema
    from silostudy.files import replacing

    with replacing(chosen.output) as temporary:
        temporary.write_text(study_schema(), encoding="utf-8")
