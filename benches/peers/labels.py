#!/usr/bin/env python3
"""The classifier of the Python package beside logistic regression and decision trees of emlearn, on scikit-learn's data.

    cargo build --release -p cortex-bound
    python3 -m venv peers && peers/bin/pip install ./python emlearn==0.23.2 scikit-learn==1.9.1
    peers/bin/python benches/peers/labels.py [--steps 2000000] [--only wine] [--line-price 0.05]

Accuracy is that of all samples in a stratified 5-fold cross-validation, with its 95 % interval (Wilson), on the same folds. Code
is the median of the five models': bytes of code and constants with the library functions that it calls, and the most instructions
of a decision, on a Cortex-M0 and a Cortex-M4F, `-Os`. The classifier answers in floats and in integers, whose bits the ranges of
the training samples fill; the trees are inline code over features of 16 bits, called without the vote of a forest. Of trees of 4
to 256 leaves, the table has the most accurate one whose code fits 2 KB on the Cortex-M0. What scales features to integers counts
for neither. Prints a table in Markdown.

The accelerometer is drawn here: 2,000 windows of 64 samples at 50 Hz by one who rests, walks, climbs stairs, runs or shakes it, held in
any direction; classifiers see six features of the magnitude.
"""

from __future__ import annotations

import argparse
import json
import subprocess
import sys
import tempfile
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import emlearn
import numpy as np
from sklearn.datasets import load_breast_cancer, load_digits, load_wine
from sklearn.linear_model import LogisticRegression
from sklearn.model_selection import StratifiedKFold
from sklearn.pipeline import make_pipeline
from sklearn.preprocessing import StandardScaler
from sklearn.tree import DecisionTreeClassifier

from tpg_train import TPGClassifier

sys.path.insert(0, str(Path(__file__).resolve().parents[1] / "control"))
from generated import BOUND, flash_of  # noqa: E402

# Of each activity of the accelerometer: the lowest and highest frequency, Hz, and amplitude, g, and the share of the second harmonic.
ACTIVITIES = {
    "rest": (0.0, 0.5, 0.0, 0.02, 0.0),
    "walk": (1.4, 2.2, 0.15, 0.45, 0.3),
    "stairs": (1.1, 1.8, 0.2, 0.6, 0.8),
    "run": (2.2, 3.2, 0.5, 1.5, 0.3),
    "shake": (2.8, 6.0, 0.3, 1.2, 0.1),
}


def accelerometer(return_X_y: bool = True) -> tuple[Any, Any]:
    """Returns features of windows of an accelerometer, and who moves it how."""
    random, times = np.random.default_rng(1), np.arange(64) / 50
    features, activities = [], []
    for number in range(2000):
        name = list(ACTIVITIES)[number % len(ACTIVITIES)]
        slow, fast, weak, strong, second = ACTIVITIES[name]
        phase = 2 * np.pi * (random.uniform(slow, fast) * times + random.uniform())
        swing = random.uniform(weak, strong) * (np.sin(phase) + second * np.sin(2 * phase + random.uniform(0, 2)))
        gravity, way = (axis / np.linalg.norm(axis) for axis in random.normal(size=(2, 3)))
        samples = (
            gravity + swing[:, None] * (0.8 * gravity + 0.6 * way) + random.normal(size=(64, 3)) * random.uniform(0.02, 0.12)
        )
        size = np.linalg.norm(samples, axis=1)
        steps, middle = np.abs(np.diff(size)), size - size.mean()
        crossings = np.count_nonzero(np.diff(np.signbit(middle)))
        features.append([size.mean(), size.std(), size.min(), size.max(), steps.mean(), crossings])
        activities.append(name)
    return np.array(features), np.array(activities)


DATA = {"digits": load_digits, "wine": load_wine, "breast cancer": load_breast_cancer, "accelerometer": accelerometer}
LEAVES = (4, 8, 16, 32, 64, 128, 256)
LARGEST = 2048
CORES = {"m0": ["-mcpu=cortex-m0"], "m4f": ["-mcpu=cortex-m4", "-mfloat-abi=hard", "-mfpu=fpv4-sp-d16"]}


class Integers:
    """The policy of a classifier in integers."""

    def __init__(self, model: Any, bits: int) -> None:
        self.graph, self.classes = model.model_.quantise(bits).graph, model.classes_

    def predict(self, samples: Any) -> Any:
        return self.classes[self.graph.answers(np.ascontiguousarray(samples, np.float64))]


class Tree:
    """A decision tree over features of 16 bits."""

    def __init__(self, leaves: int) -> None:
        self.tree = DecisionTreeClassifier(max_leaf_nodes=leaves, random_state=0)

    def whole(self, samples: Any) -> Any:
        return np.clip(np.rint((samples - self.low) / self.span * 65534 - 32767), -32768, 32767).astype(np.int16)

    def fit(self, samples: Any, classes: Any) -> Tree:
        self.low, self.span = samples.min(axis=0), np.ptp(samples, axis=0)
        self.span[self.span == 0] = 1
        self.tree.fit(self.whole(samples), classes)
        return self

    def predict(self, samples: Any) -> Any:
        return self.tree.predict(self.whole(samples))

    def code(self, core: str) -> tuple[int, int]:
        """Returns flash and instructions."""
        with tempfile.TemporaryDirectory() as temporary:
            folder = Path(temporary)
            converted = emlearn.convert(self.tree, method="inline", dtype="int16_t")
            converted.save(file=str(folder / "tree.h"), name="tree", format="c")
            inputs = len(self.low)
            glue = f'#include "tree.h"\nint decide(const int16_t *x) {{ return tree_tree_0(x, {inputs}); }}\n'
            (folder / "tree.c").write_text(glue)
            gcc = ["arm-none-eabi-gcc", *CORES[core], "-mthumb", "-Os", "-std=c99", f"-I{emlearn.includedir}"]
            gcc += ["-ffunction-sections", "-fdata-sections", "-c", "tree.c", "-o", "tree.o"]
            subprocess.run(gcc, check=True, cwd=folder, stderr=subprocess.DEVNULL)
            # Only what the decision reaches.
            kept = ["arm-none-eabi-ld", "-r", "--gc-sections", "-e", "decide", "tree.o", "-o", "kept.o"]
            subprocess.run(kept, check=True, cwd=folder)
            flash = flash_of(folder / "kept.o")
            if flash > LARGEST:
                return flash, 0  # too large for the table
            bound = [str(BOUND), str(folder / "kept.o"), "decide", "--json"]
            told = subprocess.run(bound, check=True, capture_output=True, text=True).stdout
            return flash, int(json.loads(told.splitlines()[0])["instructions"])


