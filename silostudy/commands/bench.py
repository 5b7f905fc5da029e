"""Command `silostudy bench`: measures what things cost, side by side on this machine."""

import time
from collections.abc import Callable
from pathlib import Path

# one call of 200,000 pressures, a sweep of usual size
DEPTHS = 50
CASES = 4000
OUTPUTS = {"discs": "accuracy.csv", "spheres": "accuracy_of_spheres.csv"}  # of `bench accuracy`, where it is not told
PEER_CASES = 40  # the scalar loop is timed on fewer


def add(sub) -> None:
    command = sub.add_parser("bench", help="measure speed: prints a table and writes it as CSV")
    what = command.add_subparsers(required=True, metavar="what")
    pressure = what.add_parser("pressure", help="pressures a second of each method, against a loop over depths and cases")
    pressure.add_argument("--output", type=Path, default=Path("results/bench/pressure.csv"))
    pressure.set_defaults(run=run_pressure)
    dem = what.add_parser("dem", help="particle-steps a second of the disc engine, beside LAMMPS where it is installed")
    dem.add_argument("--output", type=Path, default=Path("results/bench/dem.csv"))
    dem.set_defaults(run=run_dem)
    spheres = what.add_parser("spheres", help="the same of spheres in a bin with a cone: minutes, with --most an hour")
    spheres.add_argument("--most", action="store_true", help="half a million and a million spheres too")
    spheres.add_argument("--output", type=Path, default=Path("results/bench/spheres.csv"))
    spheres.set_defaults(run=run_spheres)
    discharge = what.add_parser("discharge", help="spheres left in a bin that flows out, beside LAMMPS from the same fillings")
    discharge.add_argument(
        "--silo",
        default="small",
        help="small; benchmark: that of Dosta et al. (2024), two materials and two outlets, as published (weeks); "
        "benchmark-8mm: of spheres of 8 mm, 500 times softer, its first second (a quarter of an hour)",
    )
    discharge.add_argument("--output", type=Path, default=Path("results/bench/discharge.csv"))
    discharge.set_defaults(run=run_discharge)
    hard = what.add_parser("hard", help="hard cases as scene files: what they come to here and in LAMMPS; two minutes")
    hard.add_argument("--scenes", type=Path, default=Path("config/scenes/hard"), help="folder of the scene files")
    hard.add_argument("--output", type=Path, default=Path("results/bench/hard.csv"))
    hard.set_defaults(run=run_hard)
    accuracy = what.add_parser("accuracy", help="CPU time to an error, beside LAMMPS where it is installed")
    accuracy.add_argument(
        "--grains",
        choices=("discs", "spheres"),
        default="discs",
        help="discs: static wall forces; spheres: means over fillings",
    )
    accuracy.add_argument(
        "--output", type=Path, help="of discs results/bench/accuracy.csv if not told, of spheres accuracy_of_spheres.csv there"
    )
    accuracy.set_defaults(run=run_accuracy)
    effects = what.add_parser(
        "effects", help="price of every effect and optional part in time, instructions, memory: half an hour"
    )
    effects.add_argument("--output", type=Path, default=Path("results/bench/effects.csv"))
    effects.set_defaults(run=run_effects)
    certificate = what.add_parser(
        "certificate", help="the front alone, runs that find out their own error, or both: met and cost; some minutes"
    )
    certificate.add_argument("--output", type=Path, default=Path("results/bench/certificate.csv"))
    certificate.set_defaults(run=run_certificate)


def run_certificate(chosen) -> None:
    from silostudy.commands.bench_certificate import run

    run(chosen)


def run_accuracy(chosen) -> None:
    from silostudy.commands import bench_accuracy, bench_means

    chosen.output = chosen.output or Path("results/bench", OUTPUTS[chosen.grains])
    {"discs": bench_accuracy, "spheres": bench_means}[chosen.grains].run(chosen)


def run_effects(chosen) -> None:
    from silostudy.commands.bench_effects import run

    run(chosen)


def run_dem(chosen) -> None:
    from silostudy.commands.bench_dem import run

    run(chosen)


def run_spheres(chosen) -> None:
    from silostudy.commands.bench_spheres import run

    run(chosen)


def run_discharge(chosen) -> None:
    from silostudy.commands.bench_discharge import run

    run(chosen)


def run_hard(chosen) -> None:
    from silostudy.commands.bench_hard import run

    run(chosen)


def run_pressure(chosen) -> None:
    import pandas as pd

    from silostudy.figures.style import save_table
    from silostudy.pressure import PRESSURE

    rows = [_measure(row) for row in PRESSURE.values()]
    table = pd.DataFrame(rows)
    print(table.to_string(index=False, float_format=lambda value: f"{value:.3g}"))
    save_table(table, chosen.output)


def _measure(row) -> dict:
    """Pressures a second of one method's wall pressure: a whole sweep in one call, and the same formula in a loop."""
    from silostudy.pressure.calls import call

    phase = next(reversed(row.phases))
    function = row.phases[phase]["wall_normal_pressure"]
    z, scenes = _sweep(CASES)
    few_z, few = z[:PEER_CASES], {name: values[:PEER_CASES] for name, values in scenes.items()}

    def loop() -> None:
        for case in range(PEER_CASES):
            numbers = {name: float(values[case, 0]) for name, values in few.items()}
            for depth in few_z[case]:
                call(function, depth, numbers)

    whole, single = _seconds(lambda: call(function, z, scenes)) / z.size, _seconds(loop) / few_z.size
    return {"method": row.key, "phase": phase, "pressures_per_s": 1 / whole, "loop_per_s": 1 / single, "ratio": single / whole}


def _sweep(cases: int):
    """Depths (cases, DEPTHS) and parameters (cases, 1) of silos of every size, with the proportions that charts ask for."""
    import numpy as np

    from silostudy.pressure.parameters import PARAMETERS

    diameter = np.linspace(3, 20, cases)[:, None]
    depth = 3.6 * diameter
    given = {name: value for name, (_, _, value) in PARAMETERS.items()}  # what only some ask for: of a usual size
    given |= {"unit_weight": 7845.32, "internal_friction_angle": 0.5236, "poisson_ratio": 0.4, "powder": 0.0, "i_phi": 0.548}
    given |= {"wall_friction": 0.44, "lateral_pressure_ratio": 0.45, "top_cone_height": 0.0, "contact_depth": 0.0}
    sizes = {"diameter": diameter, "hydraulic_radius": diameter / 4, "cylinder_depth": depth, "outlet_depth": 1.1 * depth}
    constant = {name: np.full_like(diameter, value) for name, value in given.items()}
    return depth * np.linspace(0.02, 1, DEPTHS), {**constant, **sizes}


def _seconds(work: Callable[[], object], repeats: int = 7) -> float:
    """Median CPU time of a call, after one that does not count."""
    work()
    times = []
    for _ in range(repeats):
        start = time.process_time()
        work()
        times.append(time.process_time() - start)
    return sorted(times)[repeats // 2]
