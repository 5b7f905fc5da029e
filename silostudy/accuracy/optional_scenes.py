"""Work with an optional part of a scene of grains: its run into a cube, and looks at what its contacts bear."""

from collections.abc import Callable
from dataclasses import replace
from pathlib import Path
from tempfile import TemporaryDirectory

from silostudy.accuracy.optional_parts import OptionalPart, Work
from silostudy.accuracy.priced_effects import base
from silostudy.compute.dem import carry_through, run_of, scene_model
from silostudy.compute.dem_cube import cube_of
from silostudy.config.grain_scenes import scene_class
from silostudy.dem.engine import Engine
from silostudy.dem.follow import EVERY, follow
from silostudy.dem.pace import SHARE, Pace
from silostudy.dem.run import CHECK_EVERY

APART = EVERY * CHECK_EVERY  # steps from a look at the contacts to the next


def ran(content: dict, then: Callable = cube_of) -> Callable[[], Work]:
    """Makes ready a run of a scene, into a cube or whatever `then` makes of (run, scene)."""

    def prepare() -> Work:
        scene = scene_class(content, "part").model_validate(content)

        def work() -> None:
            with TemporaryDirectory() as folder:
                run = run_of(scene, scene_model(scene, Path()))
                carry_through(run, scene, Path(folder, "checkpoint") if scene.record.checkpoint_every_s else None, _nothing)
                then(run, scene)

        return work

    return prepare


def _nothing(step: int) -> None:
    pass


def changing_steps(content: dict, room: str, note: str = "") -> tuple[OptionalPart, ...]:
    """Time steps of a scene that change, beside those that stay."""

    def stepped(**march) -> Callable[[], Work]:
        return ran(content | {"march": content["march"] | march})

    short = {"step_factor": 0.25}
    return (
        OptionalPart(f"steps that follow the contacts{note}", room, stepped(step="follow"), stepped()),
        OptionalPart(
            f"steps of a quarter that are longer at rest{note}", room, stepped(step="longer_at_rest", **short), stepped(**short)
        ),
    )


def look(body: str, room: str, note: str = "") -> OptionalPart:
    """A look at the contacts of bodies near rest whose step follows them, beside the steps from one look to the next."""
    return OptionalPart(f"a look at the contacts in {APART} steps{note}", room, _looks(body, 1), _looks(body, 0))


def _looks(body: str, count: int) -> Callable[[], Work]:
    def prepare() -> Work:
        model = replace(base(body), pace=Pace(SHARE))  # never longer than it begins: the steps are the same without a look

        def work() -> None:
            engine = Engine(model)
            engine.step_to(APART)
            for _ in range(count):
                follow(engine, [], filling=False)

        return work

    return prepare
