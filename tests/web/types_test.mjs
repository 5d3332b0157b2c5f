// SPDX-License-Identifier: Apache-2.0
// The types of the package: its README's examples and other use compile, misuse does not, and tools that look at packages find nothing.
import assert from 'node:assert/strict';
import { execFileSync, spawnSync } from 'node:child_process';
import { copyFile, mkdtemp, rm, writeFile } from 'node:fs/promises';
import { dirname, join } from 'node:path';
import test from 'node:test';
import { fileURLToPath } from 'node:url';

import { blocksOf, declarations } from './readme.mjs';

const here = dirname(fileURLToPath(import.meta.url)), packages = join(here, 'node_modules'), rakelight = join(packages, 'rakelight');
const modes = [{ module: 'nodenext' }, { module: 'esnext', moduleResolution: 'bundler' }];
const strict = { strict: true, noEmit: true, target: 'es2022', exactOptionalPropertyTypes: true, noUncheckedIndexedAccess: true };

// Some tools color what they say where CI is set, terminal or not.
const environment = { ...process.env, NO_COLOR: '1' };
const run = (tool, ...words) => spawnSync(process.execPath, [tool, ...words], { encoding: 'utf8', cwd: here, env: environment });

/** @param files  name -> text, or a path to copy  @returns what the compiler says */
async function compile(files, options) {
    const folder = await mkdtemp(join(here, 'types-'));
    try {
        for (const [name, { text, path }] of Object.entries(files)) await (path ? copyFile(path, join(folder, name)) : writeFile(join(folder, name), text));
        await writeFile(join(folder, 'tsconfig.json'), JSON.stringify({ compilerOptions: { ...strict, ...options }, files: Object.keys(files) }));
        const { status, stdout, stderr } = run(join(packages, 'typescript/bin/tsc'), '--pretty', 'false', '-p', folder);
        return status === 0 ? '' : `exit code ${status}\n${stdout}${stderr}`;
    } finally {
        await rm(folder, { recursive: true });
    }
}

const beside = name => ({ path: join(here, name) });
const withOthers = { lib: ['es2022', 'dom', 'dom.iterable'], types: ['node'], skipLibCheck: true };

for (const mode of modes) {
    const name = mode.moduleResolution ?? mode.module;

    test(`the examples of the README compile (${name})`, async () => {
        const blocks = [...blocksOf('js'), ...blocksOf('ts')];
        assert.ok(blocks.length >= 5);
        const files = Object.fromEntries(blocks.map((text, i) => [`example${i}.ts`, { text }]));
        assert.equal(await compile({ ...files, 'names.d.ts': { text: declarations } }, { ...mode, ...withOthers }), '');
    });

    test(`use compiles, and no line of misuse does (${name})`, async () => {
        const files = { 'use.ts': beside('types_use.ts'), 'misuse.ts': beside('types_misuse.ts') };
        assert.equal(await compile(files, { ...mode, ...withOthers, exactOptionalPropertyTypes: false }), '');
    });

    test(`the declarations are right by themselves, without those of browsers, Node and other packages (${name})`, async () => {
        const text = ['', '/attributes', '/attributes/single', '/scene'].map((entry, i) => `export * as entry${i} from 'rakelight${entry}';\n`).join('');
        assert.equal(await compile({ 'all.ts': { text } }, { ...mode, lib: ['es2022'], types: [], skipLibCheck: false }), '');
    });
}

test('publint finds nothing but a suggestion', () => {
    const { status, stdout, stderr } = run(join(packages, 'publint/src/cli.js'), 'run', rakelight, '--strict');
    assert.equal(status, 0, stdout + stderr);
    const [, ...suggestions] = stdout.split('Suggestions:\n')[1]?.match(/^\d+\. .*$/gm) ?? [];
    assert.match(stdout, /^1\. pkg.browser with an object value can be refactored/m);  // what emscripten imports in Node has no other name
    assert.deepEqual(suggestions, []);
});

test('the types are found as the modules are', () => {
    const { status, stdout, stderr } = run(join(packages, '@arethetypeswrong/cli/dist/index.js'), '--pack', rakelight, '--profile', 'esm-only', '--no-definitely-typed');
    assert.equal(status, 0, stdout + stderr);
});

test('the package has what its modules need, and only that', () => {
    const [{ files }] = JSON.parse(execFileSync('npm', ['pack', '--dry-run', '--json', rakelight], { encoding: 'utf8', shell: process.platform === 'win32' }));
    const names = files.map(({ path }) => path);
    for (const name of ['LICENSE', 'README.md', 'cli.js', 'program_options.d.ts', 'wasm/rakelight-scene.wasm']) assert.ok(names.includes(name), name);
    assert.deepEqual(names.filter(name => !/^(wasm\/)?[\w-]+(\.d)?\.(js|mjs|ts|wasm|md|json)$|^LICENSE$/.test(name)), []);
    assert.ok(files.find(({ path }) => path === 'cli.js').mode & 0o111);
});
