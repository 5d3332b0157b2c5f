// SPDX-License-Identifier: Apache-2.0
// An object of three.js with all below it: what is handed over of it, and how changes come back into its geometries. Only what its
// objects have is used, so that this works with whatever copy of the library made them.
import { AttributesError } from './options.js';

const floatTypes = [Int8Array, Uint8Array, Uint8ClampedArray, Int16Array, Uint16Array, Float32Array];
const names = { position: 'POSITION', normal: 'NORMAL', tangent: 'TANGENT', skinIndex: 'JOINTS_0', skinWeight: 'WEIGHTS_0' };

/** All numbers of an attribute as they are stored, without what lies between them. */
function stored(attribute) {
    const { count, itemSize, array } = attribute;
    if (!attribute.isInterleavedBufferAttribute) return array.subarray(0, count * itemSize);
    const out = new array.constructor(count * itemSize), { stride } = attribute.data;
    for (let i = 0; i < count; ++i) for (let c = 0; c < itemSize; ++c) out[i * itemSize + c] = array[i * stride + attribute.offset + c];
    return out;
}

const getters = ['getX', 'getY', 'getZ', 'getW'];

/** As the values that shaders see. */
function values(attribute) {
    const { count, itemSize } = attribute, out = new Float32Array(count * itemSize);
    for (let c = 0; c < itemSize; ++c) for (let i = 0; i < count; ++i) out[i * itemSize + c] = attribute[getters[c]](i);
    return out;
}

const read = attribute => () => {
    const isPlain = !attribute.isFloat16BufferAttribute && floatTypes.includes(attribute.array.constructor);
    return { array: isPlain ? stored(attribute) : values(attribute), components: attribute.itemSize, normalized: isPlain && attribute.normalized };
};
const readIntegers = (attribute, Type) => () => ({ array: Type.from(stored(attribute)), components: attribute.itemSize, normalized: false });

/** @param base  what a target that is not relative contains too */
const readOffsets = (attribute, base) => () => {
    const array = values(attribute);
    if (base) values(base).forEach((value, i) => { array[i] -= value; });
    return { array, components: 3, normalized: false };
};

/** The texture of a mesh to which its tangents belong. */
function tangentTexture(mesh) {
    const materials = [mesh.material].flat().filter(Boolean);
    for (const name of ['normalMap', 'clearcoatNormalMap', 'anisotropyMap', 'map'])
        for (const material of materials) if (material[name]) return material[name];
    return undefined;
}

/** Texture coordinates of a texture, v down as in glTF. */
const readTexcoords = (attribute, texture) => () => {
    if (texture?.matrixAutoUpdate) texture.updateMatrix();
    const uv = values(attribute), m = texture?.matrix?.elements ?? [1, 0, 0, 0, 1, 0, 0, 0, 1];
    for (let i = 0; i < uv.length; i += attribute.itemSize) {
        const u = uv[i], v = uv[i + 1], transformed = m[1] * u + m[4] * v + m[7];
        uv[i] = m[0] * u + m[3] * v + m[6];
        uv[i + 1] = texture?.flipY ? 1 - transformed : transformed;
    }
    return { array: uv, components: attribute.itemSize, normalized: false };
};

/** The class of plain attributes, of which all others are made. */
function attributeClass(geometry) {
    let prototype = [...Object.values(geometry.attributes), geometry.index].find(each => each?.isBufferAttribute) ?? geometry.attributes.position.clone();
    while (!Object.hasOwn(prototype, 'copyArray')) prototype = Object.getPrototypeOf(prototype);
    return prototype.constructor;
}

/** Of instanced geometries only their shaders know the places. */
const isReadable = geometry => geometry.attributes.position && !geometry.isInstancedBufferGeometry &&
    !Object.values(geometry.attributes).some(each => each.isGLBufferAttribute);

/** The visible meshes of an object. */
export class ThreeObject {
    #root;
    #geometries = [];
    #meshes = [];
    #flat = [];  // meshes without normals
    #remarks = [];

