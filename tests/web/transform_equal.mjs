// SPDX-License-Identifier: Apache-2.0
// smoothSeams() of documents beside `rakelight smooth` of their files: every array of what is shown is the same to the bit. The library
// checks less of a file than the program does; on broken files that it reads, smoothSeams() works or says what is wrong.
//
//     transform_equal.mjs NATIVE FOLDER...   all .glb and .gltf files below
import { execFileSync } from 'node:child_process';
import { mkdtempSync, readdirSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';

import { Logger, NodeIO } from '@gltf-transform/core';
import { ALL_EXTENSIONS } from '@gltf-transform/extensions';
import { AttributesError, smoothSeams } from 'rakelight/scene';

const [native, ...folders] = process.argv.slice(2);
const io = new NodeIO().setLogger(new Logger(Logger.Verbosity.SILENT)).registerExtensions(ALL_EXTENSIONS);
const ways = [
    [{}, []],
    [{ normals: 'model' }, ['--normals', 'model']],
    [{ normals: 'object', crease: 40, weight: 'area', keepInstances: true }, ['--normals', 'object', '--crease-angle', '40', '--weight', 'area', '--keep-instances']],
    [{ tangents: 'always', borderDistance: 0.01 }, ['--tangents', 'always', '--border-distance', '0.01']],
];
/** Their nodes have matrices, which the library takes apart: the last bits of the places are others, or, of a matrix without inverse, all. */
const tolerances = { 'OrientationTest.glb': 1e-15, 'matrix_singular.gltf': 2 };

const endless = ['texture_dev_zero.gltf'];  // the library reads a device for ever

function* files(folder) {
    for (const entry of readdirSync(folder, { withFileTypes: true })) {
        const path = join(folder, entry.name);
        if (entry.isDirectory()) yield* files(path);
        else if (/\.(glb|gltf)$/i.test(entry.name) && !endless.includes(entry.name)) yield path;
    }
}

function shown(document) {
    const nodes = [], scene = document.getRoot().getDefaultScene() ?? document.getRoot().listScenes()[0];
    const roots = scene?.listChildren() ?? document.getRoot().listNodes().filter(node => !node.getParentNode());
    for (const stack = [...roots].reverse(); stack.length > 0;) {
        nodes.push(stack.pop());
        stack.push(...nodes.at(-1).listChildren().reverse());
    }
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

/** @returns the document after the transform; undefined: the library does not read it, or it was refused by an error of the input */
async function smoothed(path, options) {
    let document;
    try {
        document = await io.read(path);
    } catch {
        return undefined;
    }
    try {
        await document.transform(smoothSeams(options));
        return document;
    } catch (fault) {
        if (fault instanceof AttributesError) return undefined;
        throw fault;
    }
}

function isAccepted(path, target, words) {
    try {
        execFileSync(native, ['smooth', path, '-o', target, '--quiet', ...words], { stdio: 'pipe' });
        return true;
    } catch {
        return false;
    }
}

const out = mkdtempSync(join(tmpdir(), 'rakelight-'));
const counts = { equal: 0, wrong: 0, 'refused by both': 0, 'only the program takes': 0, 'only smoothSeams() takes': 0 };

/** @returns which of the counts it is, and what to say */
async function outcome(path, options, words) {
    const target = join(out, path.endsWith('.gltf') ? 'out.gltf' : 'out.glb'), isRight = isAccepted(path, target, words);
    const document = await smoothed(path, options);
    if (!document) return [isRight ? 'only the program takes' : 'refused by both'];
    if (!isRight) return ['only smoothSeams() takes'];
    const found = differences(document, await io.read(target), tolerances[path.split('/').pop()] ?? 0);
    return found.length ? ['wrong', `${found.length} differ: ${found[0]}`] : ['equal'];
}

for (const path of folders.flatMap(folder => [...files(folder)].sort()))
    for (const [options, words] of ways) {
        const [kind, text] = await outcome(path, options, words).catch(fault => ['wrong', fault.stack]);
        ++counts[kind];
        if (text) console.log(`${path} ${words.join(' ')}: ${text}`);
    }
rmSync(out, { recursive: true });
console.log('transforms: ' + Object.entries(counts).map(([kind, count]) => `${kind} ${count}`).join(', '));
process.exitCode = counts.wrong > 0 || counts.equal === 0 ? 1 : 0;
