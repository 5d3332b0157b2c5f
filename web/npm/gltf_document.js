// SPDX-License-Identifier: Apache-2.0
// A document of @gltf-transform/core: what is handed over of it, and how changes come back into it. Only methods of its objects are
// called, so that this works with whatever copy of the library made them.
import { AttributesError } from './options.js';

const instancing = 'EXT_mesh_gpu_instancing';
const indexTypes = { 5121: Uint8Array, 5123: Uint16Array, 5125: Uint32Array };

/** Elements as they are stored; an accessor without an array has none. */
const read = accessor => () => ({
    array: accessor.getArray() ?? new Float32Array(0),
    components: accessor.getElementSize(),
    normalized: accessor.getNormalized(),
});

/** Numbers of things, from 0, in the order in which they are first met. */
class Numbers {
    #numbers = new Map();
    things = [];
    of(thing) {
        const known = this.#numbers.get(thing);
        if (known !== undefined) return known;
        this.#numbers.set(thing, this.things.length);
        return this.things.push(thing) - 1;
    }
    has(thing) { return this.#numbers.has(thing); }
}

function textureUse(texture, info) {
    if (!texture) return undefined;
    const transform = info.getExtension('KHR_texture_transform');
    return {
        set: transform?.getTexCoord() ?? info.getTexCoord(), offset: transform?.getOffset() ?? [0, 0],
        scale: transform?.getScale() ?? [1, 1], rotation: transform?.getRotation() ?? 0,
    };
}

function giveMaterial(module, material) {
    const clearcoat = material.getExtension('KHR_materials_clearcoat'), anisotropy = material.getExtension('KHR_materials_anisotropy');
    module.material({
        normal: textureUse(material.getNormalTexture(), material.getNormalTextureInfo()),
        clearcoatNormal: clearcoat && textureUse(clearcoat.getClearcoatNormalTexture(), clearcoat.getClearcoatNormalTextureInfo()),
        anisotropy: anisotropy && textureUse(anisotropy.getAnisotropyTexture(), anisotropy.getAnisotropyTextureInfo()),
    }, anisotropy?.getAnisotropyStrength());
}

/** The placements of a node: its own, or those of its instances. */
function placements(node) {
    const attributes = node.getExtension(instancing);
    if (!attributes) return undefined;
    const [t, r, s] = ['TRANSLATION', 'ROTATION', 'SCALE'].map(name => attributes.getAttribute(name));
    const count = (t ?? r ?? s)?.getCount();
    if (count === undefined) return undefined;
    if ([t, r, s].some(accessor => accessor && accessor.getCount() !== count))
        throw new AttributesError(`node '${node.getName()}': its instance attributes have different counts`);
    [t, r, s].forEach((accessor, i) => {
        if (accessor && accessor.getElementSize() !== [3, 4, 3][i]) throw new AttributesError(`node '${node.getName()}': its instance attributes have another type than glTF allows`);
    });
    const element = (accessor, i, otherwise) => accessor?.getElement(i, []) ?? otherwise;
    return Array.from({ length: count }, (_, i) => [...element(t, i, [0, 0, 0]), ...element(r, i, [0, 0, 0, 1]), ...element(s, i, [1, 1, 1])]);
}

function placeOf(node) {
    const parts = [node.getTranslation(), node.getRotation(), node.getScale()];
    if (parts.some((part, i) => part.length !== [3, 4, 3][i])) throw new AttributesError(`node '${node.getName()}': its translation, rotation or scale has another length than glTF allows`);
    return parts.flat();
}

/** What is shown of a document: its default scene, or its first; of a document without scenes all nodes. */
export class GltfDocument {
    #document;
    #meshes = new Numbers();
    #materials = new Numbers();
    #skins = new Numbers();
    #nodes = new Numbers();
    #given;  // node -> number in the module
    #made = new Map();  // what accessors say -> the new ones that say so

