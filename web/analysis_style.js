// The look of the analysis' curves: one colour and mark for each origin in a single run, one colour for each run in a
// comparison, where origins differ by symbol and the quantities of one origin by dash.

const analysis_style = (() => {
  'use strict';

  // Okabe and Ito's palette, as in the other figures; further curves of one origin take further colours.
  const simulated = ['#0072B2', '#CC79A7', '#E69F00', '#6A4FB3', '#2FB5C7', '#8A5A2B'];
  const by_origin = {
    simulated, measured: ['#009E73', '#5F8A1E', '#4C6A92'], column: ['#D55E00', '#A63D2F', '#E69F00'],
    theory: ['#22282f', '#8A5A2B', '#6A4FB3', '#2FB5C7'], fit: ['#A63D2F', '#6A4FB3', '#8A5A2B', '#CC79A7', '#2FB5C7', '#5F8A1E'], reference: ['#7a848e', '#9aa3ab', '#5b656e'],
  };
  // Without the colours of the column twin and of measurements, which all runs may share.
  const runs = ['#0072B2', '#CC79A7', '#8A5A2B', '#6A4FB3', '#2FB5C7', '#E69F00', '#5F8A1E', '#A63D2F'];
  const dashes = ['solid', 'dash', 'dot', 'dashdot', 'longdash'];
  const symbols = { simulated: 'circle', measured: 'diamond-open', column: 'square-open', theory: 'x', fit: 'triangle-up-open', reference: 'cross' };
  // Lines over a map lie on the map's own light and dark colours, whatever those of the page.
  const over_light = ['#1b2026', '#009E73', '#6A4FB3', '#A63D2F'], over_dark = ['#D55E00', '#009E73', '#CC79A7', '#E69F00'];

  const origin_names = { simulated: 'simulated', column: 'column twin', measured: 'measured', theory: 'theory', fit: 'fit', reference: 'reference' };
  const origin_name = origin => origin_names[origin] || origin;

  const pick = (list, i) => list[i % list.length];
  const colour_of_run = index => pick(runs, index);

  // Style of a curve: `run` is the index of its run in an overlay, or null where a figure shows one run.
  function of(curve, run, map) {
    const variant = curve.variant || 0, origin = by_origin[curve.origin] ? curve.origin : 'reference';
    const drawn_once = run === null;
    const color = map ? pick(map.diverging ? over_light : over_dark, variant) : drawn_once ? pick(by_origin[origin], variant) : colour_of_run(run);
    const first = drawn_once ? { simulated: 0, column: 0, measured: 1, theory: 0, fit: 2, reference: 2 }[origin] : 0;
    return {
      color, width: origin === 'reference' ? 1.6 : origin === 'simulated' || origin === 'column' ? 2 : 1.8,
      dash: map && origin === 'theory' ? 'dash' : pick(dashes, first + variant),
      // In a comparison the lines of other origins carry a few of their symbols.
      sparse_symbols: !drawn_once && origin !== 'simulated', symbol: symbols[origin], variant,
    };
  }

  const transparent = (hex, share) => `rgba(${[1, 3, 5].map(i => parseInt(hex.slice(i, i + 2), 16)).join(',')},${share})`;

  // White to dark: low values leave the paper white, and lines over the map stay visible.
  const sequential = [[0, '#fbfcfd'], [0.2, '#d3e3ef'], [0.4, '#9cc4df'], [0.6, '#559ac9'], [0.8, '#21649f'], [1, '#062a4f']];
  const diverging = [[0, '#053061'], [0.2, '#2f79b5'], [0.4, '#a5cee3'], [0.5, '#f7f7f7'], [0.6, '#f7b799'], [0.8, '#ca4741'], [1, '#67001f']];

  return { of, origin_name, transparent, colour_of_run, sequential, diverging };
})();
