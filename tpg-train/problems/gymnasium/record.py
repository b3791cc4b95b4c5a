"""Records episodes of Gymnasium's classic control: the vectors that this project's own problems are compared with.

    python3 -m venv venv && venv/bin/pip install 'gymnasium==1.2.3' 'numpy==2.4.6'
    venv/bin/python record.py                             # writes the committed PROBLEM.csv.gz beside this file
    venv/bin/python record.py cartpole --episodes 10000   # writes one problem's rows to standard output

A row is a state: `action,reward,ended,state...,observation...`. The first row of an episode has no action and no reward;
`ended` is 0, 1 for terminated, 2 for truncated. States are Gymnasium's own numbers, so a step can be compared from the
same state; every number is written so that it can be read back exactly.
"""

import argparse
import gzip
import math
import pathlib
import random
import sys

import gymnasium
import numpy

# Problem: Gymnasium's name, and the episodes that are committed.
PROBLEMS = {
    "cartpole": ("CartPole-v1", 5),
    "acrobot": ("Acrobot-v1", 5),
    "mountain-car": ("MountainCar-v0", 8),
    "pendulum": ("Pendulum-v1", 6),
    "mountain-car-continuous": ("MountainCarContinuous-v0", 5),
}


def action(problem, state, skill, chance):
    """Returns an action: with probability `skill` one that leads far, otherwise a random one."""
    if chance.random() >= skill:
        if problem == "pendulum":
            return numpy.array([chance.uniform(-2.5, 2.5)], dtype=numpy.float32)
        if problem == "mountain-car-continuous":
            return numpy.array([chance.uniform(-1.0, 1.0)], dtype=numpy.float32)
        return chance.randrange(2 if problem == "cartpole" else 3)
    if problem == "cartpole":
        return int(state[2] + 0.5 * state[3] + 0.1 * state[1] > 0)
    if problem == "acrobot":
        return 2 if state[3] > 0 else 0
    if problem == "mountain-car":
        return 2 if state[1] > 0 else 0
    if problem == "pendulum":
        return numpy.array([math.copysign(2.0, state[1])], dtype=numpy.float32)
    return numpy.array([0.9 if state[1] > 0 else -0.9], dtype=numpy.float32)


def numbers(values):
    return [repr(float(value)) for value in values]


def rows(problem, episodes):
    """Yields the rows of so many episodes."""
    env = gymnasium.make(PROBLEMS[problem][0])
    # Beyond the box of actions the environment clips by itself.
    bare = env.unwrapped
    for seed in range(episodes):
        chance = random.Random(seed)
        skill = chance.choice([0.0, 0.5, 0.9, 0.98])
        observation, _ = env.reset(seed=seed)
        yield ["", "", "0", *numbers(bare.state), *numbers(observation)]
        ended = 0
        while not ended:
            act = action(problem, bare.state, skill, chance)
            observation, reward, terminated, truncated, _ = env.step(act)
            ended = 1 if terminated else 2 if truncated else 0
            written = str(act) if isinstance(act, int) else repr(float(act[0]))
            yield [written, repr(float(reward)), str(ended), *numbers(bare.state), *numbers(observation)]


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("problem", nargs="?", choices=PROBLEMS)
    parser.add_argument("--episodes", type=int, default=10_000)
    arguments = parser.parse_args()
    if arguments.problem:
        for row in rows(arguments.problem, arguments.episodes):
            sys.stdout.write(",".join(row) + "\n")
        return
    for problem, (_, episodes) in PROBLEMS.items():
        text = "".join(",".join(row) + "\n" for row in rows(problem, episodes))
        path = pathlib.Path(__file__).parent / f"{problem}.csv.gz"
        # No time and no name in the header: the same bytes each time.
        path.write_bytes(gzip.compress(text.encode(), compresslevel=9, mtime=0))


if __name__ == "__main__":
    main()
