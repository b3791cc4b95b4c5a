"""Prints what the unit test of the games compares with: episodes, rewards and a digest of 20,000 steps of the package `minatar`.

pip install minatar==1.0.15 && python record.py
"""

import numpy as np
from minatar import Environment

WORD = (1 << 64) - 1
MOVES = {
    "breakout": "nlr",
    "asterix": "nlurd",
    "space_invaders": "nlrf",
    "freeway": "nud",
    "seaquest": "nlurdf",
}


class Draws:
    """SplitMix64 instead of the package's own random numbers."""

    def __init__(self, seed: int) -> None:
        self.state = seed

    def unit(self) -> float:
        self.state = (self.state + 0x9E3779B97F4A7C15) & WORD
        mixed = ((self.state ^ (self.state >> 30)) * 0xBF58476D1CE4E5B9) & WORD
        mixed = ((mixed ^ (mixed >> 27)) * 0x94D049BB133111EB) & WORD
        return ((mixed ^ (mixed >> 31)) >> 11) / 2**53

    def rand(self, size: int | None = None) -> float | np.ndarray:
        return (
            self.unit()
            if size is None
            else np.array([self.unit() for _ in range(size)])
        )

    def randint(
        self, low: int, high: int | None = None, size: int | None = None
    ) -> int | np.ndarray:
        low, high = (0, low) if high is None else (low, high)
        drawn = low + np.floor(self.rand(size) * (high - low)).astype(int)
        return int(drawn) if size is None else drawn


def begin(env: Environment, seed: int) -> None:
    draws = Draws(seed)
    env.random = draws
    env.env.random = draws
    env.last_action = 0
    env.reset()


for game, moves in MOVES.items():
    env, choices, seed = Environment(game), Draws(7 ^ 0xABCD), 7
    begin(env, seed)
    episodes, rewards, digest = 0, 0, 0xCBF29CE484222325
    for _ in range(20_000):
        choice = choices.randint(len(moves))
        reward, is_over = env.act(env.env.action_map.index(moves[choice]))
        rewards += reward
        state = env.state()
        boards = [
            sum(
                1 << place
                for place, cell in enumerate(state[:, :, channel].ravel())
                if cell
            )
            for channel in range(state.shape[2])
        ]
        for word in [choice, int(reward), int(is_over), *boards]:
            for byte in word.to_bytes(16, "little"):
                digest = ((digest ^ byte) * 0x100000001B3) & WORD
        if is_over:
            seed += 1
            episodes += 1
            begin(env, seed)
    print(f"{game}: ({episodes}, {int(rewards)}, 0x{digest:016X})")
