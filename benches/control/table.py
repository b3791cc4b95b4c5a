#!/usr/bin/env python3
"""The shipped policies on real Gymnasium, driven by their generated C, beside other people's and other kinds of policies.

    cargo build --release -p tpg-codegen -p cortex-bound
    python3 -m venv control && control/bin/pip install "gymnasium[box2d,mujoco]==1.4.0" scikit-learn
    control/bin/python benches/control/table.py [--episodes 1000] [--rivals] [--only cartpole] [--json FILE]

Every policy plays the same episodes, seeds 10,000,000 and up, which nothing was trained or chosen on. A return has its 95 %
interval; bytes are code and constants for a Cortex-M4F, `arm-none-eabi-gcc -Os`, instructions the most that one decision takes
(`cortex-bound`). `--rivals` trains linear policies with the same number of steps for everybody, by augmented random search and by
covariance matrix adaptation, leaves the least weights of the second out, and distils decision trees from the shipped policy; it
takes minutes. `--agents` trains agents of Stable-Baselines3 with the zoo's settings where that takes minutes, and puts them into
integers; it needs `stable-baselines3` and this project's Python package, too. Published returns are those of Stable-Baselines3's zoo
where it has the problem.
Prints a table in Markdown.
"""

from __future__ import annotations

import argparse
import json
import sys
import tempfile
from dataclasses import asdict, dataclass
from pathlib import Path
from typing import Any

import gymnasium
import numpy as np
from agents import RECIPES, Agent, Integers, trained
from generated import ROOT, Policy, built, flash_of, footprint, report
from pruned import pruned_search
from rivals import distilled, episode, random_search, write_c

FIRST_SEED = 10_000_000
TREE_LEAVES = (16, 128)


@dataclass(frozen=True)
class Problem:
    """A problem: its folder under generated/, Gymnasium's id, steps for a linear rival, published returns and their source."""

    name: str
    id: str
    steps: int
    published: dict[str, float]
    source: str = "the zoo"


# benchmark.md of DLR-RM/rl-baselines3-zoo at 22e3ff2 (LunarLander: version 2 of the environments; Swimmer, Hopper: version 3); DDQN+PER
# and CrossQ from docs/BENCHMARKS.md of kengz/SLM-Lab. The zoo has no InvertedDoublePendulum of MuJoCo's: the mean of ten runs from
# deep_rl_data/sumup_rl_results.csv of gegelati/GECCO-2025 (version 4).
PROBLEMS = [
    Problem("cartpole", "CartPole-v1", 200_000, {"PPO": 500.0}),
    Problem("acrobot", "Acrobot-v1", 500_000, {"QR-DQN": -69.1, "PPO": -73.5}),
    Problem("mountain-car", "MountainCar-v0", 500_000, {"DQN": -100.8, "PPO": -110.4, "ARS": -122.0}),
    Problem("mountain-car-continuous", "MountainCarContinuous-v0", 500_000, {"ARS": 96.7, "SAC": 94.7}),
    Problem("pendulum", "Pendulum-v1", 500_000, {"CrossQ": -145.7, "TQC": -151.3}, "SLM-Lab, the zoo"),
    Problem("lunar-lander", "LunarLander-v3", 1_000_000, {"DDQN+PER": 265.9, "PPO": 242.1}, "SLM-Lab, the zoo"),
    Problem("lunar-lander-continuous", "LunarLanderContinuous-v3", 1_000_000, {"TQC": 278.0, "PPO": 270.9}),
    Problem("inverted-double-pendulum", "InvertedDoublePendulum-v5", 1_000_000, {"SAC": 9348.0}, "gegelati/GECCO-2025"),
    Problem("swimmer", "Swimmer-v5", 1_500_000, {"TRPO": 365.7, "TD3": 359.1, "ARS": 355.3}),
    Problem("half-cheetah", "HalfCheetah-v5", 3_000_000, {"TQC": 12090.0, "PPO": 5819.0}),
    Problem("bipedal-walker", "BipedalWalker-v3", 5_000_000, {"TQC": 329.8, "PPO": 287.9}),
    Problem("hopper", "Hopper-v5", 3_000_000, {"TQC": 3754.0, "TRPO": 3618.0, "ARS": 3344.0}),
]


@dataclass(frozen=True)
class Row:
    """A policy's figures."""

    problem: str
    policy: str
    mean: float
    interval: float
    least: float
    flash: int | None
    instructions: int | None
    note: str = ""


def played(problem: Problem, policy: Any, episodes: int) -> tuple[float, float, float]:
    """Returns mean, half of the 95 % interval and minimum of a policy's returns on the test episodes."""
    env = gymnasium.make(problem.id)
    returns = np.array([episode(env, policy, FIRST_SEED + at)[0] for at in range(episodes)])
    return float(returns.mean()), float(1.96 * returns.std(ddof=1) / np.sqrt(episodes)), float(returns.min())


