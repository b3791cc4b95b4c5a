#!/usr/bin/env python3
"""Measures how busy the workers of a run keep the cores (Linux).

    python benches/control/cores.py LunarLander-v3 --steps 1000000 --workers 2

Prints, for each number of workers, the CPU time of all processes as a share of the wall time times the cores that they can
have. On a machine with other work they wait for cores that others have: the second share counts that time too, of the workers
alone, so what is missing from it is the time for which a worker had nothing to do. The graph must be the same for every number.
"""

from __future__ import annotations

import argparse
import multiprocessing
import os
import resource
import threading
import time
from pathlib import Path

from tpg_train import TPG


class Wanted:
    """The seconds for which children ran or waited for a core: sampled, because children end."""

    def __init__(self) -> None:
        self._tasks: dict[Path, float] = {}
        self._over = threading.Event()
        self._thread = threading.Thread(target=self._watch)
        self._thread.start()

    def _watch(self) -> None:
        while not self._over.wait(0.05):
            for child in multiprocessing.active_children():
                for task in Path(f"/proc/{child.pid}/task").glob("*/schedstat"):
                    try:
                        ran, waited, _ = task.read_text().split()
                    except (OSError, ValueError):
                        continue
                    self._tasks[task] = (int(ran) + int(waited)) / 1e9

    def seconds(self) -> float:
        """Ends the sampling."""
        self._over.set()
        self._thread.join()
        return sum(self._tasks.values())


def cpu() -> float:
    """Returns the CPU seconds of this process and of the children that have ended."""
    used = [resource.getrusage(who) for who in (resource.RUSAGE_SELF, resource.RUSAGE_CHILDREN)]
    return sum(one.ru_utime + one.ru_stime for one in used)


def main() -> None:
    arguments = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    arguments.add_argument("environment")
    arguments.add_argument("--steps", type=int, default=1_000_000)
    arguments.add_argument("--seed", type=int, default=1)
    arguments.add_argument("--workers", type=int, nargs="+", default=[os.cpu_count() or 1])
    given = arguments.parse_args()
    for workers in given.workers:
        load = os.getloadavg()[0]
        model = TPG(given.environment, seed=given.seed, native=False)
        wanted, before, began = Wanted(), cpu(), time.perf_counter()
        model.learn(given.steps, n_workers=workers)
        seconds = time.perf_counter() - began
        share = (cpu() - before) / (seconds * min(workers, os.cpu_count() or 1))
        busy = wanted.seconds() / (seconds * workers)
        print(
            f"{workers} workers, load {load:.1f} before: {model.num_timesteps} steps in {seconds:.1f} s, cores busy {share:.1%}, "
            f"workers busy or waiting for a core {busy:.1%}; graph {model.graph.sha256[:16]}"
        )


if __name__ == "__main__":
    main()
