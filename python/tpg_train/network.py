"""Actors of Stable-Baselines3 in integers: the same bits in Python, on a PC and on a Cortex-M4."""

from __future__ import annotations

import copy
import dataclasses
import functools
import hashlib
import itertools
import json
import os
from collections.abc import Callable, Mapping, Sequence
from pathlib import Path
from typing import Any, Union

import cloudpickle  # type: ignore[import-untyped, unused-ignore]
import gymnasium
import numpy as np
from gymnasium import spaces
from numpy.typing import NDArray

from ._tpg import InputError, Network
from ._tpg import train_network as train
from .comparing import controller, play
from .model import VerificationError
from .reports import Evaluation, Report
from .spaces import Interface, _name

PathLike = Union[str, "os.PathLike[str]"]
Floats = NDArray[np.float32]
Layers = list[tuple[Floats, Floats]]

# The most units of a layer, and pieces of the polyline that stands for a tanh: ReLUs are all that the network has.
WIDEST = 512
PIECES = 8
CALIBRATION_STEPS = 5000
# How far the integers may be from the network: a share of equal actions, and a mean distance as a share of half a value's range.
LEAST_EQUAL = 0.9
MOST_DIFFERENCE = 0.05
STATES = 20_000


class NetworkPolicy:
    """A multilayer perceptron in integers, with the names and habits of a Stable-Baselines3 model.

    Attributes: `agreement`, how near it is to the network that it was made from: the share of equal actions, or the mean
    distance of a value as a share of half its range, on the calibration states.
    """

    def __init__(self, network: Network, interface: Interface, states: Floats, agreement: dict[str, float]) -> None:
        self._network, self._interface, self._states = network, interface, states
        self.agreement = agreement

    @property
    def bytes(self) -> int:
        """Bytes of constants on a target."""
        return self._network.bytes

    @property
    def multiplications(self) -> int:
        """Multiplications of a weight that a decision costs."""
        return self._network.multiplications

    def predict(
        self, observation: Any, state: Any = None, episode_start: Any = None, deterministic: bool = True
    ) -> tuple[Any, None]:
        """Returns the action for an observation, or the actions for a batch; and None instead of a recurrent state."""
        states, is_batch = self._interface.states(observation)
        answers = self._network.answers(np.ascontiguousarray(states, dtype=np.float32))
        return self._interface.to_actions(answers, is_batch), None

    def evaluate(self, env: gymnasium.Env[Any, Any], episodes: int = 100, seed: int = 1) -> Evaluation:
        """Runs the network on test episodes of an environment."""
        seeds = [seed * 1_000_003 + place for place in range(episodes)]
        played, _ = play(env, controller(self), seeds, self._interface.limit)
        return Evaluation.of(played, self._interface.name)

    def export_c(self, folder: PathLike, prefix: str | None = None) -> list[Path]:
        """Writes C99 that needs no library into a folder and returns the paths."""
        return [Path(path) for path in self._network.export_c(Path(folder), prefix or self._prefix())]

    def export_rust(self, folder: PathLike, prefix: str | None = None) -> list[Path]:
        """Writes the constants for the `no_std` crate tpg-runtime into a folder and returns the path."""
        return [Path(path) for path in self._network.export_rust(Path(folder), prefix or self._prefix())]

    def _prefix(self) -> str:
        return _name(self._interface.name)[:40]

    def verify(self, states: int = STATES, seed: int = 1) -> int:
        """Compiles the C and compares its answers with the network's, bit for bit; returns the number of states.

        States are those of the calibration, and others around them, with infinities and NaN.

        Raises:
            VerificationError: if an answer differs.
        """
        generator = np.random.default_rng(seed)
        rows = self._states[generator.integers(len(self._states), size=states)]
        spread = self._states.std(axis=0) + 1e-3
        rows = (rows + generator.normal(size=rows.shape) * spread * generator.choice([0.0, 1.0, 30.0], size=(states, 1))).astype(
            np.float32
        )
        rows[::97] = generator.choice(
            np.array([np.nan, np.inf, -np.inf, 0.0, -0.0, 1e30, 1e-40], np.float32), size=rows[::97].shape
        )
        differences = self._network.differences(np.ascontiguousarray(rows))
        if differences:
            raise VerificationError(f"the C differs from the network on {differences} of {states} states")
        return states

    def report(self) -> Report:
        """Returns what a decision costs."""
        data = {"bytes": self.bytes, "multiplications": self.multiplications}
        return Report(
            f"{self.bytes} bytes of constants, {self.multiplications} multiplications of a weight for each decision", data
        )

    def save(self, path: PathLike) -> None:
        """Writes a `policy.q.json`, which `tpg-codegen policy` reads."""
        self._network.save(Path(path))

    @classmethod
    def load(cls, path: PathLike, env: gymnasium.Env[Any, Any]) -> NetworkPolicy:
        """Reads a `policy.q.json` for an environment, which gives the states of `verify`."""
        network, interface = Network.load(Path(path)), Interface.of(env)
        found = len(network.inputs)
        if found != interface.inputs:
            raise InputError(f"{path}: a network of {found} inputs; accepted: {interface.inputs}, as {interface.name} has")
        return cls(network, interface, np.zeros((1, found), np.float32), {})

    def __repr__(self) -> str:
        return f"<NetworkPolicy for {self._interface.name}, {self.bytes} bytes, {self.multiplications} multiplications>"