def rows(problem: Problem, episodes: int, with_rivals: bool, folder: Path) -> list[Row]:
    """Returns the rows of a problem."""
    place = ROOT / "generated" / problem.name
    source = place / f"{problem.name.replace('-', '_')}.c"
    graph = place / "graph.json"
    policy = Policy(graph, source, folder)
    prefix = source.stem
    size = footprint(source, f"{prefix}_infer", folder, f"{prefix.upper()}_NO_SELFTEST")
    told = report(graph)
    if told != size.flash:
        raise SystemExit(f"{graph}: `tpg-codegen report` says {told} bytes, the compiler {size.flash}")
    found = [Row(problem.name, "this project", *played(problem, policy, episodes), size.flash, size.instructions)]
    if not with_rivals:
        return found
    env = gymnasium.make(problem.id)
    linear, steps = random_search(env, problem.steps, 1)
    found.append(rival(problem, "linear, random search", linear, episodes, folder, f"{steps / 1e6:.2f} M steps"))
    whole, small, steps = pruned_search(env, problem.steps, 1)
    found.append(rival(problem, "linear, covariance matrix adaptation", whole, episodes, folder, f"{steps / 1e6:.2f} M steps"))
    pruned = f"{np.count_nonzero(small.weights)} weights"
    found.append(rival(problem, "linear, covariance matrix adaptation, pruned", small, episodes, folder, pruned))
    for leaves in TREE_LEAVES:
        tree = distilled(env, policy, leaves)
        found.append(rival(problem, f"tree of {leaves} leaves", tree, episodes, folder, "imitates this project's"))
    return found


def agent_rows(problem: Problem, episodes: int, folder: Path) -> list[Row]:
    """Returns the rows of an agent of Stable-Baselines3: its network in floats, and the same in integers."""
    if problem.id not in RECIPES:
        return []
    agent, steps = trained(problem.id, 1), RECIPES[problem.id].steps
    note = f"trained here: {steps / 1e6:.2f} M steps, {agent.seconds:.0f} CPU s"
    integers = Integers(agent)
    function = f"agent_{agent.name.lower()}"
    multiplications = f"the same network, {integers.network.multiplications:,} multiplications a decision"
    return [
        agent_row(problem, agent, "floats", function, episodes, folder, note),
        agent_row(problem, integers, "integers", f"{function}_integers", episodes, folder, multiplications),
    ]


def agent_row(
    problem: Problem, policy: Agent | Integers, kind: str, function: str, episodes: int, folder: Path, note: str
) -> Row:
    """Returns the row of an agent: its return, and the flash of its C without the C library."""
    name = f"{RECIPES[problem.id].algorithm} in {kind}"
    flash = flash_of(built(policy.write_c(function, folder), folder))
    return Row(problem.name, name, *played(problem, policy, episodes), flash, None, note)


def rival(problem: Problem, name: str, policy: Any, episodes: int, folder: Path, note: str) -> Row:
    """Returns a rival's row."""
    function = f"rival_{''.join(letter for letter in name if letter.isalnum())}"
    size = footprint(write_c(policy, function, folder), function, folder)
    return Row(problem.name, name, *played(problem, policy, episodes), size.flash, size.instructions, note)


def main() -> None:
    """Prints the table."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--episodes", type=int, default=1000)
    parser.add_argument("--rivals", action="store_true", help="train and distil rivals, too")
    parser.add_argument("--agents", action="store_true", help="train agents of Stable-Baselines3, too")
    parser.add_argument("--only", action="append", help="one problem; can be repeated")
    parser.add_argument("--json", type=Path, help="writes the figures")
    options = parser.parse_args()
    unknown = set(options.only or []) - {problem.name for problem in PROBLEMS}
    if unknown:
        parser.error(f"--only {sorted(unknown)[0]}; accepted: {', '.join(problem.name for problem in PROBLEMS)}")
    print("| problem | policy | return | least | flash | instructions | |")
    print("| --- | --- | --- | --- | --- | --- | --- |")
    table: list[Row] = []
    with tempfile.TemporaryDirectory() as folder:
        for problem in PROBLEMS:
            shipped = (ROOT / "generated" / problem.name / "graph.json").exists()
            if not shipped or (options.only and problem.name not in options.only):
                continue
            found = rows(problem, options.episodes, options.rivals, Path(folder))
            if options.agents:
                found += agent_rows(problem, options.episodes, Path(folder))
            for row in found:
                table.append(row)
                print(
                    f"| {row.problem} | {row.policy} | {row.mean:.2f} ± {row.interval:.2f} | {row.least:.1f} | "
                    f"{row.flash or ''} | {row.instructions or ''} | {row.note} |"
                )
                sys.stdout.flush()
            published = ", ".join(f"{name} {value:g}" for name, value in problem.published.items())
            print(f"| {problem.name} | published by {problem.source} | {published} | | | | |")
    if options.json:
        options.json.write_text(json.dumps([asdict(row) for row in table], indent=1) + "\n")


if __name__ == "__main__":
    main()
