"""CPU milliseconds of one whole update of a soft actor-critic in PyTorch on one thread: sac_update.py ACTOR CRITIC.

Called by the bench networks."""

import sys
import time

import torch
from torch import nn

torch.set_num_threads(1)
torch.manual_seed(0)
INPUTS, ACTIONS, BATCH, UPDATES = 38, 4, 256, 150


def network(inputs, width, outputs):
    return nn.Sequential(
        nn.Linear(inputs, width), nn.ReLU(), nn.Linear(width, width), nn.ReLU(), nn.Linear(width, outputs)
    )


def measure(actor_width, critic_width):
    actor = network(INPUTS, actor_width, 2 * ACTIONS)
    critics = [network(INPUTS + ACTIONS, critic_width, 1) for _ in range(2)]
    slow = [network(INPUTS + ACTIONS, critic_width, 1) for _ in range(2)]
    log_alpha = torch.tensor([-3.0], requires_grad=True)
    actor_adam = torch.optim.Adam(actor.parameters(), lr=5e-4)
    critic_adam = torch.optim.Adam([p for c in critics for p in c.parameters()], lr=5e-4)
    alpha_adam = torch.optim.Adam([log_alpha], lr=1.5e-3)
    states, following = torch.randn(BATCH, INPUTS), torch.randn(BATCH, INPUTS)
    actions, rewards = torch.tanh(torch.randn(BATCH, ACTIONS)), torch.randn(BATCH)
    discounts = torch.full((BATCH,), 0.95)
    parameters = [p for s in slow for p in s.parameters()], [p for c in critics for p in c.parameters()]

    def act(x):
        mean, log_std = actor(x).chunk(2, dim=1)
        log_std = log_std.clamp(-5, 2)
        noise = torch.randn_like(mean)
        u = mean + log_std.exp() * noise
        density = -0.5 * noise * noise - log_std - 0.9189385 - 2 * (0.6931472 - u - nn.functional.softplus(-2 * u))
        return torch.tanh(u), density.sum(1)

    def judge(nets, x, a):
        joined = torch.cat([x, a], 1)
        return [net(joined).squeeze(1) for net in nets]

    def update():
        alpha = log_alpha.exp().detach()
        with torch.no_grad():
            next_actions, density = act(following)
            wanted = rewards + discounts * (torch.min(*judge(slow, following, next_actions)) - alpha * density)
        loss = sum(nn.functional.mse_loss(q, wanted) for q in judge(critics, states, actions))
        critic_adam.zero_grad(set_to_none=True)
        loss.backward()
        critic_adam.step()
        own, density = act(states)
        for p in parameters[1]:
            p.requires_grad_(False)
        loss = (alpha * density - torch.min(*judge(critics, states, own))).mean()
        actor_adam.zero_grad(set_to_none=True)
        loss.backward()
        actor_adam.step()
        for p in parameters[1]:
            p.requires_grad_(True)
        loss = -(log_alpha * (density.detach() - 1.0)).mean()
        alpha_adam.zero_grad(set_to_none=True)
        loss.backward()
        alpha_adam.step()
        with torch.no_grad():
            torch._foreach_lerp_(*parameters, 0.005)

    for _ in range(UPDATES // 10):
        update()
    began = time.process_time()
    for _ in range(UPDATES):
        update()
    return (time.process_time() - began) * 1e3 / UPDATES


if __name__ == "__main__":
    print(measure(int(sys.argv[1]), int(sys.argv[2])))
