#!/usr/bin/env python3
"""Write the example files of laboratory data to cases/laboratory/.

All of them are synthetic: made here by random numbers with a known answer, which stands in the comments of each file
and which the tests look for. None is a measurement. The seed is fixed, so that the files do not change.

Usage: tools/make-laboratory-examples.py [FOLDER]
"""
import pathlib
import sys

import numpy

MARK = "# SYNTHETIC: made by tools/make-laboratory-examples.py, not measured.\n"

# The flow is like condition 2 of the thesis.
DEPTH = 0.050  # m
FRICTION_VELOCITY = 0.044  # m/s
ROUGHNESS = 0.035  # m
KAPPA = 0.41

# The surface: a frozen random pattern, W(rho) = exp(-rho^2/sigma_w^2) cos(2 pi rho/L0).
CELERITY = 0.360  # m/s
PERIOD = 0.0875  # L0, m
WIDTH = 0.12  # sigma_w, m
DEVIATION = 0.40e-3  # m
INSTRUMENT_NOISE = 0.01e-3  # m

# name, x (m), offset (m), gain (m/V)
PROBES = [("P1", 0.0, -41.0e-3, 18.2e-3), ("P2", 28.0e-3, -38.5e-3, 17.6e-3), ("P3", 120.3e-3, -40.2e-3, 18.9e-3),
          ("P4", 300.3e-3, -39.7e-3, 18.4e-3)]


def surface(x, t, rng):
    """Elevation over the mean level at each x and t (m): components of equal amplitude, their wavenumbers drawn from
    the spectrum of W, a normal distribution about 2 pi/L0 of deviation sqrt(2)/sigma_w."""
    components = 600
    k = rng.normal(2 * numpy.pi / PERIOD, numpy.sqrt(2) / WIDTH, components)
    phase = rng.uniform(0, 2 * numpy.pi, components)
    amplitude = DEVIATION * numpy.sqrt(2 / components)
    eta = numpy.zeros((len(t), len(x)))
    for k_i, phase_i in zip(k, phase):
        eta += amplitude * numpy.cos(k_i * (x[None, :] - CELERITY * t[:, None]) + phase_i)
    return eta


def write_wave_probes(folder, rng):
    frequency = 100.0
    t = numpy.arange(4000) / frequency
    x = numpy.array([p[1] for p in PROBES])
    elevation = surface(x, t, rng)
    level = DEPTH + elevation + rng.normal(0, INSTRUMENT_NOISE, elevation.shape)
    volts = (level - numpy.array([p[2] for p in PROBES])) / numpy.array([p[3] for p in PROBES])
    missing = [(1, 500, 1), (1, 1200, 4), (1, 2500, 7)]  # probe, first row, rows
    for probe, first, rows in missing:
        volts[first:first + rows, probe] = numpy.nan
    spikes = numpy.sort(rng.choice(numpy.arange(50, 3950, 30), 8, replace=False))
    volts[spikes, 2] += rng.choice([-1, 1], 8) * rng.uniform(0.2, 0.5, 8)
    dropped = {3000, 3001}
    with open(folder / "wave-probes.csv", "w", encoding="utf-8") as file:
        file.write(MARK)
        file.write("# title: synthetic wave probes, like condition 2\n")
        file.write("# Four wave probes along the centreline, 40 s at 100 Hz, mean level 50 mm over the datum.\n")
        file.write(f"# Answer: celerity {CELERITY} m/s, L0 {1e3 * PERIOD} mm, sigma_w {1e3 * WIDTH:.0f} mm, standard "
                   f"deviation {1e3 * DEVIATION} mm,\n")
        sample = ", ".join(f"{1e3 * s:.4f}" for s in numpy.std(elevation, axis=0))
        file.write(f"# of this sample {sample} mm; noise of the probes {1e3 * INSTRUMENT_NOISE} mm.\n")
        file.write("# Faults: P2 misses 12 values in 3 gaps, P3 has 8 spikes, the rows of 30.00 and 30.01 s are lost.\n")
        file.write(f"# sampling_frequency: {frequency:g} Hz\n")
        for name, position, offset, gain in PROBES:
            file.write(f"# probe {name}: x = {1e3 * position:g} mm, offset = {1e3 * offset:g} mm, "
                       f"gain = {1e3 * gain:g} mm/V\n")
        file.write("t [s]," + ",".join(f"{p[0]} [V]" for p in PROBES) + "\n")
        for row, time in enumerate(t):
            if row in dropped:
                continue
            values = ",".join("" if numpy.isnan(v) else f"{v:.4f}" for v in volts[row])
            file.write(f"{time:.2f},{values}\n")


