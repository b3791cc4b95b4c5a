#!/usr/bin/env python3
"""Measures what an evaluated step costs beside the environment's own loop.

    python benches/control/overhead.py CartPole-v1

The same episodes twice: driven by a policy, and by the list of its actions in a loop of Python that does nothing else. CPU time
of one process; the least of several rounds, in turns.
"""

from __future__ import annotations

import argparse
import time
from typing import Any

import gymnasium

from tpg_train import TPG, _tpg
from tpg_train._tpg import Policy


class Recorded(gymnasium.Wrapper[Any, Any, Any, Any]):
    """Keeps the actions that it is given."""

    actions: list[Any]

    def step(self, action: Any) -> Any:
        self.actions.append(action)
        return self.env.step(action)


def replay(env: gymnasium.Env[Any, Any], episodes: list[tuple[int, list[Any]]]) -> None:
    step = env.step
    for seed, actions in episodes:
        env.reset(seed=seed)
        for action in actions:
            step(action)


def main() -> None:
    arguments = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    arguments.add_argument("environment")
    arguments.add_argument("--episodes", type=int, default=100)
    arguments.add_argument("--rounds", type=int, default=9)
    given = arguments.parse_args()
    model = TPG(given.environment, native=False).learn(100_000)
    policy, env, interface = Policy.of(model.graph._graph), model.env, model._interface
    seeds = _tpg.test_seeds(1, given.episodes)
    recorded, episodes = Recorded(env), []
    for seed in seeds:
        recorded.actions = []
        interface.driver(recorded).run(policy, [seed])
        episodes.append((seed, recorded.actions))
    driver, steps = interface.driver(env), sum(len(actions) for _, actions in episodes)
    rounds: dict[str, list[float]] = {"alone": [], "driven": []}
    for _ in range(given.rounds):
        began = time.process_time()
        replay(env, episodes)
        middle = time.process_time()
        driver.run(policy, seeds)
        rounds["alone"].append(middle - began)
        rounds["driven"].append(time.process_time() - middle)
    alone, driven = (1e6 * min(rounds[name]) / steps for name in ("alone", "driven"))
    print(f"{given.environment}: {steps} steps, {alone:.2f} us a step alone, {driven:.2f} driven: {driven - alone:+.2f} us")


if __name__ == "__main__":
    main()
