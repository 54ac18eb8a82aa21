// Figures of the analysis with several sets of axes: maps (one for each map), and the curves of several runs side by
// side.

const analysis_panels = (() => {
  'use strict';

  const { axis_of, axis_layout, traces_of, legend_height, legend_entry, kind_names, finite, largest } = analysis_figures;
  const style = analysis_style;

  // A grid of panels: places of the axes in paper coordinates, for pixels of width and height.
  function grid(count, width, height_of_panel, room, left, on_paper) {
    // On paper two figures share a page, so seven panels stand in two rows.
    const columns = width < 520 || room.stacked ? 1 : count <= 4 ? Math.min(on_paper ? 3 : 2, count) : on_paper && count > 6 ? 4 : 3;
    const rows = Math.ceil(count / columns), right = room.right, top = room.top, bottom = 52, gap_x = room.gap_x, gap_y = room.gap_y;
    const inner_width = Math.max(120, width - left - right), inner_height = rows * height_of_panel + (rows - 1) * gap_y;
    const share_x = (inner_width - (columns - 1) * gap_x) / columns / inner_width, share_y = height_of_panel / inner_height;
    const place = i => {
      const column = i % columns, row = Math.floor(i / columns), from = column * (share_x + gap_x / inner_width);
      const to_y = 1 - row * (share_y + gap_y / inner_height);
      return { x: [from, Math.min(1, from + share_x)], y: [Math.max(0, to_y - share_y), to_y], first: column === 0, last: i + columns >= count };
    };
    return { place, panel_height: height_of_panel, panel: share_x * inner_width, height: inner_height + top + bottom, margin: { l: left, r: right, t: top, b: bottom } };
  }

  const suffix = i => (i ? String(i + 1) : '');
  // Names of the axes, once for all panels: each axis would repeat them, and they are longer than a panel is high.
  const axis_names = (x, y, height) => [
    { text: units.title(x.label, x.unit), xref: 'paper', yref: 'paper', x: 0.5, y: 0, yshift: -26, xanchor: 'center', yanchor: 'top', showarrow: false },
    { text: units.wrapped(units.title(y.label, y.unit), height), xref: 'paper', yref: 'paper', x: 0, y: 0.5, xshift: y.logarithmic ? -58 : -46, xanchor: 'right', yanchor: 'middle', textangle: -90, showarrow: false }];

  // The name of a panel, cut to its width.
  const cut = (text, pixels) => (text.length * 7.2 > pixels ? `${text.slice(0, Math.max(8, Math.floor(pixels / 7.2) - 1))}…` : text);
  const heading = (text, place) => ({ text: `<b>${units.symbols(text)}</b>`, xref: 'paper', yref: 'paper', x: place.x[0], y: place.y[1], xanchor: 'left', yanchor: 'bottom',
    showarrow: false, font: { size: 12.5 } });

  // The curves of each run in a panel of its own, with common ranges.
  function curves(entries, width, on_paper) {
    const x = axis_of(entries, 'x'), y = axis_of(entries, 'y'), traces = [], annotations = [], extra = {}, shown = new Map(), kind = kind_names(entries);
    for (const { figure } of entries) for (const curve of figure.curves) shown.set(kind(curve), curve);
    const legend = legend_height([...shown.keys()], width);
    const made = grid(entries.length, width, on_paper ? 132 : 235, { top: legend + 26, right: 14, gap_x: 26, gap_y: 50 }, y.logarithmic ? 86 : 72, on_paper);
    const seen = new Set();
    entries.forEach(({ figure, run }, i) => {
      const place = made.place(i), name = suffix(i);
      for (const curve of figure.curves) {
        const first = !seen.has(kind(curve));
        seen.add(kind(curve));
        const parts = traces_of(curve, x, y, style.of(curve, null), kind(curve), { xaxis: `x${name}`, yaxis: `y${name}`, legendgroup: kind(curve) });
        parts.forEach((trace, part) => traces.push({ ...trace, showlegend: first && part === parts.length - 1 }));
      }
      if (!figure.curves.length) traces.push(legend_entry('', { mode: 'markers' }, { xaxis: `x${name}`, yaxis: `y${name}`, showlegend: false }));
      extra[`xaxis${name}`] = axis_layout(x, { domain: place.x, anchor: `y${name}`, ...(i ? { matches: 'x' } : {}), title: undefined, nticks: on_paper ? 4 : 5, tickangle: 0 });
      extra[`yaxis${name}`] = axis_layout(y, { domain: place.y, anchor: `x${name}`, ...(i ? { matches: 'y' } : {}), title: undefined, ...(place.first ? {} : { showticklabels: false }), nticks: 6 });
      annotations.push(heading(cut(run, made.panel), place));
    });
    annotations.push(...axis_names(x, y, made.height - made.margin.t - made.margin.b));
    const legend_place = { orientation: 'h', x: 0, xanchor: 'left', y: 1 + 22 / (made.height - made.margin.t - made.margin.b), yanchor: 'bottom' };
    return { traces, height: made.height, paper_share: 1, layout: figures.layout({ ...extra, annotations, margin: made.margin, barmode: 'overlay', bargap: 0,
      showlegend: shown.size > 1, legend: { ...legend_place, font: { size: 12 }, bgcolor: 'rgba(255,255,255,0)' } }) };
  }

  // Range of colours that holds all but the extreme half percent of the values at each end.
  function colours(maps) {
    const all = [];
    for (const map of maps) {
      const stride = Math.max(1, Math.floor(map.values.length / 20000));
      for (let i = 0; i < map.values.length; i += stride) { const value = map.values[i]; if (finite(value) && (!map.logarithmic || value > 0)) all.push(value); }
    }
    all.sort((a, b) => a - b);
    if (!all.length) return { low: 0, high: 1, cut: false };
    const at = share => all[Math.round(share * (all.length - 1))];
    if (maps[0].diverging) { const reach = Math.max(Math.abs(at(0.005)), Math.abs(at(0.995))) || 1; return { low: -reach, high: reach }; }
    if (maps[0].logarithmic) return { low: Math.max(all[0], all[all.length - 1] * 1e-6), high: all[all.length - 1] };
    const low = at(0.005), high = at(0.995);
    return low < high ? { low, high } : { low: low - 0.5 * (Math.abs(low) || 1), high: low + 0.5 * (Math.abs(low) || 1) };
  }

  const ends_of = values => {
    const step = values.length > 1 ? 0.5 * Math.abs(values[values.length - 1] - values[0]) / (values.length - 1) : 0.5;
    return [Math.min(values[0], values[values.length - 1]) - step, Math.max(values[0], values[values.length - 1]) + step];
  };

  function heatmap(map, x, y, limits, scale, name, coloraxis) {
    const rows = map.y.map((_, j) => map.values.slice(j * map.x.length, (j + 1) * map.x.length).map(value =>
      !finite(value) ? null : map.logarithmic ? (value > 0 ? Math.log10(value) : null) : scale.factor * value));
    return { type: 'heatmap', x: map.x.map(value => x.factor * value), y: map.y.map(value => y.factor * value), z: rows, zsmooth: false, name: map.label,
      xaxis: `x${name}`, yaxis: `y${name}`, coloraxis, hovertemplate: `%{x:.4~g} ${x.unit}, %{y:.4~g} ${y.unit}<br>` +
        `${map.logarithmic ? '10^%{z:.2f}' : '%{z:.3~g}'} ${scale.unit}<extra></extra>` };
  }

  // Lines of equal value over a map, thin and grey, so that arrows and curves stand out.
  function contour_lines(map, x, y, limits, scale, name) {
    const plain = heatmap(map, x, y, limits, scale, name), steps = 8, [low, high] = [limits.low, limits.high].map(value => scale.factor * value);
    return { type: 'contour', x: plain.x, y: plain.y, z: plain.z, xaxis: plain.xaxis, yaxis: plain.yaxis, name: map.label, showscale: false, showlegend: false, hoverinfo: 'skip', connectgaps: false,
      autocontour: false, line: { color: 'rgba(60,68,76,0.55)', width: 0.8, smoothing: 0.6 }, contours: { coloring: 'none', start: low, end: high, size: (high - low) / steps || 1 } };
  }

  // All maps of all runs, each with the curves that lie over it. Maps of the same quantity share their colours.
  function maps(entries, width, on_paper) {
    const x = axis_of(entries, 'x'), y = axis_of(entries, 'y'), panels = [], traces = [], annotations = [], extra = {};
    for (const { figure, run } of entries) {
      figure.maps.forEach(map => panels.push({ map, figure, title: [entries.length > 1 ? run : '', figure.maps.length > 1 ? map.label : '', map.run && map.run !== run ? map.run : '']
        .filter(Boolean).join(': ') }));
    }
    const quantities = [...new Set(panels.map(({ map }) => `${map.label}|${map.unit}|${map.diverging}|${map.logarithmic}`))];
    const key = map => quantities.indexOf(`${map.label}|${map.unit}|${map.diverging}|${map.logarithmic}`);
    const kind = kind_names(entries), names = [...new Set(entries.flatMap(({ figure }) => figure.curves.map(kind)))];
    const legend = names.length ? legend_height(names, width) : 0, titled = panels.some(({ title }) => title);
    const narrow = width < 520, flat = entries[0].figure.y.equal_scale;
    const alone = panels.length === 1;
    // Equal scales along both axes make flat panels, unless they would be too flat to read.
    const spans = panels.map(({ map }) => (y.factor * (map.y[map.y.length - 1] - map.y[0])) / (x.factor * (map.x[map.x.length - 1] - map.x[0]) || 1));
    // Panels much wider than high stand one above the other, each with its scale of colours beside it.
    const stacked = flat && !alone && !narrow && Math.max(...spans.map(Math.abs)) < 0.45;
    const flat_height = share => Math.max(70, Math.min(400, share * (width - 180) * Math.max(...spans.map(Math.abs))));
    const made = grid(panels.length, width, flat ? flat_height(alone || narrow || stacked ? 1 : 0.4) : alone ? (narrow ? 300 : on_paper ? 230 : 400) : on_paper ? 132 : 240,
      { top: legend + (titled ? 26 : 12), right: narrow ? 14 : 14 + 92 * (stacked ? 1 : quantities.length), stacked, gap_x: 50, gap_y: titled ? 50 : 36 }, y.logarithmic ? 86 : 72, on_paper);
    const seen = new Set();
    // Ticks that the axes have room for: equal scales may leave one of them a fraction of the panel.
    const ticks_of = map => {
      const span = values => { const [low, high] = ends_of(values); return high - low; };
      const across = x.factor * span(map.x), up = y.factor * span(map.y), equal = y.equal_scale && x.factor === y.factor;
      const pixels = equal ? Math.min(made.panel / across, made.panel_height / up) : 0;
      const count = (length, each) => Math.max(2, Math.min(8, Math.floor(length / each)));
      return { x: count(equal ? pixels * across : made.panel, 58), y: count(equal ? pixels * up : made.panel_height, 34) };
    };
    panels.forEach(({ map, figure, title }, i) => {
      const ticks = ticks_of(map);
      const place = made.place(i), name = suffix(i), number = key(map);
      const scale = units.scale(map.unit, largest([map.values]), map.logarithmic);
      traces.push(heatmap(map, x, y, null, scale, name, `coloraxis${suffix(number)}`));
      if (map.contours) traces.push(contour_lines(map, x, y, colours(panels.filter(panel => key(panel.map) === number).map(panel => panel.map)), scale, name));
      for (const curve of figure.curves) {
        const first = !seen.has(kind(curve));
        seen.add(kind(curve));
        const parts = traces_of(curve, x, y, style.of(curve, null, map), kind(curve), { xaxis: `x${name}`, yaxis: `y${name}`, legendgroup: kind(curve) });
        // A light rim keeps a line visible on light and dark colours alike.
        const rim = parts.filter(trace => trace.line && trace.line.width).map(trace => ({ ...trace, mode: 'lines', hoverinfo: 'skip', hovertemplate: null, showlegend: false,
          line: { ...trace.line, color: 'rgba(255,255,255,0.85)', width: trace.line.width + 2.4, dash: 'solid' } }));
        traces.push(...rim);
        parts.forEach((trace, part) => traces.push({ ...trace, showlegend: first && part === parts.length - 1 }));
      }
      const range = (axis, values) => { const given = analysis_figures.range_of(axis).range, ends = ends_of(values).map(value => axis.factor * value);
        return given && given.every(finite) ? given : axis.logarithmic ? undefined : ends; };
      extra[`xaxis${name}`] = { ...axis_layout(x, { domain: place.x, anchor: `y${name}`, showgrid: false, ...(flat ? { constrain: 'domain' } : {}), nticks: Math.min(ticks.x, alone ? 8 : on_paper ? 4 : 5), tickangle: 0, ...(alone ? {} : { title: undefined }) }, alone ? made.panel : Infinity),
        range: range(x, map.x), autorange: false };
      extra[`yaxis${name}`] = { ...axis_layout(y, { domain: place.y, anchor: `x${name}`, showgrid: false, nticks: Math.min(ticks.y, 6), ...(alone ? {} : { title: undefined }),
        ...(y.equal_scale && x.factor === y.factor ? { scaleanchor: `x${name}`, constrain: 'domain' } : {}) }, made.panel_height), range: range(y, map.y), autorange: false };
      if (x.logarithmic) Object.assign(extra[`xaxis${name}`], { autorange: true });
      if (y.logarithmic) Object.assign(extra[`yaxis${name}`], { autorange: true });
      if (title) annotations.push(heading(cut(title, made.panel), place));
    });
    if (!alone) annotations.push(...axis_names(x, y, made.height - made.margin.t - made.margin.b));
    const all_height = Math.min(420, made.height - made.margin.t - made.margin.b);
    quantities.forEach((_, number) => {
      const members = panels.filter(({ map }) => key(map) === number).map(({ map }) => map), limits = colours(members), { logarithmic, diverging, label, unit } = members[0];
      const scale = units.scale(unit, largest(members.map(map => map.values)), logarithmic);
      const [cmin, cmax] = logarithmic ? [Math.log10(limits.low), Math.log10(limits.high)] : [scale.factor * limits.low, scale.factor * limits.high];
      // Stacked, the heading of the panel names the quantity; the scale stands beside the first panel that has it.
      const beside = stacked ? made.place(panels.findIndex(({ map }) => key(map) === number)) : null;
      const inner_height = stacked ? Math.max(80, made.panel_height) : all_height;
      const name_of_scale = stacked ? units.title('', scale.unit).trim() : units.title(label, scale.unit);
      const decades = []; for (let power = Math.ceil(cmin); power <= cmax; ++power) decades.push(power);
      extra[`coloraxis${suffix(number)}`] = { cmin, cmax, colorscale: diverging ? style.diverging : style.sequential,
        colorbar: { title: { text: narrow ? name_of_scale : units.wrapped(name_of_scale, inner_height), side: narrow ? 'top' : 'right' }, thickness: 13, outlinewidth: 0.5, outlinecolor: '#7a848e',
          ...(logarithmic && decades.length > 1 ? { tickvals: decades, ticktext: decades.map(power => `10<sup>${String(power).replace('-', '−')}</sup>`) } : { nticks: 6 }),
          ...(narrow ? { orientation: 'h', y: -0.22, yanchor: 'top' } : { lenmode: 'pixels', len: inner_height, y: beside ? beside.y[1] : 1, yanchor: 'top',
            x: 1 + (12 + (stacked ? 0 : 92 * number)) / Math.max(120, width - made.margin.l - made.margin.r), xanchor: 'left' }) } };
    });
    const inner = made.height - made.margin.t - made.margin.b;
    return { traces, height: made.height + (narrow ? 90 : 0), paper_share: 1,
      layout: figures.layout({ ...extra, annotations, margin: { ...made.margin, b: made.margin.b + (narrow ? 90 : 0) }, plot_bgcolor: '#ffffff', showlegend: names.length > 0,
        legend: { orientation: 'h', x: 0, xanchor: 'left', y: 1 + (titled ? 22 : 6) / inner, yanchor: 'bottom', font: { size: 12 }, bgcolor: 'rgba(255,255,255,0)' } }) };
  }

  return { curves, maps };
})();
