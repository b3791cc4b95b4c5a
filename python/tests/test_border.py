"""What crosses the border between Python and the trainer: observations, flags, success, names, arguments."""

from __future__ import annotations

import copy
import gc
import itertools
import json
import pickle
import warnings
from pathlib import Path
from typing import Any

import environments
import gymnasium
import numpy as np
import pytest
from gymnasium import spaces
from gymnasium.envs.registration import EnvSpec

from tpg_train import TPG, InputError
from tpg_train._tpg import Policy, success_of
from tpg_train.spaces import Interface
from tpg_train.wrappers import Differences

SMALL: dict[str, Any] = {"population": 12, "episodes": 2, "settings": {"selection.validation_episodes": 4}}


def layouts(values: np.ndarray[Any, Any]) -> list[Any]:
    """Returns the same array in every memory layout, and as lists."""
    wide = np.zeros((*values.shape[:-1], 2 * values.shape[-1]), values.dtype)
    wide[..., ::2] = values
    locked = values.copy()
    locked.setflags(write=False)
    backwards = np.ascontiguousarray(values[::-1])[::-1]
    return [values, np.asfortranarray(values), wide[..., ::2], locked, backwards, values.tolist()]


class Told(gymnasium.Env[Any, Any]):
    """Tells one observation, whatever happens."""

    action_space = spaces.Discrete(2)

    def __init__(self, observation: Any, shape: tuple[int, ...]) -> None:
        self.observation = observation
        self.observation_space = spaces.Box(-1e9, 1e9, shape, np.float64)

    def reset(self, *, seed: int | None = None, options: dict[str, Any] | None = None) -> tuple[Any, dict[str, Any]]:
        super().reset(seed=seed)
        return self.observation, {}

    def step(self, action: Any) -> tuple[Any, float, bool, bool, dict[str, Any]]:
        return self.observation, 0.0, False, True, {}


@pytest.mark.parametrize("shape", [(), (1,), (5,), (2, 3), (3, 1)])
@pytest.mark.parametrize("dtype", [np.float32, np.float64, np.float16, np.int64, np.uint8, ">f4"])
def test_training_and_predict_read_the_same_values_of_any_layout_and_type(shape: tuple[int, ...], dtype: Any) -> None:
    values = np.arange(1, 1 + int(np.prod(shape))).reshape(shape).astype(dtype)
    policy = Policy.of(TPG(Told(values, shape), **SMALL).learn(10).graph._graph)
    for observation in layouts(values) if shape else [values, values[()], values.tolist()]:
        interface = Interface.of(Told(observation, shape))
        trained = interface.driver(Told(observation, shape)).play(policy, 1, [0])[2][0]
        predicted, is_batch = interface.states(observation)
        assert trained == predicted[0].tolist() == values.ravel().astype(float).tolist() and not is_batch
        batch, is_batch = interface.states(np.stack([np.asarray(observation)] * 3))
        assert batch.tolist() == [trained] * 3 and is_batch


def test_a_transposed_observation_gets_the_return_that_it_was_trained_for() -> None:
    class Arm(environments.Cart):
        observation_space = spaces.Box(-5, 5, (2, 3), np.float32)

        def observe(self) -> Any:
            return np.array([[self.x, 1.0], [self.v, 2.0], [0.5, 3.0]], np.float32).T

    model = TPG(Arm, **SMALL).learn(3000)
    env, total = Arm(), 0.0
    for place in range(5):
        observation, _ = env.reset(seed=int(place))
        done = False
        while not done:
            observation, reward, _, done, _ = env.step(model.predict(observation)[0])
            total += reward
    played = Interface.of(env).driver(env).run(Policy.of(model.graph._graph), list(range(5)))
    assert total == pytest.approx(sum(score for score, *_ in played))


def test_an_observation_of_another_shape_is_refused_in_training_as_in_predict() -> None:
    env = Told(np.zeros(2, np.float32), (1, 2))
    with pytest.raises(InputError, match=r"seed \d+, step 0: an observation of shape \[2\]; accepted: \[1, 2\]"):
        TPG(env, **SMALL).learn(10)
    with pytest.raises(InputError, match=r"shape \(2,\); accepted: \(1, 2\)"):
        Interface.of(env).states(env.observation)


