// SPDX-License-Identifier: Apache-2.0
// smoothSeams() of documents beside `rakelight smooth` of their files: every array of what is shown is the same to the bit.
//
//     transform_equal.mjs NATIVE FOLDER...   all .glb and .gltf files below
import { execFileSync } from 'node:child_process';
import { mkdtempSync, readdirSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';

import { Logger, NodeIO } from '@gltf-transform/core';
import { ALL_EXTENSIONS } from '@gltf-transform/extensions';
import { smoothSeams } from 'rakelight/scene';

const [native, ...folders] = process.argv.slice(2);
const io = new NodeIO().setLogger(new Logger(Logger.Verbosity.SILENT)).registerExtensions(ALL_EXTENSIONS);
const ways = [
    [{}, []],
    [{ normals: 'model' }, ['--normals', 'model']],
    [{ normals: 'object', crease: 40, weight: 'area', keepInstances: true }, ['--normals', 'object', '--crease-angle', '40', '--weight', 'area', '--keep-instances']],
    [{ tangents: 'always', borderDistance: 0.01 }, ['--tangents', 'always', '--border-distance', '0.01']],
];
/** Their nodes have matrices, which the library takes apart: the last bits of the places are others. */
const tolerances = { 'OrientationTest.glb': 1e-15 };

function* files(folder) {
    for (const entry of readdirSync(folder, { withFileTypes: true })) {
        const path = join(folder, entry.name);
        if (entry.isDirectory()) yield* files(path);
        else if (/\.(glb|gltf)$/i.test(entry.name)) yield path;
    }
}

function shown(document) {
    const nodes = [], scene = document.getRoot().getDefaultScene() ?? document.getRoot().listScenes()[0];
    scene.traverse(node => nodes.push(node));
    return nodes;
}

/** What differs between two accessors, or undefined. */
function difference(a, b, tolerance) {
    const [x, y] = [a?.getArray(), b?.getArray()];
    if (!x && !y) return undefined;
    if (!x || !y || x.constructor !== y.constructor || x.length !== y.length) return `${x?.length} numbers, not ${y?.length}`;
    const at = x.findIndex((value, i) => value !== y[i] && !(Math.abs(value - y[i]) <= tolerance) && !Object.is(value, y[i]));
    return at < 0 ? undefined : `number ${at} is ${x[at]}, not ${y[at]}`;
}

function differences(document, other, tolerance) {
    const found = [], nodes = shown(document), others = shown(other);
    const meshes = list => new Set(list.map(node => node.getMesh())).size;
    if (nodes.length !== others.length || meshes(nodes) !== meshes(others)) return ['other nodes or meshes'];
    nodes.forEach((node, n) => node.getMesh()?.listPrimitives().forEach((primitive, p) => {
        const wanted = others[n].getMesh().listPrimitives()[p], place = `node ${n}, primitive ${p}: `;
        if (primitive.getMode() !== wanted.getMode()) found.push(place + 'mode');
        const owners = [[primitive, wanted], ...primitive.listTargets().map((target, t) => [target, wanted.listTargets()[t]])];
        const pairs = [['indices', primitive.getIndices(), wanted.getIndices()],
            ...owners.flatMap(([a, b]) => [...new Set([...a.listSemantics(), ...b.listSemantics()])].map(name => [name, a.getAttribute(name), b.getAttribute(name)]))];
        for (const [name, a, b] of pairs) {
            const text = difference(a, b, tolerance);
            if (text) found.push(place + name + ': ' + text);
        }
    }));
    return found;
}

const out = mkdtempSync(join(tmpdir(), 'rakelight-'));
let equal = 0, wrong = 0, refused = 0;
for (const path of folders.flatMap(folder => [...files(folder)].sort()))
    for (const [options, words] of ways) {
        const target = join(out, path.endsWith('.gltf') ? 'out.gltf' : 'out.glb');
        try {
            execFileSync(native, ['smooth', path, '-o', target, '--quiet', ...words], { stdio: 'pipe' });
        } catch {
            ++refused;
            continue;
        }
        const document = await io.read(path);
        await document.transform(smoothSeams(options));
        const found = differences(document, await io.read(target), tolerances[path.split('/').pop()] ?? 0);
        if (found.length) console.log(`${path} ${words.join(' ')}: ${found.length} differ: ${found[0]}`);
        found.length ? ++wrong : ++equal;
    }
rmSync(out, { recursive: true });
console.log(`transforms equal ${equal}, wrong ${wrong}, refused by the program ${refused}`);
process.exitCode = wrong > 0 || equal === 0 ? 1 : 0;