    constructor(root) { this.#root = root; }

    /** What is not smoothed. */
    get remarks() { return this.#remarks; }

    give(module) {
        this.#root.updateWorldMatrix(true, true);
        this.#root.traverseVisible(object => {
            if (!object.isMesh) return;
            if (object.isBatchedMesh || !isReadable(object.geometry)) this.#leaveOut(object);
            else this.#meshes.push(object);
        });
        this.#flat = this.#meshes.filter(mesh => !mesh.geometry.attributes.normal);
        this.#geometries = [...new Set(this.#meshes.map(mesh => mesh.geometry))];
        this.#geometries.forEach((geometry, number) => this.#giveGeometry(module, geometry, number));
        this.#giveNodes(module);
    }

    #leaveOut(object) {
        const what = object.isBatchedMesh ? 'batched meshes are' : 'a geometry whose positions cannot be read is';
        this.#remark('dropped', object, `${what} not smoothed`);
    }

    #remark(kind, { name }, text) { this.#remarks.push({ kind, count: 1, place: name, text }); }

    #giveGeometry(module, geometry, number) {
        const user = this.#meshes.find(mesh => mesh.geometry === geometry), { morphAttributes, attributes, index } = geometry;
        const targets = Array.from({ length: Math.max(...Object.values(morphAttributes).map(each => each.length), 0) });
        for (const [name, list] of Object.entries(morphAttributes))
            if (list.length !== targets.length || Array.from(list).includes(undefined)) throw new AttributesError(`geometry '${geometry.name || user.name}': not every morph target has ${name}`);
        for (const [name, t] of Object.entries(user.morphTargetDictionary ?? {})) if (t in targets) targets[t] = name;
        module.primitive({ mesh: number, primitive: 0, mode: 4, targets, name: geometry.name || user.name });
        for (const [name, attribute] of Object.entries(attributes))
            if (names[name]) module.attribute(names[name], attribute, name === 'skinIndex' ? readIntegers(attribute, Uint16Array) : read(attribute));
        const texture = tangentTexture(user), uv = attributes[texture?.channel ? `uv${texture.channel}` : 'uv'];
        if (uv) module.attribute('TEXCOORD_0', {}, readTexcoords(uv, texture));
        if (index) module.attribute('indices', index, readIntegers(index, Uint32Array));
        for (const name of ['position', 'normal']) {
            const base = geometry.morphTargetsRelative ? undefined : attributes[name];
            morphAttributes[name]?.forEach((each, t) => module.attribute(names[name], base ? {} : each, readOffsets(each, base), t));
        }
    }

    /** Each mesh where it is in the world; the bones of skinned ones behind them. */
    #giveNodes(module) {
        const skinned = this.#meshes.filter(mesh => mesh.isSkinnedMesh && mesh.skeleton && mesh.geometry.attributes.skinIndex);
        const bones = [...new Set(skinned.flatMap(mesh => mesh.skeleton.bones))];
        let count = 0;
        this.#meshes.forEach((mesh, source) => {
            const shown = { source, mesh: this.#geometries.indexOf(mesh.geometry), skin: skinned.indexOf(mesh) };
            const place = mesh.matrixWorld.clone();
            for (let i = 0; i < (mesh.isInstancedMesh ? mesh.count : 1); ++i, ++count) {
                if (mesh.isInstancedMesh) mesh.getMatrixAt(i, place), place.premultiply(mesh.matrixWorld);
                module.node({ ...shown, place: place.elements });
            }
        });
        bones.forEach((bone, i) => module.node({ source: this.#meshes.length + i, place: bone.matrixWorld.elements }));
        for (const { skeleton, bindMatrix } of skinned) {
            const inverses = skeleton.boneInverses.map(inverse => inverse.clone().multiply(bindMatrix).elements);
            if (inverses.length < skeleton.bones.length) throw new AttributesError('a skeleton has fewer inverse matrices than bones');
            module.skin(skeleton.bones.map(bone => count + bones.indexOf(bone)), inverses.slice(0, skeleton.bones.length).flatMap(each => [...each]));
        }
    }

    /** @param versions  of SceneModule.versions() */
    take(module, versions) {
        // Copies are made of what was there before: the geometry itself changes last.
        for (const version of [...versions].sort((a, b) => a.isInPlace - b.isInPlace)) {
            const change = module.primitiveChange(version.meshes[0]), original = this.#geometries[version.mesh];
            const geometry = version.isInPlace ? original : original.clone();
            if (change.isChanged) apply(change, geometry);
            if (!version.isInPlace) for (const node of version.nodes) this.#meshes[node].geometry = geometry;
        }
        this.#showNormals();
    }

    /** Flat shading does not look at normals. Loaders choose it where there were none. */
    #showNormals() {
        const smooth = new Map();  // material -> its copy, which does
        const copyOf = material => {
            if (!smooth.has(material)) smooth.set(material, Object.assign(material.clone(), { flatShading: false }));
            return smooth.get(material);
        };
        for (const mesh of this.#meshes.filter(each => [each.material].flat().some(material => material?.flatShading))) {
            const isNew = this.#flat.includes(mesh) && mesh.geometry.attributes.normal;
            if (!isNew) {
                this.#remark('warning', mesh, 'its normals are not seen: its material has flatShading');
                continue;
            }
            const made = [mesh.material].flat().map(material => (material.flatShading ? copyOf(material) : material));
            mesh.material = Array.isArray(mesh.material) ? made : made[0];
            this.#remark('changed', mesh, 'it has normals now, so its material is one without flatShading');
        }
    }
}

