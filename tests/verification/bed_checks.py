"""Beds of several roughnesses: one behind the other, and side by side."""

import json
import re

import numpy

import figures
from check import Check
from inflow_checks import means_across, section_means
from open_end_checks import account, column_profile, mean_surface, program
from options import options_text
from runs import ROOT


def twin_of_one_bed(study, case, roughness):
    """Height and velocity of the column twin of a case whose bed is of one equivalent roughness (m), and the mean of the velocity over the depth."""
    text = re.sub(r"\[\[bed_patch\]\].*?(?=\n\[)", "", (ROOT / case).read_text(), flags=re.DOTALL)
    plain = study.folder / "one_bed.toml"
    plain.write_text(text)
    of_bed = plain, "--set", f"bed.equivalent_roughness={roughness}"
    z, u = column_profile(study, *of_bed)
    return z, u, json.loads(program(study, "column", *of_bed, "--json"))["depth_mean_velocity"]


def change(study):
    case = "cases/plane-beds/change-of-roughness.toml"
    check = Check("bed_change", "A change of the bed's roughness",
                  "Water 100 mm deep over a bed that becomes rougher half-way, from 1 to 20 mm of equivalent roughness, against steady varied flow over both beds, one behind the other.")
    flow = study.run("bed_change", case)
    begin = flow.parameters["run"]["average_from"]
    stations = json.loads(program(study, "backwater", case, "--stations", "801", "--json", "-"))["stations"]
    x, level = mean_surface(flow, begin)
    edge, h = flow.parameters["bed_patch"][0]["x_from"], flow.depth
    places, depth = numpy.array(stations["x"]), numpy.array(stations["depth"])
    before = numpy.interp(x, places[places < edge], depth[places < edge])
    behind = numpy.interp(x, places[places > edge], depth[places > edge])
    exact = numpy.where(x < edge, before, behind)
    departure = level / exact - 1
    for name, part in (("over the smoother bed, up to 5 depths before the edge", (x > 0.1 * flow.length) & (x < edge - 5 * h)),
                       ("over the rougher bed, from 10 depths behind the edge on", (x > edge + 10 * h) & (x < 0.95 * flow.length))):
        check.norm(f"depth {name}: mean departure from riffle backwater", float(departure[part].mean()), 0.01)
        check.norm("the same, largest departure", float(numpy.abs(departure[part]).max()))
    check.norm("largest departure between, where the flow takes on the profile of the other bed",
               float(numpy.abs(departure[(x > edge - 5 * h) & (x < edge + 10 * h)]).max()))
    account(check, flow)
    figure = figures.Figure(1, width=7)
    axes = figure.panel("distance along the channel x (m)", "depth (mm)", f"mean from {begin:.0f} s on")
    figures.exact(axes, places, 1e3 * depth, "riffle backwater")
    figures.simulated(axes, x, 1e3 * level, "particles", most=200)
    check.figures.append((figure.svg(check.name), f"Depth along the channel; from {edge:g} m on the bed is rougher."))
    check.best, check.cost = options_text(flow), flow.cost_text
    return check


