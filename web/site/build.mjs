// SPDX-License-Identifier: Apache-2.0
// Makes the page, a folder of static files.
//
//   node build.mjs MODULE EXAMPLES OUT
//
// MODULE: the folder of rakelight-page.mjs and .wasm. EXAMPLES: the folder data/ of the project. Run it where `npm install` was run.
import { execFileSync } from 'node:child_process';
import { createHash } from 'node:crypto';
import { cp, mkdir, readdir, readFile, rm, writeFile } from 'node:fs/promises';
import { createRequire } from 'node:module';
import { dirname, join } from 'node:path';
import { fileURLToPath } from 'node:url';

import { build } from 'esbuild';

const here = dirname(fileURLToPath(import.meta.url)), [module, data, out] = process.argv.slice(2);
const compiler = createRequire(import.meta.url).resolve('typescript/package.json').replace('package.json', 'bin/tsc');
for (const project of ['tsconfig.json', 'tsconfig.sw.json']) execFileSync(process.execPath, [compiler, '-p', join(here, project)], { stdio: 'inherit' });
const examples = {
    knight: ['knight/Knight_noNormals.glb'],
    spot: ['spot/spot_slab5.glb'],
    head: ['head/head.mtl', 'head/color.jpg', 'head/normal_from_bump.png', 'head/LICENSE.txt'],
    wall: ['maps/wall.obj', 'maps/brick_height.png', 'maps/brick_normal.png'],
};

await rm(out, { recursive: true, force: true });
await mkdir(out, { recursive: true });
const options = { bundle: true, minify: true, format: 'esm', target: 'es2022', legalComments: 'none', logLevel: 'warning' };
await build({
    ...options, outdir: out, splitting: true,
    entryPoints: [join(here, 'src/main.ts'), join(here, 'src/worker.ts')],
    external: ['fs', 'path', 'node:*'],
    plugins: [{  // what emscripten made stays as it is, beside the others
        name: 'module', setup: bundle => bundle.onResolve({ filter: /page_module\.js$/ }, () => ({ path: './rakelight-page.mjs', external: true })),
    }],
});
for (const name of ['index.html', 'style.css', 'icon.svg']) await cp(join(here, name), join(out, name));
for (const name of ['rakelight-page.mjs', 'rakelight-page.wasm']) await cp(join(module, name), join(out, name));
await cp(createRequire(import.meta.url).resolve('draco3dgltf/draco_decoder_gltf.wasm'), join(out, 'draco_decoder_gltf.wasm'));
for (const [name, files] of Object.entries(examples)) {
    await mkdir(join(out, 'examples', name), { recursive: true });
    for (const file of files) await cp(join(data, file), join(out, 'examples', name, file.replace(/^.*\//, '')));
}
await cp(join(here, 'examples'), join(out, 'examples'), { recursive: true });

const files = (await readdir(out, { recursive: true, withFileTypes: true })).filter(entry => entry.isFile())
    .map(entry => join(entry.parentPath, entry.name).slice(out.length + 1)).filter(name => !name.startsWith('examples/') && !name.startsWith('docs/')).sort();
const hash = createHash('sha256');
for (const name of files) hash.update(name).update(await readFile(join(out, name)));
await build({
    ...options, format: 'iife', outfile: join(out, 'sw.js'), entryPoints: [join(here, 'src/sw.ts')],
    define: { files: JSON.stringify(['./', ...files]), version: JSON.stringify(hash.digest('hex').slice(0, 12)) },
});
await writeFile(join(out, '.nojekyll'), '');
