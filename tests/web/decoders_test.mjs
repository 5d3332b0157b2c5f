// SPDX-License-Identifier: Apache-2.0
// Draco and meshopt: models that are compressed by the npm packages are read with the decoders of these packages.
import assert from 'node:assert/strict';
import { spawnSync } from 'node:child_process';
import { mkdtemp, rm, writeFile } from 'node:fs/promises';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import test from 'node:test';
import { fileURLToPath } from 'node:url';

import { Document, Logger, NodeIO } from '@gltf-transform/core';
import { ALL_EXTENSIONS } from '@gltf-transform/extensions';
import { draco, meshopt } from '@gltf-transform/functions';
import draco3d from 'draco3dgltf';
import { MeshoptDecoder, MeshoptEncoder } from 'meshoptimizer';
import { RakelightError, configure, inspect, render, smooth } from 'rakelight';

const dracoDecoder = await draco3d.createDecoderModule();
const logger = new Logger(Logger.Verbosity.ERROR);
const io = new NodeIO().setLogger(logger).registerExtensions(ALL_EXTENSIONS).registerDependencies({
    'draco3d.decoder': dracoDecoder, 'draco3d.encoder': await draco3d.createEncoderModule(),
    'meshopt.decoder': MeshoptDecoder, 'meshopt.encoder': MeshoptEncoder,
});

/** Two halves of a tube; at their borders the normals of each lean away from the other. */
async function tube(transform) {
    const document = new Document().setLogger(logger), buffer = document.createBuffer(), scene = document.createScene();
    const columns = 12, rows = 6;
    for (let half = 0; half < 2; ++half) {
        const positions = [], normals = [], indices = [];
        for (let i = 0; i <= columns; ++i)
            for (let j = 0; j <= rows; ++j) {
                const a = Math.PI * (half + i / columns), lean = i === 0 ? -0.2 : i === columns ? 0.2 : 0;
                positions.push(Math.cos(a), j / rows, Math.sin(a));
                normals.push(Math.cos(a + lean), 0, Math.sin(a + lean));
                const v = i * (rows + 1) + j;
                if (i < columns && j < rows) indices.push(v, v + 1, v + rows + 2, v, v + rows + 2, v + rows + 1);
            }
        const accessor = (type, array) => document.createAccessor().setType(type).setArray(array).setBuffer(buffer);
        const primitive = document.createPrimitive().setIndices(accessor('SCALAR', Uint16Array.from(indices)))
            .setAttribute('POSITION', accessor('VEC3', Float32Array.from(positions))).setAttribute('NORMAL', accessor('VEC3', Float32Array.from(normals)));
        scene.addChild(document.createNode(`half ${half}`).setMesh(document.createMesh().addPrimitive(primitive)));
    }
    await document.transform(transform);
    return io.writeBinary(document);
}

const models = { draco: await tube(draco()), meshopt: await tube(meshopt({ encoder: MeshoptEncoder })) };

for (const [name, model] of Object.entries(models))
    test(`${name}: without a decoder the message names what to install, with it the seam is found and fixed`, async () => {
        configure({});
        await assert.rejects(inspect(model), fault => fault instanceof RakelightError && fault.exitCode === 4 && fault.message.includes(name === 'draco' ? 'Draco' : 'meshopt'));
        configure({ decoders: { draco: dracoDecoder, meshopt: MeshoptDecoder } });
        assert.equal((await inspect(model, { check: true, maxSeam: 2 })).passed, false);
        const fixed = await smooth(model);
        assert.equal((await inspect(fixed.bytes, { check: true, maxSeam: 2 })).passed, true);
        assert.equal((await io.readBinary(fixed.bytes)).getRoot().listMeshes().length, 2);
        assert.ok((await render(model, { resolution: [64, 48] })).bytes.length > 100);
    });

test('broken compressed data is one line, not a crash', async () => {
    configure({ decoders: { draco: dracoDecoder, meshopt: MeshoptDecoder } });
    const before = dracoDecoder.HEAPF32.byteLength;
    for (const model of Object.values(models)) {
        const cut = model.slice(), start = 20 + new DataView(cut.buffer, cut.byteOffset).getUint32(12, true) + 8;
        cut.fill(0xa5, start + 40, start + 120);
        for (let run = 0; run < 30; ++run) await assert.rejects(inspect(cut), fault => fault instanceof RakelightError && fault.exitCode === 4);
    }
    assert.equal(dracoDecoder.HEAPF32.byteLength, before);
});

test('the program takes the decoders that npm installed', async () => {
    const folder = await mkdtemp(join(tmpdir(), 'rakelight-')), here = fileURLToPath(new URL('.', import.meta.url));
    try {
        for (const [name, model] of Object.entries(models)) {
            const file = join(folder, name + '.glb'), cli = join(here, 'node_modules/rakelight/cli.js');
            await writeFile(file, model);
            const run = cwd => spawnSync(process.execPath, [cli, 'inspect', file, '--check', '--max-seam', '2'], { cwd, encoding: 'utf8' });
            assert.equal(run(here).status, 5);
            const { status, stderr } = run(folder);
            assert.equal(status, 4);
            assert.match(stderr, /install the npm package/);
        }
    } finally {
        await rm(folder, { recursive: true });
    }
});
