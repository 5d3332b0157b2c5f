// SPDX-License-Identifier: Apache-2.0
// Every entry can be bundled for browsers: what only Node has is left out by the package's own word.
import assert from 'node:assert/strict';
import test from 'node:test';
import { fileURLToPath } from 'node:url';

import { build } from 'esbuild';

for (const entry of ['', '/attributes', '/attributes/single', '/scene'])
    test(`rakelight${entry} is bundled for browsers`, async () => {
        const { errors, warnings, outputFiles: [{ text }] } = await build({
            stdin: { contents: `export * from 'rakelight${entry}';`, resolveDir: fileURLToPath(new URL('.', import.meta.url)) },
            bundle: true, format: 'esm', platform: 'browser', write: false, logLevel: 'silent',
        });
        assert.deepEqual([errors, warnings], [[], []]);
        assert.doesNotMatch(text, /from ?"(node:|fs|module)|import\("(node:|fs|module)/);
    });
