// SPDX-License-Identifier: Apache-2.0
// Writes one module that needs no other file: the sources, the script that emscripten made, and its .wasm in base64.
//   node single_file.mjs OUT.js SCRIPT.mjs SOURCE.js...   (SCRIPT.wasm lies beside SCRIPT.mjs; the last source is the entry)
import { readFileSync, writeFileSync } from 'node:fs';
import { basename } from 'node:path';

const license = '// SPDX-License-Identifier: Apache-2.0\n';
const imported = /^import .* from '\.\/.*';\n/gm;
const address = /new URL\("[\w.-]+\.wasm",import\.meta\.url\)\.href/g;

function fail(message) {
    console.error(`single_file.mjs: ${message}`);
    process.exit(1);
}

/** The script as a function makeModule(); bundlers see no address of a .wasm file any more. */
function moduleMaker(script) {
    const text = readFileSync(script, 'utf8'), end = 'export default Module;';
    if (text.match(address)?.length !== 1 || !text.trimEnd().endsWith(end)) fail(`${script} is not as expected of emscripten`);
    const wasm = readFileSync(script.replace(/\.mjs$/, '.wasm')).toString('base64');
    return `${text.replace(address, '""').replace(end, '').trim()}
const wasmBinary = () => Uint8Array.from(atob('${wasm}'), letter => letter.charCodeAt(0));
const makeModule = options => Module({ wasmBinary: wasmBinary(), ...options });
`;
}

/** Without its imports; only the entry exports. */
function inlined(source, isEntry) {
    const text = readFileSync(source, 'utf8').replace(license, '').replace(imported, '');
    if (/^import /m.test(text)) fail(`${source} has imports of a kind that is not known here`);
    return isEntry ? text : text.replace(/^export (?=const|class|function)/gm, '');
}

const [out, script, ...sources] = process.argv.slice(2);
if (!sources.length) fail('usage: single_file.mjs OUT.js SCRIPT.mjs SOURCE.js...');
const parts = sources.map((source, i) => inlined(source, i === sources.length - 1));
writeFileSync(out, `${license}// ${sources.map(source => basename(source)).join(', ')} and ${basename(script)} with its .wasm, in one file.\n${moduleMaker(script)}${parts.join('\n')}`);