function apply({ copied, corners, removesTangents, directions, targets }, geometry) {
    geometry.dispose();  // what three.js made of the old attributes
    const Attribute = attributeClass(geometry);
    if (copied.length > 0) split(geometry, copied, Attribute);
    for (const [name, array] of directions) {
        const isInteger = !(array instanceof Float32Array), to = name.toLowerCase();
        geometry.setAttribute(to, new Attribute(array, to === 'tangent' ? 4 : 3, isInteger));
    }
    if (removesTangents) geometry.deleteAttribute('tangent');
    if (corners) {
        const isSmall = geometry.index?.array instanceof Uint16Array && geometry.attributes.position.count < 65536;
        geometry.setIndex(new Attribute(isSmall ? Uint16Array.from(corners) : corners, 1));
    }
    targets.forEach((target, t) => {
        for (const [name, offsets] of target) if (name === 'NORMAL') setTarget(geometry, t, offsets, Attribute);
    });
}

/** Normals of a morph target; also those of geometries whose targets are not relative. */
function setTarget(geometry, t, offsets, Attribute) {
    if (!geometry.morphTargetsRelative) values(geometry.attributes.normal).forEach((value, i) => { offsets[i] += value; });
    geometry.morphAttributes.normal ??= [];
    geometry.morphAttributes.normal[t] = new Attribute(offsets, 3);
}

/** All attributes get copies of vertices behind theirs. */
function split(geometry, copied, Attribute) {
    const longer = attribute => {
        if (attribute.isInstancedBufferAttribute || attribute.data?.isInstancedInterleavedBuffer) return attribute;
        const array = stored(attribute), size = attribute.itemSize, out = new array.constructor(array.length + copied.length * size);
        out.set(array);
        copied.forEach((vertex, i) => out.set(array.subarray(vertex * size, (vertex + 1) * size), array.length + i * size));
        const Same = attribute.isInterleavedBufferAttribute || !attribute.isFloat16BufferAttribute ? Attribute : attribute.constructor;
        const made = new Same(out, size, attribute.normalized);
        made.name = attribute.name;
        made.usage = (attribute.data ?? attribute).usage;
        if (attribute.gpuType) made.gpuType = attribute.gpuType;
        return made;
    };
    for (const [name, attribute] of Object.entries(geometry.attributes)) geometry.setAttribute(name, longer(attribute));
    for (const [name, list] of Object.entries(geometry.morphAttributes)) geometry.morphAttributes[name] = list.map(longer);
}
