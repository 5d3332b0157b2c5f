// SPDX-License-Identifier: Apache-2.0
// The library in a worker: it reads, examines, smooths and draws, so that the page never waits.
import type { ExplainRow, InspectRow, SmoothRow } from '../../npm/reports.js';
import { decoderFor } from './decoders.js';
import makeModule, { type PageModule } from './page_module.js';
import type { Calls, CallName, Fault, Message, Model, Request, Settings, Side, Version, View } from './protocol.js';

class Failure extends Error {
    constructor(readonly fault: Fault) {
        super(fault.message);
    }
}

const folder = '/model', fixedFolder = '/fixed';
const endings = ['gltf', 'glb', 'obj', 'ply'];  // that fix() keeps; others become GLB

let module: PageModule;
let canvas: OffscreenCanvas;
let context = 0;  // of WebGL; 0: the engine soft draws
let current: Model | undefined;
let scaled: OffscreenCanvas | undefined;  // of coarse pictures
let loserOfContext: WEBGL_lose_context | null = null;
let pen: OffscreenCanvasRenderingContext2D | undefined;  // without WebGL

const post = (message: Message, transfer: Transferable[] = []): void => self.postMessage(message, { transfer });

const types = { string: 'string', number: 'number' } as const;

/** @returns the text that a function of the module gives */
function text(name: string, ...values: Array<string | number>): string {
    return module.ccall(name, 'string', values.map(value => types[typeof value as 'string' | 'number']), values) as string;
}

interface Report {
    rows: Array<{ error?: Fault }>;
}

/** Runs a function that reports. */
function row<T>(name: string, ...values: Array<string | number>): T {
    const report = JSON.parse(text(name, ...values)) as Report, first = report.rows[0]!;
    if (first.error) throw new Failure(first.error);
    return first as T;
}

/** Runs a function that reports errors alone. */
function run(name: string, ...values: Array<string | number>): void {
    const said = text(name, ...values);
    if (said) throw new Failure((JSON.parse(said) as Report).rows[0]!.error!);
}

const settingsText = (settings: Settings): string =>
    Object.entries(settings).filter(([, value]) => value !== undefined).map(([key, value]) => `${key}\t${value}\n`).join('');

const attributes = { majorVersion: 2, minorVersion: 0, alpha: false, depth: false, stencil: false, antialias: false, preserveDrawingBuffer: false, powerPreference: 'high-performance' };

function startContext(): void {
    context = module.GL.createContext(canvas, attributes);
    if (!context) return;
    module.GL.makeContextCurrent(context);
    module.GL.getContext(context).GLctx.getExtension('WEBGL_debug_renderer_info');  // Firefox: no second canvas.getContext()
    loserOfContext = module.GL.getContext(context).GLctx.getExtension('WEBGL_lose_context');
    try {
        run('rl_start_gl');
    } catch {
        endContext();
    }
}

function endContext(): void {
    if (!context) return;
    module.ccall('rl_end_gl', null, [], []);
    module.GL.deleteContext(context);
    context = 0;
}

function watchContext(): void {
    canvas.addEventListener('webglcontextlost', event => {
        event.preventDefault();  // so that it comes back
        endContext();
        post({ kind: 'context', isThere: false });
    });
    canvas.addEventListener('webglcontextrestored', () => {
        startContext();
        post({ kind: 'context', isThere: true });
    });
}

function removeFolder(place: string): void {
    if (!module.FS.analyzePath(place).exists) return;
    for (const name of module.FS.readdir(place)) {
        if (name === '.' || name === '..') continue;
        const path = `${place}/${name}`;
        if (module.FS.isDir(module.FS.stat(path).mode)) removeFolder(path);
        else module.FS.unlink(path);
    }
    module.FS.rmdir(place);
}

function filesBelow(place: string, below = ''): Array<{ path: string; bytes: Uint8Array<ArrayBuffer> }> {
    return module.FS.readdir(place).filter(name => name !== '.' && name !== '..').flatMap(name => {
        const path = `${place}/${name}`;
        return module.FS.isDir(module.FS.stat(path).mode) ? filesBelow(path, `${below}${name}/`)
                                                          : [{ path: below + name, bytes: module.FS.readFile(path) }];
    });
}

async function writeFiles(model: Model): Promise<void> {
    module.FS.chdir('/');
    removeFolder(folder);
    removeFolder(fixedFolder);
    module.FS.mkdirTree(folder);
    module.FS.mkdirTree(fixedFolder);
    let at = 0;
    for (const { path, bytes } of model.files) {
        post({ kind: 'progress', stage: 'read', share: at++ / model.files.length });
        const place = `${folder}/${path}`;
        module.FS.mkdirTree(place.slice(0, place.lastIndexOf('/')));
        module.FS.writeFile(place, new Uint8Array(bytes instanceof Blob ? await bytes.arrayBuffer() : bytes));
    }
    module.FS.chdir(folder);
}

