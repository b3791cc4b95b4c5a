# %% [markdown]
# # The robot arm
#
# A WidowX reaches for targets. Importing `tpg_train` registers it with Gymnasium, for this library and for any other.

# %%
import gymnasium

import tpg_train

env = gymnasium.make("tpg_train/WidowX-v0")  # four motors, whose values are the action
print(env.observation_space.shape, env.action_space)

# %% [markdown]
# The same arm with named moves, from its home position. A good policy takes minutes: `tpg-train tpg --problem fs`.

# %%
model = tpg_train.TPG("tpg_train/WidowXFixedDiscrete-v0", seed=1, population=60, verbose=1)
model.learn(total_timesteps=300_000)
print(model.evaluate(50))
print(model.formula())
model.export_c("policy", prefix="reach")
print(model.verify())
