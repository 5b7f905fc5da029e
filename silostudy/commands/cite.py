"""Command `silostudy cite CUBE`: prints the references behind the numbers of a cube."""

from pathlib import Path


def add(sub) -> None:
    command = sub.add_parser("cite", help="print the references of the methods and tables used in a cube")
    command.add_argument("cube", type=Path)
    command.set_defaults(run=run)


def run(chosen) -> None:
    from silostudy.cube.io import read

    attributes = read(chosen.cube).attrs
    print(f"{attributes['title']} ({attributes['source']}, study {attributes['study_hash']})")
    print(attributes["references"])
