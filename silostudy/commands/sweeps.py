"""Sweeps computed in parts: `part` and `merge` for the pipeline, `verdict` and `retry` for cases that failed."""

import sys
from pathlib import Path


def add(sub) -> None:
    part = sub.add_parser("part", help="compute one part of a sweep")
    part.add_argument("study", type=Path)
    part.add_argument("folder", type=Path, help="folder of the plan and the journals: results/STUDY/parts")
    part.add_argument("part", help="name of the part in plan.csv")
    part.set_defaults(run=run_part)

    merge = sub.add_parser("merge", help="merge the parts of a sweep into its cube")
    merge.add_argument("study", type=Path)
    merge.add_argument("folder", type=Path, help="folder of the plan and the journals")
    merge.add_argument("output", type=Path, help="netCDF file to write; the list of failed cases beside it")
    merge.set_defaults(run=run_merge)

    verdict = sub.add_parser("verdict", help="list the failed cases of a sweep; status 2 where there are any")
    verdict.add_argument("failed", type=Path, help="list of failed cases: results/STUDY/KIND-failed.csv")
    verdict.set_defaults(run=run_verdict)

    retry = sub.add_parser("retry", help="forget the failed cases of a sweep, so that the pipeline computes them again")
    retry.add_argument("folder", type=Path, help="results/STUDY")
    retry.set_defaults(run=run_retry)


def run_part(chosen) -> None:
    import time

    from silostudy.sweep.part import compute_part

    start = time.perf_counter()
    count = compute_part(chosen.study, chosen.part, chosen.folder, lambda text: print(text, file=sys.stderr, flush=True))
    print(f"{chosen.study.stem} {chosen.part}: {count} case(s) in {time.perf_counter() - start:.1f} s")


def run_merge(chosen) -> None:
    from silostudy.sweep.merge import merge

    cases, lost = merge(chosen.study, chosen.folder, chosen.output)
    print(f"{chosen.study.stem}: {cases} case(s), {lost} failed -> {chosen.output}")
    for line in certificate_lines(chosen.output):
        print(f"  {line}")


def certificate_lines(cube: Path):
    """Says of each quantity whose accuracy was asked for how many cases met it, the worst error kept, and what it took."""
    import xarray as xr

    from silostudy.cube.certificates import step_unsure

    with xr.open_dataset(cube) as held:
        for number, name in enumerate(held["asked_quantity"].values.astype(str) if "asked_quantity" in held else ()):
            of = held.isel(asked_quantity=number)
            unsure = int(step_unsure(of).sum())
            met, bound, asked = of["error_met"], float(of["error_bound"].max()), float(of["error_asked"].min())
            yield (
                f"{name}: asked {100 * asked:.3g} % and more, met in {int((met == 1).sum())} of {met.size} case(s), the worst "
                f"{100 * bound:.2g} %; {int(of['fillings_computed'].sum())} fillings, {float(of['cpu_time'].sum()):.3g} CPU s, "
                f"of which {float(of['cpu_time_on_step'].sum()):.2g} on the step"
                f"{f', whose error is not known to that in {unsure}' if unsure else ''}"
            )


def run_verdict(chosen) -> None:
    import csv

    from silostudy.errors import BadInput

    with chosen.failed.open(newline="", encoding="utf-8") as stream:
        lost = list(csv.reader(stream))[1:]
    if lost:
        print("\n".join(": ".join(row) for row in lost))
        again = f"masked in the cube; to compute them again: silostudy retry {chosen.failed.parent}, then the same command"
        raise BadInput("failed cases", len(lost), again, str(chosen.failed))


def run_retry(chosen) -> None:
    from silostudy.errors import BadInput
    from silostudy.sweep.journal import ENDING, forget_failed

    journals = sorted((chosen.folder / "parts").glob(f"*{ENDING}"))
    if not journals:
        raise BadInput("folder", str(chosen.folder), "holds no parts of a sweep")
    print(f"{chosen.folder}: {sum(map(forget_failed, journals))} failed case(s) will be computed again")
