"""Two controllers on the same episodes."""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from dataclasses import asdict, dataclass, field
from typing import Any

import gymnasium
import numpy as np

from ._tpg import InputError, success_of
from .reports import Evaluation, interval

Played = tuple[float, int, "bool | None", float]
# Answers the observations of one episode.
Act = Callable[[Any], Any]


@dataclass(frozen=True)
class Effort:
    """Wear of actuators: `saturated` is the share of steps with a component at a bound, `chatter` the mean change of a component
    from step to step, as a share of its range."""

    saturated: float
    chatter: float


@dataclass(frozen=True)
class Comparison:
    """Two controllers on the same episodes: `difference` is the mean of this model's return less the other's, `ci95` its 95 %
    interval; `efforts` are both controllers', None where actions are named; `law` is the formula of a controller that was
    tuned for this; `returns` are those of each episode."""

    name: str
    this: Evaluation
    other: Evaluation
    difference: float
    ci95: tuple[float, float]
    efforts: tuple[Effort, Effort] | None
    law: str | None
    returns: tuple[list[float], list[float]] = field(repr=False)

    def __str__(self) -> str:
        return str(Comparisons((self,)))

    def difference_text(self) -> str:
        """Returns the difference with its interval."""
        return f"{self.difference:+.2f}, 95 % interval {self.ci95[0]:+.2f} to {self.ci95[1]:+.2f}"

    def verdict(self) -> str:
        """Returns which of the two is better."""
        low, high = self.ci95
        return "no clear difference" if low <= 0 <= high else f"{'this model' if low > 0 else self.name} is better"

    def as_json(self) -> dict[str, Any]:
        """Returns the other controller as a line of `tested.jsonl` holds it."""
        effort = None if self.efforts is None else asdict(self.efforts[1])
        return {"name": self.name, "law": self.law, "scores": self.returns[1], "effort": effort}


class Comparisons(tuple[Comparison, ...]):
    """A model beside several controllers, on the same episodes."""

    __slots__ = ()

    def __str__(self) -> str:
        played = [("this model", self[0].this, self[0].efforts and self[0].efforts[0])]
        played += [(one.name, one.other, one.efforts and one.efforts[1]) for one in self]
        head = [f"{len(self[0].returns[0])} episodes", "mean", "95 % interval", "lowest"]
        rows = [head + ["saturated", "chatter"] * (self[0].efforts is not None)]
        for name, result, effort in played:
            wear = [] if effort is None else [f"{100 * effort.saturated:.1f} %", f"{effort.chatter:.4f}"]
            low, high = result.ci95
            rows.append([name, f"{result.mean:.2f}", f"{low:.2f} to {high:.2f}", f"{result.min:.2f}", *wear])
        widths = [max(map(len, column)) for column in zip(*rows, strict=True)]
        lines = ["  ".join([row[0].ljust(widths[0]), *map(str.rjust, row[1:], widths[1:])]) for row in rows]
        lines += [f"this model - {one.name}: {one.difference_text()}: {one.verdict()}" for one in self]
        return "\n".join([*lines, *(f"the law of {one.name}: {one.law}" for one in self if one.law is not None)])


def play(
    env: gymnasium.Env[Any, Any], start: Callable[[], Act], seeds: Sequence[int], limit: int
) -> tuple[list[Played], Effort | None]:
    """Plays an episode for each seed; `start` gives a controller for an episode.

    Returns return, number of steps, success and last reward of each, and the effort where actions are a bounded Box.
    """
    space = env.action_space
    bounded = isinstance(space, gymnasium.spaces.Box) and space.is_bounded() and bool(np.all(space.low < space.high))
    played: list[Played] = []
    steps, saturated, changes, changed = 0, 0, 0, 0.0
    for seed in seeds:
        act, last = start(), None
        observation, _ = env.reset(seed=seed)
        score, length, done, success, earned = 0.0, 0, False, None, 0.0
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
            earned = float(reward)
            score, length, done = score + earned, length + 1, bool(terminated or truncated)
            success = success_of(info) if done else None
        played.append((score, length, success, earned))
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
    env: gymnasium.Env[Any, Any], this: Callable[[], Act], others: Sequence[Any], seeds: Sequence[int], limit: int, name: str
) -> tuple[list[Played], Comparisons]:
    """Plays the same episodes with each controller; returns this one's, and the comparisons."""
    starts = [this, *map(controller, others)]
    ours, *all_theirs = (play(env, start, seeds, limit) for start in starts)
    kinds = [getattr(other, "kind", None) or getattr(other, "__name__", None) or type(other).__name__ for other in others]
    return ours[0], Comparisons(beside(ours, theirs, kind, name) for kind, theirs in zip(kinds, all_theirs, strict=True))


def beside(
    ours: tuple[list[Played], Effort | None], theirs: tuple[list[Played], Effort | None], kind: str, name: str
) -> Comparison:
    """Compares what two controllers have played; `name` is the environment's."""
    returns = [score for score, *_ in ours[0]], [score for score, *_ in theirs[0]]
    if np.isnan(returns[1]).any():
        raise InputError(f"a return of NaN by {kind}; accepted: numbers")
    differences = np.subtract(*returns)
    mean, count = float(differences.mean()), len(differences)
    deviation = float(differences.std(ddof=1)) if count > 1 else math.inf
    return Comparison(
        name=kind,
        this=Evaluation.of(ours[0], name),
        other=Evaluation.of(theirs[0], name),
        difference=mean,
        ci95=interval(mean, deviation, count),
        efforts=None if ours[1] is None or theirs[1] is None else (ours[1], theirs[1]),
        law=None,
        returns=returns,
    )