    constructor(document) { this.#document = document; }

    give(module) {
        const root = this.#document.getRoot(), scene = root.getDefaultScene() ?? root.listScenes()[0];
        const roots = scene ? scene.listChildren() : root.listNodes().filter(node => !node.getParentNode());
        // Not by traverse(), which calls itself: hierarchies may be deep. A node comes before its children.
        for (const stack = [...roots].reverse(); stack.length > 0;) {
            const node = stack.pop();
            this.#nodes.of(node);
            for (const child of node.listChildren().reverse()) stack.push(child);
        }
        this.#meshes = this.#met(node => node.getMesh());
        this.#skins = this.#met(node => node.getMesh() && node.getSkin());
        this.#meshes.things.forEach((mesh, number) => mesh.listPrimitives().forEach((_, i) => this.#givePrimitive(module, mesh, number, i)));
        for (const material of this.#materials.things) giveMaterial(module, material);
        this.#giveNodes(module);
        for (const skin of this.#skins.things) this.#giveSkin(module, skin);
    }

    /** Of all nodes. */
    #met(part) {
        const numbers = new Numbers();
        for (const node of this.#nodes.things) {
            const found = part(node);
            if (found) numbers.of(found);
        }
        return numbers;
    }

    #givePrimitive(module, mesh, number, i) {
        const primitive = mesh.listPrimitives()[i], material = primitive.getMaterial(), indices = primitive.getIndices();
        module.primitive({
            mesh: number, primitive: i, mode: primitive.getMode(), targets: primitive.listTargets().map((_, t) => mesh.getExtras().targetNames?.[t]),
            material: material ? this.#materials.of(material) : -1,
            name: mesh.getName(),
        });
        for (const name of primitive.listSemantics()) module.attribute(name, primitive.getAttribute(name), read(primitive.getAttribute(name)));
        if (indices) module.attribute('indices', indices, read(indices));
        primitive.listTargets().forEach((target, t) => {
            for (const name of target.listSemantics()) module.attribute(name, target.getAttribute(name), read(target.getAttribute(name)), t);
        });
    }

    /** Instances become nodes below theirs, which are still that node of the document. */
    #giveNodes(module) {
        const given = this.#given = new Map();
        let count = 0;
        this.#nodes.things.forEach((node, source) => {
            const parent = given.get(node.getParentNode()) ?? -1, mesh = node.getMesh(), skin = node.getSkin();
            const shown = { mesh: mesh ? this.#meshes.of(mesh) : -1, skin: mesh && skin ? this.#skins.of(skin) : -1 };
            const instances = mesh && placements(node);
            given.set(node, count++);
            module.node({ parent, source, place: placeOf(node), ...!instances && shown });
            for (const place of instances ?? []) {
                module.node({ parent: given.get(node), source, place, mesh: shown.mesh });
                ++count;
            }
        });
    }

    #giveSkin(module, skin) {
        const joints = skin.listJoints(), matrices = skin.getInverseBindMatrices();
        const numbers = joints.map(joint => this.#given.get(joint));
        if (numbers.includes(undefined)) throw new AttributesError(`skin '${skin.getName()}': a joint is not a node of the scene`);
        if (matrices && matrices.getCount() < joints.length)
            throw new AttributesError(`skin '${skin.getName()}': ${joints.length} joints, but ${matrices.getCount()} inverse bind matrices`);
        const identity = [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1];
        module.skin(numbers, joints.flatMap((_, j) => (matrices ? matrices.getElement(j, []) : identity)));
    }

    /** @param versions  of SceneModule.versions() */
    take(module, versions) {
        const copies = new Map();  // number of a scene's mesh -> primitive as it became
        const originals = this.#meshes.things.map(mesh => [...mesh.listPrimitives()]);
        const alone = this.#meshes.things.map((_, number) => versions.filter(version => version.mesh === number).length === 1);
        for (const { mesh: number, isInPlace, nodes, meshes } of versions) {
            const mesh = this.#meshes.things[number];
            const primitives = [...originals[number]];
            for (const each of meshes) {
                if (!copies.has(each)) copies.set(each, this.#changed(module, module.primitiveChange(each), originals[number], alone[number]));
                const [at, primitive] = copies.get(each);
                primitives[at] = primitive;
            }
            const target = isInPlace ? mesh : mesh.clone();
            for (const primitive of target.listPrimitives()) target.removePrimitive(primitive);
            for (const primitive of primitives) target.addPrimitive(primitive);
            if (!isInPlace) for (const node of nodes) this.#nodes.things[node].setMesh(target);
        }
        for (const primitives of originals) for (const primitive of primitives) if (!isUsed(primitive)) disposeAll(primitive);
    }

    /** @returns [index in the mesh, the primitive], which is a copy where versions of the mesh differ, or other meshes have it */
    #changed(module, change, originals, isAlone) {
        const original = originals[change.primitive];
        if (!change.isChanged) return [change.primitive, original];
        const isOwn = isAlone && [original, ...original.listTargets()].every(each => users(each).length === 1);
        const primitive = isOwn ? original : copyOf(original);
        if (change.copied.length > 0) this.#split(primitive, change);
        for (const [name, array] of change.directions) this.#put(primitive, name, array, name === 'TANGENT' ? 'VEC4' : 'VEC3');
        if (change.removesTangents) for (const owner of [primitive, ...primitive.listTargets()]) release(owner, 'TANGENT');
        primitive.listTargets().forEach((target, t) => {
            for (const [name, array] of change.targets[t]) this.#put(target, name, array, 'VEC3');
        });
        if (change.corners) this.#putCorners(primitive, change.corners);
        return [change.primitive, primitive];
    }

