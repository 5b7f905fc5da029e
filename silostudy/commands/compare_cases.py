"""Lines of `silostudy compare` on the load cases of EN 1991-4's Table 3.1: each computed, or with the reason why not."""


def told(expansion) -> list[str]:
    """A line for every load case; nothing where no method of the study gives any."""
    from silostudy.compute.load_cases import load_cases
    from silostudy.tables.load_cases import LOAD_CASES

    given = {key for row in LOAD_CASES.values() for key in row.methods}
    if not given & set(expansion.study.method_keys):
        return []
    listed = load_cases(expansion.study, expansion.cases[0].scene)
    head = "load cases of EN 1991-4, Table 3.1 (`silostudy list load-cases`)"
    return [head, *(f"{case.row.title:56}{f'{case.state}: {case.why}' if case.why else case.state}" for case in listed)]
