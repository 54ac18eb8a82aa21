"""Porous zones: falling head, Brinkman's layer, decay of a wave in a medium, a dam break into crushed stone, water at rest."""

import csv
import math

import h5py
import numpy

import figures
from check import Check
from options import options_text
from runs import ROOT


def zone_of(flow, number=0):
    return flow.parameters["porous"][number]


def _number(value):
    return None if isinstance(value, str) else value


def resistance(zone, viscosity):
    """Linear and quadratic coefficient of the discharge of an area: a, 1/s, and b, 1/m."""
    n, permeability, size = zone["porosity"], _number(zone["permeability"]), _number(zone["grain_size"])
    if permeability:
        return viscosity / permeability, zone["forchheimer"] / math.sqrt(permeability)
    return (zone["laminar_coefficient"] * (1 - n) ** 2 * viscosity / (n**3 * size**2), zone["inertial_coefficient"] * (1 - n) / (n**3 * size))


def _integrate(rates, state, times, most=1e-3):
    """Runge & Kutta's fourth order between `times`."""
    states = [numpy.array(state, float)]
    for begin, end in zip(times[:-1], times[1:]):
        steps = max(1, math.ceil((end - begin) / most))
        dt, y = (end - begin) / steps, states[-1]
        for _ in range(steps):
            k1 = rates(y)
            k2 = rates(y + dt / 2 * k1)
            k3 = rates(y + dt / 2 * k2)
            k4 = rates(y + dt * k3)
            y = y + dt / 6 * (k1 + 2 * k2 + 2 * k3 + k4)
        states.append(y)
    return numpy.array(states)


def _head(flow, wall=0.12):
    """Times and head between the legs of the U-tube, from the mass of water in each."""
    times, heads = [], []
    order = numpy.argsort(flow.ids)
    mass = flow.mass[order]
    zone = zone_of(flow)
    bottom, top = zone["z_from"], zone["z_to"]
    for s in flow.snapshots():
        volume = mass / s.density
        # Above the plug the left leg is open water. The weights rise over some rows, so that none counts at once.
        left = (volume * numpy.clip((s.z - top - 0.025) / 0.04, 0, 1))[s.x < wall].sum() / 0.1 + top + 0.045
        right = (volume * numpy.clip((s.z - 0.1) / 0.06, 0, 1))[s.x > wall].sum() / 0.1 + 0.13
        times.append(s.time)
        heads.append(left - right)
    return numpy.array(times), numpy.array(heads), top - bottom


def falling_head(study):
    check = Check("falling_head", "Falling head in a U-tube with a porous plug",
                  "The head between the legs of a U-tube with a plug: by a permeability exponential but for the inertia of the water; by grains after Ergun; from rest on, by the equation of the water in the tube.")
    figure = figures.Figure(1, width=6)
    axes = figure.panel("t, s", "head, m", "")
    runs = [("permeability", "falling-head", {}), ("grains", "falling-head-gravel", {})]
    if not study.quick:
        runs += [("permeability, 4 mm", "falling-head", {"numerics.spacing": '"4 mm"'}), ("grains, 4 mm", "falling-head-gravel", {"numerics.spacing": '"4 mm"'}),
                 ("permeability, semi-implicit Euler", "falling-head", {"numerics.stepping": '"semi-implicit-euler"'}),
                 ("permeability, three times as long", "falling-head", {"run.until": '"9 s"'})]
    for number, (name, case, settings) in enumerate(runs):
        flow = study.run("falling_" + "".join(c if c.isalnum() else "_" for c in name), f"cases/porous/{case}.toml", settings)
        time, head, plug = _head(flow)
        zone = zone_of(flow)
        linear, quadratic = resistance(zone, flow.viscosity)
        # The water of the legs, of the gap and of the pores, in which it is faster, moves together: legs and gap like 0.469 m of a leg, by
        # the potential flow of this tube.
        length = 0.469 + plug / zone["porosity"]

        def rates(y, linear=linear, quadratic=quadratic, plug=plug, length=length):
            h, q = y
            return numpy.array([-2 * q, (9.81 * h - (linear + quadratic * abs(q)) * plug * q) / length])

        exact = _integrate(rates, [0.1, 0.0], time)[:, 0]
        error = numpy.abs(head - exact).max() / 0.1
        check.norm(f"largest departure of the head over the first, {name}", float(error), 0.01)
        if quadratic == 0:
            late = (time > 0.2) & (head > 0.02)
            slopes = [numpy.polyfit(time[late], numpy.log(h[late]), 1)[0] for h in (exact, head)]
            check.norm(f"time of the exponential, {name}", float(slopes[0] / slopes[1] - 1), None)
        if number < 2:
            figures.exact(axes, time, exact, "equation of the tube" if number == 0 else "")
            figures.simulated(axes, time[::2], head[::2], name, figures.COLOURS[number])
            check.best, check.cost = options_text(flow), flow.cost_text
            check.budgets_of(flow, energy=False, vertical=False)
    check.figures.append((figure.svg(check.name), "Head between the legs of a U-tube with a porous plug."))
    return check


