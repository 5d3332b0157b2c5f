// SPDX-License-Identifier: Apache-2.0
// smoothSeams() as a transform of gltf-transform: seams close, all else stays, and the numbers are those of the program.
import assert from 'node:assert/strict';
import test from 'node:test';
import { fileURLToPath } from 'node:url';

import { EXTMeshGPUInstancing } from '@gltf-transform/extensions';
import { quantize } from '@gltf-transform/functions';
import { AttributesError, smoothSeams } from 'rakelight/scene';

import { columns, cube, distance, identity, meetings, placed, rows, sheet, vector } from './bent_sheet.mjs';
import { accessor, addTarget, allParts, assertUnchanged, closes, documentOf, equalsProgram, io, mesh, newDocument, numbers, partsOf, primitive, run, show,
         showSheet, state, unused } from './gltf_parts.mjs';

const sheets = (...options) => [sheet(0, options[0]), sheet(1, options[1] ?? options[0])];
const meshOf = (document, i) => document.getRoot().listNodes()[i].getMesh();
const primitiveOf = (document, i) => meshOf(document, i).listPrimitives()[0];

test('two parts are joined where they lie in the world, at the normals of the cylinder', async () => {
    const matrices = [placed(1, 2, [3, 1, -2]), placed(2, 0.5, [0, -4, 1])];
    const parts = [0, 1].map(i => sheet(i, { matrix: matrices[i] })), document = documentOf(parts, matrices);
    const report = await closes(document);
    assert.equal(report.seams.turned, 2 * (rows + 1));
    parts.forEach(({ normals, border }, i) => {
        const made = numbers(primitiveOf(document, i).getAttribute('NORMAL'));
        for (let v = 0; v < normals.length / 3; ++v)
            if (!border.includes(v)) assert.deepEqual(vector(made, v), vector(normals, v));
            else assert.ok(distance(vector(made, v), i === 0 ? [-1, 0, 0] : [0, 0, -1]) < 1e-6);
    });
});

test('a mesh gets a copy for a node with another neighbor, and both borders are joined', async () => {
    const far = [10, 0, 0], document = newDocument(), [left, right] = sheets();
    const first = showSheet(document, left), shared = first.getMesh(), second = show(document, shared, placed(0, 1, far));
    showSheet(document, right);
    showSheet(document, sheet(1, { lean: 0.4, at: far }));
    await closes(document, {}, { places: 2 * (rows + 1) });
    assert.equal(document.getRoot().listMeshes().length, 4);
    assert.ok(first.getMesh() === shared);
    assert.ok(second.getMesh() !== shared);
    const [ours, theirs] = [first, second].map(node => node.getMesh().listPrimitives()[0]);
    assert.ok(ours.getAttribute('NORMAL') !== theirs.getAttribute('NORMAL'));
    assert.ok(ours.getAttribute('POSITION') === theirs.getAttribute('POSITION'));
    assert.deepEqual(unused(document), []);
});

test('keepInstances keeps one mesh, and says so', async () => {
    const far = [10, 0, 0], document = newDocument(), [left, right] = sheets();
    const first = showSheet(document, left), second = show(document, first.getMesh(), placed(0, 1, far));
    showSheet(document, right);
    showSheet(document, sheet(1, { lean: 0.4, at: far }));
    const { remarks } = await run(document, { keepInstances: true });
    assert.ok(first.getMesh() === second.getMesh());
    assert.match(remarks.map(({ text }) => text).join(), /kept shared/);
});

test('an accessor of two meshes stays as it is for the one that does not change', async () => {
    const [left, right] = sheets(), document = documentOf([left, right]), [changed] = document.getRoot().listNodes();
    const { POSITION, NORMAL } = Object.fromEntries(['POSITION', 'NORMAL'].map(name => [name, primitiveOf(document, 0).getAttribute(name)]));
    const lone = primitive(document, { POSITION, NORMAL }, left.indices);
    show(document, mesh(document, 'alone', lone), placed(0, 1, [10, 0, 0]));
    await closes(document);
    assert.ok(lone.getAttribute('NORMAL') === NORMAL);
    assert.ok(lone.getAttribute('POSITION') === POSITION);
    assert.deepEqual(NORMAL.getArray(), left.normals);
    assert.ok(changed.getMesh().listPrimitives()[0].getAttribute('POSITION') === POSITION);
    assert.deepEqual(unused(document), []);
});