def train_network(
    env: str | Callable[[], gymnasium.Env[Any, Any]],
    decisions: int = 150_000,
    *,
    seed: int = 1,
    hidden: Sequence[int] = (64, 64),
    settings: Mapping[str, Any] | None = None,
    kind: str = "w8a16",
) -> NetworkPolicy:
    """Trains a soft actor-critic on an environment whose actions are a `Box`, and puts its actor into integers.

    Args:
        env: a Gymnasium id, or a function that makes an environment: each of the parallel episodes has one of its own.
        decisions: in training, each of which lasts four actions of the environment (`learning.decision_lasts`).
        hidden: units of each hidden layer of the actor.
        settings: other values of what `tpg-train config --sac long` prints, such as `{"learning.lanes": 4}`.
        kind: bits of weights and activations: "w8a16" or "w16a16".

    The result's `agreement` has `validation_score`: the mean return on the validation episodes, before the integers.
    """
    make: Callable[[], gymnasium.Env[Any, Any]] = functools.partial(gymnasium.make, env) if isinstance(env, str) else env
    one = make()
    interface = Interface.of(one)
    if not isinstance(interface.action_space, spaces.Box):
        raise InputError(f"{interface.name}: the action space {interface.action_space}; accepted: a Box")
    chosen = {"learning.decisions": decisions, "actor.hidden": list(hidden), **(settings or {})}
    drivers = itertools.chain([interface.driver(one)], (interface.driver(make()) for _ in itertools.count()))
    network, score = train(interface.space(), lambda: next(drivers), json.dumps(chosen), seed, kind)
    policy = NetworkPolicy(network, interface, np.zeros((1, interface.inputs), np.float32), {"validation_score": score})
    policy._states = _visited(policy, make(), interface, seed)[1]
    return policy


