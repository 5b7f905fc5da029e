"""Command `silostudy export STUDY FOLDER`: load cases as tables, a netCDF file for finite elements, and CalculiX decks."""

from pathlib import Path

SHOWN = 6  # ids of cases in a message
LEVELS = 201  # of the tables, on wall and hopper
DEGREES = 5.0  # step of the tables where a load waves round the wall


def add(sub) -> None:
    command = sub.add_parser(
        "export",
        help="write load cases of a pressure or shell study for finite elements: pressure and friction over depth and angle",
    )
    command.add_argument("study", type=Path, help="a study file, or its name in config/studies")
    command.add_argument("folder", type=Path, help="folder to write loads.nc and a CSV file for each load case into")
    command.add_argument("--case", metavar="ID", help="of a study with sweep: which silo (`silostudy cases`)")
    command.add_argument(
        "--load-case", nargs="+", metavar="KEY", help="see `silostudy list load-cases`; left out: all computed"
    )
    command.add_argument("--values", nargs="+", metavar="SET", help="sets of characteristic values; left out: all")
    command.add_argument("--deck", action="store_true", help="also write an input deck of CalculiX for each (shell studies)")
    command.add_argument("--element-size", type=float, default=0.5, metavar="M", help="of the deck's shells (m), usually 0.5")
    command.set_defaults(run=run)


def run(chosen) -> None:
    from silostudy.commands.studies import path_of
    from silostudy.compute.calculix import deck
    from silostudy.compute.loads import loads_cube, with_loads
    from silostudy.cube.io import write
    from silostudy.cube.load import load_case
    from silostudy.errors import BadInput
    from silostudy.figures.style import save_table
    from silostudy.files import check_writable, replacing

    check_writable(chosen.folder)
    expansion = with_loads(path_of(chosen.study))
    scene = _scene(expansion, chosen.case)
    _check(chosen)
    cube = loads_cube(expansion)
    wanted = _wanted(cube, chosen)
    loads = {f"{key}-{values}": load_case(cube, key, values, chosen.case) for key, values in wanted}
    decks = {name: deck(load, scene, size=chosen.element_size) for name, load in loads.items()} if chosen.deck else {}
    if (chosen.folder / "loads.nc").exists():  # its files would stand beside the new ones as if they belonged together
        raise BadInput("folder", str(chosen.folder), "must be a new one: it holds an earlier export")
    write(cube, chosen.folder / "loads.nc")
    for name, load in loads.items():
        save_table(_table(load), chosen.folder / f"{name}.csv")
    for name, text in decks.items():
        with replacing(chosen.folder / f"{name}.inp") as temporary:
            temporary.write_text(text, encoding="utf-8")
    print(f"{expansion.name}: {len(loads)} load(s){f', {len(decks)} deck(s)' if decks else ''} -> {chosen.folder}")


def _table(load):
    from math import radians

    from pandas import DataFrame

    return DataFrame(load.columns(levels=LEVELS, step=radians(DEGREES)))


def _scene(expansion, case: str | None):
    """The silo that a call names; BadInput lists the known ones."""
    from silostudy.errors import BadInput

    if not expansion.shape and case is None:
        return expansion.cases[0].scene
    known = {known_case.id: known_case.scene for known_case in expansion.cases}
    if case not in known:
        ids, count = ", ".join(list(known)[:SHOWN]), len(known)
        told = f"{ids}{f' and {count - SHOWN} more, see `silostudy cases`' if count > SHOWN else ''}"
        raise BadInput("--case", case, f"must be one of the study's cases: {told}")
    return known[case]


def _check(chosen) -> None:
    """BadInput for an unknown load case or set, or an impossible size, before anything is computed."""
    from silostudy.compute.loads import SETS
    from silostudy.errors import BadInput, unknown
    from silostudy.tables.load_cases import LOAD_CASES

    for flag, given, known in (("--load-case", chosen.load_case, LOAD_CASES), ("--values", chosen.values, SETS)):
        for key in given or ():
            if key not in known:
                raise unknown(flag, key, dict.fromkeys(known))
    if not 0.01 <= chosen.element_size <= 10:
        raise BadInput("--element-size", chosen.element_size, "must be from 0.01 to 10 m")


def _wanted(cube, chosen) -> list[tuple[str, str]]:
    """Load case and set of everything that is asked for; BadInput where a case that is named has no field here, and why."""
    from silostudy.cube.load import given_cases, of_case
    from silostudy.errors import BadInput

    case_cube = of_case(cube, chosen.case)
    given = given_cases(case_cube)
    for key in chosen.load_case or ():
        if key not in given:
            why = str(case_cube["load_case_reason"].sel(load_case=key).values) or "it has no field of its own"
            raise BadInput("--load-case", key, f"is not given for this silo: {why}; given: {', '.join(given)}")
    if not given:
        why = str(case_cube["load_case_reason"].values[0])
        raise BadInput("--load-case", chosen.load_case, f"no load case has a field for this silo: {why}")
    loads = [
        (key, values) for key in chosen.load_case or given for values in given[key] if values in (chosen.values or given[key])
    ]
    if not loads:
        raise BadInput(
            "--values", chosen.values, "none of the load cases is given with this set; see `silostudy list load-cases`"
        )
    return loads