class Brinkman:
    """Laminar flow over and in a layer: discharge of an area by height."""

    def __init__(self, flow):
        zone = zone_of(flow)
        self.porosity, ratio, k = zone["porosity"], zone["viscosity_ratio"], _number(zone["permeability"])
        self.top, self.depth, self.gravity, self.viscosity = zone["z_to"], flow.depth, flow.gravity_x, flow.viscosity
        self.far, self.reach = self.gravity * k / self.viscosity, math.sqrt(ratio * k / self.porosity)
        self.gradient = self.gravity * (self.depth - self.top) / self.viscosity
        self.factor = self.gradient * self.reach / (ratio * math.sinh(self.top / self.reach))
        self.slip = self.far + self.factor * math.cosh(self.top / self.reach)
        self.alpha = math.sqrt(k) * self.gradient / (self.slip - self.far)
        self.root = math.sqrt(k)

    def discharge(self, z):
        z = numpy.asarray(z, float)
        above = self.slip + self.gravity / self.viscosity * ((self.depth - self.top) * (z - self.top) - 0.5 * (z - self.top) ** 2)
        return numpy.where(z < self.top, self.far + self.factor * numpy.cosh(z / self.reach), above)


def _slip_and_alpha(exact, z, q):
    """Slip velocity and Beavers & Joseph's coefficient as a laboratory finds them: the parabola of the open water away from the edge, carried to the top."""
    open_water = (z > exact.top + 0.15 * (exact.depth - exact.top)) & (z < exact.depth)
    fit = numpy.polyfit(z[open_water], q[open_water], 2)
    slip, gradient = numpy.polyval(fit, exact.top), numpy.polyval(numpy.polyder(fit), exact.top)
    return slip, exact.root * gradient / (slip - exact.far)


def brinkman(study):
    case = "cases/porous/brinkman.toml"
    check = Check("brinkman", "Brinkman's layer and Beavers & Joseph's slip",
                  "Laminar flow over and in a porous layer against the exact profile of Neale & Nader (1974) with a continuous stress of the water; the slip velocity and Beavers & Joseph's coefficient from the parabola above.")
    figure = figures.Figure(1, width=6)
    axes = figure.panel("discharge of an area q, m/s", "z, m", "mean from 5 s on")
    variants = [("2 mm", {})]
    if not study.quick:
        variants += [("1.5 mm", {"numerics.spacing": '"1.5 mm"'}), ("3 mm", {"numerics.spacing": '"3 mm"'}),
                     ("in space, 4 mm", {"channel.dimensions": 3, "channel.width": '"40 mm"', "numerics.spacing": '"4 mm"'}),
                     ("30 s", {"run.until": '"30 s"', "run.average_from": '"25 s"'}),
                     ("from a uniform start", {"start.kind": '"uniform"', "start.velocity": '"0.1 m/s"', "run.until": '"20 s"', "run.average_from": '"15 s"'})]
    for number, (name, settings) in enumerate(variants):
        flow = study.run("brinkman_" + "".join(c if c.isalnum() else "_" for c in name), case, settings)
        exact = Brinkman(flow)
        z = flow.profiles["z"]
        twin_z, twin_u = study.column(flow)
        twin = numpy.interp(z, twin_z, twin_u)
        # The pores at a height are those of the particles: the porosity changes over the edge.
        edge = 2.4 * flow.smoothing_length if isinstance(zone_of(flow)["edge"], str) else zone_of(flow)["edge"]
        t = numpy.clip((exact.top - z) / edge + 0.5, 0, 1)
        porosity = 1 - t * t * (3 - 2 * t) * (1 - exact.porosity)
        q, largest = porosity * flow.profiles["velocity"], float(exact.discharge(exact.depth))
        bar = 0.01 if name != "3 mm" and "4 mm" not in name else None
        check.norm(f"largest departure of q over its largest, {name}", float(numpy.abs(q - exact.discharge(z)).max() / largest), bar)
        check.norm(f"rms of q against the column twin, over its largest, {name}", float(numpy.sqrt(numpy.mean((q - porosity * twin) ** 2)) / largest), bar)
        slip, alpha = _slip_and_alpha(exact, z, q)
        check.norm(f"slip velocity, {name}", float(slip / exact.slip - 1), bar)
        check.norm(f"Beavers & Joseph's coefficient, {name}", float(alpha / exact.alpha - 1), bar)
        check.norm(f"resistance over the weight, less one, {name}", flow.values["porous_over_gravity"] - 1, bar)
        if number == 0:
            heights = numpy.linspace(0, exact.depth, 400)
            figures.exact(axes, exact.discharge(heights), heights, "exact")
            figures.simulated(axes, q, z, f"dx {name}", figures.COLOURS[0])
            check.best, check.cost = options_text(flow), flow.cost_text
            check.budgets_of(flow, energy=False, vertical=False)
    check.figures.append((figure.svg(check.name), "Discharge of an area over and in a porous layer of 40 mm."))
    return check


