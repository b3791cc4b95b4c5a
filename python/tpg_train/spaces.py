"""The way between a Gymnasium environment's spaces and a policy's flat state and actions."""

from __future__ import annotations

import itertools
import unicodedata
import warnings
from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace
from typing import Any

import gymnasium
import numpy as np
from gymnasium import spaces
from numpy.typing import NDArray

from ._tpg import Driver, Eye, Graph, InputError, Policy, Space, flat
from .names import names_of

MOST_ACTIONS = 4096
MOST_INPUTS = 2**16
MOST_NAMES = 60
DEFAULT_LIMIT = 10_000


@dataclass(frozen=True)
class Part:
    """A part of an observation: a named source of one or more values."""

    name: str
    low: NDArray[np.float64]
    high: NDArray[np.float64]


def _name(text: str) -> str:
    """Returns a name as graphs take it: letters, digits and underscores; other letters by their Unicode names, θ as `theta`."""
    name = "".join(_ascii(letter) for letter in text).lower()
    return name if name[:1].isalpha() else f"x{name}"


def _ascii(letter: str) -> str:
    if letter.isascii():
        return letter if letter.isalnum() else "_"
    plain = unicodedata.normalize("NFKD", letter)[0]
    if plain.isascii():
        return plain if plain.isalnum() else "_"
    return unicodedata.name(letter, "_").split()[-1].replace("-", "_") if letter.isalpha() else "_"


def _unique(names: Sequence[str]) -> list[str]:
    """Appends a number to each name that an earlier one has already: `x`, `x_2`, `x_3`."""
    unique: list[str] = []
    for name in names:
        numbered = itertools.chain([name], (f"{name}_{number}" for number in itertools.count(2)))
        unique.append(next(one for one in numbered if one not in unique and (one == name or one not in names)))
    return unique


def _parts(space: spaces.Space[Any], name: str) -> list[Part]:
    """Returns the parts of an observation, in the order in which Gymnasium flattens it."""
    if isinstance(space, spaces.Dict):
        return [
            part for key, inner in space.spaces.items() for part in _parts(inner, _name(f"{name}_{key}" if name else str(key)))
        ]
    if isinstance(space, spaces.Tuple):
        return [
            part
            for place, inner in enumerate(space.spaces)
            for part in _parts(inner, _name(f"{name}_{place}" if name else f"part_{place}"))
        ]
    name = name or "obs"
    if isinstance(space, spaces.Box):
        if len(space.shape) >= 3 or (space.dtype == np.uint8 and len(space.shape) == 2):
            raise InputError(
                f"an observation of images, {space.shape} of {space.dtype}; accepted: a single Box of rows, columns and "
                "channels, of uint8 or bool"
            )
        return [Part(name, space.low.astype(np.float64).ravel(), space.high.astype(np.float64).ravel())]
    if isinstance(space, (spaces.Discrete, spaces.MultiDiscrete, spaces.MultiBinary)):
        length = spaces.flatdim(space)
        return [Part(name, np.zeros(length), np.ones(length))]
    raise InputError(f"the observation space {space}; accepted: Box, Discrete, MultiDiscrete, MultiBinary, Dict, Tuple")


def _eye(space: spaces.Space[Any]) -> Eye | None:
    """Returns what makes a state of images; None for a space that has none."""
    if not isinstance(space, spaces.Box) or len(space.shape) not in (2, 3) or space.dtype not in (np.uint8, np.bool_):
        return None
    return Eye(list(space.shape), int(space.high.max()))


