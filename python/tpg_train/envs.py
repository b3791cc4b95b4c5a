"""The built-in problems as Gymnasium environments, so that every other library can train on them."""

from __future__ import annotations

import json
from typing import Any

import gymnasium
import numpy as np
from gymnasium import spaces
from numpy.typing import NDArray

from . import _tpg

Observation = NDArray[np.float32]


class BuiltInEnv(gymnasium.Env[Observation, Any]):
    """A built-in problem, stepped by the same code that evolution trains on.

    Args:
        problem: a name that `tpg-train problems` lists.
        continuous: True drives the four motors directly instead of 8 or 9 named moves.

    Observations are the problem's sources, in order, as float32; `info["is_success"]` is there where the problem defines
    success.
    """

    metadata: dict[str, Any] = {"render_modes": []}

    def __init__(self, problem: str, continuous: bool = False, render_mode: str | None = None) -> None:
        self.render_mode = render_mode
        self._running = _tpg.NativeEnv(problem, continuous)
        description = json.loads(self._running.description)
        ranges = np.asarray([ends for source in description["sources"] for ends in source["ranges"]], dtype=np.float64)
        # Declared ranges are where states usually lie; some problems go beyond them.
        self.source_ranges = ranges
        self.observation_space = spaces.Box(-np.inf, np.inf, (len(ranges),), np.float32)
        self.input_names = [
            source["name"] if len(source["ranges"]) == 1 else f"{source['name']}_{place}"
            for source in description["sources"]
            for place in range(len(source["ranges"]))
        ]
        self.action_names: list[str] = description["actions"]
        self.time_limit: int = description["time_limit"]
        if self.action_names:
            self.action_space: spaces.Space[Any] = spaces.Discrete(len(self.action_names))
        else:
            _, least, most = zip(*description["outputs"], strict=True)
            self.action_space = spaces.Box(np.array(least, np.float32), np.array(most, np.float32), dtype=np.float32)

    def reset(self, *, seed: int | None = None, options: dict[str, Any] | None = None) -> tuple[Observation, dict[str, Any]]:
        """Starts an episode. `options={"task": ...}` starts that of a task, as `tpg-train` writes tasks."""
        super().reset(seed=seed)
        if options is not None and "task" in options:
            return self._running.reset_to(json.dumps(options["task"])), {}
        return self._running.reset(int(self.np_random.integers(2**31))), {}

    def step(self, action: Any) -> tuple[Observation, float, bool, bool, dict[str, Any]]:
        """Takes an action."""
        if self.action_names:
            told = self._running.choose(int(action))
        else:
            told = self._running.act(np.ascontiguousarray(action, dtype=np.float32).ravel())
        observation, reward, terminated, truncated, success = told
        ends = (terminated or truncated) and success is not None
        return observation, reward, terminated, truncated, {"is_success": success} if ends else {}


# Ids, with the problem and whether its outputs are values.
IDS = {
    "tpg_train/WidowX-v0": ("rs", True),
    "tpg_train/WidowXFixed-v0": ("fs", True),
    "tpg_train/WidowXDiscrete-v0": ("rs", False),
    "tpg_train/WidowXFixedDiscrete-v0": ("fs", False),
}


def register_envs() -> None:
    """Registers the robot arm: `gymnasium.make("tpg_train/WidowX-v0")`. Importing `tpg_train` does it."""
    for name, (problem, continuous) in IDS.items():
        if name not in gymnasium.registry:
            gymnasium.register(
                name, entry_point="tpg_train.envs:BuiltInEnv", kwargs={"problem": problem, "continuous": continuous}
            )
