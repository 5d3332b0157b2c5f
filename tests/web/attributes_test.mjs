// SPDX-License-Identifier: Apache-2.0
// rakelight/attributes beside closed forms: parts of a sphere, a cube, parts that meet, and what is wrong.
import assert from 'node:assert/strict';
import test from 'node:test';

import { AttributesError, loadAttributes } from 'rakelight/attributes';

const attributes = await loadAttributes();

/** A strip of a unit sphere between two longitudes, moved: its matrix moves it back. */
function strip(from, to, columns, rows, move) {
    const positions = [], indices = [], texcoords = [];
    for (let row = 0; row <= rows; ++row)
        for (let column = 0; column <= columns; ++column) {
            const a = from + (to - from) * column / columns, b = Math.PI * (0.2 + 0.6 * row / rows);
            positions.push(Math.sin(b) * Math.cos(a) - move, Math.cos(b), -Math.sin(b) * Math.sin(a));
            texcoords.push(a / (2 * Math.PI), row / rows);
        }
    const at = (row, column) => row * (columns + 1) + column;
    for (let row = 0; row < rows; ++row)
        for (let column = 0; column < columns; ++column)
            indices.push(at(row, column), at(row + 1, column), at(row + 1, column + 1), at(row, column), at(row + 1, column + 1), at(row, column + 1));
    return { positions: Float32Array.from(positions), indices: Uint32Array.from(indices), texcoords: Float32Array.from(texcoords),
             matrix: [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, move, 0, 0, 1], columns, rows };
}

const halves = () => [strip(0, Math.PI, 16, 12, 0.5), strip(Math.PI, 2 * Math.PI, 16, 12, -0.25)];
const vector = (array, i) => [array[3 * i], array[3 * i + 1], array[3 * i + 2]];

function degreesBetween(a, b) {
    const dot = a.reduce((sum, x, i) => sum + x * b[i], 0);
    return Math.acos(Math.min(1, Math.max(-1, dot / Math.hypot(...a) / Math.hypot(...b)))) * 180 / Math.PI;
}

test('normals of two parts of a sphere point away from its center, and agree where the parts meet', () => {
    const parts = halves(), made = attributes.computeAttributes(parts);
    made.forEach(({ normals, tangents, indices, sourceVertices }, p) => {
        const { positions, matrix } = parts[p];
        assert.equal(normals.length, positions.length);
        assert.equal(tangents.length, positions.length / 3 * 4);
        assert.deepEqual(indices, parts[p].indices);
        assert.equal(sourceVertices.length, 0);
        for (let v = 0; v < positions.length / 3; ++v) {
            const [x, y, z] = vector(positions, v);
            assert.ok(degreesBetween(vector(normals, v), [x + matrix[12], y, z]) < 2.5);
        }
    });
    const { columns, rows } = parts[0], row = columns + 1;
    for (let r = 0; r <= rows; ++r) {
        assert.deepEqual(vector(made[0].normals, r * row + columns), vector(made[1].normals, r * row));
        assert.deepEqual(vector(made[0].normals, r * row), vector(made[1].normals, r * row + columns));
    }
});

test('the scope object leaves the seam', () => {
    const made = attributes.computeAttributes(halves(), { scope: 'object', weight: 'angle' });
    assert.ok(degreesBetween(vector(made[0].normals, 6 * 17 + 16), vector(made[1].normals, 6 * 17)) > 1);
});

test('a cube that shares vertices gets 24 of them, and one of smoothing group 1 keeps 8', () => {
    const positions = [];
    for (const z of [-1, 1]) for (const y of [-1, 1]) for (const x of [-1, 1]) positions.push(x, y, z);
    const quads = [[0, 2, 3, 1], [4, 5, 7, 6], [0, 1, 5, 4], [2, 6, 7, 3], [0, 4, 6, 2], [1, 3, 7, 5]];
    const indices = quads.flatMap(([a, b, c, d]) => [a, b, c, a, c, d]);
    const [hard] = attributes.computeAttributes([{ positions, indices }]);
    assert.equal(hard.normals.length / 3, 24);
    assert.deepEqual([...hard.sourceVertices].length, 16);
    hard.indices.forEach((v, i) => assert.equal(v < 8 ? v : hard.sourceVertices[v - 8], indices[i]));
    const [soft] = attributes.computeAttributes([{ positions, indices, smoothingGroups: Array(12).fill(1) }]);
    assert.equal(soft.normals.length / 3, 8);
    assert.ok(degreesBetween(vector(soft.normals, 7), [1, 1, 1]) < 1e-3);
});

test('authored normals are joined where parts meet, and all others keep their bits', () => {
    const parts = halves(), made = attributes.computeAttributes(parts, { scope: 'object', weight: 'angle' });
    parts.forEach((part, p) => { part.normals = made[p].normals; });
    const { parts: joined, report } = attributes.joinSeams(parts);
    assert.equal(joined[0].vertices.length, 2 * 13);
    assert.equal(report.turned, 4 * 13);
    assert.equal(report.normals, 2 * 17 * 13);
    assert.ok(report.largestDegrees > 0.5 && report.largestDegrees < 10);
    const normalOf = (p, v) => vector(joined[p].normals, joined[p].vertices.indexOf(v));
    assert.deepEqual(normalOf(0, 16), normalOf(1, 0));
});

test('parts without indices, of no triangles, and no parts', () => {
    const [made] = attributes.computeAttributes([{ positions: [0, 0, 0, 1, 0, 0, 0, 1, 0] }]);
    assert.deepEqual([...made.normals], [0, 0, 1, 0, 0, 1, 0, 0, 1]);
    assert.deepEqual([...made.indices], [0, 1, 2]);
    assert.deepEqual([...attributes.computeAttributes([{ positions: [1, 2, 3], indices: [] }])[0].normals], [0, 0, 1]);
    assert.deepEqual(attributes.computeAttributes([]), []);
});

test('what is wrong is said with its place', () => {
    const part = { positions: [0, 0, 0, 1, 0, 0, 0, 1, 0] };
    const cases = [[[{ ...part, indices: [0, 1, 3] }], {}, /3/], [[{ ...part, indices: [0, 1] }], {}, /part 0: indices/],
        [[part, { positions: [1, 2] }], {}, /part 1: positions/], [[{ ...part, normals: [0, 0, 1] }], {}, /3 positions, but 1 normals/],
        [[{ ...part, matrix: [1, 2] }], {}, /matrix/], [[part], { scope: 'all' }, /scope must be face, object, model/],
        [[part], { crease: 200 }, /0 to 180/], [[{ ...part, matrix: Array(16).fill(NaN) }], {}, /matrix/]];
    for (const [parts, options, message] of cases)
        assert.throws(() => attributes.computeAttributes(parts, options), fault => fault instanceof AttributesError && message.test(fault.message), String(message));
});
