// SPDX-License-Identifier: Apache-2.0
// smoothSeams() over objects of three.js: seams close where meshes are shown, and geometries stay what three.js expects.
import assert from 'node:assert/strict';
import test from 'node:test';

import { AttributesError, smoothSeams } from 'rakelight/scene';
import * as THREE from 'three';

import { cube, distance, identity, meetings, placed, rows, sheet, sheets, vector } from './bent_sheet.mjs';
import { documentOf, numbers, run } from './gltf_parts.mjs';
import { attribute, closes, geometriesOf, geometryOf, meshOf, partOf, partsOf, place, sceneOf } from './three_parts.mjs';

test('two meshes are joined where they lie in the world, with the numbers of the gltf-transform path', async () => {
    const matrices = [placed(0, 1, [3, 1, -2]), placed(2, 1, [0, -4, 1])], parts = [0, 1].map(i => sheet(i, { matrix: matrices[i] }));
    const scene = sceneOf(parts, { matrices }), document = documentOf(parts, matrices);
    const { seams } = await closes(scene);
    assert.equal(seams.turned, 2 * (rows + 1));
    await run(document);
    document.getRoot().listNodes().forEach((node, i) => {
        const { normal, position } = geometriesOf(scene)[i].attributes;
        assert.deepEqual(normal.array, numbers(node.getMesh().listPrimitives()[0].getAttribute('NORMAL')));
        assert.deepEqual(position.array, parts[i].positions);
    });
});

test('distances are those of the world, also below a parent', async () => {
    const scene = sceneOf(sheets(undefined, { at: [-0.001, 0, 0] })), above = new THREE.Group().add(scene);
    assert.equal((await smoothSeams(scene, { weldDistance: 1e-4 })).changed, false);
    above.scale.setScalar(0.01);
    assert.equal((await smoothSeams(scene, { weldDistance: 1e-4 })).changed, true);
});

test('geometries without indices', async () => {
    const scene = sceneOf(sheets(), { change: geometry => geometry.toNonIndexed() });
    await closes(scene);
    for (const geometry of geometriesOf(scene)) {
        assert.equal(geometry.index, null);
        assert.equal(geometry.attributes.normal.count, geometry.attributes.position.count);
    }
});

test('each instance of an InstancedMesh counts where it is', async () => {
    const matrices = [identity, placed(1, 2, [10, 0, 0])], scene = new THREE.Scene(), [left, right] = sheets().map(geometryOf);
    const instanced = place(new THREE.InstancedMesh(left, undefined, 2), placed(0, 1, [0, 3, 0]));
    matrices.forEach((matrix, i) => instanced.setMatrixAt(i, new THREE.Matrix4().fromArray(matrix)));
    const lifted = matrix => new THREE.Matrix4().makeTranslation(0, 3, 0).multiply(new THREE.Matrix4().fromArray(matrix)).elements;
    scene.add(instanced, ...matrices.map(matrix => meshOf(right, lifted(matrix))));
    const parts = () => matrices.flatMap(matrix => [instanced, scene.children[1]].map(mesh => partOf(mesh, matrix)));
    const { remarks } = await closes(scene, {}, { parts, places: 2 * (rows + 1) });
    assert.deepEqual(remarks, []);
    assert.ok(instanced.geometry === left && scene.children[1].geometry === right);
});

/** Vertices at the border move with bone 0, others with bone 1. */
function addInfluences(geometry, { positions, border }) {
    const of = (Type, value) => Type.from({ length: positions.length / 3 * 4 }, (_, k) => (k % 4 === 0 ? value(k / 4) : 0));
    geometry.setAttribute('skinIndex', attribute(of(Uint16Array, v => (border.includes(v) ? 0 : 1)), 4));
    geometry.setAttribute('skinWeight', attribute(of(Float32Array, () => 1), 4));
}

