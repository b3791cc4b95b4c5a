"""Names of what Gymnasium's environments observe and do: an environment itself does not say them."""

from __future__ import annotations

from typing import Any

import gymnasium
import numpy as np
from gymnasium import spaces

_LANDER = ("x", "y", "vx", "vy", "angle", "spin", "left_leg", "right_leg")
_WALKER = (
    *("hull_angle", "hull_spin", "vx", "vy"),
    *("hip_1_angle", "hip_1_speed", "knee_1_angle", "knee_1_speed", "contact_1"),
    *("hip_2_angle", "hip_2_speed", "knee_2_angle", "knee_2_speed", "contact_2"),
    *(f"lidar_{ray}" for ray in range(10)),
)
_HOPPER = ("thigh", "leg", "foot")
_CHEETAH = ("back_thigh", "back_shin", "back_foot", "front_thigh", "front_shin", "front_foot")
_WALKER2D = ("right_thigh", "right_leg", "right_foot", "left_thigh", "left_leg", "left_foot")


def _body(joints: tuple[str, ...]) -> tuple[str, ...]:
    """Returns the names of the values of a body in a plane: its pose, the angles of its joints, and the speeds of all."""
    angles, speeds = (tuple(f"{joint}_{of}" for joint in joints) for of in ("angle", "speed"))
    return ("height", "pitch", *angles, "vx", "vz", "pitch_speed", *speeds)


# The values of an observation, and the actions or the values of an action.
_NAMES: dict[tuple[str, type[spaces.Space[Any]]], tuple[tuple[str, ...], tuple[str, ...]]] = {
    ("LunarLander", spaces.Discrete): (_LANDER, ("none", "left_engine", "main_engine", "right_engine")),
    ("LunarLander", spaces.Box): (_LANDER, ("main_engine", "side_engine")),
    ("LunarLanderContinuous", spaces.Box): (_LANDER, ("main_engine", "side_engine")),
    ("BipedalWalker", spaces.Box): (_WALKER, ("hip_1", "knee_1", "hip_2", "knee_2")),
    ("BipedalWalkerHardcore", spaces.Box): (_WALKER, ("hip_1", "knee_1", "hip_2", "knee_2")),
    ("InvertedPendulum", spaces.Box): (("x", "theta", "v", "omega"), ("force",)),
    ("InvertedDoublePendulum", spaces.Box): (
        ("x", "sin_1", "sin_2", "cos_1", "cos_2", "v", "omega_1", "omega_2", "constraint"),
        ("force",),
    ),
    ("Reacher", spaces.Box): (
        ("cos_1", "cos_2", "sin_1", "sin_2", "target_x", "target_y", "speed_1", "speed_2", "off_x", "off_y"),
        ("shoulder", "elbow"),
    ),
    ("Swimmer", spaces.Box): (
        ("angle", "angle_1", "angle_2", "vx", "vy", "spin", "speed_1", "speed_2"),
        ("rotor_1", "rotor_2"),
    ),
    ("Hopper", spaces.Box): (_body(_HOPPER), _HOPPER),
    ("HalfCheetah", spaces.Box): (_body(_CHEETAH), _CHEETAH),
    ("Walker2d", spaces.Box): (_body(_WALKER2D), _WALKER2D),
}


def names_of(env: gymnasium.Env[Any, Any], inputs: int) -> tuple[tuple[str, ...], tuple[str, ...] | None]:
    """Returns the names of an observation's values, none where they are not known or not `inputs`; and of the actions."""
    spec = getattr(env, "spec", None)
    if spec is None or spec.namespace is not None:
        return (), None
    values, ends = _NAMES.get((spec.name, type(env.action_space)), ((), ()))
    size = getattr(env.action_space, "n", None) or np.prod(env.action_space.shape or (0,))
    return values if len(values) == inputs else (), ends if ends and len(ends) == size else None
