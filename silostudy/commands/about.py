"""Lines that `silostudy check` says of a study, kind by kind: each function takes an expansion and gives lines."""

import re

ALIKE = 4  # lines that differ by numbers alone and are told each


def pressures(expansion) -> list[str]:
    """Size of a study of pressures: methods, cases and values."""
    from silostudy.compute.pressure import silent_cube
    from silostudy.cube.silence import silences

    study = expansion.study
    methods = len(study.method_keys) + len(study.as_printed)
    values = len(expansion.cases) * methods * len(study.phases) * len(study.depths)
    lines = [f"{methods} method(s) x {len(study.phases)} phase(s) x {len(study.depths)} depths: {values} values a quantity"]
    return [*lines, *(f"note: {line}" for line in silences(silent_cube(expansion)))]


def cautions(expansion) -> list[str]:
    """Cautions for a study's author, though nothing is wrong."""
    from silostudy.scene.scene import solid_parameters

    notes: dict[str, int] = {}
    for case in expansion.cases:
        parameters = solid_parameters(case.scene, "")
        wall = case.scene.wall.key if case.scene.wall else "its own wall friction"
        if parameters["wall_friction"] < parameters["wall_friction_uncapped"]:
            text = f"{case.scene.solid.key} on {wall}: wall friction {parameters['wall_friction_uncapped']:.3g} capped at "
            notes[f"{text}tan(phi) = {parameters['wall_friction']:.3g}"] = 1
        for name in ("wall_friction", "poisson_ratio"):
            if parameters[name] != parameters[name]:
                text = f"{case.scene.solid.key} on {wall}: no {name} in the tables; methods that need it give nothing"
                notes[text] = 1
    return [f"note: {text}" for text in (*notes, *unusual_inputs(expansion), *_switches(expansion))]


def unusual_inputs(expansion) -> list[str]:
    """Inputs of a study's silos and solids that are possible but unusual, each once."""
    from silostudy.scene.possible import unusual
    from silostudy.scene.scene import Scene

    scenes = (case.scene for case in expansion.cases if isinstance(case.scene, Scene))
    return list(dict.fromkeys(text for scene in scenes for text in unusual(scene)))


def _switches(expansion) -> list[str]:
    """Methods that a switch of the scene leaves as they are."""
    from silostudy.pressure import PRESSURE

    rows = [expansion.study.family(PRESSURE)[key] for key in expansion.study.method_keys]
    keep = [row.key for row in rows if "wall_friction" in row.varies]
    ends = dict.fromkeys(case.scene.wall_friction_end for case in expansion.cases)
    moved = ", ".join(end for end in ends if end != "mean")
    if keep and moved:
        return [f"wall_friction_end: {moved} does not move {', '.join(keep)}: they vary the wall friction themselves"]
    return []


def shaking(expansion) -> list[str]:
    """Base motion, likeness index and assumptions of a seismic study."""
    study, lines = expansion.study, []
    if asked := study.identification:
        count, trials = len(asked.fine_coefficients), asked.recovery_trials
        lines.append(f"{count} coefficients x 3 damping ratios and 2 stiffnesses, and {trials} recovery trials a case")
    lines += dict.fromkeys(f"base motion: {case.scene.base.origin}" for case in expansion.cases)
    if any(case.scene.imitation for case in expansion.cases):
        lines.append("note: the measured response is synthetic")
    return [*lines, f"note: assumed are {', '.join(study.assumed)}"] if study.assumed else lines


def earthquake(expansion) -> list[str]:
    """Earthquake that a shell study lays on its wall, and what is not checked with it."""
    from silostudy.compute.shell_earthquake import UNCHECKED

    asked = expansion.study.earthquake
    return [f"earthquake: {asked.study}, {asked.mass_choice}", f"note: {UNCHECKED}"] if asked else []


def checks(expansion) -> list[str]:
    """Number of combinations of actions that the steel is checked in, and actions that are not given."""
    from silostudy.compute.checks import not_given
    from silostudy.scene.steelwork import combinations

    if expansion.study.checks is None:
        return []
    without = ", ".join(not_given(expansion))
    told = [f"note: not given, so in no combination: {without}"] if without else []
    return [f"steel checked in {len(combinations(expansion.study))} combination(s) of actions", *told]


def gathered(lines: list[str]) -> list[str]:
    """The lines, in which those that differ by numbers alone are told by the first, their count and the last."""
    alike: dict[str, list[str]] = {}
    for line in lines:
        alike.setdefault(re.sub(r"\d[\d.,]*(e[+-]?\d+)?", "#", line), []).append(line)
    told = []
    for group in alike.values():
        between = [f"{len(group) - 2} more such lines"] if len(group) > ALIKE else group[1:-1]
        told += [*group[:1], *between, *group[1:][-1:]]
    return told


def seconds_of_parts(expansion) -> float:
    """About what a sweep costs (s): from the measured time of a case where the study states it, else from grains and steps."""
    from silostudy.sweep.plan import parts_of

    study, parts = expansion.study, parts_of(expansion.study)
    seconds = sum(study.case_s or parts.call("cost", case.scene) for case in expansion.cases)
    return seconds * expansion.size / len(expansion.cases)


def time_of_parts(expansion) -> list[str]:
    """About what a sweep costs, in words."""
    from silostudy.scene.costs import OF_MEAN, rains, told_time

    study, seconds = expansion.study, seconds_of_parts(expansion)
    if getattr(study, "of_fillings", ()) and not study.case_s:
        told = f"about {told_time(seconds)} of one core were it {OF_MEAN} fillings a case: as many are computed as the accuracy"
        return [f"{told} asked takes, a kernel's compiling apart"]
    rained = not study.case_s and any(
        rains(case.scene.config) for case in expansion.cases if hasattr(case.scene.config, "events")
    )
    sort = "about" if rained else "at most about"
    later = ", more where a rain of grains comes to rest late" if rained else ""
    return [f"{sort} {told_time(seconds)} of one core{later}, a kernel's compiling apart"]


def tests(expansion) -> list[str]:
    """Number of cells of a laboratory, their stresses, and those at which its numbers enter the row of the solid."""
    study, counts = expansion.study, dict.fromkeys(case.scene.count for case in expansion.cases)
    stresses = ", ".join(f"{stress:g}" for stress in study.stresses_kPa)
    return [
        f"{expansion.size} cell(s) of {', '.join(map(str, counts))} grains, each tested at {stresses} kPa",
        f"row {study.solid.key}: at {study.vertical:g} kPa, wall friction at {study.horizontal:g} kPa",
    ]


def rules(expansion) -> list[str]:
    """Number of buckling rules that judge the shell."""
    return [f"{len(expansion.study.rule_keys)} buckling rule(s)"]


def rings(expansion) -> list[str]:
    """Reach of a silo's rings, for the rules that count any, and that they are left out beyond it."""
    from silostudy.buckling.limits import LEAST_RING_RATIO

    walls = dict.fromkeys((case.scene.shell.bay_length, case.scene.shell.ring_area) for case in expansion.cases)
    lines = []
    for bay, area in walls:
        if bay:
            most = area / (LEAST_RING_RATIO * bay) * 1e3
            lines.append(
                f"note: rings of {area * 1e4:g} cm2 every {bay:g} m count at most up to a wall of {most:.3g} mm; in a "
                "thicker one they are left out, the bay is the whole height (`wall_supported_length`); EN 1993-4-1 counts none"
            )
    return lines