def from_sb3(model: Any, *, env: gymnasium.Env[Any, Any] | None = None, kind: str = "w8a16", seed: int = 1) -> NetworkPolicy:
    """Puts the actor of a Stable-Baselines3 model into integers.

    PPO, A2C, DQN, SAC and TD3 with `MlpPolicy`. Hidden layers with ReLU are taken as they are; a tanh, the default of PPO
    and A2C, becomes a polyline of eight pieces, which makes the next layer eight times as wide: train with
    `policy_kwargs={"activation_fn": torch.nn.ReLU}` where size matters. The statistics of a `VecNormalize`, or of a
    `NormalizeObservation` around `env`, and `clip_obs`, become part of the inputs: the exported code reads raw values.

    Args:
        env: calibrates the integers; by default one made from the id of the model's own.
        kind: bits of weights and activations: "w8a16" or "w16a16".

    Raises:
        InputError: if the model is not one of these, or if the integers act otherwise than the model: equal actions in less
            than nine tenths of the states, or values that are farther away than a twentieth of half their range, on average.
    """
    name = type(model).__name__
    layers, squash = _actor(model, name)
    env, normaliser = _raw(model, _env_of(model) if env is None else env)
    interface = Interface.of(env)
    inputs = layers[0][0].shape[1]
    if interface.inputs != inputs:
        raise InputError(f"{name}: a network of {inputs} inputs; accepted: {interface.inputs}, as {interface.name} has")
    layers[-1] = _combined(*layers[-1], interface, name)
    seen, states = _visited(_Normalised(model, normaliser), env, interface, seed)
    policy = _in_integers(layers, interface, squash, states, normaliser, kind)
    policy.agreement.update(_agreement(_Normalised(model, normaliser), policy, interface, seen))
    equal, apart = (policy.agreement.get(key) for key in ("equal_actions", "mean_difference"))
    if (equal is not None and equal < LEAST_EQUAL) or (apart is not None and not apart <= MOST_DIFFERENCE):
        raise InputError(
            f"{name}: integers of {kind} that are unlike the network, {policy.agreement}; accepted: equal actions in "
            f"{LEAST_EQUAL:.0%} of the states, values {MOST_DIFFERENCE:.0%} of half their range away: try kind='w16a16'"
        )
    return policy


def _in_integers(
    layers: Layers, interface: Interface, squash: str, states: Floats, normaliser: _Normaliser, kind: str
) -> NetworkPolicy:
    """Puts layers into integers, calibrated on states."""
    choices, outputs = interface.actions()
    values = [(output, np.float32(low), np.float32(high), squash) for output, low, high in outputs]
    names = [name if len(ends) == 1 else f"{name}[{place}]" for name, ends in interface.sources() for place in range(len(ends))]
    scaled, calibration = _scaled(names, states, layers, normaliser, kind)
    network = Network.quantise(scaled, layers, values, choices, calibration, kind, _sha256(layers))
    return NetworkPolicy(network, interface, states, {})


@dataclasses.dataclass(frozen=True)
class _Normaliser:
    """The wrapper between an observation and the network: subtracts a mean, divides by a deviation, clips."""

    mean: NDArray[np.float64] | None = None
    deviation: NDArray[np.float64] | None = None
    clip: float = np.inf

    def __call__(self, observation: Any) -> Any:
        if self.mean is None or self.deviation is None:
            return observation
        return np.clip((np.asarray(observation) - self.mean) / self.deviation, -self.clip, self.clip).astype(np.float32)


class _Normalised:
    """A model that reads raw observations."""

    def __init__(self, model: Any, normaliser: _Normaliser) -> None:
        self._model, self._normaliser = model, normaliser

    def predict(self, observation: Any, deterministic: bool = True) -> tuple[Any, Any]:
        """Returns the action for a raw observation, or the actions for a batch."""
        action, state = self._model.predict(self._normaliser(observation), deterministic=deterministic)
        return action, state


