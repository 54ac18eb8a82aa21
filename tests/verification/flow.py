"""A run of the verification: its case, its snapshots, and the budgets of mass, momentum and energy that follow from them."""

import math
import tomllib

import h5py
import numpy

from neighbours import velocity_gradients
from runs import RiffleRun


class Snapshot:
    """All particles at one time, ordered by their numbers: x, y, z, u, v, w (y and v 0 in a plane), density, pressure, eddy_viscosity (SI)."""

    def __init__(self, group):
        order = numpy.argsort(group["id"][:], kind="stable")
        position, velocity = group["position"][:], group["velocity"][:]
        self.time = float(group.attrs["time"])
        self.id = group["id"][:][order]
        self.x, self.y, self.z = (position[order, axis].astype(float) for axis in range(3))
        self.u, self.v, self.w = (velocity[order, axis].astype(float) for axis in range(3))
        for name in ("density", "pressure", "eddy_viscosity"):
            setattr(self, name, group[name][:][order].astype(float))


class Flow(RiffleRun):
    """Results of a two-dimensional run; lengths in m, masses and forces per unit width."""

    def _read(self):
        super()._read()
        with h5py.File(self.folder / "results.h5", "r") as file:
            build, version = (bytes(file.attrs[key]).decode() for key in ("build", "riffle_version"))
            self.build = f"Riffle {version}, {build}, {self.values['instruction_set']}"
            text = file["/case/text"][()]
            self.parameters = tomllib.loads(text.decode() if isinstance(text, bytes) else text)
            self.names = sorted(file["/snapshots"])
            state = file["/state"]
            self.mass = state["mass"][:][numpy.argsort(state["id"][:], kind="stable")]
            self.ids = numpy.sort(state["id"][:])
            # The probe of the case, where it has one, is sampled more often than the standard one.
            probes = file["/probes"] if "/probes" in file else {}
            force = [group for group in probes.values() if group.attrs["kind"] in ("force", b"force")]
            force.sort(key=lambda group: -len(group["time"]))
            self.forces = {key: data[:] for key, data in force[0].items()} if force else {}
        channel, fluid = self.parameters["channel"], self.parameters["fluid"]
        angle = math.atan(channel["slope"])
        self.gravity_x, self.gravity_z = fluid["gravity"] * math.sin(angle), fluid["gravity"] * math.cos(angle)
        self.density, self.viscosity = fluid["density"], fluid["kinematic_viscosity"]
        self.length, self.depth = channel["length"], self.values["total_depth"]
        self.spacing = self.parameters["numerics"]["spacing"]
        self.smoothing_length = self.spacing * self.parameters["numerics"]["smoothing_ratio"]
        self.periods = (self.length if channel["ends"] == "periodic" else None,
                        self.depth if channel["top"] == "periodic" else None)

    def snapshot(self, index):
        with h5py.File(self.folder / "results.h5", "r") as file:
            return Snapshot(file["/snapshots"][self.names[index]])

    def snapshots(self, at_most=None):
        """The snapshots in order; of more than `at_most`, as many evenly spread ones, the first and last among them."""
        count = len(self.names)
        chosen = range(count)
        if at_most and count > at_most:
            chosen = sorted({round(i * (count - 1) / (at_most - 1)) for i in range(at_most)})
        for index in chosen:
            yield self.snapshot(index)

    def speeds(self, begin, end):
        """The largest speed of a particle and the largest rms over the particles, over the snapshots of a period, over sqrt(g H)."""
        scale = math.sqrt(self.gravity_z * self.depth)
        squares = [s.u**2 + s.v**2 + s.w**2 for s in self.snapshots() if begin <= s.time <= end]
        return max(math.sqrt(v.max()) for v in squares) / scale, max(math.sqrt(v.mean()) for v in squares) / scale

    @property
    def cost(self):
        """Seconds of one core."""
        return self.values["wall_clock_seconds"] * self.values["threads"]

    @property
    def cost_text(self):
        return f"{self.values['particles']:.0f} particles, {self.values['steps']:.0f} steps, {self.cost:.0f} s of a core"


def lost_mass(flow):
    """Share of the mass at the start that the last snapshot lacks: particles gone, or outside the box by more than a spacing."""
    first, last = flow.snapshot(0), flow.snapshot(-1)
    inside = numpy.isin(first.id, last.id).sum() == first.id.size and flow.ids.size == first.id.size
    if not inside:
        return 1.0 - numpy.isin(first.id, last.id).mean()
    gone = ~numpy.isfinite(last.x + last.z)
    if flow.periods[1] is None:
        gone |= last.z < -flow.spacing
    if flow.periods[0] is None:
        gone |= (last.x < -flow.spacing) | (last.x > flow.length + flow.spacing)
    return flow.mass[gone].sum() / flow.mass.sum()


