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

test('without WebGL the engine soft draws the same, with seams, light and hard edges', options, async () => {
    const pictures = { webgl: [], soft: [] };
    for (const engine of ['webgl', 'soft'])
        await withPage({ engine }, async ({ page, url }) => {
            await openExample(page, url, 'spot');
            assert.equal(await page.evaluate(() => document.body.dataset.renderer === 'soft'), engine === 'soft');
            const take = async () => pictures[engine].push(await picture(page));
            await take();
            await page.check('#hard');
            await take();
            await page.locator('#borders button').nth(1).click();
            await take();
            await page.click('#fix');
            await page.waitForSelector('#download:not([hidden])');
            await take();
        });
    for (const i of [0, 1, 2, 3]) {
        const { rows: [row] } = await compare(pictures.webgl[i], pictures.soft[i]);
        assert.ok(row.psnr_db > 28, `picture ${i}: ${row.psnr_db} dB`);  // lines are antialiased by soft alone
    }
});

/** Puts a text before the worker's. */
const changeWorker = (page, text) => page.route('**/worker.js', async route => {
    const response = await route.fetch();
    await route.fulfill({ response, body: text + await response.text() });
});

const withoutExtension = name => `{ const own = WebGL2RenderingContext.prototype.getExtension;
    WebGL2RenderingContext.prototype.getExtension = function (asked) { return asked === '${name}' ? null : own.call(this, asked); };
    const all = WebGL2RenderingContext.prototype.getSupportedExtensions;
    WebGL2RenderingContext.prototype.getSupportedExtensions = function () { return all.call(this).filter(other => other !== '${name}'); }; }`;

test('a browser that draws no floats, or hides its GPU, shows the model all the same', options, async () => {
    for (const [name, renderer] of [['EXT_color_buffer_float', /^soft$/], ['WEBGL_debug_renderer_info', /WebGL|ANGLE/]])
        await withPage({ serviceWorkers: 'block' }, async ({ page, url, problems }) => {
            await changeWorker(page, withoutExtension(name));
            await openExample(page, url, 'spot');
            assert.match(await page.evaluate(() => document.body.dataset.renderer), renderer);
            assert.equal(await page.locator('#message').isVisible(), false);
            const { rows: [row] } = await compare(await picture(page), await picture(page));
            assert.ok(row.equal);
            assert.deepEqual(problems.filter(text => !/GPU stall|404|Service Worker/.test(text)), []);
        });
});

test('a context that does not come back gives way to the engine soft', options, () => withPage({}, async ({ page, url }) => {
    await openExample(page, url, 'spot');
    const before = await picture(page);
    await page.evaluate(() => globalThis.rakelight.engine.call('loseContext'));
    await page.waitForFunction(() => document.body.dataset.renderer === 'soft', null, { timeout: 20_000 });
    const { rows: [row] } = await compare(before, await picture(page));
    assert.ok(row.psnr_db > 28, `${row.psnr_db} dB`);
}));

test('Cancel while the library still starts leaves a page that works', options, () => withPage({ serviceWorkers: 'block' }, async ({ page, url }) => {
    let delay = 3000;
    await page.route('**/*.wasm', async route => {
        await wait(delay);
        await route.continue();
    });
    await page.goto(url);
    await page.click('[data-example=teapot]');
    await page.waitForSelector('#progress:not([hidden])');
    delay = 0;
    await page.click('#cancel');
    await page.click('[data-example=teapot]');
    await page.waitForSelector('body.open');
    await settled(page);
    assert.equal(await text(page, 'headline'), '2 borders with a seam, largest 25.3°');
}));

test('after the first visit the page works without a network', options, () => withPage({}, async ({ page, context, url }) => {
    await openExample(page, url, 'teapot');
    await page.evaluate(() => navigator.serviceWorker.ready);
    await page.reload();
    await page.waitForFunction(() => navigator.serviceWorker.controller !== null);
    await context.setOffline(true);
    await openExample(page, url, 'teapot');
    await page.reload();
    await page.waitForSelector('body.open');
    assert.equal(await text(page, 'headline'), '2 borders with a seam, largest 25.3°');
    await page.evaluate(() => document.querySelector('[data-example=spot]').click());
    await settled(page);
    assert.equal(await text(page, 'headline'), '4 borders with a seam, largest 30.3°', 'kept though nobody looked at it');
    await page.evaluate(() => document.querySelector('[data-example=head]').click());
    await settled(page);
    assert.match(await text(page, 'message-text'), /not there without a network/);
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
    assert.equal(await page.locator('#message').isVisible() && await text(page, 'message-text'), false);
    await dropGrid(page, 2_000_000);
    await page.waitForFunction(() => /grid\.stl/.test(document.getElementById('detail').textContent), null, { timeout: 120_000 });
    await settled(page);
    assert.match(await text(page, 'detail'), /2,000,000 triangles/);
}));

test('after 50 models the page holds no more than after 30', options, () => withPage({}, async ({ page, url }) => {
    await page.goto(url);
    const names = ['spot', 'teapot', 'wall', 'knight', 'head'], held = [];
    for (let i = 0; i < 50; ++i) {
        await page.evaluate(name => document.querySelector(`[data-example=${name}]`).click(), names[i % 5]);
        await settled(page);
        if (i % 7 === 0) {
            await page.evaluate(() => document.getElementById('fix').click());
            await settled(page);
        }
        held.push(await page.evaluate(() => globalThis.rakelight.engine.call('memory')));
    }
    assert.ok(held.at(-1).bytes <= held[29].bytes, `[bytes] ${held.map(({ bytes }) => bytes)}`);
    assert.equal(held[49].files, held[14].files, 'of the head, and of what was fixed of it');
    assert.equal(held[49].objects, held[14].objects, `names of OpenGL ${held.map(({ objects }) => objects)}`);
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
        const line = await text(page, 'message-text'), isFault = await page.locator('#message').evaluate(box => box.classList.contains('fault') && !box.hidden);
        if (!isFault) continue;
        refused += 1;
        assert.ok(line.length > 10 && line.length < 700 && !line.includes('\n'), `${name}: ${line}`);
    }
    assert.ok(refused > hostile.length / 3, `${refused} of ${hostile.length}`);
    await page.evaluate(() => document.querySelector('[data-example=spot]').click());
    await settled(page);
    assert.equal(await text(page, 'headline'), '4 borders with a seam, largest 30.3°');
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