/** Where a decoder is missing, it is loaded, and the call is made again. */
async function withDecoders<T>(call: () => T): Promise<T> {
    try {
        return call();
    } catch (fault) {
        const missing = module.missingDecoder;
        if (!missing || module.decoders?.[missing]) throw fault;
        module.decoders = { ...module.decoders, [missing]: await decoderFor(missing) };
        return call();
    }
}

function drawSoft(view: View): void {
    pen ??= canvas.getContext('2d')!;
    const coarser = view.isMoving ? 3 : 1;
    const width = Math.max(1, Math.round(view.width / coarser)), height = Math.max(1, Math.round(view.height / coarser));
    run('rl_draw', width, height, Math.round(view.split * width), marksOf(view), view.isMoving ? 1 : 0);
    const at = module.ccall('rl_soft_picture', 'number', [], []) as number;
    const codes = new Uint8ClampedArray(module.HEAPU8.slice(at, at + 4 * width * height).buffer);
    scaled ??= new OffscreenCanvas(width, height);
    scaled.width = width;
    scaled.height = height;
    scaled.getContext('2d')!.putImageData(new ImageData(codes, width, height), 0, 0);
    pen.drawImage(scaled, 0, 0, view.width, view.height);
}

const marksOf = (view: View): number => (view.seams ? 1 : 0) + (view.hardEdges ? 2 : 0);

const sideNumber = (side: Side): number => (side === 'right' ? 1 : 0);
const versionNumber = (version: Version): number => (version === 'fixed' ? 1 : 0);

const calls: { [name in CallName]: (...given: Parameters<Calls[name]>) => ReturnType<Calls[name]> | Promise<ReturnType<Calls[name]>> } = {
    async start(offscreen) {
        canvas = offscreen;
        module = await makeModule({ onProgress: (stage, share) => post({ kind: 'progress', stage, share }) });
        startContext();
        if (context) watchContext();
        return text('rl_renderer');
    },
    async open(model) {
        await writeFiles(model);
        const inspected = await withDecoders(() => row<InspectRow>('rl_open', model.name));
        current = model;
        return inspected;
    },
    fix() {
        const name = current!.name.replace(/^builtin:([a-z]+).*$/, '$1.glb').replace(/^.*\//, '');
        const ending = name.slice(name.lastIndexOf('.') + 1).toLowerCase();
        removeFolder(fixedFolder);
        module.FS.mkdirTree(fixedFolder);
        const output = `${fixedFolder}/${endings.includes(ending) ? name : `${name.replace(/\.[^.]*$/, '')}.glb`}`;
        const smoothed = row<SmoothRow>('rl_smooth', output);
        return { smoothed, inspected: row<InspectRow>('rl_open_fixed', output) };
    },
    fixedFiles: () => filesBelow(fixedFolder),
    set: (side, version, channel, settings) => run('rl_set', sideNumber(side), versionNumber(version), channel, settingsText(settings)),
    draw(view) {
        const begin = performance.now();
        if (canvas.width !== view.width) canvas.width = view.width;
        if (canvas.height !== view.height) canvas.height = view.height;
        if (context) run('rl_draw', view.width, view.height, Math.round(view.split * view.width), marksOf(view), view.isMoving ? 1 : 0);
        else drawSoft(view);
        return performance.now() - begin;
    },
    turn: (dx, dy) => run('rl_turn', dx, dy),
    pan: (dx, dy) => run('rl_pan', dx, dy),
    dolly: factor => run('rl_dolly', factor),
    showWhole: () => run('rl_show_whole'),
    flyToBorder: border => run('rl_fly_to_border', border),
    endRakingLight: () => run('rl_end_raking_light'),
    explain: (side, x, y) => ({ row: row<ExplainRow>('rl_explain', sideNumber(side), x, y), text: text('rl_explain_text', sideNumber(side), x, y) }),
    heatColors: degrees => degrees.map(angle => `#${(module.ccall('rl_heat_color', 'number', ['number'], [angle]) as number).toString(16).padStart(6, '0')}`),
    memory: () => module.HEAPU8.byteLength,
    loseContext: () => loserOfContext?.loseContext(),
    restoreContext: () => loserOfContext?.restoreContext(),
};

/** What is no error of the library's. Errors of files in memory are plain objects. */
function outside(fault: unknown): Fault {
    const { message, errno } = fault as { message?: string; errno?: number };
    return { message: message ?? (errno === undefined ? String(fault) : `the files cannot be kept in memory (error ${errno})`), file: '', place: '', advice: '', code: 'failed' };
}

let last: Promise<void> = Promise.resolve();  // calls are answered one by one, in their order
self.addEventListener('message', ({ data }: MessageEvent<Request>) => {
    last = last.then(async () => {
        const call = calls[data.call] as (...given: unknown[]) => unknown;
        try {
            post({ kind: 'result', id: data.id, result: await call(...data.arguments) });
        } catch (fault) {
            post({ kind: 'fault', id: data.id, fault: fault instanceof Failure ? fault.fault : outside(fault) });
        }
    });
});
