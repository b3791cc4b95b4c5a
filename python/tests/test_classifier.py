"""The classifier: scikit-learn's rules, determinism, accuracy, and code."""

from __future__ import annotations

import ctypes
import json
import pickle
import subprocess
import sys
from pathlib import Path
from typing import Any

import numpy as np
import pytest
import tools
from sklearn.datasets import load_breast_cancer, load_digits, load_wine
from sklearn.model_selection import train_test_split
from sklearn.neural_network import MLPClassifier
from sklearn.utils.estimator_checks import check_estimator

import tpg_train
from tpg_train import TPG, InputError, TPGClassifier

STEPS = 300_000


def wine(**arguments: Any) -> tuple[Any, list[Any]]:
    parts = train_test_split(*load_wine(return_X_y=True, as_frame=True), random_state=0, stratify=load_wine().target)
    return TPGClassifier(total_timesteps=STEPS, random_state=1, **arguments).fit(parts[0], parts[2]), parts


@pytest.fixture(scope="module")
def fitted() -> tuple[Any, list[Any]]:
    return wine()


def test_scikit_learns_checks_pass() -> None:
    small = {"tpg.nb_roots": 20, "learning.nb_iterations_per_policy_evaluation": 50, "selection.racing_episodes": 0}
    check_estimator(TPGClassifier(total_timesteps=10_000, settings=small))


def test_samples_that_nothing_has_seen_are_classified(fitted: tuple[Any, list[Any]]) -> None:
    model, (_, seen, _, classes) = fitted
    assert model.score(seen, classes) >= 0.9
    assert model.classes_.tolist() == [0, 1, 2] and model.n_features_in_ == 13
    assert model.model_.graph.actions == ["class_0", "class_1", "class_2"]
    assert "flavanoids[0]" in model.model_.graph.inputs and "class_2" in model.model_.formula()


def test_the_same_seed_gives_the_same_bytes_in_any_order_of_samples(fitted: tuple[Any, list[Any]]) -> None:
    model, (samples, _, classes, _) = fitted
    again = TPGClassifier(total_timesteps=STEPS, random_state=1, n_jobs=2).fit(samples[::-1], classes[::-1])
    assert again.model_.graph.to_json() == model.model_.graph.to_json()
    other = TPGClassifier(total_timesteps=STEPS, random_state=2).fit(samples, classes)
    assert other.model_.graph.to_json() != model.model_.graph.to_json()


def test_the_c_and_a_file_answer_as_the_classifier(fitted: tuple[Any, list[Any]], tmp_path: Path) -> None:
    model, (_, seen, _, _) = fitted
    expected = model.predict(seen)
    model.model_.save(tmp_path / "graph.json")
    loaded = TPG.load(tmp_path / "graph.json")
    assert [int(loaded.predict(row)[0]) for row in seen.to_numpy()] == expected.tolist()
    assert (pickle.loads(pickle.dumps(model)).predict(seen) == expected).all()
    source = next(path for path in model.model_.export_c(tmp_path / "c", prefix="wine") if path.suffix == ".c")
    library = tmp_path / "wine.so"
    subprocess.run([tools.program("cc"), "-O1", "-shared", "-fPIC", source, "-lm", "-o", library], check=True)
    infer = ctypes.CDLL(str(library)).wine_infer
    row = ctypes.c_float * 13
    assert [infer(row(*values)) for values in seen.to_numpy()] == expected.tolist()
    whole = model.model_.quantise(16, seen.to_numpy())
    assert model.model_.export_rust(tmp_path / "rust") and "Cortex-M0" in str(whole.report("m0"))


