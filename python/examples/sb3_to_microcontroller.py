# %% [markdown]
# # From Stable-Baselines3 to a microcontroller
#
# A PPO actor becomes a network in integers: the same bits in Python, on a PC and on a Cortex-M4. Beside it, a graph that does
# the same in a hundredth of the bytes.

# %%
import gymnasium
import torch
from stable_baselines3 import PPO
from stable_baselines3.common.evaluation import evaluate_policy

from tpg_train import TPG, from_sb3

actor = PPO("MlpPolicy", "CartPole-v1", policy_kwargs={"activation_fn": torch.nn.ReLU}, seed=1, device="cpu")
actor.learn(4_000)

# %%
network = from_sb3(actor)
print(network, network.agreement)
print(network.evaluate(gymnasium.make("CartPole-v1"), 10))
print(*network.export_c("policy", prefix="actor"), sep="\n")
print(f"equal bits on {network.verify()} states")

# %% [markdown]
# `evaluate_policy` of Stable-Baselines3 takes our models, too.

# %%
graph = TPG("CartPole-v1", seed=1).learn(500_000, target=475)
print(evaluate_policy(graph, gymnasium.make("CartPole-v1"), n_eval_episodes=5, warn=False))  # type: ignore[arg-type, unused-ignore]
print(graph.report("m4f"))
