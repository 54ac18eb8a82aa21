"""Linear theory of a box that floats in two dimensions, in water of a finite depth: added mass and wave damping in heave and roll by a boundary element method.

The potential phi e^(-i w t) of the water that a body moves solves Laplace's equation with phi_z = w^2/g phi on the surface, phi_z = 0 on the bed,
phi_n = the body's normal velocity, and is a wave that leaves, phi_n = i k phi, a few depths beside the body (Newman 1977, Marine Hydrodynamics,
chapter 6). Its pressure i w rho phi on the body gives the added mass a and the damping b: F = w^2 a + i w b per unit of motion. Straight elements of constant phi (Brebbia 1978).
"""

import numpy

GRAVITY = 9.81


def wave_number(frequency, depth):
    k = frequency**2 / GRAVITY
    for _ in range(200):
        k = 0.5 * (k + frequency**2 / GRAVITY / numpy.tanh(k * depth))
    return k


def elements(corners, lengths):
    """Ends of the elements of a closed line and the number of the side each belongs to; the water lies on its left."""
    begins, ends, sides = [], [], []
    for side, (a, b) in enumerate(zip(corners, corners[1:] + corners[:1])):
        a, b = numpy.array(a), numpy.array(b)
        n = max(6, int(numpy.ceil(numpy.hypot(*(b - a)) / lengths[side])))
        at = a + (b - a) * numpy.linspace(0, 1, n + 1)[:, None]
        begins.append(at[:-1])
        ends.append(at[1:])
        sides += [side] * n
    return numpy.concatenate(begins), numpy.concatenate(ends), numpy.array(sides)


def influence(begin, end):
    """Integrals over each element j of ln r and of its derivative along the outward normal, seen from the middle of element i."""
    middle = 0.5 * (begin + end)
    along = end - begin
    length = numpy.hypot(along[:, 0], along[:, 1])
    t = along / length[:, None]
    n = numpy.stack([t[:, 1], -t[:, 0]], axis=1)  # outward: the water lies on the left
    d = middle[:, None, :] - begin[None, :, :]
    x = d[..., 0] * t[None, :, 0] + d[..., 1] * t[None, :, 1]
    y = d[..., 0] * n[None, :, 0] + d[..., 1] * n[None, :, 1]
    far = length[None, :] - x
    with numpy.errstate(divide="ignore", invalid="ignore"):
        angle = numpy.where(abs(y) > 1e-12, numpy.arctan(far / y) + numpy.arctan(x / y), 0.0)
        log = 0.5 * (far * numpy.log(far**2 + y**2) + x * numpy.log(x**2 + y**2)) - length[None, :] + y * angle
    double = -angle
    own = numpy.eye(len(begin), dtype=bool)
    double[own] = 0.0
    log[own] = length * (numpy.log(length / 2) - 1)
    return log, double, middle, n, length


def radiation(width, draught, depth, frequency, mode, centre=0.0):
    """(added mass, damping) per width, kg/m and kg/(m s); of roll about the height `centre` above the surface kg m and kg m/s."""
    reach = 0.5 * width + 4 * depth + 2 * numpy.pi / wave_number(frequency, depth) * 0.5
    half = 0.5 * width
    corners = [(-reach, -depth), (reach, -depth), (reach, 0.0), (half, 0.0), (half, -draught), (-half, -draught), (-half, 0.0), (-reach, 0.0)]
    surface, far, body = width / 12, depth / 8, width / 40
    begin, end, side = elements(corners, [far, far, surface, body, body, body, surface, far])
    log, double, middle, n, length = influence(begin, end)
    wave = wave_number(frequency, depth)
    # Green's second identity with ln r, at a place of the boundary: pi phi = sum phi (ln r)_n - sum phi_n ln r.
    robin = numpy.zeros(len(side), dtype=complex)  # phi_n = robin phi
    robin[(side == 1) | (side == 7)] = 1j * wave
    robin[(side == 2) | (side == 6)] = frequency**2 / GRAVITY
    body = (side >= 3) & (side <= 5)
    velocity = n[:, 1] if mode == "heave" else ((middle[:, 1] - centre) * n[:, 0] - middle[:, 0] * n[:, 1])
    source = numpy.where(body, velocity, 0.0)
    matrix = numpy.pi * numpy.eye(len(side)) - double + log * robin[None, :]
    phi = numpy.linalg.solve(matrix, -log @ source)
    # Outward of the water is into the body: p pushes it that way, and F = i w a - b.
    total = 1000.0 * numpy.sum(phi[body] * velocity[body] * length[body])
    return total.real, frequency * total.imag


def natural_period(mass, stiffness, coefficients):
    """Period of w^2 (mass + a(w)) = stiffness, and the share of critical damping there; `coefficients`(w) gives a and b."""
    frequency = (stiffness / (2 * mass)) ** 0.5
    for _ in range(8):
        added, damping = coefficients(frequency)
        frequency = 0.5 * (frequency + (stiffness / (mass + added)) ** 0.5)
    return 2 * numpy.pi / frequency, damping / (2 * frequency * (mass + added))
