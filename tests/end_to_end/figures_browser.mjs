// Looks at the figures and tables of a page in a real browser, whatever they are:
//   node tests/end_to_end/figures_browser.mjs PAGE.html [SCREENSHOT-DIR] [--figures key,key...] [--save key,key...] [--desk]
// Each figure is drawn, when it comes into view and not before, with titled axes and finite data, or says why not;
// side-by-side and overlaid views draw; those named by --save (all without it) give SVG, PNG and CSV files that hold what
// they should; nothing is wider than the window; paper takes every figure. --figures: keys that must be there.
// --desk: not on a telephone, and not on paper before it was in view; for pages whose figures another page has too.

import { mkdirSync, readFileSync, writeFileSync } from 'node:fs';
import { join, resolve } from 'node:path';
import { check, check_figure, draw_all, failures, finish, inspect, look_through_a_browser, open } from './browser.mjs';

const options = process.argv.slice(2);
const list = name => { const at = options.indexOf(name); return at < 0 ? null : options.splice(at, 2)[1].split(','); };
const desk = options.includes('--desk');
if (desk) options.splice(options.indexOf('--desk'), 1);
const expected = list('--figures') || [], saved = list('--save');
const [page_file, folder] = options;
if (!page_file) {
  console.error('usage: node figures_browser.mjs PAGE.html [SCREENSHOT-DIR] [--figures key,...] [--save key,...] [--desk]');
  process.exit(2);
}
const file = resolve(page_file), name = file.replace(/.*\//, '').replace(/\.html$/, '');
if (folder) mkdirSync(folder, { recursive: true });

// The file that a button of a figure saves. On a machine with much else to do a browser may drop a click: it gets three.
async function save(page, id, button) {
  for (let tries = 1; ; ++tries) {
    try {
      const [download] = await Promise.all([page.waitForEvent('download', { timeout: 20000 }),
        page.click(`#figure-${id} .tools button:text-is("${button}")`, { timeout: 20000 })]);
      return { name: download.suggestedFilename(), content: readFileSync(await download.path()) };
    } catch (error) {
      if (tries === 3) throw new Error(`${button} of figure ${id}: ${error.message}`);
    }
  }
}

async function check_files(page, id, state, where) {
  const svg = await save(page, id, 'SVG'), text = svg.content.toString();
  check(/\.svg$/.test(svg.name) && /^<svg[\s>]/.test(text) && /<\/svg>\s*$/.test(text) && text.length > 3000, `${where}: ${id} gave no SVG file`);
  const parsed = await page.evaluate(source => !new DOMParser().parseFromString(source, 'image/svg+xml').querySelector('parsererror'), text);
  check(parsed, `${where}: the SVG file of ${id} is no XML`);
  const png = await save(page, id, 'PNG'), size = [16, 20].map(at => png.content.readUInt32BE(at));
  check(/\.png$/.test(png.name) && png.content.subarray(1, 4).toString() === 'PNG', `${where}: ${id} gave no PNG file`);
  check(Math.abs(size[0] - 3 * state.width) <= 3, `${where}: the PNG file of ${id} is ${size[0]} px wide, expected three times ${state.width}`);
  for (const button of state.buttons.filter(label => /CSV/.test(label))) {
    const csv = await save(page, id, button), lines = csv.content.toString().trim().split('\n').filter(line => !line.startsWith('#'));
    check(/\.csv$/.test(csv.name) && lines.length > 2, `${where}: ${button} of ${id} gave no table`);
    const numbers = lines.slice(1).map(line => line.split(',').filter(cell => cell !== '' && Number.isFinite(Number(cell))).length);
    // A gap of a line is a row without numbers.
    check(numbers.filter(count => count >= 2).length > 0.5 * numbers.length, `${where}: ${button} of ${id} holds lines without numbers`);
    check(/\[.+\]|\(.+\)/.test(lines[0] + lines[1]), `${where}: ${button} of ${id} names no units: ${lines[0]}`);
  }
}

// The surface has another picture at another moment and in the other view, and plays until it is stopped.
async function check_moving_surface(page, where) {
  const figure = page.locator('#figure-moving-surface'), picture = () => figure.locator('.imagelayer image').first().evaluate(image => image.getAttribute('href') || image.getAttribute('xlink:href'));
  const moment = () => figure.locator('.frames').textContent(), changes = async (what, read, act) => {
    const before = await read();
    await act();
    for (let tries = 0; tries < 100 && (await read()) === before; ++tries) await page.waitForTimeout(50);
    check((await read()) !== before, `${where}: ${what} of the moving surface does not change`);
  };
  await figure.scrollIntoViewIfNeeded();
  check(/t = \d+\.\d+ s/.test(await moment()), `${where}: the moving surface does not name its moment`);
  await changes('the picture', picture, () => figure.locator('.frames input').fill('3'));
  await changes('the view', picture, () => figure.locator('.choices > button').nth(1).click());
  await changes('the moment', moment, () => figure.locator('button.play').click());
  await figure.locator('button.play').click();
  await page.waitForTimeout(300);
  const stopped = await moment();
  await page.waitForTimeout(900);
  check((await moment()) === stopped, `${where}: the moving surface goes on after it was stopped`);
}

async function check_page(browser, width, height, scheme) {
  const { context, page, where } = await open(browser, file, width, height, scheme);
  const ids = await page.$$eval('figure', all => all.map(figure => figure.id.replace('figure-', '')));
  const before = (await page.$$('.js-plotly-plot')).length, all = (await page.$$('figure .plot')).length;
  check(all < 8 || before < all, `${where}: all ${all} figures are drawn before they come into view`);
  for (const key of expected) check(ids.includes(key), `${where}: figure ${key} is missing`);
  check(new Set(ids).size === ids.length, `${where}: two figures share a name`);
  await draw_all(page);
  const states = {};
  for (const id of ids) {
    const state = states[id] = await page.evaluate(inspect, id);
    if (state.note) check(state.note.length > 20, `${where}: the note in place of figure ${id} says nothing`);
    else check_figure(id, state, where);
  }
  const overflow = await page.evaluate(() => document.documentElement.scrollWidth - document.documentElement.clientWidth);
  check(overflow <= 0, `${where}: the page is ${overflow} px wider than the window`);
  if (folder) await page.screenshot({ path: join(folder, `${name}-${width}-${scheme}.png`), fullPage: true });
  return { context, page, where, ids, states };
}

await look_through_a_browser(async browser => {
  const { context, page, where, ids, states } = await check_page(browser, 1280, 900, 'light');
  for (const id of ids) if (!states[id].note && (!saved || saved.includes(id))) await check_files(page, id, states[id], where);
  // Each view of a figure of several runs draws as the other does.
  for (const button of await page.$$('.chapter .choices button[aria-pressed="false"]')) {
    await button.scrollIntoViewIfNeeded();
    await button.click();
    const id = await button.evaluate(element => element.closest('figure').id.replace('figure-', ''));
    check_figure(id, await page.evaluate(inspect, id), `${where}, other view`);
  }
  if (ids.includes('moving-surface')) await check_moving_surface(page, where);
  const empty = await page.$$eval('.findings tbody tr', rows => rows.filter(row => ![...row.querySelectorAll('td')].some(cell => cell.textContent.trim())).length);
  check(empty === 0, `${where}: ${empty} rows of findings are empty`);
  await page.evaluate(() => addEventListener('beforeprint', () => {
    window.printed = [...document.querySelectorAll('.js-plotly-plot')].map(plot => [plot.id, plot._fullLayout.width, plot.closest('.pair') && !plot.closest('.wide') ? 335 : 688]);
  }));
  const paper = await page.pdf({ preferCSSPageSize: true, printBackground: true });
  check(paper.length > 30_000 && paper.subarray(0, 5).toString() === '%PDF-', `${where}: printing gave no PDF`);
  if (folder) writeFileSync(join(folder, `${name}.pdf`), paper);
  const printed = await page.evaluate(() => window.printed || []), figures = ids.filter(id => !states[id].note).length;
  check(printed.length === figures, `on paper: ${printed.length} of ${figures} figures`);
  for (const [id, width, column] of printed) check(width <= column, `on paper: ${id} is ${width} px wide, its column ${column} px`);
  await context.close();
  if (desk) return;
  // Paper takes figures that have never been in view, too.
  const fresh = await open(browser, file, 1280, 900, 'light');
  await fresh.page.pdf({ preferCSSPageSize: true });
  const drawn = (await fresh.page.$$('.js-plotly-plot')).length;
  check(drawn === figures, `on paper at once: ${drawn} of ${figures} figures`);
  await fresh.context.close();
  // A telephone at night: the narrow page and the dark one at once.
  const seen = await check_page(browser, 420, 900, 'dark');
  await seen.context.close();
});
finish(`figures look right: ${file} (${failures.length} faults)`);