def measured_surfaces():
    """Of the dam break: by time, places and heights."""
    surfaces = {}
    with open(ROOT / "cases/porous/dam-break-measured.csv") as file:
        for row in csv.DictReader(line for line in file if not line.startswith("#")):
            surfaces.setdefault(float(row["t"]), []).append((float(row["x"]), float(row["z"])))
    return {time: numpy.array(points).T for time, points in surfaces.items()}


def dam_break(study):
    case = "cases/porous/dam-break.toml"
    check = Check("porous_dam_break", "Dam break into a dam of crushed stone",
                  "The surface against the one measured by Lin (1998) and Liu et al. (1999) at 0.35, 0.75, 1.15, 1.55 and 1.95 s.")
    figure = figures.Figure(3, width=9)
    variants = [("5 mm", {})] + ([] if study.quick else [("4 mm", {"numerics.spacing": '"4 mm"'})])
    for number, (name, settings) in enumerate(variants):
        flow = study.run("porous_dam_break_" + name.replace(" ", "_"), case, settings)
        with h5py.File(flow.folder / "results.h5", "r") as file:
            time, x, elevation = (file["/surface"][key][:] for key in ("time", "x", "elevation"))
        squares = []
        for panel, (at, (places, heights)) in enumerate(measured_surfaces().items()):
            surface = elevation[numpy.abs(time - at).argmin()]
            departure = numpy.interp(places, x, numpy.nan_to_num(surface)) - heights
            squares.append(departure**2)
            check.norm(f"rms of the surface over the first depth, t = {at} s, {name}", float(numpy.sqrt(squares[-1].mean()) / 0.35), None)
            if number == 0 and panel in (0, 2, 4):
                axes = figure.panel("x, m", "z, m", f"t = {at} s")
                figures.exact(axes, places, heights, "measured")
                figures.simulated(axes, x[::3], surface[::3], f"dx {name}", figures.COLOURS[0])
        check.norm(f"rms of the surface over the first depth, {name}", float(numpy.sqrt(numpy.concatenate(squares).mean()) / 0.35), 0.06)
        if number == 0:
            check.best, check.cost = options_text(flow), flow.cost_text
    check.figures.append((figure.svg(check.name), "Surface of a dam break into crushed stone between 0.30 and 0.59 m."))
    return check


