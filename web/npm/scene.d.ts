// SPDX-License-Identifier: Apache-2.0
// Types of whole documents. Neither three nor @gltf-transform/core need be installed: what is used of them is named here.
import type { LoadOptions } from './attributes.js';

export { AttributesError } from './attributes.js';
export type { LoadOptions } from './attributes.js';

export interface SmoothSeamsOptions {
    /**
     * 'seams' keeps the normals that are there, joins them where parts meet and makes those that are missing. The others replace all: 'model'
     * smooths over all parts, 'object' over each by itself, 'face' makes flat faces. Default: 'seams'.
     */
    normals?: 'seams' | 'model' | 'object' | 'face';
    /** 'auto' decides edge by edge; a number: faces that differ by more degrees, 0 to 180, are not smoothed. Default: 'auto'. */
    crease?: 'auto' | number;
    /** Of the faces around a vertex. Default: 'auto', which chooses at each vertex. */
    weight?: 'auto' | 'uniform' | 'area' | 'angle' | 'angle-area' | 'max' | 'fit';
    /** Up to which distance vertices of different parts are at one place, in the world's unit; negative: what rounding can have parted. Default: -1. */
    weldDistance?: number;
    /** Also borders that run beside each other without common vertices, at most this far apart, in the world's unit. Default: 0, none. */
    borderDistance?: number;
    /**
     * 'auto': tangents turn with their normals; where normals are replaced they are made anew, if there were any or there is a normal map.
     * 'always': wherever there are texture coordinates. 'never': none are left. Default: 'auto'.
     */
    tangents?: 'auto' | 'always' | 'never';
    /** Averaged tangents, and bitangents as the attribute _BITANGENT. Default: false. */
    bitangents?: boolean;
    /** Nodes that share a mesh go on sharing it, with the normals of the first, also where their neighbors differ. Default: false. */
    keepInstances?: boolean;
    /** Called once, after the document or the object has changed. */
    onReport?: (report: SmoothSeamsReport) => void;
}

/** Angles are in degrees, in world space. */
export interface SmoothSeamsReport {
    /** Whether anything changed. */
    changed: boolean;
    /** Of normals 'seams', where normals were there. */
    seams?: {
        /** How many normals faces use. */
        normals: number;
        /** How many of them turned. */
        turned: number;
        largestDegrees: number;
        meanDegrees: number;
        /** Pairs of flat faces of two meshes that keep their edge. */
        flatPairs: number;
        /** Pairs of faces of two meshes that keep an authored crease. */
        creasePairs: number;
        /** Always 0: normals that are zero or not finite are made anew, which made counts. */
        unusable: number;
    };
    /** Vertices without a usable normal that got one. */
    made: number;
    /** Of `borderDistance`: vertices that turned, and how far. */
    borders: { turned: number; largestDegrees: number; meanDegrees: number };
    remarks: SmoothSeamsRemark[];
}

export interface SmoothSeamsRemark {
    /** 'dropped': something is left out or lost. */
    kind: 'note' | 'changed' | 'guessed' | 'dropped' | 'warning';
    /** How often. */
    count: number;
    /** The mesh, geometry or object; empty: no one place. */
    place: string;
    text: string;
}

/** What is used of a Document of @gltf-transform/core, version 4. */
export interface DocumentLike {
    getRoot(): { getDefaultScene(): object | null; listScenes(): object[]; listNodes(): object[]; listBuffers(): object[] };
    getLogger(): { debug(text: string): void; warn(text: string): void };
    createAccessor(name?: string): object;
    createBuffer(name?: string): object;
}

/** What is used of an Object3D of three.js. */
export interface Object3DLike {
    readonly isObject3D: boolean;
    updateWorldMatrix(updateParents: boolean, updateChildren: boolean): void;
    traverseVisible(callback: (object: any) => void): void;
}

/**
 * The visible meshes of an object and of all below it, where they are in the world. Geometries change in place; meshes that share one and need
 * different normals get copies. @throws AttributesError, before anything has changed
 */
export function smoothSeams(object: Object3DLike, options?: SmoothSeamsOptions): Promise<SmoothSeamsReport>;
/** A transform for document.transform(): the default scene, or the first. Remarks go to the document's logger. */
export function smoothSeams(options?: SmoothSeamsOptions): (document: DocumentLike) => Promise<void>;

/** Where the .wasm file comes from; before the first call. */
export function configure(options: LoadOptions): void;
