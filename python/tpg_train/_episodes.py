"""Whole episodes, here or elsewhere: a worker is sent policies, never single observations."""

from __future__ import annotations

import atexit
import concurrent.futures
import functools
import hashlib
import multiprocessing
import queue
import threading
from collections.abc import Callable, Sequence
from concurrent.futures.process import BrokenProcessPool
from typing import Any, Protocol, Union

import cloudpickle  # type: ignore[import-untyped, unused-ignore]
import gymnasium

from ._tpg import Driver, InputError, Policy, Samples, Space, TrainingError, evolve
from .spaces import Interface

Played = tuple[float, int, Union[bool, None], float]
Seen = tuple[Played, str, list[list[float]]]
Environment = gymnasium.Env[Any, Any]

ATTEMPTS = 3
PIECES_FOR_EACH_WORKER = 8
USUAL_WORKERS = 4


class Episodes(Protocol):
    """A place where episodes run."""

    def run(self, policies: Sequence[Policy], seeds: Sequence[int]) -> list[list[Played]]:
        """Returns one result for each policy and seed."""
        ...

    def play(self, plays: Sequence[tuple[Policy, int, list[int]]]) -> list[Seen]:
        """Returns the result of one episode for each policy and seed, the moments of what was seen, and some states."""
        ...

    def close(self) -> None:
        """Lets go of what it holds."""
        ...


class Here:
    """Episodes in this process, on one environment."""

    def __init__(self, driver: Driver) -> None:
        self._driver = driver

    def run(self, policies: Sequence[Policy], seeds: Sequence[int]) -> list[list[Played]]:
        return [self._driver.run(policy, list(seeds)) for policy in policies]

    def play(self, plays: Sequence[tuple[Policy, int, list[int]]]) -> list[Seen]:
        return [self._driver.play(policy, seed, after) for policy, seed, after in plays]

    def close(self) -> None:
        pass


class _Kept(threading.local):
    """The drivers of a thread of a worker: two episodes of one environment at a time would disturb each other."""

    def __init__(self) -> None:
        self.drivers: dict[str, Driver] = {}


_kept = _Kept()


# A method of the driver, a policy's bytes, and what else the method takes.
_Piece = tuple[str, bytes, tuple[Any, ...]]


def _work(token: str, made_by: bytes, pieces: list[_Piece]) -> list[Any]:
    """Runs pieces of work in a worker, which keeps its environment for the next ones."""
    driver = _kept.drivers.get(token)
    if driver is None:
        factory, settings = cloudpickle.loads(made_by)
        env = factory()
        atexit.register(env.close)
        driver = _kept.drivers[token] = Interface.of(env, **settings).driver(env)
    return [getattr(driver, method)(Policy.from_bytes(policy), *more) for method, policy, more in pieces]


