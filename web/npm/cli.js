#!/usr/bin/env node
// SPDX-License-Identifier: Apache-2.0
// The program `rakelight` on the files of this machine: its options, messages and exit codes.
import { readdirSync, readFileSync, statSync, writeSync } from 'node:fs';
import { parse } from 'node:path';
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

function writeAll(descriptor, bytes) {
    for (let at = 0; at < bytes.length;) at += writeSync(descriptor, bytes, at);
}

const words = process.argv.slice(2);
const environment = Object.fromEntries(Object.entries(process.env).filter(([name]) => name.startsWith('RAKELIGHT_')));
const { code, stdout, stderr } = await runProgram(isWindows ? words.map(toModulePath) : words, {
    prepare: mountFolders,
    environment,
    stdin: words.includes('-') ? readFileSync(0) : undefined,
});
writeAll(1, stdout.bytes);
writeAll(2, stderr.bytes);
process.exitCode = code;