test('normals of two primitives of a mesh stay as they are for the one away from the border', async () => {
    const [left, right] = sheets(), document = newDocument(), NORMAL = accessor(document, left.normals.slice());
    const away = primitive(document, { POSITION: sheet(0, { at: [10, 0, 0] }).positions, NORMAL }, left.indices);
    const near = primitive(document, { POSITION: left.positions, NORMAL }, left.indices);
    show(document, mesh(document, 'both', away, near));
    showSheet(document, right);
    await closes(document);
    assert.ok(away.getAttribute('NORMAL') === NORMAL);
    assert.ok(near.getAttribute('NORMAL') !== NORMAL);
    assert.deepEqual(NORMAL.getArray(), left.normals);
    assert.deepEqual(unused(document), []);
});

test('accessors that primitives share with all that is in them stay shared', async () => {
    const [left, right] = sheets(), document = newDocument(), column = left.indices.length / columns;
    const shared = { POSITION: accessor(document, left.positions), NORMAL: accessor(document, left.normals) };
    const made = [left.indices.slice(0, column), left.indices.slice(column)].map(indices => primitive(document, shared, indices));
    show(document, mesh(document, 'pieces', ...made));
    showSheet(document, right);
    const count = document.getRoot().listAccessors().length;
    await equalsProgram(document);
    assert.ok(made[0].getAttribute('NORMAL') !== shared.NORMAL);
    assert.ok(made[0].getAttribute('NORMAL') === made[1].getAttribute('NORMAL'));
    assert.equal(document.getRoot().listAccessors().length, count);
});

test('a primitive of two meshes changes in each by itself', async () => {
    const document = newDocument(), [left, right] = sheets(), far = [10, 0, 0];
    const one = primitive(document, { POSITION: left.positions, NORMAL: left.normals }, left.indices);
    show(document, mesh(document, 'here', one));
    show(document, mesh(document, 'there', one), placed(0, 1, far));
    showSheet(document, right);
    showSheet(document, sheet(1, { lean: 0.4, at: far }));
    await closes(document, {}, { places: 2 * (rows + 1) });
    assert.deepEqual(unused(document), []);
});

test('sparse normals', async () => {
    const document = documentOf(sheets());
    for (const each of document.getRoot().listAccessors()) if (each.getType() === 'VEC3') each.setSparse(true);
    const reread = await io.readBinary(await io.writeBinary(document));
    await equalsProgram(document);
    await closes(reread);
});

for (const quantizeNormal of [8, 12])
    test(`quantized to ${quantizeNormal} bits: as the program, and the seam is closed`, async () => {
        const document = documentOf(sheets({ lean: 0.3 }));
        await document.transform(quantize({ quantizeNormal, quantizationVolume: 'scene' }));
        const parts = () => allParts(document);
        assert.ok(meetings(parts(), 1e-3).least > 0.1);
        assert.equal((await equalsProgram(document)).changed, true);
        const { places, most } = meetings(parts(), 1e-3);
        assert.equal(places, rows + 1);
        assert.ok(most < 1e-6, `${most} apart`);
    });

/** A cube with something of each kind at its vertices, and a morph target that makes it longer. */
function fullCube(document) {
    const { positions, indices } = cube(), count = positions.length / 3;
    const of = (Type, size, value) => Type.from({ length: count * size }, (_, i) => value(Math.floor(i / size), i % size));
    const owner = primitive(document, {
        POSITION: positions, TEXCOORD_0: of(Float32Array, 2, (v, c) => v + c / 2), COLOR_0: of(Uint8Array, 4, (v, c) => 20 * v + c),
        JOINTS_0: of(Uint8Array, 4, (_, c) => c), WEIGHTS_0: of(Float32Array, 4, (v, c) => (c === 0 ? 1 - v / 8 : c === 1 ? v / 8 : 0)),
        _CUSTOM: of(Float32Array, 1, v => v),
    }, indices);
    addTarget(document, owner, { POSITION: of(Float32Array, 3, (v, c) => (c === 0 ? positions[3 * v] : 0)) });
    return owner;
}

const readAll = owner => [owner, ...owner.listTargets()].flatMap((each, t) => each.listSemantics().map(name => {
    const from = each.getAttribute(name), size = from.getElementSize();
    return { key: `${t} ${name}`, count: from.getCount(), array: from.getArray(), size };
}));