test('skinned meshes are joined in the bind pose, however their bones are posed', async () => {
    const matrices = [identity, placed(1, 1, [3, 0, 1])], bones = [new THREE.Bone(), new THREE.Bone()], scene = new THREE.Scene();
    scene.add(...bones);
    bones[1].position.set(0, 2, 0);
    scene.updateMatrixWorld(true);
    const skeleton = new THREE.Skeleton(bones), meshes = matrices.map((matrix, i) => {
        const part = sheet(i, { matrix }), mesh = place(new THREE.SkinnedMesh(geometryOf(part)), matrix);
        addInfluences(mesh.geometry, part);
        scene.add(mesh);
        mesh.bind(skeleton, new THREE.Matrix4().fromArray(matrix));
        return mesh;
    });
    bones[0].position.set(5, 0, 0);
    bones[1].rotation.set(1, 2, 0);
    place(meshes[1], placed(0, 1, [100, 0, 0]));
    await closes(scene, {}, { parts: () => meshes.map((mesh, i) => partOf(mesh, matrices[i])) });
});

test('groups still fit after vertices split', async () => {
    const { positions, indices } = cube(), geometry = geometryOf({ positions, indices });
    geometry.setAttribute('uv', attribute(Float32Array.from({ length: 16 }, (_, i) => i), 2));
    geometry.setAttribute('number', new THREE.Int32BufferAttribute([0, 1, 2, 3, 4, 5, 6, 7], 1).setUsage(THREE.DynamicDrawUsage));
    geometry.attributes.number.gpuType = THREE.IntType;
    geometry.morphTargetsRelative = true;
    geometry.morphAttributes.position = [attribute(positions.map((x, k) => (k % 3 === 0 ? x : 0)))];
    for (let face = 0; face < 6; ++face) geometry.addGroup(6 * face, 6, face % 2);
    const mesh = new THREE.Mesh(geometry, [new THREE.MeshBasicMaterial(), new THREE.MeshBasicMaterial()]), groups = structuredClone(geometry.groups);
    assert.equal((await smoothSeams(mesh, { tangents: 'never' })).changed, true);
    const { position, normal, uv, number } = geometry.attributes, targets = ['position', 'normal'].map(name => geometry.morphAttributes[name][0]);
    for (const { count } of [position, normal, uv, number, ...targets]) assert.equal(count, 24);
    assert.deepEqual([number.usage, number.gpuType, number.array.constructor], [THREE.DynamicDrawUsage, THREE.IntType, Int32Array]);
    assert.deepEqual(geometry.groups, groups);
    assert.ok(geometry.index.array instanceof Uint16Array);
    indices.forEach((was, c) => {
        const v = geometry.index.array[c], face = 6 * Math.floor(c / 6), normals = [0, 1].map(k => vector(normal.array, geometry.index.array[face + 3 * k]));
        assert.deepEqual(vector(position.array, v), vector(positions, was));
        assert.equal(number.array[v], was);
        assert.ok(distance(vector(targets[0].array, v), [positions[3 * was], 0, 0]) + Math.hypot(...vector(targets[1].array, v)) < 1e-6);
        assert.deepEqual(vector(uv.array, v, 2), [2 * was, 2 * was + 1]);
        assert.ok(distance(vector(normal.array, v), normals[0]) < 1e-6 && distance(...normals) < 1e-6);
    });
});

test('a geometry of two meshes with different neighbors gets a clone for one of them', async () => {
    const far = [10, 0, 0], [left, right] = sheets().map(geometryOf), scene = new THREE.Scene();
    scene.add(meshOf(left), meshOf(left, placed(0, 1, far)), meshOf(right), meshOf(geometryOf(sheet(1, { lean: 0.4, at: far }))));
    await closes(scene, {}, { places: 2 * (rows + 1) });
    const [first, second] = geometriesOf(scene);
    assert.ok(first === left && second !== left);
    assert.deepEqual(second.attributes.position.array, left.attributes.position.array);
});

function interleave(geometry) {
    const { position, normal } = geometry.attributes, array = new Float32Array(8 * position.count);
    for (let v = 0; v < position.count; ++v) array.set([...vector(position.array, v), 0, ...vector(normal.array, v), v], 8 * v);
    const buffer = new THREE.InterleavedBuffer(array, 8);
    geometry.setAttribute('position', new THREE.InterleavedBufferAttribute(buffer, 3, 0));
    geometry.setAttribute('normal', new THREE.InterleavedBufferAttribute(buffer, 3, 4));
    return geometry.setAttribute('number', new THREE.InterleavedBufferAttribute(buffer, 1, 7));
}

