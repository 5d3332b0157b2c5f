// SPDX-License-Identifier: Apache-2.0
// smoothSeams() over what a document of gltf-transform says beside its arrays: skins, targets, textures, scenes, instances; and files of data/.
import assert from 'node:assert/strict';
import test from 'node:test';
import { fileURLToPath } from 'node:url';

import { EXTMeshGPUInstancing, KHRTextureTransform } from '@gltf-transform/extensions';
import { AttributesError, smoothSeams } from 'rakelight/scene';

import { distance, identity, meetings, placed, rows, sheet, sheets, vector } from './bent_sheet.mjs';
import { accessor, addTarget, allParts, assertUnchanged, closes, documentOf, equalsProgram, io, mesh, newDocument, numbers, partsOf, primitive, primitiveOf,
         run, show, showSheet, state, unused } from './gltf_parts.mjs';

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

const turn = 0.3, [c, s] = [Math.cos(turn), Math.sin(turn)];
/** How far vectors move that turn around y. */
const offsets = array => array.map((_, k) => [c * array[k] + s * array[k + 2], array[k], c * array[k] - s * array[k - 2]][k % 3] - array[k]);
const addTurned = (document, owner, { positions, normals }) => addTarget(document, owner, { POSITION: offsets(positions), NORMAL: offsets(normals) });

test('offsets of morph targets turn with their normals: the seam is closed with weight 0 and with weight 1', async () => {
    const parts = sheets(), document = documentOf(parts);
    parts.forEach((part, i) => addTurned(document, primitiveOf(document, i), part));
    assert.ok(meetings(allParts(document, 1)).least > 0.1);
    await closes(document);
    const moved = allParts(document, 1), { places, most } = meetings(moved);
    assert.equal(places, rows + 1);
    assert.ok(most < 1e-6, `${most} apart`);
    moved.forEach(({ normals }, i) => parts[i].border.forEach(v => assert.ok(distance(vector(normals, v), [s, 0, c]) < 1e-6)));
    assert.deepEqual(unused(document), []);
});

test('a copy of a mesh for another neighbor has targets of its own', async () => {
    const document = newDocument(), [left, right] = sheets(), other = sheet(1, { lean: 0.4 }), far = placed(0, 1, [0, 10, 0]);
    const nodes = [showSheet(document, left), showSheet(document, right), showSheet(document, other, far)];
    nodes.forEach((node, i) => addTurned(document, node.getMesh().listPrimitives()[0], [left, right, other][i]));
    show(document, nodes[0].getMesh(), far);
    await closes(document, {}, { places: 2 * (rows + 1) });
    const { places, most } = meetings(allParts(document, 1));
    assert.equal(places, 2 * (rows + 1));
    assert.ok(most < 1e-6, `${most} apart`);
    assert.deepEqual(unused(document), []);
});

