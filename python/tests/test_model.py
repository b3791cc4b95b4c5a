"""The class TPG: from an environment to a graph to code."""

from __future__ import annotations

import ctypes
import json
import pickle
import subprocess
import sys
import warnings
from pathlib import Path
from typing import Any

import environments
import gymnasium
import numpy as np
import pytest
import tools
from gymnasium.wrappers import TimeLimit

import tpg_train
from tpg_train import TPG, InputError, StatefulEnvironmentWarning, TrainingError, VerificationError
from tpg_train.tuning import Loop, Tuned

SMALL: dict[str, Any] = {
    "population": 20,
    "episodes": 3,
    "settings": {"selection.validation_episodes": 8, "selection.racing_episodes": 0},
}


@pytest.fixture(scope="module")
def pole() -> TPG:
    return TPG("CartPole-v1", seed=1, native=False).learn(250_000, target=475)


@pytest.fixture(scope="module")
def swing() -> TPG:
    return TPG("Pendulum-v1", seed=1).learn(200_000)


def test_cartpole_in_real_gymnasium_is_solved(pole: TPG) -> None:
    result = pole.evaluate(50)
    assert result.environment == "CartPole-v1" and result.episodes == 50
    assert result.mean >= 475, result
    assert result.ci95[0] <= result.mean <= result.ci95[1] and result.min <= result.mean


def test_prediction_is_for_one_or_a_batch_in_any_float(pole: TPG) -> None:
    batch = np.random.default_rng(1).uniform(-0.2, 0.2, (50, 4))
    single = [pole.predict(row)[0] for row in batch.astype(np.float32)]
    assert all(isinstance(action, np.int64) and pole.action_space.contains(action) for action in single)
    for array in (
        batch.astype(np.float32),
        batch.astype(np.float32).astype(np.float64),
        list(batch.astype(np.float32)),
    ):
        actions, state = pole.predict(array, deterministic=False)
        assert actions.tolist() == single and state is None
    with pytest.raises(InputError, match=r"shape \(3,\); accepted: \(4,\)"):
        pole.predict(np.zeros(3))


def test_values_are_float32_in_the_box(swing: TPG) -> None:
    actions, _ = swing.predict(np.random.default_rng(1).normal(size=(100, 3)))
    assert actions.shape == (100, 1) and actions.dtype == np.float32
    assert (np.abs(actions) <= 2).all() and len(np.unique(actions)) > 2
    assert swing.predict(np.zeros(3))[0].shape == (1,)
    assert "torque" in swing.formula()


def test_a_policy_in_integers_has_no_float(pole: TPG, tmp_path: Path) -> None:
    for path in [*pole.export_c(tmp_path / "fixed", prefix="cart", fixed=16), *pole.export_rust(tmp_path / "rust", fixed=8)]:
        lines = [line for line in path.read_text().splitlines() if "SHA-256" not in line]
        assert not any(word in line for word in ("float", "double", "f32", "f64", "math.h") for line in lines)
    states = np.random.default_rng(1).normal(size=(500, 4)) * 0.1
    whole = pole.quantise(bits=12, states=states, episodes=0)
    assert "of 500 actions are the same" in whole.said and '"counts"' in whole.graph.to_json()
    few: list[tuple[Any, Any]] = [(1, None), ("8", None), (3.5, None), (2**40, None)]
    few += [(8, given) for given in (np.zeros((3, 2)), np.zeros((3, 4)), [], [1.0], "text", np.full((3, 4), np.nan))]
    for bits, given in few:
        with pytest.raises(InputError):
            pole.quantise(bits=bits, states=given, episodes=4)
    partly = np.vstack([states, np.full((1, 4), np.nan), states])
    with pytest.raises(InputError, match="finite"):
        pole.quantise(8, states=partly, episodes=4)