test('interleaved attributes', async () => {
    const scene = sceneOf(sheets(), { change: geometry => interleave(geometry).toNonIndexed() }), indexed = sceneOf(sheets(), { change: interleave });
    const { position } = geometriesOf(indexed)[0].attributes, before = position.data.array.slice();
    await closes(indexed);
    assert.ok(geometriesOf(indexed)[0].attributes.position === position);
    assert.deepEqual(position.data.array, before);
    await closes(scene);
});

test('interleaved attributes of vertices that split', async () => {
    const { positions, indices } = cube(), shared = geometryOf({ positions, normals: positions, indices: Uint32Array.from(indices) });
    const geometry = interleave(shared).deleteAttribute('normal');
    await smoothSeams(new THREE.Mesh(geometry));
    const { position, number } = geometry.attributes;
    assert.deepEqual([position.count, number.count], [24, 24]);
    assert.ok(geometry.index.array instanceof Uint32Array);
    indices.forEach((was, c) => {
        assert.deepEqual(vector(position.array, geometry.index.array[c]), vector(positions, was));
        assert.equal(number.array[geometry.index.array[c]], was);
    });
});

const coded = (geometry, Type) => geometry.setAttribute('normal',
    attribute(Type.from(geometry.attributes.normal.array, x => Math.round(x * (Type === Int8Array ? 127 : 32767))), 3, true));

for (const Type of [Int8Array, Int16Array])
    test(`normals of ${Type.name} stay ones, and are equal`, async () => {
        const parts = sheets({ lean: 0.3 }), scene = sceneOf(parts, { change: geometry => coded(geometry, Type) });
        const before = geometriesOf(scene).map(geometry => geometry.attributes.normal.array.slice());
        await closes(scene);
        geometriesOf(scene).forEach(({ attributes: { normal } }, i) => {
            assert.ok(normal.array instanceof Type && normal.normalized);
            for (let v = 0; v < normal.count; ++v)
                if (!parts[i].border.includes(v)) assert.deepEqual(vector(normal.array, v), vector(before[i], v));
        });
    });

test('normals of 8 bits beside floats become floats, those of 16-bit floats too', async () => {
    const half = ({ attributes: { normal } }) => new THREE.Float16BufferAttribute(Uint16Array.from(normal.array, THREE.DataUtils.toHalfFloat), 3);
    for (const change of [geometry => coded(geometry, Int8Array), geometry => geometry.setAttribute('normal', half(geometry))]) {
        const parts = sheets({ lean: 0.3 }), scene = sceneOf(parts, { change: (geometry, _, i) => (i === 0 ? change(geometry) : geometry) });
        await closes(scene);
        const { array } = geometriesOf(scene)[0].attributes.normal, [{ normals, border }] = parts;
        assert.ok(array instanceof Float32Array);
        for (let v = 0; v < array.length / 3; ++v) assert.ok(distance(vector(array, v), border.includes(v) ? [0, 0, 1] : vector(normals, v)) < 0.01);
    }
});

/** A morph target that turns or moves the whole sheet. */
function addTarget(geometry, moved, isRelative) {
    geometry.morphTargetsRelative = isRelative;
    for (const name of ['position', 'normal']) {
        const base = geometry.attributes[name].array, sums = moved(base, name);
        geometry.morphAttributes[name] = [attribute(isRelative ? sums.map((x, i) => x - base[i]) : sums)];
    }
    return geometry;
}

const [c, s] = [Math.cos(0.3), Math.sin(0.3)];
const turned = array => array.map((_, k) => [c * array[k] + s * array[k + 2], array[k], c * array[k] - s * array[k - 2]][k % 3]);
const lifted = (array, name) => array.map((x, k) => (name === 'position' && k % 3 === 1 ? x + 1 : x));

