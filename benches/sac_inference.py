"""Nanoseconds of one inference of an actor in PyTorch, batch 1, one thread: eager, then TorchScript.

sac_inference.py INPUTS UNITS; called by the bench networks."""

import statistics
import sys
import time

import torch
from torch import nn

torch.set_num_threads(1)
torch.manual_seed(0)
BURSTS, REPEATS = 401, 20


def nanoseconds(network, observation):
    bursts = []
    with torch.inference_mode():
        for _ in range(500):  # TorchScript optimises what it has seen a few times
            network(observation)
        for _ in range(BURSTS):
            began = time.perf_counter()
            for _ in range(REPEATS):
                network(observation)
            bursts.append((time.perf_counter() - began) * 1e9 / REPEATS)
    return statistics.median(bursts)


inputs, units = int(sys.argv[1]), int(sys.argv[2])
network = nn.Sequential(
    nn.Linear(inputs, units), nn.ReLU(), nn.Linear(units, units), nn.ReLU(), nn.Linear(units, 4)
).eval()
observation = torch.randn(1, inputs)
script = torch.jit.freeze(torch.jit.trace(network, observation))
print(nanoseconds(network, observation), nanoseconds(script, observation))
