"""What `silostudy explain accuracy` says: which kinds of study may ask for which accuracy, and what their errors hang on."""

KEY = "accuracy"


def explanation() -> list[str]:
    """The lines that explain the key `accuracy`."""
    from silostudy.stages import FILE_KINDS
    from silostudy.tables.fronts import ASKED, TRAITS, quantities, rows_for

    lines = [
        "Accuracy in place of settings: `accuracy: {QUANTITY: largest relative error}` in a study or a discrete-element scene",
        "  the cheapest measured settings (`silostudy list accuracies`) that keep it in every case are taken, and recorded",
    ]
    for kind, row in FILE_KINDS.items():
        if "accuracy" not in row.study.model_fields:
            lines.append(f"  {kind}: may not ask: {row.study.unasked}")
            continue
        for quantity in quantities(kind):
            rows = [row for row in rows_for(kind) if row.quantity == quantity]
            about = f"sets {_keys(rows[0].settings)}; measured on {rows[0].machine}, {rows[0].measured_on}"
            lines.append(f"  {kind}, {quantity}: {ASKED[rows[0].kind, quantity]}")
            lines.append(f"    {about}")
            lines += [f"    {text}" for text in dict.fromkeys(map(_traits, rows))]
    return [*lines, "Numbers of a scene that errors hang on:", *(f"  {name}: {title}" for name, title in TRAITS.items())]


def _keys(settings: str) -> str:
    import json

    return ", ".join(json.loads(settings))


def _traits(row) -> str:
    ranges = ", ".join(f"{name} {low:g} to {high:g}" for name, (low, high) in row.within.items())
    return f"error goes with {row.scaled_by or 'no trait'}; measured within {ranges or 'any scene'}"
