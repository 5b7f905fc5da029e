"""A bar of model time on standard error."""

import sys


class progress:
    """A bar with the rate in particle-steps a second, where steps change in model time (s), and the time that remains.

    It begins once the first steps are made, behind which the compiling and a start from a checkpoint lie: neither counts.
    """

    def __init__(self, task):
        self.task, self.bar = task, None

    def __enter__(self):
        return self.tell

    def tell(self, step: int) -> None:
        engine, model = self.task.engine, self.task.engine.model
        of_tick, unit = (model.dt, " s") if model.pace.changes else (len(model.x), " particle-steps")
        made = (step - self.task.began) * of_tick
        if self.bar is None:
            self.bar = _bar((self.task.last - self.task.began) * of_tick, made, unit)
        self.bar.set_postfix_str(f"t = {engine.time:.3f} s, {engine.n} {engine.space.body}s", refresh=False)
        self.bar.update(made - self.bar.n)

    def __exit__(self, kind, error, trace) -> None:
        if self.bar is None:
            return
        if error is None:  # done, however far off the limit was
            self.bar.total = self.bar.n
        self.bar.close()


def _bar(total: float, made: float, unit: str):
    """A bar over so much work in a unit, of which some is done: the rate is of what follows."""
    from tqdm import tqdm

    return tqdm(total=total, initial=made, unit=unit, unit_scale=True, file=sys.stderr, mininterval=0.5)