def _raw(model: Any, env: gymnasium.Env[Any, Any]) -> tuple[gymnasium.Env[Any, Any], _Normaliser]:
    """Returns an environment of raw observations, and what a wrapper of the model's, or of `env`, makes of them."""
    vector = model.get_env()
    while vector is not None and hasattr(vector, "venv"):
        if type(vector).__name__ == "VecNormalize" and vector.norm_obs:
            statistics = vector.obs_rms
            deviation, clip = np.sqrt(np.asarray(statistics.var, np.float64) + vector.epsilon), float(vector.clip_obs)
            if not clip > 0.0:
                raise InputError(f"a VecNormalize of clip_obs = {clip}; accepted: above 0")
            return env, _Normaliser(np.asarray(statistics.mean, np.float64), deviation, clip)
        vector = vector.venv
    inner: Any = env
    while isinstance(inner, gymnasium.Wrapper):
        if isinstance(inner, gymnasium.wrappers.NormalizeObservation):
            if inner is not env or inner.obs_rms.count < 1:
                raise InputError(
                    "a NormalizeObservation that is not outermost, or has seen nothing; accepted: from_sb3(model, env=...) with "
                    "the environment that the model was trained on, and NormalizeObservation around everything else"
                )
            deviation = np.sqrt(np.asarray(inner.obs_rms.var, np.float64) + inner.epsilon)
            return inner.env, _Normaliser(np.asarray(inner.obs_rms.mean, np.float64), deviation)
        inner = inner.env
    return env, _Normaliser()


def _combined(weights: Floats, bias: Floats, interface: Interface, name: str) -> tuple[Floats, Floats]:
    """Returns the last layer with one value for each action: for a combination of choices the sum of the values of its parts."""
    space = interface.action_space
    if isinstance(space, spaces.Box):
        wanted, parts = int(np.prod(space.shape)), None
        if bool(np.any(space.low == space.high)):
            raise InputError(f"{name}: a Box of actions with equal bounds; accepted: a range for each value")
    elif isinstance(space, spaces.Discrete):
        wanted, parts = int(space.n), None
    else:
        assert isinstance(space, (spaces.MultiBinary, spaces.MultiDiscrete))
        sizes = space.nvec.ravel().tolist() if isinstance(space, spaces.MultiDiscrete) else [1] * int(np.prod(space.shape))
        wanted, starts = sum(sizes), np.cumsum([0, *sizes[:-1]])
        chosen = np.array(list(itertools.product(*(range(max(size, 2)) for size in sizes))))
        parts = np.zeros((len(chosen), wanted), np.float32)
        rows = np.arange(len(chosen))
        for place, start in enumerate(starts):
            if isinstance(space, spaces.MultiBinary):
                parts[:, start] = chosen[:, place]
            else:
                parts[rows, start + chosen[:, place]] = 1.0
        if len(parts) > WIDEST:
            raise InputError(f"{name}: {len(parts)} combinations of actions; accepted: up to {WIDEST}")
    if len(bias) != wanted:
        raise InputError(f"{name}: a network of {len(bias)} values for {space}; accepted: {wanted}")
    if parts is None:
        return weights, bias
    return np.ascontiguousarray(parts @ weights, dtype=np.float32), np.ascontiguousarray(parts @ bias, dtype=np.float32)


def _actor(model: Any, name: str) -> tuple[Layers, str]:
    """Returns the linear layers of an actor, ReLU behind all but the last, and how values are limited."""
    if name not in ("PPO", "A2C", "DQN", "SAC", "TD3"):
        raise InputError(f"a model of {name}; accepted: PPO, A2C, DQN, SAC, TD3")
    policy = model.policy
    owner = policy if name in ("PPO", "A2C") else policy.q_net if name == "DQN" else policy.actor
    extractor = type(owner.features_extractor).__name__
    if extractor != "FlattenExtractor":
        raise InputError(f"{name}: a {extractor}; accepted: MlpPolicy with its FlattenExtractor")
    if name in ("PPO", "A2C"):
        if getattr(policy, "squash_output", False):
            raise InputError(f"{name}: squash_output=True; accepted: False")
        modules = [*policy.mlp_extractor.policy_net, policy.action_net]
        return _layers(modules, name), "clamp"
    if name == "DQN":
        return _layers(list(policy.q_net.q_net), name), "clamp"
    if name == "SAC":
        return _layers([*policy.actor.latent_pi, policy.actor.mu], name), "tanh"
    modules = list(policy.actor.mu)
    if type(modules[-1]).__name__ != "Tanh":
        raise InputError(f"{name}: an actor without tanh behind it; accepted: TD3's own")
    return _layers(modules[:-1], name), "tanh"


