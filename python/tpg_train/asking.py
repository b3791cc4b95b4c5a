"""A graph and a network on one environment: the network decides where the graph asks, or where rules call it."""

from __future__ import annotations

import itertools
from copy import copy
from typing import Any, Union

import gymnasium
import numpy as np
from gymnasium import spaces

from ._tpg import InputError, Switch
from .network import NetworkPolicy, PathLike

MOST_ACTIONS = 4096


class Asking(gymnasium.Wrapper[Any, Any, Any, Any]):
    """One more action, the last: a network decides this step, and `price` is taken from the reward.

    `TPG(Asking(env, network, price=1))` learns when the network is worth it; its `graph.json` says which action asks. Values
    become `levels`, evenly spaced from minimum to maximum; every combination is an action. With `levels=None` nobody can
    ask, actions stay as they are, and only rules call the network.

    Rules watch the distance to the goal: the reward of the last action with its sign changed, or `info["distance"]`. The
    network takes over when the distance exceeds its minimum so far by more than `separation`, or after `patience` actions of
    the graph without a new minimum, and hands back after `hand_back_after` actions; None is never.

    Args:
        network: decides, as `from_sb3` and `train_network` make it, or its `policy.q.json`.
        price: of one ask, in units of the reward. The rules' turns cost nothing.

    Attributes: `episodes`, `actions`, `asks` and `network_actions` (asked or by rules) since the wrapper was made.
    """

    def __init__(
        self,
        env: gymnasium.Env[Any, Any],
        network: Union[NetworkPolicy, PathLike],
        *,
        price: float = 0.0,
        levels: int | None = 3,
        separation: float = float("inf"),
        patience: int | None = None,
        hand_back_after: int | None = None,
    ) -> None:
        super().__init__(env)
        if not price >= 0:
            raise InputError(f"a price of {price}; accepted: 0 or more")
        self._network = network if isinstance(network, NetworkPolicy) else NetworkPolicy.load(network, env)
        self.price = float(price)
        self._rules = (float(separation), patience, hand_back_after)
        Switch(0.0, *self._rules)
        self._own = _actions(env.action_space, levels)
        self.asks_network = self._own is not None
        if self._own is not None:
            self.action_space = spaces.Discrete(len(self._own) + 1)
        self.episodes = self.actions = self.asks = self.network_actions = 0
        self._begin(np.inf)

    def _begin(self, distance: float) -> None:
        self._switch = Switch(distance, *self._rules)

    def reset(self, *, seed: int | None = None, options: dict[str, Any] | None = None) -> tuple[Any, dict[str, Any]]:
        """Starts an episode."""
        observation, info = self.env.reset(seed=seed, options=options)
        self.episodes += 1
        self._begin(float(info.get("distance", np.inf)))
        self._observation = observation
        return observation, info

    def step(self, action: Any) -> tuple[Any, Any, bool, bool, dict[str, Any]]:
        """Takes an action of the graph, or the network's where the graph asks or the network has its turn."""
        drives = self._switch.network_drives
        asked = not drives and self._own is not None and int(action) == len(self._own)
        if drives or asked:
            inner, _ = self._network.predict(self._observation)
        else:
            # A copy: an environment may change what it is given.
            inner = action if self._own is None else copy(self._own[int(action)])
        observation, reward, terminated, truncated, info = self.env.step(inner)
        self.actions += 1
        self.asks += asked
        self.network_actions += drives or asked
        self._switch.acted(asked, float(info.get("distance", -float(reward))))
        paid = float(reward) - self.price if asked else reward
        self._observation = observation
        return observation, paid, terminated, truncated, info


def _actions(space: spaces.Space[Any], levels: int | None) -> list[Any] | None:
    """Returns the graph's own actions; None where it keeps the environment's."""
    if levels is None:
        return None
    if isinstance(space, spaces.Discrete):
        return [int(space.start) + choice for choice in range(int(space.n))]
    if not isinstance(space, spaces.Box) or len(space.shape) != 1:
        raise InputError(f"the action space {space}; accepted: Discrete, or a flat Box")
    if levels < 2 or levels ** len(space.low) >= MOST_ACTIONS:
        raise InputError(f"{levels} levels of {len(space.low)} values; accepted: from 2, below {MOST_ACTIONS} combinations")
    values = [np.linspace(low, high, levels) for low, high in zip(space.low, space.high, strict=True)]
    return [np.asarray(combination, dtype=space.dtype) for combination in itertools.product(*values)]


__all__ = ["Asking"]
