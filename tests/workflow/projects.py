"""Tiny whole projects for the tests of the pipeline, of names that shells, patterns and regular expressions trip over."""

import copy
import os
import subprocess
import sys
from pathlib import Path

import yaml

from tests.conftest import ROOT, SMALL
from tests.test_sweep.sweeps import content

STUDIES = ("wei zen;$HOME+([|]'\"ü&*?#~^=,`x`é{ 1-2 }", "a-b", "a_b")  # the last two are one name in a rule's
SWEEP, SCENE, SHAKE = "sw ee;p'$HOME(", 'b o"x;$HOME+[', "sha ke;$HOME(.csv"
RESULTS = "r es;$HOME+([|'ü&*?#{-}"
SHORT = content()["scene"] | {
    "march": {"limit_s": 0.02, "step_s": 2.5e-5},
    "quake": {"file": SHAKE},
    "events": [{"when": "time", "value": 0.01, "do": "open_slit"}, {"when": "time", "value": 0.02, "do": "stop"}],
}


def make(folder: Path) -> Path:
    """A project of three studies with a figure, a sweep and a scene of hard names; the folder itself."""
    for kind in ("studies", "scenes"):
        (folder / "config" / kind).mkdir(parents=True)
        (folder / "config" / kind / SHAKE).write_text("time_s,x_m_s2,y_m_s2\n0,1,0\n1,0,0\n")
    for name in STUDIES:
        study = copy.deepcopy(SMALL) | {"title": f"of {{x}} {name}", "outputs": ["fig_4_2_11"]}
        (folder / f"config/studies/{name}.yaml").write_text(yaml.safe_dump(study))
    sweep = content(slits=[0.1, 0.12], frictions=[0.1], scene=SHORT)
    (folder / f"config/studies/{SWEEP}.yaml").write_text(yaml.safe_dump(sweep))
    (folder / f"config/scenes/{SCENE}.yaml").write_text(yaml.safe_dump(SHORT))
    (folder / "config/config.yaml").write_text(yaml.safe_dump({"studies": [*STUDIES, SWEEP], "scenes": [SCENE]}))
    return folder


def snakemake(folder: Path, *arguments, results: str = RESULTS) -> subprocess.CompletedProcess:
    """Runs the pipeline in a folder as from a shell in which no environment is activated; all that it says on stdout."""
    command = [sys.executable, "-m", "snakemake", "--snakefile", ROOT / "Snakefile", "--cores", "2", *arguments]
    command += ["--config", f"results={results}"]
    environment = {**os.environ, "PATH": os.defpath, "PYTHONPATH": str(ROOT)}
    return subprocess.run(
        list(map(str, command)),
        cwd=folder, env=environment, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True,
    )  # fmt: skip


def tree(folder: Path) -> dict[str, tuple[int, bytes]]:
    """Time and content of everything in a project, but for what Snakemake itself keeps in .snakemake."""
    places = [path for path in folder.rglob("*") if path.relative_to(folder).parts[0] != ".snakemake"]
    return {str(path.relative_to(folder)): (path.stat().st_mtime_ns, path.is_file() and path.read_bytes()) for path in places}
