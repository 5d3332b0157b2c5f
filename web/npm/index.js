// SPDX-License-Identifier: Apache-2.0
// Bytes of models in; bytes and reports out. The work is the program's: an option is that of the program in camel case
// (creaseAngle: 60 is --crease-angle 60), a report is what --json writes.
import { runProgram } from './program.js';

/** What the program would end with: exit code 1 failed, 2 usage, 3 not found, 4 bad file, 5 not comparable. */
export class RakelightError extends Error {
    name = 'RakelightError';
    constructor(message, { exitCode, code, file = '', place = '', advice = '' }) {
        super(message);
        Object.assign(this, { exitCode, code, file, place, advice });
    }
}

const folder = '/model', outputs = '/outputs';
let loadOptions = {};

const usage = (message, advice = '') => new RakelightError(advice ? `${message}; ${advice}` : message, { exitCode: 2, code: 'usage', advice });

/** Where the .wasm file comes from, before the first call; and decoders of compressed models. */
export function configure(options) {
    for (const key of Object.keys(options))
        if (!['locateFile', 'wasmBinary', 'decoders'].includes(key)) throw usage(`configure() knows no ${JSON.stringify(key)}`, 'locateFile, wasmBinary or decoders');
    if (options.locateFile !== undefined && typeof options.locateFile !== 'function') throw usage('locateFile must be a function');
    for (const [name, decoder] of Object.entries(options.decoders ?? {})) checkDecoder(name, decoder);
    loadOptions = { ...options };
}

function checkDecoder(name, decoder) {
    if (!['draco', 'meshopt'].includes(name)) throw usage(`there is no decoder ${JSON.stringify(name)}`, 'draco or meshopt');
    if (decoder === undefined) return;
    if (name === 'draco' && typeof decoder?.Decoder !== 'function')
        throw usage('decoders.draco is not what createDecoderModule() of draco3dgltf resolves to', 'pass await draco3d.createDecoderModule()');
    if (name === 'meshopt' && typeof decoder?.decodeGltfBuffer !== 'function') throw usage('decoders.meshopt is not MeshoptDecoder of meshoptimizer');
}

const optionName = key => '--' + key.replace(/[A-Z]/g, letter => '-' + letter.toLowerCase());
const optionKey = (_, name) => name.replace(/-([a-z0-9])/g, (_, letter) => letter.toUpperCase());

/** What the program says of its command line, as of options. */
const inJavaScript = text => text.trim().replace(/^rakelight: error: /, '').replace(/;? see rakelight .*$/s, '').replace(/--([a-z][a-z0-9-]*)/g, optionKey);

function wordsOf(options) {
    if (typeof options !== 'object') throw usage('options must be an object');
    for (const key of ['help', 'output', 'json']) if (options && key in options) throw usage(`${key} is not an option here`);
    return Object.entries(options ?? {}).flatMap(([key, value]) => {
        if (value === undefined || value === false || value === null) return value === false ? [optionName(key) + '=off'] : [];
        if (value === true) return [optionName(key)];
        return [optionName(key), Array.isArray(value) || ArrayBuffer.isView(value) ? Array.from(value).join(',') : String(value)];
    });
}

const contains = (bytes, text) => [...text].every((letter, i) => bytes[i] === letter.charCodeAt(0));

/** GLB and PLY say what they are; other bytes need a name. */
function nameOf(bytes) {
    if (bytes.length === 0) throw usage('the model has no bytes');
    if (contains(bytes, 'glTF')) return 'model.glb';
    if (contains(bytes, 'ply')) return 'model.ply';
    if (contains(bytes, '\x89PNG')) return 'picture.png';
    throw usage('the name of the file is missing', 'pass { name, bytes }');
}

/** @returns its bytes as a Uint8Array, or undefined: it holds no bytes */
function bytesOf(given) {
    if (given instanceof ArrayBuffer || given instanceof globalThis.SharedArrayBuffer) return new Uint8Array(given);
    return ArrayBuffer.isView(given) ? new Uint8Array(given.buffer, given.byteOffset, given.byteLength) : undefined;
}

function checkName(name) {
    if (typeof name !== 'string' || name === '') throw usage('the name of the file is missing', 'pass { name, bytes }');
    if (/^[-/]|^builtin:/.test(name) || name.split(/[\\/]/).some(part => ['', '.', '..'].includes(part))) throw usage(`${JSON.stringify(name)} is not a name below the model's folder`);
}

