"""Command `silostudy bench effects`: price of every effect and optional part, as the shipped table has it."""

from silostudy.files import replacing

HEAD = """\
# Share of CPU time (median and quartiles of the turns), of instructions (valgrind's callgrind, which knows no AVX-512; empty
# of parts that are no effect and no scene of grains) and of memory that goes when an effect is left out.
# {machine}, {measured_on}; measured by `silostudy bench effects --output silostudy/tables/effect_prices.csv`.
# These are this package's own measurements.
"""
TURNS = 5  # of optional parts
OWN = {"source": "kiyama_fujimura_1983", "locator": "measured here"}


def run(chosen) -> None:
    """Prints the prices and writes them as CSV."""
    import pandas as pd
    from threadpoolctl import threadpool_limits

    from silostudy.accuracy.measure import machine
    from silostudy.accuracy.price_table import price_variables

    with threadpool_limits(limits=1):
        table = pd.DataFrame(price_variables(TURNS, lambda text: print(text, flush=True)))
    table.columns = table.columns.str.removeprefix("effect_")
    print(table.to_string(index=False, float_format=lambda value: f"{value:.3f}"))
    with replacing(chosen.output) as temporary:
        text = table.assign(**OWN).to_csv(index=False, float_format="%.4f")
        temporary.write_text(HEAD.format(**machine()) + text, encoding="utf-8")
