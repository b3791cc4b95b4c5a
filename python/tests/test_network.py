"""Actors of Stable-Baselines3 in integers, without PyTorch: stand-ins that have what is read of a model."""

from __future__ import annotations

import ctypes
import subprocess
from pathlib import Path
from typing import Any

import environments
import gymnasium
import numpy as np
import pytest
import tools
from gymnasium import spaces
from numpy.typing import NDArray

from tpg_train import InputError, NetworkPolicy, from_sb3


class Tensor(np.ndarray[Any, Any]):
    """An array that answers as a tensor does."""

    def detach(self) -> Tensor:
        return self

    cpu = numpy = detach


class Linear:
    def __init__(self, inputs: int, outputs: int, generator: np.random.Generator) -> None:
        self.weight = generator.normal(size=(outputs, inputs)).astype(np.float32).view(Tensor)
        self.bias = (generator.normal(size=outputs) / 9).astype(np.float32).view(Tensor)

    def __call__(self, rows: Any) -> Any:
        return rows @ np.asarray(self.weight).T + np.asarray(self.bias)


class ReLU:
    def __call__(self, rows: Any) -> Any:
        return np.maximum(rows, 0)


class FlattenExtractor:
    pass


class Bag:
    def __init__(self, **items: Any) -> None:
        self.__dict__.update(items)


class DummyVecEnv:
    def __init__(self, env: gymnasium.Env[Any, Any]) -> None:
        self.envs = [env]


class VecNormalize:
    def __init__(self, env: gymnasium.Env[Any, Any], clip_obs: float, mean: Any, var: Any) -> None:
        self.venv, self.norm_obs, self.epsilon, self.clip_obs = DummyVecEnv(env), True, 1e-8, clip_obs
        self.obs_rms = Bag(mean=np.array(mean), var=np.array(var))

    def get_attr(self, name: str, indices: int) -> list[Any]:
        return [None]


class PPO:
    """Reads observations as the library does: one-hot where they are choices."""

    def __init__(self, env: gymnasium.Env[Any, Any], vector: Any = None, units: int = 16) -> None:
        generator = np.random.default_rng(0)
        self.env, self.vector = env, vector
        inputs = spaces.flatdim(env.observation_space)
        values = spaces.flatdim(env.action_space) if not isinstance(env.action_space, spaces.Box) else env.action_space.shape[0]
        self.layers = [Linear(inputs, units, generator), ReLU(), Linear(units, values, generator)]
        extractor = Bag(policy_net=self.layers[:2])
        self.policy = Bag(features_extractor=FlattenExtractor(), mlp_extractor=extractor, action_net=self.layers[2])

    def get_env(self) -> Any:
        return self.vector

    def predict(self, observation: Any, deterministic: bool = True) -> tuple[Any, None]:
        space, actions = self.env.observation_space, self.env.action_space
        is_batch = np.ndim(observation) > len(space.shape or ())
        rows = observation if is_batch else [observation]
        flat = np.array([spaces.flatten(space, row) for row in rows]) if not isinstance(space, spaces.Box) else np.asarray(rows)
        for layer in self.layers:
            flat = layer(np.asarray(flat, np.float32).reshape(len(rows), -1))
        if isinstance(actions, spaces.Box):
            chosen = np.clip(flat, actions.low, actions.high)
        elif isinstance(actions, spaces.MultiDiscrete):
            parts = np.split(flat, np.cumsum(actions.nvec)[:-1], axis=1)
            chosen = np.stack([part.argmax(axis=1) for part in parts], axis=1)
        else:
            chosen = flat.argmax(axis=1)
        return (chosen if is_batch else chosen[0]), None


class Pushed(environments.Cart):
    """Its force is a value."""

    action_space = spaces.Box(-0.2, 0.1, (1,), np.float32)

    def push(self, action: Any) -> float:
        return float(action[0])


class Short(Pushed):
    """Ends before it is far away."""

    def step(self, action: Any) -> Any:
        observation, reward, stop, _, info = super().step(action)
        return observation, reward, stop, self.steps >= 3, info


class Cells(environments.Cart):
    """Tells the cell that it is in."""

    observation_space = spaces.Discrete(5)

    def observe(self) -> Any:
        return int(np.clip(round(self.x) + 2, 0, 4))


class Cell(Cells):
    observation_space = spaces.MultiDiscrete([5, 2])

    def observe(self) -> Any:
        return np.array([super().observe(), self.v > 0])


