#!/usr/bin/env python3
"""Pictures of the shipped policies at work: on real Gymnasium moments of one episode, driven by the generated C, and of the arm's
policies an episode as `tpg-train report` draws it.

    python3 -m venv control && control/bin/pip install "gymnasium[box2d,mujoco]==1.4.0"
    control/bin/python benches/control/acting.py

Writes `generated/*/acting.svg`. Earlier moments are paler.
"""

from __future__ import annotations

import re
import subprocess
import tempfile
from collections.abc import Callable
from pathlib import Path
from typing import Any

import gymnasium
import numpy as np
from generated import ROOT, Policy

SEED, WIDTH, HEIGHT, MARGIN = 10_000_000, 360, 180, 8
Point = tuple[float, float]
# A line along points, its width in the environment's units, and its style: `line` and `ground` are open, the others areas.
Shape = tuple[list[Point], float, str]


def arm(at: Point, lengths: list[float], angles: list[float], width: float) -> Shape:
    """Returns a chain of links; an angle of 0 points upwards, of a positive one to the left."""
    points = [at]
    for length, angle in zip(lengths, angles, strict=True):
        x, y = points[-1]
        points.append((x - length * float(np.sin(angle)), y + length * float(np.cos(angle))))
    return points, width, "line"


def pole(env: Any) -> list[Shape]:
    x, _, angle, _ = env.state
    cart = [(x - 0.25, -0.22), (x + 0.25, -0.22), (x + 0.25, 0.02), (x - 0.25, 0.02)]
    return [arm((x, 0.0), [1.0], [-angle], 0.08), (cart, 0.0, "soft")]


def acrobot(env: Any) -> list[Shape]:
    first, second = env.state[:2]
    return [arm((0.0, 0.0), [1.0, 1.0], [np.pi + first, np.pi + first + second], 0.12)]


def pendulum(env: Any) -> list[Shape]:
    return [arm((0.0, 0.0), [1.0], [env.state[0]], 0.14)]


def hill(x: float) -> Point:
    """Returns the point of the mountain cars' ground."""
    return x, 0.45 * float(np.sin(3 * x)) + 0.55


def car(env: Any) -> list[Shape]:
    at, rise = np.array(hill(env.state[0])), 1.35 * np.cos(3 * env.state[0])
    along = np.array([1.0, rise]) / np.hypot(1.0, rise)
    up = np.array([-along[1], along[0]])
    return [([tuple(at + 0.05 * x * along + y * up) for x, y in ((-1, 0.01), (1, 0.01), (1, 0.07), (-1, 0.07))], 0.0, "area")]


def bodies(env: Any) -> list[Shape]:
    """Returns the polygons of Box2D's moving bodies, the walker's far leg in another tone."""
    far = env.legs[:-2]
    return [
        ([tuple(body.transform * corner) for corner in part.shape.vertices], 0.0, "soft" if body in far else "area")
        for body in [*far, getattr(env, "lander", None) or env.hull, *env.legs[-2:]]
        for part in body.fixtures
    ]


def capsules(env: Any) -> list[Shape]:
    """Returns MuJoCo's capsules, as seen from the side, or from above where the plane is that."""
    model, data = env.model, env.data
    plane = [0, 1] if model.opt.viscosity > 0 else [0, 2]
    shapes: list[Shape] = []
    for place in np.flatnonzero(model.geom_type == 3):
        radius, half = model.geom_size[place][:2]
        along = data.geom_xmat[place].reshape(3, 3)[:, 2] * half
        ends = (data.geom_xpos[place] - along, data.geom_xpos[place] + along)
        shapes.append(([(float(end[plane[0]]), float(end[plane[1]])) for end in ends], 2 * float(radius), "line"))
    return shapes


def slope(_: Any) -> Shape:
    return [hill(x) for x in np.linspace(-1.2, 0.6, 60)], 0.02, "ground"


def moon(env: Any) -> Shape:
    return [env.sky_polys[0][0], *(part[1] for part in env.sky_polys)], 0.06, "ground"


def track(env: Any) -> Shape:
    end = max(point[0] for shape in bodies(env) for point in shape[0]) + 2
    return [points[0] for points, _ in env.terrain_poly if 2 < points[0][0] < end], 0.12, "ground"


def rail(env: Any) -> Shape:
    return [(-1.0, -0.24), (1.0, -0.24)], 0.03, "ground"


def floor(env: Any) -> Shape:
    end = max(point[0] for shape in capsules(env) for point in shape[0]) + 0.5
    return [(-0.5, 0.0), (end, 0.0)], 0.02, "ground"


def push_pole(env: Any) -> Any:
    env.state = np.array([-0.4, 0.0, 0.0, 1.0], dtype=np.float32)
    return env.state


def push_poles(env: Any) -> Any:
    env.set_state(np.array([-0.5, 0.0, 0.0]), np.array([0.0, 0.9, 0.0]))
    return env._get_obs()


# Two problems begin so near their goal that there would be nothing to see.
PUSHES = {"cartpole": push_pole, "inverted-double-pendulum": push_poles}
# Problem, Gymnasium's id, what moves, the ground, steps from moment to moment, moments.
SCENES: list[tuple[str, str, Callable[[Any], list[Shape]], Callable[[Any], Shape] | None, int, int]] = [
    ("cartpole", "CartPole-v1", pole, rail, 8, 6),
    ("acrobot", "Acrobot-v1", acrobot, None, 5, 16),
    ("mountain-car", "MountainCar-v0", car, slope, 4, 60),
    ("mountain-car-continuous", "MountainCarContinuous-v0", car, slope, 12, 90),
    ("pendulum", "Pendulum-v1", pendulum, None, 4, 16),
    ("lunar-lander", "LunarLander-v3", bodies, moon, 16, 40),
    ("lunar-lander-continuous", "LunarLanderContinuous-v3", bodies, moon, 16, 40),
    ("inverted-double-pendulum", "InvertedDoublePendulum-v5", capsules, None, 2, 5),
    ("swimmer", "Swimmer-v5", capsules, None, 15, 8),
    ("bipedal-walker", "BipedalWalker-v3", bodies, track, 48, 4),
    ("hopper", "Hopper-v5", capsules, floor, 14, 12),
    ("half-cheetah", "HalfCheetah-v5", capsules, floor, 14, 8),
]


