// What all figures share: colours, axes, layout, and how numbers are written. Values come in SI; figures only give them
// readable prefixes.

const figures = (() => {
  'use strict';

  // Okabe and Ito's palette, told apart by colour-blind readers; marks differ in shape or dash as well.
  const colour = { surface: '#D55E00', body: '#b9c0c7', edge: '#4a535d', guide: '#7a848e', window: 'rgba(0,114,178,0.10)' };
  const ink = '#1b2026';

  const has = (group, ...names) => Boolean(group) && names.every(name => Array.isArray(group[name]) && group[name].length > 0);

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
      title: { text: title, standoff: 8 }, automargin: true, showline: true, mirror: true, linecolor: colour.edge,
      linewidth: 1, ticks: 'outside', ticklen: 5, tickcolor: colour.edge, gridcolor: '#e6e9ed', zeroline: false,
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

  return { axis, layout, significant, interval, colour, has, ink };
})();
