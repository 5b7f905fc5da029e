"""The explorer in headless Chromium: a visitor chooses, slices, points, exports; nothing comes from elsewhere, no error."""

import csv
import subprocess
import sys

import pytest

from silostudy.commands import explore
from silostudy.cube.io import write
from silostudy.errors import BadInput

pytestmark = pytest.mark.long


@pytest.fixture
def address(wheat, tmp_path):
    """Address of the explorer of the wheat silo, with a picture and a note beside its cube."""
    pytest.importorskip("panel", reason="no panel: uv sync --group show")
    study = tmp_path / "wheat"
    for name in ("figures/comparison.png", "notes/calculation_note-1.html"):
        (study / name).parent.mkdir(parents=True, exist_ok=True)
        (study / name).write_text("<h1>Calculation note</h1>")
    write(wheat, study / "pressure.nc")
    command = [sys.executable, "-u", "-m", "silostudy", "explore", str(study / "pressure.nc"), "--no-browser"]
    with subprocess.Popen(command, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True) as server:
        yield next(line.split()[-1] for line in server.stdout if "http://" in line)
        server.terminate()


def saved(page, button: str):
    """What a button saves."""
    with page.expect_download() as download:
        page.get_by_text(button).click()
    return download.value.path()


def choose(page, name: str, option: str) -> None:
    """Chooses an option from the list of a name."""
    page.get_by_label(name, exact=True).select_option(label=option)


def test_a_visitor_chooses_plots_and_exports(page, address):
    page, wrong = page
    page.goto(address)
    page.wait_for_selector("canvas")
    page.wait_for_selector("text=points by scope")
    assert page.get_by_text("calculation_note-1").get_attribute("href") == "files/notes/calculation_note-1.html"
    choose(page, "phase", "filling")
    page.wait_for_selector("td:has-text('phase not covered')")  # of a method that treats discharge alone
    rows = list(csv.DictReader(saved(page, "numbers (CSV)").open()))
    assert {row["curve"] for row in rows} >= {"caquot", "jenike_mass_flow"}
    deepest = max((row for row in rows if row["curve"] == "caquot"), key=lambda row: float(row["depth"]))
    assert float(deepest["wall_normal_pressure"]) == pytest.approx(26.36e3, rel=1e-3)
    assert deepest["scope"] == "in scope"
    assert deepest["source"].endswith("section 4.2.2 (c)")
    assert saved(page, "picture (PNG)").read_bytes().startswith(b"\x89PNG")
    choose(page, "along", "pressure_method")
    page.wait_for_selector("text=phase filling", state="detached")
    page.goto(f"{address}/files/notes/calculation_note-1.html")
    assert page.get_by_text("Calculation note").is_visible()
    assert wrong == []


def test_without_panel_one_line_says_how_to_get_it(monkeypatch):
    monkeypatch.setattr(explore, "find_spec", lambda name: None)
    with pytest.raises(BadInput, match="uv sync --group show"):
        explore.run(None)
