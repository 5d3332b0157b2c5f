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

const folder = '/model';
let loadOptions = {};

/** Where the .wasm file comes from, before the first call; and decoders of compressed models. */
export function configure(options) { loadOptions = options; }

const optionName = key => '--' + key.replace(/[A-Z]/g, letter => '-' + letter.toLowerCase());

function wordsOf(options) {
    return Object.entries(options).flatMap(([key, value]) => {
        if (value === undefined || value === false || value === null) return value === false ? [optionName(key) + '=off'] : [];
        if (value === true) return [optionName(key)];
        return [optionName(key), Array.isArray(value) || ArrayBuffer.isView(value) ? Array.from(value).join(',') : String(value)];
    });
}

const contains = (bytes, text) => [...text].every((letter, i) => bytes[i] === letter.charCodeAt(0));

/** GLB and PLY say what they are; other bytes need a name. */
function nameOf(bytes) {
    if (contains(bytes, 'glTF')) return 'model.glb';
    if (contains(bytes, 'ply')) return 'model.ply';
    if (contains(bytes, '\x89PNG')) return 'picture.png';
    throw new RakelightError('the name of the file is missing: pass { name, bytes }', { exitCode: 2, code: 'usage' });
}

/** @returns {name, files}: all files of the input, by their names beside one another */
function inputOf(input) {
    if (input instanceof ArrayBuffer) input = new Uint8Array(input);
    if (ArrayBuffer.isView(input)) {
        const bytes = new Uint8Array(input.buffer, input.byteOffset, input.byteLength);
        return inputOf({ name: nameOf(bytes), bytes });
    }
    const { name, bytes, files = {} } = input;
    return { name, files: { ...files, [name]: bytes instanceof ArrayBuffer ? new Uint8Array(bytes) : bytes } };
}

function putFiles(FS, at, files) {
    for (const [name, bytes] of Object.entries(files)) {
        const path = `${at}/${name}`;
        FS.mkdirTree(path.slice(0, path.lastIndexOf('/')));
        FS.writeFile(path, bytes);
    }
}

/** @returns {exitCode, report, FS} */
async function run(verb, inputs, options, words = []) {
    const given = inputs.map((input, i) => ({ ...inputOf(input), at: inputs.length > 1 ? `${folder}/${i}` : folder }));
    const { code, stdout, stderr, FS } = await runProgram(
        [verb, ...given.map(({ name, at }) => `${at.slice(folder.length + 1)}/${name}`.replace(/^\//, '')), ...words, ...wordsOf(options), '--json'], {
            ...loadOptions,
            prepare(FS) {
                FS.mkdirTree(folder);
                given.forEach(({ at, files }) => putFiles(FS, at, files));
                FS.chdir(folder);
            },
        });
    let report;
    try {
        report = JSON.parse(stdout.text);
    } catch {
        throw new RakelightError(stderr.text.trim() || 'the run ended without a report', { exitCode: code, code: code === 2 ? 'usage' : 'failed' });
    }
    const fault = report.error ?? report.rows?.find(row => row.error)?.error;
    if (fault) throw new RakelightError(fault.file ? `${fault.file}: ${fault.message}` : fault.message, { exitCode: code, ...fault });
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
    const { format = ['gltf', 'obj', 'ply'].includes(ending) ? ending : 'glb', ...rest } = options;
    const output = `out/model.${format}`;
    const { report, FS } = await run('smooth', [model], rest, ['-o', output]);
    const files = {};
    for (const file of FS.readdir(`${folder}/out`))
        if (file !== '.' && file !== '..' && FS.isFile(FS.stat(`${folder}/out/${file}`).mode)) files[file] = FS.readFile(`${folder}/out/${file}`);
    return { bytes: files[output.slice(4)], files, report };
}

/** A picture: PNG, or what `format` says (jpg, ppm, hdr). */
export async function render(model, options = {}) {
    const { format = 'png', ...rest } = options;
    const { report, FS } = await run('render', [model], rest, ['-o', `out.${format}`]);
    return { bytes: FS.readFile(`${folder}/out.${format}`), report };
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
