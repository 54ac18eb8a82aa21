// Picture of the flow field: the particles of a snapshot, drawn into a bitmap that lies behind the axes of a figure, so
// that ten thousand particles stay quick and the picture can be zoomed and saved with its axes. A slider leads through
// the snapshots.

const field = (() => {
  'use strict';

  // Viridis (van der Walt and Smith 2015), read alike with and without colour blindness, and a diverging map.
  const sequential = ['#440154', '#482878', '#3e4989', '#31688e', '#26828e', '#1f9e89', '#35b779', '#6ece58', '#b5de2b', '#fde725'];
  const diverging = ['#053061', '#2f79b5', '#a5cee3', '#f7f7f7', '#f7b799', '#ca4741', '#67001f'];
  const quantities = [
    { key: 'velocity', button: 'velocity u', symbol: '<i>u</i>', unit: 'm/s', name: 'u', map: sequential },
    { key: 'vertical_velocity', button: 'velocity w', symbol: '<i>w</i>', unit: 'm/s', name: 'w', map: diverging, symmetric: true },
    { key: 'pressure', button: 'pressure', symbol: '<i>p</i>', unit: 'Pa', name: 'p', map: sequential },
    { key: 'eddy_viscosity', button: 'eddy viscosity', symbol: '<i>ν</i><sub>t</sub>', unit: 'm2/s', name: 'ν_t', map: sequential },
  ];
  const scale = map => map.map((value, i) => [i / (map.length - 1), value]);
  const channels = map => map.map(text => [1, 3, 5].map(i => parseInt(text.slice(i, i + 2), 16)));

  // Values of a frame: 16-bit steps between the ends of the quantity's range, the highest for not-a-number.
  function unpacked(text, [low, high]) {
    const bytes = atob(text), values = new Float64Array(bytes.length / 2);
    for (let i = 0; i < values.length; ++i) {
      const step = bytes.charCodeAt(2 * i) + 256 * bytes.charCodeAt(2 * i + 1);
      values[i] = step === 65535 ? NaN : low + (high - low) * step / 65534;
    }
    return values;
  }

  const available = picture => quantities.filter(({ key }) => picture.ranges[key] && (key !== 'eddy_viscosity' || picture.ranges[key][1] > 0));

  // The frame with its values spelled out, made when it is first shown.
  function frame_of(picture, number) {
    const frame = picture.frames[number];
    if (!frame.values) frame.values = Object.fromEntries(Object.keys(picture.ranges).map(key => [key, unpacked(frame[key], picture.ranges[key])]));
    return frame;
  }

  function mixed(stops, share) {
    const position = Math.min(1, Math.max(0, share)) * (stops.length - 1);
    const low = Math.min(stops.length - 2, Math.floor(position)), part = position - low;
    return stops[low].map((value, i) => Math.round(value + part * (stops[low + 1][i] - value)));
  }

  const colourAt = (stops, share) => `rgb(${mixed(stops, share).join(',')})`;

  // Range that holds all but the extreme 0.5 % at each end over all frames, so that one odd particle does not eat the
  // colours and those of two moments can be compared.
  function range(picture, item) {
    const sample = [];
    const stride = Math.max(1, Math.ceil(picture.frames.reduce((sum, { count }) => sum + count, 0) / 50000));
    picture.frames.forEach((_, number) => {
      const values = frame_of(picture, number).values[item.key];
      for (let i = number % stride; i < values.length; i += stride) if (Number.isFinite(values[i])) sample.push(values[i]);
    });
    sample.sort((a, b) => a - b);
    if (!sample.length) return [0, 1];
    let low = sample[Math.floor(0.005 * (sample.length - 1))], high = sample[Math.ceil(0.995 * (sample.length - 1))];
    if (item.symmetric) { high = Math.max(Math.abs(low), Math.abs(high)); low = -high; }
    if (low === high) high = low + (Math.abs(low) || 1);
    return [low, high];
  }

  // `period`: length after which the channel repeats, m; particles near its ends are drawn at both. 0: none.
  function paint(values, frame, spacing, limits, map, view, width, height, period) {
    const canvas = document.createElement('canvas');
    canvas.width = width;
    canvas.height = height;
    const pen = canvas.getContext('2d'), stops = channels(map), { x: xs, z: zs } = frame.values;
    const sx = width / (view.x1 - view.x0), sz = height / (view.z1 - view.z0);
    const rx = Math.max(1, 0.7 * spacing * sx), rz = Math.max(1, 0.7 * spacing * sz);
    for (let i = 0; i < values.length; ++i) {
      if (!Number.isFinite(values[i])) continue;
      const y = height - (zs[i] - view.z0) * sz;
      pen.fillStyle = colourAt(stops, (values[i] - limits[0]) / (limits[1] - limits[0]));
      for (const along of period ? [xs[i] - period, xs[i], xs[i] + period] : [xs[i]]) {
        const x = (along - view.x0) * sx;
        if (x < -rx || x > width + rx || y < -rz || y > height + rz) continue;
        pen.beginPath();
        pen.ellipse(x, y, rx, rz, 0, 0, 2 * Math.PI);
        pen.fill();
      }
    }
    return canvas;
  }

  function nearest(frame, spacing, x, height) {
    let best = -1, least = (1.5 * spacing) ** 2;
    const { x: xs, z: zs } = frame.values;
    for (let i = 0; i < xs.length; ++i) {
      const distance = (xs[i] - x) ** 2 + (zs[i] - height) ** 2;
      if (distance < least) { least = distance; best = i; }
    }
    return best;
  }

  // Parts with a resistance of their own, in the colours of `riffle preview`.
  const zone_colours = { vegetation: '#3f7d3a', porous: '#8a7456', bed: '#b5651d' };
  const zone_words = { vegetation: 'vegetation', porous: 'porous zones', bed: 'patches of the bed' };

  const closed = outline => ({ x: [...outline.x, outline.x[0]], z: [...outline.z, outline.z[0]] });

  // Bodies and spheres as filled outlines, bed, lid and end walls as lines, in the unit of the axes.
  function boundaries(picture, geometry, frame, factor, top) {
    const made = [];
    const solid = (name, xs, zs, extra) => made.push({ type: 'scatter', mode: 'lines', name, x: xs.map(x => factor * x), y: zs.map(z => factor * z), fill: 'toself',
      fillcolor: figures.colour.body, line: { color: figures.colour.edge, width: 1.2 }, hoverinfo: 'skip', showlegend: false, ...extra });
    const told = new Set();
    for (const zone of picture.zones) {
        const colour = zone_colours[zone.kind], flat = zone.x.length === 2;
        const { x, z } = flat ? zone : closed(zone);
        // A rim of white parts it from the water behind it, whatever the colour there.
        if (!flat) solid(zone.name, x, z, { fill: 'none', line: { color: '#ffffff', width: 3 } });
        solid(zone_words[zone.kind], x, z, { fill: flat ? 'none' : 'toself', fillcolor: `${colour}38`, line: { color: colour, width: flat ? 6 : 1.6, dash: flat ? 'solid' : 'dash' },
          showlegend: !told.has(zone.kind), legendgroup: zone.kind });
        told.add(zone.kind);
    }
    frame.bodies.forEach((body, i) => { const { x, z } = closed(body); solid('bodies', x, z, { showlegend: i === 0, legendgroup: 'bodies' }); });
    if (picture.spheres.length) {
      const xs = [], zs = [], steps = 32;
      for (const [x, z, radius] of picture.spheres) {
        for (let i = 0; i <= steps; ++i) { xs.push(x + radius * Math.cos(2 * Math.PI * i / steps)); zs.push(z + radius * Math.sin(2 * Math.PI * i / steps)); }
        xs.push(null); zs.push(null);
      }
      made.push({ type: 'scatter', mode: 'lines', name: 'spheres of the bed', x: xs.map(x => (x === null ? null : factor * x)), y: zs.map(z => (z === null ? null : factor * z)),
        line: { color: '#ffffff', width: 1.4 }, hoverinfo: 'skip', showlegend: false });
    }
    const wall = (xs, zs) => made.push({ type: 'scatter', mode: 'lines', x: xs.map(x => factor * x), y: zs.map(z => factor * z), line: { color: figures.colour.edge, width: 3 },
      hoverinfo: 'skip', showlegend: false });
    if (geometry.bed) wall([0, geometry.length], [0, 0]);
    if (geometry.lid !== null) wall([0, geometry.length], [geometry.lid, geometry.lid]);
    if (geometry.ends !== null) for (const x of [0, geometry.length]) wall([x, x], [0, Math.min(geometry.ends, top)]);
    return made;
  }

  // Draw into `plot`; buttons and slider go into `choices`, what lies under the pointer into `readout`.
  function draw(data, plot, choices, readout, config, width_now) {
    const picture = data.field, items = available(picture), g = data.geometry;
    // Equal scales along both axes, unless the picture would become too flat to read; a margin shows bed and walls.
    const edge = 0.012 * Math.max(picture.x_end, picture.top);
    const whole = { x0: g.ends !== null ? -edge : 0, x1: picture.x_end + (g.ends !== null ? edge : 0), z0: g.falls ? -g.falls : g.bed ? -edge : 0, z1: picture.top + edge };
    const { unit, factor } = units.scale('m', Math.max(picture.x_end, picture.top));
    let view = { ...whole }, current = items[0], number = picture.frames.length - 1;
    const limits_of = new Map();
    const limits_now = () => { if (!limits_of.has(current.key)) limits_of.set(current.key, range(picture, current)); return limits_of.get(current.key); };

    function bitmap(limits) {
      const frame = frame_of(picture, number), density = Math.min(2600, 2 * Math.max(600, width_now()));
      const height = Math.max(60, Math.round(density * (view.z1 - view.z0) / (view.x1 - view.x0)));
      return paint(frame.values[current.key], frame, picture.spacing, limits, current.map, view, density, Math.min(2000, height),
        g.periodic && !picture.left_out ? g.length : 0).toDataURL('image/png');
    }

    function build() {
      const limits = limits_now(), width = Math.max(280, width_now()), narrow = width < 620, frame = frame_of(picture, number);
      const shown = units.scale(current.unit, Math.max(...limits.map(Math.abs)));
      const inner = width - (narrow ? 70 : 165), most = narrow ? 360 : 460;
      const tall = Math.max(150, Math.min(most, inner * (whole.z1 - whole.z0) / (whole.x1 - whole.x0)));
      const colours = limits.map(value => shown.factor * value);
      const traces = [{
        type: 'scatter', mode: 'markers', x: [null], y: [null], showlegend: false, hoverinfo: 'skip',
        marker: { color: [colours[0]], cmin: colours[0], cmax: colours[1], colorscale: scale(current.map), showscale: true,
          colorbar: narrow
            ? { title: { text: `${current.symbol} (${shown.unit})`, side: 'top' }, orientation: 'h', thickness: 12, outlinewidth: 0, y: -0.42, yanchor: 'top', nticks: 5 }
            : { title: { text: `${current.symbol} (${shown.unit})`, side: 'right' }, thickness: 14, outlinewidth: 0, len: 1.05, nticks: 5 } },
      }, ...boundaries(picture, g, frame, factor, whole.z1)];
      if (figures.has(frame.surface, 'x', 'z')) {
        traces.push({ type: 'scatter', mode: 'lines', name: 'free surface', x: frame.surface.x.map(x => (x === null ? null : factor * x)),
          y: frame.surface.z.map(z => (z === null ? null : factor * z)), connectgaps: false, line: { color: figures.colour.surface, width: 2, simplify: false } });
      }
      const shapes = g.rough && !picture.spheres.length ? [g.crest, g.datum].map(z => ({ type: 'line', xref: 'paper', x0: 0, x1: 1, y0: factor * z, y1: factor * z,
        line: { color: '#ffffff', width: 1.2, dash: z === g.crest ? 'dash' : 'dot' } })) : [];
      // Where the scales are equal the picture keeps them at every width; a flat picture is stretched upward.
      const equal = inner * (whole.z1 - whole.z0) / (whole.x1 - whole.x0) >= 150;
      const layout = figures.layout({
        xaxis: figures.axis(`<i>x</i> along the channel (${unit})`, { range: [factor * view.x0, factor * view.x1], showgrid: false, constrain: 'domain' }),
        yaxis: figures.axis(`<i>z</i> (${unit})`, { range: [factor * view.z0, factor * view.z1], showgrid: false, nticks: 5, ...(equal ? { scaleanchor: 'x', constrain: 'domain' } : {}) }),
        shapes, margin: { l: 56, r: 10, t: 10, b: 48 }, hovermode: false,
        images: [{ source: bitmap(limits), xref: 'x', yref: 'y', x: factor * view.x0, y: factor * view.z1, sizex: factor * (view.x1 - view.x0), sizey: factor * (view.z1 - view.z0),
          sizing: 'stretch', layer: 'below' }],
        width, height: Math.round(tall + (narrow ? 170 : 92)),
      });
      return { traces, layout };
    }

    const show = () => { const { traces, layout } = build(); return Plotly.react(plot, traces, layout, config); };
    const buttons = items.map(item => {
      const button = document.createElement('button');
      button.type = 'button';
      button.textContent = item.button;
      button.addEventListener('click', () => { current = item; press(); show(); });
      choices.append(button);
      return button;
    });
    const press = () => buttons.forEach((button, i) => button.setAttribute('aria-pressed', String(items[i] === current)));
    press();
    if (picture.frames.length > 1) choices.append(slider());
    show();

    function slider() {
      const label = document.createElement('label'), input = document.createElement('input'), words = document.createElement('span');
      label.className = 'frames';
      const tell = () => { words.textContent = `t = ${figures.significant(picture.frames[number].time)} s`; input.setAttribute('aria-valuetext', words.textContent); };
      Object.assign(input, { type: 'range', min: 0, max: picture.frames.length - 1, step: 1, value: number });
      input.setAttribute('aria-label', 'Time of the snapshot');
      let due = 0;
      input.addEventListener('input', () => {
        number = Number(input.value);
        tell();
        cancelAnimationFrame(due);
        due = requestAnimationFrame(show);
      });
      tell();
      label.append('Snapshot ', input, ' ', words);
      return label;
    }

    plot.on('plotly_relayout', change => {
      if (change['xaxis.autorange'] || change['yaxis.autorange']) view = { ...whole };
      else if (Object.keys(change).some(key => /^[xy]axis\.range/.test(key))) {
        const [x0, x1] = plot.layout.xaxis.range, [z0, z1] = plot.layout.yaxis.range;
        view = { x0: x0 / factor, x1: x1 / factor, z0: z0 / factor, z1: z1 / factor };
      } else return;
      show();
    });
    plot.addEventListener('mousemove', event => {
      const full = plot._fullLayout, box = plot.getBoundingClientRect(), frame = frame_of(picture, number);
      const x = full.xaxis.p2d(event.clientX - box.left - full.xaxis._offset) / factor, height = full.yaxis.p2d(event.clientY - box.top - full.yaxis._offset) / factor;
      const i = nearest(frame, picture.spacing, x, height);
      readout.textContent = i < 0 ? '' : `Particle at x = ${(factor * frame.values.x[i]).toPrecision(4)} ${unit}, z = ${(factor * frame.values.z[i]).toPrecision(4)} ${unit}: ` +
        items.map(item => `${item.name} = ${frame.values[item.key][i].toPrecision(4)} ${units.pretty(item.unit)}`).join(', ');
    });
    return { show, frame: () => number };
  }

  const caption = data => {
    const picture = data.field, times = picture.frames.map(({ time }) => figures.significant(time)), first = times[0], last = times[times.length - 1];
    return `Particles of ${picture.frames.length > 1 ? `${picture.frames.length} snapshots from <i>t</i> = ${first} s to ${last} s (at first the last one)` : `the snapshot at <i>t</i> = ${last} s`}, ` +
      `each drawn with the size of the particle spacing (${figures.significant(1000 * picture.spacing)} mm) and coloured by the chosen quantity.` +
      (data.geometry.rough && !picture.spheres.length ? ' White lines: crests of the bed elements (dashed) and datum (dotted); below the crests the elements act on the water by their drag.' : '') +
      (picture.spheres.length ? ' White circles: the spheres of the bed where the slice cuts them, which act on the water by their drag.' : '') +
      (picture.frames.some(({ bodies }) => bodies.length) ? ' Grey: bodies.' : '') +
      Object.entries(zone_words).map(([kind, words]) => {
        const names = picture.zones.filter(zone => zone.kind === kind).map(({ name }) => name);
        return names.length ? ` ${kind === 'bed' ? 'Brown lines along the bed' : `Outlined in ${kind === 'porous' ? 'grey-brown' : 'green'}`}: ${words} (${names.join(', ')}).` : '';
      }).join('') +
      (picture.y !== undefined ? ` A slice one particle spacing thick at <i>y</i> = ${figures.significant(1000 * picture.y)} mm.` : '') +
      (picture.left_out ? ` Shown: the first ${figures.significant(1000 * picture.x_end)} mm of the channel.` : '');
  };

  // The particles of the frame shown as CSV, SI.
  function csv(data, number) {
    const picture = data.field, shown = available(picture), frame = frame_of(picture, number);
    return save.comment(`particles of the snapshot at t = ${frame.time} s; values to 1/65534 of their range in the picture`) +
      save.rows([['x [m]', 'z [m]', ...shown.map(item => save.heading(item.key, item.unit))],
        ...Array.from(frame.values.x, (x, i) => [x, frame.values.z[i], ...shown.map(item => frame.values[item.key][i])].map(value => (Number.isFinite(value) ? Number(value.toPrecision(6)) : value)))]);
  }

  // The colours of values on either side of zero, for pictures beside this one: for Plotly, and as so many steps of red,
  // green and blue.
  const about_zero = { scale: scale(diverging), steps: count => Array.from({ length: count }, (_, i) => mixed(channels(diverging), i / (count - 1))) };

  return { draw, caption, available, csv, unpacked, about_zero };
})();