def test_the_graph_asks_a_network_where_it_is_unsure_and_c_answers_as_both(tmp_path: Path) -> None:
    parts = train_test_split(*load_digits(return_X_y=True), random_state=0)
    few: dict[str, Any] = {"total_timesteps": STEPS, "random_state": 1}
    alone = TPGClassifier(**few).fit(parts[0], parts[2])
    model = TPGClassifier(**few, network=MLPClassifier((32,), max_iter=300), price=0.02).fit(parts[0], parts[2])
    graph, expected = model.model_.graph, model.predict(parts[1])
    asked = graph.answers(np.ascontiguousarray(parts[1])) == 10
    assert 0.01 < asked.mean() < 0.5 and model.score(parts[1], parts[3]) > alone.score(parts[1], parts[3])
    assert (expected[asked] == model.network_.predict(parts[1][asked])[0]).all()
    assert (expected[~asked] == alone.predict(parts[1])[~asked]).all()
    assert (pickle.loads(pickle.dumps(model)).predict(parts[1]) == expected).all()
    for fixed, kind in ((None, "c_float"), (16, "c_int16")):
        folder = tmp_path / kind
        files = model.model_.export_c(folder, prefix="digit", fixed=fixed, network=model.network_)
        assert sorted(path.name for path in files)[-3:] == ["digit_decide.h", "digit_network.c", "digit_network.h"]
        (folder / "all.c").write_text(
            '#include "digit_decide.h"\nint decide(const digit_state_t *state) { return (int)digit_decide(state); }\n'
        )
        flags = ["-std=c99", "-Wall", "-Wextra", "-Wconversion", "-Werror", "-O1", "-shared", "-fPIC"]
        library = folder / "digit.so"
        subprocess.run([tools.program("cc"), *flags, *folder.glob("*.c"), "-lm", "-o", library], check=True)
        rows, values = parts[1], getattr(ctypes, kind) * 64
        if fixed is not None:
            counts = [
                one for source in json.loads(model.model_.quantise(16).graph.to_json())["sources"] for one in source["counts"]
            ]
            rows = np.rint(rows / [one["scale"] for one in counts] + [one.get("offset", 0) for one in counts]).astype(int)
        decide = ctypes.CDLL(str(library)).decide
        answers = np.array([decide(values(*row)) for row in rows.tolist()])
        assert (answers == expected).mean() >= (1.0 if fixed is None else 0.98)
    with pytest.raises(InputError, match=r"the network: \$.observation: .*; accepted: alcohol, malic_acid"):
        wine(network=MLPClassifier((4,), max_iter=2000))[0].model_.export_c(tmp_path / "other", network=model.network_)
    with pytest.raises(InputError, match=r"the graph: \$.actions: no action that asks, as the last; accepted: one"):
        alone.model_.export_c(tmp_path / "other", network=model.network_)
    assert not (tmp_path / "other").exists()


def test_classes_have_names_and_weights() -> None:
    samples, classes = load_breast_cancer(return_X_y=True)
    names = np.array(["malignant", "benign"])[classes]
    few = {"total_timesteps": STEPS, "random_state": 0}
    plain = TPGClassifier(**few).fit(samples, names)
    assert plain.model_.graph.actions == ["benign", "malignant"] and plain.score(samples, names) > 0.9
    careful = TPGClassifier(**few, class_weight={"benign": 0.02, "malignant": 1.0}).fit(samples, names)
    found = lambda model: (model.predict(samples)[names == "malignant"] == "malignant").mean()  # noqa: E731
    assert found(careful) > found(plain)


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        ({"validation_fraction": 1.0}, r"validation_fraction = 1.0; accepted: from 0, below 1"),
        ({"preset": "fast"}, r"the preset \"fast\"; accepted: .*labels"),
        ({"settings": {"tpg.roots": 3}}, "unknown field `roots`"),
        ({"price": -1}, "price = -1; accepted: 0 or more"),
        ({"network": MLPClassifier(activation="tanh")}, "accepted: an MLPClassifier with activation='relu'"),
        ({"total_timesteps": 0}, "total_timesteps = 0; accepted: a whole number from 1"),
    ],
)
def test_a_bad_argument_is_named(arguments: dict[str, Any], message: str) -> None:
    with pytest.raises(InputError, match=message):
        TPGClassifier(**arguments).fit([[0.0], [1.0]], [0, 1])


def test_bad_samples_are_refused() -> None:
    with pytest.raises(InputError, match="y of one class; accepted: samples of two classes"):
        TPGClassifier().fit([[0.0], [1.0]], [0, 1], sample_weight=[1, 0])
    with pytest.raises(ValueError, match="contains NaN"):
        TPGClassifier().fit([[0.0], [np.nan]], [0, 1])
    with pytest.raises(ValueError, match="too large for dtype"):
        TPGClassifier().fit([[0.0], [1e200]], [0, 1])


def test_without_scikit_learn_the_rest_works_and_the_error_says_what_to_install() -> None:
    script = (
        "import sys; sys.modules['sklearn'] = None; import tpg_train; from tpg_train import *\n"
        "try: tpg_train.TPGClassifier\n"
        "except ImportError as error: print(error)"
    )
    told = subprocess.run([sys.executable, "-c", script], check=True, capture_output=True, text=True).stdout
    assert "pip install 'tpg-train[sklearn]'" in told
    assert not hasattr(tpg_train, "Classifier")


def test_the_guides_example_runs(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    page = (Path(__file__).parents[2] / "docs/python.md").read_text()
    example = page.split("## Classify")[1].split("```python\n")[1].split("```")[0]
    monkeypatch.chdir(tmp_path)
    names: dict[str, Any] = {}
    exec(example, names)
    assert names["model"].score(names["unseen"], names["expected"]) >= 0.9
    assert (tmp_path / "wine/wine.c").exists()
