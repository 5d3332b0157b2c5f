// SPDX-License-Identifier: Apache-2.0
// The module that smooths a whole document: what it is given, number by number, and what it gives back.
import { AttributesError, checkNames, creasesOf, numberOf, scopes, tangentChoices, tangentModes, weights } from './options.js';
import makeModule from './wasm/rakelight-scene.mjs';

/** In the order of the module's enumerators. */
const semantics = ['POSITION', 'NORMAL', 'TANGENT', '_BITANGENT', 'TEXCOORD', 'JOINTS', 'WEIGHTS', 'indices'];
const componentTypes = new Map([[Int8Array, 5120], [Uint8Array, 5121], [Uint8ClampedArray, 5121], [Int16Array, 5122], [Uint16Array, 5123],
    [Uint32Array, 5125], [Float32Array, 5126]]);
const arrayTypes = { 5120: Int8Array, 5122: Int16Array, 5126: Float32Array };
const textures = ['normal', 'clearcoatNormal', 'anisotropy'];
const optionNames = ['normals', 'crease', 'weight', 'weldDistance', 'borderDistance', 'tangents', 'bitangents', 'keepInstances', 'onReport'];

/** Scopes of new normals, then the word that keeps the document's normals. */
const normalChoices = [...scopes, 'seams'];

/** What an attribute is: [number of the semantic, set], or undefined: it is not used for normals. */
function semanticOf(name) {
    const whole = semantics.indexOf(name);
    if (whole >= 0) return [whole, 0];
    const [, word, set] = /^(TEXCOORD|JOINTS|WEIGHTS)_(\d)$/.exec(name) ?? [];
    return word && set < (word === 'TEXCOORD' ? 8 : 4) ? [semantics.indexOf(word), Number(set)] : undefined;
}

let loadOptions = {}, loaded;

/** Where the .wasm file comes from; before the first call, and without effect after it. */
export function configure(options) {
    loadOptions = { ...options.locateFile && { locateFile: options.locateFile }, ...options.wasmBinary && { wasmBinary: options.wasmBinary } };
}

/** A scene that is being handed over; one at a time. */
export class SceneModule {
    static async begin() {
        loaded ??= makeModule(loadOptions);
        try {
            return new SceneModule(await loaded);
        } catch (fault) {
            loaded = undefined;  // the next call may be given the right place
            throw fault;
        }
    }

    #module;
    #arrays = new Map();

    constructor(module) {
        this.#module = module;
        module._rl_clear();
    }

    /** The memory is free again. */
    end() { this.#module._rl_clear(); }

    /** After a trap the module's memory is in no known state: the next call gets another one. */
    static forget() { loaded = undefined; }

    /** @param at  what a function of the module returned: above 2 GiB its sign is wrong, and 0 is no memory */
    #fill(Type, at, numbers) {
        if (!at) throw new AttributesError('not enough memory');
        new Type(this.#module.HEAPU8.buffer, at >>> 0, numbers.length).set(numbers);
    }

    /**
     * @param key  arrays of one key are one
     * @param read  () => { array: typed array, components, normalized }
     */
    array(key, read) {
        const known = this.#arrays.get(key);
        if (known !== undefined) return known;
        const { array, components, normalized } = read();
        const type = componentTypes.get(array.constructor);
        if (!type) throw new AttributesError(`an array of ${array.constructor.name} cannot be read`);
        const count = array.length / components;
        if (!Number.isInteger(count)) throw new AttributesError(`an array has ${array.length} numbers, not a multiple of ${components}`);
        this.#fill(array.constructor, this.#module._rl_array(type, components, normalized ? 1 : 0, count), array);
        this.#arrays.set(key, this.#arrays.size);
        return this.#arrays.size - 1;
    }

    /** @param uses  { normal, clearcoatNormal, anisotropy }: { set, offset, scale, rotation } of those that are there */
    material(uses, anisotropyStrength = 0) {
        this.#module._rl_material(anisotropyStrength);
        textures.forEach((name, i) => {
            const use = uses[name];
            if (use) this.#module._rl_texture(i, use.set, ...use.offset, ...use.scale, use.rotation);
        });
    }

    #text(text, room) {
        const bytes = new TextEncoder().encode(text);
        this.#fill(Uint8Array, room(bytes.length), bytes);
    }

