// SPDX-License-Identifier: Apache-2.0
// Makes the page, a folder of static files.
//
//   node build.mjs MODULE CLONE OUT
//
// MODULE: the folder of rakelight-page.mjs and .wasm. CLONE: that of the project, whose data/ has the examples; build/docs, where it was
// made, becomes docs/ of the page, with live figures. Run it where `npm install` was run.
import { execFileSync } from 'node:child_process';
import { createHash } from 'node:crypto';
import { existsSync } from 'node:fs';
import { cp, mkdir, readdir, readFile, rm, writeFile } from 'node:fs/promises';
import { createRequire } from 'node:module';
import { dirname, join } from 'node:path';
import { fileURLToPath } from 'node:url';

import { build } from 'esbuild';

const here = dirname(fileURLToPath(import.meta.url)), [module, clone, out] = process.argv.slice(2);
const compiler = createRequire(import.meta.url).resolve('typescript/package.json').replace('package.json', 'bin/tsc');
for (const project of ['tsconfig.json', 'tsconfig.sw.json']) execFileSync(process.execPath, [compiler, '-p', join(here, project)], { stdio: 'inherit' });
const examples = {
    knight: ['data/knight/Knight_noNormals.glb'],
    spot: ['data/spot/spot_slab5.glb'],
    head: ['data/head/head.mtl', 'data/head/color.jpg', 'data/head/normal_from_bump.png', 'data/head/LICENSE.txt'],
    wall: ['data/maps/wall.obj', 'data/maps/brick_height.png', 'data/maps/brick_normal.png'],
    figures: ['data/maps/leather_normal.png', 'data/maps/leather_height.png', 'data/visibility/cyclic.obj', 'data/visibility/colors.mtl', 'data/visibility/floor.obj', 'tests/golden/models/checker.png'],
};

await rm(out, { recursive: true, force: true });
await mkdir(out, { recursive: true });
const options = { bundle: true, minify: true, format: 'esm', target: 'es2022', legalComments: 'none', logLevel: 'warning' };
await build({
    ...options, outdir: out, splitting: true,
    entryPoints: [join(here, 'src/main.ts'), join(here, 'src/worker.ts'), join(here, 'src/live.ts')],
    external: ['fs', 'path', 'node:*'],
    plugins: [{  // what emscripten made stays as it is, beside the others
        name: 'module', setup: bundle => bundle.onResolve({ filter: /page_module\.js$/ }, () => ({ path: './rakelight-page.mjs', external: true })),
    }],
});
for (const name of ['index.html', 'style.css', 'live.css', 'icon.svg']) await cp(join(here, name), join(out, name));
for (const name of ['rakelight-page.mjs', 'rakelight-page.wasm']) await cp(join(module, name), join(out, name));
await cp(createRequire(import.meta.url).resolve('draco3dgltf/draco_decoder_gltf.wasm'), join(out, 'draco_decoder_gltf.wasm'));
for (const [name, files] of Object.entries(examples)) {
    await mkdir(join(out, 'examples', name), { recursive: true });
    for (const file of files) await cp(join(clone, file), join(out, 'examples', name, file.replace(/^.*\//, '')));
}
await cp(join(here, 'examples'), join(out, 'examples'), { recursive: true });

// The documentation, where it was made.
const docs = join(clone, 'build/docs');
if (existsSync(join(docs, 'index.html'))) {
    await cp(docs, join(out, 'docs'), { recursive: true });
    const source = await readFile(join(here, 'src/figures.ts'), 'utf8');
    for (const page of new Set([...source.matchAll(/page: '([\w-]+)'/g)].map(([, name]) => name))) {
        const path = join(out, 'docs', `${page}.html`), text = await readFile(path, 'utf8');
        await writeFile(path, text.replace('</head>', '<link rel="stylesheet" href="../live.css"></head>').replace('</body>', '<script type="module" src="../live.js"></script></body>'));
    }
} else {
    const path = join(out, 'index.html');
    await writeFile(path, (await readFile(path, 'utf8')).replace(/ *<a href="docs[^\n]*\n/, ''));
}

const files = (await readdir(out, { recursive: true, withFileTypes: true })).filter(entry => entry.isFile())
    .map(entry => join(entry.parentPath, entry.name).slice(out.length + 1)).filter(name => !name.startsWith('examples/') && !name.startsWith('docs/')).sort();
const hash = createHash('sha256');
const examplesToKeep = ['spot/spot_slab5.glb', 'wall/wall.obj', 'wall/wall.mtl', 'wall/brick_height.png', 'wall/brick_normal.png'].map(name => `examples/${name}`);
for (const name of [...files, ...(await readdir(join(out, 'examples'), { recursive: true, withFileTypes: true })).filter(entry => entry.isFile()).map(entry => join(entry.parentPath, entry.name).slice(out.length + 1)).sort()]) hash.update(name).update(await readFile(join(out, name)));
await build({
    ...options, format: 'iife', outfile: join(out, 'sw.js'), entryPoints: [join(here, 'src/sw.ts')],
    define: { files: JSON.stringify(['./', ...files, ...examplesToKeep]), version: JSON.stringify(hash.digest('hex').slice(0, 12)) },
});
await writeFile(join(out, '.nojekyll'), '');