class Workers:
    """Episodes in the workers of an executor: any `concurrent.futures.Executor`, or processes of its own."""

    def __init__(
        self,
        factory: Callable[[], Environment],
        settings: dict[str, Any],
        executor: concurrent.futures.Executor | None,
        n_workers: int,
    ) -> None:
        try:
            self._made_by: bytes = cloudpickle.dumps((factory, settings))
        except Exception as error:
            raise InputError(
                f"an environment that cannot be sent to workers: {error}; accepted: an id, or a function that makes it"
            ) from error
        self._token = hashlib.sha256(self._made_by).hexdigest()
        self._own = executor is None
        self._n_workers = n_workers or _size_of(executor)
        self._executor = executor or self._pool()

    def _pool(self) -> concurrent.futures.Executor:
        # Forked processes and threads do not go together.
        context = multiprocessing.get_context("spawn")
        return concurrent.futures.ProcessPoolExecutor(self._n_workers, mp_context=context)

    def run(self, policies: Sequence[Policy], seeds: Sequence[int]) -> list[list[Played]]:
        total = len(policies) * len(seeds)
        length = max(1, total // (PIECES_FOR_EACH_WORKER * self._n_workers))
        pieces: list[_Piece] = []
        places = []
        for place, policy in enumerate(policies):
            sent = policy.to_bytes()
            for start in range(0, len(seeds), length):
                pieces.append(("run", sent, (list(seeds[start : start + length]),)))
                places.append(place)
        results: list[list[Played]] = [[] for _ in policies]
        together = max(1, length // max(1, min(length, len(seeds))))
        for place, played in zip(places, self._all(pieces, together), strict=True):
            results[place].extend(played)
        return results

    def play(self, plays: Sequence[tuple[Policy, int, list[int]]]) -> list[Seen]:
        together = max(1, len(plays) // (PIECES_FOR_EACH_WORKER * self._n_workers))
        return self._all([("play", policy.to_bytes(), (seed, after)) for policy, seed, after in plays], together)

    def _all(self, pieces: Sequence[_Piece], together: int) -> list[Any]:
        """Returns the results of pieces of work, in order. What a killed worker had is given to another."""
        chunks = [list(pieces[start : start + together]) for start in range(0, len(pieces), together)]
        results: dict[int, list[Any]] = {}
        for attempt in range(1, ATTEMPTS + 1):
            open_chunks = [place for place in range(len(chunks)) if place not in results]
            futures: dict[int, concurrent.futures.Future[list[Any]]] = {}
            try:
                for place in open_chunks:
                    futures[place] = self._executor.submit(_work, self._token, self._made_by, chunks[place])
                for place, future in futures.items():
                    results[place] = future.result()
            except BrokenProcessPool as error:
                _collect(futures, results)
                if not self._own or attempt == ATTEMPTS:
                    raise TrainingError(
                        f"a worker was killed, {attempt} times in the same generation; the run is saved and can be resumed"
                    ) from error
                self._executor.shutdown(wait=False, cancel_futures=True)
                self._executor = self._pool()
                continue
            except BaseException:
                for future in futures.values():
                    future.cancel()
                raise
            break
        return [result for place in range(len(chunks)) for result in results[place]]

    def close(self) -> None:
        if self._own:
            self._executor.shutdown(wait=True, cancel_futures=True)


class Bench:
    """A run on a thread of its own, which waits for what is told about its episodes."""

    def __init__(self, field: Space | Samples | str, settings: dict[str, Any]) -> None:
        self._events: queue.SimpleQueue[tuple[str, Any]] = queue.SimpleQueue()
        self._replies: queue.SimpleQueue[Any] = queue.SimpleQueue()
        self._thread = threading.Thread(target=self._run, args=(field, settings), daemon=True)
        self._thread.start()

    def _run(self, field: Space | Samples | str, settings: dict[str, Any]) -> None:
        calls = [functools.partial(self._ask, kind) for kind in ("evaluate", "play", "progress")]
        error = None
        try:
            evolve(field, settings, *calls)
        except BaseException as raised:
            error = raised
        self._events.put(("end", error))

    def _ask(self, kind: str, *says: Any) -> Any:
        self._events.put((kind, says))
        reply = self._replies.get()
        if reply is None:
            raise TrainingError("the run was stopped")
        return reply

    def next(self) -> tuple[str, Any]:
        """Waits for the next event: `evaluate`, `play` or `progress` with what the run says, or `end` with its error."""
        return self._events.get()

    def reply(self, reply: Any) -> None:
        """Replies to the last event."""
        self._replies.put(reply)

    def close(self) -> None:
        """Ends the run, which saves itself as it was after its last complete generation, and waits for that."""
        self._replies.put(None)
        self._thread.join()


def _collect(futures: dict[int, concurrent.futures.Future[list[Any]]], results: dict[int, list[Any]]) -> None:
    """Keeps what was finished before the pool broke."""
    for place, future in futures.items():
        if place not in results and future.done() and not future.cancelled() and future.exception() is None:
            results[place] = future.result()


def _size_of(executor: concurrent.futures.Executor | None) -> int:
    """Returns the number of an executor's workers, or a usual one where it does not say."""
    for name in ("_max_workers", "_num_workers"):
        size = getattr(executor, name, None)
        if isinstance(size, int) and size > 0:
            return size
    return USUAL_WORKERS


def first_difference(env: Environment, seeds: tuple[int, int] = (11, 12), steps: int = 50) -> str | None:
    """Returns what differs when an episode is begun again with the same seed; None if nothing does."""
    first, other = seeds
    before = _trace(env, first, steps)
    _trace(env, other, steps)
    after = _trace(env, first, steps)
    for step, (one, two) in enumerate(zip(before, after, strict=False)):
        for name, left, right in zip(("observation", "reward", "end"), one, two, strict=False):
            if left != right:
                return f"the {name} after {step} actions"
    return None if len(before) == len(after) else "the length of the episode"


def _trace(env: Environment, seed: int, steps: int) -> list[list[bytes]]:
    """Returns what an environment tells under random actions that depend only on the seed, as bytes: NaN is equal to itself."""
    observation, _ = env.reset(seed=seed)
    env.action_space.seed(seed)
    told = [[cloudpickle.dumps(observation)]]
    for _ in range(steps):
        # What is wrong with a step is said when it is trained on.
        *parts, _ = env.step(env.action_space.sample())
        told.append([cloudpickle.dumps(part) for part in parts])
        if any(parts[2:]):
            break
    return told