    /** All attributes but those that are made anew get copies of elements behind theirs. */
    #split(primitive, { copied, directions, targets }) {
        const extend = (owner, made) => {
            for (const name of owner.listSemantics()) {
                if (made.some(([other]) => other === name)) continue;
                const old = owner.getAttribute(name), array = old.getArray() ?? read(old)().array, size = old.getElementSize();
                const longer = new array.constructor(array.length + copied.length * size);
                longer.set(array);
                copied.forEach((vertex, i) => longer.set(array.subarray(vertex * size, (vertex + 1) * size), array.length + i * size));
                replace(owner, name, this.#accessorLike(old, longer, old.getType(), old.getNormalized()));
            }
        };
        extend(primitive, directions);
        primitive.listTargets().forEach((target, t) => extend(target, targets[t]));
    }

    /** As an accessor of its own: others may use the old one. Integers stand for -1..1. */
    #put(owner, name, array, type) {
        replace(owner, name, this.#accessorLike(owner.getAttribute(name), array, type, !(array instanceof Float32Array)));
    }

    /** As a list of triangles. */
    #putCorners(primitive, corners) {
        const old = primitive.getIndices(), largest = corners.reduce((a, b) => Math.max(a, b), 0);
        const wanted = indexTypes[old ? old.getComponentType() : 5123];
        const isWide = ({ BYTES_PER_ELEMENT: bytes }) => bytes >= wanted.BYTES_PER_ELEMENT && largest < 2 ** (8 * bytes) - 1;
        const Type = [wanted, Uint16Array, Uint32Array].find(isWide);
        primitive.setIndices(this.#accessorLike(old, Type.from(corners), 'SCALAR', false, 'indices')).setMode(4);
        if (old && !isUsed(old)) old.dispose();
    }

    /** Equal contents are stored once, so that primitives that share an accessor go on sharing. */
    #accessorLike(old, array, type, isNormalized, use = 'vertices') {
        const buffer = old?.getBuffer() ?? this.#document.getRoot().listBuffers()[0] ?? this.#document.createBuffer();
        const name = old?.getName() ?? '', extras = old?.getExtras() ?? {};
        const key = JSON.stringify([use, name, extras, type, array.constructor.name, array.length, isNormalized]);
        if (!this.#made.has(key)) this.#made.set(key, []);
        const alike = this.#made.get(key), same = alike.find(each => each.getBuffer() === buffer && isEqual(each.getArray(), array));
        if (same) return same;
        const made = this.#document.createAccessor(name).setExtras(extras).setType(type).setArray(array).setNormalized(isNormalized).setBuffer(buffer);
        alike.push(made);
        return made;
    }
}

/** Of one length. */
const isEqual = (a, b) => a.every((x, i) => Object.is(x, b[i]));

/** With targets of its own, and the same accessors. */
function copyOf(primitive) {
    const copy = primitive.clone();
    for (const target of copy.listTargets()) copy.removeTarget(target).addTarget(target.clone());
    return copy;
}

/** Parents beside the document's root, which lists all. */
const users = property => property.listParents().filter(parent => parent.propertyType !== 'Root');
const isUsed = property => users(property).length > 0;
function replace(owner, name, accessor) {
    const old = owner.getAttribute(name);
    owner.setAttribute(name, accessor);
    if (old && !isUsed(old)) old.dispose();
}

function release(owner, name) {
    if (owner.getAttribute(name)) replace(owner, name, null);
}

/** A primitive that no mesh shows any more, and what only it has. */
function disposeAll(primitive) {
    const accessors = [primitive, ...primitive.listTargets()].flatMap(owner => owner.listSemantics().map(name => owner.getAttribute(name)));
    const indices = primitive.getIndices(), targets = primitive.listTargets();
    primitive.dispose();
    for (const target of targets) if (!isUsed(target)) target.dispose();
    for (const accessor of [...accessors, ...indices ? [indices] : []]) if (!isUsed(accessor)) accessor.dispose();
}
