// Loads the pages' scripts as a page does, one after the other into one scope, without a browser.

import { readFileSync } from 'node:fs';
import { runInNewContext } from 'node:vm';

const text_of = name => readFileSync(new URL(`../${name}.js`, import.meta.url), 'utf8');

// The objects that the scripts of these names make, by name. `around`: what the scripts find in a browser.
export const scripts = (names, around = {}) =>
  runInNewContext(`${names.map(text_of).join('\n')}\n({ ${names.join(', ')} })`, { atob, ...around });
