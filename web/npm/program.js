// SPDX-License-Identifier: Apache-2.0
// The program in an instance of its own for each run: nothing is left of a run, also where it ran out of memory.
import makeModule from './wasm/rakelight.mjs';

let compiled;

/** Compiles once. The options are those of the first call. */
async function compile({ wasmBinary, locateFile }) {
    if (wasmBinary) return WebAssembly.compile(wasmBinary);
    const url = locateFile ? locateFile('rakelight.wasm', '') : new URL('./wasm/rakelight.wasm', import.meta.url);
    if (typeof process === 'object' && process.versions?.node && !/^(https?|blob|data):/.test(String(url))) {
        const { readFile } = await import('node:fs/promises');
        return WebAssembly.compile(await readFile(url));
    }
    return WebAssembly.compileStreaming(fetch(url));
}

/** Bytes that are written one by one. */
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
export async function runProgram(words, { prepare, stdin, environment, decoders, ...load } = {}) {
    compiled ??= compile(load);
    const program = await compiled, out = new Output(), messages = new Output();
    let at = 0;
    const module = await makeModule({
        noInitialRun: true,
        decoders,
        instantiateWasm(imports, done) {
            WebAssembly.instantiate(program, imports).then(instance => done(instance, program));
            return {};
        },
        stdin: () => (stdin && at < stdin.length ? stdin[at++] : null),
        stdout: out.write,
        stderr: messages.write,
        preRun: [made => Object.assign(made.ENV, environment)],
    });
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
