"""Command `silostudy list`: prints what there is to choose from."""

from pathlib import Path

from silostudy.commands.families import add_methods_from, families


def add(sub) -> None:
    command = sub.add_parser(
        "list",
        help="list kinds of study, methods, rules, laws and other parts of scenes, solids, walls, records, measurements, "
        "studies, outputs, problems or accuracies",
    )
    command.add_argument("what", choices=LISTS)
    command.add_argument("--studies", type=Path, default=Path("config/studies"), help="folder of study files")
    add_methods_from(command)
    command.set_defaults(run=run)


def run(chosen) -> None:
    for cells in LISTS[chosen.what](chosen):
        print("  ".join(cells))


def _kinds(chosen):
    from silostudy.stages import FILE_KINDS

    yield ("What a file says as `kind`, and under it the cubes that it makes in its folder of results:",)
    for kind in FILE_KINDS.values():
        yield f"{kind.key:10}", kind.title
        for stage in kind.stages:
            asked = f" (where the study has a section {stage.section})" if stage.section else ""
            yield " " * 10, f"{stage.key}.nc".ljust(14), stage.title + asked


def _methods(chosen):
    from silostudy.pressure import PRESSURE

    for row in families(chosen)[PRESSURE.name].values():
        yield (
            f"{row.key:22}",
            f"{row.title:32}",
            f"{', '.join(row.phases):20}",
            f"{row.source}, {row.locator}{' (one source: only where named)' * row.on_request}",
        )


def _buckling(chosen):
    from silostudy.buckling import BUCKLING, RIVALS

    known = families(chosen)
    for row in (*known[BUCKLING.name].values(), *known[RIVALS.name].values()):
        yield f"{row.key:28}", f"{row.title:26}", f"{row.source}, {row.locator}"


def _checks(chosen):
    from silostudy.checks import CHECKS

    for row in CHECKS.values():
        status = "one source, off by default" if row.one_source else ""
        yield f"{row.key:28}", f"{row.title:38}", f"{row.part:8}", f"{row.source}, {row.locator}", status


def _combinations(chosen):
    from silostudy.tables.combinations import COMBINATIONS

    for row in COMBINATIONS.values():
        factors = ", ".join(f"{name} {value:g}" for name, value in row.factors.items() if value)
        yield f"{row.key:4}", f"{row.title:34}", factors, f"{row.source}, {row.locator}"


def _load_cases(chosen):
    from silostudy.pressure.en1991_4.characteristic import described
    from silostudy.tables.load_cases import LOAD_CASES

    for row in LOAD_CASES.values():
        values = "; ".join(f"{name}: {described(name)}" for name in row.sets)
        state = f"{row.state} ({row.evidence})" if row.evidence else row.state
        yield f"{row.key:20}", f"{row.title:52}", f"{row.clause:12}", state, values, f"{row.source}, {row.locator}", row.remark


def _laws(chosen):
    from silostudy.contact import FAMILIES

    known = families(chosen)
    for section, family in FAMILIES.items():
        for row in known[family.name].values():
            yield (
                f"{section:10}",
                f"{row.key:24}",
                f"{row.title:40}",
                f"{', '.join(row.grains):15}",
                f"{row.source}, {row.locator}",
            )


def _parts_of_scenes(name: str):
    """The listing of a family that scenes choose from."""

    def listing(chosen):
        from silostudy.commands.explain_scene import grains_of, rows_of

        for row in rows_of(name).values():
            yield f"{row.key:24}", f"{', '.join(grains_of(name, row.key)):15}", row.title

    return listing


def _mass_rules(chosen):
    from silostudy.seismic.rules import MASS_RULES

    for row in MASS_RULES.values():
        yield f"{row.key:18}", f"{row.title:52}", f"{row.source}, {row.locator}"


def _materials(chosen):
    from math import isnan

    from silostudy.tables.materials import MATERIALS, PAIRS

    for row in MATERIALS.values():
        density = "" if isnan(row.density) else f"rho {row.density:g} kg/m3"
        properties = f"E {row.youngs_modulus / 1e6:g} MPa  nu {row.poissons_ratio:g}  {density}"
        yield f"{row.key:28}", f"{properties:44}", f"{row.title:36}", f"{row.source}, {row.locator}"
    for pair in PAIRS.values():
        properties = f"e {pair.restitution:g}  mu {pair.sliding_friction:g}  mu_r {pair.rolling_friction:g}"
        yield f"{pair.title:28}", f"{properties:44}", f"{'pair':36}", f"{pair.source}, {pair.locator}"


def _records(chosen):
    from silostudy.tables.records import RECORDS

    for row in RECORDS.values():
        yield f"{row.key:18}", row.title, f"{row.source}, {row.locator}", row.remark


def _measurements(chosen):
    from silostudy.tables.measured import measurements

    for row in measurements():
        what = f"{row.title}: {row.quantity} {row.told}"
        yield f"{row.measurement:24}", f"{row.kind:13}", what, f"{row.source}, {row.locator}", row.why_none


def _solids(chosen):
    from math import degrees

    from silostudy.tables.solids import SOLIDS

    for row in SOLIDS.values():
        properties = f"{row.unit_weight / 1e3:6.2f} kN/m3  phi {degrees(row.internal_friction_angle):4.1f} deg"
        yield f"{row.key:18}", f"{row.title:36}", f"{row.grain:12}", properties, f"{row.source}, {row.locator}"


def _walls(chosen):
    from silostudy.tables.walls import WALLS

    for row in WALLS.values():
        yield f"{row.key:18}", f"{row.title:38}", f"{row.rule:14}", f"{row.source}, {row.locator}"


def _studies(chosen):
    from silostudy.config.load import read_study
    from silostudy.errors import BadInput

    files = sorted(chosen.studies.glob("*.yaml"))
    if not files:
        raise BadInput("studies", str(chosen.studies), "holds no study files (*.yaml)")
    for file in files:
        yield f"{file.stem:18}", read_study(file).title


def _outputs(chosen):
    from silostudy.tables.outputs import OUTPUTS

    for row in OUTPUTS.values():
        wants = "one silo" if row.single_case else f"axes {', '.join(row.axes) or 'any'}"
        yield f"{row.key:30}", f"{row.kind:7}", f"{wants:28}", row.title


def _problems(chosen):
    from silostudy.tables.problems import PROBLEMS

    for row in PROBLEMS.values():
        yield f"{row.key:16}", f"{row.title:76}", f"{row.reference_kind}: {row.reference}"


def _accuracies(chosen):
    from silostudy.choice.fronts import FRONTS

    for row in FRONTS:
        by = f"x {row.scaled_by}" if row.scaled_by else ""
        yield f"{row.kind:9}", f"{row.quantity:26}", f"error {row.error:<9.3g}{by:18}", f"{row.cost:<9.3g} s", row.settings


LISTS = {
    "kinds": _kinds,
    "methods": _methods,
    "buckling": _buckling,
    "checks": _checks,
    "combinations": _combinations,
    "load-cases": _load_cases,
    "laws": _laws,
    **{
        name: _parts_of_scenes(name)
        for name in ("packings", "fillings", "inserts", "sizes", "integrators", "triggers", "actions", "rest", "quantities")
    },
    "mass-rules": _mass_rules,
    "solids": _solids,
    "walls": _walls,
    "materials": _materials,
    "records": _records,
    "measurements": _measurements,
    "studies": _studies,
    "outputs": _outputs,
    "problems": _problems,
    "accuracies": _accuracies,
}
