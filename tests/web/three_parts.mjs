// SPDX-License-Identifier: Apache-2.0
// Scenes of three.js from typed arrays, and where their parts meet.
import assert from 'node:assert/strict';

import { smoothSeams } from 'rakelight/scene';
import * as THREE from 'three';

import { identity, meetings, rows } from './bent_sheet.mjs';

export const attribute = (array, size = 3, isNormalized = false) => new THREE.BufferAttribute(array, size, isNormalized);

export function geometryOf({ positions, normals, indices }) {
    const geometry = new THREE.BufferGeometry().setAttribute('position', attribute(positions.slice()));
    if (normals) geometry.setAttribute('normal', attribute(normals.slice()));
    return geometry.setIndex(attribute(indices.slice(), 1));
}

export function place(object, matrix) {
    object.matrix.fromArray(matrix);
    object.matrixAutoUpdate = false;
    return object;
}

export const meshOf = (geometry, matrix = identity) => place(new THREE.Mesh(geometry), matrix);

/** A scene of sheets. @param change  of the geometries */
export function sceneOf(parts, { change = geometry => geometry, matrices = [] } = {}) {
    const scene = new THREE.Scene();
    parts.forEach((part, i) => scene.add(meshOf(change(geometryOf(part), part, i), matrices[i])));
    return scene;
}

const numbersOf = ({ count }, get) => Float32Array.from({ length: 3 * count }, (_, i) => get(Math.floor(i / 3), i % 3));
const getters = ['getX', 'getY', 'getZ'];

/** Numbers as shaders see them. @param weight  of morph target 0 */
function values(geometry, name, weight = 0) {
    const base = geometry.attributes[name], target = geometry.morphAttributes[name]?.[0], rest = geometry.morphTargetsRelative ? 1 : 1 - weight;
    return numbersOf(base, (v, c) => rest * base[getters[c]](v) + (weight && weight * target[getters[c]](v)));
}

export const partOf = (mesh, matrix = mesh.matrixWorld.elements, weight = 0) =>
    ({ positions: values(mesh.geometry, 'position', weight), normals: values(mesh.geometry, 'normal', weight), matrix: [...matrix] });

export function partsOf(object, weight = 0) {
    object.updateWorldMatrix(true, true);
    const parts = [];
    object.traverse(each => { if (each.isMesh) parts.push(partOf(each, undefined, weight)); });
    return parts;
}

/** Runs it, between a seam that is there and one that is closed. */
export async function closes(object, options = {}, { parts = () => partsOf(object), places = rows + 1 } = {}) {
    const before = meetings(parts());
    assert.equal(before.places, places);
    assert.ok(before.least > 0.1, `a seam of ${before.least}`);
    const report = await smoothSeams(object, options), after = meetings(parts());
    assert.equal(after.places, places);
    assert.ok(after.most < 1e-6, `${after.most} apart`);
    assert.equal(report.changed, true);
    return report;
}

export const geometriesOf = object => object.children.map(child => child.geometry);
