// SPDX-License-Identifier: Apache-2.0
// Imported before a block of the README runs: its names, and fetch() of files beside it as in a browser.
import { readFile } from 'node:fs/promises';

import { values } from './readme.mjs';

Object.assign(globalThis, await values());
globalThis.Request = class { constructor(url) { this.url = url; } };
globalThis.fetch = async ({ url }) => new Response(await readFile(url));
globalThis.ProgressEvent = class {};
