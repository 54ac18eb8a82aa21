// The map of the moving surface: where it shows water, and what its caption says: node --test tests/*.test.js.

import assert from 'node:assert/strict';
import test from 'node:test';
import { scripts } from './scripts.js';

// As much of a canvas as the map needs.
const document = { createElement: () => {
  const canvas = { getContext: () => ({ createImageData: (width, height) => ({ data: new Uint8ClampedArray(4 * width * height) }), putImageData: image => { canvas.data = image.data; } }) };
  return canvas;
} };
const { moving_surface } = scripts(['figures', 'units', 'field', 'moving_surface'], { document });

const grey = [154, 154, 154];

// A moment of levels between -largest and largest, packed as the report does; null: no water.
const packed = (levels, largest) => Buffer.from(Uint16Array.from(levels, level => (level === null ? 65535 : Math.round(65534 * (level + largest) / (2 * largest)))).buffer).toString('base64');

// A surface of points one metre apart, each in the middle of its square.
function surface(rows, options = {}) {
  const largest = options.largest || 1, [nx, ny] = [rows[0].length, rows.length], middles = n => Array.from({ length: n }, (_, i) => i + 0.5);
  const frame = packed(rows.flat(), largest);
  return { x: middles(nx), y: middles(ny), length: nx, width: ny, time: [0, 1], frames: [frame, frame], largest, periodic_along: false, periodic_across: false, ...options };
}

// The colours of a picture of `fine` by `fine` pixels a square, rows from the bottom as in the surface.
function colours(of, view, fine = 4) {
  const width = fine * of.x.length, height = fine * of.y.length, { data } = moving_surface.paint(of, 0, view, width, height);
  return Array.from({ length: height }, (_, row) => Array.from({ length: width }, (_, column) => [...data.slice(4 * ((height - 1 - row) * width + column), 4 * ((height - 1 - row) * width + column) + 3)]));
}

const is_grey = colour => colour.every((value, k) => value === grey[k]);
const waves = (ny, nx) => Array.from({ length: ny }, (_, j) => Array.from({ length: nx }, (_, i) => 0.2 * Math.sin(i + 0.7 * j)));

// Two bodies that leave a slot of one point, and a dry corner.
const with_gaps = () => {
  const rows = waves(7, 9);
  for (const j of [0, 1, 2, 4, 5, 6]) rows[j][4] = null;
  rows[6][8] = null;
  return rows;
};

test('a pixel is grey where the point nearest to it has no level, and nowhere else', () => {
  for (const view of ['elevation', 'light']) {
    for (const period of [{}, { periodic_along: true, periodic_across: true }]) {
      const rows = with_gaps();
      colours(surface(rows, period), view).forEach((line, row) => line.forEach((colour, column) =>
        assert.equal(is_grey(colour), rows[Math.floor(row / 4)][Math.floor(column / 4)] === null, `${view}, pixel ${column}, ${row}`)));
    }
  }
});

test('beside a gap the colours are those of the levels there', () => {
  const flat = waves(7, 9).map(row => row.map(() => 0.3)), holed = flat.map(row => [...row]);
  holed[3][4] = null;
  const without = colours(surface(flat), 'elevation'), beside = colours(surface(holed), 'elevation');
  beside.forEach((line, row) => line.forEach((colour, column) => { if (!is_grey(colour)) assert.deepEqual(colour, without[row][column]); }));
});

test('a gap changes nothing that is farther away than the curves reach', () => {
  const rows = waves(7, 12), holed = rows.map(row => [...row]), range = { limit: 0.2 };
  holed[3][1] = null;
  const [without, beside] = [rows, holed].map(of => colours(surface(of, range), 'elevation'));
  beside.forEach((line, row) => assert.deepEqual(line.slice(16), without[row].slice(16)));
});

test('a moment without any water is grey all over', () => {
  const none = waves(3, 4).map(row => row.map(() => null));
  assert.ok(colours(surface(none), 'light').flat().every(is_grey));
});

test('the caption names the grey of places without water where there are any', () => {
  assert.match(moving_surface.caption(surface(with_gaps())), /Grey: no water\.$/);
  assert.doesNotMatch(moving_surface.caption(surface(waves(7, 9))), /Grey/);
});

test('the caption says how much steeper the slopes are drawn, within a bound, and nothing of a flat surface', () => {
  const caption = height => moving_surface.caption(surface(waves(7, 9).map(row => row.map(level => height * level)), { largest: height }));
  const steeper = height => Number((caption(height).match(/slopes drawn (\S+) times as steep/) || [])[1]);
  assert.ok(steeper(1) > 1 && steeper(1) < 10, caption(1));
  assert.equal(Math.round(steeper(0.1) / steeper(1)), 10);
  assert.equal(steeper(1e-3), 1000);
  assert.doesNotMatch(caption(1e-12), /steep/);
  assert.match(caption(1e-12), /Relief: light from the upper left, without what is shorter/);
});