@pytest.mark.parametrize("env", [environments.Cart, environments.ManyCart, Pushed, Cells, Cell])
def test_an_actor_of_any_choices_acts_as_its_model(env: type[environments.Cart]) -> None:
    policy = from_sb3(PPO(env()), env=env())
    assert policy.agreement.get("equal_actions", 1.0) > 0.97 and policy.agreement.get("mean_difference", 0.0) < 0.02
    assert policy.verify(3000) == 3000


def in_c(policy: NetworkPolicy, states: NDArray[np.float32], folder: Path) -> NDArray[np.float32]:
    """Returns the first value of the exported C for each state."""
    policy.export_c(folder, prefix="actor")
    library = folder / "actor.so"
    compiler = tools.program("cc")
    subprocess.run([compiler, "-std=c99", "-O2", "-shared", "-fPIC", "-o", library, folder / "actor.c"], check=True)
    infer, answers = ctypes.CDLL(str(library)).actor_infer, np.zeros((len(states), 1), np.float32)
    for state, answer in zip(states, answers, strict=True):
        infer(state.ctypes.data_as(ctypes.c_void_p), answer.ctypes.data_as(ctypes.c_void_p))
    return answers


@pytest.mark.parametrize("kind", ["w8a16", "w16a16"])
@pytest.mark.parametrize("clip", [0.5, 2.0, 10.0])
def test_what_vecnormalize_clips_is_clipped_in_c(clip: float, kind: str, tmp_path: Path) -> None:
    env, mean, var = Short(), np.array([0.1, -0.2]), np.array([1.3, 0.02])
    model = PPO(env, VecNormalize(env, clip, mean, var))
    policy = from_sb3(model, env=env, kind=kind)
    assert policy.verify(3000) == 3000
    far = np.linspace(-3 * clip, 3 * clip, 61)
    normal = np.stack(np.meshgrid(far, far), axis=-1).reshape(-1, 2)
    states = (mean + normal * np.sqrt(var + 1e-8)).astype(np.float32)
    wanted = model.predict(np.clip(normal, -clip, clip).astype(np.float32))[0]
    unclipped = model.predict(normal.astype(np.float32))[0]
    half = 0.15
    assert np.abs(unclipped - wanted).max() > half / 4, "the clip decides nothing here"
    found = in_c(policy, states, tmp_path)
    bound = {"w8a16": 0.1, "w16a16": 0.01}[kind] * max(1.0, clip / 2)
    assert np.abs(found - wanted).max() / half < bound
    assert (found == policy.predict(states)[0]).all()
    assert "the network sees (value - 0.1)" in (tmp_path / "actor.h").read_text()


def test_a_clip_too_wide_for_the_integers_does_not_make_them_coarse() -> None:
    env = Pushed()
    model = PPO(env, VecNormalize(env, 1e6, [0.0, 0.0], [1.0, 1.0]))
    assert from_sb3(model, env=env).agreement == from_sb3(PPO(env), env=env).agreement
    with pytest.raises(InputError, match="clip_obs = 0.0; accepted: above 0"):
        from_sb3(PPO(env, VecNormalize(env, 0.0, [0.0, 0.0], [1.0, 1.0])), env=env)


def test_the_statistics_of_a_wrapper_become_part_of_the_inputs(tmp_path: Path) -> None:
    env = gymnasium.wrappers.NormalizeObservation(Pushed())
    with pytest.raises(InputError, match="has seen nothing"):
        env.obs_rms.count = 0
        from_sb3(PPO(env), env=env)
    env.obs_rms.mean, env.obs_rms.var, env.obs_rms.count = np.array([0.7, -0.2]), np.array([0.04, 0.01]), 100
    model = PPO(env)
    policy = from_sb3(model, env=env, kind="w16a16")
    assert policy.agreement["mean_difference"] < 0.02 and policy.verify(3000) == 3000
    assert policy.export_c(tmp_path, prefix="actor") and "(value - 0.7)" in (tmp_path / "actor.h").read_text()
    with pytest.raises(InputError, match="not outermost"):
        from_sb3(model, env=gymnasium.wrappers.TimeLimit(env, 50))


def test_integers_that_are_unlike_the_network_are_refused(monkeypatch: pytest.MonkeyPatch) -> None:
    env = environments.Cart()
    model = PPO(env)
    other = PPO(env)
    other.layers[2].weight[:] *= -1
    monkeypatch.setattr(model, "predict", other.predict)
    with pytest.raises(InputError, match="unlike the network"):
        from_sb3(model, env=env)
