// Looks at a report in a real browser, without a network:
//   node tests/end_to_end/report_browser.mjs REPORT.html [SCREENSHOT-DIR] [--partial] [--kind KIND] [--desk]
// Checks what a reader relies on: no errors, no request leaves the page, each figure has axes with titles and a
// visible trace of finite data, the tables hold numbers, the field picture is painted, the page fits a desk and
// a telephone, it prints. --partial allows notes in place of figures and a short
// summary (a run that has only just started). --kind: of the flow, whose figures must be there: uniform (without the option), bodies, tank,
// wave, box. --desk: not on a telephone.

import { existsSync, mkdirSync, statSync, writeFileSync } from 'node:fs';
import { join, resolve } from 'node:path';
import { check, check_figure, draw_all, finish, inspect, look_through_a_browser, open } from './browser.mjs';

const options = process.argv.slice(2);
const desk = options.includes('--desk');
const partial = options.includes('--partial');
const kind = options.includes('--kind') ? options.splice(options.indexOf('--kind'), 2)[1] : 'uniform';
const [page_file, folder] = options.filter(option => !option.startsWith('--'));
if (!page_file) {
  console.error('usage: node report_browser.mjs REPORT.html [SCREENSHOT-DIR] [--partial] [--kind KIND] [--desk]');
  process.exit(2);
}
const file = resolve(page_file);
if (folder) mkdirSync(folder, { recursive: true });

const tank = ['level_lines', 'level_history', 'energy_history', 'volume_history', 'level_map', 'field', 'density_history'];
const expected = {
  uniform: ['velocity_profile', 'log_law', 'velocity_gradient_profile', 'velocity_error_profile', 'stress_profile', 'pressure_profile', 'velocity_history', 'force_history', 'field',
    'surface_map', 'fluctuation_history', 'order_history', 'density_history'],
  bodies: ['long_profile', 'velocity_along', 'froude_along', 'solid_forces', 'solid_moments', 'force_history', 'velocity_history', 'field', 'density_history'],
  tank: [...tank, 'front_history'],
  wave: [...tank, 'mode_history'],
  box: ['energy_history', 'volume_history', 'field', 'density_history'],
}[kind];
// Share of painted pixels in the field's picture, and its number of distinct colours.
const painted = async () => {
  const image = document.querySelector('#figure-field .imagelayer image');
  if (!image) return null;
  const picture = new Image();
  picture.src = image.getAttribute('href') || image.getAttribute('xlink:href');
  await picture.decode();
  const canvas = document.createElement('canvas');
  canvas.width = picture.width;
  canvas.height = picture.height;
  const pen = canvas.getContext('2d');
  pen.drawImage(picture, 0, 0);
  const { data } = pen.getImageData(0, 0, canvas.width, canvas.height);
  let count = 0;
  const colours = new Set();
  for (let i = 0; i < data.length; i += 4) {
    if (data[i + 3] < 200) continue;
    ++count;
    colours.add((data[i] << 16) | (data[i + 1] << 8) | data[i + 2]);
  }
  return { share: count / (data.length / 4), colours: colours.size };
};

async function check_page(browser, width, height, scheme) {
  const { context, page, where } = await open(browser, file, width, height, scheme);
  await draw_all(page);
  for (const id of expected) {
    if (partial && !(await page.$(`#figure-${id}`))) continue;
    const state = await page.evaluate(inspect, id);
    check(state.present, `${where}: figure ${id} is missing`);
    if (!state.present) continue;
    if (state.note) {
      check(partial, `${where}: figure ${id} was not drawn: ${state.note}`);
      check(state.note.length > 20, `${where}: the note in place of figure ${id} says nothing`);
      continue;
    }
    check_figure(id, state, where);
  }
  const overflow = await page.evaluate(() => document.documentElement.scrollWidth - document.documentElement.clientWidth);
  check(overflow <= 0, `${where}: the page is ${overflow} px wider than the window`);
  if (folder) await page.screenshot({ path: join(folder, `report-${width}-${scheme}.png`), fullPage: true });
  return { context, page, where };
}