def _impulse(flow, times, values):
    """Integral of a force's record from the first to the last of `times`."""
    cumulated = numpy.concatenate(([0.0], numpy.cumsum(0.5 * (values[1:] + values[:-1]) * numpy.diff(flow.forces["time"]))))
    return numpy.diff(numpy.interp(times, flow.forces["time"], cumulated))[0]


def momentum_budget(flow):
    """Change of momentum less the impulse of all forces, between the first and last snapshot that the record of forces spans.

    Returns (x, z), each over the impulse of the forces' magnitudes (without forces: over M times the rms velocity), and the scale in words.
    """
    snapshots = list(flow.snapshots())
    if not flow.forces:
        first, last = snapshots[0], snapshots[-1]
        m = flow.mass
        speed = math.sqrt((m * (first.u**2 + first.w**2)).sum() / m.sum())
        change = [(m * (getattr(last, c) - getattr(first, c))).sum() / (m.sum() * speed) for c in ("u", "w")]
        return change[0], change[1], "mass times rms velocity"
    times = flow.forces["time"]
    inside = [s for s in snapshots if times[0] <= s.time <= times[-1]]
    first, last = inside[0], inside[-1]
    span = [first.time, last.time]
    force = flow.forces
    weight = flow.mass.sum() * flow.gravity_z
    held = [force[name] for name in ("bed_drag", "wall_force", "vegetation_drag", "porous_drag") if name in force]
    along = force["weight_component"] - sum(held)
    sizes = numpy.abs(force["weight_component"]) + sum(numpy.abs(each) for each in held)
    change_x = (flow.mass * (last.u - first.u)).sum() - _impulse(flow, span, along)
    change_z = (flow.mass * (last.w - first.w)).sum() - _impulse(flow, span, force["wall_normal_force"] - weight)
    scale = max(_impulse(flow, span, sizes), 1e-12 * flow.mass.sum())
    # With wall forces that are nothing but noise the flow's own momentum is the scale.
    scale = max(scale, flow.mass.sum() * math.sqrt(numpy.mean(first.u**2 + first.w**2)))
    return change_x / scale, change_z / max(scale, weight * (span[1] - span[0])), "impulse of the forces"


def elastic_energy(flow, density):
    """Energy of compression per mass: the integral of p / rho^2 from rho0."""
    c, ratio = flow.values["sound_speed"], density / flow.density
    if flow.parameters["numerics"]["equation_of_state"] == "tait":
        return c**2 / 7 * (ratio**6 / 6 + 1 / ratio - 7 / 6)
    return c**2 * (numpy.log(ratio) + 1 / ratio - 1)


class Energy:
    """Time series of a run's energies per unit width, J/m, and the work done on it.

    `dissipation` is the work that viscosity has taken since the start, from the velocity gradients in the snapshots
    (mu grad u : grad u for Morris' form, 2 mu S : S for the form along the line of centres); `weight` is the work of gravity along
    the bed. `balance` is what is left of total - weight + dissipation - total(0): dissipation of the scheme itself, if negative.
    """

    def __init__(self, flow, snapshots=41):
        rows = []
        line_of_centres = flow.parameters["numerics"]["viscosity"] == "monaghan-gingold"
        for s in flow.snapshots(snapshots):
            m = flow.mass
            g = velocity_gradients(s.x, s.z, s.u, s.w, m / s.density, flow.smoothing_length, flow.periods)
            if line_of_centres:
                square = 2 * (g[0] ** 2 + g[3] ** 2) + (g[1] + g[2]) ** 2
            else:
                square = sum(component**2 for component in g)
            rows.append([s.time, (0.5 * m * (s.u**2 + s.w**2)).sum(), (m * flow.gravity_z * s.z).sum(),
                         (m * elastic_energy(flow, s.density)).sum(), (m * (flow.viscosity + s.eddy_viscosity) * square).sum(),
                         (m * s.x).sum() * flow.gravity_x])
        self.time, self.kinetic, self.potential, self.elastic, self.rate, place = numpy.array(rows).T
        cumulate = lambda t, v: numpy.concatenate(([0.0], numpy.cumsum(0.5 * (v[1:] + v[:-1]) * numpy.diff(t))))
        self.dissipation = cumulate(self.time, self.rate)
        if flow.periods[0] is None:
            self.weight = place - place[0]
        else:  # who leaves at one end enters at the other: the places do not tell the way
            time = flow.series["time"]
            power = flow.mass.sum() * flow.gravity_x * flow.series["total_mean_velocity"]
            self.weight = numpy.interp(self.time, time, cumulate(time, power))
            self.weight -= self.weight[0]
        self.total = self.kinetic + self.potential + self.elastic
        self.balance = self.total - self.total[0] - self.weight + self.dissipation