def test_integers_have_the_fewest_bits_that_keep_the_return(swing: TPG, tmp_path: Path) -> None:
    whole = swing.quantise(episodes=10)
    assert "10 episodes" in whole.said and "8 bits" in whole.said
    assert whole.graph.counts and not swing.graph.counts
    # Both see and answer values; the integers' are multiples of a count.
    angles = np.linspace(-3, 3, 50)
    states = np.stack([np.cos(angles), np.sin(angles), angles], axis=1)
    assert np.abs(whole.predict(states)[0] - swing.predict(states)[0]).max() < 0.1
    whole.save(tmp_path / "whole.json")
    loaded = TPG.load(tmp_path / "whole.json", "Pendulum-v1")
    results = [model.evaluate(10, native=False, n_workers=count) for model, count in ((whole, 0), (loaded, 0), (loaded, 2))]
    assert len({result.mean for result in results}) == 1
    native = [model.evaluate(10).mean for model in (whole, swing)]
    assert abs(native[0] - native[1]) < 0.05 * abs(native[1]), "on the built-in problem, too"
    assert (TPG.load(tmp_path / "whole.json").predict(states)[0] == whole.predict(states)[0]).all()
    assert "one standard error lower" in swing.quantise(2, episodes=10).said


def test_the_c_answers_as_the_interpreter_in_whole_episodes(pole: TPG, tmp_path: Path) -> None:
    compiler = tools.program("cc")
    paths = pole.export_c(tmp_path / "policy", prefix="cart")
    assert sorted(path.name for path in paths) == ["cart.c", "cart.h"]
    library = tmp_path / "cart.so"
    subprocess.run(
        [
            compiler,
            "-std=c99",
            "-O2",
            "-ffp-contract=off",
            "-shared",
            "-fPIC",
            "-o",
            library,
            tmp_path / "policy/cart.c",
            "-lm",
        ],
        check=True,
    )
    infer = ctypes.CDLL(str(library)).cart_infer
    infer.restype = ctypes.c_uint16
    episodes = 1000
    env = gymnasium.make_vec("CartPole-v1", num_envs=episodes)
    observations, _ = env.reset(seed=1)
    over, steps = np.zeros(episodes, bool), 0
    while not over.all():
        states = np.ascontiguousarray(observations, np.float32)
        actions = [infer(ctypes.c_void_p(states.ctypes.data + row * states.strides[0])) for row in range(episodes)]
        assert actions == pole.predict(observations)[0].tolist()
        observations, _, terminated, truncated, _ = env.step(np.array(actions))
        steps += int((~over).sum())
        over |= terminated | truncated
    assert steps > 400 * episodes


def test_proof_report_formula_and_rust(pole: TPG, tmp_path: Path) -> None:
    proof = pole.verify(5000)
    assert proof.differences == 0 and "C, fast = interpreter on 5000 states" in str(proof)
    report = pole.report("host")
    assert "flash" in str(report).lower() and report.data["graph"]["inputs"] == 4
    assert "theta" in pole.formula() and "right" in pole.formula()
    assert [path.suffix for path in pole.export_rust(tmp_path, prefix="cart")] == [".rs"]
    for arguments, message in [((["c"], ["quick"]), "profile"), ((["ada"], ["fast"]), "language")]:
        with pytest.raises(InputError, match=message):
            pole.graph.verify(*arguments, 10, 1)
    with pytest.raises(InputError, match="host, m0, m3, m4, m4f, m7"):
        pole.report("z80")
    with pytest.raises(InputError, match="cannot start a name"):
        pole.export_c(tmp_path / "none", prefix="1")
    assert not (tmp_path / "none").exists()


