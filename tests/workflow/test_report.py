"""The report as a browser shows it: one page of its own, every figure opens, no broken image, no error on the console."""

import os
import shutil
import subprocess
import sys
from pathlib import Path

import pytest

from tests.conftest import ROOT

PICTURE = "img[src^='data:image/png']"


def snakemake(folder: Path, *arguments) -> None:
    environment = {**os.environ, "PATH": f"{Path(sys.executable).parent}:{os.environ['PATH']}"}
    command = ["snakemake", "--snakefile", str(ROOT / "Snakefile"), "--cores", "2", *map(str, arguments)]
    done = subprocess.run(command, cwd=folder, env=environment, capture_output=True, text=True)
    assert done.returncode == 0, done.stderr[-3000:]


def looked_at(page, report: Path) -> dict[str, tuple[str, list[str]]]:
    """Opens everything in the report as a reader would: output -> (its caption, widths of the images shown)."""
    page.goto(report.as_uri())
    found = {}
    for category in page.evaluate("Object.keys(categories)"):
        for path in page.evaluate("c => Object.values(categories[c]).flat()", category):
            page.goto("about:blank")
            page.goto(report.as_uri())
            page.get_by_text(category, exact=True).click()
            row = page.get_by_role("row").filter(has_text=page.evaluate("p => results[p].labels.output", path))
            caption = page.evaluate("p => results[p].caption", path)
            if path.endswith(".png"):
                row.locator("[iconname=eye]").click()
                page.wait_for_selector(PICTURE)
                page.wait_for_function("s => [...document.querySelectorAll(s)].every(one => one.complete)", arg=PICTURE)
                sizes = page.eval_on_selector_all(PICTURE, "them => them.map(one => one.width)")
            else:
                sizes = []
                assert row.locator("[iconname=eye]").get_attribute("href").startswith("data:text/csv")
            found[path] = caption, sizes
    return found


def check(page, wrong, report: Path, least: int) -> None:
    found = looked_at(page, report)
    assert len(found) >= least
    for path, (caption, sizes) in found.items():
        assert "Source: " in caption, path
        assert all(size >= 1000 for size in sizes), path  # px, in which its smallest words have 12
        assert len(sizes) == path.endswith(".png"), path
    assert wrong == []


def test_report_of_a_small_project(page, tmp_path):
    (tmp_path / "config/studies").mkdir(parents=True)
    for name in ("wheat-silo", "pieper-flour"):
        shutil.copy(ROOT / f"config/studies/{name}.yaml", tmp_path / "config/studies")
    (tmp_path / "config/config.yaml").write_text("studies: [wheat-silo, pieper-flour]\n")
    snakemake(tmp_path)
    snakemake(tmp_path, "--report", "report.html")
    check(*page, tmp_path / "report.html", 3)
    assert {file.name for file in tmp_path.iterdir()} - {".snakemake", "config"} == {"results", "report.html"}


def test_report_of_the_whole_project(page, tmp_path):
    if not (ROOT / "results/wheat-silo/figures").is_dir():
        pytest.skip("the default project has not been run here: uv run snakemake --cores 2")
    snakemake(ROOT, "--report", tmp_path / "report.html", "--nolock")
    check(*page, tmp_path / "report.html", 30)