def write_calibration(folder, rng):
    with open(folder / "probe-calibration.csv", "w", encoding="utf-8") as file:
        file.write(MARK)
        file.write("# Still-water levels over the datum by point gauge, and the voltages of the wave probes.\n")
        file.write("# Answer: the lines in wave-probes.csv; the voltages scatter by 2 mV.\n")
        file.write("level [mm]," + ",".join(f"{p[0]} [V]" for p in PROBES) + "\n")
        for level in numpy.arange(0.035, 0.0651, 0.003):
            volts = [(level - p[2]) / p[3] + rng.normal(0, 0.002) for p in PROBES]
            file.write(f"{1e3 * level:.1f}," + ",".join(f"{v:.4f}" for v in volts) + "\n")


def write_profile(folder, rng):
    uncertainty = 0.003  # m/s
    with open(folder / "adv-profile.csv", "w", encoding="utf-8") as file:
        file.write(MARK)
        file.write("# title: synthetic ADV profile, like condition 2\n")
        file.write("# Heights over the datum, depth 50 mm, velocities with noise of the stated uncertainty.\n")
        file.write(f"# Answer: rough log law with u_* {FRICTION_VELOCITY} m/s and k_s {1e3 * ROUGHNESS:.0f} mm over the "
                   "datum, kappa 0.41;\n# Nezu's intensities; -u'w' = u_*^2 (1 - z/h).\n")
        file.write("z [mm],u [cm/s],u_uncertainty [cm/s],w [cm/s],u_rms [cm/s],w_rms [cm/s],-u'w' [cm2/s2]\n")
        for z in numpy.arange(0.005, 0.0461, 0.002):
            u = FRICTION_VELOCITY * (numpy.log(z / ROUGHNESS) / KAPPA + 8.5) + rng.normal(0, uncertainty)
            w = rng.normal(0, 0.001)
            decay = FRICTION_VELOCITY * numpy.exp(-z / DEPTH)
            u_rms = 2.30 * decay * (1 + rng.normal(0, 0.02))
            w_rms = 1.27 * decay * (1 + rng.normal(0, 0.02))
            stress = FRICTION_VELOCITY**2 * (1 - z / DEPTH) * (1 + rng.normal(0, 0.05))
            file.write(f"{1e3 * z:.1f},{1e2 * u:.2f},{1e2 * uncertainty:.2f},{1e2 * w:.2f},{1e2 * u_rms:.2f},"
                       f"{1e2 * w_rms:.2f},{1e4 * stress:.3f}\n")


def write_point(folder, rng):
    frequency, rows, mean = 25.0, 2500, 0.28
    memory = 0.8  # of successive samples
    u_rms, w_rms, correlation = 0.080, 0.045, -0.40
    noise = rng.normal(size=(rows, 3))
    noise[:, 2] = correlation * noise[:, 0] + numpy.sqrt(1 - correlation**2) * noise[:, 2]
    state = noise[0].copy()
    velocity = numpy.zeros((rows, 3))
    for i in range(rows):
        velocity[i] = state
        state = memory * state + numpy.sqrt(1 - memory**2) * noise[i]
    velocity *= [u_rms, 0.060, w_rms]
    velocity[:, 0] += mean
    quality = rng.uniform(80, 99, rows)
    poor = numpy.sort(rng.choice(numpy.arange(20, rows - 20, 40), 10, replace=False))
    quality[poor] = rng.uniform(20, 60, 10)
    velocity[poor] = rng.uniform(-1, 1, (10, 3))
    spikes = numpy.sort(rng.choice(numpy.arange(10, rows - 20, 40), 12, replace=False))
    velocity[spikes, 0] += rng.choice([-1, 1], 12) * rng.uniform(0.8, 1.2, 12)
    with open(folder / "adv-point.csv", "w", encoding="utf-8") as file:
        file.write(MARK)
        file.write("# title: synthetic ADV point, like condition 2\n")
        file.write("# Velocities at one point, 100 s at 25 Hz, autoregressive with 0.8 from sample to sample.\n")
        file.write(f"# Answer: u {mean} m/s, u_rms {u_rms} m/s, v_rms 0.06 m/s, w_rms {w_rms} m/s, -u'w' "
                   f"{-correlation * u_rms * w_rms:.6f} m2/s2.\n")
        file.write("# Faults: 10 samples of low correlation with meaningless velocities, 12 spikes of u.\n")
        file.write(f"# sampling_frequency: {frequency:g} Hz\n# z: 20 mm\n")
        file.write("u [m/s];v [m/s];w [m/s];correlation [%]\n")
        for row in range(rows):
            file.write(";".join(f"{v:.4f}" for v in velocity[row]) + f";{quality[row]:.0f}\n")