def strips(study):
    case = "cases/plane-beds/strips.toml"
    check = Check("bed_strips", "Strips of two roughnesses side by side",
                  "A wide channel with a strip of 20 mm of equivalent roughness beside one of 1 mm, each eight depths wide and periodic across: "
                  "in the middle of each the flow is the uniform one over such a bed alone.")
    flow = study.run("bed_strips", case)
    begin = flow.parameters["run"]["average_from"]
    patch, bed = flow.parameters["bed_patch"][0], flow.parameters["bed"]
    width, h = flow.parameters["channel"]["width"], flow.depth
    middle = 0.5 * (patch["y_from"] + patch["y_to"])
    late = [s for s in flow.snapshots() if s.time >= begin]
    y, z, u = (numpy.concatenate([getattr(s, name) for s in late]) for name in ("y", "z", "u"))
    # From the middle of the rough strip, over the edge, to the middle of the smooth one.
    away = numpy.abs((y - middle + 0.5 * width) % width - 0.5 * width)
    figure = figures.Figure(2)
    profile = figure.panel("velocity u (m/s)", "height z (mm)", "in the middle of each strip")
    rows = round(h / flow.spacing)
    for number, (name, roughness, near) in enumerate((("rough", patch["equivalent_roughness"], away < h), ("smooth", bed["equivalent_roughness"], away > 0.5 * width - h))):
        height, velocity, mean = twin_of_one_bed(study, case, roughness)
        check.norm(f"mean velocity in the middle of the {name} strip against the column twin of its bed", float(u[near].mean() / mean - 1), 0.01)
        row = numpy.clip((z[near] / h * rows).astype(int), 0, rows - 1)
        count = numpy.maximum(numpy.bincount(row, minlength=rows), 1)
        zs, us = numpy.bincount(row, z[near], rows) / count, numpy.bincount(row, u[near], rows) / count
        above = zs > 5 * flow.spacing
        check.norm(f"profile above five rows in the middle of the {name} strip, rms over that mean", float(numpy.sqrt(numpy.mean((us - numpy.interp(zs, height, velocity))[above] ** 2)) / mean), 0.01)
        figures.exact(profile, velocity, 1e3 * height, f"twin, {name}", figures.COLOURS[number])
        figures.simulated(profile, us, 1e3 * zs, f"{name} strip", figures.COLOURS[number])
    bins = numpy.clip((away / (0.5 * width) * 48).astype(int), 0, 47)
    across = numpy.bincount(bins, u, 48) / numpy.bincount(bins, minlength=48)
    axes = figure.panel("distance from the middle of the rough strip (m)", "depth-mean velocity (m/s)", f"edge at {0.25 * width:.1f} m")
    figures.simulated(axes, (numpy.arange(48) + 0.5) / 48 * 0.5 * width, across, "particles")
    check.figures.append((figure.svg(check.name), "Profiles in the middle of both strips against the twins of their beds, and the depth-mean velocity across."))
    check.best, check.cost = options_text(flow), flow.cost_text
    return check


def strip_in_flume(study):
    case = "cases/plane-beds/flume-strip.toml"
    check = Check("bed_strip_in_flume", "A strip of gravel in a flume",
                  "Half of a flume, eight depths wide between glass walls, whose bed is of 10 mm of equivalent roughness along the middle half of its width and of 1 mm beside it, against the twin of the cross-section.")
    flow = study.run("bed_strip_in_flume", case)
    begin = flow.parameters["run"]["average_from"]
    twin_y, twin_u = section_means(study, case)
    y, u = means_across(flow, 0.5 * flow.length, 0.5 * flow.length, begin)
    twin = numpy.interp(y, twin_y, twin_u)
    check.norm("mean over the section against the twin's, less one", float(u.mean() / twin.mean() - 1), 0.01)
    check.norm("U(y), rms over that mean", float(numpy.sqrt(((u - twin) ** 2).mean()) / twin.mean()), 0.03)
    check.norm("in the file beside the wall, over the twin's, less one", float(u[0] / twin[0] - 1))
    check.norm("at the centreline, over the twin's, less one", float(u[-1] / twin[-1] - 1))
    beds = [twin_of_one_bed(study, case, k)[2] for k in (flow.parameters["bed"]["equivalent_roughness"], flow.parameters["bed_patch"][0]["equivalent_roughness"])]
    figure = figures.Figure(1, width=7)
    axes = figure.panel("distance from the wall y (m)", "depth mean of u (m/s)", f"means from {begin:g} s on")
    figures.exact(axes, twin_y, twin_u, "section twin")
    figures.simulated(axes, y, u, "particles", figures.COLOURS[0])
    for number, mean in enumerate(beds):
        figures.exact(axes, [0, twin_y[-1]], [mean, mean], f"column twin of the {('smoother', 'rougher')[number]} bed", figures.COLOURS[1 + number], linestyle="--")
    check.figures.append((figure.svg(check.name), "Depth-mean velocity from the wall to the centreline; from 0.12 m on the bed is of gravel."))
    check.best, check.cost = options_text(flow), flow.cost_text
    return check


CHECKS = {"bed_change": change, "bed_strips": strips, "bed_strip_in_flume": strip_in_flume}