@pytest.mark.parametrize("value", [True, np.bool_(True), 1, 1.0, np.float32(1), np.array(True), np.array([1.0])])
@pytest.mark.parametrize("key", ["is_success", "success"])
def test_success_and_flags_are_read_by_their_truth(value: Any, key: str) -> None:
    class Cart(environments.Cart):
        def step(self, action: Any) -> Any:
            observation, reward, _, end, _ = super().step(action)
            kind = type(value) if not isinstance(value, np.ndarray) else lambda flag: np.full(value.shape, flag)
            return observation, reward, kind(False), kind(end), {key: value}

    assert TPG(Cart, **SMALL).learn(300).evaluate(3).success_rate == 1.0


def test_what_is_neither_true_nor_false_is_refused_with_seed_and_step() -> None:
    class Cart(environments.Cart):
        def step(self, action: Any) -> Any:
            observation, reward, _, end, info = super().step(action)
            return observation, reward, None, end, info

    with pytest.raises(InputError, match=r"seed \d+, step 1: terminated is None; accepted: true or false"):
        TPG(Cart, **SMALL).learn(300)
    with pytest.raises(InputError, match="is_success is .*; accepted: true or false"):
        success_of({"is_success": np.array([True, False])})
    assert success_of({}) is None and success_of({"is_success": None}) is None
    assert success_of({"success": 0.0}) is False and success_of({"is_success": True, "success": False}) is True


def test_a_reward_of_infinity_is_refused() -> None:
    class Cart(environments.Cart):
        def step(self, action: Any) -> Any:
            observation, _, stop, end, info = super().step(action)
            return observation, np.inf, stop, end, info

    with pytest.raises(InputError, match="step 1: a reward of inf; accepted: a number"):
        TPG(Cart, **SMALL).learn(300)


def test_an_environment_that_was_changed_is_used_as_it_is() -> None:
    env = gymnasium.make("CartPole-v1")
    env.unwrapped.force_mag = 0.0  # type: ignore[attr-defined]
    assert TPG(env).native is None and TPG(lambda: gymnasium.make("CartPole-v1")).native is None
    assert TPG("CartPole-v1").native == "cartpole" and TPG("CartPole-v1", env_kwargs={"sutton_barto_reward": True}).native is None
    original = gymnasium.registry["CartPole-v1"]
    try:
        for change in ({"max_episode_steps": 90}, {"entry_point": environments.Cart}, {"kwargs": {"sutton_barto_reward": True}}):
            del gymnasium.registry["CartPole-v1"]
            gymnasium.register(**{"id": "CartPole-v1", "entry_point": original.entry_point, "max_episode_steps": 500, **change})
            assert TPG("CartPole-v1").native is None, change
    finally:
        gymnasium.registry["CartPole-v1"] = original


@pytest.mark.parametrize("env", ["CartPole-v1", "gymnasium:CartPole-v1", gymnasium.spec("CartPole-v1")])
def test_what_make_takes_is_an_environment(env: Any) -> None:
    assert TPG(env).env.spec.id == "CartPole-v1"  # type: ignore[union-attr]


def test_arguments_are_refused_by_their_names() -> None:
    for arguments, message in (
        ({"seed": -1}, r"seed = -1; accepted: a whole number from 0"),
        ({"population": 0}, "population = 0; accepted: a whole number from 2"),
        ({"episodes": 0.5}, "episodes = 0.5; accepted: a whole number from 1"),
        ({"n_workers": -1}, "n_workers = -1"),
        ({"max_episode_steps": "many"}, "max_episode_steps = 'many'"),
    ):
        with pytest.raises(InputError, match=message):
            TPG(environments.Cart, **arguments)
    for steps in (-5, 0, 1.5, float("nan"), float("inf"), None):
        with pytest.raises(InputError, match="total_timesteps = .*; accepted: a whole number from 1"):
            TPG(environments.Cart, **SMALL).learn(steps)  # type: ignore[arg-type]
    with pytest.raises(InputError, match="NoSuch"):
        TPG("NoSuch-v0")
    with pytest.raises(InputError, match="make_vec"):
        TPG(gymnasium.make_vec("CartPole-v1", 2))  # type: ignore[arg-type]
    with pytest.raises(InputError, match="NormalizeObservation"):
        TPG(lambda: gymnasium.wrappers.NormalizeObservation(environments.Cart()))
    with pytest.raises(InputError, match="env_kwargs with an environment"):
        TPG(environments.Cart(), env_kwargs={"a": 1})
    assert TPG(environments.Cart, seed=None).seed != TPG(environments.Cart, seed=None).seed
    assert TPG(environments.Cart, **SMALL).learn(1e2).num_timesteps >= 100
    assert TPG(environments.Cart, **SMALL).learn(100).predict(np.zeros((0, 2), np.float32))[0].shape == (0,)


