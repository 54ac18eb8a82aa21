// The browser that draws our pages for tests and pictures: the one named by CHROMIUM, or Debian's headless shell, which makes its
// frames without a screen and so never waits for one, or Debian's whole browser. Needs web/node_modules (npm ci --prefix web).

import { existsSync } from 'node:fs';
import { createRequire } from 'node:module';
import { dirname, join } from 'node:path';
import { fileURLToPath } from 'node:url';

const here = dirname(fileURLToPath(import.meta.url));
const { chromium } = createRequire(join(here, '../web/package.json'))('playwright-core');

const installed = ['/usr/bin/chromium-headless-shell', '/usr/bin/chromium'];

export const launch = () => chromium.launch({
  executablePath: process.env.CHROMIUM || installed.find(path => existsSync(path)) || installed[0],
  args: ['--no-sandbox', '--disable-gpu', '--disable-dev-shm-usage', '--disable-background-networking',
    '--disable-component-update', '--no-first-run', '--disable-sync', '--disable-extensions'],
});
