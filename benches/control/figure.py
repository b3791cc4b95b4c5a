"""A figure of return against bytes, one panel for each problem, as SVG."""

from __future__ import annotations

import math
from typing import Any

WIDTH, HEIGHT, MARGIN, COLUMNS = 300, 190, 46, 2
INKS = {"this project": "#c2185b", "linear, random search": "#00695c"}
OTHER = "#5c6bc0"
LEAST, MOST = 30.0, 30_000.0


def figure(table: list[dict[str, Any]]) -> str:
    """Draws the rows of a table."""
    names = list(dict.fromkeys(row["problem"] for row in table))
    panels = [panel(name, [row for row in table if row["problem"] == name]) for name in names]
    lines = math.ceil(len(panels) / COLUMNS)
    body = "".join(
        f'<g transform="translate({place % COLUMNS * WIDTH},{place // COLUMNS * HEIGHT})">{drawn}</g>\n'
        for place, drawn in enumerate(panels)
    )
    size = f'viewBox="0 0 {COLUMNS * WIDTH} {lines * HEIGHT}" width="{COLUMNS * WIDTH}" height="{lines * HEIGHT}"'
    style = '<rect width="100%" height="100%" fill="white"/>'
    return f'<svg xmlns="http://www.w3.org/2000/svg" {size} font-family="sans-serif" font-size="10">\n{style}\n{body}</svg>\n'


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
    drawn.append(
        f'<rect x="{left}" y="{top}" width="{right - left}" height="{bottom - top}" fill="none" stroke="#999"/>'
    )
    for flash, text in ((100, "100 B"), (1_000, "1 KB"), (10_000, "10 KB")):
        drawn.append(f'<path d="M{across(flash):.1f} {top}V{bottom}" stroke="#ddd"/>')
        drawn.append(f'<text x="{across(flash):.1f}" y="{bottom + 12}" text-anchor="middle">{text}</text>')
    for value in (low + room, high - room):
        drawn.append(f'<text x="{left - 4}" y="{down(value) + 3:.1f}" text-anchor="end">{value:.4g}</text>')
    for row in rows:
        ink, x, y = INKS.get(row["policy"], OTHER), across(row["flash"]), down(row["mean"])
        ends = f"M{x:.1f} {down(row['mean'] - row['interval']):.1f}V{down(row['mean'] + row['interval']):.1f}"
        drawn.append(f'<path d="{ends}" stroke="{ink}"/><circle cx="{x:.1f}" cy="{y:.1f}" r="3.5" fill="{ink}"/>')
        at_right = x < 0.6 * WIDTH
        drawn.append(
            f'<text x="{x + (6 if at_right else -6):.1f}" y="{y - 4:.1f}" text-anchor="{"start" if at_right else "end"}" '
            f'fill="{ink}">{row["policy"]}</text>'
        )
    return "".join(drawn)