def test_names_that_fall_together_are_numbered() -> None:
    def names(*given: str) -> list[str]:
        interface = Interface.of(Told(np.zeros(len(given)), (len(given),)), input_names=given)
        return [name for name, _ in interface.sources()]

    assert names("θ", "ω") == ["theta", "omega"]
    assert names("Theta", "theta", "x_2", "x", "x") == ["theta", "theta_2", "x_2", "x", "x_3"]
    space = spaces.Dict({"pos x": spaces.Box(-1, 1, (1,)), "pos_x": spaces.Box(-1, 1, (2,))})
    env = Told({"pos x": np.zeros(1), "pos_x": np.zeros(2)}, ())
    env.observation_space = space
    assert [name for name, _ in Interface.of(env).sources()] == ["pos_x", "pos_x_2"]
    many = Told(np.zeros(61), (61,))
    with pytest.warns(UserWarning, match="61 input_names: a graph has at most 60 named sources"):
        Interface.of(many, input_names=[f"s{place}" for place in range(61)])


def test_a_value_whose_bounds_are_equal_is_no_output(tmp_path: Path) -> None:
    class Cart(environments.Cart):
        action_space = spaces.Box(np.array([0.5, -0.1], np.float32), np.array([0.5, 0.1], np.float32))

        def push(self, action: Any) -> float:
            assert action.shape == (2,) and action.dtype == np.float32 and action[0] == 0.5
            return float(action[1])

    model = TPG(Cart, **SMALL).learn(500)
    assert [name for name, _, _ in model.graph.outputs] == ["action_1"]
    action, _ = model.predict(np.array([1.0, 0.0], np.float32))
    assert action.shape == (2,) and action[0] == np.float32(0.5)
    model.save(tmp_path / "graph.json")
    assert (TPG.load(tmp_path / "graph.json", Cart).predict(np.array([1.0, 0.0], np.float32))[0] == action).all()


def test_a_loaded_graph_fits_the_names_and_bounds_of_its_environment(tmp_path: Path) -> None:
    class Bounded(environments.Cart):
        observation_space = spaces.Box(-9, 9, (2,), np.float32)

    class Wider(environments.Cart):
        observation_space = spaces.Box(-9, 10, (2,), np.float32)

    path = tmp_path / "graph.json"
    TPG(Bounded, input_names=["x", "v"], **SMALL).learn(200).save(path)
    assert TPG.load(path, Bounded).has_graph and TPG.load(path, Bounded, input_names=["x", "v"]).has_graph
    with pytest.raises(InputError, match=r"the inputs x\[0\], v\[0\]; accepted: v\[0\], x\[0\]"):
        TPG.load(path, Bounded, input_names=["v", "x"])
    with pytest.raises(InputError, match="from -9.0 to 9.0; accepted: -9.0 to 10.0"):
        TPG.load(path, Wider)
    with pytest.raises(InputError, match="a graph of 2 inputs; accepted: 3"):
        TPG.load(path, environments.TupleCart)


def test_a_model_is_copied_and_pickled_with_its_run() -> None:
    model = TPG(environments.Cart, **SMALL).learn(300)
    state = np.array([0.5, -0.5], np.float32)
    for other in (copy.deepcopy(model), pickle.loads(pickle.dumps(model))):
        assert other.graph.sha256 == model.graph.sha256 and other.predict(state)[0] == model.predict(state)[0]
        assert other.folder != model.folder and other.num_timesteps == model.num_timesteps
        steps = other.learn(300).num_timesteps
        assert steps > model.num_timesteps
    assert model.learn(300).graph.sha256 == other.graph.sha256 and model.num_timesteps == steps
    assert len(list(itertools.islice(model.folder.iterdir(), 1))) == 1