@dataclass(frozen=True)
class Interface:
    """Everything that evolution and the drivers of episodes must know about an environment."""

    name: str
    observation_space: spaces.Space[Any]
    action_space: spaces.Space[Any]
    parts: tuple[Part, ...]
    limit: int
    input_names: tuple[str, ...] | None = None
    end_names: tuple[str, ...] | None = None
    asks: bool = False
    eye: Eye | None = None
    value_names: tuple[str, ...] = ()

    @classmethod
    def of(
        cls,
        env: gymnasium.Env[Any, Any],
        max_episode_steps: int | None = None,
        input_names: Sequence[str] | None = None,
        end_names: Sequence[str] | None = None,
    ) -> Interface:
        """Describes an environment. `end_names` are those of its actions, or of its outputs."""
        for attribute in ("observation_space", "action_space", "reset", "step"):
            if not hasattr(env, attribute):
                raise InputError(
                    f"an environment without {attribute}; accepted: a gymnasium.Env, an id, or a function that makes one"
                )
        spec = getattr(env, "spec", None)
        name = spec.id if spec is not None else type(getattr(env, "unwrapped", env)).__name__
        limit = max_episode_steps or getattr(spec, "max_episode_steps", None) or DEFAULT_LIMIT
        eye = _eye(env.observation_space)
        found = (
            _parts(env.observation_space, "")
            if eye is None
            else [Part(name, np.array(ranges)[:, 0], np.array(ranges)[:, 1]) for name, ranges in eye.parts()]
        )
        names = _unique([part.name for part in found])
        parts = tuple(replace(part, name=name) for part, name in zip(found, names, strict=True))
        values, known = names_of(env, sum(len(part.low) for part in parts))
        inputs, ends = (tuple(given) if given else None for given in (input_names, end_names or known))
        asks = bool(getattr(env, "asks_network", False))
        values = values if inputs is None else ()
        interface = cls(name, env.observation_space, env.action_space, parts, int(limit), inputs, ends, asks, eye, values)
        if not 1 <= interface.inputs <= MOST_INPUTS:
            raise InputError(f"{name}: an observation of {interface.inputs} values; accepted: 1 to {MOST_INPUTS}")
        if input_names is not None and len(input_names) != interface.inputs:
            raise InputError(f"{len(input_names)} input_names; accepted: {interface.inputs}")
        if input_names is not None and len(input_names) > MOST_NAMES:
            warnings.warn(
                f"{len(input_names)} input_names: a graph has at most {MOST_NAMES} named sources; the inputs of {name} are "
                f"numbered, {parts[0].name}[0] and so on",
                stacklevel=2,
            )
        choices, outputs = interface.actions()
        ended = [*choices, *(name for name, _, _ in outputs)]
        if len(set(ended)) < len(ended):
            raise InputError(f"action_names {', '.join(ended)}; accepted: each name once")
        return interface

    @property
    def inputs(self) -> int:
        """The number of values of the flat state."""
        return sum(len(part.low) for part in self.parts)

    @property
    def shape(self) -> tuple[int, ...]:
        """The shape of an observation, or of what `flatten` makes of it."""
        space = self.observation_space
        return space.shape if isinstance(space, spaces.Box) and self.eye is None else (self.inputs,)

    def sources(self) -> list[tuple[str, list[tuple[float, float]]]]:
        """Returns the sources that training knows, with the range of each value; an end that is not known is infinite."""
        ranges = [_range(low, high) for part in self.parts for low, high in zip(part.low, part.high, strict=True)]
        names = self.input_names
        if names is not None and len(names) <= MOST_NAMES:
            return [(name, [end]) for name, end in zip(_unique([_name(name) for name in names]), ranges, strict=True)]
        ends = iter(ranges)
        return [(part.name, list(itertools.islice(ends, len(part.low)))) for part in self.parts]

    def named(self) -> list[tuple[str, list[tuple[float, float]]]]:
        """Returns the sources of a graph: those of training, or one for each value where the values have known names."""
        sources = self.sources()
        ends = [end for _, values in sources for end in values]
        return [(name, [end]) for name, end in zip(self.value_names, ends, strict=True)] if self.value_names else sources

    def space(self) -> Space:
        """Describes the environment for evolution."""
        choices, outputs = self.actions()
        return Space(self.sources(), choices, outputs, self.limit, self.asks, self.eye)

    def policy(self, graph: Graph) -> Policy:
        """Returns the policy of a graph on the states of this environment."""
        return Policy.of(graph) if self.eye is None else Policy.of(graph, self.space())

    def read_by(self, graph: Graph, states: NDArray[np.float64]) -> NDArray[np.float64]:
        """Returns the columns of states that a graph reads."""
        return states if self.eye is None else states[:, graph.columns(self.space())[: len(graph.inputs) - graph.memory]]

    def actions(self) -> tuple[list[str], list[tuple[str, float, float]]]:
        """Returns the names of the actions, or the outputs with their ranges."""
        space = self.action_space
        if isinstance(space, spaces.Box):
            if space.dtype is not None and not np.issubdtype(space.dtype, np.floating):
                raise InputError(
                    f"{self.name}: actions of {space.dtype}; accepted: a Box of floating point, Discrete, MultiDiscrete"
                )
            low, high = space.low.astype(np.float64).ravel(), space.high.astype(np.float64).ravel()
            if not (np.all(np.isfinite(low)) and np.all(np.isfinite(high)) and np.any(low < high)):
                raise InputError(
                    f"{self.name}: a Box of actions from {low} to {high}; accepted: finite bounds, as "
                    "gymnasium.wrappers.RescaleAction gives it, one of them a range"
                )
            usual = ["action"] if len(low) == 1 else [f"action_{place}" for place in range(len(low))]
            if self.end_names is not None and len(self.end_names) != len(low):
                raise InputError(f"{len(self.end_names)} action_names; accepted: {len(low)}")
            names = [_name(name) for name in self.end_names or usual]
            outputs = list(zip(names, low.tolist(), high.tolist(), strict=True))
            return [], [output for output, varies in zip(outputs, low < high, strict=True) if varies]
        combinations = self.combinations()
        if len(combinations) < 2:
            raise InputError(f"{self.name}: the only action {combinations[0]}; accepted: two or more")
        if self.end_names is not None:
            if len(self.end_names) != len(combinations):
                raise InputError(f"{len(self.end_names)} action_names; accepted: {len(combinations)}")
            return list(self.end_names), []
        return ["a" + "_".join(str(part) for part in np.atleast_1d(combination)) for combination in combinations], []

    def combinations(self) -> list[Any]:
        """Returns the environment's action for each number; every combination of several choices is one."""
        space = self.action_space
        if isinstance(space, spaces.Discrete):
            return [int(space.start) + choice for choice in range(int(space.n))]
        if isinstance(space, spaces.MultiDiscrete):
            sizes, dtype, shape = [int(size) for size in space.nvec.ravel()], space.dtype, space.shape
            starts = np.asarray(getattr(space, "start", 0))
        elif isinstance(space, spaces.MultiBinary):
            sizes, dtype, shape = [2] * int(np.prod(space.shape)), space.dtype, space.shape
            starts = np.asarray(0)
        else:
            raise InputError(f"{self.name}: the action space {space}; accepted: Discrete, Box, MultiDiscrete, MultiBinary")
        count = int(np.prod([float(size) for size in sizes]))
        if count > MOST_ACTIONS:
            raise InputError(
                f"{self.name}: {count} combinations of actions; accepted: up to {MOST_ACTIONS}. Wrap the environment so that "
                "it has fewer, or a Box"
            )
        every = itertools.product(*(range(size) for size in sizes))
        return [np.asarray(options, dtype=dtype).reshape(shape) + starts.astype(dtype) for options in every]

    def flatten(self) -> Callable[[Any], NDArray[Any]] | None:
        """Returns the function that makes a flat array of an observation; None for a Box, which is an array."""
        space = self.observation_space
        if self.eye is not None:
            return self.eye.look
        if isinstance(space, spaces.Box):
            return None
        return lambda observation: np.asarray(spaces.flatten(space, observation), dtype=np.float64)

    def encode(self) -> Callable[[Sequence[float]], NDArray[Any]] | None:
        """Returns the function that makes an action of a policy's values; None where a flat array of float32 is one."""
        space = self.action_space
        if not isinstance(space, spaces.Box):
            return None
        if space.dtype == np.float32 and len(space.shape) == 1 and bool(np.all(space.low < space.high)):
            return None
        return lambda values: self._box_actions(np.asarray([values]))[0]

    def _box_actions(self, answers: NDArray[Any]) -> NDArray[Any]:
        """Returns the actions of rows of values: a component whose bounds are equal is that bound, and no output of a policy."""
        space = self.action_space
        assert isinstance(space, spaces.Box)
        actions = np.repeat(space.low.reshape(1, -1), len(answers), axis=0)
        actions[:, (space.low < space.high).ravel()] = answers.astype(space.dtype)
        return actions.reshape((len(answers), *space.shape))

    def driver(self, env: gymnasium.Env[Any, Any]) -> Driver:
        """Creates what runs whole episodes of the environment."""
        listed = None if isinstance(self.action_space, spaces.Box) else self.combinations()
        return Driver(env, self.shape, self.limit, self.flatten(), listed, self.encode())

    def states(self, observation: Any) -> tuple[NDArray[np.float64], bool]:
        """Returns observations as rows of the flat state, and true if it was a batch."""
        observations, is_batch = self._rows(observation)
        flatten = self.flatten() or (lambda observation: observation)
        rows = [flat(flatten(one), self.shape) for one in observations]
        return np.stack(rows) if rows else np.empty((0, self.inputs)), is_batch

    def _rows(self, observation: Any) -> tuple[Sequence[Any], bool]:
        """Returns the observations of a batch, or the one that it is, and true if it was a batch."""
        space = self.observation_space
        if isinstance(space, spaces.Dict):
            if not isinstance(observation, dict) or set(observation) != set(space.spaces):
                raise InputError(f"an observation that is no dict of {', '.join(map(str, space.spaces))}")
            key, inner = next(iter(space.spaces.items()))
            if np.ndim(observation[key]) <= len(inner.shape or ()):
                return [observation], False
            return [{name: values[row] for name, values in observation.items()} for row in range(len(observation[key]))], True
        if isinstance(space, spaces.Tuple):
            return [observation], False
        array, shape = np.asarray(observation), space.shape or ()
        if array.shape == shape:
            return [array], False
        if array.ndim == len(shape) + 1 and array.shape[1:] == shape:
            return list(array), True
        raise InputError(f"an observation of shape {array.shape}; accepted: {shape}, or a batch of them")

    def to_actions(self, answers: NDArray[Any], is_batch: bool) -> Any:
        """Turns a policy's answers into the environment's actions."""
        space = self.action_space
        if isinstance(space, spaces.Box):
            actions = self._box_actions(answers)
        elif isinstance(space, spaces.Discrete):
            actions = answers.astype(np.int64) + np.int64(space.start)
        else:
            every = self.combinations()
            actions = (
                np.stack([every[int(answer)] for answer in answers]) if len(answers) else np.empty((0, *(space.shape or ())))
            )
        return actions if is_batch else actions[0]


def _range(low: float, high: float) -> tuple[float, float]:
    """Returns a range; an end that only says "any number of this type" is unknown, as ±inf is."""
    far = 1e30
    return (low if low > -far else -np.inf, high if high < far else np.inf)
