// SPDX-License-Identifier: Apache-2.0
// Seam-free normals and tangents of parts that lie in the world: typed arrays in, typed arrays out.
import { AttributesError, checkNames, creasesOf, numberOf, radians, scopes, tangentModes, weights } from './options.js';
import makeModule from './wasm/rakelight-attributes.mjs';

const firstOwnObject = 0x40000000;  // beyond the numbers that callers give
const identity = [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1];

export { AttributesError };

class Parts {
    constructor(module, parts) {
        this.module = module;
        module._rl_clear();
        parts.forEach((part, i) => this.#add(part, i));
    }

    #add(part, i) {
        const name = `part ${i}`;
        const { matrix = identity, object, positionStep = 0, crease } = part;
        if (matrix.length !== 16) throw new AttributesError(`${name}: matrix has ${matrix.length} numbers, not 16`);
        const numbers = (this.module._rl_add_part() >>> 0) / 8;  // above 2 GiB its sign is wrong
        const own = crease === undefined ? -1 : radians(crease, `${name}: crease`);
        new Float64Array(this.module.HEAPU8.buffer).set([...matrix, object ?? firstOwnObject + i, positionStep, own], numbers);
        const vertices = this.#array(0, part.positions, Float32Array, 3, `${name}: positions`);
        const corners = part.indices ?? Uint32Array.from({ length: vertices }, (_, i) => i);
        if (corners.length % 3 !== 0) throw new AttributesError(`${name}: indices has ${corners.length} numbers, not three a triangle`);
        for (const [what, array, size] of [[1, part.normals, 3], [2, part.texcoords, 2]]) {
            if (!array) continue;
            const count = this.#array(what, array, Float32Array, size, `${name}: ${what === 1 ? 'normals' : 'texcoords'}`);
            if (count !== vertices) throw new AttributesError(`${name}: ${vertices} positions, but ${count} ${what === 1 ? 'normals' : 'texcoords'}`);
        }
        this.#array(3, corners, Uint32Array, 1, `${name}: indices`);
        if (part.smoothingGroups) this.#array(4, part.smoothingGroups, Uint32Array, 1, `${name}: smoothingGroups`);
    }

    #array(what, array, Type, size, name) {
        if (!array || array.length % size !== 0) throw new AttributesError(`${name} must have ${size} numbers for each`);
        const at = this.module._rl_array(what, array.length / size) >>> 0;
        if (!at && array.length) throw new AttributesError('not enough memory');
        new Type(this.module.HEAPU8.buffer, at, array.length).set(array);
        return array.length / size;
    }

    check(code) {
        if (code !== 0) throw new AttributesError(this.module.UTF8ToString(this.module._rl_error()));
    }

    /** A copy. */
    result(part, what, Type, size) {
        const count = this.module._rl_result_count(part, what) * size;
        return new Type(this.module.HEAPU8.buffer, this.module._rl_result(part, what) >>> 0, count).slice();
    }
}

class Attributes {
    #module;
    constructor(module) { this.#module = module; }

    computeAttributes(parts, options = {}) {
        checkNames(options, ['scope', 'weight', 'crease', 'weldDistance', 'tangents', 'tangentMode', 'keepNormals', 'groupsAcross']);
        const { scope = 'model', weight = 'auto', crease = 'auto', weldDistance = -1, tangents = true, tangentMode = 'averaged',
                keepNormals = false, groupsAcross = false } = options;
        return this.#run(parts, all => {
            all.check(this.#module._rl_compute_attributes(numberOf(scopes, scope, 'scope'), numberOf(weights, weight, 'weight'),
                ...creasesOf(crease), weldDistance, tangents ? 1 : 0, numberOf(tangentModes, tangentMode, 'tangentMode'),
                keepNormals ? 1 : 0, groupsAcross ? 1 : 0));
            return parts.map((part, i) => made(all, part, i));
        });
    }

    joinSeams(parts, options = {}) {
        checkNames(options, ['crease', 'weldDistance']);
        const { crease = 'auto', weldDistance = -1 } = options;
        return this.#run(parts, all => {
            all.check(this.#module._rl_join_seams(...creasesOf(crease), weldDistance));
            const [normals, turned, largestDegrees, meanDegrees, unusable] = [0, 1, 2, 3, 4].map(i => this.#module._rl_report(i));
            return {
                parts: parts.map((_, i) => ({ vertices: all.result(i, 5, Uint32Array, 1), normals: all.result(i, 6, Float32Array, 3) })),
                report: { normals, turned, largestDegrees, meanDegrees, unusable },
            };
        });
    }

    /** The memory of the call is free again after it. */
    #run(parts, run) {
        if (!Array.isArray(parts)) throw new AttributesError('parts must be an array of parts');
        try {
            return run(new Parts(this.#module, parts));
        } finally {
            this.#module._rl_clear();
        }
    }
}

function made(all, part, i) {
    const indices = all.result(i, 3, Uint32Array, 1);
    const result = {
        normals: all.result(i, 0, Float32Array, 3),
        indices: indices.length ? indices : Uint32Array.from(part.indices ?? { length: part.positions.length / 3 }, (v, k) => v ?? k),
        sourceVertices: all.result(i, 4, Uint32Array, 1),
    };
    const tangents = all.result(i, 1, Float32Array, 4), bitangents = all.result(i, 2, Float32Array, 3);
    if (tangents.length) result.tangents = tangents;
    if (bitangents.length) result.bitangents = bitangents;
    return result;
}

/** Loads the module. One is enough for a program; its calls do not run at the same time. */
export async function loadAttributes({ locateFile, wasmBinary } = {}) {
    return new Attributes(await makeModule({ ...(locateFile && { locateFile }), ...(wasmBinary && { wasmBinary }) }));
}
