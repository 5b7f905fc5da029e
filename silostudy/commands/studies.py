"""Commands on a study before it is computed: `cases`, and `schema` for editors."""

from pathlib import Path


def add(sub) -> None:
    cases = sub.add_parser("cases", help="write the table of cases of a study")
    cases.add_argument("study", type=Path, help="a study file, or its name in config/studies")
    cases.add_argument("output", type=Path, help="CSV file to write")
    cases.set_defaults(run=run_cases)

    schema = sub.add_parser("schema", help="write the JSON schema of study files, for editors")
    schema.add_argument("output", type=Path)
    schema.set_defaults(run=run_schema)


def path_of(study: Path) -> Path:
    """The file of a study that is named by its path, or by its name in config/studies."""
    return study if study.suffix in (".yaml", ".yml") or study.is_file() else Path("config/studies") / f"{study}.yaml"


def run_cases(chosen) -> None:
    import csv
    import json

    from silostudy.choice.expand import expand_file
    from silostudy.files import replacing, seal

    expansion = expand_file(path_of(chosen.study))
    keys = list(expansion.cases[0].settings)
    with replacing(chosen.output) as temporary, temporary.open("w", newline="", encoding="utf-8") as stream:
        table = csv.writer(stream)
        table.writerow(["case", *keys])
        for case in expansion.cases:
            values = (case.settings[key] for key in keys)
            table.writerow(
                [case.id, *(value if isinstance(value, (str, int, float)) else json.dumps(value) for value in values)]
            )
    seal(chosen.output)


def run_schema(chosen) -> None:
    from silostudy.config.schema import study_schema
    from silostudy.files import replacing

    with replacing(chosen.output) as temporary:
        temporary.write_text(study_schema(), encoding="utf-8")
