#!/usr/bin/env python3
"""The shipped policies in integers on real Gymnasium, with the fewest bits that keep the return, beside the same policies in floats.

    python benches/control/integers.py [--episodes 1000] [--only cartpole]

Needs this project's Python package, `gymnasium[box2d,mujoco]==1.4.0` and `arm-none-eabi-gcc`. Bits are chosen on 100 episodes;
both then play the same other ones. Bytes are those of a Cortex-M0 with the library functions that are called, instructions the
most that one decision takes. Prints a table in Markdown.
"""

from __future__ import annotations

import argparse
import math
from typing import Any

from generated import ROOT
from table import PROBLEMS

from tpg_train import TPG


def cost(model: TPG) -> tuple[int, int]:
    """Returns linked bytes and the most instructions of the first profile on a Cortex-M0."""
    size = model.report("m0").data["sizes"][0]
    return size["linked_flash"], size["instructions"]


def main() -> None:
    arguments = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    arguments.add_argument("--episodes", type=int, default=1000)
    arguments.add_argument("--only")
    given = arguments.parse_args()
    print("| task | bits | return, `f32` | integers less `f32` | bytes | instructions |\n| --- | --: | --: | --- | --: | --: |")
    ratios: list[Any] = []
    for problem in PROBLEMS:
        if given.only not in (None, problem.name):
            continue
        model = TPG.load(ROOT / "generated" / problem.name / "graph.json", problem.id, native=False)
        whole = model.quantise()
        bits = whole.said.split("-bit")[0]
        played = model.evaluate(given.episodes, other=whole)
        # Less the policy in floats; 0 is no -0.
        difference, low, high = (-value + 0.0 for value in (played.difference, played.ci95[1], played.ci95[0]))
        (bytes_, instructions), (fewer_bytes, fewer) = cost(model), cost(whole)
        ratios.append((fewer_bytes / bytes_, fewer / instructions))
        row = (
            f"{bits} | {played.this.mean:,.2f} | {difference:+.2f} ({low:+.2f} to {high:+.2f}) "
            f"| {bytes_:,} → {fewer_bytes:,} | {instructions:,} → {fewer:,} |"
        )
        print(f"| {problem.id} | {row.replace('-', '−')}", flush=True)
    means = [math.exp(sum(math.log(ratio) for ratio in column) / len(ratios)) for column in zip(*ratios, strict=True)]
    print(f"| geometric mean | | | | × {means[0]:.3f} | × 1/{1 / means[1]:.0f} |")


if __name__ == "__main__":
    main()
