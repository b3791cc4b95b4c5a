"""The compiled part of the package."""

from collections.abc import Callable, Sequence
from os import PathLike
from pathlib import Path
from typing import Any, TypeAlias, final

import numpy as np
from numpy.typing import NDArray

__all__ = [
    "Driver",
    "Eye",
    "Graph",
    "InputError",
    "NativeEnv",
    "Network",
    "Policy",
    "Samples",
    "Space",
    "Switch",
    "TrainingError",
    "__version__",
    "configuration",
    "evaluate_native",
    "evolve",
    "flat",
    "problems",
    "quantise_native",
    "success_of",
    "test_seeds",
    "train_network",
]

# An episode's return, its steps, and whether the environment called it a success.
_Ending: TypeAlias = tuple[float, int, bool | None, float]
# An episode's ending, the moments of what was seen, and some states.
_Played: TypeAlias = tuple[_Ending, str, list[list[float]]]

__version__: str

class InputError(ValueError): ...
class TrainingError(RuntimeError): ...

@final
class Graph:
    """A tangled program graph."""

    @staticmethod
    def load(path: str | PathLike[str]) -> Graph: ...
    @staticmethod
    def from_json(text: str, name: str = "<text>") -> Graph: ...
    def to_json(self) -> str: ...
    def __reduce__(self) -> tuple[Any, tuple[str]]: ...
    def save(self, path: str | PathLike[str]) -> None: ...
    @property
    def sha256(self) -> str: ...
    @property
    def inputs(self) -> list[str]: ...
    def columns(self, space: Space) -> list[int]: ...
    @property
    def ranges(self) -> list[tuple[float, float]]: ...
    @property
    def counts(self) -> bool: ...
    @property
    def actions(self) -> list[str]: ...
    @property
    def outputs(self) -> list[tuple[str, float, float]]: ...
    @property
    def memory(self) -> int: ...
    @property
    def scalar(self) -> str: ...
    @property
    def size(self) -> int: ...
    def answers(self, states: NDArray[np.float64]) -> NDArray[Any]: ...
    def formula(self) -> str: ...
    def report(self, targets: Sequence[str]) -> tuple[str, str]: ...
    def quantise(self, bits: int, states: NDArray[np.float64] | None) -> tuple[Graph, str]: ...
    def quantise_keeping(
        self,
        bits: int | None,
        states: NDArray[np.float64] | None,
        play: Callable[[Graph], tuple[list[float], NDArray[np.float64]]],
    ) -> tuple[Graph, str]: ...
    def code(self, language: str, prefix: str, profile: str) -> list[tuple[str, str]]: ...
    def export(self, folder: str | PathLike[str], language: str, prefix: str, profile: str) -> list[Path]: ...
    def verify(self, languages: Sequence[str], profiles: Sequence[str], states: int, seed: int) -> tuple[str, bool]: ...
    def svg(self) -> str: ...

@final
class Policy:
    """A policy that is evaluated in an episode."""

    @staticmethod
    def of(graph: Graph, space: Space | None = None) -> Policy: ...
    @staticmethod
    def from_bytes(bytes: bytes) -> Policy: ...
    def to_bytes(self) -> bytes: ...
    @property
    def inputs(self) -> int: ...
    def moments(self, states: Sequence[Sequence[float]]) -> str: ...
    def answer(self, state: Sequence[float]) -> tuple[int | None, list[float]]: ...

@final
class Space:
    """Names, units and ranges of an environment's observations and actions."""

    def __new__(
        cls,
        sources: Sequence[tuple[str, Sequence[tuple[float, float]]]],
        actions: Sequence[str],
        outputs: Sequence[tuple[str, float, float]],
        limit: int,
        asks: bool = False,
        eye: Eye | None = None,
    ) -> Space: ...

@final
class Eye:
    """The features of an image, which make a flat state."""

    def __new__(cls, shape: Sequence[int], brightest: int) -> Eye: ...
    def parts(self) -> list[tuple[str, list[list[float]]]]: ...
    def look(self, image: NDArray[Any]) -> NDArray[np.float64]: ...

