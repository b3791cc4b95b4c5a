"""The model: from an environment to a graph, and from the graph to code."""

from __future__ import annotations

import concurrent.futures
import dataclasses
import functools
import json
import logging
import os
import secrets
import shutil
import tempfile
import warnings
import weakref
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Any, Union, cast, overload

import cloudpickle  # type: ignore[import-untyped, unused-ignore]
import gymnasium
import numpy as np
from gymnasium.envs.registration import EnvSpec
from numpy.typing import NDArray

from . import _tpg
from ._episodes import Bench, Episodes, Here, Workers, first_difference
from ._tpg import Graph, InputError, Policy, Samples, Space, TrainingError
from .callbacks import BaseCallback, MaybeCallback, _Bar, _TensorBoard, as_list
from .comparing import Comparison, Comparisons, compare, play
from .reports import Evaluation, HallEntry, Proof, Report
from .spaces import Interface, _name
from .tuning import tuned
from .wrappers import Fresh

if TYPE_CHECKING:
    from .network import NetworkPolicy

log = logging.getLogger("tpg_train")

Environment = gymnasium.Env[Any, Any]
EnvironmentLike = Union[str, EnvSpec, Environment, Callable[[], Environment]]
PathLike = Union[str, "os.PathLike[str]"]

# Gymnasium's environments that are built in, and where Gymnasium defines them: an id that was registered anew is another one. An
# action's number and the state's order are Gymnasium's.
BUILT_IN = {
    "CartPole-v1": ("cartpole", "gymnasium.envs.classic_control.cartpole:CartPoleEnv"),
    "Acrobot-v1": ("acrobot", "gymnasium.envs.classic_control.acrobot:AcrobotEnv"),
    "MountainCar-v0": ("mountain-car", "gymnasium.envs.classic_control.mountain_car:MountainCarEnv"),
    "MountainCarContinuous-v0": (
        "mountain-car-continuous",
        "gymnasium.envs.classic_control.continuous_mountain_car:Continuous_MountainCarEnv",
    ),
    "Pendulum-v1": ("pendulum", "gymnasium.envs.classic_control.pendulum:PendulumEnv"),
}
MOST_SEED = 2**64 - 1
MOST_TUNING_STEPS = 200_000
# The seed of the episodes that choose bits: others than those of `evaluate`.
_QUANTISING = 2**63


class StatefulEnvironmentWarning(UserWarning):
    """An environment whose state survives `reset(seed=...)`: its episodes cannot be repeated."""


class VerificationError(RuntimeError):
    """Generated code that does not answer as the graph, or that could not be compiled."""


class Candidate:
    """A policy and the seed of the episode that it is to run: see `TPG.ask`.

    Attributes: `seed`, for `reset(seed=...)`; `steps`, the number of observations that it has answered.
    """

    def __init__(
        self,
        policy: Policy,
        seed: int,
        interface: Interface,
        place: int,
        after: list[int] | None,
        seen: list[list[float]] | None = None,
    ) -> None:
        self.seed = seed
        self.steps = 0
        self._policy, self._interface, self._place = policy, interface, place
        self._after = after
        self._seen: list[list[float]] = [] if seen is None else seen
        self._memory = [0.0] * (policy.inputs - interface.inputs)

    def predict(self, observation: Any) -> Any:
        """Returns the action for an observation of this episode."""
        states, is_batch = self._interface.states(observation)
        if is_batch:
            raise InputError("a batch of observations; accepted: one, of this candidate's own episode")
        state = states[0].tolist() + self._memory
        if self._after is not None:
            self._seen.append(state)
        self.steps += 1
        action, values = self._policy.answer(state)
        outputs = len(values) - len(self._memory)
        self._memory = values[outputs:]
        answer = np.asarray([values[:outputs]], dtype=np.float64) if action is None else np.asarray([action])
        return self._interface.to_actions(answer, False)


@dataclass
class _Asked:
    """What `tell` must reply to."""

    bench: Bench
    kind: str
    candidates: list[Candidate]
    policies: int


