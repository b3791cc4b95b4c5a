#!/usr/bin/env python3
"""Learning curves of locomotion by `TPG(id, seed=...).learn(steps)` without any setting, five seeds each.

    python benches/control/curves.py FOLDER [--only Hopper-v5]

Needs this project's Python package and `gymnasium[box2d,mujoco]==1.4.0`. Each run keeps its own folder below FOLDER; one that ended
is not repeated, so that a second call only draws. Writes `docs/curves.svg`: the median return of the policies of a generation over
the steps of training, of each seed and the median of these; points are what the best policies return on their validation episodes.
"""

from __future__ import annotations

import argparse
import json
from pathlib import Path

import numpy as np
from figure import ROOT, Frame, page

from tpg_train import TPG

TASKS = {
    "Swimmer-v5": 500_000,
    "InvertedDoublePendulum-v5": 300_000,
    "Hopper-v5": 1_000_000,
    "HalfCheetah-v5": 3_000_000,
    "LunarLander-v3": 1_000_000,
}
SEEDS = range(1, 6)
POINTS = 60


def curve(folder: Path, task: str, seed: int, steps: int) -> tuple[list[float], float]:
    """Returns the scores of the newest generation at equal distances, and the validated one; trains first where no run has ended."""
    ended = folder / "ended"
    if not ended.exists():
        TPG(task, seed=seed, native=False, folder=folder).learn(steps)
        ended.touch()
    rows = [json.loads(line) for line in (folder / "generations.jsonl").read_text().splitlines()]
    places, scores = [row["steps"] for row in rows], [row["median_score"] for row in rows]
    at = np.searchsorted(places, np.linspace(steps / POINTS, steps, POINTS), side="right") - 1
    return [scores[max(place, 0)] for place in at], max(row["validation"]["score"] for row in rows if row.get("validation"))


def panel(task: str, steps: int, curves: list[tuple[list[float], float]]) -> str:
    """Draws one task."""
    values, ends = np.array([line for line, _ in curves]), [end for _, end in curves]
    low, high = min(values.min(), *ends), max(values.max(), *ends)
    room = 0.08 * (high - low)
    frame = Frame(task, "steps", (float(low - room), float(high + room)))
    places = np.linspace(1 / POINTS, 1, POINTS) * (frame.right - frame.left) + frame.left
    for share in (0.5, 1.0):
        frame.tick(frame.left + share * (frame.right - frame.left), f"{steps * share / 1e6:g} M")
    for line, ink, width in [*((line, "#f48fb1", 1) for line in values), (np.median(values, axis=0), "#c2185b", 2.5)]:
        known = "L".join(f"{x:.1f} {frame.down(float(y)):.1f}" for x, y in zip(places, line, strict=True))
        frame.drawn.append(f'<path d="M{known}" fill="none" stroke="{ink}" stroke-width="{width}"/>')
    frame.drawn += [f'<circle cx="{frame.right}" cy="{frame.down(end):.1f}" r="3" fill="#880e4f"/>' for end in ends]
    return "\n".join(frame.drawn)


def main() -> None:
    """Trains what is missing, and draws what there is."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("folder", type=Path)
    parser.add_argument("--only", choices=TASKS)
    given = parser.parse_args()
    panels = []
    for task, steps in TASKS.items():
        if given.only in (None, task):
            curves = [curve(given.folder / f"{task}-{seed}", task, seed, steps) for seed in SEEDS]
            panels.append(panel(task, steps, curves))
    (ROOT / "docs/curves.svg").write_text(page(panels))


if __name__ == "__main__":
    main()