def test_a_missing_compiler_is_said(pole: TPG, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("CC", "no-such-compiler")
    with pytest.raises(VerificationError, match="not verified: C, fast"):
        pole.verify(10)


def test_a_graph_is_saved_as_json_and_loaded(pole: TPG, tmp_path: Path) -> None:
    pole.save(tmp_path / "cart.json")
    assert json.loads((tmp_path / "cart.json").read_text())["format"] == "tpg-graph"
    again = TPG.load(tmp_path / "cart.json", "CartPole-v1")
    assert again.graph.sha256 == pole.graph.sha256
    assert again.evaluate(20, native=False) == pole.evaluate(20)
    assert again.evaluate(20).environment == "built-in cartpole"
    alone = TPG.load(tmp_path / "cart.json")
    assert [path.name for path in alone.export_c(tmp_path / "code")] == ["cart.h", "cart.c"]
    rows = np.random.default_rng(2).uniform(-1, 1, (20, 4))
    assert alone.predict(rows)[0].tolist() == pole.predict(rows)[0].tolist()
    with pytest.raises(InputError, match="4 inputs; accepted: 3, as Pendulum-v1 has"):
        TPG.load(tmp_path / "cart.json", "Pendulum-v1")
    (tmp_path / "bad.json").write_text("{}")
    with pytest.raises(InputError, match="bad.json: .*accepted"):
        TPG.load(tmp_path / "bad.json")
    with pytest.raises(InputError, match="missing.json"):
        TPG.load(tmp_path / "missing.json")


def test_a_notebook_gets_a_picture(pole: TPG, swing: TPG) -> None:
    for model in (pole, swing):
        assert model.graph._repr_svg_().startswith("<svg") and "<style>" in model.graph._repr_svg_()
        assert repr(model.graph).startswith("<Graph of") and str(model.graph) == model.formula()


def test_known_ids_run_as_built_in_problems_unless_wrapped(caplog: pytest.LogCaptureFixture) -> None:
    with caplog.at_level("INFO", "tpg_train"):
        assert TPG("CartPole-v1").native == "cartpole"
    assert "runs as the built-in problem cartpole; native=False" in caplog.text
    made = gymnasium.make("CartPole-v1")
    assert TPG(made).native is None
    assert TPG("CartPole-v1", native=False).native is None
    assert TPG(TimeLimit(made, 100)).native is None or made.spec is None
    assert TPG(gymnasium.make("CartPole-v1", max_episode_steps=100)).native is None
    assert TPG(gymnasium.wrappers.TransformReward(made, lambda reward: -reward)).native is None
    assert TPG(lambda: gymnasium.make("CartPole-v1")).native is None


@pytest.mark.parametrize("make", [environments.Cart, environments.BoxCart, environments.DictCart])
def test_a_policy_is_evolved_in_f64(make: type[environments.Cart], tmp_path: Path) -> None:
    double = TPG(make, scalar="f64", **SMALL).learn(20_000)
    assert double.graph.scalar == "f64" and TPG(make, **SMALL).learn(100).graph.scalar == "f32"
    assert TPG(make, scalar="f64", **SMALL).learn(20_000, n_workers=2).graph.sha256 == double.graph.sha256
    assert any("double" in path.read_text() for path in double.export_c(tmp_path, prefix="cart"))
    assert double.verify(500).differences == 0
    # What the worker does is what the model says.
    env, total = make(), 0.0
    observation, _ = env.reset(seed=tpg_train._tpg.test_seeds(1, 1)[0])
    done = False
    while not done:
        observation, reward, terminated, truncated, _ = env.step(double.predict(observation)[0])
        total, done = total + float(reward), terminated or truncated
    assert double.evaluate(1).mean == total


def test_a_built_in_problem_is_evolved_in_f64() -> None:
    model = TPG("CartPole-v1", scalar="f64").learn(200_000, target=475)
    assert model.native == "cartpole" and model.graph.scalar == "f64"
    assert model.evaluate(100).mean > 300 and model.evaluate(3, native=False).mean > 100
    assert model.verify(500).differences == 0


def test_f64_reads_digits_that_f32_does_not(tmp_path: Path) -> None:
    value = {"length": 1, "unit": "", "ranges": [[0, 2]]}
    text = {
        "format": "tpg-graph",
        "version": 1,
        "maths": "own",
        "registers": 1,
        "sources": [{"name": name, **value} for name in ("x", "one", "zero")],
        "instructions": ["add"],
        "actions": [{"id": 0, "name": "above"}, {"id": 1, "name": "below"}],
        "root": 0,
        "teams": [{"id": 0, "edges": [{"program": place, "action": place} for place in (0, 1)]}],
        "programs": [
            {"id": place, "lines": [{"to": 0, "op": "add", "args": [name, "zero[0]"]}]}
            for place, name in enumerate(("x[0]", "one[0]"))
        ],
    }
    right = {}
    for scalar in ("f32", "f64"):
        file = tmp_path / f"{scalar}.json"
        file.write_text(json.dumps({**text, "scalar": scalar}))
        right[scalar] = TPG.load(file, environments.Digits).evaluate(40).success_rate
    assert right["f64"] == 1.0 and right["f32"] is not None and right["f32"] < 0.8


@pytest.mark.parametrize("name", ["CartPole-v1", "Pendulum-v1", "MountainCarContinuous-v0"])
def test_built_in_problems_are_gymnasiums_step_by_step(name: str) -> None:
    problem = TPG(name).native
    assert problem is not None
    ours, theirs = tpg_train.envs.BuiltInEnv(problem), gymnasium.make(name)
    for seed in range(5):
        observation, _ = theirs.reset(seed=seed)
        inner = theirs.unwrapped
        assert inner.state is not None  # type: ignore[attr-defined]
        state = [float(value) for value in inner.state]  # type: ignore[attr-defined]
        task = state[0] if problem == "mountain-car-continuous" else state
        mine, _ = ours.reset(options={"task": task})
        np.testing.assert_allclose(mine, observation, atol=1e-6)
        theirs.action_space.seed(seed)
        for _ in range(200):
            action = theirs.action_space.sample()
            observation, reward, terminated, truncated, _ = theirs.step(action)
            mine, my_reward, my_end, my_cut, _ = ours.step(action)
            np.testing.assert_allclose(mine, observation, rtol=1e-3, atol=1e-3)
            assert abs(my_reward - float(reward)) < 1e-3 and (my_end, my_cut) == (terminated, truncated)
            if terminated or truncated:
                break


@pytest.mark.parametrize(
    "make",
    [
        environments.DictCart,
        environments.TupleCart,
        environments.BoxCart,
        environments.ManyCart,
        environments.StartingCart,
        environments.WideCart,
    ],
)
def test_spaces(make: type[environments.Cart]) -> None:
    model = TPG(make, **SMALL).learn(20_000)
    assert model.evaluate(5).success_rate is not None
    env = make()
    action, _ = model.predict(env.reset(seed=1)[0])
    assert env.action_space.contains(action)
    model.verify(500)


def test_names_of_a_nested_observation_are_in_the_formula() -> None:
    model = TPG(environments.DictCart, **SMALL)
    assert [part.name for part in model._interface.parts] == ["cart_v", "cart_x", "side"]
    assert model.learn(20_000).graph.inputs == ["cart_v[0]", "cart_x[0]", "side[0]", "side[1]"]
    named = TPG(environments.Cart, input_names=["place", "speed"], action_names=["brake", "push"], **SMALL).learn(20_000)
    assert named.graph.inputs == ["place[0]", "speed[0]"] and named.graph.actions == ["brake", "push"]
    assert model.predict({"cart": {"x": np.zeros(1), "v": np.zeros(())}, "side": 0})[0] in (0, 1)


def test_unknown_ranges_are_learned_from_visited_states() -> None:
    model = TPG(environments.Cart, **SMALL).learn(20_000)
    assert all(np.isfinite(ends).all() and ends[0] < ends[1] for ends in model.graph.ranges)


@pytest.mark.parametrize(
    ("make", "message"),
    [
        ("NoSuch-v0", "NoSuch"),
        (environments.Images, "an observation of images"),
        (environments.Unbounded, "accepted: finite bounds"),
        (environments.Texts, "accepted: Box, Discrete"),
        (environments.OneAction, "two or more"),
        (environments.Huge, "1000000 combinations"),
        (lambda: 3, "without observation_space"),
    ],
)
def test_what_is_no_environment_is_refused_with_what_is_accepted(make: object, message: str) -> None:
    with pytest.raises(InputError, match=message) as error:
        TPG(make)  # type: ignore[arg-type]
    assert "accepted" in str(error.value)


@pytest.mark.parametrize(
    ("make", "message"),
    [
        (environments.NanObservation, r"seed \d+, step 3: observation\[1\] is NaN"),
        (environments.NanReward, r"seed \d+, step 1: a reward of NaN"),
        (environments.WrongShape, r"seed \d+, step 0: an observation of shape \[3\]; accepted: \[2\]"),
        (environments.OldStep, r"step\(\) returned a tuple of 4; accepted: \(observation, reward, terminated"),
    ],
)
def test_what_an_environment_does_wrong_is_said_with_its_place(make: type[environments.Cart], message: str) -> None:
    with pytest.raises(InputError, match=message):
        TPG(make, **SMALL).learn(1000)


@pytest.mark.parametrize("n_workers", [0, 1])
def test_an_exception_of_the_environment_arrives_as_itself(n_workers: int) -> None:
    model = TPG(environments.Failing, n_workers=n_workers, **SMALL)
    with pytest.raises(KeyError, match="the motor is off"):
        model.learn(100_000)


def test_settings_and_presets_are_checked() -> None:
    for arguments, message in [
        ({"preset": "best"}, "accepted: thorough, quick, gegelati"),
        ({"settings": {"tpg.roots": 3}}, "tpg.roots"),
        ({"settings": {"tpg.nb_roots": 0}}, "nb_roots"),
        ({"scalar": "f16"}, "f16.*expected `f32` or `f64`"),
        ({"input_names": ["x"]}, "1 input_names; accepted: 2"),
        ({"action_names": ["x"]}, "1 action_names; accepted: 2"),
        ({"action_names": ["x", "x"]}, "action_names x, x; accepted: each name once"),
    ]:
        with pytest.raises(InputError, match=message):
            TPG(environments.Cart, **arguments)
    with pytest.raises(TrainingError, match="no graph yet"):
        TPG(environments.Cart).predict(np.zeros(2))


def test_state_that_survives_a_reset_is_noticed_and_named() -> None:
    with pytest.warns(StatefulEnvironmentWarning, match=r"Stateful: the observation after 0 actions .*wrappers\.Fresh"):
        TPG(environments.Stateful, **SMALL).learn(100)
    gymnasium.register("Stateful-v0", entry_point=environments.Stateful)
    with warnings.catch_warnings():
        warnings.simplefilter("error", StatefulEnvironmentWarning)
        named = TPG("Stateful-v0", **SMALL).learn(3_000)
    assert named.evaluate(3).mean == named.evaluate(3).mean, "an id says how to make a new one for each episode"


def test_training_goes_on_and_the_same_seed_gives_the_same_graph(tmp_path: Path) -> None:
    whole = TPG(environments.Cart, folder=tmp_path / "a", **SMALL).learn(30_000)
    assert 0.9 * 30_000 <= whole.num_timesteps <= 1.2 * 30_000
    same = TPG(environments.Cart, **SMALL).learn(30_000)
    assert same.graph.sha256 == whole.graph.sha256
    assert TPG(environments.Cart, seed=2, **SMALL).learn(30_000).graph.sha256 != whole.graph.sha256
    resumed = TPG(environments.Cart, folder=tmp_path / "a", resume=True, **SMALL)
    assert resumed.num_timesteps == whole.num_timesteps
    # A script that was stopped is run again as it is: the run has these steps already.
    assert resumed.learn(30_000).num_timesteps == whole.num_timesteps
    assert resumed.learn(10_000).num_timesteps >= whole.num_timesteps + 9_000
    with pytest.raises(InputError, match="resume"):
        TPG(environments.Cart, folder=tmp_path / "a", **SMALL).learn(10)


def test_a_stopped_run_ends_with_the_bytes_of_an_undisturbed_one() -> None:
    def learn(stop_at: int | None) -> str:
        model = TPG(environments.Cart, **SMALL)
        calls = 0

        class Stopping(environments.Cart):
            def step(self, action: object) -> object:
                nonlocal calls
                calls += 1
                if calls == stop_at:
                    raise KeyboardInterrupt
                return super().step(action)

        Stopping.__name__ = "Cart"  # a graph says its environment's
        if stop_at is not None:
            stopping = TPG(Stopping, **SMALL)
            with pytest.raises(KeyboardInterrupt):
                stopping.learn(20_000)
            assert 0 < stopping.num_timesteps < 20_000
            stopping.learn(20_000 - stopping.num_timesteps)
            return stopping.graph.sha256
        return model.learn(20_000).graph.sha256

    assert learn(11_111) == learn(None)


def test_ctrl_c_stops_saves_and_can_go_on(tmp_path: Path) -> None:
    script = f"""
import os, signal, threading
from tpg_train import TPG

def interrupt(figures, _):
    if figures["progress"]["generations"] == 3:
        threading.Thread(target=lambda: os.kill(os.getpid(), signal.SIGINT)).start()

for native in (True, False):
    model = TPG("CartPole-v1", native=native, population=20, episodes=2, folder={str(tmp_path)!r} + f"/{{native}}")
    try:
        model.learn(10**12, interrupt)
    except KeyboardInterrupt:
        print("stopped", model.num_timesteps > 0)
    before = model.num_timesteps
    print("went on", model.learn(1000).num_timesteps > before)
"""
    done = subprocess.run([sys.executable, "-c", script], capture_output=True, text=True, timeout=100)
    assert done.stdout.split("\n")[:-1] == ["stopped True", "went on True"] * 2, done.stderr


def test_python_goes_on_while_we_compute(pole: TPG) -> None:
    import threading

    ticks = 0
    over = threading.Event()

    def tick() -> None:
        nonlocal ticks
        while not over.wait(0.001):
            ticks += 1

    thread = threading.Thread(target=tick)
    thread.start()
    pole.verify(20_000)
    over.set()
    thread.join()
    assert ticks > 20


def test_the_hall_of_fame_goes_from_small_to_good() -> None:
    model = TPG("Pendulum-v1", seed=2).learn(500_000)
    hall = model.hall_of_fame
    assert hall and all(a.size < b.size and a.score < b.score for a, b in zip(hall, hall[1:], strict=False))
    assert model.graph.sha256 == hall[-1].graph.sha256
    assert model.use(hall[0]).graph.size == hall[0].size
    model.verify(500)


def test_hardware_in_the_loop() -> None:
    arguments = {"population": 12, "episodes": 2, "settings": {"selection.validation_episodes": 4}}
    goes_on = lambda says, _: says["self"].num_timesteps < 20_000  # noqa: E731
    learned = TPG(environments.Cart, **arguments).learn(10**12, goes_on)
    model = TPG(environments.Cart, **arguments)
    env, rounds = environments.Cart(), 0
    while model.num_timesteps < 20_000 and (candidates := model.ask()):
        rounds += 1
        assert model.ask() == candidates, "asked again before an answer"
        returns = []
        for candidate in reversed(candidates):
            observation, _ = env.reset(seed=candidate.seed)
            total, done = 0.0, False
            while not done:
                observation, reward, terminated, truncated, _ = env.step(candidate.predict(observation))
                total, done = total + float(reward), terminated or truncated
            returns.append(total)
        with pytest.raises(InputError, match="each of them once"):
            model.tell(candidates, returns[1:])
        with pytest.raises(InputError, match="a return of NaN"):
            model.tell(candidates, [float("nan")] * len(candidates))
        model.tell(list(reversed(candidates)), returns)
    assert rounds > 5 and model.has_graph
    # A bench says nothing of success, which the file tells.
    found, accepted = ((one.num_timesteps, one.graph.size, one.formula(), one.graph.ranges) for one in (model, learned))
    assert found == accepted
    with pytest.raises(InputError, match="native=False"):
        TPG("CartPole-v1").ask()


def test_hardware_in_the_loop_may_play_shorter_episodes() -> None:
    model, rounds = TPG(environments.Cart, settings={"start.random": 0.5, "start.share": 0.5}, seed=1), 0
    env, refused = environments.Cart(), False
    while model.num_timesteps < 5_000 and (candidates := model.ask()):
        rounds += 1
        if candidates[0]._after is not None:
            refused = True
            with pytest.raises(InputError, match="no observation; accepted: an episode in which predict"):
                model.tell(candidates, [0.0] * len(candidates))
        for candidate in candidates:
            observation, _ = env.reset(seed=candidate.seed)
            for _ in range(1 + (candidate.seed + rounds) % 9):
                observation, *_ = env.step(candidate.predict(observation))
        model.tell(candidates, [-1.0 - candidate.steps for candidate in candidates])
    assert refused and model.num_timesteps >= 5_000


def test_learning_after_loading_says_that_it_begins_anew(pole: TPG, tmp_path: Path) -> None:
    pole.save(tmp_path / "pole.json")
    loaded = TPG.load(tmp_path / "pole.json", "CartPole-v1")
    with pytest.warns(UserWarning, match="begins a new run and replaces the policy that was loaded"):
        loaded.learn(10_000)


def test_a_preset_has_the_sizes_that_the_environment_needs(tmp_path: Path) -> None:
    for env, settings, random in ((environments.Cart, {}, 0.45), (environments.BoxCart, {"start.share": 0.25}, 0.25)):
        model = TPG(env, settings=settings, folder=tmp_path / str(random)).learn(2_000)
        config = json.loads(model.graph.to_json())["provenance"]["config"]
        assert config["start"]["random"] == random and config["learning"]["nb_generations"] == 0
        assert tpg_train.Graph.load(tmp_path / str(random) / "graph.json").sha256 == model.graph.sha256
    with pytest.raises(InputError, match="the setting start.share: .*expected f64"):
        TPG(environments.Cart, settings={"start.share": "a"})


def test_hardware_in_the_loop_goes_on_with_a_random_search(tmp_path: Path) -> None:
    class Stop(tpg_train.callbacks.BaseCallback):
        def _on_step(self) -> bool:
            return False

    settings = {"start.random": 0.5, "start.share": 0.5}
    model = TPG(environments.Cart, settings=settings, folder=tmp_path / "run").learn(1_000_000, callback=Stop())
    before = model.num_timesteps
    env, driver = environments.Cart(), model._interface.driver(environments.Cart())
    for _ in range(2):
        candidates = model.ask()
        assert 2 * len({candidate.seed for candidate in candidates}) == len(candidates), "opposites play the same episode"
        returns = []
        for candidate in candidates:
            observation, _ = env.reset(seed=candidate.seed)
            total, done = 0.0, False
            while not done:
                observation, reward, terminated, truncated, _ = env.step(candidate.predict(observation))
                total, done = total + float(reward), terminated or truncated
            returns.append(total)
            played, seen, _ = driver.play(candidate._policy, candidate.seed, [])
            assert played[:2] == (total, candidate.steps)
            assert seen == candidate._policy.moments(candidate._seen)
            assert json.loads(seen)["count"] == candidate.steps
        model.tell(candidates, returns)
    model.ask()
    assert model.num_timesteps > before


def test_a_graph_is_text_and_is_pickled_as_it(pole: TPG) -> None:
    text = pole.graph.to_json()
    assert tpg_train.Graph.from_json(text).sha256 == pole.graph.sha256
    assert pickle.loads(pickle.dumps(pole.graph._graph)).sha256 == pole.graph.sha256


def test_a_model_is_compared_with_another_controller_on_the_same_episodes(pole: TPG, swing: TPG) -> None:
    hand = lambda state: int(state[2] + 0.5 * state[3] > 0)  # noqa: E731
    both = pole.evaluate(20, other=hand)
    assert both.this == pole.evaluate(20, native=False) and both.efforts is None
    tested = json.loads((pole.folder / "tested.jsonl").read_text())
    assert tested["graph"] == pole.graph.sha256 and tested["rivals"][0]["scores"] == both.returns[1]
    assert np.mean([one["score"] for one in tested["episodes"]]) == both.this.mean
    env = gymnasium.make("CartPole-v1")
    returns = []
    for seed in tpg_train._tpg.test_seeds(1, 20):
        state, done, score = env.reset(seed=seed)[0], False, 0.0
        while not done:
            state, reward, terminated, truncated, _ = env.step(hand(state))
            score, done = score + float(reward), terminated or truncated
        returns.append(score)
    assert both.other.mean == np.mean(returns) and both.difference == both.this.mean - both.other.mean
    assert both.ci95[0] <= both.difference <= both.ci95[1]
    itself = pole.evaluate(5, other=pole)
    assert itself.difference == 0 and itself.ci95 == (0, 0) and "no clear difference" in str(itself)
    bang = swing.evaluate(10, other=lambda state: np.array([2.0 if state[2] > 0 else -2.0], np.float32))
    assert bang.efforts is not None and bang.efforts[1].saturated == 1 and bang.efforts[0].saturated < 1
    assert 0 < bang.efforts[0].chatter < 1 and "saturated" in str(bang) and "this model is better" in str(bang)
    with pytest.raises(InputError, match="a return of NaN by <lambda>"):
        swing.evaluate(2, other=lambda _: np.array([np.nan], np.float32))
    with pytest.raises(InputError, match="other=3; accepted: a function"):
        pole.evaluate(2, other=3)
    with pytest.raises(InputError, match="other='lqr'; accepted: pid, relay, linear"):
        pole.evaluate(2, other="lqr")
    with pytest.raises(InputError, match="whose actions are choices; accepted: relay, linear"):
        pole.evaluate(2, other="pid")


def test_a_rival_is_tuned_and_says_its_law() -> None:
    swing = TPG("Pendulum-v1", native=False, settings={"start.share": 1.0, "start.random": 1.0}).learn(3_000)
    for kind, law in (("pid", "torque = "), ("relay", "torque = 2 if "), ("linear", "torque = ")):
        both = swing.evaluate(5, other=kind)
        assert both.law is not None and law in both.law and "[" not in both.law
        assert both.efforts is not None
        assert kind != "relay" or both.efforts[1].saturated == 1.0
    all_of_them = swing.evaluate(5, other=["relay", lambda state: np.zeros(1, np.float32)])
    assert [one.name for one in all_of_them] == ["relay", "<lambda>"]
    assert "this model - <lambda>: " in str(all_of_them) and "the law of relay: torque" in str(all_of_them)
    with pytest.raises(InputError, match="one or more controllers"):
        swing.evaluate(5, other=[])


def test_a_run_is_resumed_with_its_names_only(tmp_path: Path) -> None:
    swing = lambda **names: TPG("Pendulum-v1", native=False, folder=tmp_path, **names)  # noqa: E731
    swing(input_names=["x", "y", "speed"]).learn(3_000)
    with pytest.raises(InputError, match=r"a graph of the inputs x\[0\], y\[0\], speed\[0\]; accepted: cos_theta"):
        swing(resume=True).learn(6_000)
    resumed = swing(input_names=["x", "y", "speed"], resume=True)
    steps = resumed.num_timesteps
    assert resumed.evaluate(2).mean < 0, "a resumed model can be used at once"
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        resumed.learn(1)
    assert resumed.num_timesteps == steps, "it had more steps already"
    resumed.learn(3_000)


def test_a_quantised_policy_has_a_report(pole: TPG) -> None:
    assert "Cortex-M0" in str(pole.quantise(16).report("m0"))


def test_rivals_on_the_same_episodes_are_kept_for_the_report(tmp_path: Path) -> None:
    swing = TPG("Pendulum-v1", native=False, folder=tmp_path, settings={"start.share": 1.0, "start.random": 1.0}).learn(3_000)
    still = lambda state: np.zeros(1, np.float32)  # noqa: E731
    swing.evaluate(4, other="relay")
    swing.evaluate(4, other=still)
    swing.evaluate(4)
    tested = json.loads((tmp_path / "tested.jsonl").read_text())
    assert [rival["name"] for rival in tested["rivals"]] == ["relay", "<lambda>"] and tested["effort"]["chatter"] > 0
    swing.evaluate(5)
    assert json.loads((tmp_path / "tested.jsonl").read_text())["rivals"] == []


def test_a_loop_answers_by_error_sum_and_change() -> None:
    swing = TPG("Pendulum-v1", native=False)
    loops = [Loop(1, 0.5, -2.0, 0.25, 1.0)]
    law = Tuned("pid", swing._interface, loops)
    first, state = law.predict(np.array([1.0, 0.25, 0.0], np.float32))
    second, _ = law.predict(np.array([1.0, 0.75, 0.0], np.float32), state)
    # The errors are -0.25 and 0.25: 0.5 - 0.0625 + 0, and -0.5 + 0 + 0.5.
    assert first.tolist() == [0.4375] and second.tolist() == [0.0]
    gains = "-2 * (sin_theta - 0.5) + 0.25 * sum(sin_theta - 0.5) + 1 * change(sin_theta)"
    assert law.formula() == f"torque = {gains}, limited to -2 to 2"
    assert Loop(0, 0.0, 0.5, 0.0, 0.0).text("error", 0.5) == "0.5 + 0.5 * error"
    relay = Tuned("relay", TPG("CartPole-v1")._interface, [Loop(2, 0.0, 1.0, 0.0, 0.0)], (1, 0))
    assert [relay.predict(np.array([0, 0, angle, 0], np.float32))[0] for angle in (0.1, -0.1)] == [0, 1]
    assert relay.formula() == "left if 1 * theta > 0, else right"
