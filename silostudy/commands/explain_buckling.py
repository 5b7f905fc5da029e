"""Lines of `silostudy explain` on a buckling rule or on a rival reading."""

SILO = (
    "  in a silo safety_factor multiplies the axial stress (friction of the solid, own weight, roof, snow) and the "
    "largest\n            pressure; the smallest guaranteed one stays as it is; hoop tension and membrane "
    "yield (`list checks`) are checked beside"
)


def explanation(row) -> list[str]:
    """The lines that explain a buckling rule."""
    from silostudy.buckling import RIVALS
    from silostudy.buckling.family import PARAMETERS, REASONS
    from silostudy.tables.handbook import errata
    from silostudy.tables.references import with_locator

    lines = [f"{row.title} ({row.key})", f"  formula   {row.formula}", f"  range     {row.range}"]
    lines.append(f"  masks     {', '.join(REASONS[limit.reason] for limit in row.limits)}")
    if row.excludes:
        lines.append(f"  excludes  {row.excludes}")
    if not row.rival_of:
        lines.append(SILO)
    lines.append("  symbols")
    lines += [f"            {symbol}: {name} ({unit})" for name, (unit, symbol, _) in PARAMETERS.items() if name in row.needs]
    lines.append(f"  source    {with_locator(row.source, row.locator)}")
    for erratum in (erratum for erratum in errata() if erratum.method == row.key):
        lines.append(f"  error of the source, {erratum.place}: printed {erratum.printed}; right: {erratum.right}")
        lines.append(f"            known because {erratum.evidence}")
    rivals = [rival.key for rival in RIVALS.values() if rival.rival_of == row.key]
    if rivals:
        lines.append(f"  other readings, for comparison (`rivals` of a buckling study): {', '.join(rivals)}")
    return lines
