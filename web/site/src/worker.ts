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

const endings = ['gltf', 'glb', 'obj', 'ply'];  // that fix() keeps; others become GLB
const goneAfterMs = 5000;                      // a lost context is not waited for any longer

/** A model in memory: its files, and those that fix() writes, each in a folder of its own. */
interface Opened {
    name: string;
    folder: string;
    fixed: string;
}

let module: PageModule;
let canvas: OffscreenCanvas;
let context = 0;  // of WebGL; 0: the engine soft draws
let isLost = false;
let loserOfContext: WEBGL_lose_context | null = null;
let pen: OffscreenCanvasRenderingContext2D | undefined;  // without WebGL
let scaled: OffscreenCanvas | undefined;                 // the picture of the engine soft, as large as it is
let current: Opened | undefined;
let opened = 0;  // models so far

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

/** Whether the engine gl can draw here. A canvas that once had WebGL has no other context. */
function hasWebGL(): boolean {
    const probe = new OffscreenCanvas(1, 1).getContext('webgl2'), can = Boolean(probe?.getExtension('EXT_color_buffer_float'));
    probe?.getExtension('WEBGL_lose_context')?.loseContext();
    return can;
}

/** @throws Failure: OpenGL does not begin, and the canvas is of no more use */
function startContext(): void {
    context = module.GL.createContext(canvas, attributes);
    if (!context) return post({ kind: 'context', state: 'gone' });
    module.GL.makeContextCurrent(context);
    const { GLctx } = module.GL.getContext(context);  // Firefox: no second canvas.getContext()
    GLctx.getExtension('WEBGL_debug_renderer_info');
    loserOfContext = GLctx.getExtension('WEBGL_lose_context');
    try {
        run('rl_start_gl');
    } catch (fault) {
        endContext();
        post({ kind: 'context', state: 'gone' });
        throw fault;
    }
}

function endContext(): void {
    if (!context) return;
    module.ccall('rl_end_gl', null, [], []);
    module.GL.deleteContext(context);
    context = 0;
}

