"""The simplest rival for size: weights by covariance matrix adaptation, the least of them left out; no evolution."""

from __future__ import annotations

from typing import Any

import gymnasium
import numpy as np
from rivals import Linear, episode

EPISODES, DEVIATION, EXPLORED = 2, 0.5, 2_000
PRUNING_EPISODES, PRUNING_SHARE = 50, 0.2
FIRST_OWN_SEED = 60_000_000


class Adaptation:
    """Covariance matrix adaptation (Hansen's tutorial), from 0 with the same deviation everywhere."""

    def __init__(self, numbers: int) -> None:
        self.count = 4 + int(3 * np.log(numbers))
        self.mean, self.deviation, self.covariance = np.zeros(numbers), DEVIATION, np.eye(numbers)
        self._path, self._step_path, self._updates = np.zeros(numbers), np.zeros(numbers), 0

    def samples(self, draw: np.random.Generator) -> np.ndarray:
        """Returns the samples of a generation."""
        factor = np.linalg.cholesky(self.covariance)
        return self.mean + self.deviation * draw.standard_normal((self.count, len(self.mean))) @ factor.T

    def update(self, ranked: np.ndarray) -> None:
        """Moves towards the better half of samples, which are given best first."""
        n, parents = len(self.mean), len(ranked) // 2
        weights = np.log(parents + 0.5) - np.log(np.arange(1, parents + 1))
        weights /= weights.sum()
        effective = 1 / (weights**2).sum()
        path_rate = (4 + effective / n) / (n + 4 + 2 * effective / n)
        step_rate = (effective + 2) / (n + effective + 5)
        one = 2 / ((n + 1.3) ** 2 + effective)
        many = min(1 - one, 2 * (effective - 2 + 1 / effective) / ((n + 2) ** 2 + effective))
        damping = 1 + 2 * max(0.0, np.sqrt((effective - 1) / (n + 1)) - 1) + step_rate
        expected = np.sqrt(n) * (1 - 1 / (4 * n) + 1 / (21 * n * n))
        steps = (ranked[:parents] - self.mean) / self.deviation
        step = weights @ steps
        white = np.linalg.solve(np.linalg.cholesky(self.covariance), step)
        self.mean = self.mean + self.deviation * step
        self._updates += 1
        self._step_path = (1 - step_rate) * self._step_path + np.sqrt(step_rate * (2 - step_rate) * effective) * white
        length = np.linalg.norm(self._step_path)
        settled = np.sqrt(1 - (1 - step_rate) ** (2 * self._updates))
        is_short = length / settled / expected < 1.4 + 2 / (n + 1)
        self._path = (1 - path_rate) * self._path + is_short * np.sqrt(path_rate * (2 - path_rate) * effective) * step
        self.covariance = (
            (1 - one - many) * self.covariance
            + one * np.outer(self._path, self._path)
            + many * (steps * weights[:, None]).T @ steps
        )
        self.deviation *= float(np.exp(np.clip(step_rate / damping * (length / expected - 1), -1, 1)))


def explored(env: gymnasium.Env[Any, Any], seed: int) -> np.ndarray:
    """Returns the deviation of each input under random actions: its unit."""
    env.action_space.seed(seed)
    observation, _ = env.reset(seed=FIRST_OWN_SEED)
    seen = []
    for _ in range(EXPLORED):
        seen.append(observation)
        observation, _, ended, cut, _ = env.step(env.action_space.sample())
        if ended or cut:
            observation, _ = env.reset()
    spread = np.std(np.asarray(seen, dtype=float), axis=0)
    return np.where(spread > 0, spread, 1.0)


def pruned_search(env: gymnasium.Env[Any, Any], steps: int, seed: int) -> tuple[Linear, Linear, int]:
    """Returns the mean of the search, the same without its least weights, and the number of steps.

    The search has four fifths of the steps. Then the weight that moves its sum least, in units of its input, is left out,
    again and again; the smallest policy within a standard error of the best on episodes of its own is taken."""
    draw = np.random.default_rng(seed)
    unit = np.append(explored(env, seed), 1.0)
    space = env.action_space
    is_choice = isinstance(space, gymnasium.spaces.Discrete)
    # Only differences of bids matter: the first one is 0.
    rows = int(space.n) - 1 if is_choice else int(np.prod(space.shape))
    search, done = Adaptation(rows * len(unit)), EXPLORED

    def policy(numbers: np.ndarray) -> Linear:
        weights = numbers.reshape(rows, -1) / unit
        return Linear(space, np.vstack([np.zeros((int(is_choice), len(unit))), weights]))

    def mean(of: Linear, seeds: Any) -> tuple[float, float]:
        nonlocal done
        played = [episode(env, of, int(at)) for at in seeds]
        done += sum(length for _, length, *_ in played)
        returns = np.array([score for score, *_ in played])
        return float(returns.mean()), float(returns.std(ddof=1) / np.sqrt(len(returns)))

    while done < (1 - PRUNING_SHARE) * steps:
        samples, seeds = search.samples(draw), draw.integers(2**31, size=EPISODES)
        scores = [mean(policy(sample), seeds)[0] for sample in samples]
        search.update(samples[np.argsort(scores)[::-1]])
    own = range(FIRST_OWN_SEED, FIRST_OWN_SEED + PRUNING_EPISODES)
    numbers, found = search.mean.copy(), []
    while numbers.any() and (not found or done < steps):
        found.append((*mean(policy(numbers), own), numbers.copy()))
        left = np.flatnonzero(numbers)
        numbers[left[np.argmin(np.abs(numbers[left]))]] = 0.0
    best, error, _ = max(found, key=lambda one: one[0])
    smallest = [numbers for score, _, numbers in found if score >= best - error][-1]
    return policy(search.mean), policy(smallest), done
