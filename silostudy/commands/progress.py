"""A bar of model time on standard error."""

import sys


class progress:
    """A bar with the rate in particle-steps a second and the time that remains.

    It begins once the first steps are made, behind which the compiling and a start from a checkpoint lie: neither counts.
    """

    def __init__(self, task):
        self.task, self.bar = task, None

    def __enter__(self):
        return self.tell

    def tell(self, step: int) -> None:
        engine, most = self.task.engine, len(self.task.engine.model.x)
        if self.bar is None:
            self.bar = _bar((self.task.last - self.task.began) * most, (step - self.task.began) * most)
        self.bar.set_postfix_str(f"t = {engine.time:.3f} s, {engine.n} {engine.space.body}s", refresh=False)
        self.bar.update((step - self.task.began) * most - self.bar.n)

    def __exit__(self, kind, error, trace) -> None:
        if self.bar is None:
            return
        if error is None:  # done, however far off the limit was
            self.bar.total = self.bar.n
        self.bar.close()


def _bar(total: int, made: int):
    """A bar over so many particle-steps, of which some are made: the rate is of those that follow."""
    from tqdm import tqdm

    return tqdm(total=total, initial=made, unit=" particle-steps", unit_scale=True, file=sys.stderr, mininterval=0.5)
