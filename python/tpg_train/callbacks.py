"""Callbacks with the names and habits of Stable-Baselines3's, whose own callbacks work here too."""

from __future__ import annotations

import os
from collections.abc import Callable, Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any, Union

if TYPE_CHECKING:
    from .model import TPG


class BaseCallback:
    """A callback. Evolution calls it after every generation, where Stable-Baselines3 calls it after every step.

    Attributes: `model`, `n_calls` (generations so far), `num_timesteps` (environment steps so far), `locals`, whose
    `progress` holds the figures of the generation, and `verbose`.
    """

    model: TPG

    def __init__(self, verbose: int = 0) -> None:
        self.verbose = verbose
        self.n_calls = 0
        self.num_timesteps = 0
        self.locals: dict[str, Any] = {}
        self.globals: dict[str, Any] = {}
        self.parent: BaseCallback | None = None

    def init_callback(self, model: TPG) -> None:
        """Gets the model."""
        self.model = model
        self._init_callback()

    def on_training_start(self, locals_: dict[str, Any], globals_: dict[str, Any]) -> None:
        """Is called before the first generation."""
        self.locals, self.globals = locals_, globals_
        self.num_timesteps = self.model.num_timesteps
        self._on_training_start()

    def on_rollout_start(self) -> None:
        """Is called before a generation."""
        self._on_rollout_start()

    def on_step(self) -> bool:
        """Is called after a generation; false ends the training, which can go on later."""
        self.n_calls += 1
        self.num_timesteps = self.model.num_timesteps
        return self._on_step()

    def on_rollout_end(self) -> None:
        """Is called after a generation, after `on_step`."""
        self._on_rollout_end()

    def on_training_end(self) -> None:
        """Is called at the end."""
        self._on_training_end()

    def update_locals(self, locals_: dict[str, Any]) -> None:
        """Gets the figures of a generation."""
        self.locals.update(locals_)

    def _init_callback(self) -> None:
        pass

    def _on_training_start(self) -> None:
        pass

    def _on_rollout_start(self) -> None:
        pass

    def _on_step(self) -> bool:
        return True

    def _on_rollout_end(self) -> None:
        pass

    def _on_training_end(self) -> None:
        pass


class CallbackList(BaseCallback):
    """Several callbacks, one after another."""

    def __init__(self, callbacks: Sequence[Any]) -> None:
        super().__init__()
        self.callbacks = list(callbacks)

    def _init_callback(self) -> None:
        for callback in self.callbacks:
            callback.init_callback(self.model)

    def _on_training_start(self) -> None:
        for callback in self.callbacks:
            callback.on_training_start(self.locals, self.globals)

    def _on_rollout_start(self) -> None:
        for callback in self.callbacks:
            callback.on_rollout_start()

    def _on_step(self) -> bool:
        # Every callback is called, also behind one that ends the training.
        return all([callback.on_step() for callback in self.callbacks])

    def _on_rollout_end(self) -> None:
        for callback in self.callbacks:
            callback.on_rollout_end()

    def _on_training_end(self) -> None:
        for callback in self.callbacks:
            callback.on_training_end()

    def update_locals(self, locals_: dict[str, Any]) -> None:
        super().update_locals(locals_)
        for callback in self.callbacks:
            callback.update_locals(locals_)


class CheckpointCallback(BaseCallback):
    """Saves the best graph every `save_freq` generations as PREFIX_STEPS_steps.json."""

    def __init__(self, save_freq: int, save_path: str | os.PathLike[str], name_prefix: str = "tpg", verbose: int = 0) -> None:
        super().__init__(verbose)
        self.save_freq = save_freq
        self.save_path = Path(save_path)
        self.name_prefix = name_prefix

    def _init_callback(self) -> None:
        self.save_path.mkdir(parents=True, exist_ok=True)

    def _on_step(self) -> bool:
        if self.n_calls % self.save_freq == 0 and self.model.has_graph:
            self.model.save(self.save_path / f"{self.name_prefix}_{self.num_timesteps}_steps.json")
        return True


class _Function(BaseCallback):
    """A function of locals and globals; false ends the training."""

    def __init__(self, function: Callable[[dict[str, Any], dict[str, Any]], Any]) -> None:
        super().__init__()
        self.function = function

    def _on_step(self) -> bool:
        return self.function(self.locals, self.globals) is not False


class _Bar(BaseCallback):
    """A progress bar over environment steps."""

    def __init__(self, total: int) -> None:
        super().__init__()
        try:
            from tqdm.auto import tqdm
        except ImportError as error:
            raise ImportError("progress_bar=True needs tqdm: pip install 'tpg-train[progress]'") from error
        self.make: Callable[[int], Any] = lambda initial: tqdm(
            total=initial + total, initial=initial, unit="step", unit_scale=True
        )

    def _on_training_start(self) -> None:
        self.bar = self.make(self.num_timesteps)

    def _on_step(self) -> bool:
        self.bar.update(self.num_timesteps - self.bar.n)
        self.bar.set_postfix(
            {
                "best": self.locals["progress"].get("best_score"),
                "validated": self.locals["progress"].get("best_validated"),
            }
        )
        return True

    def _on_training_end(self) -> None:
        self.bar.close()


class _TensorBoard(BaseCallback):
    """Writes the figures of each generation for TensorBoard."""

    FIGURES = {
        "rollout/best_score": "best_score",
        "rollout/median_score": "median_score",
        "eval/mean_reward": "validation_score",
        "train/generation": "generations",
        "train/teams": "teams",
        "train/programs": "programs",
    }

    def __init__(self, folder: str | os.PathLike[str], name: str) -> None:
        super().__init__()
        try:
            from tensorboard.summary import Writer
        except ImportError as error:
            raise ImportError("tensorboard_log needs tensorboard: pip install 'tpg-train[tensorboard]'") from error
        number = 1 + max(
            (
                int(path.name.rpartition("_")[2])
                for path in Path(folder).glob(f"{name}_*")
                if path.name.rpartition("_")[2].isdigit()
            ),
            default=0,
        )
        self.writer = Writer(str(Path(folder) / f"{name}_{number}"))

    def _on_step(self) -> bool:
        for tag, key in self.FIGURES.items():
            value = self.locals["progress"].get(key)
            if value is not None:
                self.writer.add_scalar(tag, value, self.num_timesteps)
        return True

    def _on_training_end(self) -> None:
        self.writer.close()


MaybeCallback = Union[None, BaseCallback, Callable[[dict[str, Any], dict[str, Any]], Any], Sequence[Any]]


def as_list(callback: MaybeCallback, more: Sequence[BaseCallback]) -> CallbackList:
    """Makes one callback of what a user gives."""
    if callback is None:
        given: list[Any] = []
    elif isinstance(callback, (list, tuple)):
        given = list(callback)
    elif hasattr(callback, "on_step"):
        given = [callback]
    elif callable(callback):
        given = [_Function(callback)]
    else:
        raise TypeError(f"callback={callback!r}; accepted: a callback, a list of them, or a function of locals and globals")
    return CallbackList([*given, *more])
