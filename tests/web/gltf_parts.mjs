// SPDX-License-Identifier: Apache-2.0
// Documents of gltf-transform from typed arrays, what they hold, and whether two hold the same.
import assert from 'node:assert/strict';

import { Document, Logger, NodeIO } from '@gltf-transform/core';
import { ALL_EXTENSIONS } from '@gltf-transform/extensions';
import { smooth } from 'rakelight';
import { smoothSeams } from 'rakelight/scene';

import { identity, meetings } from './bent_sheet.mjs';

export const io = new NodeIO().setLogger(new Logger(Logger.Verbosity.SILENT)).registerExtensions(ALL_EXTENSIONS);

export function newDocument() {
    const document = new Document().setLogger(new Logger(Logger.Verbosity.SILENT));
    document.createBuffer();
    document.createScene('shown');
    return document;
}

const types = { TEXCOORD: 'VEC2', TANGENT: 'VEC4', COLOR: 'VEC4', JOINTS: 'VEC4', WEIGHTS: 'VEC4', _CUSTOM: 'SCALAR' };

export const accessor = (document, array, type = 'VEC3') =>
    document.createAccessor().setType(type).setArray(array).setBuffer(document.getRoot().listBuffers()[0]);

/** @param attributes  name -> typed array or accessor */
export function primitive(document, attributes, indices) {
    const made = document.createPrimitive();
    for (const [name, given] of Object.entries(attributes))
        made.setAttribute(name, ArrayBuffer.isView(given) ? accessor(document, given, types[name.replace(/_\d$/, '')]) : given);
    return indices ? made.setIndices(accessor(document, indices, 'SCALAR')) : made;
}

/** A morph target. */
export function addTarget(document, owner, attributes) {
    const target = document.createPrimitiveTarget();
    for (const [name, array] of Object.entries(attributes)) target.setAttribute(name, accessor(document, array));
    owner.addTarget(target);
}

export const mesh = (document, name, ...primitives) =>
    primitives.reduce((made, each) => made.addPrimitive(each), document.createMesh(name));

/** A node of the first scene. */
export function show(document, shown, matrix = identity) {
    const node = document.createNode(shown.getName()).setMesh(shown).setMatrix(matrix);
    document.getRoot().listScenes()[0].addChild(node);
    return node;
}

/** A part of a sheet, with normals alone, as a node of the first scene. */
export const showSheet = (document, { positions, normals, indices }, matrix, name = 'part') =>
    show(document, mesh(document, name, primitive(document, { POSITION: positions, NORMAL: normals }, indices)), matrix);

/** The document of some parts. */
export function documentOf(parts, matrices = []) {
    const document = newDocument();
    parts.forEach((part, i) => showSheet(document, part, matrices[i], `part ${i}`));
    return document;
}

export const primitiveOf = (document, node) => document.getRoot().listNodes()[node].getMesh().listPrimitives()[0];

export function numbers(from) {
    const size = from.getElementSize();
    const out = new Float32Array(from.getCount() * size);
    for (let i = 0; i < from.getCount(); ++i) out.set(from.getElement(i, []), i * size);
    return out;
}

const offset = (from, name, weight) => {
    const base = numbers(from.getAttribute(name));
    if (weight !== 0) from.listTargets().forEach(t => numbers(t.getAttribute(name)).forEach((x, i) => { base[i] += weight * x; }));
    return base;
};

/** All primitives of a node where it is, for meetings(). @param weight  of all morph targets */
export const partsOf = (node, matrix = node.getWorldMatrix(), weight = 0) => node.getMesh().listPrimitives()
    .map(each => ({ positions: offset(each, 'POSITION', weight), normals: offset(each, 'NORMAL', weight), matrix }));

export const allParts = (document, weight = 0) => document.getRoot().listNodes().filter(node => node.getMesh())
    .flatMap(node => partsOf(node, node.getWorldMatrix(), weight));

/** Runs it, between a seam that is there and one that is closed. @returns the report */
export async function closes(document, options = {}, { parts = () => allParts(document), places = 7, step } = {}) {
    const before = meetings(parts(), step);
    assert.equal(before.places, places);
    assert.ok(before.least > 0.1, `a seam of ${before.least}`);
    const report = await run(document, options);
    const after = meetings(parts(), step);
    assert.equal(after.places, places);
    assert.ok(after.most < 1e-6, `${after.most} apart`);
    assert.equal(report.changed, true);
    return report;
}

export async function run(document, options = {}) {
    let report;
    await document.transform(smoothSeams({ ...options, onReport(given) { report = given; } }));
    return report;
}

const content = from => from && {
    type: from.getType(), componentType: from.getComponentType(), isNormalized: from.getNormalized(), array: from.getArray(),
};
const attributesOf = owner => Object.fromEntries(owner.listSemantics().sort().map(name => [name, content(owner.getAttribute(name))]));
const contentOf = each => ({
    mode: each.getMode(), indices: content(each.getIndices()), material: each.getMaterial()?.getName(),
    attributes: attributesOf(each), targets: each.listTargets().map(attributesOf),
});

/** All that nodes show. */
export const shown = document => document.getRoot().listNodes().map(node => ({
    name: node.getName(), matrix: node.getMatrix(), primitives: node.getMesh()?.listPrimitives().map(contentOf),
}));

/** The arrays as they are, and which objects hold them. */
export const state = document => ({
    accessors: document.getRoot().listAccessors().map(each => [each, each.getArray().slice()]),
    meshes: document.getRoot().listMeshes().map(each => [each, each.listPrimitives()]),
});

export function assertUnchanged(document, before) {
    const after = state(document);
    for (const kind of ['accessors', 'meshes']) {
        assert.equal(after[kind].length, before[kind].length);
        after[kind].forEach(([object], i) => assert.ok(object === before[kind][i][0]));
        assert.deepEqual(after[kind].map(([, held]) => held), before[kind].map(([, held]) => held));
    }
}

export const unused = document => document.getRoot().listAccessors()
    .filter(each => each.listParents().every(parent => parent.propertyType === 'Root' || parent.propertyType === 'Buffer'));

/** The document becomes what the program makes of its file, in all arrays. */
export async function equalsProgram(document, options = {}) {
    const bytes = await io.writeBinary(document);
    const expected = await io.readBinary((await smooth(bytes, options)).bytes);
    const idle = unused(document), report = await run(document, options);
    assert.deepEqual(shown(document), shown(expected));
    assert.ok(unused(document).every(each => idle.includes(each)));
    return report;
}
