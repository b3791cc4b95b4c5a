"""Workers: the same bytes for any number of them and any executor; nothing is lost with one that is killed."""

from __future__ import annotations

import concurrent.futures
import functools
import subprocess
import sys
from pathlib import Path
from typing import Any

import environments
import gymnasium
import pytest
import tools

from tpg_train import TPG, InputError, TrainingError

ARGUMENTS: dict[str, Any] = {"population": 24, "episodes": 3, "settings": {"selection.validation_episodes": 8}}
STEPS = 15_000


def learned(**arguments: Any) -> str:
    return TPG(environments.Cart, **ARGUMENTS).learn(STEPS, **arguments).graph.sha256


@pytest.fixture(scope="module")
def alone() -> str:
    return learned()


@pytest.mark.parametrize("n_workers", [1, 2, 4])
def test_the_number_of_processes_does_not_matter(alone: str, n_workers: int) -> None:
    assert learned(n_workers=n_workers) == alone


def test_a_random_search_is_the_same_in_processes() -> None:
    settings = {"start.random": 0.5, "start.share": 0.5, "selection.validation_episodes": 8}
    runs = [TPG(environments.Cart, settings=settings).learn(30_000, n_workers=workers) for workers in (0, 1, 3)]
    assert len({run.graph.sha256 for run in runs}) == 1
    assert len({run.num_timesteps for run in runs}) == 1


def test_an_executor_of_ones_own_does_the_work(alone: str) -> None:
    used = 0

    class Counting(concurrent.futures.ThreadPoolExecutor):
        def submit(self, *arguments: Any, **named: Any) -> Any:
            nonlocal used
            used += 1
            return super().submit(*arguments, **named)

    with Counting(3) as executor:
        assert learned(executor=executor) == alone
        assert used > 10
        assert executor.submit(int, "3").result() == 3, "it stays open"


def test_dask(alone: str) -> None:
    distributed = tools.module("distributed")
    with distributed.LocalCluster(n_workers=2, threads_per_worker=1, dashboard_address=None) as cluster:
        with distributed.Client(cluster) as client:
            assert learned(executor=client.get_executor()) == alone


def test_mpi(alone: str, tmp_path: Path) -> None:
    tools.module("mpi4py")
    mpirun = tools.program("mpirun")
    script = tmp_path / "train.py"
    script.write_text(
        f"""
import sys
sys.path.insert(0, {str(Path(__file__).parent)!r})
import conftest, environments
from mpi4py.futures import MPIPoolExecutor
from tpg_train import TPG

if __name__ == "__main__":
    with MPIPoolExecutor() as executor:
        print(TPG(environments.Cart, **{ARGUMENTS!r}).learn({STEPS}, executor=executor).graph.sha256)
"""
    )
    command = [
        mpirun,
        "--allow-run-as-root",
        "--oversubscribe",
        "-n",
        "3",
        sys.executable,
        "-m",
        "mpi4py.futures",
        str(script),
    ]
    done = subprocess.run(command, capture_output=True, text=True, timeout=300)
    assert done.stdout.strip() == alone, done.stderr


def killed(marker: str) -> gymnasium.Env[Any, Any]:
    env = environments.Killed()
    env.marker = marker
    return env


def test_a_killed_worker_loses_nothing(alone: str, tmp_path: Path) -> None:
    marker = tmp_path / "killed"
    model = TPG(functools.partial(killed, str(marker)), **ARGUMENTS)
    model._checked = True  # its own steps would kill this process
    assert model.learn(STEPS, n_workers=2).graph.sha256 == alone
    assert marker.exists(), "no worker was killed"


def test_a_killed_dask_worker_loses_nothing(alone: str, tmp_path: Path) -> None:
    distributed = tools.module("distributed")
    marker = tmp_path / "killed"
    model = TPG(functools.partial(killed, str(marker)), **ARGUMENTS)
    model._checked = True  # its own steps would kill this process
    with distributed.LocalCluster(n_workers=2, threads_per_worker=1, dashboard_address=None) as cluster:
        with distributed.Client(cluster) as client:
            assert model.learn(STEPS, executor=client.get_executor()).graph.sha256 == alone
    assert marker.exists(), "no worker was killed"


def test_workers_that_are_always_killed_end_the_run_with_an_error() -> None:
    model = TPG(environments.AlwaysKilled, **ARGUMENTS)
    model._checked = True
    with pytest.raises(TrainingError, match="a worker was killed, 3 times"):
        model.learn(STEPS, n_workers=1)
    mine = concurrent.futures.ProcessPoolExecutor(1)
    with pytest.raises(TrainingError, match="a worker was killed, 1 times"):
        model.learn(STEPS, executor=mine)


def test_an_environment_that_cannot_be_sent_is_refused() -> None:
    env = environments.Cart()
    env.lock = __import__("threading").Lock()  # type: ignore[attr-defined]
    model = TPG(env, **ARGUMENTS)
    with pytest.raises(InputError, match="cannot be sent to workers"):
        model.learn(10, n_workers=2)
    env = environments.Cart()
    assert TPG(env, **ARGUMENTS).learn(STEPS, n_workers=1).graph.sha256 == learned()


def test_evaluation_is_the_same_anywhere() -> None:
    model = TPG(environments.Cart, **ARGUMENTS).learn(STEPS)
    assert model.evaluate(30) == model.evaluate(30, n_workers=2)
    assert model.evaluate(30) != model.evaluate(30, seed=2)
