"""From a Gymnasium environment to a proven C function of a few hundred bytes.

from tpg_train import TPG

model = TPG("CartPole-v1", seed=1)
model.learn(total_timesteps=200_000, target=475)
print(model.evaluate(1000), model.formula(), model.report("m4f"))
model.export_c("policy/", prefix="cart")
model.verify()
"""

from ._tpg import Graph, InputError, TrainingError, __version__
from .asking import Asking
from .comparing import Comparison, Effort
from .envs import register_envs
from .model import TPG, Candidate, StatefulEnvironmentWarning, VerificationError
from .network import NetworkPolicy, from_sb3, train_network
from .reports import Evaluation, HallEntry, Proof, Report

register_envs()

__all__ = [
    "TPG",
    "Asking",
    "Candidate",
    "Comparison",
    "Effort",
    "Evaluation",
    "Graph",
    "HallEntry",
    "InputError",
    "NetworkPolicy",
    "Proof",
    "Report",
    "StatefulEnvironmentWarning",
    "TrainingError",
    "VerificationError",
    "__version__",
    "from_sb3",
    "register_envs",
    "train_network",
]