def law(z):
    """Velocity of the rough log law over the middle of the channel (m/s)."""
    return FRICTION_VELOCITY * (numpy.log(z / ROUGHNESS) / KAPPA + 8.5)


def write_section(folder, rng):
    width, uncertainty = 0.459, 0.003  # m, m/s
    with open(folder / "cross-section.csv", "w", encoding="utf-8") as file:
        file.write(MARK)
        file.write("# title: synthetic cross-section, like condition 2\n")
        file.write("# Heights over the datum, depth 50 mm; distances from the side wall of a channel 459 mm wide.\n")
        file.write("# Answer: the log law of adv-profile.csv times (y / H)^(1/7) within a depth H = 50 mm of the wall;\n")
        file.write("# -u'w' = u_*^2 (1 - z/h), less by the same factor squared; noise of the stated uncertainty.\n")
        file.write("y [mm],z [mm],u [cm/s],u_uncertainty [cm/s],-u'w' [cm2/s2]\n")
        for y in (0.010, 0.020, 0.035, 0.055, 0.080, 0.120, 0.170, 0.5 * width):
            factor = min(1.0, y / DEPTH) ** (1 / 7)
            for z in (0.006, 0.012, 0.020, 0.030, 0.042):
                u = factor * law(z) + rng.normal(0, uncertainty)
                stress = (factor * FRICTION_VELOCITY) ** 2 * (1 - z / DEPTH) * (1 + rng.normal(0, 0.05))
                file.write(f"{1e3 * y:.1f},{1e3 * z:.1f},{1e2 * u:.2f},{1e2 * uncertainty:.2f},{1e4 * stress:.3f}\n")


def write_field(folder, rng):
    uncertainty = 0.002  # m/s
    with open(folder / "piv-means.csv", "w", encoding="utf-8") as file:
        file.write(MARK)
        file.write("# title: synthetic PIV, like condition 2\n")
        file.write("# Mean velocities in the x-z plane of the centreline, heights over the datum, depth 50 mm.\n")
        file.write("# Answer: the log law of adv-profile.csv at every x, w = 0, noise of the stated uncertainty; three\n")
        file.write("# places have no vector.\n")
        file.write("x [mm],z [mm],u [m/s],w [m/s],u_uncertainty [m/s],w_uncertainty [m/s]\n")
        points = [(x, z) for z in numpy.arange(0.006, 0.0461, 0.004) for x in numpy.arange(0.010, 0.0901, 0.010)]
        lost = set(rng.choice(len(points), 3, replace=False))
        for number, (x, z) in enumerate(points):
            u, w = law(z) + rng.normal(0, uncertainty), rng.normal(0, uncertainty)
            values = "," if number in lost else f"{u:.4f},{w:.4f}"
            file.write(f"{1e3 * x:.0f},{1e3 * z:.0f},{values},{uncertainty:g},{uncertainty:g}\n")


def main():
    default = pathlib.Path(__file__).resolve().parent.parent / "cases" / "laboratory"
    folder = pathlib.Path(sys.argv[1]) if len(sys.argv) > 1 else default
    folder.mkdir(parents=True, exist_ok=True)
    for seed, write in enumerate([write_wave_probes, write_calibration, write_profile, write_point, write_section,
                                  write_field]):
        write(folder, numpy.random.default_rng(2016 + seed))


if __name__ == "__main__":
    main()
