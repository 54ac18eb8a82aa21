#!/usr/bin/env python3
"""Linear stability of a case's column solution in two dimensions.

Usage: tests/validation/column_stability.py CASE [--riffle BINARY]

Prints the growth rate of the least stable disturbance exp(i k x + s t) of the steady flow, by wavelength: once with the
eddy viscosity of the undisturbed flow, once with that of the closure, which follows the disturbance (2 nu_t along du/dz).
Equation of the stream function psi (u' = psi_z, w' = -i k psi), with drag -1/2 c U|U| and rigid, stress-free top and bed:
    s L psi = -i k (U L - U'') psi + nu L^2 psi + a (nu_t psi_zz)_zz - (c U psi_z)_z + 1/2 c U k^2 psi,  L = d2/dz2 - k^2.
"""

import argparse
import io
import pathlib
import subprocess

import numpy

import runs

POINTS = 500
NU = 1e-6


def column(riffle, case):
    """Profile of the column twin: z, u, du/dz, tau/rho, l_m; gravity along x; total depth."""
    text = subprocess.run([str(riffle), "column", str(case), "--csv"], check=True, capture_output=True, text=True).stdout
    z, u, gradient, stress, length = numpy.genfromtxt(io.StringIO(text), delimiter=",", skip_header=1).T[:5]
    stress = stress / 1000.0
    drive = stress[numpy.argmax(stress)] / (z[-1] - z[numpy.argmax(stress)])  # the line of the stress above the crests
    return z, u, gradient, stress, length, drive


def operators(z):
    """First and second derivative on uneven points, inside rows only."""
    n = len(z)
    first, second = numpy.zeros((n, n)), numpy.zeros((n, n))
    for i in range(1, n - 1):
        below, above = z[i] - z[i - 1], z[i + 1] - z[i]
        both = below + above
        first[i, i - 1:i + 2] = -above / (below * both), (above - below) / (below * above), below / (above * both)
        second[i, i - 1:i + 2] = 2 / (below * both), -2 / (below * above), 2 / (above * both)
    inside = slice(1, n - 1)
    return first[inside, inside], second[inside, inside]


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("case", type=pathlib.Path)
    parser.add_argument("--riffle", type=pathlib.Path, help="the binary (default: the build of this checkout)")
    arguments = parser.parse_args()
    height, u, gradient, stress, length, drive = column(arguments.riffle or runs.default_riffle(), arguments.case)

    # Points crowd where the shear is largest.
    fine = numpy.linspace(0.0, height[-1], 20001)
    density = 0.15 + 1 / (1 + ((fine - height[numpy.argmax(gradient)]) / 1e-3)**2)
    place = numpy.concatenate([[0], numpy.cumsum(0.5 * (density[1:] + density[:-1]) * numpy.diff(fine))])
    z = numpy.interp(numpy.linspace(0, 1, POINTS), place / place[-1], fine)
    first, second = operators(z)
    at = lambda values: numpy.interp(z, height, values)[1:-1]
    U, shear, nu_t = at(u), at(gradient), at(length**2 * numpy.abs(gradient))
    curvature = numpy.gradient(numpy.interp(z, height, gradient), z)[1:-1]
    drag = at(2 * numpy.clip(drive + numpy.gradient(stress, height), 0, None) / numpy.maximum(u, 1e-3)**2)
    print(f"largest shear {shear.max():.1f} 1/s at z = {1e3 * z[1 + numpy.argmax(shear)]:.2f} mm")
    print(f"{'wavelength mm':>14} {'growth 1/s, nu_t frozen':>24} {'growth 1/s, closure':>20}")
    for wavelength in (0.004, 0.006, 0.010, 0.020, 0.040, 0.100, 0.200):
        k = 2 * numpy.pi / wavelength
        laplacian = second - k**2 * numpy.eye(POINTS - 2)
        inverse = numpy.linalg.inv(laplacian)
        growth = []
        for tangent in (1, 2):
            exchange = (tangent * second @ (nu_t[:, None] * second) - first @ ((drag * U)[:, None] * first)
                        + numpy.diag(0.5 * drag * U * k**2))
            matrix = (-1j * k * (numpy.diag(U) - curvature[:, None] * inverse) + NU * laplacian + exchange @ inverse)
            growth.append(numpy.linalg.eigvals(matrix).real.max())
        print(f"{1e3 * wavelength:14.0f} {growth[0]:24.2f} {growth[1]:20.2f}")


if __name__ == "__main__":
    main()
