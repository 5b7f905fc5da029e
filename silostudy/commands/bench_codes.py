"""Command `silostudy bench codes`: how far LAMMPS is off the engine in a study's first setting, as the shipped table has it."""

import numpy as np

from silostudy.errors import BadInput
from silostudy.files import replacing

FILLINGS = 12
HEAD = """\
# Means over fillings by the engine and by LAMMPS from the same starts, with the same law and step: how far LAMMPS is off, half
# the 95 % interval of that, and the standard deviation of a filling over its mean by either code.
# {measured_on}; measured by `uv run --group peers silostudy bench codes --output silostudy/tables/code_differences.csv`.
# These are this package's own measurements.
"""
OWN = {"source": "lammps_granular", "locator": "measured here"}


def run(chosen) -> None:
    """Prints the differences and writes them as CSV."""
    import pandas as pd
    from tqdm import tqdm

    from silostudy.accuracy.codes import of_codes
    from silostudy.accuracy.measure import machine
    from silostudy.accuracy.peers import available
    from silostudy.choice.expand import expand_file
    from silostudy.commands.bench_hard import version
    from silostudy.config.spheres import SphereScene

    if missing := available():
        raise BadInput("bench codes", "LAMMPS", missing)
    first = expand_file(chosen.study, [0])
    scene = getattr(first.cases[0].scene, "config", None)
    if not isinstance(scene, SphereScene):
        raise BadInput("kind", first.study.kind, "must be a study of scenes of spheres", str(chosen.study))
    fillings = [
        of_codes(scene.model_copy(update={"seed": seed}), chosen.study.parent)
        for seed in tqdm(range(1, FILLINGS + 1), unit=" fillings")
    ]
    table = pd.DataFrame(differences(fillings)).assign(lammps_version=version(), study=first.study.title, **OWN)
    print(table.to_string(index=False, float_format=lambda value: f"{value:.4g}"))
    with replacing(chosen.output) as temporary:
        text = table.to_csv(index=False, float_format="%.5g")
        temporary.write_text(HEAD.format(**machine()) + text, encoding="utf-8")


def differences(fillings: list[dict[str, dict[str, float]]]) -> list[dict]:
    """A row a quantity: means of both codes, how far theirs is off with half its interval, scatter of a filling."""
    from silostudy.figures.intervals import changed

    rows = []
    for quantity in fillings[0]["silostudy"]:
        ours, theirs = (np.array([filling[code][quantity] for filling in fillings]) for code in ("silostudy", "LAMMPS"))
        change, half = changed(theirs, ours)
        rows.append({
            "quantity": quantity, "fillings": len(fillings), "silostudy_mean": ours.mean(), "lammps_mean": theirs.mean(),
            "change": change, "half_interval": half, "silostudy_scatter": ours.std(ddof=1) / abs(ours.mean()),
            "lammps_scatter": theirs.std(ddof=1) / abs(theirs.mean()),
        })  # fmt: skip
    return rows
