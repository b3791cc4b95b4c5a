# %% [markdown]
# # CartPole to C in a minute
#
# A policy that balances a pole, as a C function of some two hundred bytes, proven to act as the policy that was trained.

# %%
from tpg_train import TPG

model = TPG("CartPole-v1", seed=1, verbose=1)
model.learn(total_timesteps=500_000, target=475)

# %% [markdown]
# The environment ran as a built-in problem, a hundred times as fast as in Python. Gymnasium's own says the same:

# %%
print("built in:  ", model.evaluate(1000))
print("Gymnasium: ", model.evaluate(20, native=False))

# %% [markdown]
# The policy can be read, and `model.graph` draws itself.

# %%
print(model.formula())
print(model.report("m4f"))
model.graph

# %% [markdown]
# `verify` compiles the C and compares its answers with the interpreter's, bit for bit.

# %%
print(*model.export_c("policy", prefix="cart"), sep="\n")
print(model.verify())
model.save("cart.json")

# %% [markdown]
# A smaller policy may do: the hall of fame holds the best one of each size.

# %%
for entry in model.hall_of_fame:
    print(entry.size, entry.score)
