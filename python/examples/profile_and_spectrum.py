# %% [markdown]
# # Velocity profile and surface spectrum of a run
#
# Opens the results of a run and draws the mean velocity over the depth, beside the column twin where the run has one, and
# the spectrum of the free surface. It needs the fields /profiles and /surface: a tank has no profiles, a duct no surface. Runs as a script, or cell by cell in an editor that knows `# %%` (VS Code, Spyder, Jupyter with jupytext):
#
#     PYTHONPATH=python python3 python/examples/profile_and_spectrum.py results/my-flume figure.png

# %%
import sys

import numpy as np

from riffle_results import ResultsError, open_results

arguments = sys.argv[1:] if len(sys.argv) > 1 and not sys.argv[1].startswith("-") else []
folder = arguments[0] if arguments else "results/demo"
picture = arguments[1] if len(arguments) > 1 else None

# %% [markdown]
# Nothing is read until it is used; `load()` reads what is still wanted once the file is closed.

# %%
with open_results(folder) as run:
    print(run)
    title = run.title
    try:
        profiles, surface = run.profiles.load(), run.surface.load()
    except ResultsError as error:
        sys.exit(f"{error}\nThis example draws /profiles and /surface; of another kind of flow, `riffle analyse` says what there is.")
    try:
        column = run.column.load()
    except ResultsError:
        column = None  # around bodies and between open ends the flow has no twin

velocity = profiles.velocity
print(f"{velocity.attrs['long_name']} ({velocity.attrs['units']}) over {profiles.sizes['layer']} layers, "
      f"averaged from {profiles.attrs['window_start']:.2f} to {profiles.attrs['window_end']:.2f} s")

# %% [markdown]
# A plain periodogram in time of the elevation about the mean of each instant, averaged over all x: enough for a look.
# `riffle analyse` estimates spectra by Welch's method, with confidence intervals; `riffle_results.read_analysis` opens what it writes.

# %%
fluctuation = surface.elevation.astype(float) - surface.elevation.mean("x")
interval = float(np.median(np.diff(surface.time)))
frequency = np.fft.rfftfreq(surface.sizes["time"], interval)[1:]
transform = np.fft.rfft(fluctuation.values, axis=0)[1:]
spectrum = 2 * interval / surface.sizes["time"] * (np.abs(transform) ** 2).mean(axis=1)  # one-sided, m2 s
print(f"surface: standard deviation {1e6 * float(fluctuation.std()):.2f} µm, {frequency.size} frequencies up to "
      f"{frequency[-1]:.1f} Hz")

# %%
try:
    import matplotlib
except ImportError:
    print("matplotlib is not installed (Debian: python3-matplotlib): no figure")
    sys.exit()

if picture:
    matplotlib.use("Agg")  # no window
import matplotlib.pyplot as plt

figure, (left, right) = plt.subplots(1, 2, figsize=(10, 4.5), layout="constrained")
if column is not None:
    left.plot(column.velocity, 1000 * column.z, color="#D55E00", label="column twin")
left.errorbar(velocity, 1000 * profiles.z, xerr=profiles.velocity_half_width, fmt="o", markersize=4, color="#0072B2",
              label="simulated, 95 %")
left.set(xlabel="mean velocity $u$ (m/s)", ylabel="$z$ above the bed level (mm)")
left.legend()
right.loglog(frequency, spectrum, color="#0072B2")
right.set(xlabel="frequency (Hz)", ylabel="spectrum of the surface elevation (m² s)")
figure.suptitle(title)
if picture:
    figure.savefig(picture, dpi=150)
    print(picture)
else:
    plt.show()
