"""Lines of `silostudy explain accuracy`: which kinds of study may ask for which accuracy, and what their errors hang on."""

KEY = "accuracy"


def explanation() -> list[str]:
    """The lines that explain the key `accuracy`."""
    from silostudy.choice.fronts import TRAITS, rows_for
    from silostudy.stages import FILE_KINDS
    from silostudy.tables.asked import quantities

    lines = [
        "Accuracy in place of settings: `accuracy: {QUANTITY: largest relative error}` in a study or a discrete-element scene",
        "  the cheapest measured settings (`silostudy list accuracies`) that keep it in every case are taken, and recorded",
    ]
    for kind, row in FILE_KINDS.items():
        if "accuracy" not in row.study.model_fields:
            lines.append(f"  {kind}: may not ask: {row.study.unasked}")
            continue
        for name, quantity in quantities(row.study.fronts).items():
            rows = rows_for(row.study.fronts, [name])
            lines.append(f"  {kind}, {name}: {quantity.title}")
            lines.append(f"    sets {', '.join(quantity.decides)}; measured on {rows[0].machine}, {rows[0].measured_on}")
            lines += [f"    {text}" for text in dict.fromkeys(map(_traits, rows))]
    return [*lines, "Numbers of a scene that errors hang on:", *(f"  {name}: {title}" for name, title in TRAITS.items())]


def _traits(row) -> str:
    ranges = ", ".join(f"{name} {low:g} to {high:g}" for name, (low, high) in row.within.items())
    return f"error goes with {row.scaled_by or 'no trait'}; measured within {ranges or 'any scene'}"
