"""The figures that a model returns."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np

from ._tpg import Graph


@dataclass(frozen=True)
class Evaluation:
    """The result of a policy on test episodes; `ci95` is the 95 % interval of the mean return."""

    episodes: int
    mean: float
    std: float
    min: float
    ci95: tuple[float, float]
    mean_steps: float
    success_rate: float | None
    environment: str

    @classmethod
    def of(cls, played: Sequence[tuple[float, int, bool | None, float]], environment: str) -> Evaluation:
        """Takes return, number of actions, success and last reward of each episode."""
        scores = np.asarray([score for score, *_ in played])
        successes = [success for _, _, success, _ in played if success is not None]
        std = float(scores.std(ddof=1)) if len(scores) > 1 else 0.0
        return cls(
            episodes=len(played),
            mean=float(scores.mean()),
            std=std,
            min=float(scores.min()),
            ci95=interval(float(scores.mean()), std, len(played)),
            mean_steps=float(np.mean([steps for _, steps, *_ in played])),
            success_rate=sum(successes) / len(successes) if successes else None,
            environment=environment,
        )

    @classmethod
    def of_report(cls, report: dict[str, Any]) -> Evaluation:
        """Takes the figures of `tpg-train eval`."""
        mean, std, episodes = report["mean_score"], report["std_score"], report["episodes"]
        return cls(
            episodes=episodes,
            mean=mean,
            std=std,
            min=report["min_score"],
            ci95=interval(mean, std, episodes),
            mean_steps=report["mean_steps"],
            success_rate=report["success_rate"],
            environment=f"built-in {report['problem']}",
        )

    def __str__(self) -> str:
        low, high = self.ci95
        success = "" if self.success_rate is None else f", {100 * self.success_rate:.1f} % solved"
        return (
            f"{self.mean:.2f} on {self.episodes} episodes of {self.environment} (95 % interval of the mean {low:.2f} to "
            f"{high:.2f}, standard deviation {self.std:.2f}, lowest {self.min:.2f}){success}"
        )


def interval(mean: float, std: float, count: int) -> tuple[float, float]:
    """Returns the 95 % interval of a mean."""
    half = 1.959963984540054 * std / math.sqrt(count)
    return mean - half, mean + half


@dataclass(frozen=True)
class HallEntry:
    """A policy of the hall of fame: its size in lines and edges, and its mean return on the validation episodes."""

    size: int
    score: float
    graph: Graph


class Report:
    """What code costs: `data` holds every figure, `str()` is a table."""

    def __init__(self, text: str, data: dict[str, Any]) -> None:
        self.text, self.data = text, data

    def __str__(self) -> str:
        return self.text

    __repr__ = __str__


class Proof:
    """The comparison of generated code with the interpreter: `data` holds every figure, `str()` is a sentence for each."""

    def __init__(self, data: dict[str, Any]) -> None:
        self.data = data

    @property
    def differences(self) -> int:
        """The number of answers that differ."""
        return sum(comparison["differences"] for comparison in self.data["comparisons"])

    def __str__(self) -> str:
        lines = [
            f"{one['engine']} = interpreter on {one['states']} states"
            if one["differences"] == 0
            else f"{one['engine']} differs from the interpreter on {one['differences']} of {one['states']} states: {one['first']}"
            for one in self.data["comparisons"]
        ]
        return "\n".join([*lines, *(f"not verified: {one['engine']}: {one['error']}" for one in self.data["unproven"])])

    __repr__ = __str__