@final
class Samples:
    """Labelled samples, whose episodes the compiled part runs."""

    def __new__(
        cls,
        space: Space,
        rows: NDArray[np.float64],
        classes: NDArray[np.uint16],
        scores: NDArray[np.float64],
        training: int,
        linear: Sequence[Sequence[Sequence[float]]],
    ) -> Samples: ...

def flat(observation: Any, shape: Sequence[int]) -> NDArray[np.float64]: ...
def success_of(info: Any) -> bool | None: ...

@final
class Driver:
    """Runs episodes of an environment."""

    def __new__(
        cls,
        env: Any,
        shape: Sequence[int],
        limit: int,
        flatten: Any = None,
        actions: Sequence[Any] | None = None,
        encode: Any = None,
    ) -> Driver: ...
    def run(self, policy: Policy, seeds: Sequence[int]) -> list[_Ending]: ...
    def play(self, policy: Policy, seed: int, after: Sequence[int]) -> _Played: ...

@final
class NativeEnv:
    """A built-in problem that is stepped from outside."""

    def __new__(cls, name: str, continuous: bool = False) -> NativeEnv: ...
    @property
    def description(self) -> str: ...
    def reset(self, seed: int) -> NDArray[np.float32]: ...
    def reset_to(self, task: str) -> NDArray[np.float32]: ...
    def choose(self, action: int) -> tuple[NDArray[np.float32], float, bool, bool, bool | None]: ...
    def act(self, values: NDArray[np.float32]) -> tuple[NDArray[np.float32], float, bool, bool, bool | None]: ...

@final
class Network:
    """A multilayer perceptron in integers."""

    @staticmethod
    def quantise(
        inputs: Sequence[tuple[str, Any, Any]],
        layers: Sequence[tuple[NDArray[np.float32], NDArray[np.float32]]],
        values: Sequence[tuple[str, Any, Any, str]],
        actions: Sequence[str],
        states: NDArray[np.float32],
        kind: str,
        sha256: str,
    ) -> Network: ...
    @staticmethod
    def load(path: str | PathLike[str]) -> Network: ...
    def save(self, path: str | PathLike[str]) -> None: ...
    @property
    def inputs(self) -> list[str]: ...
    @property
    def actions(self) -> list[str]: ...
    @property
    def bytes(self) -> int: ...
    @property
    def multiplications(self) -> int: ...
    def answers(self, states: NDArray[np.float32]) -> NDArray[Any]: ...
    def export_c(self, folder: str | PathLike[str], prefix: str) -> list[Path]: ...
    def export_rust(self, folder: str | PathLike[str], prefix: str) -> list[Path]: ...
    def differences(self, states: NDArray[np.float32]) -> int: ...

@final
class Switch:
    """The turns of one episode."""

    def __new__(
        cls,
        distance: float,
        separation: float = ...,
        patience: int | None = None,
        hand_back_after: int | None = None,
    ) -> Switch: ...
    @property
    def network_drives(self) -> bool: ...
    def acted(self, asked: bool, distance: float) -> None: ...

def train_network(space: Space, make: Callable[[], Driver], settings: str, seed: int, kind: str) -> tuple[Network, float]: ...
def configuration(preset: str, settings: str) -> str: ...
def evolve(
    field: Space | Samples | str,
    settings: dict[str, Any],
    evaluate: Callable[[list[Policy], list[int]], Sequence[Sequence[_Ending]]],
    play: Callable[[list[tuple[Policy, int, list[int]]]], Sequence[_Played]],
    progress: Callable[[dict[str, Any]], bool],
) -> bool: ...
def test_seeds(seed: int, count: int) -> list[int]: ...
def problems() -> list[tuple[str, str]]: ...
def evaluate_native(problem_name: str, graph: Graph, episodes: int, seed: int) -> str: ...
def quantise_native(
    problem_name: str, graph: Graph, bits: int | None, states: NDArray[np.float64] | None, episodes: int
) -> tuple[Graph, str]: ...
