// SPDX-License-Identifier: Apache-2.0
// The page at its limits: no WebGL, no network, no room, broken and huge models, many of them.
import assert from 'node:assert/strict';
import { readdir, readFile, stat } from 'node:fs/promises';
import { join } from 'node:path';
import test from 'node:test';
import { gzipSync } from 'node:zlib';

import { compare } from 'rakelight';

import { drop, isSkipped, open, openExample, picture, settled, site, text } from './page_support.mjs';

const options = { skip: isSkipped };

/** Runs a test in a browser of its own. */
async function withPage(given, work) {
    const it = await open(given);
    try {
        await work(it);
    } finally {
        await it.end();
    }
}

const zipped = async name => gzipSync(await readFile(join(site, name)), { level: 9 }).length;

test('the first paint takes less than 200 kB, a model less than 2.0 MB', options, async () => {
    const first = (await Promise.all(['index.html', 'style.css', 'icon.svg', 'main.js'].map(zipped))).reduce((a, b) => a + b);
    assert.ok(first < 200e3, `${first} bytes`);
    const chunks = (await readdir(site)).filter(name => /^chunk-.*\.js$/.test(name));
    const rest = (await Promise.all(['worker.js', 'rakelight-page.mjs', 'rakelight-page.wasm', ...chunks].map(zipped))).reduce((a, b) => a + b);
    assert.ok(first + rest < 2.0e6, `${first + rest} bytes`);
});

test('without WebGL the engine soft draws the same', options, async () => {
    const pictures = [];
    for (const engine of ['webgl', 'soft'])
        await withPage({ engine }, async ({ page, url }) => {
            await openExample(page, url, 'knight');
            assert.equal(await page.evaluate(() => document.body.dataset.renderer === 'soft'), engine === 'soft');
            await page.uncheck('#heat');
            pictures.push(await picture(page));
            if (engine === 'webgl') return;
            await page.locator('#borders button').first().click();
            await settled(page);
            await page.check('#heat');
            await page.click('#fix');
            await page.waitForSelector('#download:not([hidden])');
            assert.equal(await text(page, 'message'), 'normals made for 15 parts');
        });
    const { rows: [row] } = await compare(...pictures);
    assert.ok(row.psnr_db > 40, `${row.psnr_db} dB`);
});

test('after the first visit the page works without a network', options, () => withPage({}, async ({ page, context, url }) => {
    await openExample(page, url, 'teapot');
    await page.evaluate(() => navigator.serviceWorker.ready);
    await page.reload();
    await page.waitForFunction(() => navigator.serviceWorker.controller !== null);
    await context.setOffline(true);
    await openExample(page, url, 'teapot');
    await page.reload();
    await page.waitForSelector('body.open');
    assert.equal(await text(page, 'headline'), '2 borders, largest 25.3°');
}));

/** A binary STL of a grid: 50 bytes a triangle. Made in the page, so that nothing passes through the driver of the browser. */
const dropGrid = (page, triangles) => page.evaluate(count => {
    const bytes = new ArrayBuffer(84 + 50 * count), view = new DataView(bytes), side = Math.ceil(Math.sqrt(count / 2));
    view.setUint32(80, count, true);
    for (let t = 0; t < count; ++t) {
        const cell = t >> 1, x = cell % side, y = Math.floor(cell / side), corners = t & 1 ? [[1, 0], [1, 1], [0, 1]] : [[0, 0], [1, 0], [0, 1]];
        corners.forEach(([dx, dy], k) => [x + dx, y + dy, Math.sin((x + dx) / 40) * 20].forEach((v, i) => view.setFloat32(84 + 50 * t + 12 + 12 * k + 4 * i, v, true)));
    }
    const transfer = new DataTransfer();
    transfer.items.add(new File([bytes], 'grid.stl'));
    document.dispatchEvent(new DragEvent('drop', { dataTransfer: transfer, bubbles: true }));
}, triangles);

test('a model of 100 MB shows its progress, is cancelled, and is opened', options, () => withPage({}, async ({ page, url }) => {
    await openExample(page, url, 'spot');
    await dropGrid(page, 2_000_000);
    await page.waitForSelector('#progress:not([hidden])');
    assert.equal(await page.evaluate(() => new Promise(resolve => setTimeout(() => resolve('the page is alive'), 1))), 'the page is alive');
    await page.click('#cancel');
    await settled(page);
    assert.match(await text(page, 'detail'), /spot_slab5\.glb/);
    assert.equal(await page.locator('#progress').isVisible(), false);
    await dropGrid(page, 2_000_000);
    await page.waitForFunction(() => /grid\.stl/.test(document.getElementById('detail').textContent), null, { timeout: 120_000 });
    await settled(page);
    assert.match(await text(page, 'detail'), /2,000,000 triangles$/);
}));