for (const isRelative of [true, false])
    for (const [moved, normal] of [[turned, [s, 0, c]], [lifted, [0, 0, 1]]])
        test(`${isRelative ? '' : 'not '}relative morph targets (${moved.name}): the seam is closed with weight 0 and with weight 1`, async () => {
            const parts = sheets(), scene = sceneOf(parts, { change: geometry => addTarget(geometry, moved, isRelative) });
            assert.ok(meetings(partsOf(scene, 1)).least > 0.1);
            await closes(scene);
            const after = partsOf(scene, 1), { places, most } = meetings(after);
            assert.equal(places, rows + 1);
            assert.ok(most < 1e-6, `${most} apart`);
            after.forEach(({ normals }, i) => parts[i].border.forEach(v => assert.ok(distance(vector(normals, v), normal) < 1e-6)));
        });

test('morph targets that are not relative may be attributes of other geometries', async () => {
    const parts = sheets(), near = sceneOf(parts, { change: geometry => addTarget(geometry, turned, false) }), far = new THREE.Group();
    for (const { morphAttributes: { position: [position], normal: [normal] }, index } of geometriesOf(near))
        far.add(new THREE.Mesh(new THREE.BufferGeometry().setAttribute('position', position).setAttribute('normal', normal).setIndex(index)));
    far.position.set(0, 50, 0);
    assert.ok(meetings(partsOf(far)).least > 0.1);
    await smoothSeams(new THREE.Scene().add(far, near));
    for (const all of [partsOf(far), partsOf(near, 1)])
        all.forEach(({ normals }, i) => parts[i].border.forEach(v => assert.ok(distance(vector(normals, v), [s, 0, c]) < 1e-6)));
});

const withTangents = (geometry, { tangents, texcoords }) =>
    geometry.setAttribute('tangent', attribute(tangents.slice(), 4)).setAttribute('uv', attribute(texcoords.slice(), 2));

test('tangents turn with their normals, or go', async () => {
    const parts = sheets(), scene = sceneOf(parts, { change: withTangents });
    await closes(scene);
    geometriesOf(scene).forEach(({ attributes: { tangent } }, i) => {
        for (let v = 0; v < tangent.count; ++v)
            if (parts[i].border.includes(v)) assert.ok(distance(vector(tangent.array, v, 4), [-1, 0, 0, 1]) < 1e-6);
            else assert.deepEqual(vector(tangent.array, v, 4), vector(parts[i].tangents, v, 4));
    });
    const gone = sceneOf(parts, { change: withTangents });
    await closes(gone, { tangents: 'never' });
    for (const { attributes } of geometriesOf(gone)) assert.deepEqual(Object.keys(attributes), ['position', 'normal', 'uv']);
});

test('tangents are made along the texture, as it lies', async () => {
    for (const [flipY, w] of [[true, -1], [false, 1]]) {
        const scene = sceneOf(sheets(), { change: (geometry, part) => withTangents(geometry, part).deleteAttribute('tangent') }), normalMap = new THREE.Texture();
        normalMap.flipY = flipY;
        for (const mesh of scene.children) mesh.material = new THREE.MeshStandardMaterial({ normalMap });
        await closes(scene, { tangents: 'always' });
        for (const { attributes: { normal, tangent } } of geometriesOf(scene))
            for (let v = 0; v < tangent.count; ++v)
                assert.ok(distance(vector(tangent.array, v, 4), [-normal.getZ(v), 0, normal.getX(v), w]) < 1e-6);
    }
});

