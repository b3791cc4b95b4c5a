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


class Frame:
    """A panel with axes: a title, what lies across and what down, with their ends."""

    def __init__(self, title: str, across: str, down: tuple[float, float]) -> None:
        self.left, self.right, self.top, self.bottom = MARGIN, WIDTH - 12, 26, HEIGHT - 44
        self.low, self.high = down
        middle = (self.top + self.bottom) / 2
        width, height = self.right - self.left, self.bottom - self.top
        self.drawn = [f'<text x="{self.left}" y="18" font-weight="bold">{title}</text>']
        self.drawn.append(f'<rect x="{self.left}" y="{self.top}" width="{width}" height="{height}" fill="none" stroke="#999"/>')
        self.drawn.append(f'<text x="{(self.left + self.right) / 2}" y="{self.bottom + 29}" text-anchor="middle">{across}</text>')
        self.drawn.append(f'<text transform="translate(14,{middle}) rotate(-90)" text-anchor="middle">return</text>')
        for value in ticks(self.low, self.high):
            text = f"{value:,.0f}".replace("-", "−")
            self.drawn.append(f'<path d="M{self.left} {self.down(value):.1f}H{self.right}" stroke="#ddd"/>')
            self.drawn.append(f'<text x="{self.left - 5}" y="{self.down(value) + 4:.1f}" text-anchor="end">{text}</text>')

    def down(self, value: float) -> float:
        """Returns the place of a return."""
        return self.bottom - (self.bottom - self.top) * (value - self.low) / (self.high - self.low)

    def tick(self, place: float, text: str) -> None:
        """Draws a line at a place across, and its number."""
        self.drawn.append(f'<path d="M{place:.1f} {self.top}V{self.bottom}" stroke="#ddd"/>')
        self.drawn.append(f'<text x="{place:.1f}" y="{self.bottom + 14}" text-anchor="middle">{text}</text>')


def panel(task: dict[str, Any]) -> str:
    """Draws one task."""
    linear, trees = task["linear"], task["trees"]
    points = [shipped(task["folder"]), linear["random_search"], linear["covariance"], trees["leaves_16"], trees["leaves_128"]]
    low, high = min(value for value, _ in points), max(value for value, _ in points)
    room = 0.12 * (high - low)
    frame = Frame(task["id"], "flash, bytes", (low - room, high + room))

    def across(flash: float) -> float:
        return frame.left + (frame.right - frame.left) * math.log(flash / LEAST) / math.log(MOST / LEAST)

    for flash in (100, 1_000, 10_000):
        frame.tick(across(flash), f"{flash:,}")
    # This project's point is drawn last and smaller: a rival's under it can be seen.
    for place, ((value, flash), ink) in reversed(list(enumerate(zip(points, INKS.values(), strict=True)))):
        size = 5 if place else 4
        circle = f'<circle cx="{across(flash):.1f}" cy="{frame.down(value):.1f}" r="{size}" fill="{ink}" fill-opacity="0.85"/>'
        frame.drawn.append(circle)
    return "\n".join(frame.drawn)


def page(panels: list[str]) -> str:
    """Returns a picture of panels side by side."""
    body = "".join(
        f'<g transform="translate({place % COLUMNS * WIDTH},{place // COLUMNS * HEIGHT})">\n{drawn}\n</g>\n'
        for place, drawn in enumerate(panels)
    )
    wide, high = COLUMNS * WIDTH, math.ceil(len(panels) / COLUMNS) * HEIGHT
    return (
        f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {wide} {high}" width="{wide}" height="{high}" '
        f'font-family="sans-serif" font-size="12">\n<rect width="100%" height="100%" fill="white"/>\n{body}</svg>\n'
    )


def main() -> None:
    """Draws every task, and the legend in the place behind them."""
    panels = [panel(task) for task in tomllib.loads((ROOT / "docs/figures.toml").read_text())["tasks"]]
    legend = [
        f'<circle cx="{MARGIN + 8}" cy="{50 + 22 * place}" r="4" fill="{ink}"/>'
        f'<text x="{MARGIN + 20}" y="{54 + 22 * place}">{kind}</text>'
        for place, (kind, ink) in enumerate(INKS.items())
    ]
    (ROOT / "docs/control.svg").write_text(page([*panels, "\n".join(legend)]))


if __name__ == "__main__":
    main()
