"""Lines of `silostudy explain` on the checks of a silo's steel: one of them, or all with what is left out."""

KEY = "checks"


def explanation(row) -> list[str]:
    """The lines that explain a check."""
    from silostudy.checks.family import PARAMETERS
    from silostudy.tables.references import with_locator

    lines = [f"{row.title} ({row.key})", f"  formula   {row.formula}", f"  range     {row.range}", "  symbols"]
    lines += [f"            {symbol}: {name} ({unit})" for name, (unit, symbol, _) in PARAMETERS.items() if name in row.needs]
    status = ["  status    one public source: made only where checks.one_source names it"] if row.one_source else []
    return [*lines, *status, f"  source    {with_locator(row.source, row.locator)}"]


def checks() -> list[str]:
    """The lines on all checks: which are made where, what a study gives for them, and what is not built."""
    from silostudy.checks import CHECKS, SOLID_CHECKS, not_built

    lines = ["checks of a silo's steel beside axial buckling (`silostudy list buckling`)"]
    lines += [f"  {row.key:26}{row.title:40}{_made(row, SOLID_CHECKS)}" for row in CHECKS.values()]
    lines.append("combinations of actions: `silostudy list combinations`; a study's own in checks.combinations")
    lines.append("load cases of EN 1991-4 behind them: `silostudy list load-cases`; of one silo: `silostudy compare STUDY`")
    told = {
        "remembered alone, so not built": not_built.MEMORY,
        "sources disagree": not_built.CONFLICT,
        "one source alone, so not built": not_built.ONE_SOURCE,
        "left out": not_built.LEFT_OUT,
    }
    return lines + [line for head, texts in told.items() for line in (head, *(f"  - {text}" for text in texts))]


def _made(row, always) -> str:
    if row.key in always:
        return "every shell study; under combinations with the section checks"
    return "with the section checks" + (", named in checks.one_source (one source)" if row.one_source else "")
