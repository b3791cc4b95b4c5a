"""The honest rivals of a small policy: a linear one by random search, and a decision tree that imitates the policy."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import gymnasium
import numpy as np

STEP, NOISE, DIRECTIONS, TOP = 0.02, 0.05, 8, 4
TREE_EPISODES, TREE_ROUNDS = 40, 3


def literal(value: float) -> str:
    """Returns a C literal of a float."""
    return f"{np.format_float_scientific(np.float32(value), unique=True, trim='0')}F"


class Linear:
    """A weighted sum of the observation for each output, or for each action, of which the greatest is taken."""

    def __init__(self, space: gymnasium.Space[Any], weights: np.ndarray) -> None:
        self.space, self.weights = space, np.asarray(weights, dtype=np.float32)

    def reset(self) -> None:
        """Begins an episode."""

    def __call__(self, observation: Any) -> Any:
        sums = self.weights[:, :-1] @ np.asarray(observation, dtype=np.float32) + self.weights[:, -1]
        if isinstance(self.space, gymnasium.spaces.Discrete):
            return int(np.argmax(sums))
        return np.clip(sums, self.space.low, self.space.high).astype(np.float32)

    def c(self, name: str) -> str:
        """Returns it as C."""
        rows = [
            "".join(f" + {literal(weight)} * s[{at}]" for at, weight in enumerate(row[:-1]) if weight)
            for row in self.weights.astype(float)
        ]
        sums = "".join(
            f"    float v{at} = {literal(row[-1])}{terms};\n" for at, (row, terms) in enumerate(zip(self.weights, rows))
        )
        if isinstance(self.space, gymnasium.spaces.Discrete):
            best = "".join(f"    if (v{at} > v0) {{ v0 = v{at}; best = {at}; }}\n" for at in range(1, len(rows)))
            return f"int {name}(const float *s) {{\n{sums}    int best = 0;\n{best}    return best;\n}}\n"
        bounds = zip(self.space.low, self.space.high)
        ends = "".join(
            f"    a[{at}] = v{at} < {literal(low)} ? {literal(low)} : v{at} > {literal(high)} ? {literal(high)} : v{at};\n"
            for at, (low, high) in enumerate(bounds)
        )
        return f"void {name}(const float *s, float *a) {{\n{sums}{ends}}}\n"


def episode(env: gymnasium.Env[Any, Any], policy: Any, seed: int) -> tuple[float, int, list[Any]]:
    """Runs an episode; returns its return, its number of actions, and what was observed."""
    observation, _ = env.reset(seed=seed)
    policy.reset()
    total, seen, over = 0.0, [], False
    while not over:
        seen.append(observation)
        observation, reward, ended, cut, _ = env.step(policy(observation))
        total += float(reward)
        over = ended or cut
    return total, len(seen), seen


def random_search(env: gymnasium.Env[Any, Any], steps: int, seed: int) -> tuple[Linear, int]:
    """Augmented random search, V2-t of Mania, Guy and Recht (2018): a linear policy of normalised observations, the normalisation
    folded into its weights; of all that it came to, the best by 20 episodes of its own."""
    draw = np.random.default_rng(seed)
    inputs = int(np.prod(env.observation_space.shape or (1,)))
    space = env.action_space
    outputs = int(space.n) if isinstance(space, gymnasium.spaces.Discrete) else int(np.prod(space.shape))
    weights = np.zeros((outputs, inputs))
    count, mean, spread, done = 1e-4, np.zeros(inputs), np.ones(inputs) * 1e-4, 0
    best: tuple[float, Linear] | None = None

    def folded(of: np.ndarray) -> Linear:
        scaled = of / np.sqrt(spread / count + 1e-8)
        return Linear(space, np.column_stack([scaled, -scaled @ mean]))

    generation = 0
    while done < steps:
        directions = draw.standard_normal((DIRECTIONS, outputs, inputs))
        scores = np.zeros((DIRECTIONS, 2))
        visited = []
        for place, direction in enumerate(directions):
            for side, sign in enumerate((1.0, -1.0)):
                policy = folded(weights + sign * NOISE * direction)
                score, length, seen = episode(env, policy, int(draw.integers(2**31)))
                scores[place, side] = score
                done += length
                visited.extend(seen)
        top = np.argsort(-scores.max(axis=1))[:TOP]
        deviation = scores[top].std() + 1e-8
        for place in top:
            weights += STEP / (TOP * deviation) * (scores[place, 0] - scores[place, 1]) * directions[place]
        fresh = np.asarray(visited, dtype=float).reshape(len(visited), -1)
        total = count + len(fresh)
        shift = fresh.mean(axis=0) - mean
        spread += ((fresh - fresh.mean(axis=0)) ** 2).sum(axis=0) + shift**2 * count * len(fresh) / total
        mean, count = mean + shift * len(fresh) / total, total
        generation += 1
        if generation % 10 == 0 or done >= steps:
            policy = folded(weights)
            played = [episode(env, policy, 50_000_000 + at) for at in range(20)]
            done += sum(length for _, length, *_ in played)
            score = float(np.mean([score for score, *_ in played]))
            if best is None or score > best[0]:
                best = (score, policy)
    assert best is not None
    return best[1], done


class Tree:
    """A decision tree that imitates a policy."""

    def __init__(self, space: gymnasium.Space[Any], tree: Any) -> None:
        self.space, self.tree = space, tree
        self._discrete = isinstance(space, gymnasium.spaces.Discrete)
        inner = tree.tree_
        self._parts = (inner.feature, inner.threshold.astype(np.float32), inner.children_left, inner.children_right)
        self._values = [self._value(node) for node in range(inner.node_count)]

    def _value(self, node: int) -> Any:
        value = self.tree.tree_.value[node]
        if self._discrete:
            return int(self.tree.classes_[int(np.argmax(value[0]))])
        return value[:, 0].astype(np.float32)

    def reset(self) -> None:
        """Begins an episode."""

    def __call__(self, observation: Any) -> Any:
        feature, threshold, left, right = self._parts
        state, node = np.asarray(observation, dtype=np.float32), 0
        while left[node] >= 0:
            node = left[node] if state[feature[node]] <= threshold[node] else right[node]
        return self._values[node]

    def c(self, name: str) -> str:
        """Returns it as C."""
        feature, threshold, left, right = self._parts

        def lines(node: int, indent: str) -> str:
            if left[node] < 0:
                value = self._values[node]
                if self._discrete:
                    return f"{indent}return {value};\n"
                return (
                    "".join(f"{indent}a[{at}] = {literal(one)};\n" for at, one in enumerate(value))
                    + f"{indent}return;\n"
                )
            inner = indent + "    "
            return (
                f"{indent}if (s[{feature[node]}] <= {literal(threshold[node])}) {{\n{lines(left[node], inner)}{indent}}}\n"
                f"{lines(right[node], indent)}"
            )

        head = f"int {name}(const float *s)" if self._discrete else f"void {name}(const float *s, float *a)"
        return f"{head} {{\n{lines(0, '    ')}}}\n"


def distilled(env: gymnasium.Env[Any, Any], teacher: Any, leaves: int) -> Tree:
    """Fits a tree to a teacher's answers: first where the teacher goes, then where the tree goes (DAgger)."""
    from sklearn.tree import DecisionTreeClassifier, DecisionTreeRegressor

    kind = DecisionTreeClassifier if isinstance(env.action_space, gymnasium.spaces.Discrete) else DecisionTreeRegressor
    states: list[Any] = []
    policy, tree = teacher, None
    for turn in range(TREE_ROUNDS + 1):
        for at in range(TREE_EPISODES):
            states.extend(episode(env, policy, 60_000_000 + 1_000 * turn + at)[2])
        answers = np.asarray([np.asarray(teacher(state)) for state in states])
        fitted = kind(max_leaf_nodes=leaves, random_state=0).fit(np.asarray(states, dtype=np.float32), answers)
        policy = tree = Tree(env.action_space, fitted)
    assert tree is not None
    return tree


def write_c(policy: Linear | Tree, name: str, folder: Path) -> Path:
    """Writes a rival's C into a folder."""
    file = folder / f"{name}.c"
    file.write_text(policy.c(name))
    return file