await look_through_a_browser(async browser => {
  // A desk: everything, and the ways to use the page.
  const { context, page, where } = await check_page(browser, 1280, 900, 'light');
  const rows = await page.$$eval('#summary-table tbody tr', lines => lines.map(line => ({ key: line.dataset.key,
    numbers: [...line.querySelectorAll('td')].map(cell => cell.dataset.value).filter(value => value !== undefined).map(Number) })));
  check(rows.length >= (partial ? 0 : kind === 'uniform' ? 5 : 2), `${where}: the summary table has ${rows.length} rows`);
  const mean = rows.find(row => row.key === 'depth_mean_velocity');
  // Only uniform channels have a twin to compare with.
  check(partial || (kind === 'uniform' ? mean && mean.numbers.length >= 2 && mean.numbers.every(value => value > 0) : !mean || mean.numbers.length === 1),
    `${where}: the summary table lacks the depth-mean velocity, or has a twin that the flow has not`);
  check(rows.every(row => row.numbers.length >= 1 && row.numbers.every(Number.isFinite)), `${where}: a row of the summary table has no number`);
  const marks = await page.$$eval('#diagnostics-table .mark', cells => cells.map(cell => cell.textContent));
  check(partial || marks.length >= (kind === 'uniform' ? 5 : 2), `${where}: the diagnostics table has ${marks.length} rows`);
  check((await page.textContent('#verdict')).length > 80, `${where}: no verdict`);
  check((await page.textContent('#case-text')).includes('[channel]'), `${where}: the case is not on the page`);

  if (await page.$('#figure-field .js-plotly-plot')) {
    const seen = new Set();
    for (const button of await page.$$('#figure-field .choices button')) {
      await button.click();
      const picture = await page.evaluate(painted);
      check(picture && picture.share > (kind === 'uniform' ? 0.5 : 0.1) && picture.colours > 5, `${where}: the field picture is empty (${JSON.stringify(picture)})`);
      seen.add(await page.$eval('#figure-field .imagelayer image', image => (image.getAttribute('href') || image.getAttribute('xlink:href')).slice(-400)));
    }
    const buttons = (await page.$$('#figure-field .choices button')).length;
    check(buttons >= 3 && seen.size === buttons, `${where}: ${seen.size} different field pictures from ${buttons} buttons`);
    await (await page.$('#figure-field .choices button')).click();
    const slider = await page.$('#figure-field .frames input');
    if (slider && !partial) {
      const source = () => page.$eval('#figure-field .imagelayer image', image => image.getAttribute('href') || image.getAttribute('xlink:href'));
      const last = await source();
      await slider.fill('0');
      await page.waitForFunction(before => { const image = document.querySelector('#figure-field .imagelayer image'); return (image.getAttribute('href') || image.getAttribute('xlink:href')) !== before; },
        last, { timeout: 20000 }).catch(() => check(false, `${where}: the slider shows no other snapshot`));
      check(/t = 0 s/.test(await page.textContent('#figure-field .frames')), `${where}: the slider does not name the time of the snapshot`);
    }
    const plot = await page.$('#plot-field .nsewdrag');
    await plot.scrollIntoViewIfNeeded();
    const box = await plot.boundingBox();
    await page.mouse.move(box.x + 0.15 * box.width, box.y + 0.75 * box.height);  // water in a tank before its dam breaks, too
    await page.waitForTimeout(50);
    check(/Particle at x = .* u = /.test(await page.textContent('#figure-field .readout')), `${where}: no value under the pointer in the field picture`);
  }
  await page.click('#copy-case');
  const copied = await page.waitForFunction(() => /Copied|Selected/.test(document.getElementById('copy-case').textContent), null, { timeout: 20000 }).catch(() => null);
  check(copied, `${where}: the case cannot be copied`);
  if (await page.$('#plot-velocity_profile')) {
    const svg = await page.evaluate(() => Plotly.toImage(document.getElementById('plot-velocity_profile'), { format: 'svg', width: 600, height: 460 }));
    check(svg.startsWith('data:image/svg+xml') && svg.length > 5000, `${where}: a figure cannot be saved as SVG`);
  }
  // On paper each figure must fit its column of the A4 page: 182 mm, or half of it less the gap.
  await page.evaluate(() => addEventListener('beforeprint', () => {
    window.printed = [...document.querySelectorAll('.js-plotly-plot')].map(plot => [plot.id, plot._fullLayout.width, plot.closest('.pair') && !plot.closest('.wide') ? 335 : 688]);
  }));
  const paper = await page.pdf({ preferCSSPageSize: true, printBackground: true });
  check(paper.length > 50_000 && paper.subarray(0, 5).toString() === '%PDF-', `${where}: printing gave no PDF`);
  if (folder) writeFileSync(join(folder, 'report.pdf'), paper);
  const printed = await page.evaluate(() => window.printed || []);
  check(partial || printed.length >= expected.length, `on paper: ${printed.length} figures were refitted`);
  for (const [id, width, column] of printed) check(width <= column, `on paper: ${id} is ${width} px wide, its column ${column} px`);
  await context.close();
  if (desk) return;

  // A telephone at night: the narrow page and the dark one at once.
  const seen = await check_page(browser, 420, 900, 'dark');
  await seen.context.close();
});

check(existsSync(file) && statSync(file).size < 12e6, 'the report is larger than 12 MB');
finish(`report looks right: ${file}`);
