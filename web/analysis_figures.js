// Draws the figures of the analysis (src/analysis/figure.hpp): curves by origin with their intervals, maps with curves
// over them, for one run, for several overlaid, or side by side.
//   entries: [{ figure, run, index }], the same figure of each run that has it.

const analysis_figures = (() => {
  'use strict';

  const style = analysis_style;
  const finite = value => value !== null && Number.isFinite(value);
  const filled = list => Array.isArray(list) && list.length > 0;

  // Ends of the 95 % intervals of a curve, or null: those given, else the value plus and minus its half-width. On a
  // logarithmic axis a half-width h about a value m becomes a factor f = s + sqrt(1 + s^2), s = h / m, each way: nearly
  // m - h and m + h where h is small, and never below zero.
  function bounds_of(curve, side, logarithmic) {
    const lower = curve[`${side}_lower`], upper = curve[`${side}_upper`], half = curve[`${side}_half_width`], middle = curve[side];
    if (filled(lower) && filled(upper)) return { lower, upper };
    if (!filled(half)) return null;
    const ends = middle.map((value, i) => {
      if (!finite(value) || !finite(half[i])) return [null, null];
      if (!logarithmic) return [value - half[i], value + half[i]];
      if (!(value > 0)) return [null, null];
      const share = half[i] / value, factor = share + Math.hypot(1, share);
      return [value / factor, value * factor];
    });
    return { lower: ends.map(([low]) => low), upper: ends.map(([, high]) => high) };
  }

  function largest(lists) {
    let most = 0;
    for (const list of lists) for (const value of list) if (finite(value) && Math.abs(value) > most) most = Math.abs(value);
    return most;
  }

  // An axis over all runs: its unit, the factor from SI, its range.
  function axis_of(entries, side) {
    const first = entries[0].figure[side];
    const lists = entries.flatMap(({ figure }) => [...figure.curves.map(curve => curve[side]), ...figure.maps.map(map => map[side])]);
    const ends = entries.flatMap(({ figure }) => [figure[side].from, figure[side].to]).filter(finite);
    const bounded = finite(first.from) && finite(first.to);
    return { ...first, ...units.scale(first.unit, bounded ? largest([ends]) : largest(lists), first.logarithmic), entries, side };
  }

  function range_of(axis) {
    const bounds = which => axis.entries.map(({ figure }) => figure[axis.side][which]);
    const from = bounds('from'), to = bounds('to');
    const low = from.every(finite) ? Math.min(...from) * axis.factor : null, high = to.every(finite) ? Math.max(...to) * axis.factor : null;
    if (low === null && high === null) return {};
    // The end that is not given follows from the data (Plotly forgets a range that is open on one side when it fits its
    // margins).
    const values = axis.entries.flatMap(({ figure }) => [...figure.curves.flatMap(curve => [curve[axis.side], ...Object.values(bounds_of(curve, axis.side, axis.logarithmic) || {})]),
      ...figure.maps.map(map => map[axis.side]), (figure.guides || []).filter(guide => guide.axis === axis.side).flatMap(({ from: a, to: b }) => [a, b])]).flat().filter(finite);
    const least = axis.factor * values.reduce((a, b) => Math.min(a, b), Infinity), most = axis.factor * values.reduce((a, b) => Math.max(a, b), -Infinity);
    const room = 0.05 * ((high === null ? most : high) - (low === null ? least : low)) || 1;
    const ends = [low === null ? least - (axis.logarithmic ? 0 : room) : low, high === null ? most + (axis.logarithmic ? 0 : room) : high];
    return ends[1] > ends[0] ? { range: axis.logarithmic ? ends.map(value => Math.log10(value)) : ends } : {};
  }

  // An axis of names: 0, 1, 2 ... stand for them.
  const names_layout = names => ({ tickvals: names.map((_, i) => i), ticktext: names.map(units.symbols), range: [-0.5, names.length - 0.5], showgrid: false });

  function axis_layout(axis, extra = {}, pixels = Infinity) {
    if (filled(axis.categories)) return figures.axis(units.wrapped(units.symbols(axis.label), pixels), { ...names_layout(axis.categories), ...extra });
    const spread = axis.logarithmic ? decades_of(axis) : 0, steps = spread > 0.8 ? [1, 2, 5] : [1, 1.5, 2, 3, 4, 5, 6, 8];
    const decades = axis.logarithmic ? { type: 'log', exponentformat: 'power', ...(spread > 2.3 ? { dtick: 1 } : { tickvals: steps_of_decades(steps) }) } : {};
    return figures.axis(units.wrapped(units.title(axis.label, axis.unit), pixels), { ...decades, ...range_of(axis), ...extra });
  }

  // 1, 2, 5 in each decade, where few of them are shown; more of each where not even one is.
  const steps_of_decades = steps => Array.from({ length: 24 }, (_, i) => 10 ** (i - 12)).flatMap(power => steps.map(step => step * power));

  function decades_of(axis) {
    let low = Infinity, high = 0;
    for (const { figure } of axis.entries) {
      for (const part of [...figure.curves, ...figure.maps]) for (const value of part[axis.side]) if (value > 0) { low = Math.min(low, value); high = Math.max(high, value); }
    }
    return high > low ? Math.log10(high / low) : 1;
  }

  const scaled = (values, factor) => values.map(value => (finite(value) ? factor * value : null));

  // The band of an interval as closed outlines, one for each unbroken stretch.
  function band(curve, side, x, y, bounds) {
    const outline = { x: [], y: [] };
    let stretch = [];
    const flush = () => {
      if (stretch.length > 1) {
        const back = stretch.slice().reverse();
        const along = side === 'y' ? i => x.factor * curve.x[i] : i => y.factor * curve.y[i];
        const across = (i, end) => (side === 'y' ? y : x).factor * (end ? bounds.upper : bounds.lower)[i];
        const path = [...stretch.map(i => [along(i), across(i, 0)]), ...back.map(i => [along(i), across(i, 1)])];
        outline.x.push(...path.map(point => point[side === 'y' ? 0 : 1]), null);
        outline.y.push(...path.map(point => point[side === 'y' ? 1 : 0]), null);
      }
      stretch = [];
    };
    curve.x.forEach((_, i) => { if (finite(curve.x[i]) && finite(curve.y[i]) && finite(bounds.lower[i]) && finite(bounds.upper[i])) stretch.push(i); else flush(); });
    flush();
    return outline;
  }

  // Traces of one curve.
  function traces_of(curve, x, y, look, name, extra) {
    const made = [], xs = scaled(curve.x, x.factor), ys = scaled(curve.y, y.factor);
    const line = curve.mark === 'line' || curve.mark === 'line_and_points', marks = curve.mark === 'points' || curve.mark === 'line_and_points';
    const errors = {};
    for (const side of ['x', 'y']) {
      const axis = side === 'x' ? x : y, bounds = bounds_of(curve, side, axis.logarithmic);
      if (!bounds) continue;
      if (line && !marks) {
        const outline = band(curve, side, x, y, bounds);
        made.push({ type: 'scatter', mode: 'lines', ...outline, name: `${name}: 95 % interval`, line: { width: 0, color: look.color }, fill: 'toself',
          fillcolor: style.transparent(look.color, 0.2), hoverinfo: 'skip', ...extra, showlegend: false });
      } else {
        const reach = (ends, sign) => ends.map((end, i) => (finite(end) && finite(curve[side][i]) ? Math.max(0, axis.factor * sign * (end - curve[side][i])) : 0));
        errors[`error_${side}`] = { type: 'data', symmetric: false, array: reach(bounds.upper, 1), arrayminus: reach(bounds.lower, -1), thickness: 1,
          width: curve.x.length > 60 ? 0 : 3, color: look.color };
      }
    }
    const hover = { hovertemplate: `%{x:.4~g} ${x.unit}, %{y:.4~g} ${y.unit}<extra>${units.symbols(name)}</extra>` };
    if (curve.mark === 'area') {
      made.push({ type: 'scatter', mode: 'lines', x: xs, y: ys, name: units.symbols(name), fill: 'toself', fillcolor: figures.colour.body, line: { color: figures.colour.edge, width: 1.2 },
        hoverinfo: 'skip', ...extra });
      return made;
    }
    if (curve.mark === 'bars') {
      made.push({ type: 'bar', x: xs, y: ys, name: units.symbols(name), marker: { color: style.transparent(look.color, 0.45), line: { color: look.color, width: 1 } },
        ...errors, ...hover, ...extra });
      return made;
    }
    const size = curve.x.length > 400 ? 3 : curve.x.length > 120 ? 4.5 : 6;
    made.push({ type: 'scatter', mode: [line && 'lines', (marks || look.sparse_symbols) && 'markers'].filter(Boolean).join('+'), x: xs, y: ys, name: units.symbols(name),
      ...(line ? { line: { color: look.color, width: look.width, dash: look.dash, simplify: false }, connectgaps: false } : {}),
      ...(marks || look.sparse_symbols ? { marker: { color: look.color, size: marks ? size : 6, ...(marks ? {} : { maxdisplayed: 9 }), symbol: look.symbol, line: { width: /open/.test(look.symbol) ? 1.5 : 0, color: look.color } } } : {}),
      ...errors, ...hover, ...extra });
    return made;
  }

  const same_numbers = (a, b) => a.length === b.length && a.every((value, i) => value === b[i]);
  const same_curve = (a, b) => a.name === b.name && a.origin === b.origin && same_numbers(a.x, b.x) && same_numbers(a.y, b.y);

  // Height that a legend of these names takes above the plot: one row, or columns as wide as its longest name; a legend
  // with groups (of several runs) fills one row after the other instead.
  function legend_height(names, width, flows = false) {
    const lengths = names.map(name => 48 + 6.6 * units.symbols(name).replace(/<[^>]*>|&\w+;/g, '').length), room = width - 75;
    if (!names.length || lengths.reduce((sum, length) => sum + length, 0) <= room) return 20;
    if (flows) {
      let rows = 1, used = 0;
      for (const length of lengths) {
        if (used > 0 && used + length > room) { rows += 1; used = 0; }
        used += length;
      }
      return 20 * rows;
    }
    return 20 * Math.ceil(names.length / Math.max(1, Math.floor(room / Math.max(...lengths))));
  }

  // Names of curves for a common legend: what stands before a comma ("x = U t, U = 0.33 m/s") where no two curves of a
  // figure share that, else the whole name.
  function kind_names(entries) {
    const before = name => name.split(', ')[0];
    const clash = entries.length < 2 || entries.some(({ figure }) => new Set(figure.curves.map(curve => before(curve.name))).size < figure.curves.length);
    return curve => (clash ? curve.name : before(curve.name));
  }

  const legend_entry = (name, trace, extra) => ({ type: 'scatter', x: [null], y: [null], hoverinfo: 'skip', showlegend: true, name: units.symbols(name), ...trace, ...extra });

  // One set of axes: a run's own figure, or the curves of all runs over each other.
  // Theory and column twin lie below what is compared with them; the legend keeps the order of the figure.
  const depth = { theory: 0, column: 1 };
  const drawing_order = curves => curves.map((curve, rank) => ({ curve, rank, place: depth[curve.origin] ?? 2 }))
    .sort((a, b) => a.place - b.place || a.rank - b.rank);

  // What the figure marks across its extent, where all runs mark the same: lines and bands, with their names.
  function guides_of(entries, x, y) {
    const text = ({ figure }) => JSON.stringify(figure.guides || []), shapes = [], annotations = [];
    if (entries.some(entry => text(entry) !== text(entries[0]))) return { shapes, annotations };
    const list = entries[0].figure.guides || [];
    list.forEach(guide => {
      const upright = guide.axis === 'x', axis = upright ? x : y, from = axis.factor * guide.from, to = axis.factor * guide.to, band = guide.from !== guide.to;
      const along = upright ? { xref: 'x', x0: from, x1: to, yref: 'paper', y0: 0, y1: 1 } : { yref: 'y', y0: from, y1: to, xref: 'paper', x0: 0, x1: 1 };
      shapes.push(band ? { type: 'rect', ...along, layer: 'below', fillcolor: figures.colour.window, line: { width: 0 } }
        : { type: 'line', ...along, layer: 'between', line: { color: figures.colour.guide, width: 1, dash: 'dot' } });
      const at = axis.logarithmic ? Math.log10(Math.sqrt(from * to)) : (from + to) / 2;
      // Two lines close to each other have their names on either side of them.
      const above = list.filter(other => !upright && other.axis === 'y' && other.from > guide.from).map(other => other.from - guide.from);
      const crowded = above.length && Math.min(...above) < 0.12 * Math.max(...list.map(other => other.to));
      annotations.push({ text: guide.name, showarrow: false, font: { size: 11, color: '#56606b' }, borderpad: 1,
        ...(upright ? { x: at, xref: 'x', yref: 'paper', y: 0.985, yanchor: 'top', xanchor: band ? 'center' : 'left' }
          : { y: axis.logarithmic ? Math.log10(from) : from, yref: 'y', xref: 'paper', x: 0.995, xanchor: 'right', yanchor: crowded ? 'top' : 'bottom' }) });
    });
    return { shapes, annotations };
  }

  function single(entries, width, on_paper = false) {
    const x = axis_of(entries, 'x'), y = axis_of(entries, 'y'), traces = [], names = [];
    const several = entries.length > 1;
    // Where lines may coincide, the upper ones are thinner, with symbols.
    const compared = entries.some(({ figure }) => figure.curves.some(curve => curve.origin in depth) && figure.curves.some(curve => curve.origin === 'simulated'));
    const above_theory = (look, curve) => (!compared || curve.mark !== 'line' ? look : curve.origin in depth ? { ...look, width: 3.2 }
      : curve.origin === 'simulated' && curve.x.length < 400 ? { ...look, width: 1.5, sparse_symbols: true } : look);
    if (!several) {
      for (const { curve, rank } of drawing_order(entries[0].figure.curves)) {
        traces.push(...traces_of(curve, x, y, above_theory(style.of(curve, null), curve), curve.name, { legendrank: 1000 + rank }));
        names.push(curve.name);
      }
    } else {
      const kinds = new Map(), shared = [], kind = kind_names(entries);
      const common = curve => curve.origin !== 'simulated' && entries.every(({ figure }) => figure.curves.some(other => same_curve(curve, other)));
      entries.forEach(({ figure, run, index }, place) => {
        traces.push(legend_entry(run, { mode: 'lines', line: { color: style.colour_of_run(index), width: 5 } }, { legendgroup: `run ${index}` }));
        names.push(run);
        for (const { curve } of drawing_order(figure.curves)) {
          if (common(curve)) {
            if (place === 0) shared.push(curve);
            continue;
          }
          const look = style.of(curve, index);
          // Bars of several runs would hide each other: their outlines do not.
          const drawn = curve.mark === 'bars' ? { ...curve, mark: 'line', y_half_width: [], y_lower: [], y_upper: [] } : curve;
          const steps = curve.mark === 'bars' ? { line: { color: look.color, width: 1.6, shape: 'hvh' } } : {};
          traces.push(...traces_of(drawn, x, y, look, `${curve.name}, ${run}`, { showlegend: false, legendgroup: `run ${index}`, ...steps }));
          const key = `${curve.origin}|${kind(curve)}`;
          if (!kinds.has(key)) kinds.set(key, { name: kind(curve), curve, look });
        }
      });
      // Shared curves lie below those of the runs; the legend names them after the runs.
      traces.unshift(...drawing_order(shared).flatMap(({ curve, rank }) => traces_of(curve, x, y, above_theory(style.of(curve, null), curve), curve.name, { legendrank: 2000 + rank })));
      names.push(...shared.map(({ name }) => name));
      const named = [...kinds.values()];
      for (const { name: own, curve, look } of named) {
        const name = named.filter(other => other.name === own).length > 1 ? `${own} (${style.origin_name(curve.origin)})` : own;
        const grey = '#6b7580', bars = curve.mark === 'bars';
        const marks = curve.mark === 'points' || curve.mark === 'line_and_points', line = curve.mark === 'line' || curve.mark === 'line_and_points';
        traces.push(legend_entry(name, bars ? { mode: 'lines', line: { color: grey, width: 1.6, shape: 'hvh' } }
          : { mode: [line && 'lines', (marks || look.sparse_symbols) && 'markers'].filter(Boolean).join('+'), line: { color: grey, dash: look.dash, width: look.width }, marker: { color: grey, symbol: look.symbol, size: 7 } }, { legendrank: 3000 }));
        names.push(name);
      }
    }
    const flat = traces.some(trace => trace.type === 'bar');
    const legend = legend_height(names, width, several);
    return { traces, height: (width < 400 ? 340 : 400) + legend, legend_height: legend,
      layout: figures.layout({ ...guides_of(entries, x, y), barmode: 'overlay', bargap: 0, showlegend: names.length > 1 || several || entries[0].figure.curves.some(({ origin }) => origin in depth), xaxis: axis_layout(x, {}, width - 80),
        yaxis: axis_layout(y, { ...(flat && !y.logarithmic && !range_of(y).range ? { rangemode: 'tozero' } : {}), ...(y.equal_scale && x.factor === y.factor ? { scaleanchor: 'x' } : {}) }, on_paper ? 165 : 300) }) };
  }

  return { single, axis_of, axis_layout, range_of, traces_of, legend_height, legend_entry, kind_names, finite, largest, scaled };
})();
