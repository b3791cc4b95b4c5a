"""The habits of Stable-Baselines3: callbacks, logs, progress."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import environments
import pytest
import tools

from tpg_train import TPG
from tpg_train.callbacks import BaseCallback, CallbackList, CheckpointCallback

ARGUMENTS: dict[str, Any] = {"population": 20, "episodes": 3, "settings": {"selection.validation_episodes": 8}}


class Recording(BaseCallback):
    def __init__(self, stop_after: int | None = None) -> None:
        super().__init__()
        self.calls: list[str] = []
        self.stop_after = stop_after

    def _init_callback(self) -> None:
        self.calls.append("init")

    def _on_training_start(self) -> None:
        self.calls.append("start")

    def _on_rollout_start(self) -> None:
        self.calls.append("rollout")

    def _on_step(self) -> bool:
        self.calls.append("step")
        assert self.locals["progress"]["generations"] >= self.n_calls and self.num_timesteps == self.model.num_timesteps > 0
        return self.n_calls != self.stop_after

    def _on_rollout_end(self) -> None:
        self.calls.append("end of rollout")

    def _on_training_end(self) -> None:
        self.calls.append("end")


def test_callbacks_are_called_in_order_and_end_the_training() -> None:
    one, two = Recording(), Recording(stop_after=3)
    model = TPG(environments.Cart, **ARGUMENTS).learn(100_000, callback=[one, two])
    rounds = ["rollout", "step", "end of rollout"] * 3
    assert one.calls == two.calls == ["init", "start", *rounds, "rollout", "end"]
    assert model.num_timesteps < 100_000
    before = model.num_timesteps
    assert model.learn(10_000, callback=CallbackList([Recording()])).num_timesteps >= before + 10_000


def test_a_function_is_a_callback(tmp_path: Path) -> None:
    seen: list[float] = []

    def callback(locals_: dict[str, Any], globals_: dict[str, Any]) -> bool:
        seen.append(locals_["progress"]["best_score"])
        return len(seen) < 2

    model = TPG(environments.Cart, **ARGUMENTS)
    model.learn(100_000, callback)
    assert len(seen) == 2 and locals
    model.learn(20_000, CheckpointCallback(5, tmp_path / "saved"))
    saved = sorted((tmp_path / "saved").glob("tpg_*_steps.json"))
    assert saved and TPG.load(saved[-1]).has_graph
    with pytest.raises(TypeError, match="accepted: a callback"):
        model.learn(10, 3)  # type: ignore[arg-type]


def test_an_exception_of_a_callback_arrives_and_nothing_is_lost() -> None:
    model = TPG(environments.Cart, **ARGUMENTS)

    def callback(locals_: dict[str, Any], globals_: dict[str, Any]) -> bool:
        if locals_["progress"]["generations"] == 4:
            raise LookupError("mine")
        return True

    with pytest.raises(LookupError, match="mine"):
        model.learn(100_000, callback)
    before = model.num_timesteps
    assert before > 0 and model.learn(100).num_timesteps > before


def test_tensorboard_gets_the_figures(tmp_path: Path) -> None:
    accumulator = tools.module("tensorboard.backend.event_processing.event_accumulator")

    model = TPG(environments.Cart, **ARGUMENTS)
    for _ in range(2):
        model.learn(10_000, tensorboard_log=tmp_path)
    assert sorted(path.name for path in tmp_path.iterdir()) == ["TPG_1", "TPG_2"]
    events = accumulator.EventAccumulator(str(tmp_path / "TPG_1"))
    events.Reload()
    assert "rollout/best_score" in events.Tags()["tensors"], events.Tags()


def test_a_progress_bar_is_shown(capsys: pytest.CaptureFixture[str]) -> None:
    tools.module("tqdm")
    TPG(environments.Cart, **ARGUMENTS).learn(10_000, progress_bar=True)
    assert "best=" in capsys.readouterr().err


def test_verbose_says_what_it_does(capsys: pytest.CaptureFixture[str]) -> None:
    TPG(environments.Cart, verbose=1, **ARGUMENTS).learn(10_000, log_interval=2)
    lines = capsys.readouterr().out.splitlines()
    assert lines[0].startswith("generation 2: ") and "median" in lines[0]