test('what is not shown as triangles of its own is left alone', async () => {
    const [left, right] = sheets().map(geometryOf), hidden = new THREE.Group().add(meshOf(right)), batched = new THREE.BatchedMesh(1, 100, 200);
    const instanced = new THREE.InstancedBufferGeometry().copy(right);
    batched.addInstance(batched.addGeometry(right));
    hidden.visible = false;
    const scene = new THREE.Scene().add(meshOf(left), hidden, new THREE.Points(right), new THREE.LineSegments(right), batched, new THREE.Mesh(instanced));
    const before = [left, right, batched.geometry, instanced].map(({ attributes }) => [attributes.normal, attributes.normal.array.slice()]);
    const { changed, remarks } = await smoothSeams(scene);
    assert.equal(changed, false);
    assert.deepEqual(remarks.map(({ kind, text }) => [kind, text]),
        [['dropped', 'batched meshes are not smoothed'], ['dropped', 'a geometry whose positions cannot be read is not smoothed']]);
    for (const [normal, array] of before) assert.deepEqual(normal.array, array);
    [left, right, batched.geometry, instanced].forEach(({ attributes }, i) => assert.ok(attributes.normal === before[i][0]));
    hidden.visible = true;
    await closes(scene, {}, { parts: () => [left, right].map(geometry => partOf({ geometry }, identity)) });
});

test('three.js works with the geometry, and what it made of the old attributes goes', async () => {
    const scene = sceneOf(sheets()), [geometry] = geometriesOf(scene);
    let disposed = 0;
    geometry.addEventListener('dispose', () => { ++disposed; });
    await closes(scene);
    assert.equal(disposed, 1);
    assert.ok(Object.values(geometry.attributes).every(each => each instanceof THREE.BufferAttribute));
    geometry.computeBoundingSphere();
    assert.ok(Math.abs(geometry.boundingSphere.radius - Math.sqrt(0.75)) < 1e-6);
    assert.deepEqual(geometry.clone().attributes.normal.array, geometry.attributes.normal.array);
    assert.equal(geometry.toNonIndexed().attributes.normal.count, geometry.index.count);
    assert.deepEqual(new THREE.BufferGeometryLoader().parse(geometry.toJSON()).attributes.normal.array, geometry.attributes.normal.array);
});

test('what is right already does not change, and a second run changes nothing', async () => {
    for (const scene of [sceneOf(sheets({ lean: 0 })), sceneOf(sheets())]) {
        await smoothSeams(scene);
        const before = geometriesOf(scene).map(({ attributes }) => attributes.normal);
        assert.equal((await smoothSeams(scene)).changed, false);
        geometriesOf(scene).forEach(({ attributes }, i) => assert.ok(attributes.normal === before[i]));
    }
});

test('what is wrong is said with its place, and geometries stay', async () => {
    const scene = sceneOf(sheets()), geometry = geometriesOf(scene)[1], { normal } = geometry.attributes;
    geometry.name = 'right';
    geometry.setAttribute('normal', attribute(new Float32Array(9)));
    await assert.rejects(smoothSeams(scene), fault => fault instanceof AttributesError && /mesh 'right', primitive 0: NORMAL has 3 elements/.test(fault.message));
    geometry.setAttribute('normal', normal);
    await assert.rejects(smoothSeams(scene, { tangent: 'never' }), /no option "tangent"/);
    await closes(scene);
});

test('meshes that get their first normals show them: flat shading is that of others', async () => {
    const scene = sceneOf(sheets()), [first, second] = scene.children, flat = first.material.clone();
    flat.flatShading = true;
    first.material = flat, second.material = [flat, new THREE.MeshBasicMaterial()];
    first.geometry.deleteAttribute('normal'), second.geometry.deleteAttribute('normal');
    const report = await smoothSeams(scene);
    assert.equal(report.made, first.geometry.attributes.position.count + second.geometry.attributes.position.count);
    assert.ok(flat.flatShading && !first.material.flatShading);
    assert.equal(second.material[0], first.material);
    assert.equal(report.remarks.filter(({ text }) => /without flatShading/.test(text)).length, 2);
    first.material = flat;
    assert.match((await smoothSeams(scene)).remarks[0].text, /not seen/);
});

test('what is neither options nor an object is refused with what to pass', () => {
    const mesh = sceneOf(sheets()).children[0];
    for (const [given, message] of [[{ scene: mesh }, /pass gltf.scene/], [mesh.geometry, /pass the mesh/], [[mesh], /takes options/], ['x', /takes options/]])
        assert.throws(() => smoothSeams(given), fault => fault instanceof AttributesError && message.test(fault.message));
});
