// SPDX-License-Identifier: Apache-2.0
// The package's functions of bytes, and its program, on models of data/.
import assert from 'node:assert/strict';
import { spawnSync } from 'node:child_process';
import { mkdtemp, readFile, rm, writeFile } from 'node:fs/promises';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import test from 'node:test';
import { fileURLToPath } from 'node:url';

import { RakelightError, compare, configure, explain, inspect, render, smooth } from 'rakelight';

const cli = fileURLToPath(new URL('./node_modules/rakelight/cli.js', import.meta.url));

/** Two halves of a bent sheet as two objects, each smooth in itself: there is a seam between them. */
const sheet = name => {
    const lines = ['# two parts'];
    const rows = 6;
    for (let part = 0; part < 2; ++part) {
        lines.push(`o part${part}`);
        for (let i = 0; i <= 4; ++i)
            for (let j = 0; j <= rows; ++j) {
                const a = (part * 4 + i) / 8 * Math.PI;
                lines.push(`v ${Math.cos(a).toFixed(6)} ${(j / rows).toFixed(6)} ${Math.sin(a).toFixed(6)}`);
            }
        // The normals of each part lean away at its border.
        for (let i = 0; i <= 4; ++i) {
            const a = (part * 4 + i) / 8 * Math.PI + (part ? 1 : -1) * (i === (part ? 0 : 4) ? 0.15 : 0);
            lines.push(`vn ${Math.cos(a).toFixed(6)} 0 ${Math.sin(a).toFixed(6)}`);
        }
        const v = (i, j) => part * 5 * (rows + 1) + i * (rows + 1) + j + 1, n = i => part * 5 + i + 1;
        for (let i = 0; i < 4; ++i)
            for (let j = 0; j < rows; ++j)
                lines.push(`f ${v(i, j)}//${n(i)} ${v(i, j + 1)}//${n(i)} ${v(i + 1, j + 1)}//${n(i + 1)} ${v(i + 1, j)}//${n(i + 1)}`);
    }
    return { name, bytes: new TextEncoder().encode(lines.join('\n') + '\n') };
};