@dataclass(frozen=True)
class Problem:
    """Samples with their classes, and the folds of a cross-validation."""

    name: str
    samples: Any
    classes: Any
    folds: list[Any]

    @classmethod
    def of(cls, name: str) -> Problem:
        samples, classes = DATA[name](return_X_y=True)
        return cls(name, samples, classes, list(StratifiedKFold(5, shuffle=True, random_state=0).split(samples, classes)))

    def models(self, make: Any) -> list[Any]:
        """Returns a model of the training samples of each fold."""
        return [make(self.samples[train], self.classes[train]) for train, _ in self.folds]

    def right(self, models: list[Any]) -> int:
        """Returns how many samples the models that were not trained on them classify well."""
        pairs = zip(models, self.folds, strict=True)
        return sum(int(np.sum(model.predict(self.samples[test]) == self.classes[test])) for model, (_, test) in pairs)

    def row(self, of: str, right: int, sizes: list[tuple[int, int]] | None) -> None:
        """Prints a line of the table."""
        figures = ["–"] * 4 if sizes is None else [f"{figure:,}" for pair in sizes for figure in pair]
        print("| " + " | ".join([self.name, of, wilson(right, len(self.classes)), *figures]) + " |", flush=True)


def wilson(right: int, count: int) -> str:
    """Returns a share with its 95 % interval, in per cent."""
    share, z = right / count, 1.96
    middle, half = share + z * z / (2 * count), z * np.sqrt(share * (1 - share) / count + z * z / (4 * count * count))
    low, high = ((middle + side * half) / (1 + z * z / count) for side in (-1, 1))
    return f"{100 * share:.1f} ({100 * low:.1f} to {100 * high:.1f})"


def medians(sizes: list[list[tuple[int, int]]]) -> list[tuple[int, int]]:
    """Returns the median flash and instructions on each core."""
    return [(int(flash), int(instructions)) for flash, instructions in np.median(np.array(sizes), axis=0)]


def code(graph: Any) -> list[tuple[int, int]]:
    """Returns flash and instructions of a graph on each core, in the profile that takes fewest instructions."""
    sizes = graph.report(*CORES).data["sizes"]
    known = [one for one in sizes if one["instructions"] is not None]
    fastest = [min((one for one in known if one["target"] == core), key=lambda one: one["instructions"]) for core in CORES]
    return [(one["linked_flash"], one["instructions"]) for one in fastest]


def regression(samples: Any, classes: Any) -> Any:
    return make_pipeline(StandardScaler(), LogisticRegression(max_iter=1000)).fit(samples, classes)


def best_tree(problem: Problem) -> tuple[int, list[tuple[int, int]]]:
    """Returns how many samples trees classify well, and their code, of the best number of leaves that fits."""
    found = []
    for leaves in LEAVES:
        make = lambda samples, classes, leaves=leaves: Tree(leaves).fit(samples, classes)  # noqa: E731
        trees = problem.models(make)
        sizes = medians([[tree.code(core) for core in CORES] for tree in trees])
        if sizes[0][0] <= LARGEST:
            found.append((problem.right(trees), sizes))
    return max(found, key=lambda one: one[0])


def main() -> None:
    arguments = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    arguments.add_argument("--steps", type=int, default=2_000_000)
    arguments.add_argument("--only", choices=DATA)
    arguments.add_argument("--line-price", type=float, help="selection.line_price: smaller policies")
    given = arguments.parse_args()

    def ours(samples: Any, classes: Any) -> Any:
        settings = {} if given.line_price is None else {"selection.line_price": given.line_price}
        return TPGClassifier(total_timesteps=given.steps, settings=settings, random_state=1).fit(samples, classes)

    print("| data | classifier | accuracy, % | flash, M0 | instructions, M0 | flash, M4F | instructions, M4F |")
    print("| --- | --- | --- | --- | --- | --- | --- |")
    for name in [given.only] if given.only else DATA:
        problem = Problem.of(name)
        models = problem.models(ours)
        problem.row("`TPGClassifier`", problem.right(models), medians([code(model.model_.graph) for model in models]))
        for bits in (16, 8):
            whole = [Integers(model, bits) for model in models]
            sizes = medians([code(one.graph) for one in whole])
            problem.row(f"in integers of {bits} bits", problem.right(whole), sizes)
        problem.row("emlearn, inline tree", *best_tree(problem))
        problem.row("logistic regression", problem.right(problem.models(regression)), None)


if __name__ == "__main__":
    main()
