# SPDX-License-Identifier: MPL-2.0
# %% [markdown]
# # What clogged the chip?
# Reads a run with fines into arrays. `make demo` makes the run; from the folder of porefines:
#
#     PYTHONPATH=python python3 python/examples/clogging.py out/micromodel/fines
#
# The `# %%` cells open as a notebook in VS Code, Spyder or Jupyter (jupytext).

# %%
import sys

import numpy as np

import porefines

run = porefines.read(sys.argv[1] if len(sys.argv) > 1 else "out/micromodel/fines")
print(run.summary["title"])

# %% [markdown]
# ## Permeability against pore volumes injected

# %%
volumes = run.series["pore_volumes"]
ratio = run.series["permeability_ratio"]
print(f"k0 = {run.summary['permeability_clean_m2'] / porefines.DARCY:.4g} darcy")
print(f"k/k0 = {ratio[-1]:.3f} after {volumes[-1]:.3g} pore volumes")

# %% [markdown]
# ## When did which throat clog, and what did it cost?
# k/k0 just before each event, and at the end.

# %%
for time, throat, kind, event in zip(*(run.clogging[name] for name in ("time_s", "throat", "kind", "event"))):
    if event == "clogged":
        before = ratio[np.searchsorted(run.series["time_s"], time) - 1]
        width = run.throats["width_m"][int(throat)]
        print(f"{1e3 * time:.4g} ms: throat {throat:.0f}, {1e6 * width:.3g} um wide, by a {kind}; k/k0 was {before:.3f}")

# %% [markdown]
# ## How fast are fines, compared with the water?

# %%
mobile = run.tracks.where(run.tracks["state"] == "mobile")
speed = np.sqrt(mobile["u_m_s"] ** 2 + mobile["v_m_s"] ** 2 + mobile["w_m_s"] ** 2)
print(f"fines: mean {1e3 * speed.mean():.3g} mm/s, fastest {1e3 * speed.max():.3g} mm/s")
fields = run.fields()
water = fields.speed[fields.solid_fraction < 0.5]
print(f"water: mean {1e3 * water.mean():.3g} mm/s in the pores at the end")

# %% [markdown]
# ## Where are the retained fines?

# %%
profile = run.retention()
last = profile["retained"][-1]
for x, count in zip(profile["x_m"], last):
    if count > 0:
        print(f"x = {1e6 * x:.4g} um: {count:.0f} retained")

# %% [markdown]
# ## A figure, where matplotlib is there

# %%
try:
    import matplotlib.pyplot as plt
except ImportError:
    print("no matplotlib (Debian: python3-matplotlib): no figure")
else:
    figure, axes = plt.subplots(figsize=(5, 3.2), layout="constrained")
    axes.plot(volumes, ratio)
    axes.set(xlabel="pore volumes injected", ylabel="k / k0", ylim=(0, None))
    figure.savefig("permeability_ratio.pdf")
    print("written: permeability_ratio.pdf")
