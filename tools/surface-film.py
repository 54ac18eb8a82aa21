#!/usr/bin/env python3
"""Make a film of the moving free surface of a run in three dimensions, as an animated picture (WebP).

    tools/surface-film.py RESULTS -o FILE.webp [--from T] [--to T] [--width PIXELS] [--slow N]

RESULTS is the results.h5 of a run with output.surface_map_interval, or its folder. The surface is seen from above, the flow
goes to the right; the light comes from the upper left, and slopes are drawn steeper than they are, without what is shorter
than four points of the maps: as the moving surface of the run's report. The mark moves at the depth-mean velocity of the
run. Needs h5py, numpy and Pillow (Debian: python3-h5py, python3-numpy, python3-pil).
"""

import argparse
import pathlib
import sys

import h5py
import numpy
from PIL import Image, ImageDraw, ImageFont

SHADOW, BRIGHT = numpy.array([10, 44, 74.0]), numpy.array([198, 226, 236.0])
SUN = numpy.array([-0.55, 0.5, 0.67])
TRUE_SLOPE = 0.45  # rms slope of what is drawn


def smoothed(maps):
    """Weights 1 2 1 along and across; the plan repeats itself."""
    for axis in (1, 2):
        maps = (numpy.roll(maps, 1, axis) + 2 * maps + numpy.roll(maps, -1, axis)) / 4
    return maps


def spline(points, pixels):
    """Weights of a periodic cubic B-spline: values at `pixels` places from those at the points, and its slopes' by the way."""
    place = (numpy.arange(pixels) + 0.5) / pixels * points - 0.5
    first = numpy.floor(place).astype(int)
    t = place - first
    weights = numpy.zeros((pixels, points))
    for k, weight in enumerate(((1 - t) ** 3, 3 * t**3 - 6 * t**2 + 4, -3 * t**3 + 3 * t**2 + 3 * t + 1, t**3)):
        numpy.add.at(weights, (numpy.arange(pixels), (first + k - 1) % points), weight / 6)
    return weights


def relief(map_, across, along, steepness):
    """Colours of a map in the light, rows from the largest y down; `steepness`: factors of the slopes between pixels."""
    fine = (across @ map_ @ along.T)[::-1]
    slope_x = steepness[0] * (numpy.roll(fine, -1, 1) - numpy.roll(fine, 1, 1))
    slope_y = steepness[1] * (numpy.roll(fine, 1, 0) - numpy.roll(fine, -1, 0))
    length = numpy.sqrt(slope_x**2 + slope_y**2 + 1)
    towards = lambda to: numpy.clip((-slope_x * to[0] - slope_y * to[1] + to[2]) / length, 0, 1)[..., None]
    half = SUN + numpy.array([0, 0, 1])
    colour = SHADOW + towards(SUN) * (BRIGHT - SHADOW)
    return (colour + 0.55 * towards(half / numpy.linalg.norm(half)) ** 60 * (255 - colour)).astype(numpy.uint8)


def frames(file, start, end, width):
    """The pictures from `start` to `end`, and the time between them, s."""
    maps = file["surface_map"]
    time = maps["time"][:]
    shown = (time >= start - 1e-9) & (time <= end + 1e-9)
    if shown.sum() < 2:
        sys.exit(f"surface-film: {file.filename} holds maps of the surface from {time[0]:g} to {time[-1]:g} s, fewer than two from {start:g} to {end:g} s")
    x, y, time = maps["x"][:], maps["y"][:], time[shown]
    elevation = maps["elevation"][shown].reshape(len(time), len(y), len(x))
    elevation = smoothed(elevation - elevation.mean(axis=(1, 2), keepdims=True))
    dx, dy = x[1] - x[0], y[1] - y[0]
    extent = dx * len(x), dy * len(y)
    height = round(width * extent[1] / extent[0])
    along, across = spline(len(x), width), spline(len(y), height)
    steepness = TRUE_SLOPE / (numpy.diff(elevation, axis=2) / dx).std()
    factors = steepness * width / (2 * extent[0]), steepness * height / (2 * extent[1])
    series = file["time_series"]
    inside = (series["time"][:] >= time[0]) & (series["time"][:] <= time[-1])
    velocity = series["depth_mean_velocity"][:][inside].mean()
    font = ImageFont.truetype("DejaVuSans.ttf", max(12, width // 40))
    pictures = []
    for moment, map_ in zip(time, elevation):
        picture = Image.fromarray(relief(map_, across, along, factors))
        pen = ImageDraw.Draw(picture)
        mark = width * (velocity * (moment - time[0]) % extent[0]) / extent[0]
        pen.ellipse((mark - 7, height / 2 - 7, mark + 7, height / 2 + 7), outline=(213, 94, 0), width=3)
        text = f"t = {moment:.2f} s     {1e3 * extent[0]:.0f} mm x {1e3 * extent[1]:.0f} mm     mark: {velocity:.2f} m/s     slopes x {steepness:.0f}"
        pen.text((9, height - 9), text, fill=(255, 255, 255), stroke_width=2, stroke_fill=(10, 44, 74), anchor="ls", font=font)
        pictures.append(picture)
    return pictures, (time[-1] - time[0]) / (len(time) - 1)


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("results", type=pathlib.Path, help="results.h5 of a run, or its folder")
    parser.add_argument("-o", "--output", type=pathlib.Path, required=True, help="the picture to write (.webp)")
    parser.add_argument("--from", dest="start", type=float, default=0.0, help="first moment, s")
    parser.add_argument("--to", dest="end", type=float, default=float("inf"), help="last moment, s")
    parser.add_argument("--width", type=int, default=640, help="of the picture, pixels")
    parser.add_argument("--slow", type=float, default=2.0, help="how many times slower than in reality it plays")
    options = parser.parse_args()
    path = options.results / "results.h5" if options.results.is_dir() else options.results
    with h5py.File(path) as file:
        if "surface_map" not in file:
            sys.exit(f"surface-film: {path} holds no maps of the surface: set output.surface_map_interval in the case and run it again")
        pictures, interval = frames(file, options.start, options.end, options.width)
    pictures[0].save(options.output, save_all=True, append_images=pictures[1:], duration=round(1000 * options.slow * interval), loop=0, quality=55, method=6)
    print(f"{options.output}: {len(pictures)} pictures")


if __name__ == "__main__":
    main()
