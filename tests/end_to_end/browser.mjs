// What the browser's tests of the pages share: a page without a network, and the faults that a page must not have.

import { pathToFileURL } from 'node:url';
import { launch } from '../../tools/browser.mjs';

export const failures = [];
export const check = (ok, what) => { if (!ok) failures.push(what); };

// A browser that no longer makes frames of its pages: nothing comes into view in it. It is no fault of the page.
class Stalled extends Error {}

// A button is clicked when it stands still for two frames, so a browser that makes none lets the click run out of time.
const may_have_stalled = error => error instanceof Stalled || error.name === 'TimeoutError';

// Has a browser looked through, and another one where the first has stalled; three stalled ones are a failure.
export async function look_through_a_browser(look) {
  for (let left = 2; ; --left) {
    failures.length = 0;
    const browser = await launch();
    try {
      return await look(browser);
    } catch (error) {
      if (!may_have_stalled(error) || left === 0) throw error;
      console.error(`note: ${error.message.split('\n')[0]}; the next one begins anew`);
    } finally {
      await browser.close();
    }
  }
}

// A page without a network; what it writes to the console, throws or asks for is a failure.
export async function open(browser, file, width, height, scheme) {
  const context = await browser.newContext({ viewport: { width, height }, colorScheme: scheme, offline: true, deviceScaleFactor: 1, acceptDownloads: true });
  const page = await context.newPage();
  page.setDefaultTimeout(60_000);  // a frame of a long page takes seconds on a busy machine
  const where = `at ${width} px, ${scheme}`;
  page.on('console', message => { if (['error', 'warning'].includes(message.type())) failures.push(`${where}: console ${message.type()}: ${message.text()}`); });
  page.on('pageerror', error => failures.push(`${where}: script error: ${error.message}`));
  page.on('request', request => {
    const url = request.url();
    if (url !== pathToFileURL(file).href && !/^(data|blob):/.test(url)) failures.push(`${where}: the page asked for ${url}`);
  });
  await page.goto(pathToFileURL(file).href, { waitUntil: 'load' });
  return { context, page, where };
}

// Figures are drawn when they come into view: show each, and wait until it is drawn. A browser on a busy machine may stop making
// frames of a page that nobody looks at, and sees nothing come into view then: a screenshot has it make one, or shows that it
// has stalled.
export async function draw_all(page) {
  for (const plot of await page.$$('figure .plot')) {
    for (let patience = 2; ; --patience) {
      // Again and again: figures above that are being drawn move it away.
      const drawn = await page.waitForFunction(element => {
        element.scrollIntoView({ block: 'center' });
        return element.classList.contains('js-plotly-plot') && element._fullLayout;
      }, plot, { timeout: 20000, polling: 10 }).catch(() => null);
      if (drawn) break;
      const frame = await page.screenshot({ clip: { x: 0, y: 0, width: 1, height: 1 }, timeout: 20000 }).catch(() => null);
      const id = await plot.evaluate(element => element.id);
      if (!frame) throw new Stalled(`the browser makes no frame in which ${id} could come into view`);
      if (patience === 0) throw new Error(`${id} is not drawn where it is in view`);
    }
  }
  await page.evaluate(() => scrollTo(0, 0));
}

export const finish = what => {
  if (failures.length) {
    console.error(failures.map(failure => `FAIL ${failure}`).join('\n'));
    process.exit(1);
  }
  console.log(what);
};

// What stands in one figure, read inside the browser.
export const inspect = id => {
  const figure = document.getElementById(`figure-${id}`);
  if (!figure) return { present: false };
  const note = figure.querySelector('.note'), plot = figure.querySelector('.js-plotly-plot');
  if (note) return { present: true, note: note.textContent };
  if (!plot) return { present: true };
  const axes = Object.keys(plot._fullLayout).filter(key => /^[xy]axis\d*$/.test(key)).map(key => plot._fullLayout[key]);
  // An axis may leave its title to the one that it is tied to, or panels to a common one.
  const common = (plot._fullLayout.annotations || []).filter(note => /\(.+\)$/.test(note.text) && note.xref === 'paper').length;
  const untitled = common >= 2 ? 0 : axes.filter(axis => axis.showticklabels !== false && !(axis.title && axis.title.text)).length;
  const drawn = common + [...plot.querySelectorAll('.xtitle, .ytitle, .x2title, .y2title, .y3title')].filter(text => text.textContent.trim()).length;
  const finite = values => values && [...values].flat().some(value => Number.isFinite(value));
  const traces = plot._fullData.filter(trace => trace.visible === true && (trace.z ? finite(trace.z) : finite(trace.x) && finite(trace.y)));
  const marks = plot.querySelectorAll('.scatterlayer path, .barlayer path, .imagelayer image, .heatmaplayer image').length;
  const box = plot.querySelector('.main-svg').getBoundingClientRect();
  const ranges = axes.every(axis => axis.range.every(Number.isFinite));
  const caption = figure.querySelector('figcaption');
  const buttons = [...figure.querySelectorAll('.tools button')].map(button => button.textContent);
  return { present: true, untitled, drawn, traces: traces.length, marks, width: box.width, height: box.height, ranges,
    caption: caption ? caption.textContent : '', buttons };
};

// Faults of one figure as words.
export function check_figure(id, state, where) {
  check(state.untitled === 0 && state.drawn >= 2, `${where}: figure ${id} has an axis without a title`);
  check((state.traces >= 1 || ['field', 'moving-surface'].includes(id)) && state.marks >= 1, `${where}: figure ${id} shows no data`);
  check(state.width > 200 && state.height > 120, `${where}: figure ${id} is ${state.width} x ${state.height} px`);
  check(state.ranges, `${where}: figure ${id} has an axis without a range`);
  check(/^Figure \d+\. .{20}/.test(state.caption), `${where}: figure ${id} has no caption`);
  check(['SVG', 'PNG'].every(name => state.buttons.includes(name)) && state.buttons.some(name => /CSV/.test(name)), `${where}: figure ${id} cannot be saved`);
}