def test_a_budget_is_kept_but_for_an_episode_of_each_policy() -> None:
    class Endless(environments.Cart):
        def step(self, action: Any) -> Any:
            observation, reward, _, _, info = super().step(action)
            return observation, reward, False, False, info

    arguments = {**SMALL, "episodes": 10}
    model = TPG(Endless, max_episode_steps=100, **arguments).learn(4_000)
    # Twelve roots, at first twice as many; half of what was asked for; and a validation of as much.
    assert 4_000 <= model.num_timesteps <= 12_000
    with pytest.warns(UserWarning, match=r"learn\(500\) made \d+ steps: .*max_episode_steps= makes them shorter"):
        TPG(Endless, max_episode_steps=500, **arguments).learn(500)


def test_what_a_model_made_is_closed_with_it() -> None:
    closed: list[str] = []

    class Cart(environments.Cart):
        def close(self) -> None:
            closed.append("")

    with warnings.catch_warnings():
        warnings.simplefilter("error", ResourceWarning)
        with TPG(Cart, **SMALL) as model:
            folder = model.learn(100).folder
            assert folder.exists()
        assert not folder.exists() and len(closed) == 1
        model = TPG(Cart, **SMALL).learn(100)
        folder = model.folder
        del model
        gc.collect()
        assert not folder.exists() and len(closed) == 2
        TPG(Cart(), **SMALL).close()
        assert len(closed) == 2, "an environment object is its maker's"


def test_a_file_of_settings_is_a_preset(tmp_path: Path) -> None:
    own = tmp_path / "own.toml"
    own.write_text("[tpg]\nnb_roots = 14\n")
    assert "nb_roots = 14" in TPG(environments.Cart, preset=own)._config
    params = tmp_path / "params.json"
    params.write_text('{ // GEGELATI\n"mutation": {"tpg": {"nbRoots": 37}}}')
    config = TPG(environments.Cart, preset=str(params))._config
    assert "nb_roots = 37" in config and "max_program_size = 96" in config
    own.write_text("[tpg]\nnb_rots = 14\n")
    with pytest.raises(InputError, match=r"own.toml: line 2: unknown field `nb_rots`"):
        TPG(environments.Cart, preset=own)
    with pytest.raises(InputError, match='the preset "slow"; accepted: .*, or a file'):
        TPG(environments.Cart, preset="slow")


def test_python_speaks_of_its_own_arguments(tmp_path: Path) -> None:
    TPG(environments.Cart, folder=tmp_path / "run", **SMALL).learn(100)
    with pytest.raises(InputError, match="another folder, or resume=True"):
        TPG(environments.Cart, folder=tmp_path / "run", **SMALL).learn(100)


def test_differences_of_a_dict_keep_its_keys() -> None:
    class Cart(environments.Cart):
        observation_space = spaces.Dict({"x": spaces.Box(-9, 9, (1,), np.float32), "v": spaces.Box(-2, 2, (1,), np.float32)})

        def observe(self) -> Any:
            return {"x": np.array([self.x], np.float32), "v": np.array([self.v], np.float32)}

    env = Differences(Cart())
    assert [name for name, _ in Interface.of(env).sources()] == ["change_v", "change_x", "now_v", "now_x"]
    first, _ = env.reset(seed=1)
    second = env.step(1)[0]
    assert first["change"]["x"] == 0 and second["change"]["v"] == second["now"]["v"] - first["now"]["v"]
    assert env.observation_space.contains(second) and TPG(env, **SMALL).learn(100).has_graph
    # A choice does not change by an amount.
    names = [name for name, _ in Interface.of(Differences(environments.DictCart())).sources()]
    assert names == ["change_cart_v", "change_cart_x", "now_cart_v", "now_cart_x", "now_side"]
    Cart.observation_space = spaces.Discrete(2)
    with pytest.raises(ValueError, match="or a Dict with one"):
        Differences(Cart())


