# %% [markdown]
# # An environment of your own: a buck converter
#
# A switch, a coil and a capacitor make 5 V out of 12 V. The controller sees voltage and current and sets the duty cycle,
# ten thousand times a second; the load changes without notice.

# %%
from typing import Any

import gymnasium
import numpy as np
from gymnasium import spaces

from tpg_train import TPG

SUPPLY, WANTED, COIL, CAPACITOR, STEP = 12.0, 5.0, 100e-6, 220e-6, 1e-4


class BuckConverter(gymnasium.Env[Any, Any]):
    """Observation: error of the voltage (V) and its integral (mV·s), current (A). Action: duty cycle."""

    observation_space = spaces.Box(-np.inf, np.inf, (3,), np.float32)
    action_space = spaces.Box(0.0, 1.0, (1,), np.float32)

    def reset(self, *, seed: int | None = None, options: Any = None) -> tuple[Any, dict[str, Any]]:
        super().reset(seed=seed)
        self.voltage, self.current, self.integral, self.steps = 0.0, 0.0, 0.0, 0
        self.loads = self.np_random.uniform(2.0, 20.0, 3)  # ohms, one after another
        return self.observe(), {}

    def observe(self) -> Any:
        return np.array([WANTED - self.voltage, 1e3 * self.integral, self.current], np.float32)

    def step(self, action: Any) -> tuple[Any, float, bool, bool, dict[str, Any]]:
        load = self.loads[self.steps // 50]
        for _ in range(20):  # the average over a period of the switch, in small steps
            dt = STEP / 20
            self.current = max(0.0, self.current + dt / COIL * (float(action[0]) * SUPPLY - self.voltage))
            self.voltage += dt / CAPACITOR * (self.current - self.voltage / load)
        error = WANTED - self.voltage
        self.integral = float(np.clip(self.integral + STEP * error, -0.01, 0.01))
        self.steps += 1
        return self.observe(), -abs(error), False, self.steps == 150, {}


# %% [markdown]
# The observation's ranges are unknown (±inf): they are learned from states that the policy visits.

# %%
if __name__ == "__main__":
    model = TPG(BuckConverter, input_names=["error", "integral", "current"], seed=1, verbose=1)
    model.learn(total_timesteps=150_000)
    print(model.evaluate(50))
    print(model.formula())
    print(model.report("m4f"))
    model.export_c("policy", prefix="buck")
    print(model.verify())
