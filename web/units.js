// Readable units: the SI prefix that fits a range of values, and how units and symbols are written.

const units = (() => {
  'use strict';

  const pretty = unit => (unit === '1' || !unit ? '–' : unit.replace(/\^\(?(\d+\/\d+)\)?/g, '<sup>$1</sup>').replace(/(?<=[a-zA-Z])\^?(-?\d)(?![^<]*<\/sup>)/g, power =>
    ({ 2: '²', 3: '³', 4: '⁴', 5: '⁵' })[power.replace('^', '')] || power));

  // [largest magnitude below which it is used, unit shown, factor from SI]; the first that fits.
  const choices = {
    m: [[1e-4, 'µm', 1e6], [2, 'mm', 1e3]],
    m2: [[1e-2, 'mm2', 1e6]],
    s: [[1e-4, 'µs', 1e6], [0.1, 'ms', 1e3]],
    'm/s': [[0.05, 'mm/s', 1e3]],
    'm2/s': [[1e-3, 'mm2/s', 1e6]],
    'm2/s2': [[1e-2, 'mm2/s2', 1e6]],
    'm3/s': [[1, 'L/s', 1e3]],
    Pa: [[0.05, 'mPa', 1e3], [2e4, 'Pa', 1], [Infinity, 'kPa', 1e-3]],
    '1/m': [[1e3, '1/m', 1], [1e6, '1/mm', 1e-3], [Infinity, '1/µm', 1e-6]],
    V: [[0.1, 'mV', 1e3]],
    Hz: [[2e4, 'Hz', 1], [Infinity, 'kHz', 1e-3]],
  };

  // Unit and factor for values of this magnitude. On a logarithmic axis only lengths change: decades are readable
  // in any unit.
  function scale(unit, magnitude, logarithmic = false) {
    const fitting = !(magnitude > 0) || (logarithmic && unit !== 'm') ? undefined
      : (choices[unit] || []).find(([limit]) => magnitude < limit);
    return fitting ? { unit: pretty(fitting[1]), factor: fitting[2] } : { unit: pretty(unit), factor: 1 };
  }

  const escape = text => String(text).replace(/&/g, '&amp;').replace(/</g, '&lt;').replace(/>/g, '&gt;');

  const greek = { alpha: 'α', beta: 'β', delta: 'δ', eta: 'η', kappa: 'κ', lambda: 'λ', nu: 'ν', omega: 'ω', phi: 'φ', pi: 'π', Pi: 'Π', rho: 'ρ', sigma: 'σ', tau: 'τ',
    theta: 'θ', xi: 'ξ' };

  // Symbols that plain text spells with words and letters: eta', u*, ks, z0.
  const spelled = text => text
    .replace(/(^|[^\p{L}])(alpha|beta|delta|eta|kappa|lambda|nu|omega|phi|pi|Pi|rho|sigma|tau|theta|xi)(?![\p{L}-])/gu, (_, before, name) => before + greek[name])
    .replace(/(^|[^\p{L}])u\*/gu, '$1u_*').replace(/(^|[^\p{L}])ks(?![\p{L}])/gu, '$1k_s').replace(/(^|[^\p{L}])([zhL])0(?!\d)/gu, '$1$2_0');

  // The end of a number with a unit behind it, or with the part of a unit that ends here: 3 s, 0.2 m2/s, 4 N m, 5 1/m.
  // A letter alone behind a number is taken for a unit.
  const unit_word = '(?:[kcmµ]?m|[mµ]?s|k?N|[kM]?Pa|k?g|k?Hz|k?J|k?W|m?V|L|K|rad|min)', power = '(?:-?\\d|[²³⁴⁵]|<sup>[^<]*</sup>)?';
  const unit_behind_number = new RegExp(`\\d\\s?(?:\\p{L}|(?:(?:1|${unit_word}${power})[ /·])+${unit_word})$`, 'u');

  // Plain text with its symbols set as symbols: single letters in italics, what follows _ as index, what follows ^ as
  // exponent. Articles stay words, and units behind numbers stay upright.
  const symbols = text => escape(spelled(elements.certain(text)))
    .replace(/(^|[^\p{L}\d_])([\p{L}]{1,2}'?)_\{?((?:[\p{L}\d∗*]|,(?=[\p{L}\d]))+)\}?/gu, (_, before, letter, index) => `${before}<i>${letter}</i><sub>${index.replace('*', '∗')}</sub>`)
    .replace(/\^\(([^)]+)\)/gu, (_, power) => `<sup>${power.replace('-', '−')}</sup>`)
    .replace(/\^\{?([−-]?\d+(?:\/\d+)?)\}?/gu, (_, power) => `<sup>${power.replace('-', '−')}</sup>`)
    .replace(/(^|[^\p{L}])d(\p{L})\/d(\p{L})(?!\p{L})/gu, '$1d<i>$2</i>/d<i>$3</i>')
    .replace(/(?<=^|[\s(\/=+−·,|²³-])(?![aAI](?![\p{L}\d']))\p{L}'?(?=$|[\s)\/=+−·,|²³.;:-])/gu, (letter, at, whole) =>
      (unit_behind_number.test(whole.slice(0, at) + letter) ? letter : `<i>${letter}</i>`));

  // A title along an axis of so many pixels, broken into two lines where it is longer. An axis shorter than that takes
  // the symbol alone, the last word of a label.
  function wrapped(text, pixels) {
    const plain = text.replace(/<[^>]*>/g, '');
    if (plain.length * 7.4 < pixels) return text;
    const short = text.match(/\S+ \([^()]*\)$/);
    if (plain.length * 7.4 > 2 * pixels && short) return short[0];
    const spaces = [...text.matchAll(/ (?![^<]*>)/g)].map(match => match.index);
    if (!spaces.length) return text;
    const middle = spaces.reduce((best, at) => (Math.abs(at - text.length / 2) < Math.abs(best - text.length / 2) ? at : best));
    return `${text.slice(0, middle)}<br>${text.slice(middle + 1)}`;
  }

  const title = (label, unit) => `${symbols(label)} (${unit})`;

  return { scale, pretty, symbols, title, wrapped };
})();
