// Puts figures of a report side by side into one PNG, for the README and the gallery:
//   node tools/report-picture.mjs REPORT.html PICTURE.png velocity stress field
// Names are those of the report's figures (figure-<name>). Needs what tools/browser.mjs says.

import { resolve } from 'node:path';
import { pathToFileURL } from 'node:url';
import { launch } from './browser.mjs';

const [report, picture, ...names] = process.argv.slice(2);
if (!names.length) {
  console.error('usage: node tools/report-picture.mjs REPORT.html PICTURE.png FIGURE...');
  process.exit(2);
}

const browser = await launch();
try {
  const page = await browser.newPage({ viewport: { width: 1280, height: 900 }, colorScheme: 'light' });
  await page.goto(pathToFileURL(resolve(report)).href);
  const shots = [];
  for (const name of names) {
    // Figures are drawn when they come into view.
    await page.locator(`#figure-${name}`).scrollIntoViewIfNeeded();
    const plot = page.locator(`#figure-${name} .js-plotly-plot`).first();
    await plot.locator('.main-svg').first().waitFor();
    await page.waitForTimeout(1000);
    shots.push((await plot.screenshot()).toString('base64'));
  }
  const sheet = await browser.newPage({ viewport: { width: 1280, height: 900 } });
  const images = shots.map(data => `<img src="data:image/png;base64,${data}">`).join('');
  await sheet.setContent(
    `<body style="margin:0;background:white"><div id="sheet" style="display:flex;flex-wrap:wrap;gap:12px;` +
    `justify-content:center;align-items:center;width:1280px;padding:8px;box-sizing:border-box">${images}</div></body>`);
  await sheet.waitForTimeout(300);
  await sheet.locator('#sheet').screenshot({ path: picture });
} finally {
  await browser.close();
}
