// SPDX-License-Identifier: Apache-2.0
// What emscripten makes of web/page: build/web/page/rakelight-page.mjs.
type Value = string | number;

interface FileSystem {
    analyzePath(path: string): { exists: boolean };
    readdir(path: string): string[];
    stat(path: string): { mode: number };
    isDir(mode: number): boolean;
    unlink(path: string): void;
    rmdir(path: string): void;
    mkdirTree(path: string): void;
    writeFile(path: string, bytes: Uint8Array, options: { canOwn: boolean }): void;
    readFile(path: string): Uint8Array<ArrayBuffer>;
    chdir(path: string): void;
}

export interface Decoders {
    draco?: unknown;
    meshopt?: unknown;
}

export interface PageModule {
    ccall(name: string, returns: 'string' | 'number' | null, types: readonly string[], values: readonly Value[]): Value | null;
    FS: FileSystem;
    GL: {
        createContext(canvas: OffscreenCanvas, attributes: object): number;
        getContext(context: number): { GLctx: WebGL2RenderingContext };
        makeContextCurrent(context: number): boolean;
        deleteContext(context: number): void;
        /** By their names; null: free. */
        buffers: unknown[];
        textures: unknown[];
        programs: unknown[];
        framebuffers: unknown[];
        renderbuffers: unknown[];
        vaos: unknown[];
        samplers: unknown[];
    };
    HEAPU8: Uint8Array<ArrayBuffer>;
    decoders?: Decoders;
    /** The decoder that the last model needed and that was not there. */
    missingDecoder?: keyof Decoders;
}

export default function makeModule(options: { onProgress(stage: string, share: number): void }): Promise<PageModule>;