test('after 50 models the page holds no more memory than after 30', options, () => withPage({}, async ({ page, url }) => {
    await page.goto(url);
    const names = ['spot', 'teapot', 'wall', 'knight', 'head'], sizes = [];
    for (let i = 0; i < 50; ++i) {
        await page.evaluate(name => document.querySelector(`[data-example=${name}]`).click(), names[i % 5]);
        await settled(page);
        if (i % 7 === 0) {
            await page.evaluate(() => document.getElementById('fix').click());
            await settled(page);
        }
        sizes.push(await page.evaluate(() => globalThis.rakelight.engine.call('memory')));
    }
    assert.equal(sizes.at(-1), sizes[29], `[bytes] after each model: ${sizes}`);
}));

const wait = ms => new Promise(resolve => setTimeout(resolve, ms));

const shared = process.env.RAKELIGHT_SHARED ?? join(site, '../../../../shared');
const hostile = await readdir(join(shared, 'hostile'), { recursive: true }).then(names => names.filter(name => /\.(glb|gltf|obj|ply|stl|off)$/i.test(name)).sort(), () => []);

test('broken files give one line each, and the page lives', { skip: isSkipped || (hostile.length === 0 && 'there are no broken files here') }, () => withPage({}, async ({ page, url }) => {
    await openExample(page, url, 'spot');
    let refused = 0;
    for (const name of hostile) {
        const path = join(shared, 'hostile', name);
        if ((await stat(path)).size > 4e6) continue;
        if (!await Promise.race([drop(page, { [name.replace(/^.*\//, '')]: await readFile(path) }).then(() => true), wait(10_000)])) {
            await page.click('#cancel');  // its picture takes long: whoever waits can end it
            await settled(page);
        }
        const line = await text(page, 'message'), isFault = await page.locator('#message').evaluate(box => box.classList.contains('fault') && !box.hidden);
        if (!isFault) continue;
        refused += 1;
        assert.ok(line.length > 10 && line.length < 700 && !line.includes('\n'), `${name}: ${line}`);
    }
    assert.ok(refused > hostile.length / 3, `${refused} of ${hostile.length}`);
    await page.evaluate(() => document.querySelector('[data-example=spot]').click());
    await settled(page);
    assert.equal(await text(page, 'headline'), '4 borders, largest 30.3°');
}));

test('nothing is cut off at 360, 1280 and 2560 pixels, in the dark and in the light', options, async () => {
    for (const colorScheme of ['dark', 'light'])
        for (const width of [360, 1280, 2560])
            await withPage({ width, height: Math.round(width < 800 ? 740 : width * 0.6), colorScheme }, async ({ page, url }) => {
                const wide = () => page.evaluate(() => [...document.querySelectorAll('body *')].filter(element => {
                    const box = element.getBoundingClientRect();
                    return box.width > 0 && box.height > 0 && (box.right > innerWidth + 1 || box.left < -1) && !element.closest('[hidden], svg, #line');
                }).map(element => `${element.tagName} ${element.id}`));
                await page.goto(url);
                await page.waitForSelector('.example');
                assert.deepEqual(await wide(), [], `${width} px, empty`);
                await openExample(page, url, 'spot');
                await page.click('#fix');
                await page.waitForSelector('#download:not([hidden])');
                for (const tab of ['look', 'pixel', 'seams']) {
                    await page.click(`#tab-${tab}`);
                    assert.deepEqual(await wide(), [], `${width} px, ${tab}`);
                }
            });
});

test('figures of the documentation become live', options, () => withPage({}, async ({ page, url }) => {
    const figures = [['shading', 'shading.png', 4], ['bump', 'bump-teapots.png', 4], ['visibility', 'visibility.png', 4]];
    for (const [name, image, variants] of figures) {
        await page.goto(`${url}docs/${name}.html`);
        await page.locator(`img[src$="${image}"] ~ .rl-button`).first().click();
        await page.waitForSelector(`[data-live="${image}"]`);
        const choices = page.locator('.rl-choices button'), pictures = new Set();
        assert.equal(await choices.count(), variants);
        for (let i = 0; i < variants; ++i) {
            await choices.nth(i).click();
            await page.waitForTimeout(1500);
            pictures.add((await page.locator('.rl-stage').screenshot()).toString('base64'));
        }
        assert.match(await page.locator('.rl-message').textContent(), /^Drag to turn/);
        assert.ok(pictures.size >= variants - 1, `${name}: ${pictures.size} pictures`);
    }
}));

test('every control has a name, and the keyboard reaches it', options, () => withPage({}, async ({ page, url }) => {
    await openExample(page, url, 'spot');
    await page.click('#tab-look');
    const nameless = await page.evaluate(() => [...document.querySelectorAll('button, input, select, [role=slider], canvas')]
        .filter(element => element.offsetParent && !(element.getAttribute('aria-label') || element.textContent.trim() || element.labels?.length)).map(element => element.outerHTML.slice(0, 80)));
    assert.deepEqual(nameless, []);
    const reached = new Set();
    await page.evaluate(() => document.activeElement?.blur());
    for (let i = 0; i < 40; ++i) {
        await page.keyboard.press('Tab');
        reached.add(await page.evaluate(() => document.activeElement.id || document.activeElement.tagName));
    }
    for (const id of ['CANVAS', 'fix', 'heat', 'hard', 'tab-look', 'set-lighting', 'set-crease', 'whole', 'theme']) assert.ok(reached.has(id), `${id} of ${[...reached]}`);
}));
