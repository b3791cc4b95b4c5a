#!/usr/bin/env python3
"""A classifier that asks a network where it is unsure, beside each of them alone and a small network before a large one.

    python3 -m venv peers && peers/bin/pip install ./python emlearn==0.23.2 scikit-learn==1.9.1
    peers/bin/python benches/peers/asking.py [--only digits]

Accuracy is that of all samples in a stratified 5-fold cross-validation, with its 95 % interval (Wilson); instructions are the mean of
a decision, over the unseen samples of all folds, counted by QEMU's user mode in C compiled for a Cortex-M4F with -Os. Networks have
weights of 8 bits. The cascade answers by the small network where its two highest outputs are apart, in floats, which cost nothing
here; its margin is chosen as the graph's. Prints a table in Markdown.
"""

from __future__ import annotations

import argparse
import subprocess
import tempfile
from pathlib import Path
from typing import Any

import numpy as np
from labels import DATA, Problem, wilson
from sklearn.model_selection import train_test_split
from sklearn.neural_network import MLPClassifier
from sklearn.pipeline import make_pipeline
from sklearn.preprocessing import StandardScaler

from tpg_train import TPGClassifier

PRICES = (0.1, 0.03)
UNITS = (8, 64)
# emlearn lets numpy raise where a weight of a network is subnormal.
np.seterr(under="ignore")
CORE = ["-mcpu=cortex-m4", "-mthumb", "-mfloat-abi=hard", "-mfpu=fpv4-sp-d16"]
PROGRAM = """
#include "{header}"
static const {kind} rows[] = {{ {rows} }};
static volatile unsigned last;
void _start(void)
{{
    for (unsigned i = 0; i < {count}U; i++) {{
        last = (unsigned){function}(&rows[i]);
    }}
    __asm__ volatile("movs r7, #1; movs r0, #0; svc 0"); /* exit(0) */
}}
"""


def network(units: int) -> MLPClassifier:
    return MLPClassifier((units,), max_iter=1000, random_state=1)


class Asking:
    """A classifier, and what it says of itself."""

    def __init__(self, price: float, units: int) -> None:
        self.model = TPGClassifier(network=network(units), price=price, random_state=1)

    def fit(self, samples: Any, classes: Any) -> Asking:
        self.model.fit(samples, classes)
        return self

    def predict(self, samples: Any) -> Any:
        return self.model.predict(samples)

    def asked(self, samples: Any) -> float:
        graph = self.model.model_.graph
        answers = graph.answers(np.ascontiguousarray(samples, np.float32).astype(np.float64))
        return float(np.mean(answers == len(self.model.classes_)))


class Alone:
    """The network of a classifier."""

    def __init__(self, asking: Asking) -> None:
        self.model = asking.model

    def predict(self, samples: Any) -> Any:
        return self.model.classes_[self.model.network_.predict(samples)[0]]


class Cascade:
    """A small network that answers where its outputs are apart, else a large one."""

    def __init__(self, price: float, samples: Any, classes: Any) -> None:
        taught, held, known, expected = train_test_split(samples, classes, test_size=0.2, random_state=1, stratify=classes)
        self.nets = [make_pipeline(StandardScaler(), network(units)).fit(taught, known) for units in UNITS]
        margins = np.quantile(self.margin(held), np.linspace(0, 1, 41))
        worth = [self.answers(held, margin) for margin in margins]
        self.least = margins[int(np.argmax([np.mean(found == expected) - price * asked.mean() for found, asked in worth]))]

    def margin(self, samples: Any) -> Any:
        """Returns how far the two highest outputs of the small network are apart, before the softmax."""
        outputs = np.sort(np.log(np.maximum(self.nets[0].predict_proba(samples), 1e-300)), axis=1)
        return outputs[:, -1] - outputs[:, -2]

    def answers(self, samples: Any, margin: float) -> tuple[Any, Any]:
        asked = self.margin(samples) < margin
        return np.where(asked, self.nets[1].predict(samples), self.nets[0].predict(samples)), asked

    def predict(self, samples: Any) -> Any:
        return self.answers(samples, self.least)[0]

    def asked(self, samples: Any) -> float:
        return float(self.answers(samples, self.least)[1].mean())


