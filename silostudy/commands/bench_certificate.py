"""Sets three ways to an accuracy asked for beside each other, on scenes that no front was measured on: `bench certificate`."""

SILOS = 12  # of discs whose step is asked for; each takes one to two minutes of CPU time
FILLINGS = 60  # of each, as in trials of the front
PACKINGS = 4  # of discs whose mean is asked for
RUNS = 120  # of each


def run(chosen) -> None:
    import pandas as pd

    from silostudy.accuracy.certificate_of_step import trials_of_step
    from silostudy.accuracy.certificates import made_up, trials_of_means
    from silostudy.accuracy.fronts_packing import packings
    from silostudy.figures.style import save_table

    def tell(text: str) -> None:
        print(text, flush=True)

    tried = {
        "fillings of scenes made up": trials_of_means(made_up()),
        "runs of packings": trials_of_means(packings(tell, PACKINGS, RUNS)),
        "step of discs at rest": trials_of_step(tell, SILOS, FILLINGS),
    }
    rows = pd.DataFrame(
        [{"what": what, "way": way, **summary} for what, trials in tried.items() for way, summary in _by_way(trials)]
    )
    print(rows.to_string(index=False, float_format=lambda value: f"{value:.3g}"))
    save_table(rows, chosen.output)


def _by_way(trials):
    """Yields each way with the share that keeps what was asked, and how its cost compares with the cheapest."""
    import numpy as np

    for way in dict.fromkeys(way for way, _ in trials):
        of_way = [trial for name, trial in trials if name == way]
        ratio = np.array([trial.cost / trial.cheapest for trial in of_way])
        ratio = ratio[np.isfinite(ratio)]
        yield (
            way,
            {
                "trials": len(of_way),
                "met": np.mean([trial.met for trial in of_way]),
                "within_1.5": np.mean(ratio <= 1.5),
                "median_ratio": np.median(ratio),
                "ratio_of_90_percent": np.quantile(ratio, 0.9),
            },
        )
