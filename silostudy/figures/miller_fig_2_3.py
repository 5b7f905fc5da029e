"""Miller's Figs. 2 and 3 again: the coefficients C (long shells) and J (short shells) against R/t with their lower bounds."""

from pathlib import Path

import matplotlib.pyplot as plt
import pandas as pd
import xarray as xr

from silostudy.figures.miller_points import points, reached, scatter
from silostudy.figures.style import WIDTH, foot, headline, save

READ = (
    "Lower bounds of the elastic coefficients, Miller's own tests (source's Fig. 2; its Fig. 3 sets the same bounds against "
    "aluminium tests whose values it does not print). Filled: elastic; open: beyond 0.55 $\\sigma_y$"
)
JUNCTION = 10  # M from which a shell counts as long, for choosing the points


def draw(cube: xr.Dataset, stem: Path) -> None:
    """Writes the figure and its numbers."""
    figure, (left, right) = plt.subplots(1, 2, figsize=(WIDTH, 5.4))
    slender, tests, curves = cube["chart_slenderness"].values, points(cube), []
    for panel, name, symbol, safe in (
        (left, "chart_long_coefficient", "C", 0.125),
        (right, "chart_short_coefficient", "J", 0.5),
    ):
        for making, line in (("manufactured", "solid"), ("fabricated", "dashed")):
            value = cube[name].sel({"chart_making": making}).values
            panel.plot(slender, value, color="black", linestyle=line, label=f"{symbol}, {making}")
            curves.append(pd.DataFrame({"curve": f"{symbol} {making}", "R_over_t": slender, "value": value}))
        panel.axhline(safe, color="black", linestyle=":", label=f"{symbol} = {safe}, the safe choice")
        panel.set(xscale="log", xlabel="R/t", ylim=(0, None))
        panel.set_xticks([100, 200, 300, 500, 1000, 2000, 3000], labels=["100", "200", "300", "500", "1000", "2000", "3000"])
        panel.minorticks_off()
    long, short = tests[tests.M2 >= JUNCTION**2], tests[tests.M2 < JUNCTION**2]
    scatter(left, long, "R_over_t", "C")
    scatter(right, short, "R_over_t", "J")
    left.set(ylabel="C = σ R / (E t)", ylim=(0, 0.4), title="long shells and bays (M ≥ 10)")
    right.set(ylabel=r"$J = C\,M^{0.6}$", title="short bays (M < 10)")
    for panel in (left, right):
        panel.legend()
    headline(figure, _message(cube, long, short))
    foot(figure, READ)
    save(figure, pd.concat([*curves, tests.assign(curve="test")], ignore_index=True), stem)


def _message(cube: xr.Dataset, long: pd.DataFrame, short: pd.DataFrame) -> str:
    """Message of the figure, in numbers: how many elastic tests reach the bounds of manufactured shells."""
    told = []
    for tests, name, symbol in ((long, "chart_long_coefficient", "C"), (short, "chart_short_coefficient", "J")):
        elastic = tests[tests.elastic]
        bound = cube[name].sel(chart_making="manufactured").interp(chart_slenderness=elastic.R_over_t.to_numpy())
        told.append(f"{reached(elastic[symbol], bound)} that of {symbol}")
    return f"Tests that stayed elastic and reach the bound of manufactured shells: {', '.join(told)}"
