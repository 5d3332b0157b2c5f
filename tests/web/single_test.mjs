// SPDX-License-Identifier: Apache-2.0
// rakelight/attributes/single computes the same as rakelight/attributes, alone in a folder too.
import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import { copyFile, mkdtemp, readFile, rm } from 'node:fs/promises';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import test from 'node:test';
import { fileURLToPath } from 'node:url';
import { gzipSync } from 'node:zlib';

import * as whole from 'rakelight/attributes';
import * as single from 'rakelight/attributes/single';
import { half } from './readme.mjs';

const file = fileURLToPath(new URL('./node_modules/rakelight/attributes_single.js', import.meta.url));
const parts = [half(0), half(Math.PI)].map(part => ({ ...part, texcoords: Float32Array.from({ length: part.positions.length / 3 * 2 }, (_, i) => i % 7 / 7) }));

test('both entries export the same, and compute the same', async () => {
    assert.deepEqual(Object.keys(single), Object.keys(whole));
    const [a, b] = await Promise.all([whole.loadAttributes(), single.loadAttributes()]);
    for (const options of [{}, { scope: 'object', weight: 'angle', crease: 30 }, { tangentMode: 'mikktspace' }]) {
        const made = a.computeAttributes(parts, options);
        assert.ok(made[0].normals.length > 0 && made[0].tangents.length > 0);
        assert.deepEqual(b.computeAttributes(parts, options), made);
    }
    const own = a.computeAttributes(parts, { scope: 'object', crease: 180, tangents: false }), withNormals = parts.map((part, i) => ({ ...part, normals: own[i].normals }));
    assert.deepEqual(b.joinSeams(withNormals), a.joinSeams(withNormals));
});

test('its errors are its own', async () => {
    const attributes = await single.loadAttributes();
    assert.throws(() => attributes.computeAttributes([{ positions: [1, 2] }]), single.AttributesError);
});

test('it needs no other file, nor an address', async () => {
    const folder = await mkdtemp(join(tmpdir(), 'rakelight '));
    try {
        await copyFile(file, join(folder, 'alone.mjs'));
        const call = `const [{ normals }] = (await loadAttributes()).computeAttributes([{ positions: [0, 0, 0, 1, 0, 0, 0, 1, 0] }]); console.log(normals.join());`;
        const run = text => execFileSync(process.execPath, ['--input-type=module', '-'], { cwd: folder, encoding: 'utf8', input: text });
        assert.equal(run(`import { loadAttributes } from './alone.mjs'; ${call}`), '0,0,1,0,0,1,0,0,1\n');
        const data = `import { readFileSync } from 'node:fs';
            const { loadAttributes } = await import('data:text/javascript;base64,' + readFileSync('alone.mjs', 'base64')); ${call}`;
        assert.equal(run(data), '0,0,1,0,0,1,0,0,1\n');
    } finally {
        await rm(folder, { recursive: true });
    }
});

test('bundlers find no address of a .wasm file in it, and the README has its size', async () => {
    const text = await readFile(file, 'utf8'), readme = await readFile(new URL('./node_modules/rakelight/README.md', import.meta.url), 'utf8');
    assert.doesNotMatch(text, /new URL\([^)]*wasm/);
    const [, plain, zipped] = /It has (\d+) kB, (\d+) kB with\s+gzip/.exec(readme);
    for (const [said, bytes] of [[plain, text.length], [zipped, gzipSync(text, { level: 9 }).length]])
        assert.ok(Math.abs(said * 1000 / bytes - 1) < 0.05, `${said} kB are ${bytes} bytes`);
});
