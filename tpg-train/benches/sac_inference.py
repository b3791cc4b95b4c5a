"""Time of one inference of an actor in PyTorch, batch 1, one thread; called by the bench sac_inference."""

import statistics
import time

import torch
from torch import nn

torch.set_num_threads(1)
torch.manual_seed(0)
ROUNDS, REPEATS = 25, 2000


def nanoseconds(network, observation):
    rounds = []
    with torch.inference_mode():
        for _ in range(REPEATS):  # TorchScript optimises what it has seen a few times
            network(observation)
        for _ in range(ROUNDS):
            began = time.perf_counter()
            for _ in range(REPEATS):
                network(observation)
            rounds.append((time.perf_counter() - began) * 1e9 / REPEATS)
    return statistics.median(rounds)


for inputs, units in [(13, 256), (38, 256), (38, 64), (38, 16)]:
    network = nn.Sequential(
        nn.Linear(inputs, units), nn.ReLU(), nn.Linear(units, units), nn.ReLU(), nn.Linear(units, 4)
    ).eval()
    observation = torch.randn(1, inputs)
    script = torch.jit.freeze(torch.jit.trace(network, observation))
    print(
        "PyTorch %s, f32, %d-%d-%d-4: eager %.0f, TorchScript %.0f"
        % (torch.__version__, inputs, units, units, nanoseconds(network, observation), nanoseconds(script, observation)),
        flush=True,
    )
