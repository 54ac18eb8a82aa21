// Picture of the flow field: the particles of one snapshot, drawn into a bitmap that lies behind the axes of a
// figure, so that ten thousand particles stay quick and the picture can be zoomed and saved with its axes.

const field = (() => {
  'use strict';

  // Viridis (van der Walt and Smith 2015), read alike with and without colour blindness, and a diverging map.
  const sequential = ['#440154', '#482878', '#3e4989', '#31688e', '#26828e', '#1f9e89', '#35b779', '#6ece58', '#b5de2b', '#fde725'];
  const diverging = ['#053061', '#2f79b5', '#a5cee3', '#f7f7f7', '#f7b799', '#ca4741', '#67001f'];
  const quantities = [
    { key: 'velocity', button: 'velocity u', title: '<i>u</i> (m/s)', factor: 1, unit: 'm/s', name: 'u', map: sequential },
    { key: 'vertical_velocity', button: 'velocity w', title: '<i>w</i> (mm/s)', factor: 1000, unit: 'mm/s', name: 'w', map: diverging, symmetric: true },
    { key: 'pressure', button: 'pressure', title: '<i>p</i> (Pa)', factor: 1, unit: 'Pa', name: 'p', map: sequential },
    { key: 'eddy_viscosity', button: 'eddy viscosity', title: '<i>ν</i><sub>t</sub> (mm²/s)', factor: 1e6, unit: 'mm²/s', name: 'ν_t', map: sequential },
  ];
  const scale = map => map.map((value, i) => [i / (map.length - 1), value]);
  const channels = map => map.map(text => [1, 3, 5].map(i => parseInt(text.slice(i, i + 2), 16)));

  function colourAt(stops, share) {
    const position = Math.min(1, Math.max(0, share)) * (stops.length - 1);
    const low = Math.min(stops.length - 2, Math.floor(position)), part = position - low;
    const mix = stops[low].map((value, i) => Math.round(value + part * (stops[low + 1][i] - value)));
    return `rgb(${mix.join(',')})`;
  }

  // Range that holds all but the extreme 0.5 % at each end, so that one odd particle does not eat the colours.
  function range(values, symmetric) {
    const sorted = values.filter(Number.isFinite).sort((a, b) => a - b);
    if (!sorted.length) return [0, 1];
    let low = sorted[Math.floor(0.005 * (sorted.length - 1))], high = sorted[Math.ceil(0.995 * (sorted.length - 1))];
    if (symmetric) { high = Math.max(Math.abs(low), Math.abs(high)); low = -high; }
    if (low === high) high = low + (Math.abs(low) || 1);
    return [low, high];
  }

  const available = snapshot => quantities.filter(item => figures.has(snapshot, item.key) &&
    (item.key !== 'eddy_viscosity' || figures.some(snapshot[item.key])));

  // `period`: length after which the channel repeats, mm; particles near its ends are drawn at both. 0: none.
  function paint(snapshot, values, limits, map, view, width, height, period) {
    const canvas = document.createElement('canvas');
    canvas.width = width;
    canvas.height = height;
    const pen = canvas.getContext('2d'), stops = channels(map);
    const sx = width / (view.x1 - view.x0), sz = height / (view.z1 - view.z0);
    const rx = Math.max(1, 0.7 * snapshot.spacing * 1000 * sx), rz = Math.max(1, 0.7 * snapshot.spacing * 1000 * sz);
    for (let i = 0; i < values.length; ++i) {
      if (values[i] === null) continue;
      const at = 1000 * snapshot.x[i], y = height - (1000 * snapshot.z[i] - view.z0) * sz;
      pen.fillStyle = colourAt(stops, (values[i] - limits[0]) / (limits[1] - limits[0]));
      for (const along of period ? [at - period, at, at + period] : [at]) {
        const x = (along - view.x0) * sx;
        if (x < -rx || x > width + rx || y < -rz || y > height + rz) continue;
        pen.beginPath();
        pen.ellipse(x, y, rx, rz, 0, 0, 2 * Math.PI);
        pen.fill();
      }
    }
    return canvas;
  }

  function nearest(snapshot, x, height) {
    let best = -1, least = (1.5 * snapshot.spacing) ** 2;
    for (let i = 0; i < snapshot.x.length; ++i) {
      const distance = (snapshot.x[i] - x) ** 2 + (snapshot.z[i] - height) ** 2;
      if (distance < least) { least = distance; best = i; }
    }
    return best;
  }

  // Draw into `plot`; the buttons go into `choices`, what lies under the pointer into `readout`.
  function draw(data, plot, choices, readout, config, width_now) {
    const snapshot = data.snapshot, items = available(snapshot), g = data.geometry;
    const whole = { x0: 0, x1: 1000 * snapshot.x_end, z0: 0, z1: 1100 * (g.mean_level || g.total_depth) };
    let view = { ...whole }, current = items[0];

    function picture() {
      const values = snapshot[current.key].map(value => value === null ? null : current.factor * value);
      const limits = range(values, current.symmetric);
      const density = Math.min(2600, 2 * Math.max(600, width_now()));
      const height = Math.max(60, Math.round(density * (view.z1 - view.z0) / (view.x1 - view.x0)));
      const canvas = paint(snapshot, values, limits, current.map, view, density, Math.min(2000, height),
        g.periodic && !snapshot.left_out ? 1000 * g.length : 0);
      return { limits, source: canvas.toDataURL('image/png') };
    }

    function build() {
      const { limits, source } = picture(), width = Math.max(280, width_now());
      const narrow = width < 620;
      // Equal scales along both axes, unless the picture would become too flat to read.
      const inner = width - (narrow ? 70 : 165);
      const tall = Math.max(narrow ? 150 : 120, Math.min(420, inner * (whole.z1 - whole.z0) / (whole.x1 - whole.x0)));
      const traces = [{
        type: 'scatter', mode: 'markers', x: [null], y: [null], showlegend: false, hoverinfo: 'skip',
        marker: { color: [limits[0]], cmin: limits[0], cmax: limits[1], colorscale: scale(current.map), showscale: true,
          colorbar: narrow
            ? { title: { text: current.title, side: 'top' }, orientation: 'h', thickness: 12, outlinewidth: 0, y: -0.42, yanchor: 'top', nticks: 5 }
            : { title: { text: current.title, side: 'right' }, thickness: 14, outlinewidth: 0, len: 1.05, nticks: 5 } },
      }];
      if (figures.has(snapshot.surface, 'x', 'z')) {
        traces.push(figures.line('free surface', snapshot.surface.x.map(x => 1000 * x), snapshot.surface.z.map(z => 1000 * z), figures.colour.column, { line: { width: 2 } }));
      }
      const shapes = g.rough ? [g.crest, g.datum].map(z => ({ type: 'line', xref: 'paper', x0: 0, x1: 1, y0: 1000 * z, y1: 1000 * z,
        line: { color: '#ffffff', width: 1.2, dash: z === g.crest ? 'dash' : 'dot' } })) : [];
      const layout = figures.layout({
        xaxis: figures.axis('<i>x</i> down the channel (mm)', { range: [view.x0, view.x1], showgrid: false }),
        yaxis: figures.axis('<i>z</i> (mm)', { range: [view.z0, view.z1], showgrid: false, nticks: 5 }),
        shapes, margin: { l: 56, r: 10, t: 10, b: 48 },
        images: [{ source, xref: 'x', yref: 'y', x: view.x0, y: view.z1, sizex: view.x1 - view.x0, sizey: view.z1 - view.z0,
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
    show();

    plot.on('plotly_relayout', change => {
      if (change['xaxis.autorange'] || change['yaxis.autorange']) view = { ...whole };
      else if (Object.keys(change).some(key => /^[xy]axis\.range/.test(key))) {
        const [x0, x1] = plot.layout.xaxis.range, [z0, z1] = plot.layout.yaxis.range;
        view = { x0, x1, z0, z1 };
      } else return;
      show();
    });
    plot.addEventListener('mousemove', event => {
      const full = plot._fullLayout, box = plot.getBoundingClientRect();
      const x = full.xaxis.p2d(event.clientX - box.left - full._size.l), height = full.yaxis.p2d(event.clientY - box.top - full._size.t);
      const i = nearest(snapshot, x / 1000, height / 1000);
      readout.textContent = i < 0 ? '' : `Particle at x = ${(1000 * snapshot.x[i]).toFixed(1)} mm, z = ${(1000 * snapshot.z[i]).toFixed(1)} mm: ` +
        items.map(item => `${item.name} = ${(item.factor * snapshot[item.key][i]).toPrecision(4)} ${item.unit}`).join(', ');
    });
    return show;
  }

  const caption = data => `Particles of the snapshot at <i>t</i> = ${figures.significant(data.snapshot.time)} s, each drawn with the size of the ` +
    `particle spacing (${figures.significant(1000 * data.snapshot.spacing)} mm) and coloured by the chosen quantity.` +
    (data.geometry.rough ? ' White lines: crests of the bed elements (dashed) and datum (dotted); below the crests the elements act on the water by their drag.' : '') +
    (data.snapshot.y !== undefined ? ` A slice one particle spacing thick at <i>y</i> = ${figures.significant(1000 * data.snapshot.y)} mm.` : '') +
    (data.snapshot.left_out ? ` Shown: the first ${figures.significant(1000 * data.snapshot.x_end)} mm of the channel.` : '');

  // The particles as CSV, SI.
  function csv(snapshot) {
    const shown = available(snapshot), unit = { velocity: 'm/s', vertical_velocity: 'm/s', pressure: 'Pa', eddy_viscosity: 'm2/s' };
    return save.comment(`particles of the snapshot at t = ${snapshot.time} s`) + save.rows([['x [m]', 'z [m]', ...shown.map(item => save.heading(item.key, unit[item.key]))],
      ...snapshot.x.map((x, i) => [x, snapshot.z[i], ...shown.map(item => snapshot[item.key][i])])]);
  }

  return { draw, caption, available, csv };
})();
