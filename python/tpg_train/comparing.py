"""Two controllers on the same episodes."""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import Any

import gymnasium
import numpy as np

from ._tpg import InputError, success_of
from .reports import Evaluation

Played = tuple[float, int, "bool | None"]
# Answers the observations of one episode.
Act = Callable[[Any], Any]


@dataclass(frozen=True)
class Effort:
    """Wear of actuators: `saturated` is the share of steps with a component at a bound, `chatter` the mean change of a component
    from step to step, as a share of its range."""

    saturated: float
    chatter: float

    def __str__(self) -> str:
        return f"{100 * self.saturated:.1f} % of steps saturated, chatter {self.chatter:.4f}"


@dataclass(frozen=True)
class Comparison:
    """Two controllers on the same episodes: `difference` is the mean of this model's return less the other's, `ci95` its 95 %
    interval; `efforts` are both controllers', None where actions are named; `law` is the formula of a controller that was
    tuned for this."""

    this: Evaluation
    other: Evaluation
    difference: float
    ci95: tuple[float, float]
    efforts: tuple[Effort, Effort] | None
    law: str | None = None

    def __str__(self) -> str:
        low, high = self.ci95
        words = "no clear difference" if low <= 0 <= high else "this model is better" if low > 0 else "the other is better"
        efforts = ("", "") if self.efforts is None else tuple(f"; {effort}" for effort in self.efforts)
        law = "" if self.law is None else f"the other's law: {self.law}\n"
        return (
            f"this model: {self.this}{efforts[0]}\nother:      {self.other}{efforts[1]}\n{law}"
            f"difference: {self.difference:+.2f}, 95 % interval {low:+.2f} to {high:+.2f}: {words}"
        )


def play(
    env: gymnasium.Env[Any, Any], start: Callable[[], Act], seeds: Sequence[int], limit: int
) -> tuple[list[Played], Effort | None]:
    """Plays an episode for each seed; `start` gives a controller for an episode.

    Returns return, number of steps and success of each, and the effort where actions are a bounded Box.
    """
    space = env.action_space
    bounded = isinstance(space, gymnasium.spaces.Box) and space.is_bounded() and bool(np.all(space.low < space.high))
    played: list[Played] = []
    steps, saturated, changes, changed = 0, 0, 0, 0.0
    for seed in seeds:
        act, last = start(), None
        observation, _ = env.reset(seed=seed)
        score, length, done, success = 0.0, 0, False, None
        while not done and length < limit:
            action = act(observation)
            if bounded:
                assert isinstance(space, gymnasium.spaces.Box)
                values = np.clip(np.asarray(action, dtype=np.float64), space.low, space.high)
                saturated += bool(np.any((values <= space.low) | (values >= space.high)))
                if last is not None:
                    changed += float(np.mean(np.abs(values - last) / (space.high.astype(np.float64) - space.low)))
                    changes += 1
                last = values
            observation, reward, terminated, truncated, info = env.step(action)
            score, length, done = score + float(reward), length + 1, bool(terminated or truncated)
            success = success_of(info) if done else None
        played.append((score, length, success))
        steps += length
    return played, Effort(saturated / max(steps, 1), changed / max(changes, 1)) if bounded else None


def controller(other: Any) -> Callable[[], Act]:
    """Returns what starts a controller for an episode: of a model with `predict`, or of a function of the observation.

    Raises:
        InputError: if it is neither.
    """
    if hasattr(other, "predict"):

        def start() -> Act:
            state = None

            def act(observation: Any) -> Any:
                nonlocal state
                action, state = other.predict(observation, state=state, deterministic=True)
                return action

            return act

        return start
    if not callable(other):
        raise InputError(f"other={other!r}; accepted: a function of an observation, or a model with predict")
    return lambda: other


def compare(
    env: gymnasium.Env[Any, Any], this: Callable[[], Act], other: Any, seeds: Sequence[int], limit: int, name: str
) -> Comparison:
    """Plays the same episodes with both controllers."""
    (ours, effort), (theirs, other_effort) = (play(env, start, seeds, limit) for start in (this, controller(other)))
    differences = np.asarray([mine[0] - its[0] for mine, its in zip(ours, theirs, strict=True)])
    mean = float(differences.mean())
    half = 1.959963984540054 * float(differences.std(ddof=1)) / math.sqrt(len(differences)) if len(differences) > 1 else math.inf
    return Comparison(
        this=Evaluation.of(ours, name),
        other=Evaluation.of(theirs, name),
        difference=mean,
        ci95=(mean - half, mean + half),
        efforts=None if effort is None or other_effort is None else (effort, other_effort),
    )
