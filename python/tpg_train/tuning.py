"""Controllers that an engineer would tune by hand, tuned by search: rivals for a learned policy."""

from __future__ import annotations

import re
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

import gymnasium
import numpy as np
from numpy.typing import NDArray

from ._tpg import InputError
from .comparing import controller, play
from .spaces import Interface

Array = NDArray[np.float64]
# Episodes that compare candidates once their number is small, and how many candidates that is.
EPISODES, KEPT = 10, 8


@dataclass(frozen=True)
class Loop:
    """A loop around one value of the observation: `signal = proportional * error + integral * sum + derivative * change`, with
    `error = value - set_point`, and the sum and the change of the error by steps."""

    value: int
    set_point: float
    proportional: float
    integral: float
    derivative: float

    def signal(self, value: float, total: float, change: float) -> float:
        """Returns the signal for an error's value, sum and change."""
        return self.proportional * value + self.integral * total + self.derivative * change

    def text(self, name: str, middle: float = 0.0) -> str:
        """Returns the formula of the signal around a middle."""
        error = name if self.set_point == 0 else f"{name} {_signed(-self.set_point)}"
        factor = error if self.set_point == 0 else f"({error})"
        terms = ((self.proportional, factor), (self.integral, f"sum({error})"), (self.derivative, f"change({name})"))
        parts = [_signed(middle)] * (middle != 0) + [f"{_signed(gain)} * {of}" for gain, of in terms if gain != 0]
        return re.sub(r"^- ", "-", " ".join(parts).removeprefix("+ ")) or "0"


def _signed(value: float) -> str:
    """Returns a number with its sign apart, as a term of a sum."""
    return f"{'-' if value < 0 else '+'} {abs(value):.4g}"


class Tuned:
    """A PID controller or a relay of an environment: one loop for each value of a `Box` of actions, or one that chooses between
    two actions."""

    def __init__(self, kind: str, interface: Interface, loops: Sequence[Loop], ends: Sequence[int] = ()) -> None:
        self.kind, self.interface, self.loops, self.ends = kind, interface, list(loops), tuple(ends)
        self._outputs, self._flatten = interface.actions()[1], interface.flatten()

    def predict(
        self, observation: Any, state: Any = None, episode_start: Any = None, deterministic: bool = True
    ) -> tuple[Any, Any]:
        """Returns the action for an observation, and sums and errors for the next call; `state` is None at an episode's first."""
        values = np.ravel(observation if self._flatten is None else self._flatten(observation)).tolist()
        signals, kept = [], []
        for place, loop in enumerate(self.loops):
            error = values[loop.value] - loop.set_point
            total, last = (0.0, error) if state is None else state[place]
            signals.append(loop.signal(error, total + error, error - last))
            kept.append((total + error, error))
        return self.interface.to_actions(self._answers(signals), False), kept

    def _answers(self, signals: Sequence[float]) -> NDArray[Any]:
        """Returns the number of the action, or the row of values."""
        if self.ends:
            return np.array([self.ends[int(signals[0] > 0)]])
        ends = [(signal, low, high) for signal, (_, low, high) in zip(signals, self._outputs, strict=True)]
        if self.kind == "relay":
            return np.array([[high if signal > 0 else low for signal, low, high in ends]])
        return np.array([[min(max((low + high) / 2 + signal, low), high) for signal, low, high in ends]])

    def formula(self) -> str:
        """Returns the law."""
        names = [
            f"{name}[{place}]" if len(ends) > 1 else name for name, ends in self.interface.named() for place in range(len(ends))
        ]
        choices = self.interface.actions()[0]
        if self.ends:
            law = self.loops[0].text(names[self.loops[0].value])
            return f"{choices[self.ends[1]]} if {law} > 0, else {choices[self.ends[0]]}"
        return "; ".join(
            f"{name} = {high:g} if {loop.text(names[loop.value])} > 0, else {low:g}"
            if self.kind == "relay"
            else f"{name} = {loop.text(names[loop.value], (low + high) / 2)}, limited to {low:g} to {high:g}"
            for (name, low, high), loop in zip(self._outputs, self.loops, strict=True)
        )


def tuned(kind: str, env: gymnasium.Env[Any, Any], interface: Interface, steps: int) -> Tuned:
    """Tunes a controller in about so many steps of the environment: half of them draw controllers at random, the others mend the
    best by small changes.

    Args:
        kind: "pid", for a `Box` of actions, or "relay".

    Raises:
        InputError: if the environment's actions do not suit it.
    """
    choices, outputs = interface.actions()
    if kind == "pid" and not outputs:
        raise InputError(f"a PID controller on {interface.name}, whose actions are choices; accepted: relay, linear")
    if interface.eye is not None:
        raise InputError(f"a {kind} on {interface.name}, which shows images; accepted: a function of an observation")
    random, episodes = np.random.default_rng(1), range(1, EPISODES + 1)
    made = 0

    def score(law: Tuned, count: int) -> float:
        nonlocal made
        ended, _ = play(env, controller(law), episodes[:count], interface.limit)
        made += sum(length for _, length, *_ in ended)
        return float(np.mean([result for result, *_ in ended]))

    scale = _scale(env, interface, episodes)
    spans = [(high - low) / 2 for _, low, high in outputs] or [1.0]

    def loop(span: float) -> Loop:
        value = int(random.integers(interface.inputs))
        gain = span / scale[value] * random.choice([-1, 1]) * 10 ** random.uniform(-1.5, 1.5)
        point = 0.0 if random.random() < 0.7 else random.normal() * scale[value]
        integral = random.choice([-1, 1]) * gain * 10 ** random.uniform(-3, -1) if random.random() < 0.3 else 0.0
        derivative = random.choice([-1, 1]) * gain * 10 ** random.uniform(-1, 2) if random.random() < 0.7 else 0.0
        return Loop(value, float(point), float(gain), float(integral), float(derivative))

    def ends() -> list[int]:
        return random.choice(len(choices), 2, replace=False).tolist() if choices else []

    def changed(law: Tuned) -> Tuned:
        loops = []
        for old, span in zip(law.loops, spans, strict=True):
            if random.random() < 0.1:
                loops.append(loop(span))
                continue
            factors = np.exp(0.3 * random.normal(size=3) * (random.random(3) < 0.6))
            point = old.set_point + (0.2 * random.normal() * scale[old.value] if random.random() < 0.2 else 0.0)
            gains = np.array([old.proportional, old.integral, old.derivative]) * factors
            loops.append(Loop(old.value, float(point), *gains.tolist()))
        return Tuned(kind, interface, loops, law.ends)

    drawn: list[tuple[float, Tuned]] = []
    while made < steps / 2 or len(drawn) < KEPT:
        law = Tuned(kind, interface, [loop(span) for span in spans], ends())
        drawn.append((score(law, 1), law))
    drawn.sort(key=lambda one: -one[0])
    best, law = max(((score(law, EPISODES), law) for _, law in drawn[:KEPT]), key=lambda one: one[0])
    while made < steps:
        other = changed(law)
        found = score(other, EPISODES)
        if found >= best:
            best, law = found, other
    return law


def _scale(env: gymnasium.Env[Any, Any], interface: Interface, seeds: Sequence[int]) -> Array:
    """Returns the deviation of each value of the observation under random actions."""
    env.action_space.seed(1)
    seen: list[Array] = []

    def act(observation: Any) -> Any:
        seen.append(interface.states(observation)[0][0])
        return env.action_space.sample()

    play(env, lambda: act, seeds, interface.limit)
    deviation = np.std(np.array(seen), axis=0)
    return np.where(deviation > 1e-9, deviation, 1.0)
