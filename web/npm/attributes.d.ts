// SPDX-License-Identifier: Apache-2.0

/** A part of a model, placed in the world. Arrays are copied in. */
export interface Part {
    /** Three numbers a vertex, in the part's own space. */
    positions: Float32Array | readonly number[];
    /** Three a triangle, counter-clockwise seen from outside. Without them every three vertices are a triangle. */
    indices?: Uint32Array | Uint16Array | Uint8Array | readonly number[];
    /** Three numbers a vertex: what joinSeams() joins, and what keepNormals keeps. */
    normals?: Float32Array | readonly number[];
    /** Two numbers a vertex, v down as in glTF. Tangents are computed for parts that have them. */
    texcoords?: Float32Array | readonly number[];
    /** One number a triangle, as in OBJ: equal numbers are smooth, 0 is flat. */
    smoothingGroups?: Uint32Array | readonly number[];
    /** From the part to the world, 16 numbers by columns, as in glTF and three.js. Default: none. */
    matrix?: ArrayLike<number>;
    /** Parts of one number are one object (scope 'object'). Default: each is its own. */
    object?: number;
    /** Step of quantized positions, in the part's own space. */
    positionStep?: number;
    /** Degrees 0 to 180, in place of the option. */
    crease?: number;
}

export interface AttributeOptions {
    /** Over which faces normals are smoothed. Default: 'model'. */
    scope?: 'face' | 'object' | 'model';
    /** Default: 'auto', which chooses at each place. */
    weight?: 'auto' | 'uniform' | 'area' | 'angle' | 'angle-area' | 'max' | 'fit';
    /** 'auto' decides edge by edge; a number: faces that differ by more degrees are not smoothed. Default: 'auto'. */
    crease?: 'auto' | number;
    /** In the world's unit; negative: what rounding can have parted. Default: -1. */
    weldDistance?: number;
    /** Default: true, of parts with texture coordinates. */
    tangents?: boolean;
    tangentMode?: 'averaged' | 'published' | 'mikktspace' | 'published-no-handedness';
    /** Only tangents are computed; every part must have normals. */
    keepNormals?: boolean;
    /** Smoothing groups also join faces of different objects. */
    groupsAcross?: boolean;
}

/** Vertices 0 to V - 1 are those of the input; where the corners of a vertex differ, copies are appended. */
export interface PartAttributes {
    /** Three numbers a vertex, unit length. */
    normals: Float32Array;
    /** Four numbers a vertex: unit tangent, and the side of the bitangent. */
    tangents?: Float32Array;
    /** Of the modes 'published'. */
    bitangents?: Float32Array;
    indices: Uint32Array;
    /** For each appended vertex, the one that it copies: all other attributes of it, and its morph targets, are to be copied. */
    sourceVertices: Uint32Array;
}

export interface SeamOptions {
    crease?: 'auto' | number;
    weldDistance?: number;
}

export interface PartSeams {
    /** The vertices whose normals turned, ascending. */
    vertices: Uint32Array;
    /** Their normals, three numbers each. */
    normals: Float32Array;
}

export interface SeamReport {
    normals: number;
    turned: number;
    largestDegrees: number;
    meanDegrees: number;
    /** Normals that are zero or not finite, and stay. */
    unusable: number;
}

export interface Attributes {
    /** Normals and tangents anew. @throws AttributesError */
    computeAttributes(parts: readonly Part[], options?: AttributeOptions): PartAttributes[];
    /** Keeps the normals of the parts, and makes them equal where parts meet. @throws AttributesError */
    joinSeams(parts: readonly Part[], options?: SeamOptions): { parts: PartSeams[]; report: SeamReport };
}

export interface LoadOptions {
    /** Where the .wasm file is. @param name of the file @param folder of the script */
    locateFile?: (name: string, folder: string) => string;
    /** The content of the .wasm file. */
    wasmBinary?: ArrayBuffer | Uint8Array;
}

export function loadAttributes(options?: LoadOptions): Promise<Attributes>;

/** An error of the input; its message has the part and the place. */
export class AttributesError extends Error {}