/** @returns {name, files}: all files of the input, by their names beside one another */
function inputOf(input) {
    const bytes = bytesOf(input);
    if (bytes) return { name: nameOf(bytes), files: { [nameOf(bytes)]: bytes } };
    if (typeof input === 'string') throw usage(`${JSON.stringify(input)} is a name, not bytes`, 'pass await readFile(name), or { name, bytes }');
    if (typeof input !== 'object' || input === null || !('bytes' in input) || typeof input.bytes === 'function')
        throw usage('the model is missing', 'pass its bytes as a Uint8Array or ArrayBuffer, or { name, bytes, files }; await promises, and blob.arrayBuffer()');
    const name = input.name ?? nameOf(bytesOf(input.bytes) ?? []);
    const files = Object.entries({ ...input.files, [name]: input.bytes }).map(([file, content]) => {
        checkName(file);
        if (!bytesOf(content)) throw usage(`${file}: its bytes are neither a Uint8Array nor an ArrayBuffer`);
        return [file, bytesOf(content)];
    });
    return { name, files: Object.fromEntries(files) };
}

function putFiles(FS, at, files) {
    for (const [name, bytes] of Object.entries(files)) {
        const path = `${at}/${name}`;
        try {
            FS.mkdirTree(path.slice(0, path.lastIndexOf('/')));
            FS.writeFile(path, bytes);
        } catch {
            throw usage(`${JSON.stringify(name)} cannot be a file beside the others`);
        }
    }
}

function checkFormat(format) {
    if (!/^[a-z0-9]+$/i.test(format)) throw usage(`${JSON.stringify(format)} is no format`);
}

/** @returns [path below the folder, bytes] of all files */
function filesBelow(FS, place, below = '') {
    return FS.readdir(place).filter(name => name !== '.' && name !== '..').flatMap(name => {
        const path = `${place}/${name}`;
        return FS.isDir(FS.stat(path).mode) ? filesBelow(FS, path, `${below}${name}/`) : [[below + name, FS.readFile(path)]];
    });
}

/** An error of a report. @param decoder  the one that was missing, if it is for that */
function reported(fault, exitCode, decoder) {
    const advice = decoder ? `pass it: configure({ decoders: { ${decoder} } })` : inJavaScript(fault.advice ?? '');
    const message = [fault.file ? `${fault.file}: ${fault.message}` : fault.message, advice].filter(Boolean).join('; ');
    return new RakelightError(message, { exitCode, ...fault, advice });
}

/** @returns {exitCode, report, FS} */
async function run(verb, inputs, options, words = []) {
    const given = inputs.map((input, i) => ({ ...inputOf(input), at: inputs.length > 1 ? `${folder}/${i}` : folder }));
    const { code, stdout, stderr, FS, missingDecoder } = await runProgram(
        [verb, ...given.map(({ name, at }) => `${at.slice(folder.length + 1)}/${name}`.replace(/^\//, '')), ...words, ...wordsOf(options), '--json'], {
            ...loadOptions,
            prepare(FS) {
                FS.mkdirTree(folder);
                FS.mkdirTree(outputs);
                given.forEach(({ at, files }) => putFiles(FS, at, files));
                FS.chdir(folder);
            },
        });
    let report;
    try {
        report = JSON.parse(stdout.text);
    } catch {
        throw new RakelightError(inJavaScript(stderr.text) || 'the run ended without a report', { exitCode: code, code: code === 2 ? 'usage' : 'failed' });
    }
    const fault = report.error ?? report.rows?.find(row => row.error)?.error;
    if (fault) throw reported(fault, code, missingDecoder);
    return { exitCode: code, report, FS };
}

/** What is in a model, and its seams. `passed` says whether it is within the limits (check, maxSeam, ...). */
export async function inspect(model, options = {}) {
    const { exitCode, report } = await run('inspect', [model], options);
    return { passed: exitCode !== 5, ...report };
}

/** The model with seam-free normals; `files` has what was written beside it. */
export async function smooth(model, options = {}) {
    const ending = inputOf(model).name.replace(/.*\./, '').toLowerCase();
    const { format = ['gltf', 'obj', 'ply'].includes(ending) ? ending : 'glb', ...rest } = options ?? {};
    checkFormat(format);
    const { report, FS } = await run('smooth', [model], rest, ['-o', `${outputs}/model.${format}`]);
    const files = Object.fromEntries(filesBelow(FS, outputs));
    return { bytes: files[`model.${format}`], files, report };
}

/** A picture: PNG, or what `format` says (jpg, ppm, hdr). */
export async function render(model, options = {}) {
    const { format = 'png', ...rest } = options ?? {};
    checkFormat(format);
    const { report, FS } = await run('render', [model], rest, ['-o', `${outputs}/picture.${format}`]);
    return { bytes: FS.readFile(`${outputs}/picture.${format}`), report };
}

/** How much two pictures differ, or a model as it is drawn from a reference. `passed` says whether within the limits (maxFlip, ...). */
export async function compare(first, second, options = {}) {
    const { exitCode, report } = await run('compare', [first, second], options);
    return { passed: exitCode !== 5, ...report };
}

/** Why a pixel has its color. @param options  pixel: [x, y] */
export async function explain(model, options = {}) {
    return (await run('explain', [model], options)).report;
}
