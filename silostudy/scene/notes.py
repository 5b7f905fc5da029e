"""All cautions on a scene of grains and its model, a line each, as `check`, `dem` and `explain` tell them."""

from collections.abc import Iterator
from typing import Any

from silostudy.config.spheres import SphereScene
from silostudy.dem.model import Model
from silostudy.scene.cautions import early_shares, high_frictions, late_events, opened_again, unit_slips, upward
from silostudy.scene.clinging import deep_pulls
from silostudy.scene.dem import plane_silo_of
from silostudy.scene.idle import powerless, untaken
from silostudy.scene.outflow import narrow
from silostudy.scene.pressed import soft_springs
from silostudy.scene.raining import rain_warnings, spread
from silostudy.scene.spheres import space_silo_of
from silostudy.scene.stiff import shortened_steps
from silostudy.scene.vain_events import vain_events

INTERVALS = ("wall_force_window_s", "snapshots_every_s", "checkpoint_every_s")  # of a record
READ = ("fields", "contact_statistics")  # sections of a record that are read every so often


def notes(scene: Any, model: Model) -> list[str]:
    """Lines on what is possible in a scene, and hardly meant; a warning of what would go wrong."""
    silo: Any = space_silo_of(scene) if isinstance(scene, SphereScene) else plane_silo_of(scene)
    warned = [*unit_slips(scene), *narrow(silo.outlet_widths, 2.0 * float(model.radius.max()), model.space.body)]
    if isinstance(scene, SphereScene):
        warned += [*rain_warnings(scene, silo, model), *spread(scene)]
    kinds = tuple(scene.grain_kinds) if hasattr(scene, "grain_kinds") else scene.kinds
    told = (
        high_frictions(scene),
        late_events(scene),
        opened_again(scene),
        early_shares(scene),
        vain_events(scene, silo.outlet_widths),
        () if lidded(scene) else upward(scene),
        untaken(scene),
        powerless(model, kinds),
        deep_pulls(model, kinds),
        soft_springs(model, kinds, silo.silo.area if isinstance(scene, SphereScene) else silo.width),
        shortened_steps(model, kinds),
        never_longer(model),
    )
    lines = [f"note: {text}" for texts in (*told, short_records(scene, model)) for text in texts]
    return lines + [f"warning: {text}" for text in warned]


def lidded(scene: Any) -> bool:
    """Whether a lid closes the top of a scene's silo."""
    return bool(scene.lid if isinstance(scene, SphereScene) else scene.silo.lid)


def never_longer(model: Model) -> Iterator[str]:
    """A note on steps that would be longer at rest, where nothing lets them."""
    if not model.pace.lively:
        return
    if model.pace.longest == model.pace.ticks:
        yield "march.step: longer_at_rest makes no step longer without a march.step_factor below 1"
    elif model.quake is not None:
        yield "march.step: longer_at_rest makes no step longer in this scene, since its base may shake"
    elif model.moving:
        yield "march.step: longer_at_rest makes no step longer in this scene, since a wall of it moves (lid, belt, slow outlet)"


def short_records(scene: Any, model: Model) -> Iterator[str]:
    """A caution for each record that is to be written more often than there are steps."""
    record = scene.record
    asked = {name: getattr(record, name) for name in INTERVALS}
    asked |= {f"{name}.every_s": section.every_s for name in READ if (section := getattr(record, name))}
    for name, every in asked.items():
        if every and every < model.step:
            count = f"{scene.march.limit_s / model.step:,.0f} of them to march.limit_s"
            yield f"record.{name} = {every:g} is shorter than a step of {model.step:.3g} s: every step is recorded, {count}"