class TPG:
    """Evolves a tangled program graph on an environment, and turns it into code.

    Args:
        env: a Gymnasium id or `EnvSpec`, an environment, or a function that makes one. `Discrete`, `MultiDiscrete` and
            `MultiBinary` actions are chosen among; the values of a `Box` of finite bounds are computed, except those whose two
            bounds are equal.
        env_kwargs: arguments of `gymnasium.make` for an id or of the function.
        seed: decides everything: the same seed gives the same graph for any number of workers. None draws one.
        native: runs a plain id of Gymnasium's own that is built in as the built-in problem, some two hundred times as fast. An
            environment object, a function and an id with `env_kwargs` are always used as they are.
        n_workers: worker processes; 0 runs the episodes in this process (built-in problems: on all cores).
        preset: a configuration that `tpg-train config` prints, "quick" having few steps of the environment for each decision;
            or a file: settings that differ from those of "quick", or GEGELATI's params.json.
        settings: other values of the preset's settings, such as `{"tpg.nb_roots": 50}`.
        population: roots of a generation. episodes: episodes of each root in a generation. With either of them everything
            begins at random; without, a search for the weights of sums comes first, which needs fewer steps.
        folder: keeps the run, for `resume=True` in a later process and for `tpg-train report`; by default temporary.
        resume: goes on with the run in the folder, if there is one: `num_timesteps` is that run's, and the first
            `learn(total)` makes the run `total` steps long, so that a script that was stopped ends as it would have; later
            calls add steps.
        max_episode_steps: cuts episodes; by default the environment's own limit, or 10,000.
        input_names: names of the observation's values, for formulas.
        action_names: names of the actions, or of the values of a `Box`, for formulas and code.
        scalar: "f32" or "f64": what the policy and its code compute in; by default the preset's, which is "f32".
    """

    def __init__(
        self,
        env: EnvironmentLike,
        *,
        env_kwargs: Mapping[str, Any] | None = None,
        seed: int | None = 1,
        native: bool = True,
        n_workers: int = 0,
        preset: PathLike = "quick",
        settings: Mapping[str, Any] | None = None,
        population: int | None = None,
        episodes: int | None = None,
        folder: PathLike | None = None,
        resume: bool = False,
        max_episode_steps: int | None = None,
        input_names: Sequence[str] | None = None,
        action_names: Sequence[str] | None = None,
        scalar: str | None = None,
        verbose: int = 0,
    ) -> None:
        self.seed = secrets.randbelow(MOST_SEED) if seed is None else _whole("seed", seed, 0, MOST_SEED)
        self.verbose, self.n_workers = verbose, _whole("n_workers", n_workers, 0)
        population = None if population is None else _whole("population", population, 2)
        episodes = None if episodes is None else _whole("episodes", episodes, 1)
        max_episode_steps = None if max_episode_steps is None else _whole("max_episode_steps", max_episode_steps, 1)
        self.num_timesteps = 0
        # What `quantise` reports about this model's policy.
        self.said = ""
        known = self._set_env(env, dict(env_kwargs or {}), max_episode_steps, input_names, action_names)
        given = (max_episode_steps, input_names, action_names)
        self.native: str | None = known if native and given == (None, None, None) else None
        self._samples: Samples | None = None
        if self.native is not None:
            self._say(f"{self._interface.name} runs as the built-in problem {known}; native=False runs Gymnasium's")
        self._config = self._configuration(os.fspath(preset), settings or {}, population, episodes, scalar)
        self._keep(folder, self._env if isinstance(env, (str, EnvSpec)) or _is_function(env) else None)
        self._resume = self._counts_total = resume
        if resume:
            self.num_timesteps = _steps_of(self.folder)
        self._graph: Graph | None = None
        self._hall: list[HallEntry] = []
        self._asked: _Asked | None = None
        self._checked = False
        if resume:
            self._read_best()

    def _keep(self, folder: PathLike | None, own_env: Environment | None) -> None:
        """Takes the run's folder, a temporary one for None, and closes what is the model's own with the model."""
        self._temporary = tempfile.mkdtemp(prefix="tpg-") if folder is None else None
        self.folder = Path(folder if folder is not None else os.path.join(cast(str, self._temporary), "run"))
        self._let_go = weakref.finalize(self, _let_go, self._temporary, own_env)

    def close(self) -> None:
        """Closes the environment if the model made it, and removes a temporary run. A model that is deleted does so itself."""
        self._leave_asking()
        self._let_go()

    def __enter__(self) -> TPG:
        return self

    def __exit__(self, *_: object) -> None:
        self.close()

    # The environment

    def _set_env(
        self,
        env: EnvironmentLike,
        env_kwargs: dict[str, Any],
        max_episode_steps: int | None,
        input_names: Sequence[str] | None,
        action_names: Sequence[str] | None,
    ) -> str | None:
        """Takes the environment; returns the name of the built-in problem that is the same."""
        self._factory = _factory(env, env_kwargs)
        is_named = self._is_named = isinstance(env, (str, EnvSpec))
        try:
            self._env: Environment = self._factory() if is_named or _is_function(env) else env  # type: ignore[assignment]
        except (gymnasium.error.Error, ImportError) as error:
            if not is_named:
                raise
            raise InputError(f"the id {env!r}: {error}; accepted: a registered Gymnasium environment") from error
        _refuse_normalised(self._env)
        known = None if env_kwargs else _built_in(env, self._env)
        inputs, ends = _names_of(known) if known is not None and input_names is None else (input_names, None)
        ends = ends if action_names is None else list(action_names)
        self._settings: dict[str, Any] = {
            "max_episode_steps": max_episode_steps,
            "input_names": inputs,
            "end_names": ends,
        }
        self._interface = Interface.of(self._env, **self._settings)
        return known

    @property
    def env(self) -> Environment:
        """The environment in this process."""
        return self._env

    def get_env(self) -> Environment:
        """Returns the environment in this process."""
        return self._env

    @property
    def observation_space(self) -> gymnasium.spaces.Space[Any]:
        """The environment's observations."""
        return self._interface.observation_space

    @property
    def action_space(self) -> gymnasium.spaces.Space[Any]:
        """The environment's actions."""
        return self._interface.action_space

    def _say(self, text: str) -> None:
        log.info(text)
        if self.verbose:
            print(text)

    # Training

    def _configuration(
        self,
        preset: str,
        settings: Mapping[str, Any],
        population: int | None,
        episodes: int | None,
        scalar: str | None,
    ) -> str:
        # Steps and targets limit a run.
        chosen: dict[str, Any] = {"learning.nb_generations": 0}
        if population is not None:
            chosen["tpg.nb_roots"] = population
            chosen["tpg.init_nb_roots"] = 2 * population
            # A small population has survivors, too.
            chosen["learning.ratio_deleted_roots"] = max(0.0, min(0.9, 1.0 - 6.0 / population))
        if population is not None or episodes is not None:
            # A generation is what was asked for: no search for weights, whose samples are fewer.
            chosen.update({"start.random": 0.0, "start.share": 0.0})
        if episodes is not None:
            chosen["learning.nb_iterations_per_policy_evaluation"] = episodes
            chosen["selection.racing_episodes"] = min(1, episodes - 1)
        if scalar is not None:
            chosen["language.scalar"] = scalar
        chosen.update(settings)
        return _tpg.configuration(preset, json.dumps(chosen))

    def _start(self, target: float | None, max_steps: int | None) -> tuple[Space | Samples | str, dict[str, Any]]:
        """Returns what runs, and its settings; from now on the run in the folder is this model's."""
        settings = {
            "config": self._config,
            "seed": self.seed,
            "folder": self.folder,
            "resume": self._resume or self._temporary is not None,
            "target": target,
            "max_steps": max_steps,
            "threads": self.n_workers,
            "task": None if self._runs_here else self._interface.name,
            "input_names": list(self._interface.value_names),
        }
        self._resume = True
        return self._samples or self.native or self._interface.space(), settings

    @property
    def _runs_here(self) -> bool:
        """True if the compiled part runs the episodes."""
        return self.native is not None or self._samples is not None

    def _episodes(self, executor: concurrent.futures.Executor | None, n_workers: int) -> Episodes:
        if executor is None and n_workers == 0:
            return Here(self._interface.driver(self._env))
        return Workers(self._factory, self._settings, executor, n_workers)

    def _check_reset(self) -> None:
        """Makes a new environment for each episode, if an id says how, where the state of one survives a reset; else warns."""
        if self._checked or self._runs_here:
            return
        self._checked = True
        difference = first_difference(self._env)
        if difference is not None and self._is_named:
            self._env.close()
            self._factory = functools.partial(Fresh, self._factory)
            self._env = self._factory()
            self._let_go.detach()
            self._let_go = weakref.finalize(self, _let_go, self._temporary, self._env)
            self._say(f"{self._interface.name} keeps state from earlier episodes: each gets a new environment")
            difference = first_difference(self._env)
        if difference is not None:
            warnings.warn(
                f"{self._interface.name}: {difference} is another one when reset(seed=...) gets the same seed again: the "
                "environment keeps state from earlier episodes, or has randomness of its own. Graphs then depend on the number "
                "of workers, and a resumed run is another one. tpg_train.wrappers.Fresh makes a new environment for each episode",
                StatefulEnvironmentWarning,
                stacklevel=3,
            )

    def learn(
        self,
        total_timesteps: int | float,
        callback: MaybeCallback = None,
        log_interval: int = 1,
        tb_log_name: str = "TPG",
        progress_bar: bool = False,
        *,
        target: float | None = None,
        executor: concurrent.futures.Executor | None = None,
        n_workers: int | None = None,
        tensorboard_log: PathLike | None = None,
    ) -> TPG:
        """Trains for about `total_timesteps` more environment steps, an int or a float such as `1e5`. Generations are always
        finished, with fewer episodes where one would take more than half of the steps.

        A second call continues where the first one stopped, even after Ctrl-C or an exception.

        Args:
            target: ends the training as soon as a policy reaches this mean return on the validation episodes.
            callback: called after every generation: see `tpg_train.callbacks`.
            executor: runs the episodes: any `concurrent.futures.Executor`.
            n_workers: worker processes, if there is no executor; by default the model's.
            tensorboard_log: folder for TensorBoard.
        """
        total_timesteps = _whole("total_timesteps", total_timesteps, 1)
        self.said = ""
        self._leave_asking()
        if self.native is not None and executor is not None:
            self._say("a built-in problem runs in this process: executor= is ignored; native=False uses it")
        self._check_reset()
        more: list[BaseCallback] = [_Bar(total_timesteps)] if progress_bar else []
        if tensorboard_log is not None:
            more.append(_TensorBoard(tensorboard_log, tb_log_name))
        callbacks = as_list(callback, more)
        callbacks.init_callback(self)
        figures: dict[str, Any] = {"self": self, "progress": {}}
        begin, before = self.num_timesteps, 0 if self._counts_total else self.num_timesteps
        self._counts_total = False
        began = False

        def progress(says: dict[str, Any]) -> bool:
            nonlocal began
            self._note(says)
            figures["progress"] = says
            callbacks.update_locals(figures)
            on = True
            if not began:
                callbacks.on_training_start(figures, globals())
                began = True
            else:
                on = bool(callbacks.on_step())
                callbacks.on_rollout_end()
                if self.verbose and says["generations"] % log_interval == 0:
                    print(_line(says))
            callbacks.on_rollout_start()
            return on

        if self._graph is not None and self.num_timesteps == 0:
            warnings.warn(
                "learn() begins a new run and replaces the policy that was loaded; TPG(..., folder=, resume=True) goes on",
                stacklevel=2,
            )
        if self._runs_here:
            executor, n_workers = None, 0
        episodes = self._episodes(executor, self.n_workers if n_workers is None else n_workers)
        try:
            _tpg.evolve(*self._start(target, before + total_timesteps), episodes.run, episodes.play, progress)
        except KeyboardInterrupt:
            self._say(f"stopped; learn() goes on from {self.num_timesteps} steps")
            raise
        finally:
            episodes.close()
            if began:
                callbacks.on_training_end()
            self._read_best()
        made = self.num_timesteps - before
        if made > 1.2 * max(total_timesteps, begin - before):
            warnings.warn(
                f"learn({total_timesteps}) made {made} steps: an episode of each policy takes that many. max_episode_steps= "
                "makes them shorter, population= fewer",
                stacklevel=2,
            )
        return self

    def _note(self, says: dict[str, Any]) -> None:
        """Takes the figures of a generation."""
        self.num_timesteps = says["steps"]
        if "graph" in says:
            self._graph = says["graph"]
            self._hall = [HallEntry(size, score, graph) for size, score, graph in says["hall"]]

    def _read_best(self) -> None:
        """Reads the best graph of a run that stopped before this process saw one.

        Raises:
            InputError: if it is one for another environment.
        """
        file = self.folder / "graph.json"
        if self._graph is None and file.exists():
            graph = Graph.load(file)
            if not self._runs_here:
                _check_graph(graph, str(self.folder), self._interface, is_named=True)
            self._graph = graph

    # Hardware in the loop

    def ask(self) -> list[Candidate]:
        """Returns the episodes to run before evolution can go on; none once it has ended.

        Each candidate is a policy and the seed of one episode. Run them in any order, on any machine, then `tell` their
        returns. `population=` and `episodes=` of the constructor say how many there are; without them a search for weights comes
        first, whose samples are fewest.
        """
        if self.native is not None:
            raise InputError(f"ask() on the built-in problem {self.native}; accepted: TPG(..., native=False)")
        if self._asked is not None and self._asked.candidates:
            return self._asked.candidates
        if self._asked is None:
            bench = Bench(*self._start(None, None))
            weakref.finalize(self, bench.close)
            self._asked = _Asked(bench, "", [], 0)
        bench = self._asked.bench
        while True:
            kind, says = bench.next()
            if kind == "progress":
                self._note(*says)
                bench.reply(True)
                continue
            if kind == "end":
                self._asked = None
                if says is not None:
                    raise says
                return []
            policies = says[0]
            given = policies
            if kind == "evaluate":
                given = [(policy, seed, None) for policy in policies for seed in says[1]]
            candidates = [
                Candidate(policy, seed, self._interface, place, after) for place, (policy, seed, after) in enumerate(given)
            ]
            self._asked = _Asked(bench, kind, candidates, len(policies))
            return candidates

    def tell(self, candidates: Sequence[Candidate], returns: Sequence[float]) -> None:
        """Takes the return of each candidate's episode."""
        asked = self._asked
        if (
            asked is None
            or len(candidates) != len(returns)
            or {id(one) for one in candidates} != {id(one) for one in asked.candidates}
        ):
            raise InputError("other candidates than ask() returned; accepted: each of them once, with its return")
        scores = {candidate._place: float(score) for candidate, score in zip(candidates, returns, strict=True)}
        bad = [candidate.seed for candidate, score in zip(candidates, returns, strict=True) if np.isnan(score)]
        if bad:
            raise InputError(f"seed {bad[0]}: a return of NaN; accepted: a number")
        # Of the rewards, only their sum is known.
        played = [(scores[place], one.steps, None, 0.0) for place, one in enumerate(asked.candidates)]
        if asked.kind == "play":
            silent = next((one for one in asked.candidates if one.steps == 0), None)
            if silent is not None:
                raise InputError(f"seed {silent.seed}: no observation; accepted: an episode in which predict() answers some")
            seen = [one._policy.moments(one._seen) for one in asked.candidates]
            # An episode may be shorter than when it was played first.
            states = [[one._seen[min(after, one.steps - 1)] for after in one._after or []] for one in asked.candidates]
            asked.bench.reply(list(zip(played, seen, states, strict=True)))
        else:
            seeds = len(asked.candidates) // asked.policies
            asked.bench.reply([played[start : start + seeds] for start in range(0, len(played), seeds)])
        self._asked = _Asked(asked.bench, "", [], 0)

    def _leave_asking(self) -> None:
        if self._asked is not None:
            self._asked.bench.close()
            self._asked = None

    # The graph

    @property
    def has_graph(self) -> bool:
        """True once a policy has been validated, or was loaded."""
        return self._graph is not None

    @property
    def graph(self) -> _GraphView:
        """The best graph so far. In a notebook it draws itself."""
        return _GraphView(self._best())

    def _best(self) -> Graph:
        if self._graph is None:
            raise TrainingError("there is no graph yet: learn() longer, until a policy has been validated")
        return self._graph

    @property
    def hall_of_fame(self) -> list[HallEntry]:
        """The best policy of each size, smallest first: none of them is both larger and worse than another."""
        return list(self._hall)

    def use(self, entry: HallEntry) -> TPG:
        """Makes a policy of the hall of fame the model's own."""
        self._graph = entry.graph
        return self

    def predict(
        self,
        observation: Any,
        state: Any = None,
        episode_start: Any = None,
        deterministic: bool = True,
    ) -> tuple[Any, Any]:
        """Returns the action for an observation, or the actions for a batch; and the policy's memory for the next call, None
        without one. `state` is the memory that the last call returned, None at an episode's first; it begins anew where
        `episode_start` says so.

        The policy is deterministic whatever `deterministic` says.
        """
        states, is_batch = self._interface.states(observation)
        graph = self._best()
        states = self._interface.read_by(graph, states)
        if graph.memory == 0:
            return self._interface.to_actions(graph.answers(np.ascontiguousarray(states)), is_batch), None
        memory = np.zeros((len(states), graph.memory)) if state is None else np.array(state, dtype=np.float64, ndmin=2)
        if memory.shape != (len(states), graph.memory):
            raise InputError(f"a state of shape {memory.shape}; accepted: {(len(states), graph.memory)}")
        if episode_start is not None:
            memory[np.broadcast_to(np.asarray(episode_start, dtype=bool), len(states))] = 0.0
        answers = graph.answers(np.ascontiguousarray(np.hstack([states, memory])))
        outputs = answers.shape[1] - graph.memory
        return self._interface.to_actions(answers[:, :outputs], is_batch), answers[:, outputs:]

    @overload
    def evaluate(
        self,
        episodes: int = 100,
        *,
        seed: int = 1,
        native: bool | None = None,
        executor: concurrent.futures.Executor | None = None,
        n_workers: int | None = None,
        other: None = None,
    ) -> Evaluation: ...

    @overload
    def evaluate(self, episodes: int = 100, *, seed: int = 1, other: list[Any] | tuple[Any, ...]) -> Comparisons: ...

    @overload
    def evaluate(self, episodes: int = 100, *, seed: int = 1, other: Any) -> Comparison: ...

    def evaluate(
        self,
        episodes: int = 100,
        *,
        seed: int = 1,
        native: bool | None = None,
        executor: concurrent.futures.Executor | None = None,
        n_workers: int | None = None,
        other: Any = None,
    ) -> Evaluation | Comparison | Comparisons:
        """Runs the policy on test episodes, which no training and no selection has seen.

        Args:
            native: on the built-in problem; by default if the model was trained on it.
            other: another controller, to compare with on the same episodes of the environment, in this process: a function of
                an observation, or a model with `predict`. Or one that is tuned first: "pid", a loop around one value of the
                observation for each output, "relay", a loop that switches, both in up to 200,000 steps, or "linear", weighted
                sums in as many steps as this model has learned from. Or a list of such; `tpg-train report` shows them.
        """
        graph = self._best()
        if episodes < 1:
            raise InputError(f"{episodes} episodes; accepted: 1 or more")
        if other is not None:
            policy, interface = self._interface.policy(graph), self._interface
            seeds = _tpg.test_seeds(seed, episodes)
            this = lambda: Candidate(policy, 0, interface, 0, None).predict  # noqa: E731
            several = isinstance(other, (list, tuple))
            kinds = list(other) if several else [other]
            if not kinds:
                raise InputError("other=[]; accepted: one or more controllers")
            rivals = [self._rival(kind) if isinstance(kind, str) else kind for kind in kinds]
            ours, found = compare(self.env, this, rivals, seeds, interface.limit, interface.name)
            named = [
                dataclasses.replace(one, name=kind, law=_law(rival)) if isinstance(kind, str) else one
                for one, kind, rival in zip(found, kinds, rivals, strict=True)
            ]
            self._record(graph, ours, named)
            return Comparisons(named) if several else named[0]
        if self.native is not None and native is not False:
            return Evaluation.of_report(json.loads(_tpg.evaluate_native(self.native, graph, episodes, seed)))
        place = self._episodes(executor, self.n_workers if n_workers is None and self.native is None else n_workers or 0)
        try:
            played = place.run([self._interface.policy(graph)], _tpg.test_seeds(seed, episodes))[0]
            self._record(graph, played)
            return Evaluation.of(played, self._interface.name)
        finally:
            place.close()

    def _record(
        self, graph: Graph, played: Sequence[tuple[float, int, bool | None, float]], rivals: Sequence[Comparison] = ()
    ) -> None:
        """Writes test episodes into the run's folder, for `tpg-train report`; rivals on the same episodes stay there."""
        results = [
            {"outcome": 0, "success": success, "score": score, "final_reward": last, "measure": 0.0, "actions": steps}
            for score, steps, success, last in played
        ]
        file = self.folder / "tested.jsonl"
        said = {"graph": graph.sha256, "episodes": results}
        old = json.loads(file.read_text()) if file.exists() else {}
        known = {rival["name"]: rival for rival in old.get("rivals", []) if said == {key: old[key] for key in said}}
        known |= {rival.name: rival.as_json() for rival in rivals}
        effort = next(
            (dataclasses.asdict(rival.efforts[0]) for rival in rivals if rival.efforts), old.get("effort") if known else None
        )
        scores = [score for score, *_ in played] + [score for rival in rivals for score in rival.returns[1]]
        if (self.folder / "graph.json").exists() and np.isfinite(scores).all():
            file.write_text(json.dumps({**said, "effort": effort, "rivals": list(known.values())}) + "\n")

    def _rival(self, kind: str) -> Any:
        """Tunes a controller of a kind."""
        if kind not in ("pid", "relay", "linear"):
            raise InputError(f"other={kind!r}; accepted: pid, relay, linear, a function of an observation, a model with predict")
        steps = self.num_timesteps or 100_000
        if kind != "linear":
            return tuned(kind, self._env, self._interface, min(steps, MOST_TUNING_STEPS))
        return self._sibling({"start.share": 1.0, "start.random": 1.0}).learn(steps)

    def formula(self) -> str:
        """Returns what the policy computes, as formulas."""
        return self._best().formula()

    def report(self, *targets: str) -> Report:
        """Returns flash, RAM, stack, operations and the most instructions of the code on targets.

        By default these are "m4f" and "host"; others are "m0", "m3", "m4", "m7", "m33", "rv32imac",
        "rv32imafc", "rp2040", "esp32-c3" and "atmega328p".
        """
        return self.graph.report(*targets)

    def quantise(self, bits: int | None = None, states: Any = None, episodes: int = 100) -> TPG:
        """Returns a model of the policy in integers, for chips without an FPU; its `said` tells what they change.

        The policy plays episodes that `evaluate` does not. Twice the ranges that it visits, or the ranges of `states`, a row for
        each, fill the bits of the inputs. Then the integers play the same episodes. Without `bits`, these are the fewest
        of 8, 10, 12, 14 and 16 with which the mean return is at most one standard error lower. With `episodes=0`, and for a
        model without its environment, there are the declared ranges, which may be much wider than what happens, and 16 bits.
        """
        graph, interface = self._best(), self._interface
        rows = None if states is None else _rows(states, len(graph.inputs), graph.memory)
        bits = None if bits is None else _whole("bits", bits, 2, 16)
        if episodes == 0 or isinstance(self._env, _Described):
            return self._in_integers(*graph.quantise(16 if bits is None else bits, rows))
        count = _whole("episodes", episodes, 2)
        if self.native is not None:
            return self._in_integers(*_tpg.quantise_native(self.native, graph, bits, rows, count))
        seeds = _tpg.test_seeds(_QUANTISING, count)

        def played(graph: Graph) -> tuple[list[float], NDArray[np.float64]]:
            policy = interface.policy(graph)
            seen: list[list[float]] = []
            results, _ = play(self.env, lambda: Candidate(policy, 0, interface, 0, [], seen).predict, seeds, interface.limit)
            states = interface.read_by(graph, np.asarray(seen))
            return [score for score, *_ in results], states[:, : len(graph.inputs) - graph.memory]

        return self._in_integers(*graph.quantise_keeping(bits, rows, played))

    def _in_integers(self, graph: Graph, said: str) -> TPG:
        if isinstance(self._env, _Described):
            whole = TPG._of(graph, self._interface.name, [])
        else:
            whole = self._sibling({})
            whole._graph = graph
        whole.said = said
        return whole

    def _sibling(self, settings: dict[str, Any]) -> TPG:
        """Returns a new model of the same environment."""
        if self.native:
            return TPG(self._interface.name, seed=self.seed, settings=settings)
        names = {"input_names": self._settings["input_names"], "action_names": self._settings["end_names"]}
        limit = self._settings["max_episode_steps"]
        return TPG(self._env, seed=self.seed, settings=settings, max_episode_steps=limit, native=False, **names)

    def export_c(
        self,
        folder: PathLike,
        prefix: str | None = None,
        profile: str = "fast",
        fixed: int | None = None,
        network: NetworkPolicy | None = None,
    ) -> list[Path]:
        """Writes C99 into a folder and returns the paths. `profile` is "fast", "balanced", "small" or "constant-time".

        With `fixed`, the C computes in integers, from inputs and weights of so many bits: see `quantise`. With the `network` that
        the policy asks, `PREFIX_decide` of `PREFIX_decide.h` answers for both; the network names the policy's own actions.
        """
        if network is None:
            return self._export(folder, "c", prefix, profile, fixed)
        graph = (self if fixed is None else self.quantise(fixed))._best()
        files = graph.export_with(Path(folder), prefix or self._prefix(), profile, network._network)
        return [Path(path) for path in files]

    def export_rust(
        self, folder: PathLike, prefix: str | None = None, profile: str = "constant-time", fixed: int | None = None
    ) -> list[Path]:
        """Writes `no_std` Rust into a folder and returns the paths."""
        return self._export(folder, "rust", prefix, profile, fixed)

    def _export(self, folder: PathLike, language: str, prefix: str | None, profile: str, fixed: int | None) -> list[Path]:
        graph = (self if fixed is None else self.quantise(fixed))._best()
        return [Path(path) for path in graph.export(Path(folder), language, prefix or self._prefix(), profile)]

    def _prefix(self) -> str:
        return _name(self._interface.name)[:40]

    def verify(
        self,
        states: int = 100_000,
        *,
        seed: int = 1,
        languages: Sequence[str] = ("c",),
        profiles: Sequence[str] = ("fast", "balanced", "small", "constant-time"),
    ) -> Proof:
        """Compiles the generated code and compares it with the interpreter, bit for bit.

        Raises:
            VerificationError: if an answer differs, or there is no compiler.
        """
        data, holds = self._best().verify(list(languages), list(profiles), states, seed)
        proof = Proof(json.loads(data))
        if not holds:
            raise VerificationError(str(proof))
        return proof

    # Files

    def save(self, path: PathLike) -> None:
        """Writes the graph as a `graph.json`, which `tpg-codegen` reads."""
        self._best().save(Path(path))

    @classmethod
    def load(cls, path: PathLike, env: EnvironmentLike | None = None, **arguments: Any) -> TPG:
        """Reads a `graph.json`. Without an environment, one that only predicts takes its place: inputs as a Box.

        A graph alone cannot be trained further; `TPG(env, folder=..., resume=True)` goes on with a run.
        """
        graph = Graph.load(Path(path))
        if env is None:
            return cls._of(graph, Path(path).stem, [], **arguments)
        model = cls(env, **arguments)
        _check_graph(graph, str(path), model._interface, arguments.get("input_names") is not None)
        if model.native is not None and graph.inputs != [f"{one}[0]" for one in _names_of(model.native)[0]]:
            model.native = None
        model._graph = graph
        return model

    @classmethod
    def _of(cls, graph: Graph, name: str, hall: list[HallEntry], **arguments: Any) -> TPG:
        """Returns a model without an environment, which only predicts."""
        model = cls(_Described.of(graph), native=False, **arguments)
        model._interface = dataclasses.replace(model._interface, name=name)
        model._graph, model._hall = graph, hall
        return model

    def __getstate__(self) -> dict[str, Any]:
        """Returns what a copy or a pickle holds: the environment, the graph, and the run where its folder is temporary."""
        if self._asked is not None:
            raise InputError("a copy of a model between ask() and tell(); accepted: after learn(), or before ask()")
        run = {}
        if self._temporary is not None and self.folder.exists():
            run = {path.name: path.read_bytes() for path in self.folder.iterdir() if path.suffix != ".lock"}
        kept = {key: value for key, value in self.__dict__.items() if key not in ("_temporary", "_let_go", "_env", "_factory")}
        return {"kept": kept, "env": cloudpickle.dumps((self._env, self._factory)), "run": run if self._temporary else None}

    def __setstate__(self, state: dict[str, Any]) -> None:
        self.__dict__.update(state["kept"])
        self._env, self._factory = cloudpickle.loads(state["env"])
        self._keep(self.folder if state["run"] is None else None, self._env)
        if state["run"] is not None:
            for name, content in state["run"].items():
                self.folder.mkdir(exist_ok=True)
                (self.folder / name).write_bytes(content)

    def __repr__(self) -> str:
        where = f"built-in {self.native}" if self.native else self._interface.name
        return f"<TPG on {where}, seed {self.seed}, {self.num_timesteps} steps>"