test('parts without normals get some, and all attributes and targets follow the vertices that split', async () => {
    const document = newDocument(), owner = fullCube(document);
    show(document, mesh(document, 'cube', owner));
    owner.getAttribute('_CUSTOM').setName('numbers').setExtras({ unit: 'one' });
    const before = readAll(owner), corners = owner.getIndices().getArray().slice();
    assert.equal((await run(document, { tangents: 'never' })).changed, true);
    const after = readAll(owner), indices = owner.getIndices().getArray(), { positions } = cube();
    for (const { key, array, size } of before) {
        const made = after.find(each => each.key === key);
        assert.equal(made.count, 24, key);
        assert.equal(made.array.constructor, array.constructor);
        indices.forEach((v, c) => assert.deepEqual(vector(made.array, v, size), vector(array, corners[c], size), key));
    }
    assert.equal(owner.getAttribute('_CUSTOM').getName(), 'numbers');
    assert.deepEqual(owner.getAttribute('_CUSTOM').getExtras(), { unit: 'one' });
    const normals = numbers(owner.getAttribute('NORMAL'));
    for (let c = 0; c < 36; c += 3) {
        const face = [0, 1, 2].map(k => [0, 1, 2].every(i => positions[3 * corners[c + i] + k] === positions[3 * corners[c] + k]) * positions[3 * corners[c] + k]);
        for (const i of [0, 1, 2]) assert.ok(distance(vector(normals, indices[c + i]), face) < 1e-6);
    }
    assert.ok(numbers(owner.listTargets()[0].getAttribute('NORMAL')).every(x => Math.abs(x) < 1e-6));
    assert.deepEqual(unused(document), []);
});

test('strips and fans are joined as they are', async () => {
    const document = newDocument(), v = (i, j) => i * (rows + 1) + j;
    const strip = Uint16Array.from({ length: 2 * (rows + 1) }, (_, k) => v(k % 2 ? columns - 1 : columns, k >> 1));
    const fan = Uint16Array.from([v(1, rows / 2), ...Array.from({ length: rows + 1 }, (_, j) => v(0, j))]);
    const [left, right] = sheets().map((part, i) => ({ ...part, indices: i ? fan : strip }));
    const nodes = [showSheet(document, left), showSheet(document, right)];
    nodes.forEach((node, i) => node.getMesh().listPrimitives()[0].setMode(5 + i));
    await closes(document, { crease: 60 });  // 'auto' takes two flat strips for two planes
    [strip, fan].forEach((indices, i) => {
        assert.equal(primitiveOf(document, i).getMode(), 5 + i);
        assert.deepEqual(primitiveOf(document, i).getIndices().getArray(), indices);
    });
});

test('strips and fans whose vertices split become triangles', async () => {
    const document = newDocument();
    const roof = Float32Array.from([0, 0, 0, 0, 1, 0, 1, 0, 1, 1, 1, 1, 2, 0, 0, 2, 1, 0]);
    const tent = Float32Array.from([0, 2, 0, 1, 0, 1, 1, 0, -1, -1, 0, -1, -1, 0, 1, 1, 0, 1]);
    const owners = [[roof, 5], [tent, 6]].map(([POSITION, mode]) => primitive(document, { POSITION }).setMode(mode));
    owners.forEach((owner, i) => show(document, mesh(document, 'made', owner), placed(0, 1, [10 * i, 0, 0])));
    await equalsProgram(document);
    for (const owner of owners) {
        const corners = owner.getIndices().getArray(), normals = numbers(owner.getAttribute('NORMAL'));
        const positions = numbers(owner.getAttribute('POSITION')), count = owner.getAttribute('POSITION').getCount();
        assert.equal(owner.getMode(), 4);
        assert.equal(corners.length, 12);
        assert.ok(count > 6 && normals.length === 3 * count);
        for (let c = 0; c < 12; c += 3) {
            const [p, q, r] = [0, 1, 2].map(k => vector(positions, corners[c + k]));
            for (const k of [0, 1, 2]) {
                const n = vector(normals, corners[c + k]);
                for (const other of [q, r]) assert.ok(Math.abs(n.reduce((sum, x, i) => sum + x * (other[i] - p[i]), 0)) < 1e-6);
            }
        }
    }
});

/** Vertices at the border move with joint 0, others with joint 1. */
const influences = ({ positions, border }) => ({
    JOINTS_0: Uint8Array.from({ length: positions.length / 3 * 4 }, (_, k) => (k % 4 === 0 && !border.includes(k / 4) ? 1 : 0)),
    WEIGHTS_0: Float32Array.from({ length: positions.length / 3 * 4 }, (_, k) => (k % 4 === 0 ? 1 : 0)),
});

