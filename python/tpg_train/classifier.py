"""A classifier with scikit-learn's interface: its classes are a graph's actions, a sample is an episode of one step."""

from __future__ import annotations

import re
import warnings
from collections.abc import Mapping
from typing import Any

import numpy as np
from gymnasium.spaces import Box, Discrete
from numpy.typing import ArrayLike, NDArray

from ._tpg import InputError, Samples
from .model import TPG, PathLike, _Described
from .network import NetworkPolicy, _in_integers, _Normaliser
from .spaces import MOST_NAMES, Interface, _unique

try:
    from sklearn.base import BaseEstimator, ClassifierMixin, clone
    from sklearn.exceptions import ConvergenceWarning
    from sklearn.linear_model import LogisticRegression
    from sklearn.model_selection import StratifiedKFold
    from sklearn.pipeline import make_pipeline
    from sklearn.preprocessing import StandardScaler
    from sklearn.utils import check_random_state, compute_sample_weight
    from sklearn.utils.multiclass import check_classification_targets
    from sklearn.utils.validation import _check_sample_weight, check_is_fitted, validate_data
except ImportError as error:
    raise ImportError(f"{error}; TPGClassifier needs scikit-learn 1.8 or newer: pip install 'tpg-train[sklearn]'") from error

# Inverse strengths of the penalty on weights of the logistic regressions that evolution begins with.
STRENGTHS = (1.0, 0.3, 0.1, 0.03, 0.01)
# Differences between the two highest bids, of which one decides whether a network is asked.
MARGINS = (0.0, *(2.0 ** (step / 2) for step in range(-16, 17)))