def _layers(modules: Sequence[Any], name: str) -> Layers:
    """Turns linear layers and their activations into layers with ReLU behind all but the last."""
    layers: Layers = []
    slopes: Floats | None = None
    for module in modules:
        kind = type(module).__name__
        if kind == "Linear":
            weights = module.weight.detach().cpu().numpy().astype(np.float32)
            bias = module.bias.detach().cpu().numpy().astype(np.float32)
            if slopes is not None:
                # The polyline's value is the sum of slope · ReLU, and −1 at the left.
                bias = bias - weights.sum(axis=1)
                weights = np.repeat(weights, len(slopes), axis=1) * np.tile(slopes, weights.shape[1])
                slopes = None
            layers.append((np.ascontiguousarray(weights, dtype=np.float32), np.ascontiguousarray(bias, dtype=np.float32)))
        elif kind == "Tanh":
            weights, bias = layers.pop()
            if len(bias) * PIECES > WIDEST:
                raise InputError(
                    f"{name}: tanh behind {len(bias)} units; accepted: up to {WIDEST // PIECES}. Train with "
                    'policy_kwargs={"activation_fn": torch.nn.ReLU}'
                )
            knots, slopes = _polyline()
            layers.append(
                (
                    np.repeat(weights, PIECES, axis=0),
                    np.ascontiguousarray((bias[:, None] - knots[None]).ravel(), dtype=np.float32),
                )
            )
        elif kind != "ReLU":
            raise InputError(f"{name}: a layer of {kind}; accepted: Linear, ReLU, Tanh")
    for weights, _ in layers:
        if max(weights.shape) > WIDEST:
            raise InputError(f"{name}: a layer of {weights.shape[1]} to {weights.shape[0]}; accepted: up to {WIDEST}")
    return layers


def _polyline() -> tuple[Floats, Floats]:
    """Returns where the pieces of tanh begin, and how much steeper each is: −1 to the left, 1 to the right.

    Knots lie where the curve bends most: evenly in the integral of √|tanh″|.
    """
    x = np.linspace(-4.0, 4.0, 20_001)
    bend = np.sqrt(np.abs(2.0 * np.tanh(x) / np.cosh(x) ** 2))
    share = np.concatenate([[0.0], np.cumsum((bend[1:] + bend[:-1]) / 2)])
    knots = np.interp(np.linspace(0.0, 1.0, PIECES), share / share[-1], x)
    # From −3 to 3, so that the ends meet −1 and 1 early.
    knots = knots * (3.0 / 4.0)
    heights = np.tanh(knots)
    heights[0], heights[-1] = -1.0, 1.0
    slopes = np.diff(heights) / np.diff(knots)
    rises = np.diff(np.concatenate([[0.0], slopes, [0.0]]))
    return knots.astype(np.float32), rises.astype(np.float32)


def _env_of(model: Any) -> gymnasium.Env[Any, Any]:
    """Returns an environment of the model's id."""
    vector = model.get_env()
    if vector is None:
        raise InputError("a model without its environment; accepted: from_sb3(model, env=...)")
    inner = vector
    while type(inner).__name__ == "VecNormalize":
        inner = inner.venv
    if type(inner).__name__ not in ("DummyVecEnv", "SubprocVecEnv"):
        raise InputError(
            f"a model in a {type(inner).__name__}, which changes what the network sees; accepted: from_sb3(model, env=...) with "
            "an environment whose observations are the network's inputs"
        )
    spec = vector.get_attr("spec", 0)[0]
    if spec is None:
        own = getattr(inner, "envs", None)
        if not own:
            raise InputError("an environment without an id; accepted: from_sb3(model, env=...)")
        copy: gymnasium.Env[Any, Any] = cloudpickle.loads(cloudpickle.dumps(own[0]))
        return copy
    # Stable-Baselines3's own wrapper only counts.
    wrappers = tuple(wrapper for wrapper in spec.additional_wrappers if wrapper.name != "Monitor")
    return gymnasium.make(dataclasses.replace(spec, additional_wrappers=wrappers))


