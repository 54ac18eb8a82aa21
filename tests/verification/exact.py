"""Exact solutions and published measurements that the verification compares with. SI units."""

import cmath
import math

import numpy


def modes(first, step=2, count=200):
    return numpy.arange(first, first + step * count, step)


def poiseuille_start(force, nu, width, z, t):
    """u between plates, from rest under the acceleration `force` (Morris, Fox & Zhu 1997, eq. 22)."""
    k = math.pi * modes(1) / width
    terms = 4 * force / (nu * width * k**3) * numpy.exp(-nu * k**2 * t)
    return force / (2 * nu) * z * (width - z) - numpy.sin(numpy.outer(z, k)) @ terms


def couette_start(velocity, nu, width, z, t):
    """u between plates, the upper of which moves at `velocity` from t = 0 (Morris, Fox & Zhu 1997, eq. 21)."""
    n = modes(1, 1)
    k = math.pi * n / width
    terms = 2 * velocity / (n * math.pi) * (-1.0) ** n * numpy.exp(-nu * k**2 * t)
    return velocity * z / width + numpy.sin(numpy.outer(z, k)) @ terms


def channel_start(force, nu, depth, start, z, t):
    """u in a laminar channel with a free surface, from the uniform velocity `start`."""
    k = math.pi * modes(1) / (2 * depth)
    terms = 2 / (k * depth) * (start - force / (nu * k**2)) * numpy.exp(-nu * k**2 * t)
    return force / (2 * nu) * z * (2 * depth - z) + numpy.sin(numpy.outer(z, k)) @ terms


def ramp_profile(xi, start=0.01, kappa=0.41, ramp=0.09):
    """U / u_* under the stress rho u_*^2 (1 - xi) with l_m / H = min(kappa xi, ramp), zero at xi = start."""
    xi = numpy.asarray(xi, dtype=float)
    primitive = lambda s: 2 * numpy.sqrt(1 - s) + numpy.log((1 - numpy.sqrt(1 - s)) / (1 + numpy.sqrt(1 - s)))
    corner = ramp / kappa
    lower = (primitive(numpy.minimum(xi, corner)) - primitive(start)) / kappa
    upper = 2 / (3 * ramp) * ((1 - corner) ** 1.5 - (1 - numpy.maximum(xi, corner)) ** 1.5)
    return lower + upper


def gravity_wave(gravity, k, depth):
    """Angular frequency of a small wave on inviscid water."""
    return math.sqrt(gravity * k * math.tanh(k * depth))


def viscous_wave(gravity, k, depth, nu, free_of="traction"):
    """Frequency and decay of a small wave over a frictionless bed; its surface free of traction, or of du/dn (docs/verification.md)."""
    n = 2.0 if free_of == "traction" else 1.0
    square = gravity * k * math.tanh(k * depth)

    def residual(s):
        m = cmath.sqrt(k * k + s / nu)
        return (s + n * nu * k * k) ** 2 + square - n * n * nu * nu * k**3 * m * math.tanh(k * depth) / cmath.tanh(m * depth)

    before, s = complex(-0.9 * n * nu * k * k, math.sqrt(square)), complex(-n * nu * k * k, math.sqrt(square))
    for _ in range(50):
        difference = residual(s) - residual(before)
        if abs(s - before) < 1e-13 * abs(s) or difference == 0:
            break
        before, s = s, s - residual(s) * (s - before) / difference
    return s.imag, -s.real


def fit_oscillation(time, value, frequency, decay, offset=False):
    """Frequency and decay of the damped oscillation that fits a record best (least squares), from a guess; then the fit at `time`."""
    for _ in range(60):
        wave = numpy.exp(-decay * time) * numpy.array([numpy.cos(frequency * time), numpy.sin(frequency * time)])
        basis = numpy.vstack([wave] + ([numpy.ones_like(time)] if offset else [])).T
        amplitude = numpy.linalg.lstsq(basis, value, rcond=None)[0]
        by_decay = -time * (basis[:, :2] @ amplitude[:2])
        by_frequency = time * (amplitude[1] * basis[:, 0] - amplitude[0] * basis[:, 1])
        jacobian = numpy.column_stack([basis, by_decay, by_frequency])
        step = numpy.linalg.lstsq(jacobian, value - basis @ amplitude, rcond=None)[0]
        decay, frequency = decay + step[-2], frequency + step[-1]
    return frequency, decay, basis @ amplitude


