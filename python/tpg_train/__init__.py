r"""From a Gymnasium environment to a proven C function of a few hundred bytes.

from tpg_train import TPG

model = TPG("CartPole-v1", seed=1)
model.learn(total_timesteps=200_000, target=475)
print(model.evaluate(1000), model.formula(), model.report("m4f"), sep="\n")
model.export_c("policy/", prefix="cart")
model.verify()
"""

from typing import TYPE_CHECKING, Any

from . import wrappers
from ._tpg import Graph, InputError, TrainingError, __version__
from .asking import Asking
from .comparing import Comparison, Comparisons, Effort
from .envs import register_envs
from .model import TPG, Candidate, StatefulEnvironmentWarning, VerificationError
from .network import NetworkPolicy, from_sb3, train_network
from .reports import Evaluation, HallEntry, Proof, Report

if TYPE_CHECKING:
    from .classifier import TPGClassifier as TPGClassifier

register_envs()


def __getattr__(name: str) -> Any:
    """Imports what needs scikit-learn when it is asked for."""
    if name == "TPGClassifier":
        from .classifier import TPGClassifier

        return TPGClassifier
    raise AttributeError(f"module {__name__!r} has no attribute {name!r}")


__all__ = [
    "TPG",
    "Asking",
    "Candidate",
    "Comparison",
    "Comparisons",
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
    "wrappers",
]
