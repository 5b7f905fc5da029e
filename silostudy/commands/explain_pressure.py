"""Lines of `silostudy explain` on a pressure method."""


def explanation(row) -> list[str]:
    """The lines that explain a method."""
    from silostudy.pressure.parameters import PARAMETERS
    from silostudy.tables.handbook import errata
    from silostudy.tables.references import with_locator

    lines = [f"{row.title} ({row.key})", f"  formula   {row.formula}", f"  range     {row.range}"]
    lines.append(f"  plans     {', '.join(sorted(row.plans))}")
    for phase, quantities in row.phases.items():
        lines.append(f"  {phase:9} gives {', '.join(quantities)}")
    for phase, quantities in row.hopper.items():
        lines.append(f"  {phase:9} gives on the hopper wall {', '.join(quantities)}")
    for phase, quantities in row.floor.items():
        lines.append(f"  {phase:9} gives on a flat floor {', '.join(quantities)}")
    for phase, quantities in row.channel.items():
        lines.append(f"  {phase:9} gives for each flow channel {', '.join(quantities)}")
    for phase, quantities in row.totals.items():
        lines.append(f"  {phase:9} gives for the silo {', '.join(quantities)}")
    lines += [f"  {quantity} with {values}" for quantity, values in row.values.items()]
    lines.append("  symbols   z depth below the equivalent surface (m)")
    lines += [f"            {symbol}: {name} ({unit})" for name, (unit, symbol, _) in PARAMETERS.items() if name in row.needs]
    if row.equilibrium:
        lines.append(f"  weight = vertical pressure + wall friction, to rounding, in {' and '.join(row.equilibrium)}")
    lines += [f"  not computed: {what}" for what in row.not_computed]
    lines += _clauses(row.key)
    lines.append(f"  source    {with_locator(row.source, row.locator)}")
    for erratum in (erratum for erratum in errata() if erratum.method == row.key):
        lines.append(f"  error of the source, {erratum.place}: printed {erratum.printed}; right: {erratum.right}")
        lines.append(f"            known because {erratum.evidence}")
    if row.has_misprint:
        lines.append(f"  to see the print's own reading, list the method under `as_printed` in a study: [{row.key}]")
    return lines


def _clauses(key: str) -> list[str]:
    """A code's clauses, state by state: number, what it asks for, evidence, what carries it, remark and source."""
    from silostudy.tables.clauses import STATES, clauses

    rows = clauses(key)
    lines = ["  clause by clause (numbers as accounts of the code give them; tables/clauses.csv):"] if rows else []
    for state in STATES if rows else ():
        lines.append(f"  {state}")
        for clause in (row for row in rows if row.state == state):
            told = [
                f"{clause.what} ({clause.evidence})" if clause.evidence else clause.what,
                *(["see " + ", ".join(clause.names)] if clause.names else []),
            ]
            told += [clause.remark] if clause.remark else []
            lines.append(f"    {clause.clause or '-':8} {'; '.join(told)} [{clause.source}, {clause.locator}]")
    return lines
