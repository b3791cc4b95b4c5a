#!/usr/bin/env python3
"""Records what a run on a Gymnasium environment asks for, as `scaling simulate` reads it.

    python benches/control/trace.py LunarLanderContinuous-v3 --steps 100000 -o trace.json
    cargo run --release -p tpg-benches --bin scaling -- simulate trace.json

One process runs everything; the time, the steps and the bytes of each policy's episodes are written down.
"""

from __future__ import annotations

import argparse
import json
import time
from pathlib import Path
from typing import Any

from tpg_train import TPG, _episodes
from tpg_train import model as module

questions: list[dict[str, Any]] = []
last = time.perf_counter()


class Recording(_episodes.Here):
    """Episodes in this process, one policy after another."""

    def run(self, policies: Any, seeds: Any) -> Any:
        global last
        question: dict[str, Any] = {"alone": time.perf_counter() - last, "tasks": 8 * len(seeds), "units": []}
        results = []
        for policy in policies:
            sent = len(policy.to_bytes())
            began = time.perf_counter()
            played = self._driver.run(policy, list(seeds))
            seconds = time.perf_counter() - began
            steps = [int(episode[1]) for episode in played]
            question["units"].append(
                {"expected": sent, "seconds": seconds, "steps": steps, "out": sent, "back": 24 * len(played)}
            )
            results.append(played)
        questions.append(question)
        last = time.perf_counter()
        return results


def main() -> None:
    arguments = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    arguments.add_argument("environment")
    arguments.add_argument("--steps", type=int, default=100_000)
    arguments.add_argument("--population", type=int)
    arguments.add_argument("-o", "--output", type=Path, required=True)
    given = arguments.parse_args()
    module.Here = Recording  # type: ignore[misc, assignment]
    model = TPG(given.environment, seed=1, native=False, population=given.population)
    global last
    last = time.perf_counter()
    model.learn(given.steps)
    given.output.write_text(json.dumps({"name": f"{given.environment}, through Python", "questions": questions}))


if __name__ == "__main__":
    main()
