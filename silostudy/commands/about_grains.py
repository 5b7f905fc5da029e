"""Lines that `silostudy check` says of a study of shaken grains."""

from collections.abc import Iterable


def runs(expansion) -> list[str]:
    """Runs, grains, steps and effects of a grains study."""
    from silostudy.accuracy.prices import without
    from silostudy.compute.grains_model import run_lengths, shaken_box_model
    from silostudy.scene.costs import told_time

    planned = run_lengths(expansion)
    kinds = {getattr(case.scene.config, "packing", None): case.scene.config for case in expansion.cases}
    models = [shaken_box_model(config, expansion.study.seeds[0]) for config in kinds.values()]
    effects = {name for model in models for name in without(model)}
    fillings, shaken = [run for run in planned if not run.shaken], [run for run in planned if run.shaken]
    time = told_time(_time(planned, models[0]))
    return [
        f"{len(fillings)} filling(s) of {_range(run.grains for run in fillings)} {models[0].space.body}s, settled in at most "
        f"{_range(run.steps for run in fillings)} steps; equal fillings once",
        f"{len(shaken)} shaken run(s) of {_range(run.steps for run in shaken)} steps: with the settling at most "
        f"{_work(planned):.2g} particle-steps, about {time} of one core; `--price` settles and times one filling",
        f"effects compiled in, and no others: {'; '.join(sorted(effects))}",
    ]


def seconds(expansion) -> float:
    """About what the study costs (s), at most."""
    from silostudy.compute.grains_model import run_lengths, shaken_box_model

    return _time(run_lengths(expansion), shaken_box_model(expansion.cases[0].scene.config, expansion.study.seeds[0]))


def _time(planned, model) -> float:
    """About the time (s) of some runs, one of whose models is given."""
    from silostudy.scene.costs import COSTS

    return _work(planned) * COSTS[f"{model.space.body}s"].body


def _work(planned) -> int:
    """Particle-steps of some runs, at most."""
    return sum(run.grains * run.steps for run in planned)


def cautions(expansion) -> list[str]:
    """Cautions on the grains of a study's cases, each once, though nothing is wrong."""
    from silostudy.scene.cautions import high_frictions, narrow_cell, unit_slips
    from silostudy.scene.idle import untaken

    scenes = [case.scene for case in expansion.cases]
    told = [text for scene in scenes for text in (*high_frictions(scene.config, "scene."), *narrow_cell(scene))]
    idle = [list(untaken(scene.config, "scene.")) for scene in scenes]
    told += [text for text in idle[0] if all(text in of_case for of_case in idle)]  # what a sweep sets elsewhere is meant
    slips = dict.fromkeys(text for scene in scenes for text in unit_slips(scene.config, "scene."))
    return [*(f"note: {text}" for text in dict.fromkeys(told)), *(f"warning: {text}" for text in slips)]


def prices_of_effects(expansion) -> list[str]:
    """Measured time of the study on one core, and each effect's share of a step: one filling is settled and timed."""
    from silostudy.accuracy.prices import prices
    from silostudy.commands.explain_scene import priced
    from silostudy.compute.grains import settled_model
    from silostudy.compute.grains_model import run_lengths

    model = settled_model(expansion.cases[0].scene, expansion.study.seeds[0], expansion.study.rest_limit_s)
    whole, share = prices(model)
    price = whole / len(model.x)
    seconds = f"{price * _work(run_lengths(expansion)):,.0f} s on one core"
    lines = [f"{price * 1e9:.0f} ns a particle-step here and now: at most {seconds}, and the compiling"]
    return [*lines, *(f"  {name:30}{priced(effect)}" for name, effect in share.items())]


def _range(numbers: Iterable[int]) -> str:
    """The least and the largest of some numbers, in words."""
    listed = list(numbers)
    low, high = min(listed), max(listed)
    return f"{low:,}" if low == high else f"{low:,} to {high:,}"
