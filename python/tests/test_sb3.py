"""Actors of Stable-Baselines3 in integers, and its evaluation of our models."""

from __future__ import annotations

import ctypes
import subprocess
from pathlib import Path
from typing import Any

import gymnasium
import numpy as np
import pytest
import tools

sb3 = pytest.importorskip("stable_baselines3", reason="stable-baselines3 (with PyTorch) is not installed")
torch = pytest.importorskip("torch", reason="PyTorch is not installed")

from stable_baselines3.common.callbacks import BaseCallback  # noqa: E402
from stable_baselines3.common.env_checker import check_env  # noqa: E402
from stable_baselines3.common.evaluation import evaluate_policy  # noqa: E402

from tpg_train import TPG, InputError, from_sb3  # noqa: E402
from tpg_train.envs import IDS  # noqa: E402

RELU: dict[str, Any] = {"activation_fn": torch.nn.ReLU}


def trained(name: str, env: str, **arguments: Any) -> Any:
    torch.set_num_threads(1)
    model = getattr(sb3, name)("MlpPolicy", env, seed=1, device="cpu", **arguments)
    return model.learn(600)


@pytest.mark.parametrize(
    ("name", "env", "arguments"),
    [
        ("PPO", "CartPole-v1", {"policy_kwargs": RELU, "n_steps": 200}),
        ("PPO", "CartPole-v1", {"n_steps": 200}),
        ("PPO", "Pendulum-v1", {"n_steps": 200}),
        ("A2C", "CartPole-v1", {}),
        ("DQN", "CartPole-v1", {}),
        ("SAC", "Pendulum-v1", {"learning_starts": 300}),
        ("TD3", "Pendulum-v1", {"learning_starts": 300, "policy_kwargs": {"net_arch": [64, 48]}}),
    ],
)
def test_an_actor_becomes_integers_with_equal_bits_in_c(name: str, env: str, arguments: dict[str, Any], tmp_path: Path) -> None:
    model = trained(name, env, **arguments)
    policy = from_sb3(model)
    assert policy.verify(3000) == 3000
    if "equal_actions" in policy.agreement:
        assert policy.agreement["equal_actions"] > 0.97, policy.agreement
    else:
        assert policy.agreement["mean_difference"] < 0.03, policy.agreement
    result = policy.evaluate(gymnasium.make(env), 3)
    assert result.episodes == 3
    assert [path.name for path in policy.export_c(tmp_path, prefix="actor")] == ["actor.h", "actor.c"]


def test_the_c_acts_in_the_environment_as_python_does(tmp_path: Path) -> None:
    compiler = tools.program("cc")
    policy = from_sb3(trained("SAC", "Pendulum-v1", learning_starts=300))
    policy.export_c(tmp_path, prefix="actor")
    library = tmp_path / "actor.so"
    subprocess.run([compiler, "-std=c99", "-O2", "-shared", "-fPIC", "-o", library, tmp_path / "actor.c"], check=True)
    infer = ctypes.CDLL(str(library)).actor_infer
    env = gymnasium.make("Pendulum-v1")
    for seed in range(5):
        observation, _ = env.reset(seed=seed)
        done = False
        while not done:
            state, torque = np.ascontiguousarray(observation, np.float32), np.zeros(1, np.float32)
            infer(state.ctypes.data_as(ctypes.c_void_p), torque.ctypes.data_as(ctypes.c_void_p))
            assert torque == policy.predict(observation)[0]
            observation, _, terminated, truncated, _ = env.step(torque)
            done = terminated or truncated


def test_a_network_is_saved_for_tpg_codegen(tmp_path: Path) -> None:
    policy = from_sb3(trained("DQN", "CartPole-v1"), kind="w16a16")
    policy.save(tmp_path / "actor.q.json")
    assert '"argmax"' in (tmp_path / "actor.q.json").read_text()
    assert policy.export_rust(tmp_path, prefix="actor")[0].name == "actor.rs"


def test_what_is_no_such_actor_is_refused() -> None:
    with pytest.raises(InputError, match="accepted: PPO, A2C, DQN, SAC, TD3"):
        from_sb3(type("Other", (), {"policy": object()})())
    wide = sb3.PPO("MlpPolicy", "CartPole-v1", policy_kwargs={"net_arch": [100]}, device="cpu")
    with pytest.raises(InputError, match="tanh behind 100 units; accepted: up to 64"):
        from_sb3(wide)
    odd = sb3.PPO("MlpPolicy", "CartPole-v1", policy_kwargs={"activation_fn": torch.nn.ELU}, device="cpu")
    with pytest.raises(InputError, match="a layer of ELU"):
        from_sb3(odd)
    with pytest.raises(InputError, match="4 inputs; accepted: 3"):
        from_sb3(trained("DQN", "CartPole-v1"), env=gymnasium.make("Pendulum-v1"))


@pytest.mark.parametrize("name", sorted(IDS))
def test_the_arm_is_an_environment_of_theirs(name: str) -> None:
    check_env(gymnasium.make(name))


def test_they_train_on_the_arm_and_the_actor_becomes_integers() -> None:
    policy = from_sb3(trained("PPO", "tpg_train/WidowX-v0", n_steps=200, policy_kwargs=RELU))
    assert policy.agreement["mean_difference"] < 0.03 and policy.verify(500) == 500


def test_evaluate_policy_works_on_our_models() -> None:
    for env in ("CartPole-v1", "Pendulum-v1"):
        model = TPG(env, seed=3).learn(100_000)
        mean, std = evaluate_policy(model, gymnasium.make(env), n_eval_episodes=10, warn=False)  # type: ignore[arg-type]
        assert np.isfinite([mean, std]).all()
    assert mean > -1700


def test_a_callback_of_theirs_works_here() -> None:
    class Three(BaseCallback):
        def _on_step(self) -> bool:
            return self.n_calls < 3

    callback = Three()
    TPG("CartPole-v1", native=False, population=10, episodes=1).learn(100_000, callback)
    assert callback.n_calls == 3 and callback.num_timesteps > 0


def test_the_snippets_of_the_guide_about_importing_run(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    text = (Path(__file__).parents[2] / "docs/importing.md").read_text()
    snippets = [part.removeprefix("python\n") for part in text.split("```")[1::2] if part.startswith("python\n")]
    assert len(snippets) == 2
    monkeypatch.chdir(tmp_path)
    # What a reader has: a trained model, and its file.
    names: dict[str, Any] = {"model": trained("SAC", "Pendulum-v1", policy_kwargs=RELU)}
    names["model"].save("pendulum.zip")
    for snippet in snippets:
        exec(snippet, names)
    assert list(tmp_path.glob("policy/*.c")) and (tmp_path / "actor.safetensors").stat().st_size > 0