def _law(rival: Any) -> str:
    """Returns the equations of a controller's formula in one line; a source of one value has no index."""
    formula = str(rival.formula())
    if isinstance(rival, TPG):
        inputs = rival._best().inputs
        formula = "; ".join(line.strip() for line in formula.splitlines() if line.startswith("  "))
        for name in (name.removesuffix("[0]") for name in inputs if name.removesuffix("[0]") + "[1]" not in inputs):
            formula = formula.replace(f"{name}[0]", name)
    return formula


def _check_graph(graph: Graph, file: str, interface: Interface, is_named: bool) -> None:
    """Compares a graph's inputs and answers with those of an environment: their number, names and bounds.

    Names given for the file's graph alone are taken as they are: an observation of one unnamed Box has none of its own.
    """
    sources = [(name, ends) for name, values in interface.sources() for ends in values]
    inputs, outputs_of_graph = (
        graph.inputs[: len(graph.inputs) - graph.memory],
        graph.outputs[: len(graph.outputs) - graph.memory],
    )
    if interface.eye is not None:
        graph.columns(interface.space())
        inputs, sources = [], []
    if len(inputs) != len(sources):
        raise InputError(f"{file}: a graph of {len(inputs)} inputs; accepted: {len(sources)}, as {interface.name} has")
    own, numbered = (
        [f"{name}[{place}]" for name, values in sources for place in range(len(values))]
        for sources in (interface.named(), interface.sources())
    )
    if interface.eye is None and inputs not in (own, numbered) and (is_named or len(interface.parts) > 1):
        raise InputError(
            f"{file}: a graph of the inputs {', '.join(inputs)}; accepted: {', '.join(own)}; input_names= gives others"
        )
    choices, outputs = interface.actions()
    found, accepted = len(graph.actions) or len(outputs_of_graph), len(choices) or len(outputs)
    if bool(graph.actions) != bool(choices) or found != accepted:
        kinds = [f"{count} {'actions' if named else 'outputs'}" for count, named in ((found, graph.actions), (accepted, choices))]
        raise InputError(f"{file}: a graph of {kinds[0]}; accepted: {kinds[1]}, as {interface.name} has")
    own_bounds = sources + [(name, (low, high)) for name, low, high in outputs]
    bounds = list(graph.ranges)[: len(inputs)] + [(low, high) for _, low, high in outputs_of_graph]
    if graph.counts:
        return
    for (name, ends), known in zip(own_bounds, bounds, strict=True):
        # An end that the environment does not declare was estimated.
        if any(np.isfinite(end) and np.float32(end) != np.float32(one) for end, one in zip(ends, known, strict=True)):
            raise InputError(
                f"{file}: {name} from {known[0]} to {known[1]}; accepted: {ends[0]} to {ends[1]}, as {interface.name} has"
            )