def block(study):
    check = Check("porous_block", "Flow through a porous block",
                  "A periodic reach between smooth plates with a block in a part of it: the discharge of an area at which the weight of the reach balances the resistance of the block.")
    variants = [("4 mm", {})] + ([] if study.quick else [("an edge of one spacing", {"edge": "4 mm"}), ("porosity 0.3", {"porosity": 0.3})])
    for name, keys in variants:
        text = (ROOT / "cases/porous/series.toml").read_text()
        for key, value in keys.items():
            text = text.replace("porosity = 0.5", f"porosity = {value}") if key == "porosity" else text + f'{key} = "{value}"\n'
        file = study.folder / f"block_{len(check.norms)}.toml"
        file.write_text(text)
        flow = study.run("porous_block_" + "".join(c if c.isalnum() else "_" for c in name), str(file), {})
        zone = zone_of(flow)
        linear, quadratic = resistance(zone, flow.viscosity)
        drive = flow.gravity_x * flow.length / (zone["x_to"] - zone["x_from"])
        exact = (math.sqrt(linear**2 + 4 * quadratic * drive) - linear) / (2 * quadratic)
        late = flow.series["time"] > flow.parameters["run"]["average_from"]
        found = float((flow.series["total_mean_velocity"] * flow.series["water_volume"])[late].mean()) / (flow.length * flow.depth)
        check.norm(f"discharge of an area, {name}", found / exact - 1, None if "0.3" in name else 0.01)
        check.best, check.cost = options_text(flow), flow.cost_text
    return check


def _across_bands(thickness, width, places=20001):
    """Share of the first of two kinds of bands, `width` thick one after the other, along a line at right angles to them, for an edge of
    this thickness at 45 degrees to the axes: a place is a square with the weight of a smooth step's slope along either axis."""
    t = numpy.linspace(-0.5, 0.5, 401)[1:-1]
    weight = 1.5 * (1 - 4 * t**2)
    offsets = (t[:, None] + t[None, :]).ravel() * thickness / math.sqrt(2)
    histogram, edges = numpy.histogram(offsets, bins=200, weights=(weight[:, None] * weight[None, :]).ravel())
    middles, histogram = 0.5 * (edges[1:] + edges[:-1]), histogram / histogram.sum()
    s = numpy.linspace(0, 2 * width, places)[:-1]
    return sum(part * (((s - offset) % (2 * width)) < width) for part, offset in zip(histogram, middles))


def _carried_along(drive, rate, porosity, across, step):
    """Velocity along bands of water that crosses them: (across/n) du/ds = drive - rate u, the same after one period of both bands."""
    decay = numpy.exp(-rate * porosity * step / across)
    gain = drive / rate * (1 - decay)
    once = 0.0
    for d, g in zip(decay, gain):
        once = d * once + g
    u = numpy.empty(len(decay))
    last = once / (1 - numpy.prod(decay))
    for k, (d, g) in enumerate(zip(decay, gain)):
        last = u[k] = d * last + g
    return u


def bands(study):
    check = Check("porous_bands", "Flow through skew bands of two media",
                  "Bands of a fine and a coarse medium at 45 degrees to the channel, outlined in plan: across them one discharge; along them each resists in its own way, and the water carries its motion from one to the next.")
    flow = study.run("porous_bands", "cases/porous/bands.toml")
    zones = [zone_of(flow), zone_of(flow, 2)]
    linear = [resistance(zone, flow.viscosity)[0] for zone in zones]
    width = 0.5 * flow.length / math.sqrt(2)
    share = _across_bands(2.4 * flow.smoothing_length, width)
    force = sum(part * zone["porosity"] * a for part, zone, a in zip((share, 1 - share), zones, linear))
    porosity = sum(part * zone["porosity"] for part, zone in zip((share, 1 - share), zones))
    drive = flow.gravity_x / math.sqrt(2)
    across = drive / (0.5 * (linear[0] + linear[1]))
    along = float((porosity * _carried_along(drive, force, porosity, across, 2 * width / len(share))).mean())
    exact = numpy.array([across + along, along - across]) / math.sqrt(2)
    late = [s for s in flow.snapshots() if s.time > flow.parameters["run"]["average_from"]]
    room = flow.length * flow.parameters["channel"]["width"] * flow.depth
    found = numpy.mean([[(flow.mass / s.density * component).sum() / room for component in (s.u, s.v)] for s in late], axis=0)
    check.norm("discharge of an area along the channel", float(found[0] / exact[0] - 1), 0.01)
    check.norm("the same across it, over that along it, less the exact", float((found[1] - exact[1]) / exact[0]), 0.01)
    refracted = (across + 0.5 * drive * (1 / linear[0] + 1 / linear[1])) / math.sqrt(2)
    check.norm("discharge along the channel against water without inertia (Darcy's law of refraction)", float(found[0] / refracted - 1))
    check.best, check.cost = options_text(flow), flow.cost_text
    return check


CHECKS = {"porous_block": block, "porous_bands": bands, "falling_head": falling_head, "brinkman": brinkman, "porous_dam_break": dam_break}