def observed_order(spacings, errors):
    """Slope of log(error) over log(spacing), by least squares."""
    return numpy.polyfit(numpy.log(spacings), numpy.log(errors), 1)[0]


def tilted_tank(slope, length, depth, gravity, nu, t, count=41):
    """Amplitudes of the modes cos(n pi x/L), n odd, of the level of water at rest in a tank that is tilted at t = 0, less its new
    level: 4 S L / (n pi)^2 cos(omega t), damped by 2 nu k^2. Returns n and the amplitudes at the times t (times, modes)."""
    n = modes(1, 2, count)
    k = n * math.pi / length
    omega = numpy.sqrt(gravity * k * numpy.tanh(k * depth))
    amplitude = 4 * slope * length / (n * math.pi) ** 2
    t = numpy.asarray(t, dtype=float)[:, None]
    return n, amplitude * numpy.cos(omega * t) * numpy.exp(-2 * nu * k**2 * t)


def elliptic_drop(radius, rate, times):
    """Semi-axes a (along x) and b of a weightless drop of ideal fluid, a circle at t = 0 with the velocity rate (x, -z) (Monaghan 1994).

    The velocity stays linear, A (x, -z); with a b = radius^2 the pressure that vanishes on the ellipse asks for
    dA/dt = -A^2 (a^2 - b^2)/(a^2 + b^2), da/dt = A a.
    """

    def slope(a, rate_now):
        b = radius**2 / a
        return rate_now * a, -(rate_now**2) * (a * a - b * b) / (a * a + b * b)

    times = numpy.asarray(times, dtype=float)
    axes, a, r, now = [], radius, rate, 0.0
    for end in times:
        count = max(int(math.ceil((end - now) * rate * 200)), 1)
        dt = (end - now) / count
        for _ in range(count):  # Runge and Kutta's method of fourth order
            k1 = slope(a, r)
            k2 = slope(a + dt / 2 * k1[0], r + dt / 2 * k1[1])
            k3 = slope(a + dt / 2 * k2[0], r + dt / 2 * k2[1])
            k4 = slope(a + dt * k3[0], r + dt * k3[1])
            a, r = (v + dt / 6 * (p + 2 * q + 2 * s + w) for v, p, q, s, w in zip((a, r), k1, k2, k3, k4))
        now = end
        axes.append((a, radius**2 / a, r))
    return numpy.array(axes).T


def ritter_depth(gravity, depth, x, t):
    """Depth after a dam break at x = 0 (Ritter 1892), over a dry frictionless bed."""
    c = math.sqrt(gravity * depth)
    return numpy.clip(numpy.where(x < -c * t, depth, (2 * c - numpy.minimum(x / t, 2 * c)) ** 2 / (9 * gravity)), 0, depth)


# Martin & Moyce (1952), tables 2 and 6, a = 2.25 in, n^2 = 2: front Z = x/a at T = t sqrt(2 g/a); height H = h/(2 a) at t sqrt(g/a).
MARTIN_MOYCE_FRONT = numpy.array([
    (0.84, 1.22), (1.19, 1.44), (1.43, 1.67), (1.63, 1.89), (1.83, 2.11), (1.98, 2.33), (2.20, 2.56), (2.32, 2.78), (2.51, 3.00),
    (2.65, 3.22), (2.83, 3.44), (2.98, 3.67), (3.11, 3.89), (3.33, 4.11)])
MARTIN_MOYCE_HEIGHT = numpy.array([
    (0.56, 0.94), (0.77, 0.89), (0.93, 0.83), (1.08, 0.78), (1.28, 0.72), (1.46, 0.67), (1.66, 0.61), (1.84, 0.56), (2.00, 0.50),
    (2.21, 0.44)])