test('morph targets of one name belong together, whatever their order', async () => {
    const parts = sheets(), document = documentOf(parts);
    const stretched = { wide: [1, 0, 0], deep: [0, 0, 1] }, names = [['wide', 'deep'], ['deep', 'wide']];
    parts.forEach(({ positions }, i) => {
        for (const name of names[i]) addTarget(document, primitiveOf(document, i), { POSITION: positions.map((x, k) => x * stretched[name][k % 3]) });
        primitiveOf(document, i).setAttribute('NORMAL', null);
        document.getRoot().listNodes()[i].getMesh().setExtras({ targetNames: names[i] });
    });
    await run(document, { normals: 'model' });
    const normalsOf = (i, name) => numbers(primitiveOf(document, i).listTargets()[names[i].indexOf(name)].getAttribute('NORMAL'));
    for (const name of ['wide', 'deep'])
        parts[0].border.forEach((v, j) => assert.ok(distance(vector(normalsOf(0, name), v), vector(normalsOf(1, name), parts[1].border[j])) < 1e-6));
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

const picture = Buffer.from('iVBORw0KGgoAAAANSUhEUgAAAAEAAAABCAYAAAAfFcSJAAAADUlEQVR42mNkYPj/HwADBwIAMCbHYQAAAABJRU5ErkJggg==', 'base64');

test('tangents belong to the coordinates of the normal texture, and to how it lies on them', async () => {
    for (const change of [info => info.setTexCoord(1), (info, transform) => info.setExtension('KHR_texture_transform', transform.setTexCoord(1)),
        (info, transform) => info.setExtension('KHR_texture_transform', transform.setRotation(-Math.PI / 2))]) {
        const document = newDocument(), { positions, normals, texcoords, indices } = sheet(0);
        const transform = document.createExtension(KHRTextureTransform).createTransform();
        const other = texcoords.map((_, k) => texcoords[k % 2 ? k - 1 : k + 1] * (k % 2 ? -1 : 1));
        const owner = primitive(document, { POSITION: positions, NORMAL: normals, TEXCOORD_0: texcoords, TEXCOORD_1: other }, indices);
        owner.setMaterial(document.createMaterial().setNormalTexture(document.createTexture().setImage(picture).setMimeType('image/png')));
        change(owner.getMaterial().getNormalTextureInfo(), transform);
        show(document, mesh(document, 'part', owner));
        await equalsProgram(document, { tangents: 'always' });
        const tangents = numbers(owner.getAttribute('TANGENT'));
        for (let v = 0; v < normals.length / 3; ++v) assert.ok(Math.abs(tangents[4 * v + 1]) > 0.9999);
    }
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
    const apart = documentOf(sheets()), skin = apart.createSkin('arm').addJoint(apart.createNode('elsewhere'));
    apart.getRoot().listNodes()[0].setSkin(skin);
    const cases = [[good, { creases: 60 }, /no option "creases"/], [good, { normals: 'all' }, /normals must be face, object, model/],
        [apart, {}, /skin 'arm': a joint is not a node of the scene/],
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

test('texture coordinates of morph targets are left as they are, and said', async () => {
    const document = documentOf(sheets()), owner = primitiveOf(document, 0), count = owner.getAttribute('POSITION').getCount();
    const target = document.createPrimitiveTarget().setAttribute('TEXCOORD_0', accessor(document, new Float32Array(2 * count).fill(0.25), 'VEC2'));
    owner.addTarget(target.setAttribute('POSITION', accessor(document, new Float32Array(3 * count))));
    const { remarks } = await closes(document);
    assert.ok(remarks.some(({ kind, text }) => kind === 'dropped' && /morph targets of other arrays/.test(text)));
    assert.deepEqual(new Set(primitiveOf(document, 0).listTargets()[0].getAttribute('TEXCOORD_0').getArray()), new Set([0.25]));
});

test('arrays of types that glTF does not allow are errors, not zeros', async () => {
    const spoiled = spoil => {
        const document = documentOf(sheets());
        spoil(primitiveOf(document, 0), document);
        return document;
    };
    const cases = [
        [spoiled((each, document) => each.setIndices(accessor(document, Int16Array.from([0, 1, -2]), 'SCALAR'))), /indices cannot have components of type 5122/],
        [spoiled((each, document) => each.setIndices(accessor(document, Float32Array.from([0, 1, 2]), 'SCALAR'))), /indices cannot have components of type 5126/],
        [spoiled(each => each.getAttribute('NORMAL').setType('VEC2').setArray(new Float32Array(2 * each.getAttribute('POSITION').getCount()))), /NORMAL cannot have 2 components/],
        [spoiled(each => each.getAttribute('POSITION').setType('VEC2').setArray(new Float32Array(70))), /POSITION cannot have 2 components/],
        [spoiled(each => each.setMode(9)), /mode 9 is unknown/],
        [spoiled(each => each.setMode(260)), /mode 260 is unknown/],
        [spoiled(each => each.setAttribute('_BITANGENT', each.getAttribute('NORMAL').clone().setType('MAT4'))), /not a multiple of 16/],
        [spoiled((_, document) => document.getRoot().listNodes()[0].setTranslation(new Array(40000).fill(0))), /another length than glTF allows/],
        [spoiled((_, document) => document.getRoot().listNodes()[0].setTranslation(new Array(9).fill(0))), /another length than glTF allows/],
        [spoiled((each, document) => each.addTarget(document.createPrimitiveTarget()) && primitiveOf(document, 0).getMaterial() === null &&
            document.getRoot().listMeshes()[0].addPrimitive(each.clone().removeTarget(each.listTargets()[0]))), /different numbers of morph targets/],
        [spoiled((each, document) => {
            const batch = document.createExtension(EXTMeshGPUInstancing).createInstancedMesh();
            document.getRoot().listNodes()[0].setExtension('EXT_mesh_gpu_instancing', batch.setAttribute('TRANSLATION', accessor(document, new Float32Array(32), 'MAT4')));
        }), /instance attributes have another type/],
    ];
    for (const [document, message] of cases) {
        const before = state(document);
        await assert.rejects(document.transform(smoothSeams()), fault => fault instanceof AttributesError && message.test(fault.message), String(message));
        assertUnchanged(document, before);
    }
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