def picture(moments: list[list[Shape]], ground: Shape | None, title: str) -> str:
    """Draws moments, the last one darkest."""
    shapes = [*(shape for moment in moments for shape in moment), *([ground] if ground else [])]
    low = np.min([np.min(points, axis=0) - width / 2 for points, width, _ in shapes], axis=0)
    high = np.max([np.max(points, axis=0) + width / 2 for points, width, _ in shapes], axis=0)
    scale = float(min((np.array([WIDTH, HEIGHT]) - 2 * MARGIN) / np.maximum(high - low, 1e-9)))
    shift = (np.array([WIDTH, HEIGHT]) - scale * (high - low)) / 2

    def path(shape: Shape) -> str:
        line, width, style = shape
        is_open = style in ("line", "ground")
        place = [shift + scale * (np.array(point) - low) for point in line]
        text = "M" + "L".join(f"{x:.1f} {HEIGHT - y:.1f}" for x, y in place) + ("" if is_open else "z")
        fill = f' fill="none" stroke-width="{max(1.0, scale * width):.1f}"' if is_open else ""
        return f'<path class="{style}"{fill} d="{text}"/>\n'

    body = path(ground) if ground else ""
    for number, moment in enumerate(moments):
        ink = 0.12 + 0.88 * (number / max(1, len(moments) - 1)) ** 2
        parts = "".join(path(shape) for shape in moment)
        body += f'<g opacity="{ink:.2f}">\n{parts}</g>\n'
    style = (
        "svg { --ink: #00805c; --soft: #9aa5af; } @media (prefers-color-scheme: dark) { svg { --ink: #35c79b; --soft: #5b6670; } } "
        ".line { stroke: var(--ink); stroke-linecap: round; stroke-linejoin: round; } .area { fill: var(--ink); } "
        ".soft { fill: var(--soft); } .ground { stroke: var(--soft); }"
    )
    return (
        f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {WIDTH} {HEIGHT}" width="{WIDTH}" height="{HEIGHT}" role="img">\n'
        f"<title>{title}</title>\n<style>{style}</style>\n{body}</svg>\n"
    )


# The arm's policies: problem, policy, and the log that makes a folder a run.
ARMS = [
    ("widowx-fs", "fs", "graph.json", "generations.jsonl"),
    ("widowx-rs", "rs", "graph.json", "generations.jsonl"),
    ("widowx-sac", "fs", "policy.safetensors", "log.jsonl"),
    ("dodge", "dodge", "graph.json", "generations.jsonl"),
]


def reported(folder: Path, place: Path, problem: str, policy: str, log: str) -> str:
    """Returns the shortest picture of an episode in the report of a policy."""
    folder.mkdir()
    (folder / policy).write_bytes((place / policy).read_bytes())
    (folder / "config.toml").write_text(f'[problem]\nname = "{problem}"\n')
    (folder / log).touch()
    command = ["cargo", "run", "--release", "-q", "-p", "tpg-train", "--", "report", str(folder), "--episodes", "8", "-o", "-"]
    page = subprocess.run(command, cwd=ROOT, check=True, capture_output=True, text=True).stdout
    styles = ROOT / "tpg-codegen/picture/templates"
    style = "".join((styles / name).read_text() for name in ("colours.css", "picture.css"))
    pictures = [one for one in re.findall(r"<svg.*?</svg>", page, re.DOTALL) if "an episode" in one.split(">", 1)[0]]
    start, rest = min(pictures, key=len).split(">", 1)
    start = start.replace("<svg", '<svg xmlns="http://www.w3.org/2000/svg"', 1)
    return f"{start}>\n<style>{style}</style>{rest}\n"


def main() -> None:
    """Draws every shipped policy."""
    with tempfile.TemporaryDirectory() as folder:
        for name, *how in ARMS:
            place = ROOT / "generated" / name
            (place / "acting.svg").write_text(reported(Path(folder, name), place, *how))
            print(f"generated/{name}/acting.svg")
        for name, known_as, look, ground, every, count in SCENES:
            place = ROOT / "generated" / name
            policy = Policy(place / "graph.json", place / f"{name.replace('-', '_')}.c", Path(folder))
            env = gymnasium.make(known_as)
            observation, _ = env.reset(seed=SEED)
            policy.reset()
            if name in PUSHES:
                observation = PUSHES[name](env.unwrapped)
            moments, steps, done = [look(env.unwrapped)], 0, False
            while not done and len(moments) < count:
                observation, _, terminated, truncated, _ = env.step(policy(observation))
                steps, done = steps + 1, terminated or truncated
                if steps % every == 0 or done:
                    moments.append(look(env.unwrapped))
            after = " after a push" if name in PUSHES else ""
            title = f"The shipped policy on {known_as}{after}: {len(moments)} moments of {steps} steps"
            (place / "acting.svg").write_text(picture(moments, ground(env.unwrapped) if ground else None, title))
            print(f"generated/{name}/acting.svg: {title}")


if __name__ == "__main__":
    main()
