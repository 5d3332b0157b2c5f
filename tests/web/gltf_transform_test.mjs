// SPDX-License-Identifier: Apache-2.0
// smoothSeams() as a transform of gltf-transform: seams close, all else stays, and the numbers are those of the program.
import assert from 'node:assert/strict';
import test from 'node:test';

import { quantize } from '@gltf-transform/functions';

import { columns, cube, distance, meetings, placed, rows, sheet, sheets, vector } from './bent_sheet.mjs';
import { accessor, addTarget, allParts, closes, documentOf, equalsProgram, io, mesh, newDocument, numbers, primitive, primitiveOf, run, show, showSheet,
         unused } from './gltf_parts.mjs';

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

test('indices of 8 bits become wider where vertices are added beyond them', async () => {
    const { positions, indices } = cube(), document = newDocument(), count = 12;
    const all = Float32Array.from({ length: count * positions.length }, (_, k) => positions[k % 24] + (k % 3 === 0 ? 5 * Math.floor(k / 24) : 0));
    const corners = Uint8Array.from({ length: count * 36 }, (_, k) => indices[k % 36] + 8 * Math.floor(k / 36));
    const many = primitive(document, { POSITION: all }, corners), one = primitive(document, { POSITION: positions }, Uint8Array.from(indices));
    show(document, mesh(document, 'many', many));
    show(document, mesh(document, 'one', one), placed(0, 1, [0, 9, 0]));
    await equalsProgram(document);
    assert.ok(many.getIndices().getArray() instanceof Uint16Array);
    assert.ok(one.getIndices().getArray() instanceof Uint8Array);
});

test('a primitive without vertices is left out, and said', async () => {
    const document = documentOf(sheets()), nodes = document.getRoot().listNodes();
    nodes[0].getMesh().addPrimitive(document.createPrimitive());
    show(document, mesh(document, 'empty', document.createPrimitive().setAttribute('POSITION', document.createAccessor())));
    const { remarks } = await run(document), made = [0, 1].map(i => numbers(primitiveOf(document, i).getAttribute('NORMAL')));
    assert.deepEqual(remarks, [{ kind: 'dropped', count: 2, place: "mesh 'part 0', primitive 1", text: 'a primitive without vertices is left out' }]);
    assert.equal(nodes[0].getMesh().listPrimitives().length, 2);
    sheets().forEach((part, i) => part.border.forEach(v => assert.ok(distance(vector(made[i], v), [0, 0, 1]) < 1e-6)));
});
