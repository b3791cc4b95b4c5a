"""Wrappers that help small policies, and wrappers that help training."""

from __future__ import annotations

import functools
from collections.abc import Callable
from typing import Any

import gymnasium
import numpy as np
from gymnasium import spaces
from gymnasium.wrappers import FlattenObservation

__all__ = ["Differences", "FlattenObservation", "Fresh"]


class Differences(gymnasium.ObservationWrapper[Any, Any, Any], gymnasium.utils.RecordConstructorArgs):
    """Adds the change of each value since the last step: what a policy without memory needs where speeds are hidden.

    The observation becomes a Dict of `now` and `change`, whose names formulas keep; of a Dict observation each is a Dict of the
    same keys, without those of choices, which do not change by an amount. On the firmware's side the caller subtracts the last
    observation from the new one; the first change is 0.
    """

    def __init__(self, env: gymnasium.Env[Any, Any]) -> None:
        gymnasium.utils.RecordConstructorArgs.__init__(self)
        super().__init__(env)
        space = env.observation_space
        change = _changes(space)
        if change is None:
            raise ValueError(f"the observation {space}; accepted: a flat Box, as FlattenObservation gives it, or a Dict with one")
        self._changes = change
        self.observation_space = spaces.Dict({"now": space, "change": change})
        self._last: Any = None

    def reset(self, *, seed: int | None = None, options: dict[str, Any] | None = None) -> tuple[Any, dict[str, Any]]:
        """Starts an episode."""
        self._last = None
        return super().reset(seed=seed, options=options)

    def observation(self, observation: Any) -> dict[str, Any]:
        """Returns the values and their changes."""
        now = _numbers(observation, self._changes)
        change = _difference(now, now if self._last is None else self._last)
        self._last = now
        return {"now": observation, "change": change}


def _changes(space: spaces.Space[Any]) -> spaces.Space[Any] | None:
    """Returns the space of differences of two observations; None where nothing is a flat Box."""
    if isinstance(space, spaces.Dict):
        changes = {key: _changes(inner) for key, inner in space.spaces.items()}
        found = {key: change for key, change in changes.items() if change is not None}
        return spaces.Dict(found) if found else None
    if not isinstance(space, spaces.Box) or len(space.shape) > 1:
        return None
    reach = np.subtract(space.high, space.low, dtype=np.float32)
    return spaces.Box(-reach, reach, dtype=np.float32)


def _numbers(observation: Any, space: spaces.Space[Any]) -> Any:
    """Returns a copy, which no environment changes, of the values of an observation that change by an amount."""
    if isinstance(space, spaces.Dict):
        return {key: _numbers(observation[key], inner) for key, inner in space.spaces.items()}
    return np.array(observation, dtype=np.float32)


def _difference(now: Any, before: Any) -> Any:
    if isinstance(now, dict):
        return {key: _difference(value, before[key]) for key, value in now.items()}
    return now - before


class Fresh(gymnasium.Wrapper[Any, Any, Any, Any]):
    """Makes a new environment for each episode, where the state of one survives `reset(seed=...)`, as that of BipedalWalker-v3.

    Episodes can then be repeated: results depend neither on their order nor on the number of workers. Making an environment
    takes time, most of all where episodes are short.

    Args:
        make: a registered id, or a function that makes an environment.
    """

    def __init__(self, make: str | Callable[[], gymnasium.Env[Any, Any]]) -> None:
        if not (isinstance(make, str) or callable(make)):
            raise ValueError(f"{make!r}; accepted: a registered id, or a function that makes an environment")
        self._make: Callable[[], gymnasium.Env[Any, Any]] = (
            functools.partial(gymnasium.make, make) if isinstance(make, str) else make
        )
        self._is_new = True
        super().__init__(self._make())

    def reset(self, *, seed: int | None = None, options: dict[str, Any] | None = None) -> tuple[Any, dict[str, Any]]:
        """Starts an episode in an environment that has had none."""
        if not self._is_new:
            self.env.close()
            self.env = self._make()
        self._is_new = False
        return self.env.reset(seed=seed, options=options)
