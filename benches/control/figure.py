#!/usr/bin/env python3
"""A figure of return against flash, one panel for each task, from docs/figures.toml and the PROVENANCE.md of each shipped policy.

    python3 benches/control/figure.py

Writes `docs/control.svg`: the policies of the tables in docs/experiments.md.
"""

from __future__ import annotations

import math
import re
import tomllib
from pathlib import Path
from typing import Any

ROOT = Path(__file__).resolve().parents[2]
WIDTH, HEIGHT, MARGIN, COLUMNS = 360, 220, 64, 2
LEAST, MOST = 40.0, 12_000.0
Point = tuple[float, float]
INKS = {
    "this project": "#c2185b",
    "linear, random search": "#00695c",
    "linear, covariance adaptation": "#5c6bc0",
    "tree of 16 leaves": "#ffb74d",
    "tree of 128 leaves": "#b35900",
}


def shipped(folder: str) -> Point:
    """Returns the return and the bytes of a shipped policy."""
    text = (ROOT / "generated" / folder / "PROVENANCE.md").read_text()
    found = re.search(r": \*\*(\S+) ±", text), re.search(r"\| C, profile `fast` \| (\S+) bytes", text)
    if not all(found):
        raise SystemExit(f"{folder}: its PROVENANCE.md lacks a return or bytes")
    value, flash = (float(part[1].replace("−", "-").replace(",", "")) for part in found if part)
    return value, flash


def ticks(low: float, high: float) -> list[float]:
    """Returns the round numbers of a range, at least three."""
    power = 10.0 ** math.floor(math.log10((high - low) / 3))
    step = next(power * one for one in (5, 2, 1) if power * one <= (high - low) / 3)
    return [step * place for place in range(math.ceil(low / step), math.floor(high / step) + 1)]


def panel(task: dict[str, Any]) -> str:
    """Draws one task."""
    linear, trees = task["linear"], task["trees"]
    points = [shipped(task["folder"]), linear["random_search"], linear["covariance"], trees["leaves_16"], trees["leaves_128"]]
    low, high = min(value for value, _ in points), max(value for value, _ in points)
    room = 0.12 * (high - low)
    low, high = low - room, high + room
    left, right, top, bottom = MARGIN, WIDTH - 12, 26, HEIGHT - 44

    def across(flash: float) -> float:
        return left + (right - left) * math.log(flash / LEAST) / math.log(MOST / LEAST)

    def down(value: float) -> float:
        return bottom - (bottom - top) * (value - low) / (high - low)

    middle = (top + bottom) / 2
    drawn = [f'<text x="{left}" y="18" font-weight="bold">{task["id"]}</text>']
    drawn.append(f'<rect x="{left}" y="{top}" width="{right - left}" height="{bottom - top}" fill="none" stroke="#999"/>')
    drawn.append(f'<text x="{(left + right) / 2}" y="{bottom + 29}" text-anchor="middle">flash, bytes</text>')
    drawn.append(f'<text transform="translate(14,{middle}) rotate(-90)" text-anchor="middle">return</text>')
    for flash in (100, 1_000, 10_000):
        drawn.append(f'<path d="M{across(flash):.1f} {top}V{bottom}" stroke="#ddd"/>')
        drawn.append(f'<text x="{across(flash):.1f}" y="{bottom + 14}" text-anchor="middle">{flash:,}</text>')
    for value in ticks(low, high):
        text = f"{value:,.0f}".replace("-", "−")
        drawn.append(f'<path d="M{left} {down(value):.1f}H{right}" stroke="#ddd"/>')
        drawn.append(f'<text x="{left - 5}" y="{down(value) + 4:.1f}" text-anchor="end">{text}</text>')
    # This project's point is drawn last and smaller: a rival's under it can be seen.
    for place, ((value, flash), ink) in reversed(list(enumerate(zip(points, INKS.values(), strict=True)))):
        size = 5 if place else 4
        drawn.append(f'<circle cx="{across(flash):.1f}" cy="{down(value):.1f}" r="{size}" fill="{ink}" fill-opacity="0.85"/>')
    return "\n".join(drawn)


def main() -> None:
    """Draws every task, and the legend in the place behind them."""
    panels = [panel(task) for task in tomllib.loads((ROOT / "docs/figures.toml").read_text())["tasks"]]
    legend = [
        f'<circle cx="{MARGIN + 8}" cy="{50 + 22 * place}" r="4" fill="{ink}"/>'
        f'<text x="{MARGIN + 20}" y="{54 + 22 * place}">{kind}</text>'
        for place, (kind, ink) in enumerate(INKS.items())
    ]
    body = "".join(
        f'<g transform="translate({place % COLUMNS * WIDTH},{place // COLUMNS * HEIGHT})">\n{drawn}\n</g>\n'
        for place, drawn in enumerate([*panels, "\n".join(legend)])
    )
    wide, high = COLUMNS * WIDTH, math.ceil((len(panels) + 1) / COLUMNS) * HEIGHT
    (ROOT / "docs/control.svg").write_text(
        f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {wide} {high}" width="{wide}" height="{high}" '
        f'font-family="sans-serif" font-size="12">\n<rect width="100%" height="100%" fill="white"/>\n{body}</svg>\n'
    )


if __name__ == "__main__":
    main()