class _GraphView:
    """The best graph of a model: `str()` gives its formulas, a notebook its picture."""

    def __init__(self, graph: Graph) -> None:
        self._graph = graph

    def __getattr__(self, name: str) -> Any:
        return getattr(self._graph, name)

    def report(self, *targets: str) -> Report:
        """Returns what the code costs on targets, as `TPG.report` does."""
        text, data = self._graph.report(list(targets) or ["m4f", "host"])
        return Report(text, json.loads(data))

    def _repr_svg_(self) -> str:
        return self._graph.svg()

    def __str__(self) -> str:
        return self._graph.formula()

    def __repr__(self) -> str:
        return repr(self._graph)


class _Described(gymnasium.Env[Any, Any]):
    """An environment that only describes what a graph reads and answers."""

    def __init__(self, observation_space: gymnasium.Space[Any], action_space: gymnasium.Space[Any]) -> None:
        self.observation_space, self.action_space = observation_space, action_space

    @classmethod
    def of(cls, graph: Graph) -> _Described:
        """Returns the environment of a graph."""
        low, high = np.asarray(graph.ranges[: len(graph.ranges) - graph.memory], dtype=np.float64).T
        inputs = gymnasium.spaces.Box(low, high, dtype=np.float64)
        if not graph.outputs:
            return cls(inputs, gymnasium.spaces.Discrete(len(graph.actions)))
        _, least, most = zip(*graph.outputs[: len(graph.outputs) - graph.memory], strict=True)
        return cls(inputs, gymnasium.spaces.Box(np.array(least, np.float32), np.array(most, np.float32)))

    def reset(self, *, seed: int | None = None, options: dict[str, Any] | None = None) -> Any:
        raise InputError("a model that was loaded without its environment; accepted: TPG.load(path, env)")

    def step(self, action: Any) -> Any:
        raise InputError("a model that was loaded without its environment; accepted: TPG.load(path, env)")