def test_a_policy_reads_features_of_an_image(tmp_path: Path) -> None:
    model = TPG(environments.Spot, seed=1).learn(60_000)
    assert model.evaluate(100).mean > 6.0, "always the middle earns about 4.3"
    graph = model.graph
    assert set(name.split("[")[0] for name in graph.inputs) <= set(
        f"channel_{channel}_{part}" for channel in (0, 1) for part in ("bright", "dark", "grid")
    )
    env = environments.Spot()
    first, _ = env.reset(seed=5)
    images = np.stack([first, env.step(0)[0]])
    assert [model.predict(image)[0] for image in images] == model.predict(images)[0].tolist()
    assert pickle.loads(pickle.dumps(model)).predict(first)[0] == model.predict(first)[0]
    header = model.export_c(tmp_path / "c", prefix="spot")[0].read_text()
    assert "spot_look(const uint8_t *image, uint32_t stride, spot_state_t *state);" in header
    assert model.verify(states=200)
    graph.save(tmp_path / "graph.json")
    again = TPG.load(tmp_path / "graph.json", environments.Spot)
    assert again.predict(first)[0] == model.predict(first)[0]
    for wrong in (first[:, :8], first.astype(np.float32)):
        with pytest.raises(InputError, match="accepted"):
            model.predict(wrong)


def test_a_policy_with_memory_acts_in_predict_as_in_training(tmp_path: Path) -> None:
    class Cart(environments.Cart):
        """Tells its position alone."""

        observation_space = spaces.Box(-9, 9, (1,), np.float32)
        action_space = spaces.Box(-0.1, 0.1, (1,), np.float32)

        def observe(self) -> Any:
            return np.array([self.x], np.float32)

        def push(self, action: Any) -> float:
            return float(action[0])

    with pytest.raises(InputError, match="language.memory = 1; accepted: 0, for a problem without outputs"):
        TPG(environments.Cart, **{**SMALL, "settings": {"language.memory": 1}}).learn(100)
    settings = {"selection.validation_episodes": 4, "language.memory": 2}
    model = TPG(Cart, **{**SMALL, "settings": settings}).learn(3000)
    assert model.graph.memory == 2 and model.graph.inputs[1:] == ["memory0[0]", "memory1[0]"]
    env, total = Cart(), 0.0
    for seed in range(4):
        (observation, _), memory, done = env.reset(seed=seed), None, False
        while not done:
            action, memory = model.predict(observation, memory)
            observation, reward, _, done, _ = env.step(action)
            total += reward
    played = Interface.of(env).driver(env).run(Policy.of(model.graph._graph), list(range(4)))
    assert total == pytest.approx(sum(score for score, *_ in played))
    batch, memories = model.predict(np.array([[0.5], [-0.5]], np.float32), np.ones((2, 2)), episode_start=[True, False])
    assert batch[0] == model.predict(np.array([0.5], np.float32))[0] and memories.shape == (2, 2)
    model.save(tmp_path / "graph.json")
    assert (TPG.load(tmp_path / "graph.json", Cart).predict(observation)[0] == model.predict(observation)[0]).all()
    assert TPG.load(tmp_path / "graph.json").predict(observation)[0].shape == (1,)


def test_values_that_gymnasium_describes_have_names_in_graphs_only(tmp_path: Path) -> None:
    class Lander(environments.Cart):
        observation_space = spaces.Box(-1, 1, (8,), np.float32)
        action_space = spaces.Discrete(4)
        spec = EnvSpec("LunarLander-v3", max_episode_steps=20)

        def observe(self) -> Any:
            return np.array([self.x, self.v, 0, 0, 1, 0, 0, 0], np.float32)

        def push(self, action: Any) -> float:
            return 0.1 * float(action - 2)

    class Unknown(Lander):
        spec = EnvSpec("mine/LunarLander-v3", max_episode_steps=20)

    named, plain = TPG(Lander(), folder=tmp_path / "a").learn(3_000), TPG(Unknown(), folder=tmp_path / "b").learn(3_000)
    assert named.graph.inputs[:3] == ["x[0]", "y[0]", "vx[0]"] and plain.graph.inputs[7] == "obs[7]"
    assert "left_engine" in named.graph.actions and "a2" in plain.graph.actions
    states = np.random.default_rng(1).normal(size=(50, 8))
    assert (named.predict(states)[0] == plain.predict(states)[0]).all(), "the same training"
    assert json.loads((tmp_path / "a" / "graph.json").read_text())["provenance"]["note"] == "LunarLander-v3"
    assert TPG(Lander(), folder=tmp_path / "a", resume=True).learn(6_000).graph.inputs == named.graph.inputs
    plain.save(tmp_path / "plain.json")
    assert TPG.load(tmp_path / "plain.json", Lander()).graph.inputs == plain.graph.inputs
