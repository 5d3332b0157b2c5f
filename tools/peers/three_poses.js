// SPDX-License-Identifier: Apache-2.0
// Posed vertices of glTF models as three.js computes them on the CPU; tools/peers/three_poses.py serves this page and collects.
import * as THREE from 'three';
import { GLTFLoader } from 'three/addons/loaders/GLTFLoader.js';
import { DRACOLoader } from 'three/addons/loaders/DRACOLoader.js';
import { MeshoptDecoder } from 'three/addons/libs/meshopt_decoder.module.js';

const REST_SHARES = [0, 0.37, 0.83];  // of a clip's duration; and the middle key of its longest track

const loader = new GLTFLoader();
loader.setDRACOLoader(new DRACOLoader().setDecoderPath('/three/examples/jsm/libs/draco/gltf/'));
loader.setMeshoptDecoder(MeshoptDecoder);

/// What each object stands for: {node, primitive}. The loader's associations forget nodes when a file has several scenes, so the nodes are
/// asked for one by one (those of the scene: others would take their children out of it). Primitives that are objects of their own below a
/// node come in the order of the file.
async function identities(gltf) {
    const { parser } = gltf, { json } = parser, nodes = new Map(), left = [...json.scenes[json.scene ?? 0].nodes];
    for (let index; (index = left.pop()) !== undefined; left.push(...(json.nodes[index].children ?? [])))
        nodes.set(await parser.getDependency('node', index), index);
    const primitive = (object) => (nodes.has(object) ? 0 : object.parent.children.filter((other) => other.geometry && !nodes.has(other)).indexOf(object));
    return (object) => {
        let at = object;
        while (at && !nodes.has(at)) at = at.parent;
        const own = { node: nodes.get(at), primitive: object.geometry ? primitive(object) : undefined };
        const told = parser.associations.get(object);
        if (told?.primitives !== undefined && told.primitives !== own.primitive || told?.nodes !== undefined && told.nodes !== own.node)
            throw new Error(`node ${own.node}: the loader associates another`);
        return own;
    };
}

/// Every drawn primitive of the scene with its identity in the file, in the order of nodes.
function primitivesOf(gltf, identity) {
    const list = [];
    gltf.scene.traverse((object) => {
        if (object.geometry?.attributes.position && !object.isInstancedMesh) list.push({ object, ...identity(object) });
    });
    return list.sort((a, b) => a.node - b.node || a.primitive - b.primitive);
}

/// At most `most` of `count` numbers, evenly spread, the first and the last among them.
function spread(count, most) {
    if (count <= most) return [...Array(count).keys()];
    return most === 1 ? [0] : [...Array(most).keys()].map((i) => Math.round(i * (count - 1) / (most - 1)));
}

/// [node, primitive, vertex, x, y, z] in the world. Points and lines have no getVertexPosition(): that of a mesh serves them. A skinned mesh
/// without a skeleton (its geometry has a skin at another node) has no position.
function pointsOf(scene, list) {
    scene.updateMatrixWorld(true);
    const at = new THREE.Vector3();
    return list.flatMap(({ object, node, primitive, vertices }) => vertices.map((vertex) => {
        if (object.isSkinnedMesh && !object.skeleton) return [node, primitive, vertex, NaN, NaN, NaN];
        (object.getVertexPosition ?? THREE.Mesh.prototype.getVertexPosition).call(object, vertex, at);
        return [node, primitive, vertex, ...object.localToWorld(at).toArray()];
    }));
}

/// [node, 16 numbers by columns] of the world matrices of nodes with a camera or a light, or of all.
function matricesOf(gltf, identity, all) {
    const found = new Map();
    gltf.scene.traverse((object) => {
        const { node } = identity(object), source = gltf.parser.json.nodes[node];
        if (source && !found.has(node) && (all || source.camera !== undefined || source.extensions?.KHR_lights_punctual))
            found.set(node, object.matrixWorld.toArray());
    });
    return [...found].sort((a, b) => a[0] - b[0]).map(([node, matrix]) => [node, ...matrix]);
}

function timesOf(clip, source) {
    if (source.extras?.times) return source.extras.times;
    const longest = clip.tracks.reduce((a, b) => (b.times.length > a.times.length ? b : a), { times: [0] }).times;
    return [...new Set([...REST_SHARES.map((share) => share * clip.duration), longest[longest.length >> 1]])];
}

function posed(gltf, clip, time) {
    const mixer = new THREE.AnimationMixer(gltf.scene);
    const action = mixer.clipAction(clip).setLoop(THREE.LoopOnce);
    action.clampWhenFinished = true;
    action.play();
    mixer.setTime(time);
    return mixer;
}

async function sample({ url, most, all }) {
    const gltf = await loader.loadAsync(url);
    const identity = await identities(gltf), list = primitivesOf(gltf, identity);
    for (const entry of list) entry.vertices = [...Array(entry.object.geometry.attributes.position.count).keys()];
    const corner = new THREE.Vector3(), box = new THREE.Box3();
    for (const point of pointsOf(gltf.scene, list)) box.expandByPoint(corner.fromArray(point, 3));
    const share = Math.min(60, Math.max(1, Math.floor(most / list.length)));
    for (const entry of list) entry.vertices = spread(entry.vertices.length, share);
    const result = { three: '0.' + THREE.REVISION, size: box.getSize(corner).length(), poses: [] };
    const add = (clip, name, time) => {
        const points = pointsOf(gltf.scene, list);
        result.poses.push({ clip, name, time, points, nodes: matricesOf(gltf, identity, all) });
    };
    add(null, null, 0);
    const clips = gltf.animations.length;
    for (const index of all ? gltf.animations.keys() : new Set([0, clips >> 1, clips - 1].filter((i) => i >= 0 && i < clips))) {
        const clip = gltf.animations[index], source = gltf.parser.json.animations[index];
        for (const time of timesOf(clip, source)) {
            const mixer = posed(gltf, clip, time);
            add(index, source.name ?? null, time);
            mixer.stopAllAction();  // the nodes go back to where the file has them
        }
    }
    const again = pointsOf(gltf.scene, list), rest = result.poses[0].points;
    if (again.some((point, i) => point.some((value, k) => !Object.is(value, rest[i][k])))) throw new Error('not at rest again after its clips');
    return result;
}

for (const job of await (await fetch('/jobs')).json()) {
    const answer = await sample(job).catch((error) => ({ error: String(error) }));
    await fetch('/result/' + job.name, { method: 'POST', body: JSON.stringify(answer) });
}
await fetch('/done', { method: 'POST', body: '' });