def _let_go(folder: str | None, env: Environment | None) -> None:
    if env is not None:
        env.close()
    if folder is not None:
        shutil.rmtree(folder, ignore_errors=True)


def _steps_of(folder: Path) -> int:
    """Returns the number of environment steps of the run in a folder; 0 if there is none."""
    log = folder / "generations.jsonl"
    rows = log.read_text(encoding="utf-8").splitlines() if log.exists() else []
    return int(json.loads(rows[-1])["steps"]) if rows else 0


def _is_function(env: Any) -> bool:
    return callable(env) and (isinstance(env, type) or not hasattr(env, "reset"))


def _rows(states: Any, length: int, memory: int) -> NDArray[np.float64]:
    """Returns states as rows of a graph's inputs; memory may be left out."""
    try:
        rows = np.ascontiguousarray(states, dtype=np.float64)
    except (TypeError, ValueError) as error:
        raise InputError(f"states: {error}; accepted: rows of {length - memory} numbers") from error
    if rows.ndim != 2 or len(rows) == 0 or rows.shape[1] not in (length, length - memory):
        raise InputError(f"states of shape {rows.shape}; accepted: (n, {length - memory}), n from 1")
    return np.hstack([rows, np.zeros((len(rows), length - rows.shape[1]))])


def _whole(name: str, value: Any, least: int, most: int | None = None) -> int:
    """Returns a whole number in a range, also where it is a float such as 1e5."""
    accepted = f"a whole number from {least}" + ("" if most is None else f" to {most}")
    try:
        number = int(value)
    except (TypeError, ValueError, OverflowError) as error:
        raise InputError(f"{name} = {value!r}; accepted: {accepted}") from error
    if number != value or number < least or (most is not None and number > most):
        raise InputError(f"{name} = {value!r}; accepted: {accepted}")
    return number