# Buchner (2002): pressure of a disc from 0.133 to 0.267 depths above the bed, in rho g H at t sqrt(g/H): when it first
# feels the water, its first maximum, and the level on which it stands afterwards, within some 0.01.
BUCHNER_PRESSURE = numpy.array([(2.45, 0.0), (2.77, 0.69), (3.2, 0.56), (3.7, 0.54), (4.2, 0.56), (4.7, 0.54), (5.2, 0.52)])

# Ghia, Ghia & Shin (1982), tables I and II: u on the vertical centre line, w on the horizontal one, over the lid's velocity.
GHIA_Z = numpy.array([0.0547, 0.0625, 0.0703, 0.1016, 0.1719, 0.2813, 0.4531, 0.5000, 0.6172, 0.7344, 0.8516, 0.9531, 0.9609, 0.9688, 0.9766])
GHIA_X = numpy.array([0.0625, 0.0703, 0.0781, 0.0938, 0.1563, 0.2266, 0.2344, 0.5000, 0.8047, 0.8594, 0.9063, 0.9453, 0.9531, 0.9609, 0.9688])
GHIA_U = {
    100: numpy.array([-0.03717, -0.04192, -0.04775, -0.06434, -0.10150, -0.15662, -0.21090, -0.20581, -0.13641, 0.00332, 0.23151,
                      0.68717, 0.73722, 0.78871, 0.84123]),
    1000: numpy.array([-0.18109, -0.20196, -0.22220, -0.29730, -0.38289, -0.27805, -0.10648, -0.06080, 0.05702, 0.18719, 0.33304,
                       0.46604, 0.51117, 0.57492, 0.65928])}
GHIA_W = {
    100: numpy.array([0.09233, 0.10091, 0.10890, 0.12317, 0.16077, 0.17507, 0.17527, 0.05454, -0.24533, -0.22445, -0.16914,
                      -0.10313, -0.08864, -0.07391, -0.05906]),
    1000: numpy.array([0.27485, 0.29012, 0.30353, 0.32627, 0.37095, 0.33075, 0.32235, 0.02526, -0.31966, -0.42665, -0.51550,
                       -0.39188, -0.33714, -0.27669, -0.21388])}


def square_duct(force, nu, side, y, z):
    """u of laminar flow in a square duct, y and z from a corner along its sides (White, Viscous Fluid Flow)."""
    n = modes(1, count=40)
    k = n * math.pi / side
    weight = 16 * force / (nu * math.pi**2) / numpy.outer(n, n) / (k[:, None] ** 2 + k**2)
    return numpy.einsum("ij,...i,...j->...", weight, numpy.sin(numpy.multiply.outer(y, k)), numpy.sin(numpy.multiply.outer(z, k)))


def equilateral_duct(force, nu, altitude, first, second, third):
    """u of laminar flow in a duct of equilateral section, by the distances from its three sides (Boussinesq 1868)."""
    return force / (nu * altitude) * first * second * third


def paddle_waves(time, x, amplitude, omega, across, depth, length, gravity):
    """Surface over still water, by linear theory, that a piston at x = 0 makes in a closed tank from rest on: it moves by amplitude sin(omega t)
    times cos(across y), the surface rises by what is returned, [time, x], times that. Each cos(k_x x) of the tank is a spring that the
    piston drives: a'' + Omega^2 a = V' tanh(k h)/k."""
    surface = numpy.zeros((len(time), len(x)))
    for m in range(int(40 * length / depth)):
        along = m * math.pi / length
        k = math.hypot(along, across)
        if k == 0:
            surface += (depth / length * amplitude * numpy.sin(omega * time))[:, None]
            continue
        own = math.sqrt(gravity * k * math.tanh(k * depth))
        swing = math.tanh(k * depth) / k * omega / (own**2 - omega**2) * (own * numpy.sin(own * time) - omega * numpy.sin(omega * time))
        surface += (1 if m == 0 else 2) / length * amplitude * numpy.outer(swing, numpy.cos(along * x))
    return surface
