"""What `silostudy explain` says of a check of a steel wall."""


def explanation(row) -> list[str]:
    """The lines that explain a check."""
    from silostudy.checks.family import PARAMETERS
    from silostudy.tables.references import with_locator

    lines = [f"{row.title} ({row.key})", f"  formula   {row.formula}", f"  range     {row.range}", "  symbols"]
    lines += [f"            {symbol}: {name} ({unit})" for name, (unit, symbol, _) in PARAMETERS.items() if name in row.needs]
    return [*lines, f"  source    {with_locator(row.source, row.locator)}"]