test('skinned parts are joined in the bind pose, however their nodes are posed', async () => {
    const document = newDocument(), [scene] = document.getRoot().listScenes(), matrices = [identity, placed(1, 1, [3, 0, 1])];
    const joints = [placed(3, 1, [5, 0, 0]), placed(2, 1, [0, 7, 0])].map(matrix => document.createNode('joint').setMatrix(matrix));
    for (const joint of joints) scene.addChild(joint);
    const nodes = matrices.map((matrix, i) => {
        const part = sheet(i, { matrix }), node = showSheet(document, part, placed(0, 1, [100 * i, 0, 0]));
        for (const [name, array] of Object.entries(influences(part)))
            node.getMesh().listPrimitives()[0].setAttribute(name, accessor(document, array, 'VEC4'));
        const skin = document.createSkin().setInverseBindMatrices(accessor(document, Float32Array.from([...matrix, ...matrix]), 'MAT4'));
        for (const joint of joints) skin.addJoint(joint);
        return node.setSkin(skin);
    });
    await closes(document, {}, { parts: () => nodes.flatMap((node, i) => partsOf(node, matrices[i])) });
});

test('offsets of morph targets turn with their normals: the seam is closed with weight 0 and with weight 1', async () => {
    const parts = sheets(), document = documentOf(parts), [c, s] = [Math.cos(0.3), Math.sin(0.3)];
    const offsets = array => array.map((_, k) => [c * array[k] + s * array[k + 2], array[k], c * array[k] - s * array[k - 2]][k % 3] - array[k]);
    parts.forEach(({ positions, normals }, i) => addTarget(document, primitiveOf(document, i), { POSITION: offsets(positions), NORMAL: offsets(normals) }));
    assert.ok(meetings(allParts(document, 1)).least > 0.1);
    await closes(document);
    const moved = allParts(document, 1), { places, most } = meetings(moved);
    assert.equal(places, rows + 1);
    assert.ok(most < 1e-6, `${most} apart`);
    moved.forEach(({ normals }, i) => parts[i].border.forEach(v => assert.ok(distance(vector(normals, v), [s, 0, c]) < 1e-6)));
    assert.deepEqual(unused(document), []);
});

function withTangents(names) {
    const parts = sheets(), document = newDocument();
    for (const { positions, normals, tangents, texcoords, indices } of parts) {
        const all = { POSITION: positions, NORMAL: normals, TANGENT: tangents, TEXCOORD_0: texcoords };
        show(document, mesh(document, 'part', primitive(document, Object.fromEntries(names.map(name => [name, all[name]])), indices)));
    }
    return { document, parts };
}

test('tangents turn with their normals', async () => {
    const { document, parts } = withTangents(['POSITION', 'NORMAL', 'TANGENT']);
    await closes(document);
    parts.forEach(({ tangents, border }, i) => {
        const made = numbers(primitiveOf(document, i).getAttribute('TANGENT'));
        for (let v = 0; v < tangents.length / 4; ++v)
            if (border.includes(v)) assert.ok(distance(vector(made, v, 4), [-1, 0, 0, 1]) < 1e-6);
            else assert.deepEqual(vector(made, v, 4), vector(tangents, v, 4));
    });
});

test('tangents: always makes those along the texture, never removes them', async () => {
    const always = withTangents(['POSITION', 'NORMAL', 'TEXCOORD_0']).document, never = withTangents(['POSITION', 'NORMAL', 'TANGENT']).document;
    await closes(always, { tangents: 'always' });
    for (const i of [0, 1]) {
        const normals = numbers(primitiveOf(always, i).getAttribute('NORMAL')), tangents = numbers(primitiveOf(always, i).getAttribute('TANGENT'));
        for (let v = 0; v < normals.length / 3; ++v) {
            const [x, , z] = vector(normals, v);
            assert.ok(distance(vector(tangents, v, 4), [-z, 0, x, 1]) < 1e-6);
        }
    }
    await closes(never, { tangents: 'never' });
    for (const i of [0, 1]) assert.deepEqual(primitiveOf(never, i).listSemantics().sort(), ['NORMAL', 'POSITION']);
    assert.deepEqual(unused(never), []);
});

