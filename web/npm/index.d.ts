// SPDX-License-Identifier: Apache-2.0

/** The content of a file. GLB, PLY and PNG files need no name. */
export type Bytes = Uint8Array | ArrayBuffer;

/** A file, and those that it names (buffers, textures, materials), by their paths relative to it. */
export interface File {
    name: string;
    bytes: Bytes;
    files?: Record<string, Uint8Array>;
}

export type Input = Bytes | File;

/** Options of the program in camel case: creaseAngle: 60 is --crease-angle 60, allowOutside: true is --allow-outside. */
export type Options = Record<string, string | number | boolean | readonly number[] | undefined>;

/** What `rakelight VERB --json` writes. */
export interface Report {
    schema: string;
    rows: Array<Record<string, unknown>>;
    [key: string]: unknown;
}

export interface Checked extends Report {
    /** Whether all limits of the options hold. */
    passed: boolean;
}

export interface Smoothed {
    bytes: Uint8Array;
    /** With what was written beside the model. */
    files: Record<string, Uint8Array>;
    report: Report;
}

export interface Rendered {
    bytes: Uint8Array;
    report: Report;
}

/** What is in a model, and its seams. @throws RakelightError */
export function inspect(model: Input, options?: Options): Promise<Checked>;
/** The model with seam-free normals, in its own format or that of `format`: glb, gltf, obj, ply. @throws RakelightError */
export function smooth(model: Input, options?: Options & { format?: 'glb' | 'gltf' | 'obj' | 'ply' }): Promise<Smoothed>;
/** A picture of the engine soft. @throws RakelightError */
export function render(model: Input, options?: Options & { format?: 'png' | 'jpg' | 'ppm' | 'hdr' }): Promise<Rendered>;
/** Two pictures, or a picture and a model. @throws RakelightError */
export function compare(first: Input, second: Input, options?: Options): Promise<Checked>;
/** Why a pixel has its color: { pixel: [x, y] }. @throws RakelightError */
export function explain(model: Input, options?: Options): Promise<Report>;

export interface LoadOptions {
    /** Where the .wasm file is. @param name of the file @param folder of the script */
    locateFile?: (name: string, folder: string) => string;
    /** The content of the .wasm file. */
    wasmBinary?: ArrayBuffer | Uint8Array;
}

/** Where the .wasm file comes from; before the first call. */
export function configure(options: LoadOptions): void;

export class RakelightError extends Error {
    /** That of the program: 1 failed, 2 usage, 3 not found, 4 bad file. */
    exitCode: number;
    code: string;
    /** Where in the file, and what to do; empty if not known. */
    place?: string;
    advice?: string;
}