def _factory(env: EnvironmentLike, env_kwargs: dict[str, Any]) -> Callable[[], Environment]:
    """Returns what makes the environment, here and in workers."""
    if isinstance(env, (str, EnvSpec)):
        return functools.partial(gymnasium.make, env, **env_kwargs)
    if _is_function(env):
        return functools.partial(cast(Callable[..., Environment], env), **env_kwargs) if env_kwargs else env  # type: ignore[return-value]
    if env_kwargs:
        raise InputError("env_kwargs with an environment; accepted: with an id or a function that makes one")
    if isinstance(env, gymnasium.vector.VectorEnv):
        raise InputError("a vector environment, as make_vec() returns it; accepted: a single one; n_workers= runs several")
    return functools.partial(_copy, env)  # type: ignore[arg-type]


def _copy(env: Environment) -> Environment:
    """Returns a copy of an environment, as it arrives in a worker."""
    copy: Environment = cloudpickle.loads(cloudpickle.dumps(env))
    return copy


def _refuse_normalised(env: Any) -> None:
    """Refuses observations that running statistics change: neither an episode nor the exported code could repeat them."""
    while isinstance(env, gymnasium.Wrapper):
        if isinstance(env, gymnasium.wrappers.NormalizeObservation):
            raise InputError(
                "NormalizeObservation, whose statistics are not in the graph; accepted: the environment without it: training "
                "finds the scale of each input itself, and the exported code reads raw values"
            )
        env = env.env


