// The figures: each builder takes the report's data and gives { traces, layout, height, caption }, or null
// when the results file does not hold what it needs. Values come in SI; here they only get readable prefixes.

const figures = (() => {
  'use strict';

  // Okabe and Ito's palette, told apart by colour-blind readers; marks differ in shape or dash as well.
  const colour = {
    simulated: '#0072B2',
    column: '#D55E00',
    measured: '#009E73',
    resolved: '#CC79A7',
    pair: '#E69F00',
    reference: '#7a848e',
    window: 'rgba(0,114,178,0.10)',
    band: 'rgba(0,114,178,0.22)',
  };
  const ink = '#1b2026';
  const u = '<i>u</i>', z = '<i>z</i>', ustar = '<i>u</i><sub>∗</sub>', ks = '<i>k</i><sub>s</sub>';

  const millimetres = values => values.map(value => value === null ? null : 1000 * value);
  const scaled = (values, factor) => values.map(value => value === null ? null : factor * value);
  const has = (group, ...names) => Boolean(group) && names.every(name => Array.isArray(group[name]) && group[name].length > 0);
  const some = values => Array.isArray(values) && values.some(value => value !== null && value !== 0);

  // A number with so many significant digits, without an exponent where a reader would not write one.
  function significant(value, digits = 3) {
    if (value === null || value === undefined || !Number.isFinite(value)) return '–';
    if (value === 0) return '0';
    const size = Math.floor(Math.log10(Math.abs(value)));
    if (size < -4 || size > 6) {
      const mantissa = value / 10 ** size;
      return `${mantissa.toFixed(digits - 1)}·10<sup>${String(size).replace('-', '−')}</sup>`.replace(/^-/, '−');
    }
    return value.toFixed(Math.max(0, digits - 1 - size)).replace(/^-/, '−');
  }

  // Value and half-width of its interval to the same decimals: two digits of the half-width, and no more than six of
  // the value; a half-width below that is rounded up, not to nothing.
  function interval(value, half) {
    if (half >= 100) {
      const unit = 10 ** (Math.floor(Math.log10(half)) - 1);
      return [value, half].map(number => String(Math.round(number / unit) * unit).replace(/^-/, '−'));
    }
    const size = Math.floor(Math.log10(Math.max(Math.abs(value), half)));
    const decimals = Math.max(0, Math.min(9, 1 - Math.floor(Math.log10(half)), 5 - size));
    const shown = Math.ceil(half * 10 ** decimals - 0.5) || 1;
    return [value.toFixed(decimals).replace(/^-/, '−'), (shown / 10 ** decimals).toFixed(decimals)];
  }

  function axis(title, extra = {}) {
    return {
      title: { text: title, standoff: 8 }, automargin: true, showline: true, mirror: true, linecolor: '#4a535d',
      linewidth: 1, ticks: 'outside', ticklen: 5, tickcolor: '#4a535d', gridcolor: '#e6e9ed', zeroline: false,
      exponentformat: 'power', ...extra,
    };
  }

  function layout(extra) {
    return {
      font: { family: 'system-ui, "Segoe UI", "DejaVu Sans", "Liberation Sans", sans-serif', size: 13, color: ink },
      paper_bgcolor: '#ffffff', plot_bgcolor: '#ffffff', margin: { l: 60, r: 14, t: 10, b: 48 },
      hovermode: 'closest', hoverlabel: { font: { size: 12 } },
      legend: { orientation: 'h', x: 0, xanchor: 'left', y: 1.015, yanchor: 'bottom', font: { size: 12 },
                bgcolor: 'rgba(255,255,255,0)' },
      ...extra,
    };
  }

  const line = (name, x, y, color, extra = {}) => ({
    type: 'scatter', mode: 'lines', name, x, y, line: { color, width: 2, simplify: false, ...(extra.line || {}) },
    ...Object.fromEntries(Object.entries(extra).filter(([key]) => key !== 'line')),
  });
  const points = (name, x, y, color, extra = {}) => ({
    type: 'scatter', mode: 'markers', name, x, y,
    marker: { color, size: 6, ...(extra.marker || {}) },
    ...Object.fromEntries(Object.entries(extra).filter(([key]) => key !== 'marker')),
  });

  // Horizontal lines at the datum, the crest and the mean level, with their names at the right edge; `bed` moves
  // those of the bed to where the curves leave room.
  function heights(data, names = true, bed = 0.995) {
    const g = data.geometry;
    const marks = [];
    if (g.rough) marks.push([g.crest, 'crests', 'bottom'], [g.datum, 'datum', 'top']);
    if (g.mean_level) marks.push([g.mean_level, 'mean level', 'bottom']);
    return {
      shapes: marks.map(([height]) => ({
        type: 'line', xref: 'paper', x0: 0, x1: 1, y0: 1000 * height, y1: 1000 * height, layer: 'between',
        line: { color: colour.reference, width: 1, dash: 'dot' },
      })),
      annotations: names ? marks.map(([height, text, anchor]) => ({
        xref: 'paper', x: text === 'mean level' ? 0.995 : bed, xanchor: text !== 'mean level' && bed < 0.5 ? 'left' : 'right',
        y: 1000 * height, yanchor: bed < 0.5 ? 'bottom' : anchor, text, showarrow: false,
        font: { size: 11, color: '#56606b' }, borderpad: 1,
      })) : [],
    };
  }

  const heightAxis = (data, extra = {}) =>
    axis(`${z} above the bed level (mm)`, { range: [0, 1080 * (data.geometry.mean_level || data.geometry.total_depth)], ...extra });

  const windowText = data => data.profiles && data.profiles.window_end
    ? `Averages over ${significant(data.profiles.window_start)}–${significant(data.profiles.window_end)} s.` : '';

  // (1) u over the depth
  function velocity(data) {
    const p = data.profiles, c = data.column, m = data.measured && data.measured.profile;
    if (!has(p, 'z', 'velocity')) return null;
    const height = millimetres(p.z), traces = [];
    if (has(p, 'velocity_half_width')) {
      const low = p.velocity.map((value, i) => value - (p.velocity_half_width[i] ?? 0));
      const high = p.velocity.map((value, i) => value + (p.velocity_half_width[i] ?? 0));
      traces.push(line('95 % interval', low.concat(high.slice().reverse()), height.concat(height.slice().reverse()), colour.simulated,
        { line: { width: 0 }, fill: 'toself', fillcolor: colour.band, hoverinfo: 'skip', showlegend: true }));
    }
    if (has(c, 'z', 'velocity')) traces.push(line('column twin', c.velocity, millimetres(c.z), colour.column));
    if (m && m.kind === 'law') traces.push(line('measured (log law)', m.velocity, millimetres(m.z), colour.measured, { line: { dash: 'dash' } }));
    if (m && m.kind === 'points') {
      traces.push(points('measured', m.velocity, millimetres(m.z), colour.measured, {
        marker: { symbol: 'diamond-open', size: 8, line: { width: 1.5 } },
        ...(has(m, 'uncertainty') ? { error_x: { type: 'data', array: m.uncertainty, thickness: 1, width: 3 } } : {}),
      }));
    }
    traces.push(points('simulated', p.velocity, height, colour.simulated, {
      hovertemplate: 'u = %{x:.4f} m/s<br>z = %{y:.2f} mm<extra>simulated</extra>' }));
    const measuredWords = !m ? '' : m.kind === 'law'
      ? ` The dashed line is the rough log law with the measured ${ustar} and ${ks}, its zero at the datum.`
      : ' Diamonds are the measured profile.';
    return {
      traces, height: 460,
      layout: layout({ xaxis: axis(`mean velocity ${u} (m/s)`, { rangemode: 'tozero' }), yaxis: heightAxis(data), ...heights(data) }),
      caption: `Streamwise velocity over the depth: mean of the particles in each layer and over time, with its 95 % confidence ` +
        `interval, against the steady one-dimensional solution of the same model (column twin).${measuredWords} ${windowText(data)}`,
    };
  }

  // (2) semi-logarithmic
  function logLaw(data) {
    const p = data.profiles, c = data.column, law = data.log_law, m = data.measured && data.measured.profile;
    if (!has(p, 'z', 'velocity') || !law || !law.valid) return null;
    const over = (height, value) => {
      const x = [], y = [];
      height.forEach((at, i) => {
        const above = (at - law.zero_plane) / law.equivalent_roughness;
        if (above > 0.02 && value[i] !== null && value[i] > 0) { x.push(above); y.push(value[i] / law.friction_velocity); }
      });
      return [x, y];
    };
    const traces = [];
    if (has(c, 'z', 'velocity')) traces.push(line('column twin', ...over(c.z, c.velocity), colour.column));
    if (m && m.kind === 'law') traces.push(line('measured (log law)', ...over(m.z, m.velocity), colour.measured, { line: { dash: 'dash' } }));
    if (m && m.kind === 'points') traces.push(points('measured', ...over(m.z, m.velocity), colour.measured, { marker: { symbol: 'diamond-open', size: 8 } }));
    if (has(law, 'z', 'velocity')) traces.push(line('fitted law', ...over(law.z, law.velocity), colour.reference, { line: { width: 1.6, dash: 'dot' } }));
    traces.push(points('simulated', ...over(p.z, p.velocity), colour.simulated));
    const edge = height => Math.log10((height - law.zero_plane) / law.equivalent_roughness);
    const shapes = law.from > law.zero_plane && law.to > law.from ? [{
      type: 'rect', yref: 'paper', y0: 0, y1: 1, x0: 10 ** edge(law.from), x1: 10 ** edge(law.to), layer: 'below',
      fillcolor: colour.window, line: { width: 0 } }] : [];
    const annotations = shapes.length ? [{ x: (edge(law.from) + edge(law.to)) / 2, yref: 'paper', y: 0.02, yanchor: 'bottom',
      text: 'fitted range', showarrow: false, font: { size: 11, color: '#56606b' } }] : [];
    return {
      traces, height: 460,
      layout: layout({
        xaxis: axis(`(${z} − <i>z</i><sub>0</sub>) / ${ks}  (–)`, { type: 'log', tickvals: [0.01, 0.02, 0.05, 0.1, 0.2, 0.5, 1, 2, 5, 10, 20, 50, 100] }),
        yaxis: axis(`${u} / ${ustar}  (–)`, { rangemode: 'tozero' }), shapes, annotations }),
      caption: `The same profile in semi-logarithmic form. Every curve is scaled with the simulated friction velocity ` +
        `${ustar} = ${significant(law.friction_velocity)} m/s, equivalent roughness ${ks} = ${significant(1000 * law.equivalent_roughness)} mm and ` +
        `zero plane <i>z</i><sub>0</sub> = ${significant(1000 * law.zero_plane)} mm of the fitted law ` +
        `${u}/${ustar} = ln((${z} − <i>z</i><sub>0</sub>)/${ks})/${law.kappa} + 8.5, so that differences stay visible.`,
    };
  }

  // (3) velocity gradient
  function gradient(data) {
    const p = data.profiles, c = data.column;
    if (!has(p, 'z', 'velocity_gradient')) return null;
    const traces = [];
    if (has(c, 'z', 'velocity_gradient')) traces.push(line('column twin', c.velocity_gradient, millimetres(c.z), colour.column));
    traces.push(points('simulated', p.velocity_gradient, millimetres(p.z), colour.simulated));
    return {
      traces, height: 420,
      layout: layout({ xaxis: axis(`velocity gradient d${u}/d${z} (1/s)`, { rangemode: 'tozero' }), yaxis: heightAxis(data), ...heights(data) }),
      caption: `Gradient of the mean velocity, as the closure sees it at the particles, against that of the column twin. ` +
        `Times the viscosity and eddy viscosity it gives the shear stress.`,
    };
  }

  // departure from the column
  function deviation(data) {
    const p = data.profiles;
    if (!has(p, 'z', 'velocity_deviation', 'velocity')) return null;
    const scale = data.column && data.column.depth_mean_velocity;
    if (!scale) return null;
    const percent = p.velocity_deviation.map(value => value === null ? null : 100 * value / scale);
    const bars = has(p, 'velocity_half_width')
      ? { error_x: { type: 'data', array: p.velocity_half_width.map(value => value === null ? 0 : 100 * value / scale), thickness: 1, width: 0, color: colour.simulated } } : {};
    // Room for the bars too, but not so much that one poorly known layer flattens the others.
    const size = Math.max(1, ...percent.filter(value => value !== null).map(Math.abs));
    const ends = percent.map((value, i) => value === null ? 0 : Math.abs(value) + (bars.error_x ? bars.error_x.array[i] : 0));
    const largest = 1.1 * Math.min(3 * size, Math.max(1.1 * size, ...ends));
    const base = heights(data);
    base.shapes.push({ type: 'line', yref: 'paper', y0: 0, y1: 1, x0: 0, x1: 0, line: { color: colour.column, width: 2 }, layer: 'between' });
    return {
      traces: [points('simulated − column twin', percent, millimetres(p.z), colour.simulated, bars)], height: 420,
      layout: layout({ showlegend: false, xaxis: axis(`(${u} − ${u}<sub>column</sub>) / <i>U</i><sub>column</sub> (%)`, { range: [-largest, largest] }),
        yaxis: heightAxis(data), ...base }),
      caption: `Departure of the simulated velocity from the column twin at the particles' own heights, in percent of the ` +
        `column's depth-mean velocity; bars are 95 % intervals. What remains is the error of the discretisation.`,
    };
  }

  // (4) shear stress
  function stress(data) {
    const p = data.profiles;
    const height = has(p, 'bin_upper') ? p.bin_upper : p && p.z;
    if (!has(p, 'total_stress') && !has(p, 'viscous_stress')) return null;
    const at = millimetres(height), traces = [];
    if (has(p, 'analytic_stress')) traces.push(line('analytic', p.analytic_stress, at, colour.reference, { line: { width: 2.5 } }));
    if (has(p, 'viscous_stress')) traces.push(line('viscous + closure', p.viscous_stress, at, colour.column, { line: { dash: 'dash' } }));
    if (has(p, 'reynolds_stress')) traces.push(line('resolved −<i>ρu′w′</i>', p.reynolds_stress, millimetres(p.z), colour.resolved, { line: { dash: 'dot' } }));
    if (has(p, 'pair_stress')) traces.push(line('spurious (pressure)', p.pair_stress, at, colour.pair, { line: { dash: 'dashdot' } }));
    if (has(p, 'total_stress')) traces.push(points('total', p.total_stress, at, colour.simulated));
    return {
      traces, height: 460,
      layout: layout({ xaxis: axis('shear stress <i>τ</i> (Pa)'), yaxis: heightAxis(data), ...heights(data, true, 0.2) }),
      caption: `Shear stress over the depth. Above the crests uniform flow must carry <i>τ</i> = <i>ρ g</i> sin<i>θ</i> (<i>H</i> − ${z}) ` +
        `(analytic line; below the crests less the drag on the bed elements). The total is the sum of the viscous and closure stress, the ` +
        `resolved Reynolds stress, and the shear that the pressure forces carry between unevenly placed particles, which should be nil. ` +
        `The top two or three rows of particles, whose neighbourhood the surface cuts, should not be read.`,
    };
  }

  // (5) pressure against hydrostatic
  function pressure(data) {
    const p = data.profiles;
    if (!has(p, 'z', 'pressure')) return null;
    const height = millimetres(p.z), traces = [];
    const reference = has(p, 'hydrostatic_pressure');
    if (reference) traces.push(line('hydrostatic', p.hydrostatic_pressure, height, colour.reference, { line: { width: 2.5 } }));
    traces.push(points('simulated', p.pressure, height, colour.simulated));
    const bottom = reference ? Math.max(...p.hydrostatic_pressure) : 0;
    const base = heights(data, !reference);
    const extra = { xaxis: axis('pressure <i>p</i> (Pa)', { rangemode: 'tozero', domain: reference ? [0, 0.58] : [0, 1], nticks: 5 }) };
    if (reference && bottom > 0) {
      const percent = p.pressure.map((value, i) => value === null ? null : 100 * (value - p.hydrostatic_pressure[i]) / bottom);
      const largest = 1.25 * Math.max(1, ...percent.filter(value => value !== null).map(Math.abs));
      traces.push(points('difference', percent, height, colour.simulated, { xaxis: 'x2', yaxis: 'y2', showlegend: false, marker: { symbol: 'circle-open' } }));
      extra.xaxis2 = axis('difference (%)', { domain: [0.66, 1], anchor: 'y2', range: [-largest, largest], nticks: 5 });
      extra.yaxis2 = axis('', { matches: 'y', anchor: 'x2', showticklabels: false });
      base.shapes.push({ type: 'line', xref: 'x2', yref: 'paper', y0: 0, y1: 1, x0: 0, x1: 0, line: { color: colour.reference, width: 2 }, layer: 'between' });
    }
    return {
      traces, height: 460, layout: layout({ ...extra, yaxis: heightAxis(data), ...base }),
      caption: `Mean pressure against the hydrostatic <i>p</i> = <i>ρ g</i> cos<i>θ</i> (<i>z</i><sub>s</sub> − ${z}) under the mean level ` +
        `<i>z</i><sub>s</sub>; right: their difference in percent of the hydrostatic pressure at the lowest layer.`,
    };
  }

  // Stacked panels over one time axis, each with its own legend: rows of { title, traces, shapes, range }.
  function panels(rows, height) {
    const gap = 0.11, share = (1 - gap * (rows.length - 1)) / rows.length;
    const traces = [], shapes = [], annotations = [], extra = {};
    rows.forEach((row, i) => {
      const suffix = i === 0 ? '' : String(i + 1), top = 1 - i * (share + gap), last = i === rows.length - 1;
      row.traces.forEach(trace => traces.push({ ...trace, xaxis: `x${suffix}`, yaxis: `y${suffix}`, legend: `legend${suffix}`, showlegend: true }));
      (row.shapes || []).forEach(({ whole, ...shape }) => shapes.push({ ...shape, xref: `x${suffix}`, yref: whole ? `y${suffix} domain` : `y${suffix}` }));
      extra[`xaxis${suffix}`] = axis(last ? 'time <i>t</i> (s)' : '', { anchor: `y${suffix}`, showticklabels: last, rangemode: 'tozero', ...(i ? { matches: 'x' } : {}) });
      extra[`yaxis${suffix}`] = axis(`<b>(${String.fromCharCode(97 + i)})</b> ${row.title}`, { anchor: `x${suffix}`, domain: [Math.max(0, top - share), top], nticks: 5, ...(row.range ? { range: row.range } : {}) });
      extra[`legend${suffix}`] = { orientation: 'h', x: 0, xanchor: 'left', y: top + 0.004, yanchor: 'bottom', font: { size: 12 }, bgcolor: 'rgba(255,255,255,0)' };
      (row.annotations || []).forEach(note => annotations.push({ ...note, xref: `x${suffix}`, yref: `y${suffix} domain` }));
    });
    return { traces, height, paper_share: 0.92, layout: layout({ ...extra, shapes, annotations, margin: { l: 70, r: 14, t: 30, b: 48 } }) };
  }

  // Range that holds all the values, with room at the top for a line of text.
  function roomy(values, headroom = 0.25) {
    const finite = values.filter(value => value !== null);
    const low = Math.min(...finite), high = Math.max(...finite), size = high - low || 0.01 * Math.abs(high) || 1;
    return [low - 0.08 * size, high + headroom * size];
  }

  const windowShape = data => data.window && data.window.end > data.window.start ? [{
    type: 'rect', whole: true, x0: data.window.start, x1: data.window.end, y0: 0, y1: 1, fillcolor: colour.window, line: { width: 0 }, layer: 'below' }] : [];
  const span = s => [s.time[0], s.time[s.time.length - 1]];

  // (6) histories; without the forces where the page shows them elsewhere
  function history(data, forces = true) {
    const s = data.series;
    if (!has(s, 'time', 'depth_mean_velocity') || s.time.length < 2) return null;
    const rows = [], words = [], thin = { line: { width: 1.4 } }, ends = span(s);
    const level = (name, value, color, dash) => line(name, ends, [value, value], color, { line: { dash, width: 1.8 } });
    const note = (text, x, xanchor) => ({ x, xanchor, xshift: xanchor === 'left' ? 5 : 0, y: 0.97, yanchor: 'top', text, showarrow: false, font: { size: 11, color: '#56606b' } });
    const twin = data.column && data.column.depth_mean_velocity;
    const first = { title: '<i>U</i> (m/s)', shapes: windowShape(data), annotations: [],
      range: roomy(twin ? [...s.depth_mean_velocity, twin] : s.depth_mean_velocity),
      traces: [line('simulated', s.time, s.depth_mean_velocity, colour.simulated, thin)] };
    if (twin) first.traces.push(level('column twin', twin, colour.column));
    // A measured value far from the simulated ones would flatten the curve: it is then only named.
    const measured = data.measured && data.measured.depth_mean_velocity;
    if (measured > first.range[0] && measured < first.range[1]) first.traces.push(level('measured', measured, colour.measured, 'dash'));
    else if (measured) first.annotations.push(note(`measured: ${significant(measured)} m/s ${measured > first.range[1] ? '↑' : '↓'}`, ends[0], 'left'));
    if (first.shapes.length) first.annotations.push(note('averaging window', (data.window.start + data.window.end) / 2, 'center'));
    rows.push(first);
    if (forces && has(s, 'drag_over_gravity')) {
      const wall = has(s, 'wall_over_gravity') ? s.wall_over_gravity : null;
      const side = has(s, 'side_wall_over_gravity') ? s.side_wall_over_gravity : null;
      const resisting = s.drag_over_gravity.map((value, i) => value + (wall ? wall[i] : 0) + (side ? side[i] : 0));
      const row = { title: 'force/weight (–)', shapes: windowShape(data), traces: [line('drag + wall', s.time, resisting, colour.simulated, thin)] };
      if (has(s, 'acceleration_over_gravity')) {
        row.traces.push(line('+ acceleration', s.time, resisting.map((value, i) => value + s.acceleration_over_gravity[i]), colour.pair, thin));
      }
      row.traces.push(level('balance', 1, colour.reference, 'dot'));
      rows.push(row);
      words.push('Streamwise forces over the weight component of the water: drag of the bed elements and wall friction must come to ' +
        'balance it; with the acceleration they must do so at every instant.');
    }
    if (has(s, 'mean_level')) {
      words.push('Mean water level above the bed level.');
      rows.push({ title: 'level (mm)', traces: [line('mean level', s.time, millimetres(s.mean_level), colour.measured, thin)], shapes: windowShape(data) });
    }
    const made = panels(rows, 120 + 175 * rows.length);
    const estimate = data.window.mean && data.window.half_width
      ? ` Over the window <i>U</i> = ${interval(data.window.mean, data.window.half_width).join(' ± ')} m/s (95 %, correlation in time taken into account).` : '';
    made.caption = `(a) Depth-mean velocity above the datum; shaded: the averaging window.${estimate} ` +
      words.map((text, i) => `(${'bc'[i]}) ${text}`).join(' ');
    return made;
  }

  // Health of the particles over time
  function health(data) {
    const s = data.series;
    if (!has(s, 'time') || s.time.length < 2) return null;
    const rows = [], thin = { line: { width: 1.4 } };
    if (has(s, 'velocity_fluctuation')) rows.push({ title: 'rms (mm/s)', shapes: windowShape(data),
      traces: [line('velocity fluctuation', s.time, millimetres(s.velocity_fluctuation), colour.simulated, thin)] });
    if (has(s, 'particle_order')) rows.push({ title: 'order (–)', range: [0, 1.05], shapes: windowShape(data),
      traces: [line('particle order', s.time, s.particle_order, colour.column, thin)] });
    if (has(s, 'density_deviation_minimum', 'density_deviation_maximum')) rows.push({ title: 'density (%)', shapes: windowShape(data),
      traces: [line('largest density', s.time, scaled(s.density_deviation_maximum, 100), colour.measured, thin),
        line('smallest density', s.time, scaled(s.density_deviation_minimum, 100), colour.resolved, { line: { width: 1.4, dash: 'dash' } })] });
    if (!rows.length) return null;
    const made = panels(rows, 110 + 140 * rows.length);
    made.caption = `Signs of health over time: rms departure of the particle velocities from the mean of their layer; order of the particles ` +
      `(1: perfect layers, 0: none); largest and smallest density of a particle, relative to that of water at rest under no load.`;
    return made;
  }

  // (7) surface elevation in space and time
  function surface(data) {
    const s = data.surface;
    if (!has(s, 'x', 'time', 'elevation')) return null;
    const fine = s.standard_deviation < 1e-4, factor = fine ? 1e6 : 1e3, unit = fine ? 'µm' : 'mm';
    const values = s.elevation.map(row => row.map(value => value === null ? null : factor * (value - s.mean_level)));
    const reach = 3 * factor * s.standard_deviation || 1;
    const x = millimetres(s.x), traces = [{
      type: 'heatmap', x, y: s.time, z: values, zmin: -reach, zmax: reach, zsmooth: false, name: 'elevation',
      colorscale: [[0, '#053061'], [0.2, '#2f79b5'], [0.4, '#a5cee3'], [0.5, '#f7f7f7'], [0.6, '#f7b799'], [0.8, '#ca4741'], [1, '#67001f']],
      colorbar: { title: { text: `<i>η</i> − mean (${unit})`, side: 'right' }, thickness: 14, outlinewidth: 0, len: 1 },
      hovertemplate: `x = %{x:.1f} mm<br>t = %{y:.3f} s<br>%{z:.2f} ${unit}<extra></extra>`,
    }];
    if (s.velocity > 0) {
      const length = data.geometry.length, from = s.time[0], to = s.time[s.time.length - 1], px = [], py = [];
      for (let start = from; start < to; start += length / s.velocity) {
        const end = Math.min(to, start + length / s.velocity);
        px.push(0, 1000 * s.velocity * (end - start), null);
        py.push(start, end, null);
      }
      traces.push(line(`<i>x</i> = <i>U t</i>`, px, py, ink, { line: { dash: 'dash', width: 1.6 }, hoverinfo: 'skip', showlegend: true }));
    }
    return {
      traces, height: 460,
      layout: layout({ xaxis: axis('<i>x</i> down the channel (mm)', { range: [0, 1000 * data.geometry.length], showgrid: false }),
        yaxis: axis('time <i>t</i> (s)', { showgrid: false, range: [s.time[0], s.time[s.time.length - 1]] }) }),
      caption: `Elevation of the free surface about its mean, in space and time (the last ${significant(s.time[s.time.length - 1] - s.time[0])} s of the record); standard deviation ` +
        `${significant(factor * s.standard_deviation)} ${unit}. A pattern carried with the depth-mean velocity would run along the dashed lines ` +
        `<i>x</i> = <i>U t</i>; waves cross them. A closure that averages the turbulence leaves no turbulent waves: expect far less than in the flume.`,
    };
  }

  return { velocity, logLaw, gradient, deviation, stress, pressure, history, health, surface, axis, layout, line, significant, interval, colour, has, some };
})();
