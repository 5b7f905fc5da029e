"""Command `silostudy new PROJECT`: lays a folder with the pipeline, a study and a scene to start from."""

import shutil
from pathlib import Path

from silostudy import PACKAGE
from silostudy.errors import BadInput
from silostudy.files import check_writable

STARTER = PACKAGE / "starter"
PICTURE = "results/my-silo/figures/comparison_today.png"  # of the study to start from


def add(sub) -> None:
    command = sub.add_parser("new", help="lay a project folder with the pipeline, a study and a scene to start from")
    command.add_argument("project", type=Path, help="folder that is not there yet, or is empty")
    command.set_defaults(run=run)


def run(chosen) -> None:
    from silostudy.config.schema import study_schema

    folder = chosen.project
    if folder.exists() and (not folder.is_dir() or any(folder.iterdir())):
        raise BadInput("project", str(folder), "is there already, and not an empty folder: choose another name")
    check_writable(folder)
    shutil.copytree(STARTER, folder, dirs_exist_ok=True)
    (folder / "config/study.schema.json").write_text(study_schema(), encoding="utf-8")
    print(f"{folder}: made; now\n  cd {folder}\n  snakemake --cores 2")
    print(f"Its picture will then be {PICTURE}; README.md there says more")