function watchContext(): void {
    const own = canvas;
    own.addEventListener('webglcontextlost', event => {
        event.preventDefault();  // so that it comes back
        endContext();
        isLost = true;
        post({ kind: 'context', state: 'lost' });
        setTimeout(() => {
            if (isLost && canvas === own) post({ kind: 'context', state: 'gone' });
        }, goneAfterMs);
    });
    own.addEventListener('webglcontextrestored', () => {
        if (canvas !== own) return;
        isLost = false;
        startContext();
        post({ kind: 'context', state: 'there' });
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

async function writeFiles(folder: string, model: Model): Promise<void> {
    module.FS.mkdirTree(folder);
    let at = 0;
    for (const { path, bytes } of model.files) {
        post({ kind: 'progress', stage: 'read', share: at++ / model.files.length });
        const place = `${folder}/${path}`;
        module.FS.mkdirTree(place.slice(0, place.lastIndexOf('/')));
        module.FS.writeFile(place, new Uint8Array(bytes instanceof Blob ? await bytes.arrayBuffer() : bytes), { canOwn: true });
    }
}

function removeFiles({ folder, fixed }: Opened): void {
    removeFolder(folder);
    removeFolder(fixed);
}

/** Where a decoder is missing, it is loaded, and the call is made again. */
async function withDecoders<T>(call: () => T): Promise<T> {
    for (;;)
        try {
            return call();
        } catch (fault) {
            const missing = module.missingDecoder;
            if (!missing || module.decoders?.[missing]) throw fault;
            module.decoders = { ...module.decoders, [missing]: await decoderFor(missing) };
        }
}

function callDraw(view: View): void {
    run('rl_draw', view.width, view.height, Math.round(view.split * view.width), marksOf(view), view.isMoving ? 1 : 0);
}

function drawSoft(view: View): void {
    pen ??= canvas.getContext('2d')!;
    callDraw(view);
    const [at, width, height] = ['rl_soft_picture', 'rl_soft_width', 'rl_soft_height'].map(name => module.ccall(name, 'number', [], []) as number) as [number, number, number];
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
        if (hasWebGL()) startContext();
        if (context) watchContext();
        return text('rl_renderer');
    },
    useSoft(offscreen) {
        canvas = offscreen;
        pen = undefined;
        isLost = false;
    },
    async open(model) {
        opened += 1;
        const folder = `/model/${opened}`, next: Opened = { name: model.name, folder, fixed: `/fixed/${opened}` };
        try {
            await writeFiles(folder, model);
            module.FS.chdir(folder);  // where settings find files
            const inspected = await withDecoders(() => row<InspectRow>('rl_open', model.name.startsWith('builtin:') ? model.name : `${folder}/${model.name}`));
            if (current) removeFiles(current);
            current = next;
            return inspected;
        } catch (fault) {
            module.FS.chdir(current?.folder ?? '/');
            removeFiles(next);
            throw fault;
        }
    },
    examine() {
        if (current) removeFolder(current.fixed);
        return row<InspectRow>('rl_examine');
    },
    fix() {
        const { name: path, fixed } = current!, name = path.replace(/^builtin:([a-z]+).*$/, '$1.glb').replace(/^.*\//, '');
        const ending = name.slice(name.lastIndexOf('.') + 1).toLowerCase();
        removeFolder(fixed);
        module.FS.mkdirTree(fixed);
        const output = `${fixed}/${endings.includes(ending) ? name : `${name.replace(/\.[^.]*$/, '')}.glb`}`;
        const smoothed = row<SmoothRow>('rl_smooth', output);
        return { smoothed, inspected: row<InspectRow>('rl_open_fixed', output) };
    },
    fixedFiles: () => (current && module.FS.analyzePath(current.fixed).exists ? filesBelow(current.fixed) : []),
    set: (side, version, channel, settings) => run('rl_set', sideNumber(side), versionNumber(version), channel, settingsText(settings)),
    draw(view) {
        const begin = performance.now();
        if (canvas.width !== view.width) canvas.width = view.width;
        if (canvas.height !== view.height) canvas.height = view.height;
        if (context) callDraw(view);
        else if (!isLost) drawSoft(view);
        return { took: performance.now() - begin, isCoarse: module.ccall('rl_is_coarse', 'number', [], []) === 1 };
    },
    turn: (dx, dy) => run('rl_turn', dx, dy),
    pan: (dx, dy) => run('rl_pan', dx, dy),
    dolly: factor => run('rl_dolly', factor),
    showWhole: () => run('rl_show_whole'),
    flyToBorder: border => run('rl_fly_to_border', border),
    fly: share => run('rl_fly', share),
    endRakingLight: () => run('rl_end_raking_light'),
    explain(side, width, height, x, y) {
        const explained = row<ExplainRow>('rl_explain', sideNumber(side), width, height, x, y);
        return { row: explained, text: text('rl_explain_text').replace(/\/(model|fixed)\/\d+\//g, '') };
    },
    heatColors: degrees => degrees.map(angle => `#${(module.ccall('rl_heat_color', 'number', ['number'], [angle]) as number).toString(16).padStart(6, '0')}`),
    memory: () => ({ bytes: module.HEAPU8.byteLength, files: filesBelow('/model').length + filesBelow('/fixed').length, objects: objectCount() }),
    loseContext: () => loserOfContext?.loseContext(),
    restoreContext: () => loserOfContext?.restoreContext(),
};

/** Names of OpenGL that are in use. */
function objectCount(): number {
    const { buffers, textures, programs, framebuffers, renderbuffers, vaos, samplers } = module.GL;
    return [buffers, textures, programs, framebuffers, renderbuffers, vaos, samplers].reduce((sum, names) => sum + names.filter(Boolean).length, 0);
}

/** What is no error of the library's. Errors of files in memory are plain objects. */
function outside(fault: unknown): Fault {
    const { message, errno } = fault as { message?: string; errno?: number };
    if (fault instanceof WebAssembly.RuntimeError || fault instanceof RangeError)
        return { message: `the library stopped (${message ?? ''}) and was started again: the model may need more memory than a browser gives`, file: '', place: '', advice: '', code: 'crashed' };
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
