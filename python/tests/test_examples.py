"""Every example runs, as the notebook that a user opens; the script beside it is what is edited."""

from __future__ import annotations

from pathlib import Path

import pytest
import tools

FOLDER = Path(__file__).parents[1] / "examples"
EXAMPLES = sorted(FOLDER.glob("*.py"))
SECONDS = 300


def test_every_script_has_its_notebook() -> None:
    assert EXAMPLES and {path.stem for path in FOLDER.glob("*.ipynb")} == {path.stem for path in EXAMPLES}


@pytest.mark.parametrize("example", EXAMPLES, ids=lambda path: path.stem)
def test_a_notebook_holds_what_its_script_does(example: Path) -> None:
    jupytext = tools.module("jupytext")
    script, notebook = (jupytext.read(example.with_suffix(suffix)) for suffix in (".py", ".ipynb"))
    cells = [[(cell.cell_type, cell.source) for cell in one.cells] for one in (script, notebook)]
    assert cells[0] == cells[1], f"python -m jupytext --set-kernel python3 --to ipynb {example}"
    assert not any(cell.get("outputs") for cell in notebook.cells), "a notebook is kept without its outputs"


@pytest.mark.parametrize("example", EXAMPLES, ids=lambda path: path.stem)
def test_a_notebook_runs(example: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    jupytext, nbclient = tools.module("jupytext"), tools.module("nbclient")
    tools.module("ipykernel")
    if "stable_baselines3" in example.read_text():
        pytest.importorskip("stable_baselines3", reason="stable-baselines3 (with PyTorch) is not installed")
    for variable in ("IPYTHONDIR", "JUPYTER_RUNTIME_DIR", "JUPYTER_CONFIG_DIR"):
        monkeypatch.setenv(variable, str(tmp_path / variable))
    notebook = jupytext.read(example.with_suffix(".ipynb"))
    nbclient.NotebookClient(notebook, timeout=SECONDS, resources={"metadata": {"path": str(tmp_path)}}).execute()
    assert list(tmp_path.glob("policy/*.c")), "an example ends in C"
    shown = [output for cell in notebook.cells for output in cell.get("outputs", [])]
    assert not [output for output in shown if output.get("name") == "stderr"], shown
    if example.stem == "cartpole_to_c":
        assert any("image/svg+xml" in output.get("data", {}) for output in shown), "the graph draws itself"