    /** @param targets  names of its morph targets: those of one name belong together over all meshes */
    primitive({ mesh, name, primitive, mode, material = -1, targets }) {
        this.#text(name, length => this.#module._rl_primitive(mesh, primitive, mode, material, length));
        targets.forEach((name, t) => this.#text(typeof name === 'string' ? name : `target ${t}`, length => this.#module._rl_target(length)));
    }

    /** Of the last primitive, or of a morph target of it. */
    attribute(name, key, read, target = -1) {
        const semantic = semanticOf(name);
        if (semantic) this.#module._rl_attribute(...semantic, target, this.array(key, read));
    }

    skin(joints, inverseBind) {
        if (inverseBind.length !== 16 * joints.length) throw new AttributesError(`a skin has ${joints.length} joints, but ${inverseBind.length} numbers of inverse bind matrices`);
        this.#fill(Float64Array, this.#module._rl_skin(joints.length), inverseBind);
        this.#fill(Uint32Array, this.#module._rl_joints(), joints);
    }

    /** @param place  16 numbers of a matrix by columns, or 10: translation, rotation, scale */
    node({ parent = -1, source, mesh = -1, skin = -1, place }) {
        if (place.length !== 10 && place.length !== 16) throw new AttributesError(`a node is placed by ${place.length} numbers, not 10 or 16`);
        this.#fill(Float64Array, this.#module._rl_node(parent, source, mesh, skin, place.length === 16 ? 1 : 0), place);
    }

    smooth(options) {
        checkNames(options, optionNames);
        const { normals = 'seams', crease = 'auto', weight = 'auto', weldDistance = -1, borderDistance = 0, tangents = 'auto',
            bitangents = false, keepInstances = false } = options;
        const isReplaced = normals !== 'seams', averaged = tangentModes.indexOf('averaged');
        const code = this.#module._rl_smooth(isReplaced ? 1 : 0, isReplaced ? numberOf(normalChoices, normals, 'normals') : scopes.indexOf('model'),
            numberOf(weights, weight, 'weight'), ...creasesOf(crease), weldDistance, borderDistance,
            numberOf(tangentChoices, tangents, 'tangents'), averaged, bitangents ? 1 : 0, keepInstances ? 1 : 0);
        if (code !== 0) throw new AttributesError(this.#module.UTF8ToString(this.#module._rl_error()));
    }

    report() {
        const [all, turned, largestDegrees, meanDegrees, flatPairs, creasePairs, unusable, made, borderTurned, borderLargest, borderMean, keeps] =
            new Float64Array(this.#module.HEAPU8.buffer, this.#module._rl_report() >>> 0, 12);
        return {
            changed: this.#module._rl_version_count() > 0,
            ...keeps && { seams: { normals: all, turned, largestDegrees, meanDegrees, flatPairs, creasePairs, unusable } },
            made,
            borders: { turned: borderTurned, largestDegrees: borderLargest, meanDegrees: borderMean },
            remarks: Array.from({ length: this.#module._rl_remark_count() }, (_, i) => {
                const [kind, count, place, ...text] = this.#module.UTF8ToString(this.#module._rl_remark(i)).split('\n');
                return { kind, count: Number(count), place, text: text.join('\n') };
            }),
        };
    }

    /** A copy. */
    #result(Type, what, number, target = 0) {
        const bytes = this.#module._rl_result_bytes(what, number, target);
        return new Type(this.#module.HEAPU8.buffer, this.#module._rl_result(what, number, target) >>> 0, bytes / Type.BYTES_PER_ELEMENT).slice();
    }

    /** The meshes as nodes need them: { mesh, isInPlace, nodes, primitives }; none: nothing changes. */
    versions() {
        return Array.from({ length: this.#module._rl_version_count() }, (_, v) => ({
            mesh: this.#module._rl_version_mesh(v),
            isInPlace: this.#module._rl_version_is_in_place(v) !== 0,
            nodes: this.#result(Uint32Array, 0, v),
            meshes: this.#result(Uint32Array, 1, v),
        }));
    }

    /**
     * How a primitive changes.
     * @param mesh  of versions()[...].meshes
     * @returns { primitive, isChanged, copied, corners, removesTangents, directions: [name, typed array][], targets: [name, typed array][][] }
     */
    primitiveChange(mesh) {
        const [primitive, isChanged, ...head] = this.#result(Uint32Array, 2, mesh);
        if (!isChanged) return { primitive, isChanged: false };
        const [hasCorners, removesTangents] = head.slice(3);
        const named = arrays => arrays.filter(([, array]) => array.length > 0);
        const targetCount = this.#module._rl_target_count(mesh);
        return {
            primitive, isChanged: true,
            copied: this.#result(Uint32Array, 3, mesh),
            corners: hasCorners ? this.#result(Uint32Array, 4, mesh) : undefined,
            removesTangents: removesTangents !== 0,
            directions: named([1, 2, 3].map((semantic, i) => [semantics[semantic], this.#result(arrayTypes[head[i]], 5 + i, mesh)])),
            targets: Array.from({ length: targetCount },
                (_, t) => named([1, 2].map((semantic, i) => [semantics[semantic], this.#result(Float32Array, 8 + i, mesh, t)]))),
        };
    }
}
