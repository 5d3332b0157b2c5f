#!/usr/bin/env node
// SPDX-License-Identifier: Apache-2.0
// The program `rakelight` on the files of this machine: its options, messages and exit codes.
import { readdirSync, readFileSync, statSync, writeFileSync, writeSync } from 'node:fs';
import { createRequire } from 'node:module';
import { join, parse } from 'node:path';
import { pathToFileURL } from 'node:url';
import { runProgram } from './program.js';

const isWindows = process.platform === 'win32';

/** "C:\a\b" is /C:/a/b in the module's file system. */
const toModulePath = path => (/^[A-Za-z]:[\\/]/.test(path) ? '/' + path : path).replaceAll(isWindows ? '\\' : '\0', '/');

/** The folders below the root, each at its own place; of Windows the drive. */
function mountFolders(FS, NODEFS) {
    const root = parse(process.cwd()).root;
    const places = isWindows ? [[root, toModulePath(root).replace(/\/$/, '')]]
        : readdirSync('/').filter(name => !['dev', 'proc', 'sys'].includes(name) && isFolder('/' + name)).map(name => ['/' + name, '/' + name]);
    for (const [folder, place] of places) {
        FS.mkdirTree(place);
        FS.mount(NODEFS, { root: folder }, place);
    }
    FS.chdir(toModulePath(process.cwd()));
}

function isFolder(path) {
    try {
        return statSync(path).isDirectory();
    } catch {
        return false;
    }
}

/** Whoever reads may end first: `| head`. */
function writeAll(descriptor, bytes) {
    try {
        for (let at = 0; at < bytes.length;) at += writeSync(descriptor, bytes, at);
    } catch (fault) {
        if (fault.code !== 'EPIPE') throw fault;
    }
}

/** Folders that are not mounted lie in memory. @returns paths of their files */
function filesInMemory(FS) {
    return ['/', '/dev', '/proc', '/sys'].flatMap(place => (FS.analyzePath(place).exists ? FS.readdir(place) : [])
        .map(name => `${place === '/' ? '' : place}/${name}`).filter(path => FS.isFile(FS.lstat(path).mode)));
}

/** Outputs that were written there become files of this machine, or the error that this machine gives. @returns the exit code */
function takeOut(FS, code) {
    for (const path of filesInMemory(FS))
        try {
            writeFileSync(path, FS.readFile(path));
        } catch (fault) {
            writeAll(2, Buffer.from(`rakelight: error: ${path}: cannot be written: ${fault.message}\n`));
            code = 1;
        }
    return code;
}

/** A package that npm installed beside this one, or in the project where the program runs. @returns undefined: there is none */
async function installedPackage(name) {
    try {
        return await import(name);
    } catch (fault) {
        if (fault.code !== 'ERR_MODULE_NOT_FOUND') throw fault;
    }
    try {
        return await import(pathToFileURL(createRequire(join(process.cwd(), 'package.json')).resolve(name)));
    } catch (fault) {
        if (fault.code !== 'MODULE_NOT_FOUND') throw fault;
        return undefined;
    }
}

async function installedDecoder(name) {
    const found = await installedPackage(name === 'draco' ? 'draco3dgltf' : 'meshoptimizer');
    if (name === 'draco') return found?.default.createDecoderModule();
    await found?.MeshoptDecoder.ready;
    return found?.MeshoptDecoder;
}

const words = process.argv.slice(2), decoders = {};
const options = {
    prepare: mountFolders,
    environment: Object.fromEntries(Object.entries(process.env).filter(([name]) => name.startsWith('RAKELIGHT_'))),
    stdin: words.includes('-') ? readFileSync(0) : undefined,
    decoders,
};
const run = () => runProgram(isWindows ? words.map(toModulePath) : words, options);
let result = await run();
for (let name = result.missingDecoder; name && !decoders[name]; name = result.missingDecoder) {
    decoders[name] = await installedDecoder(name);
    if (!decoders[name]) break;
    result = await run();
}
writeAll(1, result.stdout.bytes);
writeAll(2, result.stderr.bytes);
process.exitCode = takeOut(result.FS, result.code);
