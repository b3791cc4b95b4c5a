"""The built-in problems as Gymnasium environments, and the wrappers."""

from __future__ import annotations

import warnings
from typing import Any

import environments
import gymnasium
import numpy as np
import pytest
from gymnasium.utils.env_checker import check_env

import tpg_train
from tpg_train import TPG, InputError, StatefulEnvironmentWarning
from tpg_train.envs import IDS, BuiltInEnv
from tpg_train.wrappers import Differences, Fresh


@pytest.mark.parametrize("name", sorted(IDS))
def test_the_arm_is_a_gymnasium_environment(name: str) -> None:
    env: gymnasium.Env[Any, Any] = gymnasium.make(name)
    with warnings.catch_warnings():
        warnings.filterwarnings("ignore", ".*Box observation space (minimum|maximum).*")
        check_env(env.unwrapped, skip_render_check=True)
    observation, _ = env.reset(seed=3)
    again, _ = env.reset(seed=3)
    assert (observation == again).all() and (env.reset(seed=4)[0] != observation).any()
    assert len(env.unwrapped.input_names) == len(observation)  # type: ignore[attr-defined]


def test_steps_are_checked() -> None:
    env = BuiltInEnv("rs", continuous=True)
    with pytest.raises(InputError, match="reset\\(\\) first"):
        env.step(np.zeros(4, np.float32))
    env.reset(seed=1)
    with pytest.raises(InputError, match="accepted: 4 values"):
        env.step(np.zeros(3, np.float32))
    with pytest.raises(InputError, match="finite"):
        env.step(np.float32([0, 0, np.nan, 0]))
    discrete = BuiltInEnv("cartpole")
    discrete.reset(seed=1)
    with pytest.raises(InputError, match="0 to 1"):
        discrete.step(2)
    with pytest.raises(InputError, match="cartpole"):
        BuiltInEnv("no such problem")


def test_an_episode_of_the_arm_ends_and_says_whether_it_succeeded() -> None:
    env = gymnasium.make("tpg_train/WidowXFixedDiscrete-v0")
    env.reset(seed=1)
    env.action_space.seed(1)
    for _ in range(100_000):
        *_, terminated, truncated, info = env.step(env.action_space.sample())
        if terminated or truncated:
            break
    assert info["is_success"] in (True, False)


def test_the_arm_can_be_trained_from_python() -> None:
    model = TPG("tpg_train/WidowXFixedDiscrete-v0", population=20, episodes=3).learn(20_000)
    assert model.evaluate(10).success_rate is not None
    assert model.verify(500).differences == 0


def test_differences_are_named_sources() -> None:
    env = Differences(environments.Cart())
    first, _ = env.reset(seed=1)
    assert (first["change"] == 0).all()
    second, *_ = env.step(1)
    np.testing.assert_array_equal(second["change"], second["now"] - first["now"])
    assert (env.reset(seed=1)[0]["change"] == 0).all(), "an episode begins anew"
    model = TPG(lambda: Differences(environments.Cart()), population=20, episodes=3).learn(20_000)
    assert set(model.graph.inputs) == {"change[0]", "change[1]", "now[0]", "now[1]"}


def test_a_fresh_environment_for_each_episode_forgets_everything() -> None:
    fresh = Fresh(environments.Stateful)
    first, _ = fresh.reset(seed=1)
    fresh.step(1)
    assert (fresh.reset(seed=1)[0] == first).all(), "an environment of its own"
    stateful = environments.Stateful()
    assert (stateful.reset(seed=1)[0] == first).all() and (stateful.reset(seed=1)[0] != first).any()

    with warnings.catch_warnings():
        warnings.simplefilter("error", StatefulEnvironmentWarning)
        graphs = [
            TPG(lambda: Fresh(environments.Stateful), population=20, episodes=3).learn(10_000, n_workers=workers).graph
            for workers in (0, 2)
        ]
    assert graphs[0].sha256 == graphs[1].sha256
    by_id = TPG(lambda: Fresh("CartPole-v1"), population=20, episodes=3).learn(2_000)
    assert by_id.native is None and by_id.evaluate(2).environment == "CartPole-v1"
    for wrong in (environments.Cart(), 7):
        with pytest.raises(ValueError, match="accepted: a registered id, or a function"):
            Fresh(wrong)  # type: ignore[arg-type]


def test_importing_registers_and_registering_twice_does_no_harm() -> None:
    tpg_train.register_envs()
    assert "tpg_train/WidowX-v0" in gymnasium.registry
