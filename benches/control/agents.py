"""Agents of Stable-Baselines3, trained here as its zoo trains them where minutes suffice, and put into integers."""

from __future__ import annotations

import time
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import gymnasium
import numpy as np
from rivals import literal


@dataclass(frozen=True)
class Recipe:
    """An algorithm with its settings: hyperparams/*.yml of DLR-RM/rl-baselines3-zoo at 22e3ff2."""

    algorithm: str
    steps: int
    environments: int
    settings: dict[str, Any]


def falling(first: float) -> Callable[[float], float]:
    """Returns a rate that falls to zero over the run."""
    return lambda left: left * first


RECIPES = {
    "CartPole-v1": Recipe(
        "PPO",
        100_000,
        8,
        dict(
            n_steps=32,
            batch_size=256,
            gae_lambda=0.8,
            gamma=0.98,
            n_epochs=20,
            ent_coef=0.0,
            learning_rate=falling(0.001),
            clip_range=falling(0.2),
        ),
    ),
    "Acrobot-v1": Recipe(
        "DQN",
        100_000,
        1,
        dict(
            learning_rate=6.3e-4,
            batch_size=128,
            buffer_size=50_000,
            learning_starts=0,
            gamma=0.99,
            target_update_interval=250,
            train_freq=4,
            gradient_steps=-1,
            exploration_fraction=0.12,
            exploration_final_eps=0.1,
            policy_kwargs=dict(net_arch=[256, 256]),
        ),
    ),
    "MountainCar-v0": Recipe(
        "DQN",
        120_000,
        1,
        dict(
            learning_rate=4e-3,
            batch_size=128,
            buffer_size=10_000,
            learning_starts=1000,
            gamma=0.98,
            target_update_interval=600,
            train_freq=16,
            gradient_steps=8,
            exploration_fraction=0.2,
            exploration_final_eps=0.07,
            policy_kwargs=dict(net_arch=[256, 256]),
        ),
    ),
    "Pendulum-v1": Recipe(
        "PPO",
        100_000,
        4,
        dict(
            n_steps=1024,
            gae_lambda=0.95,
            gamma=0.9,
            n_epochs=10,
            ent_coef=0.0,
            learning_rate=1e-3,
            clip_range=0.2,
            use_sde=True,
            sde_sample_freq=4,
        ),
    ),
}


class Agent:
    """A trained agent: `policy(observation)` is the action of the network in floats."""

    def __init__(self, model: Any, name: str, seconds: float) -> None:
        self.model, self.name, self.seconds = model, name, seconds

    def reset(self) -> None:
        """Begins an episode."""

    def __call__(self, observation: Any) -> Any:
        return self.model.predict(observation, deterministic=True)[0]

    def write_c(self, name: str, folder: Path) -> Path:
        """Writes the network as plain C into a folder: its outputs, with the C library's tanh if it has any."""
        import torch

        parts = self.model.policy.q_net.q_net if self.name == "DQN" else None
        if parts is None:
            parts = [*self.model.policy.mlp_extractor.policy_net, self.model.policy.action_net]
        layers = [part for part in parts if isinstance(part, torch.nn.Linear)]
        squash = "tanhf(sum)" if any(isinstance(part, torch.nn.Tanh) for part in parts) else "sum > 0.0F ? sum : 0.0F"
        arrays, steps, last = "", "", "s"
        for at, layer in enumerate(layers):
            rows, columns = layer.weight.shape
            numbers = np.column_stack([layer.bias.detach().numpy(), layer.weight.detach().numpy()]).ravel()
            to = "out" if at + 1 == len(layers) else f"h{at}"
            arrays += f"static const float w{at}[] = {{ {', '.join(map(literal, numbers))} }};\n"
            steps += "" if to == "out" else f"    float {to}[{rows}];\n"
            steps += f"    layer(w{at}, {columns}, {rows}, {last}, {to}, {int(to != 'out')});\n"
            last = to
        file = folder / f"{name}.c"
        file.write_text(
            f"#include <math.h>\n{arrays}"
            "static void layer(const float *w, int inputs, int outputs, const float *from, float *to, int hidden)\n{\n"
            "    for (int row = 0; row < outputs; row++) {\n        float sum = *w++;\n"
            "        for (int column = 0; column < inputs; column++) {\n            sum += *w++ * from[column];\n        }\n"
            f"        to[row] = hidden ? {squash} : sum;\n    }}\n}}\n"
            f"void {name}(const float *s, float *out)\n{{\n{steps}}}\n"
        )
        return file


class Integers:
    """The same agent in integers."""

    def __init__(self, agent: Agent) -> None:
        from tpg_train import from_sb3

        self.network = from_sb3(agent.model)
        self.network.verify()

    def reset(self) -> None:
        """Begins an episode."""

    def __call__(self, observation: Any) -> Any:
        return self.network.predict(observation)[0]

    def write_c(self, name: str, folder: Path) -> Path:
        """Writes its C into a folder."""
        return next(path for path in self.network.export_c(folder, name) if path.suffix == ".c")


def trained(problem: str, seed: int) -> Agent:
    """Trains an agent on a problem of Gymnasium, on one thread."""
    import stable_baselines3
    import torch
    from stable_baselines3.common.env_util import make_vec_env

    recipe = RECIPES[problem]
    torch.set_num_threads(1)
    before = time.process_time()
    env = make_vec_env(problem, n_envs=recipe.environments, seed=seed) if recipe.environments > 1 else gymnasium.make(problem)
    kind = getattr(stable_baselines3, recipe.algorithm)
    model = kind("MlpPolicy", env, seed=seed, device="cpu", **recipe.settings).learn(recipe.steps)
    return Agent(model, recipe.algorithm, time.process_time() - before)