test('a seam is found, fixed, and then not found', async () => {
    const model = sheet('sheet.obj');
    const before = await inspect(model, { check: true, maxSeam: 2 });
    assert.equal(before.passed, false);
    assert.equal(before.schema, 'rakelight.inspect/1');
    const fixed = await smooth(model);
    assert.match(fixed.report.schema, /^rakelight.smooth\//);
    assert.equal((await inspect({ name: 'fixed.obj', bytes: fixed.bytes, files: fixed.files }, { check: true, maxSeam: 2 })).passed, true);
    const glb = await smooth(model, { format: 'glb' });
    assert.equal((await inspect(glb.bytes, { check: true, maxSeam: 2 })).passed, true);
});

test('pictures are compared, and a pixel is explained', async () => {
    const model = sheet('sheet.obj'), picture = await render(model, { resolution: [160, 120] });
    assert.deepEqual([...picture.bytes.subarray(0, 4)], [0x89, 0x50, 0x4e, 0x47]);
    assert.equal((await compare(picture.bytes, picture.bytes, { maxError: 0 })).passed, true);
    const other = await render(model, { resolution: [160, 120], normals: 'flat' });
    assert.equal((await compare(picture.bytes, other.bytes, { maxError: 0 })).passed, false);
    const { schema } = await explain(model, { resolution: [160, 120], pixel: [80, 60] });
    assert.match(schema, /^rakelight.explain\//);
});

test('each option of the types is one of the program', async () => {
    const types = await readFile(new URL('./node_modules/rakelight/program_options.d.ts', import.meta.url), 'utf8');
    for (const [command, use] of [['Inspect', inspect], ['Smooth', smooth]]) {
        const [, body] = new RegExp(`interface ${command}Options {\n(.*?)\n}`, 's').exec(types), names = [...body.matchAll(/^    (\w+)\?: (?!string)/gm)];
        assert.ok(names.length > 15);
        for (const [, name] of names)
            await use(sheet('sheet.obj'), { [name]: 'none' }).catch(fault => assert.doesNotMatch(fault.message, /unknown option/));
    }
});

test('errors are those of the program', async () => {
    await assert.rejects(inspect(new Uint8Array([103, 108, 84, 70, 2, 0, 0, 0])), fault => fault instanceof RakelightError && fault.exitCode === 4);
    await assert.rejects(render(sheet('sheet.obj'), { resolution: 'large' }), fault => fault.exitCode === 2 && /resolution/.test(fault.message));
    await assert.rejects(smooth(sheet('sheet.obj'), { format: 'foo' }), fault => fault.exitCode === 2);
    await assert.rejects(inspect(new Uint8Array([1, 2, 3])), /name/);
    await assert.rejects(inspect({ name: 'a.glb', bytes: new Uint8Array(12) }), fault => /^a.glb: /.test(fault.message) && fault.file === 'a.glb' && fault.code === 'bad_file');
    await assert.rejects(inspect({ name: 'a.fbx', bytes: new Uint8Array([1, 2, 3]) }), fault => fault.exitCode === 4);
});

test('files in folders below come back with the model, and those of the input do not', async () => {
    const { bytes } = await smooth(sheet('sheet.obj'), { format: 'gltf' }), { files } = await smooth(sheet('sheet.obj'), { format: 'gltf' });
    const json = JSON.parse(new TextDecoder().decode(bytes)), buffer = files[json.buffers[0].uri];
    json.buffers[0].uri = 'data/b.bin';
    json.images = [{ uri: 'textures/a.png' }];
    const picture = (await render(sheet('sheet.obj'), { resolution: [8, 8] })).bytes;
    const model = { name: 'out/model.gltf', bytes: new TextEncoder().encode(JSON.stringify(json)), files: { 'out/data/b.bin': buffer, 'out/textures/a.png': picture, 'out/other.txt': new Uint8Array(1) } };
    const again = await smooth(model, { normals: 'model', creaseAngle: 20 });
    assert.deepEqual(again.files['textures/a.png'], picture);
    assert.equal('other.txt' in again.files, false);
    const uris = JSON.parse(new TextDecoder().decode(again.bytes)).buffers.map(({ uri }) => uri);
    for (const uri of uris) assert.ok(again.files[uri], uri);
});

test('what is no model is refused with what to pass', async () => {
    const cases = [['robot.glb', /is a name, not bytes; pass await readFile/], [undefined, /the model is missing/], [null, /the model is missing/],
        [Promise.resolve(), /await promises/], [new Blob([]), /blob.arrayBuffer/], [{ name: 'a.glb' }, /the model is missing/],
        [{ name: 'a.glb', bytes: 'text' }, /a.glb: its bytes are neither/], [new Uint8Array(0), /has no bytes/],
        [{ ...sheet('../sheet.obj') }, /is not a name below/], [sheet('builtin:sphere'), /is not a name below/], [sheet('-'), /is not a name below/], [sheet('a/'), /is not a name below/],
        [{ ...sheet('a.obj'), files: { 'a.obj/b': new Uint8Array(1) } }, /cannot be a file beside/], [{ ...sheet('/sheet.obj') }, /is not a name below/],
        [{ ...sheet('sheet.obj'), files: { '../x.mtl': new Uint8Array(1) } }, /is not a name below/]];
    for (const [model, message] of cases)
        await assert.rejects(inspect(model), fault => fault instanceof RakelightError && fault.exitCode === 2 && message.test(fault.message), String(message));
    assert.ok((await inspect(sheet('sheet.obj'), null)).passed);
    await assert.rejects(inspect(sheet('sheet.obj'), { maxSeams: 2 }), { message: /^unknown option 'maxSeams'; did you mean maxSeam\?$/ });
    await assert.rejects(inspect(sheet('sheet.obj'), { help: true }), /help is not an option here/);
    await assert.rejects(render(sheet('sheet.obj'), { format: '../x.png' }), /is no format/);
    for (const options of [{ decoder: {} }, { decoders: { dracos: {} } }, { decoders: { draco: Promise.resolve() } }, { decoders: { meshopt: {} } }, { locateFile: '/x' }])
        assert.throws(() => configure(options), RakelightError);
});

test('the program reads and writes files here, and ends with its codes', async () => {
    const folder = await mkdtemp(join(tmpdir(), 'rakelight '));
    const run = (...words) => spawnSync(process.execPath, [cli, ...words], { cwd: folder, encoding: 'utf8' });
    try {
        const model = sheet('sheet.obj');
        await writeFile(join(folder, model.name), model.bytes);
        assert.equal(run('inspect', 'sheet.obj', '--check', '--max-seam', '2').status, 5);
        assert.equal(run('smooth', 'sheet.obj', '-o', 'fixed.obj').status, 0);
        assert.equal(run('inspect', join(folder, 'fixed.obj'), '--check', '--max-seam', '2').status, 0);
        assert.deepEqual(new Uint8Array(await readFile(join(folder, 'fixed.obj'))), (await smooth(model)).bytes);
        for (const place of ['/proc/rakelight.glb', '/dev/null/rakelight.glb']) {
            const lost = run('smooth', 'sheet.obj', '-o', place);
            assert.notEqual(lost.status, 0);
            assert.match(lost.stderr, /rakelight: error: /);
        }
        const missing = run('inspect', 'none.obj');
        assert.equal(missing.status, 3);
        assert.match(missing.stderr, /^rakelight: error: none.obj: /);
        assert.equal(run('inspect', '--wrong').status, 2);
        assert.match(run('--version').stdout, /^rakelight \d/);
    } finally {
        await rm(folder, { recursive: true });
    }
});

test('what the program would end with is not the exit code of the caller', () => {
    const text = "import { inspect } from 'rakelight'; await inspect(new Uint8Array([103, 108, 84, 70])).catch(() => {});";
    assert.equal(spawnSync(process.execPath, ['--input-type=module', '-e', text], { cwd: fileURLToPath(new URL('.', import.meta.url)) }).status, 0);
});