class TPGClassifier(ClassifierMixin, BaseEstimator):  # type: ignore[misc, unused-ignore]
    """Evolves a tangled program graph that names the class of a sample.

    Args:
        total_timesteps: samples that are classified in training, by all policies together.
        preset, settings, scalar, verbose: as of `TPG`.
        class_weight: the score of naming a class: None, "balanced" or a dictionary, as in scikit-learn.
        validation_fraction: the part of each class that is not trained on, but chooses the policy. Where that is no sample, all
            of them choose.
        network: an `MLPClassifier` with `activation="relu"`, which is fitted to all samples, scaled. The graph asks it where its
            two highest bids are close; how close, five more pairs of graph and network decide by cross-validation.
        price: of asking the network once: where 0.1, the graph asks if that corrects one answer in ten.
        n_jobs: threads; None for 1, -1 for all cores. The graph is the same for any number.
        random_state: decides everything beside the samples, whose order does not matter.

    Attributes: `classes_`, `n_features_in_`; `model_`, a `TPG` whose actions are the classes, with everything that one has except
    an environment: `model_.export_c(...)`, `model_.report("m0")`, `model_.quantise()`, `model_.save(...)`; with a network,
    `network_`, a `NetworkPolicy` in integers: `model_.export_c(..., network=network_)` writes one C function of both.
    """

    def __init__(
        self,
        *,
        total_timesteps: int | float = 2_000_000,
        preset: PathLike = "labels",
        settings: Mapping[str, Any] | None = None,
        class_weight: str | Mapping[Any, float] | None = None,
        validation_fraction: float = 0.2,
        network: Any = None,
        price: float = 0.1,
        scalar: str | None = None,
        n_jobs: int | None = None,
        random_state: Any = None,
        verbose: int = 0,
    ) -> None:
        self.total_timesteps = total_timesteps
        self.preset = preset
        self.settings = settings
        self.class_weight = class_weight
        self.validation_fraction = validation_fraction
        self.network = network
        self.price = price
        self.scalar = scalar
        self.n_jobs = n_jobs
        self.random_state = random_state
        self.verbose = verbose

    def fit(self, X: ArrayLike, y: ArrayLike, sample_weight: ArrayLike | None = None) -> TPGClassifier:
        """Evolves a graph. A sample of weight 2 counts as two, one of weight 0 not at all."""
        values, labels = validate_data(self, X, y, dtype=np.float64 if self.scalar == "f64" else np.float32)
        values = values.astype(np.float64)
        check_classification_targets(labels)
        weights = _check_sample_weight(sample_weight, values, dtype=np.float64, ensure_non_negative=True)
        weights = weights * compute_sample_weight(self.class_weight, labels)
        self.classes_, codes = np.unique(labels[weights > 0], return_inverse=True)
        if len(self.classes_) < 2:
            raise InputError("y of one class; accepted: samples of two classes or more, with weights above 0")
        if not 0 <= self.validation_fraction < 1:
            raise InputError(f"validation_fraction = {self.validation_fraction}; accepted: from 0, below 1")
        if self.network is not None and (type(self.network).__name__ != "MLPClassifier" or self.network.activation != "relu"):
            raise InputError(f"network = {self.network}; accepted: an MLPClassifier with activation='relu'")
        if not self.price >= 0:
            raise InputError(f"price = {self.price}; accepted: 0 or more")
        seed = int(check_random_state(self.random_state).randint(2**31 - 1))
        values, codes, weights = _merged(values[weights > 0], codes, weights[weights > 0])
        order, training = _split(codes, self.validation_fraction, np.random.default_rng(seed))
        names = getattr(self, "feature_names_in_", None)
        chosen = {"selection.validation_episodes": len(order) - training or training, **(self.settings or {})}
        low, high = values.min(axis=0), values.max(axis=0)
        # An input that does not vary has a range, too: its counts need one.
        inputs = Box(low, np.where(low < high, high, low + 1), dtype=np.float64)
        with TPG(
            _Described(inputs, Discrete(len(self.classes_))),
            seed=seed,
            native=False,
            preset=self.preset,
            settings=chosen,
            max_episode_steps=1,
            input_names=None if names is None or len(names) > MOST_NAMES else list(names),
            action_names=_unique([_name_of(label) for label in self.classes_]),
            scalar=self.scalar,
            verbose=self.verbose,
            n_workers=0 if self.n_jobs == -1 else self.n_jobs or 1,
        ) as model:
            scores = weights / weights.mean()
            space = model._interface.space()
            linear = _linear(values[order[:training]], codes[order[:training]], scores[order[:training]], seed)
            classes = codes[order].astype(np.uint16)
            model._samples = Samples(space, values[order], classes, scores[order], training, linear)
            model.learn(self.total_timesteps)
            graph = model._best()
            if self.network is not None:
                graph = graph.asking(self._margin(values, codes, weights, seed))
                fitted = _fitted(self.network, values, codes, weights, seed)
                self.network_ = _in_network(fitted, model._interface, values)
            self.model_ = TPG._of(graph, type(self).__name__, model.hall_of_fame)
        return self

    def predict(self, X: ArrayLike) -> NDArray[Any]:
        """Returns the class of each sample."""
        check_is_fitted(self)
        graph = self.model_.graph
        values = validate_data(self, X, dtype=np.float64 if graph.scalar == "f64" else np.float32, reset=False)
        codes = graph.answers(np.ascontiguousarray(values, dtype=np.float64))
        asked = codes == len(self.classes_)
        if asked.any():
            codes[asked] = self.network_.predict(values[asked])[0]
        answers: NDArray[Any] = self.classes_[codes]
        return answers

    def _margin(self, values: NDArray[np.float64], codes: NDArray[np.intp], weights: NDArray[np.float64], seed: int) -> float:
        """Returns the margin between bids below which asking is worth most, on samples that neither of the two has seen."""
        fewest = int(np.bincount(codes).min())
        if fewest < 2:
            raise InputError("a class of one sample; accepted: two or more of each class, with a network")
        worth = np.zeros(len(MARGINS))
        for taught, unseen in StratifiedKFold(min(5, fewest), shuffle=True, random_state=seed).split(values, codes):
            given = values[taught], codes[taught], weights[taught]
            alone = clone(self).set_params(network=None, class_weight=None, random_state=seed).fit(*given)
            network_is_right = _fitted(self.network, *given, seed).predict(values[unseen]) == codes[unseen]
            for place, margin in enumerate(MARGINS):
                found = alone.model_.graph.asking(margin).answers(values[unseen])
                scores = np.where(found == len(alone.classes_), network_is_right - self.price, found == codes[unseen])
                worth[place] += np.sum(scores * weights[unseen])
        return float(MARGINS[int(np.argmax(worth))])


