#!/usr/bin/env python3
"""Decision trees of emlearn that imitate the shipped policies, beside these policies in integers, on a Cortex-M0.

    python benches/control/distilled.py [--episodes 1000] [--only cartpole]

Needs what `integers.py` needs, scikit-learn and `emlearn==0.23.2`. A tree sees the same observation in counts of 16 bits. It learns
from the policy's answers, first where the policy goes, then three times where the tree goes (DAgger, 40 episodes each). Of trees of
4 to 1,024 leaves, one for each output, the smallest is taken whose mean return of 100 episodes is at most one standard error below
the policy's, else the best. Both then play the same other episodes. Bytes and instructions of a tree are those of emlearn's
inline function of `int16_t` without its vote. Prints a table in Markdown.
"""

from __future__ import annotations

import argparse
import json
import re
import subprocess
import tempfile
from pathlib import Path
from typing import Any

import emlearn
import gymnasium
import numpy as np
from generated import BOUND, ROOT, Policy, flash_of
from integers import cost
from rivals import Tree, episode
from sklearn.tree import DecisionTreeClassifier, DecisionTreeRegressor
from table import FIRST_SEED, PROBLEMS

from tpg_train import TPG

M0 = ["arm-none-eabi-gcc", "-mcpu=cortex-m0", "-mthumb", "-Os", "-std=c99", "-c"]
# emlearn makes numpy raise errors, which environments do not expect.
np.seterr(all="warn", under="ignore")
LEAVES = (4, 8, 16, 32, 64, 128, 256, 512, 1024)
EPISODES, ROUNDS, CHOICE = 40, 4, 100


class Trees:
    """A tree for each output, or one for the action."""

    def __init__(self, env: gymnasium.Env[Any, Any], scales: np.ndarray, states: list[Any], answers: Any, leaves: int) -> None:
        self.scales = scales
        counts = np.asarray([self.counts(state) for state in states])
        self.is_discrete = isinstance(env.action_space, gymnasium.spaces.Discrete)
        kind = DecisionTreeClassifier if self.is_discrete else DecisionTreeRegressor
        columns = np.asarray(answers).reshape(len(states), -1).T
        self.fitted = [kind(max_leaf_nodes=leaves, random_state=0).fit(counts, column) for column in columns]
        self.trees = [Tree(env.action_space, fitted) for fitted in self.fitted]

    def counts(self, observation: Any) -> np.ndarray:
        """Returns an observation in counts of 16 bits."""
        return np.clip(np.round(np.asarray(observation, dtype=float).ravel() / self.scales), -32768, 32767)

    def reset(self) -> None:
        """Begins an episode."""

    def __call__(self, observation: Any) -> Any:
        counts = self.counts(observation)
        answers = [tree(counts) for tree in self.trees]
        return answers[0] if self.is_discrete else np.concatenate(answers).astype(np.float32)

    def cost(self, folder: Path) -> tuple[int, int]:
        """Returns bytes and the most instructions on a Cortex-M0."""
        kind = "int32_t" if self.is_discrete else "float"
        text, calls = "#include <stdint.h>\n", ""
        for place, fitted in enumerate(self.fitted):
            how = "classifier" if self.is_discrete else "regressor"
            model = emlearn.convert(fitted, method="inline", dtype="int16_t", return_type=how)
            code = model.save(name=f"t{place}", format="c")
            found = re.search(r"static inline .*?\n {8}\}\n", code, re.DOTALL)
            assert found is not None, code
            text += found[0]
            calls += f"    a[{place}] = t{place}_tree_0(s, {fitted.n_features_in_});\n"
        source = folder / "trees.c"
        source.write_text(f"{text}void decide(const int16_t *s, {kind} *a)\n{{\n{calls}}}\n")
        thing = folder / "trees.o"
        subprocess.run([*M0, str(source), "-o", str(thing)], check=True)
        bound = subprocess.run([str(BOUND), str(thing), "decide", "--json"], check=True, capture_output=True, text=True)
        return flash_of(thing), json.loads(bound.stdout.splitlines()[0])["instructions"]


def returns(env: gymnasium.Env[Any, Any], policy: Any, first: int, episodes: int) -> np.ndarray:
    """Returns a policy's returns on some episodes."""
    return np.array([episode(env, policy, first + at)[0] for at in range(episodes)])


def distilled(env: gymnasium.Env[Any, Any], teacher: Any, scales: np.ndarray, leaves: int) -> Trees:
    """Fits trees to a teacher's answers."""
    states: list[Any] = []
    policy: Any = teacher
    for turn in range(ROUNDS):
        for at in range(EPISODES):
            states.extend(episode(env, policy, 60_000_000 + 1_000 * turn + at)[2])
        policy = Trees(env, scales, states, [np.asarray(teacher(state)) for state in states], leaves)
    return policy


def main() -> None:
    """Prints the table."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--episodes", type=int, default=1000)
    parser.add_argument("--only")
    given = parser.parse_args()
    print("| task | leaves | return: tree | less the policy | bytes: tree, integers | instructions |")
    print("| --- | --: | --: | --- | --: | --: |")
    for problem in PROBLEMS:
        if given.only not in (None, problem.name):
            continue
        place = ROOT / "generated" / problem.name
        model = TPG.load(place / "graph.json", problem.id, native=False)
        whole = model.quantise()
        wide = model.quantise(bits=16)
        scales = np.array([count["scale"] for part in json.loads(wide.graph.to_json())["sources"] for count in part["counts"]])
        env = gymnasium.make(problem.id)
        with tempfile.TemporaryDirectory() as folder:
            teacher = Policy(place / "graph.json", place / f"{problem.name.replace('-', '_')}.c", Path(folder))
            aim = returns(env, teacher, FIRST_SEED - CHOICE, CHOICE)
            floor = aim.mean() - aim.std(ddof=1) / np.sqrt(CHOICE)
            best: tuple[float, int, Trees] | None = None
            for leaves in LEAVES:
                trees = distilled(env, teacher, scales, leaves)
                mean = float(returns(env, trees, FIRST_SEED - CHOICE, CHOICE).mean())
                if best is None or mean > best[0]:
                    best = (mean, leaves, trees)
                if mean >= floor:
                    break
            assert best is not None
            _, leaves, trees = best
            tree = returns(env, trees, FIRST_SEED, given.episodes)
            less = tree - returns(env, teacher, FIRST_SEED, given.episodes)
            half = 1.96 * less.std(ddof=1) / np.sqrt(len(less))
            (bytes_, instructions), (own_bytes, own) = trees.cost(Path(folder)), cost(whole)
        row = (
            f"{leaves:,} | {tree.mean():,.2f} | {less.mean():+.2f} ± {half:.2f} | {bytes_:,}, {own_bytes:,} "
            f"| {instructions:,}, {own:,} |"
        )
        print(f"| {problem.id} | {row.replace('-', '−')}", flush=True)


if __name__ == "__main__":
    main()