test('only the default scene counts', async () => {
    const document = documentOf(sheets()), untouched = state(document), scene = document.createScene('second');
    document.getRoot().setDefaultScene(scene);
    const nodes = sheets().map(part => showSheet(document, part));
    for (const node of nodes) scene.addChild(node);
    for (const node of nodes) document.getRoot().listScenes()[0].removeChild(node);
    await closes(document, {}, { parts: () => nodes.flatMap(node => partsOf(node)) });
    for (const [object, array] of untouched.accessors) assert.deepEqual(object.getArray(), array);
    for (const [object, primitives] of untouched.meshes) assert.ok(object.listPrimitives().every((each, i) => each === primitives[i]));
    assert.ok(meetings([0, 1].flatMap(i => partsOf(document.getRoot().listNodes()[i]))).least > 0.1);
});

test('each instance of EXT_mesh_gpu_instancing counts where it is', async () => {
    const document = newDocument(), [left, right] = sheets(), matrices = [identity, placed(1, 2, [10, 0, 0])], half = Math.sqrt(0.5);
    const node = showSheet(document, left), neighbor = showSheet(document, right);
    show(document, neighbor.getMesh(), matrices[1]);
    node.setExtension('EXT_mesh_gpu_instancing', document.createExtension(EXTMeshGPUInstancing).createInstancedMesh()
        .setAttribute('TRANSLATION', accessor(document, Float32Array.from([0, 0, 0, 10, 0, 0])))
        .setAttribute('ROTATION', accessor(document, Float32Array.from([0, 0, 0, 1, 0, half, 0, half]), 'VEC4'))
        .setAttribute('SCALE', accessor(document, Float32Array.from([1, 1, 1, 2, 2, 2]))));
    const parts = () => matrices.flatMap(matrix => [node, neighbor].flatMap(each => partsOf(each, matrix)));
    const { remarks } = await closes(document, {}, { parts, places: 2 * (rows + 1) });
    assert.deepEqual(remarks, []);
    assert.equal(document.getRoot().listMeshes().length, 2);
});

test('what is right already does not change, and a second run changes nothing', async () => {
    const right = documentOf(sheets({ lean: 0 })), before = state(right);
    assert.equal((await run(right)).changed, false);
    assertUnchanged(right, before);
    const joined = documentOf(sheets());
    await closes(joined);
    const after = state(joined);
    assert.equal((await run(joined)).changed, false);
    assertUnchanged(joined, after);
});

test('what is wrong is said with its place, and the document stays', async () => {
    const fewer = documentOf(sheets()), outside = documentOf(sheets()), good = documentOf(sheets());
    primitiveOf(fewer, 1).getAttribute('NORMAL').setArray(new Float32Array(9));
    primitiveOf(outside, 0).getIndices().setArray(Uint16Array.of(0, 1, 35));
    const cases = [[good, { creases: 60 }, /no option "creases"/], [good, { normals: 'all' }, /normals must be face, object, model/],
        [good, { tangents: 'some' }, /tangents must be auto/], [good, { crease: 181 }, /0 to 180/], [good, { borderDistance: -1 }, /border distance/],
        [fewer, {}, /part 1', primitive 0: NORMAL has 3 elements, but the primitive has 35 vertices/],
        [outside, {}, /part 0', primitive 0: index 35 at corner 2 exceeds 35 vertices/]];
    for (const [document, options, message] of cases) {
        const before = state(document);
        await assert.rejects(document.transform(smoothSeams(options)), fault => fault instanceof AttributesError && message.test(fault.message), String(message));
        assertUnchanged(document, before);
    }
    await closes(good);
});

/** As it is written again: tiny rotations are left out. */
const readAgain = async document => io.readBinary(await io.writeBinary(await document));
const files = ['knight/Knight_noNormals.glb', 'materials/alpha.gltf', 'materials/layers.gltf', 'materials/spheres.gltf', 'spot/spot_slab5.glb',
    'visibility/near_planes.gltf'];
const rightFiles = ['materials/sides.gltf', 'motion/door.gltf'];  // quads: all normals are those of their planes
for (const file of [...files, ...rightFiles])
    test(`${file} becomes what the program makes of it`, async () => {
        const path = fileURLToPath(new URL(`../../../data/${file}`, import.meta.url));
        await equalsProgram(await readAgain(io.read(path)));
        assert.equal((await equalsProgram(await readAgain(io.read(path)), { normals: 'model' })).changed, files.includes(file));
    });
