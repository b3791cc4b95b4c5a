"""The Python of the guides runs, with fewer steps and episodes."""

from __future__ import annotations

import re
from pathlib import Path

import pytest

DOCS = Path(__file__).parents[2] / "docs"
# Words of blocks that other tests run, that take a minute, or that need an environment of the reader's.
ELSEWHERE = ("sklearn", "train_network", "make_env", "run_on_the_bench")


@pytest.mark.filterwarnings("ignore:learn")
@pytest.mark.parametrize(("page", "count"), [("python.md", 1), ("compare.md", 2)])
def test_the_python_of_a_guide_runs(page: str, count: int, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(tmp_path)
    blocks = re.findall(r"^```python\n(.*?)^```", (DOCS / page).read_text(), re.MULTILINE | re.DOTALL)
    blocks = [block for block in blocks if not any(word in block for word in ELSEWHERE)]
    assert len(blocks) == count
    names: dict[str, object] = {}
    for block in blocks:
        block = re.sub(r"learn\([^)]*\)", "learn(20_000)", block).replace("evaluate(1000", "evaluate(5")
        exec(compile(block, page, "exec"), names)
