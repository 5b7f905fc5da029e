"""What several test rooms share: the project's folder, the wheat silo, and small studies as plain dictionaries."""

import copy
import shutil
from collections.abc import Iterator
from pathlib import Path

import matplotlib.pyplot as plt
import pytest
from hypothesis import settings

from silostudy.choice.expand import expand, expand_file
from silostudy.compute.pressure import pressure_cube
from silostudy.scene.expand import Expansion
from tests.kernels import save_memory

ROOT = Path(__file__).parents[1]
SMALL = {
    "kind": "pressure",
    "title": "a small study",
    "scene": {
        "silo": {"plan": "circular", "diameter_m": 5.0, "cylinder_depth_m": 18.0, "hopper": {"half_angle_deg": 45.0}},
        "solid": "wheat_benchmark",
    },
    "methods": ["janssen", "reimbert"],
    "depth_m": [1.0, 2.0, 18.0],
}

CHROMIUM = shutil.which("chromium") or shutil.which("chromium-browser")
QUIET = ["--no-sandbox", "--disable-gpu", "--disable-background-networking", "--disable-component-update", "--disable-sync"]

save_memory()
settings.register_profile("same", derandomize=True)  # the same examples each time; others: --hypothesis-profile=default
settings.load_profile("same")


@pytest.fixture
def page():
    """A page of headless Chromium and what went wrong on it."""
    playwright = pytest.importorskip("playwright.sync_api", reason="no playwright: uv sync --group show")
    if CHROMIUM is None:
        pytest.skip("no Chromium: Debian's package chromium")
    with playwright.sync_playwright() as driver:
        browser = driver.chromium.launch(executable_path=CHROMIUM, args=QUIET)
        page, wrong = browser.new_page(viewport={"width": 1500, "height": 900}), []
        page.on("console", lambda message: wrong.append(message.text) if message.type == "error" else None)
        page.on("pageerror", lambda error: wrong.append(str(error)))
        page.on(
            "request",
            lambda request: (
                wrong.append(request.url[:80]) if request.url.startswith("http") and "//127.0.0.1:" not in request.url else None
            ),
        )
        yield page, wrong
        browser.close()


@pytest.fixture
def study() -> dict:
    """The content of a small valid study, free to be changed."""
    return copy.deepcopy(SMALL)


@pytest.fixture
def kept(monkeypatch) -> Iterator[list]:
    """The figures that drawing saved, still open to look at."""
    figures: list = []
    monkeypatch.setattr(plt, "close", figures.append)
    yield figures
    monkeypatch.undo()
    plt.close("all")


def expanded(content: dict, folder: Path = ROOT) -> Expansion:
    """The cases of a study's content."""
    return expand(content, "small", "small.yaml", folder)


@pytest.fixture(scope="session")
def wheat():
    """The cube of the default study, the handbook's wheat silo."""
    return pressure_cube(expand_file(ROOT / "config/studies/wheat-silo.yaml"))


def with_changes(content: dict, changes: dict) -> dict:
    """A copy of a content with other values; `scene__walls` is the key `walls` of its section `scene`, None takes it out."""
    changed = copy.deepcopy(content)
    for key, value in changes.items():
        *parents, last = key.split("__")
        node = changed
        for parent in parents:
            node = node.setdefault(parent, {})
        node[last] = value
        if value is None:
            del node[last]
    return changed
