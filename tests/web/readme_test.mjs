// SPDX-License-Identifier: Apache-2.0
// The examples of the package's README run, in a folder with small models.
import assert from 'node:assert/strict';
import { spawnSync } from 'node:child_process';
import { mkdir, mkdtemp, readFile, rm, writeFile } from 'node:fs/promises';
import { dirname, join } from 'node:path';
import test from 'node:test';
import { fileURLToPath } from 'node:url';

import { inspect } from 'rakelight';
import { blocksOf, robot } from './readme.mjs';

const here = dirname(fileURLToPath(import.meta.url)), cli = join(here, 'node_modules/rakelight/cli.js');

/** In a folder of its own, from which packages are found. */
async function inFolder(use) {
    const folder = await mkdtemp(join(here, 'readme-'));
    try {
        for (const name of ['robot.glb', 'models/robot.glb']) {
            await mkdir(dirname(join(folder, name)), { recursive: true });
            await writeFile(join(folder, name), await robot());
        }
        return await use(folder);
    } finally {
        await rm(folder, { recursive: true });
    }
}

const rounding = 0.01;  // degrees
const seam = async path => (await inspect(await readFile(path))).rows[0].seams.seam_deg;

/** A command line of `rakelight`, with or without npx. @returns its exit code */
function runCommand(line, folder) {
    const words = line.trim().split(/\s+/), at = words.indexOf('rakelight');
    assert.match(line.trim(), /^(npx (--yes )?)?rakelight /);
    return spawnSync(process.execPath, [cli, ...words.slice(at + 1)], { cwd: folder, encoding: 'utf8' }).status;
}

async function runBlock(text, folder) {
    await writeFile(join(folder, 'block.mjs'), `import '../readme_values.mjs';\n${text}`);
    const { status, stdout, stderr } = spawnSync(process.execPath, ['block.mjs'], { cwd: folder, encoding: 'utf8' });
    assert.equal(status, 0, stderr);
    return stdout;
}

test('the gate fails, the model is fixed, and the gate passes', () => inFolder(async folder => {
    const [commands] = blocksOf('sh'), [gate, fix] = commands.trim().split('\n');
    assert.equal(runCommand(gate, folder), 5);
    assert.equal(runCommand(fix, folder), 0);
    assert.equal(runCommand(gate.replace('models/', 'fixed/'), folder), 0);
    const { scripts } = JSON.parse(blocksOf('json')[0]), [, step] = /^- run: (.*)/m.exec(blocksOf('yaml')[0]);
    for (const line of [scripts['check:seams'], step]) {
        assert.equal(runCommand(line, folder), 5, line);
        assert.equal(runCommand(scripts['fix:seams'], folder), 0);
        assert.equal(runCommand(line, folder), 0, line);
        await writeFile(join(folder, 'models/robot.glb'), await robot());
    }
}));

/** Each example, by a word of it, and what is to be after it. */
const examples = {
    "from 'node:fs/promises'": async (folder, stdout) => {
        assert.match(stdout, /^a seam of 11\.4 degrees$/m);
        assert.ok(await seam(join(folder, 'fixed.glb')) < rounding);
        assert.deepEqual([...(await readFile(join(folder, 'robot.png'))).subarray(0, 4)], [0x89, 0x50, 0x4e, 0x47]);
    },
    'chair.obj': () => {},
    draco3dgltf: () => {},
    '@gltf-transform/core': async folder => assert.ok(await seam(join(folder, 'smooth.glb')) < rounding),
    'three/addons': (folder, stdout) => assert.match(stdout, /^[1-9]\d* normals turned\nequal: true$/m),
    'rakelight/attributes': (folder, stdout) => assert.match(stdout, /^equal: true$/m),
};

/** Vertex 8 is the last of the first half's first row, and 0 the first of the other's: one place. */
const compare = (a, b) => `console.log(\`equal: \${${a}.slice(24, 27).join() === ${b}.slice(0, 3).join()}\`);\n`;
const more = {
    'three/addons': 'const [a, b] = scene.children.map(({ geometry }) => geometry.attributes.normal.array);\n' + compare('a', 'b'),
    'rakelight/attributes': compare('body.normals', 'wheel.normals'),
};

for (const [word, check] of Object.entries(examples))
    test(`the example of ${word} runs`, () => inFolder(async folder => {
        const found = blocksOf('js').filter(block => block.includes(word));
        assert.equal(found.length, 1);
        await check(folder, await runBlock(found[0] + (more[word] ?? ''), folder));
    }));

test('each block is one of these', () => {
    assert.equal(blocksOf('js').length, Object.keys(examples).length);
    for (const [language, count] of [['sh', 2], ['json', 1], ['yaml', 1]]) assert.equal(blocksOf(language).length, count);
});