def instructions(folder: Path, header: str, kind: str, function: str, samples: Any) -> float:
    """Returns the mean instructions of a call for each sample."""
    rows = ", ".join("{ { " + ", ".join(f"{np.float32(value)!s}F" for value in row) + " } }" for row in samples.astype(float))
    counts = []
    for count in (0, len(samples)):
        text = PROGRAM.format(header=header, kind=kind, rows=rows, count=count, function=function)
        (folder / "main.c").write_text(text)
        sources = [str(path) for path in folder.glob("*.c")]
        gcc = [
            "arm-none-eabi-gcc",
            *CORE,
            "-Os",
            "-std=gnu99",
            "-nostartfiles",
            "-Wl,-Ttext=0x10000",
            *sources,
            "-lm",
        ]
        subprocess.run([*gcc, "-o", "main.elf"], check=True, cwd=folder)
        # A larger core with the same instructions: QEMU's user mode has no Cortex-M.
        qemu = [
            "qemu-arm",
            "-cpu",
            "cortex-a9",
            "-singlestep",
            "-d",
            "nochain,exec",
            "-D",
            "/dev/stdout",
            "./main.elf",
        ]
        with subprocess.Popen(qemu, cwd=folder, stdout=subprocess.PIPE) as run:
            assert run.stdout is not None
            counts.append(sum(line.startswith(b"Trace") for line in run.stdout))
        if run.returncode != 0:
            raise SystemExit(f"QEMU ends with {run.returncode}")
    return (counts[1] - counts[0]) / len(samples)


def cost(problem: Problem, models: list[TPGClassifier], function: str) -> float:
    """Returns the mean instructions of the graphs (`policy_infer`), their networks (`policy_network_infer`) or both (`policy_decide`)."""
    header = function.removesuffix("_infer")
    state = "policy_state_t" if function == "policy_decide" else f"{header}_state_t"
    counts = []
    for model, (_, test) in zip(models, problem.folds, strict=True):
        with tempfile.TemporaryDirectory() as temporary:
            model.model_.export_c(temporary, prefix="policy", network=getattr(model, "network_", None))
            counts.append(instructions(Path(temporary), f"{header}.h", state, function, problem.samples[test]))
    return float(np.mean(counts))


def main() -> None:
    arguments = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    arguments.add_argument("--only", choices=DATA, default="digits")
    problem = Problem.of(arguments.parse_args().only)
    count = len(problem.classes)
    print("| classifier | accuracy, % | network asked, % | instructions, M4F |")
    print("| --- | --- | --- | --- |")

    def row(name: str, right: int, asked: float | None, mean: float) -> None:
        share = "" if asked is None else f"{100 * asked:.1f}"
        print(f"| {name} | {wilson(right, count)} | {share} | {mean:,.0f} |", flush=True)

    def share(models: list[Any]) -> float:
        pairs = zip(models, problem.folds, strict=True)
        return float(np.mean([model.asked(problem.samples[test]) for model, (_, test) in pairs]))

    def fitted(price: float, units: int) -> list[Asking]:
        return problem.models(lambda samples, classes: Asking(price, units).fit(samples, classes))

    alone = problem.models(lambda samples, classes: TPGClassifier(random_state=1).fit(samples, classes))
    row("graph", problem.right(alone), None, cost(problem, alone, "policy_infer"))
    asking = {price: fitted(price, UNITS[1]) for price in PRICES}
    costs = []
    for units, models in zip(UNITS, (fitted(PRICES[0], UNITS[0]), asking[PRICES[0]]), strict=True):
        costs.append(cost(problem, [one.model for one in models], "policy_network_infer"))
        row(f"network of {units} units", problem.right([Alone(one) for one in models]), None, costs[-1])
    for price, models in asking.items():
        mean = cost(problem, [one.model for one in models], "policy_decide")
        row(f"graph that asks, price {price}", problem.right(models), share(models), mean)
    for price in PRICES:
        cascades = problem.models(lambda samples, classes, price=price: Cascade(price, samples, classes))
        asked = share(cascades)
        row(f"cascade, price {price}", problem.right(cascades), asked, costs[0] + asked * costs[1])


if __name__ == "__main__":
    main()