def _visited(model: Any, env: gymnasium.Env[Any, Any], interface: Interface, seed: int) -> tuple[list[Any], Floats]:
    """Returns observations that the model visits, and the same as flat states."""
    seen: list[Any] = []
    states: list[NDArray[np.float64]] = []
    episode = 0
    while len(states) < CALIBRATION_STEPS:
        observation, _ = env.reset(seed=seed + episode)
        episode += 1
        done = False
        while not done and len(states) < CALIBRATION_STEPS:
            seen.append(copy.deepcopy(observation))
            states.append(interface.states(observation)[0][0])
            action, _ = model.predict(observation, deterministic=True)
            observation, _, terminated, truncated, _ = env.step(action)
            done = bool(terminated or truncated)
    return seen, np.ascontiguousarray(np.stack(states), dtype=np.float32)


def _scaled(
    names: Sequence[str], states: Floats, layers: Layers, normaliser: _Normaliser, kind: str
) -> tuple[list[tuple[str, np.float32, np.float32]], Floats]:
    """Returns the inputs with offset and scale, which the first layer undoes, and the states with what is clipped.

    The integers clip an input at ±8: a normaliser's bound is put there. Without a bound, or with one so
    wide that inputs would be coarse, an input is scaled if it does not fit or would be coarse: up to twice the greatest that
    calibration saw, it is not clipped.
    """
    offset = np.zeros(len(names)) if normaliser.mean is None else normaliser.mean.ravel()
    deviation = np.ones(len(names)) if normaliser.deviation is None else normaliser.deviation.ravel()
    seen = np.clip((states - offset) / deviation, -normaliser.clip, normaliser.clip)
    most = np.abs(seen).max(axis=0)
    # A power of two: the division by it is exact.
    free = np.exp2(np.floor(np.log2(np.where((most > 4.0) | (most < 0.25), 1.0 / np.maximum(most, 1e-6), 1.0))))
    bound = 8.0 / normaliser.clip
    bounded = most * bound >= 0.25
    scale = np.where(bounded, bound, free)
    if bounded.any():
        # Each input at its bounds, too: activations have room for them.
        rows, places = np.arange(len(seen)), np.flatnonzero(bounded)
        pushed = seen.copy()
        pushed[rows, places[rows % len(places)]] = np.where(rows // len(places) % 2, normaliser.clip, -normaliser.clip)
        seen = np.concatenate([seen, pushed])
    weights, bias = layers[0]
    layers[0] = (np.ascontiguousarray(weights / scale[None], dtype=np.float32), bias)
    inputs = zip(names, offset.astype(np.float32), (scale / deviation).astype(np.float32), strict=True)
    return list(inputs), np.ascontiguousarray(seen * deviation + offset, dtype=np.float32)


def _sha256(layers: Layers) -> str:
    digest = hashlib.sha256()
    for weights, bias in layers:
        digest.update(weights.tobytes())
        digest.update(bias.tobytes())
    return digest.hexdigest()


def _agreement(model: Any, policy: NetworkPolicy, interface: Interface, seen: list[Any]) -> dict[str, float]:
    """Compares the integers with the model on observations that it has visited."""
    rows = np.stack([np.asarray(observation) for observation in seen[:: max(1, len(seen) // 1000)]])
    wanted, _ = model.predict(rows, deterministic=True)
    found, _ = policy.predict(rows)
    if isinstance(interface.action_space, spaces.Box):
        half = (interface.action_space.high - interface.action_space.low) / 2
        apart = np.abs(found - wanted) / half
        return {"mean_difference": float(apart.mean()), "greatest_difference": float(apart.max())}
    equal = np.asarray(found == wanted).reshape(len(rows), -1).all(axis=1)
    return {"equal_actions": float(equal.mean())}


__all__ = ["NetworkPolicy", "from_sb3", "train_network"]