def _merged(
    values: NDArray[np.float64], codes: NDArray[np.intp], weights: NDArray[np.float64]
) -> tuple[NDArray[np.float64], NDArray[np.intp], NDArray[np.float64]]:
    """Returns samples in an order of their own, equal ones as one: a sample of weight 2 is the same as two samples."""
    rows, places = np.unique(np.column_stack([values, codes]), axis=0, return_inverse=True)
    return rows[:, :-1], rows[:, -1].astype(np.intp), np.bincount(places.ravel(), weights).astype(np.float64)


def _split(codes: NDArray[np.intp], fraction: float, random: np.random.Generator) -> tuple[NDArray[np.intp], int]:
    """Returns an order of samples, the same part of each class last, and the number of those before them."""
    order = random.permutation(len(codes))
    held = np.zeros(len(codes), dtype=bool)
    for code in np.unique(codes):
        rows = order[codes[order] == code]
        held[rows[: int(fraction * len(rows))]] = True
    return np.concatenate([order[~held[order]], order[held[order]]]), int(np.count_nonzero(~held))


def _linear(
    values: NDArray[np.float64], codes: NDArray[np.intp], weights: NDArray[np.float64], seed: int
) -> list[list[list[float]]]:
    """Returns logistic regressions with fewer and fewer weights: for each class those of the inputs, and a constant."""
    mean, deviation = values.mean(axis=0), values.std(axis=0)
    deviation[deviation == 0] = 1
    policies = []
    for strength in STRENGTHS:
        fitted = LogisticRegression(l1_ratio=1, C=strength, solver="saga", tol=1e-3, random_state=seed)
        with warnings.catch_warnings():
            warnings.simplefilter("ignore", ConvergenceWarning)
            fitted.fit((values - mean) / deviation, codes, sample_weight=weights)
        # Few digits, which do not depend on how a library adds.
        rows = np.vectorize(lambda weight: float(f"{weight:.3g}"))(fitted.coef_ / deviation)
        constants = [float(f"{constant:.6g}") for constant in fitted.intercept_ - rows @ mean]
        table = np.column_stack([rows, constants])
        policies.append((table if len(table) > 1 else np.vstack([np.zeros_like(table), table])).tolist())
    return policies


def _fitted(network: Any, values: NDArray[np.float64], codes: NDArray[np.intp], weights: NDArray[np.float64], seed: int) -> Any:
    """Fits a copy of a network to samples, behind a scaler."""
    one = clone(network)
    if one.random_state is None:
        one.random_state = seed
    return make_pipeline(StandardScaler(), one).fit(values, codes, mlpclassifier__sample_weight=weights)


def _in_network(fitted: Any, interface: Interface, values: NDArray[np.float64]) -> NetworkPolicy:
    """Puts a fitted network into integers, calibrated on samples."""
    scaler, network = fitted
    pairs = zip(network.coefs_, network.intercepts_, strict=True)
    layers = [(np.ascontiguousarray(matrix.T, np.float32), bias.astype(np.float32)) for matrix, bias in pairs]
    last, bias = layers[-1]
    if len(bias) == 1:
        layers[-1] = np.vstack([np.zeros_like(last), last]), np.append(np.float32(0), bias)
    normaliser = _Normaliser(scaler.mean_, scaler.scale_)
    return _in_integers(layers, interface, "clamp", values.astype(np.float32), normaliser, "w8a16")


def _name_of(label: Any) -> str:
    """Returns a class's name: its label where that is a name, else `class_` and the label."""
    name = re.sub(r"\W", "_", str(label), flags=re.ASCII)
    return name if name[:1].isalpha() and name == str(label) else f"class_{name}"
