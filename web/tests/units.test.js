// How units, symbols and intervals are written: node --test tests/*.test.js (npm run unit).

import assert from 'node:assert/strict';
import test from 'node:test';
import { scripts } from './scripts.js';

const { elements, units } = scripts(['elements', 'units']);

test('units behind numbers stand upright, powers, products and quotients too', () => {
  for (const text of ['standard deviation 0.0107 m2/s', 'standard deviation 0.189 N m', 'about 0.12 N/m', 'velocity 0.15 m/s and area 0.018 m2', '3 s', '4 1/m', '2 W/m2',
    '0.04431 ± 0.0006 m²/s, depth-mean', '1.8e-06 N m', '(0.2 m3/s)', '9.81 m/s2', '5 kg m/s', '2 Pa s']) {
    assert.equal(units.symbols(text), text);
  }
  assert.equal(units.symbols('0.5 m^2/s'), '0.5 m<sup>2</sup>/s');
});

test('symbols are set in italics, beside numbers and units too', () => {
  assert.equal(units.symbols('the height z at x = 2 m'), 'the height <i>z</i> at <i>x</i> = 2 m');
  assert.equal(units.symbols('W/S of t, s and m'), '<i>W</i>/<i>S</i> of <i>t</i>, <i>s</i> and <i>m</i>');
  assert.equal(units.symbols('from 0.2 m2/s, q/h'), 'from 0.2 m2/s, <i>q</i>/<i>h</i>');
  assert.equal(units.symbols('x/L_0 of 3 m/s, u'), '<i>x</i>/<i>L</i><sub>0</sub> of 3 m/s, <i>u</i>');
});

test('an interval that is not finite is left out', () => {
  for (const write of [elements.tidy, units.symbols]) {
    assert.equal(write('not determined by this record (5.22 ± inf m/s)'), 'not determined by this record (5.22 m/s)');
    assert.equal(write('order 2 +- nan, limit 3'), 'order 2, limit 3');
  }
  assert.equal(elements.tidy('+1.2 % ± inf %; healthy: 0 ± 2 %'), '+1.2\u00a0%; healthy: 0 ±\u00a02\u00a0%');
  assert.equal(elements.tidy('5 ± inf %'), '5\u00a0%');
  assert.equal(elements.tidy('3 ± 0.1 m, without information'), '3 ±\u00a00.1 m, without information');
});
