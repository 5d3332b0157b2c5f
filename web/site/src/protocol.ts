// SPDX-License-Identifier: Apache-2.0
// What the page and its worker say to each other.
import type { ExplainRow, InspectRow, SmoothRow } from '../../npm/reports.js';

/** A file of a model, by its path below the model's folder. */
export interface ModelFile {
    path: string;
    bytes: ArrayBuffer | Blob;
}

/** The model and what lies beside it; or the name of a built-in shape, such as "builtin:teapot". */
export type Model = { name: string; files: ModelFile[] };

/** Keys of [render] in world files with their values; undefined: as the model has it. */
export type Settings = Record<string, string | undefined>;

export interface View {
    /** [px] of the canvas */
    width: number;
    height: number;
    /** 0..1 where the right picture begins; 1: there is none */
    split: number;
    seams: boolean;
    hardEdges: boolean;
    isMoving: boolean;
}

/** Each model has two versions: as it is, and fixed. The left picture shows one of them, and the right one. */
export type Side = 'left' | 'right';
export type Version = 'original' | 'fixed';

export interface Explanation {
    row: ExplainRow;
    text: string;
}

export interface Drawn {
    /** [ms] */
    took: number;
    /** The picture is a first one, coarse; the next call draws the whole one. */
    isCoarse: boolean;
}

/** The calls that the worker answers. */
export interface Calls {
    /** @returns what draws: the name of the GPU, or '' for the engine soft */
    start(canvas: OffscreenCanvas): string;
    /** Draws into another canvas from now on, without WebGL. */
    useSoft(canvas: OffscreenCanvas): void;
    /** On errors the model before stays. */
    open(model: Model): InspectRow;
    /** The same model by the settings of now; what fix() made is forgotten. */
    examine(): InspectRow;
    /** Smooths the model; the right picture shows the result then. */
    fix(): { smoothed: SmoothRow; inspected: InspectRow };
    /** All files that fix() wrote. */
    fixedFiles(): Array<{ path: string; bytes: Uint8Array<ArrayBuffer> }>;
    /** @param channel  shown instead of the colors; '': colors */
    set(side: Side, version: Version, channel: string, settings: Settings): void;
    draw(view: View): Drawn;
    /** Of the picture's smaller side: half a turn for all of it. */
    turn(dx: number, dy: number): void;
    /** Of the picture's height. */
    pan(dx: number, dy: number): void;
    dolly(factor: number): void;
    showWhole(): void;
    /** Puts a light there that grazes the surface. fly() leads to it. */
    flyToBorder(border: number): void;
    /** @param share  0..1 of the way */
    fly(share: number): void;
    endRakingLight(): void;
    /** [px] of the picture, and in it */
    explain(side: Side, width: number, height: number, x: number, y: number): Explanation;
    /** CSS colors of the heat map. */
    heatColors(degrees: number[]): string[];

    // For tests: what the worker holds, and a context that is taken away and given back.
    memory(): { bytes: number; files: number; objects: number };
    loseContext(): void;
    restoreContext(): void;
}

export type CallName = keyof Calls;

/** An error as the program reports it. */
export interface Fault {
    message: string;
    file: string;
    place: string;
    advice: string;
    code: string;
}

export interface Request {
    id: number;
    call: CallName;
    arguments: unknown[];
}

export type Message =
    | { kind: 'result'; id: number; result: unknown }
    | { kind: 'fault'; id: number; fault: Fault }
    | { kind: 'progress'; stage: string; share: number }
    /** The context of WebGL was lost; is there again, and the picture must be drawn; is gone, and only useSoft() helps. */
    | { kind: 'context'; state: ContextState };

export type ContextState = 'lost' | 'there' | 'gone';
