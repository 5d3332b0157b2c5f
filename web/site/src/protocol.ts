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

/** The calls that the worker answers. */
export interface Calls {
    /** @returns what draws: the name of the GPU, or '' for the engine soft */
    start(canvas: OffscreenCanvas): string;
    open(model: Model): InspectRow;
    /** Smooths the model; the right picture shows the result then. */
    fix(): { smoothed: SmoothRow; inspected: InspectRow };
    /** All files that fix() wrote. */
    fixedFiles(): Array<{ path: string; bytes: Uint8Array<ArrayBuffer> }>;
    /** @param channel  shown instead of the colors; '': colors */
    set(side: Side, version: Version, channel: string, settings: Settings): void;
    /** @returns [ms] how long it took */
    draw(view: View): number;
    /** Of the picture's smaller side: half a turn for all of it. */
    turn(dx: number, dy: number): void;
    /** Of the picture's height. */
    pan(dx: number, dy: number): void;
    dolly(factor: number): void;
    showWhole(): void;
    flyToBorder(border: number): void;
    endRakingLight(): void;
    /** [px] of the canvas */
    explain(side: Side, x: number, y: number): Explanation;
    /** CSS colors of the heat map. */
    heatColors(degrees: number[]): string[];
    /** [bytes] that the library holds. */
    memory(): number;
    /** For tests: takes the context away and gives it back. */
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
    /** The context was lost, or is there again: the picture must be drawn. */
    | { kind: 'context'; isThere: boolean };
