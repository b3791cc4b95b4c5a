#!/usr/bin/env python3
"""The shipped policies in integers on real Gymnasium, with the fewest bits that keep the return, beside the same in floats.

    python benches/control/integers.py [--episodes 1000] [--only cartpole]

Needs this project's Python package, `gymnasium[box2d,mujoco]==1.4.0` and `arm-none-eabi-gcc`. Bits are chosen on 100 episodes; both
then play the same other ones. Bytes are those of a Cortex-M0 with the library functions that are called, instructions the most that
one decision takes. On a Cortex-M4F, which has an FPU, sensors deliver counts: floats pay for the conversion of each value that the
policy reads. Prints a table in Markdown.
"""

from __future__ import annotations

import argparse
import json
import math
import re
import tempfile
from pathlib import Path
from typing import Any

from generated import ROOT, footprint
from table import PROBLEMS

from tpg_train import TPG


def cost(model: TPG, target: str = "m0") -> tuple[int, int]:
    """Returns linked bytes and the most instructions of the first profile on a core."""
    size = model.report(target).data["sizes"][0]
    return size["linked_flash"], size["instructions"]


def conversion(model: TPG, whole: TPG) -> tuple[int, int]:
    """Returns bytes and instructions of what turns the counts of the values that a policy reads into floats on a Cortex-M4F."""
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        model.export_c(folder, prefix="p")
        body = (folder / "p.c").read_text().split("P_NO_SELFTEST")[0]
        read = set(re.findall(r"state->(\w+(?:\[\d+\])?)", body))
        scales = {
            part["name"] + (f"[{place}]" if part["length"] > 1 else ""): count["scale"]
            for part in json.loads(whole.graph.to_json())["sources"]
            for place, count in enumerate(part["counts"])
        }
        lines = [
            f"    state->{field} = (float)raw[{place}] * {scale:.9g}F;\n"
            for place, (field, scale) in enumerate(scales.items())
            if field in read
        ]
        assert len(lines) == len(read), (read, scales)
        text = f'#include "p.h"\nvoid convert(const int16_t *raw, p_state_t *state)\n{{\n{"".join(lines)}}}\n'
        source = folder / "convert.c"
        source.write_text(text)
        size = footprint(source, "convert", folder)
        return size.flash, size.instructions


def main() -> None:
    arguments = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    arguments.add_argument("--episodes", type=int, default=1000)
    arguments.add_argument("--only")
    given = arguments.parse_args()
    print("| task | bits | return, `f32` | integers less `f32` | M0: bytes | instructions | M4F: bytes | instructions |")
    print("| --- | --: | --: | --- | --: | --: | --: | --: |")
    ratios: list[Any] = []
    for problem in PROBLEMS:
        if given.only not in (None, problem.name):
            continue
        model = TPG.load(ROOT / "generated" / problem.name / "graph.json", problem.id, native=False)
        whole = model.quantise()
        bits = whole.said.split("-bit")[0]
        played = model.evaluate(given.episodes, other=whole)
        # Less the policy in floats; 0 is no -0.
        difference, low, high = (round(-value, 2) + 0.0 for value in (played.difference, played.ci95[1], played.ci95[0]))
        floats = (*cost(model), *(one + more for one, more in zip(cost(model, "m4f"), conversion(model, whole), strict=True)))
        integers = (*cost(whole), *cost(whole, "m4f"))
        pairs = list(zip(floats, integers, strict=True))
        ratios.append([fewer / more for more, fewer in pairs])
        cells = " | ".join(f"{more:,} → {fewer:,}" for more, fewer in pairs)
        row = f"{bits} | {played.this.mean:,.2f} | {difference:+.2f} ({low:+.2f} to {high:+.2f}) | {cells} |"
        print(f"| {problem.id} | {row.replace('-', '−')}", flush=True)
    means = [math.exp(sum(math.log(ratio) for ratio in column) / len(ratios)) for column in zip(*ratios, strict=True)]
    print(f"| geometric mean | | | | × {means[0]:.3f} | × 1/{1 / means[1]:.0f} | × {means[2]:.2f} | × {means[3]:.2f} |")


if __name__ == "__main__":
    main()
