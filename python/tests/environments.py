"""Environments that tests train on, or that are refused."""

from __future__ import annotations

import os
import signal
from pathlib import Path
from typing import Any

import gymnasium
import numpy as np
from gymnasium import spaces


class Cart(gymnasium.Env[Any, Any]):
    """A cart on rails that should stop in the middle; the base of the others."""

    observation_space: spaces.Space[Any] = spaces.Box(-np.inf, np.inf, (2,), np.float32)
    action_space: spaces.Space[Any] = spaces.Discrete(2)

    def reset(self, *, seed: int | None = None, options: dict[str, Any] | None = None) -> tuple[Any, dict[str, Any]]:
        super().reset(seed=seed)
        self.x, self.v, self.steps = float(self.np_random.uniform(-2, 2)), 0.0, 0
        return self.observe(), {}

    def observe(self) -> Any:
        return np.array([self.x, self.v], np.float32)

    def push(self, action: Any) -> float:
        return 0.1 if action == 1 else -0.1

    def step(self, action: Any) -> tuple[Any, float, bool, bool, dict[str, Any]]:
        self.v += self.push(action)
        self.x += 0.1 * self.v
        self.steps += 1
        end = self.steps >= 50
        return (
            self.observe(),
            -abs(self.x) - abs(self.v),
            False,
            end,
            {"is_success": bool(abs(self.x) < 0.3)} if end else {},
        )


class DictCart(Cart):
    observation_space = spaces.Dict(
        {
            "cart": spaces.Dict({"x": spaces.Box(-9, 9, (1,), np.float64), "v": spaces.Box(-9, 9, (), np.float64)}),
            "side": spaces.Discrete(2),
        }
    )

    def observe(self) -> Any:
        return {"cart": {"x": np.array([self.x]), "v": np.array(self.v)}, "side": int(self.x > 0)}


class TupleCart(Cart):
    observation_space = spaces.Tuple((spaces.Box(-9, 9, (2,), np.float32), spaces.MultiBinary(1)))

    def observe(self) -> Any:
        return np.array([self.x, self.v], np.float32), np.array([self.x > 0], np.int8)


class BoxCart(Cart):
    action_space = spaces.Box(-0.2, 0.1, (1, 2), np.float64)

    def push(self, action: Any) -> float:
        assert action.shape == (1, 2) and action.dtype == np.float64 and self.action_space.contains(action)
        return float(action.sum())


class ManyCart(Cart):
    action_space = spaces.MultiDiscrete([2, 3])

    def push(self, action: Any) -> float:
        assert self.action_space.contains(action)
        action[0] *= 2  # what is given to an environment is the environment's
        return 0.1 * float(action[0] / 2) - 0.05 * float(action[1])


class WideCart(Cart):
    observation_space = spaces.Box(-100, 100, (5000,), np.float32)

    def observe(self) -> Any:
        return np.pad(super().observe(), (4998, 0))


class Digits(Cart):
    """A decision about a digit that f32 does not have."""

    observation_space = spaces.Box(0, 2, (3,), np.float64)

    def observe(self) -> Any:
        return np.array([1 + np.copysign(1e-10, self.x), 1, 0])

    def step(self, action: Any) -> tuple[Any, float, bool, bool, dict[str, Any]]:
        right = (action == 0) == (self.x > 0)
        return self.observe(), float(right), True, False, {"is_success": bool(right)}


class StartingCart(Cart):
    action_space = spaces.Discrete(2, start=5)

    def push(self, action: Any) -> float:
        assert action in (5, 6)
        return 0.1 if action == 6 else -0.1


class Failing(Cart):
    def step(self, action: Any) -> Any:
        if self.x > 1.5 and self.steps == 7:
            raise KeyError("the motor is off")
        return super().step(action)


class Stateful(Cart):
    drift = 0.0

    def reset(self, *, seed: int | None = None, options: dict[str, Any] | None = None) -> Any:
        told = super().reset(seed=seed)
        self.drift += 0.001
        self.x += self.drift
        return self.observe(), told[1]


class NanObservation(Cart):
    def observe(self) -> Any:
        return np.array([self.x, np.nan if getattr(self, "steps", 0) == 3 else self.v], np.float32)


class NanReward(Cart):
    def step(self, action: Any) -> Any:
        observation, _, *others = super().step(action)
        return observation, float("nan"), *others


class WrongShape(Cart):
    def observe(self) -> Any:
        return np.zeros(3, np.float32)


class OldStep(Cart):
    def step(self, action: Any) -> Any:
        observation, reward, _, end, info = super().step(action)
        return observation, reward, end, info


class Images(Cart):
    observation_space = spaces.Box(0, 1, (8, 8, 3), np.float32)


class Unbounded(Cart):
    action_space = spaces.Box(-np.inf, np.inf, (1,), np.float32)


class Texts(Cart):
    observation_space = spaces.Text(5)


class OneAction(Cart):
    action_space = spaces.Discrete(1)


class Huge(Cart):
    action_space = spaces.MultiDiscrete([100, 100, 100])


class Killed(Cart):
    """Kills its process once: when a file that it makes is not there yet."""

    marker = ""

    def step(self, action: Any) -> Any:
        if self.steps == 40 and not Path(self.marker).exists():
            Path(self.marker).touch()
            os.kill(os.getpid(), signal.SIGKILL)
        return super().step(action)


Killed.__name__ = Cart.__name__  # a graph says its environment's


class AlwaysKilled(Cart):
    def step(self, action: Any) -> Any:
        os.kill(os.getpid(), signal.SIGKILL)


class Spot(gymnasium.Env[Any, Any]):
    """A bright square on a dim, noisy image: each action that says whether it is left, in the middle or right earns 1."""

    observation_space = spaces.Box(0, 255, (6, 9, 2), np.uint8)
    action_space = spaces.Discrete(3)

    def reset(self, *, seed: int | None = None, options: dict[str, Any] | None = None) -> tuple[Any, dict[str, Any]]:
        super().reset(seed=seed)
        self.steps = 0
        return self.observe(), {}

    def observe(self) -> Any:
        self.column = int(self.np_random.integers(1, 8))
        image = self.np_random.integers(60, size=(6, 9, 2), dtype=np.uint8)
        image[2:5, self.column - 1 : self.column + 2, 1] += 150
        return image

    def step(self, action: Any) -> Any:
        reward = float(action == self.column // 3)
        self.steps += 1
        return self.observe(), reward, self.steps == 10, False, {}
