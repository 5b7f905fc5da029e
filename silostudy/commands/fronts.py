"""Command `silostudy fronts`: measures the Pareto fronts that `accuracy:` chooses from, or tries its choices."""

from pathlib import Path

from silostudy.files import replacing

HEAD = """\
# Relative error over the measured scenes (the worst, or where settings are random what 95 % keep; times the trait that
# scales it) and CPU time of settings that `accuracy:` may choose, for scenes whose traits lie within the ranges; measured by
# `silostudy fronts --output silostudy/tables/fronts.csv`.  Errors and costs are this package's own measurements.
"""


def add(sub) -> None:
    fronts = sub.add_parser(
        "fronts", help="measure the Pareto fronts that `accuracy:` chooses from, or try its choices on other silos"
    )
    fronts.add_argument(
        "--trial", action="store_true", help="try the choices on silos that the Pareto fronts were not measured on"
    )
    fronts.add_argument("--kind", help="of this kind only; the rows of the others stay as they are shipped")
    fronts.add_argument("--output", type=Path, default=Path("results/accuracy/fronts.csv"), help="CSV file to write")
    fronts.set_defaults(run=run_fronts)


def run_fronts(chosen) -> None:
    import pandas as pd

    from silostudy.accuracy.fronts import KINDS, measured_fronts, trials
    from silostudy.errors import unknown
    from silostudy.tables.read import HERE

    if chosen.kind not in (None, *KINDS):
        raise unknown("kind", chosen.kind, KINDS)
    kinds = (chosen.kind,) if chosen.kind else KINDS

    def tell(text: str) -> None:
        print(text, flush=True)

    if not chosen.trial:
        shipped = pd.read_csv(HERE / "fronts.csv", comment="#", keep_default_na=False)
        rows = pd.concat([shipped[~shipped["kind"].isin(kinds)], pd.DataFrame(measured_fronts(tell, kinds))])
        with replacing(chosen.output) as temporary:
            temporary.write_text(HEAD + rows.to_csv(index=False), encoding="utf-8")
        print(f"{len(rows)} settings -> {chosen.output}")
        return
    table = pd.DataFrame([{**vars(trial), "met": trial.met} for trial in trials(tell, kinds)])
    table["cost_ratio"] = table["cost"] / table["cheapest"]
    with replacing(chosen.output) as temporary:
        table.to_csv(temporary, index=False, float_format="%.4g")
    for (kind, quantity), group in table.groupby(["kind", "quantity"], sort=False):
        print(f"{kind}, {quantity}: met in {group['met'].mean():.1%} of {len(group)}; at most 1.5 times the cheapest cost in "
              f"{(group['cost_ratio'] <= 1.5).mean():.0%}; median ratio {group['cost_ratio'].median():.2f}"
              + _settings_told(group["setting"] / group["least"]))  # fmt: skip


def _settings_told(ratio) -> str:
    """Median of levels, samples or runs taken over the fewest that would have met it, where settings are such numbers."""
    return f"; {ratio.median():.2g} times the fewest levels, samples or runs" if ratio.notna().any() else ""
