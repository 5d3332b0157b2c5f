// SPDX-License-Identifier: Apache-2.0
// Options are those of the program in camel case: creaseAngle: 60 is --crease-angle 60, allowOutside: true is --allow-outside.
import type * as program from './program_options.js';
import type { CompareRow, ExplainRow, InspectRow, RenderRow, Report, SmoothRow } from './reports.js';

export type { OptionValue } from './program_options.js';
export type * from './reports.js';

/** The content of a file. GLB, PLY and PNG files need no name. */
export type Bytes = Uint8Array | ArrayBuffer;

/** Bytes in a buffer of their own. */
export type OwnBytes = ReturnType<Uint8Array['slice']>;

/** A file, and those that it names (buffers, textures, materials), by their paths relative to it. */
export interface File {
    name: string;
    bytes: Bytes;
    files?: Record<string, Uint8Array>;
}

export type Input = Bytes | File;

/** What is set by the functions themselves, or is of folders, terminals and threads. */
type Set = 'output' | 'json' | 'quiet' | 'verbose' | 'watch' | 'recursive' | 'asOne' | 'format' | 'threads';

export interface InspectOptions extends Omit<program.InspectOptions, Set | 'report' | 'junit' | 'heatmap' | 'heatmapLegend'> {}

export interface SmoothOptions extends Omit<program.SmoothOptions, Set | 'preview' | 'apart' | 'scope'> {
    /** What is written. Default: the model's own format; GLB if that cannot be written. */
    format?: 'glb' | 'gltf' | 'obj' | 'ply';
}

type OfMorePictures = 'channels' | 'channelFiles' | 'exrColors' | 'frames' | 'fps' | 'turntable' | 'movie' | 'skipExisting' | 'keepFrames';
type OfReferences = 'ref' | 'refMeasure' | 'refThreshold' | 'refDiff';

export interface RenderOptions extends Omit<program.RenderOptions, Set | OfMorePictures | OfReferences | 'stats' | 'keepPartial'> {
    /** What is written. Default: 'png'. */
    format?: 'png' | 'jpg' | 'ppm' | 'hdr';
}

export interface CompareOptions extends Omit<program.CompareOptions, Set | 'difference' | 'gain' | 'engines'> {}

export interface ExplainOptions extends Omit<program.ExplainOptions, Set | 'pixel'> {
    /** From the left and from the top; 0,0 is the top left pixel. */
    pixel: readonly [x: number, y: number] | string;
}

/** A report with what the limits say. */
export type Checked<R extends Report> = R & {
    /** Whether all limits of the options hold. */
    passed: boolean;
};

export type InspectReport = Checked<Report<InspectRow>>;
export type CompareReport = Checked<Report<CompareRow>>;
export type SmoothReport = Report<SmoothRow>;
export type RenderReport = Report<RenderRow>;
export type ExplainReport = Report<ExplainRow>;

export interface Smoothed {
    bytes: OwnBytes;
    /** By their names: the model, and what was written beside it. */
    files: Record<string, OwnBytes>;
    report: SmoothReport;
}

export interface Rendered {
    bytes: OwnBytes;
    report: RenderReport;
}

/** What is in a model, and its seams. Limits need `check: true`. @throws RakelightError */
export function inspect(model: Input, options?: InspectOptions): Promise<InspectReport>;
/** The model with seam-free normals. @throws RakelightError */
export function smooth(model: Input, options?: SmoothOptions): Promise<Smoothed>;
/** A picture of the engine soft. @throws RakelightError */
export function render(model: Input, options?: RenderOptions): Promise<Rendered>;
/** Two pictures, or a picture and a model. @throws RakelightError, also if they differ in size */
export function compare(first: Input, second: Input, options?: CompareOptions): Promise<CompareReport>;
/** Why a pixel has its color. @throws RakelightError */
export function explain(model: Input, options: ExplainOptions): Promise<ExplainReport>;

export interface LoadOptions {
    /** Where the .wasm file is. @param name of the file @param folder of the script */
    locateFile?: (name: string, folder: string) => string;
    /** The content of the .wasm file. */
    wasmBinary?: ArrayBuffer | Uint8Array;
    /** Decoders of compressed models, as their npm packages have them. */
    decoders?: {
        /** MeshoptDecoder of the package meshoptimizer; await its `ready`. */
        meshopt?: { decodeGltfBuffer(target: Uint8Array, count: number, size: number, source: Uint8Array, mode: string, filter?: string): void };
        /** What createDecoderModule() of the package draco3dgltf resolves to. */
        draco?: object;
    };
}

/** Where the .wasm file comes from, before the first call; and decoders of compressed models. */
export function configure(options: LoadOptions): void;

export class RakelightError extends Error {
    constructor(message: string, details: { exitCode: number; code: string; file?: string; place?: string; advice?: string });
    /** That of the program: 1 failed, 2 usage, 3 not found, 4 bad file, 5 not comparable. */
    exitCode: number;
    code: 'failed' | 'usage' | 'not_found' | 'bad_file' | 'check_failed';
    /** Of the input; empty if not known. */
    file: string;
    /** Where in the file, and what to do; empty if not known. */
    place: string;
    advice: string;
}
