// SPDX-License-Identifier: Apache-2.0
// The program in an instance of its own for each run: nothing is left of a run, also where it ran out of memory.
import makeModule from './wasm/rakelight.mjs';
import { programUrl } from './wasm/program_url.mjs';

let compiled;

const isNode = typeof process === 'object' && Boolean(process.versions?.node);

/** @returns the bytes, or what fetch() gives */
async function load(url) {
    if (isNode && !/^(https?|blob|data):/.test(String(url))) return (await import('fs/promises')).readFile(url);
    const response = await fetch(url);
    if (!response.ok) throw new Error(`${url}: ${response.status} ${response.statusText}`);
    return response;
}

/** Compiles once. The options are those of the first call. Servers may not know the type of .wasm files. */
async function compile({ wasmBinary, locateFile }) {
    const found = wasmBinary ?? await load(locateFile ? locateFile('rakelight.wasm', '') : programUrl);
    if (!(found instanceof globalThis.Response)) return WebAssembly.compile(found);
    return /wasm/.test(found.headers.get('content-type')) ? WebAssembly.compileStreaming(found) : WebAssembly.compile(await found.arrayBuffer());
}

/** A byte buffer that grows. */
class Output {
    #bytes = new Uint8Array(1024);
    #size = 0;
    write = byte => {
        if (byte === null) return;
        if (this.#size === this.#bytes.length) {
            const larger = new Uint8Array(2 * this.#size);
            larger.set(this.#bytes);
            this.#bytes = larger;
        }
        this.#bytes[this.#size++] = byte;
    };
    get bytes() { return this.#bytes.subarray(0, this.#size); }
    get text() { return new TextDecoder().decode(this.bytes); }
}

/**
 * @param words  of the command line, behind the program's name
 * @param options.files  prepares the file system: (FS, NODEFS) => void
 * @param options.stdin  bytes
 * @param options.decoders  { meshopt, draco }, each as its npm package has it, ready
 * @returns {code, stdout, stderr, FS, missingDecoder}
 */
export async function runProgram(words, { prepare, stdin, environment, decoders, ...source } = {}) {
    compiled ??= compile(source);
    const program = await compiled.catch(fault => {
        compiled = undefined;  // the next call may be given the right place
        throw fault;
    }), out = new Output(), messages = new Output();
    let at = 0;
    const module = await new Promise((resolve, reject) => makeModule({
        noInitialRun: true,
        decoders,
        instantiateWasm(imports, done) {
            WebAssembly.instantiate(program, imports).then(instance => done(instance, program)).catch(reject);
            return {};
        },
        stdin: () => (stdin && at < stdin.length ? stdin[at++] : null),
        stdout: out.write,
        stderr: messages.write,
        preRun: [made => Object.assign(made.ENV, environment)],
    }).then(resolve, reject));
    prepare?.(module.FS, module.NODEFS);
    return { code: callMain(module, words, messages), stdout: out, stderr: messages, FS: module.FS, missingDecoder: module.missingDecoder };
}

/** @returns the exit code, which does not become that of the caller's process */
function callMain(module, words, messages) {
    const own = globalThis.process?.exitCode;
    try {
        return module.callMain([...words]);
    } catch (fault) {
        if (!(fault instanceof RangeError || fault instanceof WebAssembly.RuntimeError)) throw fault;
        for (const byte of new TextEncoder().encode(`rakelight: error: ${fault.message}\n`)) messages.write(byte);
        return 1;
    } finally {
        if (globalThis.process) globalThis.process.exitCode = own;
    }
}
