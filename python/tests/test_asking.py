"""A network beside a graph: asked at a price, called by rules, or by draws."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import environments
import gymnasium
import numpy as np
import pytest
from gymnasium import spaces

import tpg_train
from tpg_train import TPG, Asking, InputError, NetworkPolicy, train_network

# Episodes of 50 steps: what `tpg-train config --sac general` prints.
SMALL: dict[str, Any] = {
    "learning.random_decisions": 200,
    "learning.decision_lasts": 1,
    "learning.measured_inputs": False,
    "learning.discount": 0.99,
    "learning.exploring_entropy": -1.0,
    "validation.every": 500,
    "validation.episodes": 5,
}


class Motor(environments.Cart):
    """The cart by a force of −0.2 to 0.2, drawn to where it starts."""

    observation_space = spaces.Box(-9, 9, (2,), np.float32)
    action_space = spaces.Box(-0.2, 0.2, (1,), np.float32)

    def push(self, action: Any) -> float:
        return float(action[0])


class Broken(Motor):
    """Fails in its 300th step."""

    count = 0

    def push(self, action: Any) -> float:
        Broken.count += 1
        if Broken.count == 300:
            raise RuntimeError("the belt is torn")
        return float(action[0])


@pytest.fixture(scope="module")
def network() -> NetworkPolicy:
    return train_network(Motor, 4000, seed=1, hidden=(8, 8), settings=SMALL)


def test_a_network_is_trained_the_same_again_and_helps(network: NetworkPolicy, tmp_path: Path) -> None:
    again = train_network(Motor, 4000, seed=1, hidden=(8, 8), settings=SMALL)
    network.save(tmp_path / "one.json")
    again.save(tmp_path / "two.json")
    assert (tmp_path / "one.json").read_bytes() == (tmp_path / "two.json").read_bytes()
    other = train_network(Motor, 4000, seed=2, hidden=(8, 8), settings=SMALL)
    other.save(tmp_path / "two.json")
    assert (tmp_path / "one.json").read_bytes() != (tmp_path / "two.json").read_bytes()
    rest = np.mean([_rest(seed) for seed in range(20)])
    assert network.evaluate(Motor(), 20).mean > rest + 20, "better than doing nothing"
    assert abs(network.agreement["validation_score"]) < abs(rest)


def _rest(seed: int) -> float:
    env = Motor()
    env.reset(seed=seed)
    return sum(env.step(np.zeros(1, np.float32))[1] for _ in range(50))


def test_an_error_of_the_environment_arrives_as_itself() -> None:
    with pytest.raises(RuntimeError, match="the belt is torn"):
        train_network(Broken, 2000, hidden=(8, 8), settings=SMALL)
    with pytest.raises(InputError, match="Discrete.*accepted: a Box"):
        train_network(environments.Cart, 100)
    with pytest.raises(InputError, match=r"the setting learning.decision: unknown field"):
        train_network(Motor, 100, settings={"learning.decision": 3})


def test_an_ask_is_the_networks_action_at_a_price(network: NetworkPolicy) -> None:
    asking, plain = Asking(Motor(), network, price=0.5), Motor()
    assert isinstance(asking.action_space, spaces.Discrete) and asking.action_space.n == 4
    seen, _ = asking.reset(seed=3)
    bare, _ = plain.reset(seed=3)
    assert seen.tolist() == bare.tolist()
    for action in [0, 3, 3, 1, 2, 3]:
        own = network.predict(bare)[0] if action == 3 else np.array([[-0.2], [0.0], [0.2]][action], np.float32)
        seen, reward, *_ = asking.step(action)
        bare, wanted, *_ = plain.step(own)
        assert seen.tolist() == bare.tolist() and reward == wanted - (0.5 if action == 3 else 0.0)
    assert (asking.asks, asking.network_actions, asking.actions, asking.episodes) == (3, 3, 6, 1)


def test_rules_call_the_network_and_hand_back(network: NetworkPolicy) -> None:
    env = Asking(Motor(), network, levels=None, patience=3, hand_back_after=2)
    assert env.action_space is Motor.action_space and not env.asks_network
    env.reset(seed=1)
    env.env.unwrapped.x, env.env.unwrapped.v = 1.0, 1.0  # it flies away: no progress after the first step
    turns = []
    for _ in range(10):
        turns.append(env.network_actions)
        env.step(np.zeros(1, np.float32))
    # The first distance is a new least one; after three more the network has two actions, and progress counts anew.
    assert turns == [0, 0, 0, 0, 0, 1, 2, 2, 2, 2]
    assert env.asks == 0


def test_a_graph_learns_to_ask_and_says_so(network: NetworkPolicy, tmp_path: Path) -> None:
    network.save(tmp_path / "policy.q.json")
    make = lambda: Asking(Motor(), tmp_path / "policy.q.json", price=0.01)  # noqa: E731
    model = TPG(make, population=20, episodes=3, settings={"selection.validation_episodes": 8})
    model.learn(20_000)
    model.save(tmp_path / "graph.json")
    actions = json.loads((tmp_path / "graph.json").read_text())["actions"]
    assert [action.get("ask") for action in actions] == [None, None, None, "network"]
    free = Asking(Motor(), network)
    result = TPG.load(tmp_path / "graph.json", free).evaluate(20)
    assert free.episodes == 20 and 0 <= free.asks <= free.actions == 1000 and result.mean_steps == 50


def test_bad_arguments_are_refused(network: NetworkPolicy) -> None:
    for wrong, says in [
        ({"price": -1.0}, "a price of -1.0; accepted: 0 or more"),
        ({"levels": 1}, "1 levels of 1 values"),
        ({"patience": 0}, "patience 0"),
        ({"separation": -1.0}, "separation -1"),
    ]:
        with pytest.raises(InputError, match=says):
            Asking(Motor(), network, **wrong)
    assert "Asking" in tpg_train.__all__ and issubclass(Asking, gymnasium.Wrapper)
