"""A figure of return against bytes, one panel for each problem, as SVG."""

from __future__ import annotations

import math
from typing import Any

WIDTH, HEIGHT, MARGIN, COLUMNS = 300, 190, 46, 2
INKS = {
    "this project": "#c2185b",
    "linear, random search": "#00695c",
    "linear, covariance matrix adaptation": "#5c6bc0",
    "the same, pruned": "#90a4ae",
    "tree": "#ef8f00",
    "agent of Stable-Baselines3": "#3e2723",
}
LEGEND = 34
LEAST, MOST = 30.0, 400_000.0


def figure(table: list[dict[str, Any]]) -> str:
    """Draws the rows of a table."""
    names = list(dict.fromkeys(row["problem"] for row in table))
    panels = [panel(name, [row for row in table if row["problem"] == name]) for name in names]
    lines = math.ceil(len(panels) / COLUMNS)
    body = "".join(
        f'<g transform="translate({place % COLUMNS * WIDTH},{place // COLUMNS * HEIGHT})">{drawn}</g>\n'
        for place, drawn in enumerate(panels)
    )
    bottom = lines * HEIGHT
    legend = "".join(
        f'<circle cx="{MARGIN + place % 3 * 175}" cy="{bottom + 8 + place // 3 * 14}" r="3.5" fill="{ink}"/>'
        f'<text x="{MARGIN + 7 + place % 3 * 175}" y="{bottom + 12 + place // 3 * 14}" fill="{ink}">{kind}</text>\n'
        for place, (kind, ink) in enumerate(INKS.items())
    )
    size = f'viewBox="0 0 {COLUMNS * WIDTH} {bottom + LEGEND}" width="{COLUMNS * WIDTH}" height="{bottom + LEGEND}"'
    style = '<rect width="100%" height="100%" fill="white"/>'
    return f'<svg xmlns="http://www.w3.org/2000/svg" {size} font-family="sans-serif" font-size="10">\n{style}\n{body}{legend}</svg>\n'


def ink_of(policy: str) -> str:
    """Returns the colour of a policy's kind."""
    return INKS.get(policy) or INKS["tree" if policy.startswith("tree") else "agent of Stable-Baselines3"]


def panel(name: str, rows: list[dict[str, Any]]) -> str:
    """Draws one problem."""
    low = min(row["mean"] - row["interval"] for row in rows)
    high = max(row["mean"] + row["interval"] for row in rows)
    room = 0.15 * (high - low) or 1.0
    low, high = low - room, high + room
    left, right, top, bottom = MARGIN, WIDTH - 12, 22, HEIGHT - 32

    def across(flash: float) -> float:
        return left + (right - left) * math.log(flash / LEAST) / math.log(MOST / LEAST)

    def down(value: float) -> float:
        return bottom - (bottom - top) * (value - low) / (high - low)

    drawn = [f'<text x="{left}" y="14" font-weight="bold">{name}</text>']
    drawn.append(f'<rect x="{left}" y="{top}" width="{right - left}" height="{bottom - top}" fill="none" stroke="#999"/>')
    for flash, text in ((100, "100 B"), (1_000, "1 KB"), (10_000, "10 KB"), (100_000, "100 KB")):
        drawn.append(f'<path d="M{across(flash):.1f} {top}V{bottom}" stroke="#ddd"/>')
        drawn.append(f'<text x="{across(flash):.1f}" y="{bottom + 12}" text-anchor="middle">{text}</text>')
    for value in (low + room, high - room):
        drawn.append(f'<text x="{left - 4}" y="{down(value) + 3:.1f}" text-anchor="end">{value:.4g}</text>')
    for row in rows:
        ink, x, y = ink_of(row["policy"]), across(row["flash"]), down(row["mean"])
        ends = f"M{x:.1f} {down(row['mean'] - row['interval']):.1f}V{down(row['mean'] + row['interval']):.1f}"
        drawn.append(
            f'<path d="{ends}" stroke="{ink}"/><circle cx="{x:.1f}" cy="{y:.1f}" r="3.5" fill="{ink}" fill-opacity="0.8"/>'
        )
    return "".join(drawn)