def _built_in(given: EnvironmentLike, env: Environment) -> str | None:
    """Returns the name of the built-in problem that a plain id of Gymnasium's own stands for."""
    spec = getattr(env, "spec", None)
    if not isinstance(given, str) or spec is None or spec.id not in BUILT_IN:
        return None
    name, entry_point = BUILT_IN[spec.id]
    if name not in dict(_tpg.problems()):
        return None
    described = json.loads(_tpg.NativeEnv(name).description)
    # A built-in problem may add derived sources, which an observation of Gymnasium's does not have.
    lengths = [len(source["ranges"]) for source in described["sources"]]
    found = (spec.entry_point, spec.max_episode_steps, spec.kwargs, spec.additional_wrappers, lengths)
    inputs = int(np.prod(env.observation_space.shape or ()))
    return name if found == (entry_point, described["time_limit"], {}, (), [1] * inputs) else None


def _names_of(problem: str) -> tuple[list[str], list[str]]:
    """Returns the names of a built-in problem's inputs, and of its actions or outputs."""
    described = json.loads(_tpg.NativeEnv(problem).description)
    inputs = [source["name"] for source in described["sources"]]
    return inputs, described["actions"] or [name for name, _, _ in described["outputs"]]


def _line(says: dict[str, Any]) -> str:
    validated = says.get("best_validated")
    end = "" if validated is None else f", {validated:.2f} validated"
    scores = f"best {says['best_score']:.2f}, median {says['median_score']:.2f}{end}"
    return f"generation {says['generations']}: {says['steps']} steps, {scores}"
