// Follows a run in a real browser, as a user of `riffle watch` does:
//   node tests/end_to_end/watch_browser.mjs URL [SCREENSHOT-DIR]
// Goes through the states of a run and prints the name of each when the page shows it, so that the caller can bring
// about the next one: `waiting`, `advanced` (running, and the simulated time has grown), `stopped`, `finished`, `looked`
// (figures and layouts are as they should be), `alone` (the page says that nobody answers).

import { mkdirSync } from 'node:fs';
import { join } from 'node:path';
import { launch } from '../../tools/browser.mjs';

const [url, folder] = process.argv.slice(2);
if (!url) {
  console.error('usage: node watch_browser.mjs URL [SCREENSHOT-DIR]');
  process.exit(2);
}
if (folder) mkdirSync(folder, { recursive: true });

const failures = [];
const check = (ok, what) => { if (!ok) failures.push(what); };
const patience = { timeout: 120_000, polling: 100 };  // by the clock: a browser of which nobody sees frames may make none
const curve = { ...patience, state: 'attached' };  // a curve that is a level line has no height, and so is not "visible"
let answered = true;

const browser = await launch();

async function open(width, scheme) {
  const context = await browser.newContext({ viewport: { width, height: 900 }, colorScheme: scheme, deviceScaleFactor: 1 });
  const page = await context.newPage();
  page.on('console', message => {
    if (answered && ['error', 'warning'].includes(message.type())) failures.push(`at ${width} px, ${scheme}: console ${message.type()}: ${message.text()}`);
  });
  page.on('pageerror', error => failures.push(`at ${width} px, ${scheme}: script error: ${error.message}`));
  page.on('request', request => {
    if (!request.url().startsWith(url) && !/^(data|blob):/.test(request.url())) failures.push(`the page asked for ${request.url()}`);
  });
  await page.goto(url, { waitUntil: 'load' });
  return { context, page };
}

const picture = async (page, name) => { if (folder) await page.screenshot({ path: join(folder, `${name}.png`), fullPage: true }); };
const state = (page, name) => page.waitForFunction(wanted => document.documentElement.dataset.state === wanted, name, patience);
const simulated = page => page.textContent('#progress-facts [data-key="time"] dd').then(parseFloat);

// Figures and their curves, read inside the browser.
const drawn = () => [...document.querySelectorAll('.js-plotly-plot')].map(plot => {
  const finite = values => values && [...values].flat().some(value => Number.isFinite(value));
  return {
    id: plot.id, width: plot.getBoundingClientRect().width, column: plot.parentElement.getBoundingClientRect().width,
    curves: plot._fullData.filter(trace => trace.visible === true && finite(trace.z || trace.y)).length,
    titles: [...plot.querySelectorAll('.xtitle, .ytitle, .x2title, .y2title, .y3title')].filter(title => title.textContent.trim()).length,
    caption: plot.parentElement.querySelector('figcaption').textContent.length,
  };
});

async function look(page, where) {
  const plots = await page.evaluate(drawn);
  for (const id of ['plot-velocity_history', 'plot-velocity_profile', 'plot-velocity_error_profile', 'plot-mean_level_history', 'plot-fluctuation_history', 'plot-field']) {
    const plot = plots.find(one => one.id === id);
    check(plot, `${where}: ${id} is missing`);
    if (!plot) continue;
    check((plot.curves >= 1 || id === 'plot-field') && plot.titles >= 2, `${where}: ${id} has ${plot.curves} curves and ${plot.titles} axis titles`);
    check(plot.caption > 40, `${where}: ${id} has no caption`);
    check(plot.width > 200 && plot.width <= plot.column + 1, `${where}: ${id} is ${plot.width} px wide, its column ${plot.column} px`);
  }
  check((await page.$$('#diagnostics-table tbody tr')).length >= 5, `${where}: the table of diagnostics is short`);
  check((await page.textContent('#verdict')).length > 60, `${where}: no verdict`);
  const overflow = await page.evaluate(() => document.documentElement.scrollWidth - document.documentElement.clientWidth);
  check(overflow <= 0, `${where}: the page is ${overflow} px wider than the window`);
}

try {
  const { page } = await open(1280, 'light');
  await state(page, 'waiting');
  check(!await page.isVisible('#content'), 'figures are shown before there are results');
  await picture(page, 'waiting');
  console.log('waiting');

  await state(page, 'running');
  await page.waitForSelector('#plot-velocity_history .scatterlayer path', curve);
  const first = await simulated(page);
  await page.waitForFunction(before => parseFloat(document.querySelector('#progress-facts [data-key="time"] dd').textContent) > before, first, patience);
  check(/steps\/s$/.test(await page.textContent('#progress-facts [data-key="rate"] dd')), 'no speed while running');
  check(/\d/.test(await page.textContent('#progress-facts [data-key="left"] dd')), 'no time left while running');
  check(await page.getAttribute('#state-headline', 'role') === 'status', 'a change of state is not announced');
  await page.waitForSelector('#plot-velocity_profile .scatterlayer path', curve);
  await picture(page, 'running');
  console.log('advanced');

  await state(page, 'stopped');
  const stopped = await simulated(page);
  console.log('stopped');

  await state(page, 'finished');
  check(await simulated(page) > stopped, 'the resumed run did not advance');
  check(/^Finished/.test(await page.title()), 'the title does not tell that the run has finished');
  check(await page.textContent('#progress-facts [data-key="left"] dd') === 'none', 'a finished run has time left');
  check(await page.$eval('#progress-bar', bar => bar.value) === 1, 'the bar of a finished run is not full');
  console.log('finished');

  await page.waitForTimeout(300);
  await look(page, 'light');
  await picture(page, 'light');
  for (const [width, scheme] of [[1280, 'dark'], [420, 'light']]) {
    const other = await open(width, scheme);
    await other.page.waitForSelector('#plot-fluctuation_history .scatterlayer path', curve);
    await other.page.waitForTimeout(300);
    await look(other.page, `${width} px, ${scheme}`);
    await picture(other.page, `${scheme}-${width}`);
    await other.context.close();
  }
  answered = false;  // the browser itself reports refused connections in its console
  console.log('looked');

  await page.waitForFunction(() => /does not answer/.test(document.getElementById('connection').textContent), null, patience);
  check(await page.isVisible('#plot-velocity_history'), 'without an answer the page does not keep what it knew');
  console.log('alone');
} catch (error) {
  failures.push(error.message);
} finally {
  await browser.close();
}
if (failures.length) {
  console.error(failures.map(failure => `FAIL ${failure}`).join('\n'));
  process.exit(1);
}
