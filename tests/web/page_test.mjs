// SPDX-License-Identifier: Apache-2.0
// The page as a visitor uses it: a model comes in, its seams are shown, fixed and taken home.
import assert from 'node:assert/strict';
import { readFile } from 'node:fs/promises';
import { join } from 'node:path';
import test, { after, before } from 'node:test';

import { compare, explain, inspect, smooth } from 'rakelight';

import { drop, isSkipped, open, openExample, picture, settled, site, text } from './page_support.mjs';

const options = { skip: isSkipped };
const example = path => readFile(join(site, 'examples', path));
let it;

before(async () => {
    if (!isSkipped) it = await open();
});
after(() => it?.end());

const psnr = async (a, b) => {
    const report = await compare(a, b);
    return report.rows[0].equal ? Infinity : report.rows[0].psnr_db;
};

async function downloaded(page) {
    const [download] = await Promise.all([page.waitForEvent('download'), page.click('#download')]);
    return { name: download.suggestedFilename(), bytes: await readFile(await download.path()) };
}

test('an example opens: its line, its list of borders, its picture', options, async () => {
    const { page, url } = it;
    await openExample(page, url, 'spot');
    const report = await inspect(await example('spot/spot_slab5.glb'));
    assert.equal(await text(page, 'headline'), `4 borders with a seam, largest ${report.rows[0].seams.seam_deg.toFixed(1)}°`);
    assert.equal(await page.locator('#borders button').count(), report.rows[0].borders.length);
    assert.match(await page.locator('#borders button').first().textContent(), /part0 – part1\s*30\.3°/);
});

test('the heat map is drawn over the model and can be switched off', options, async () => {
    const { page } = it, withSeams = await picture(page);
    await page.uncheck('#heat');
    assert.ok(await psnr(withSeams, await picture(page)) < 40);
    assert.equal(await page.locator('#legend').isVisible(), false);
    await page.check('#heat');
    assert.equal(await psnr(withSeams, await picture(page)), Infinity);
});

test('a border of the list is flown to; all of the model is shown again', options, async () => {
    const { page } = it, whole = await picture(page);
    await page.locator('#borders button').nth(1).click();
    assert.ok(await psnr(whole, await picture(page)) < 25);
    await page.click('#end-raking');
    await page.click('#whole');
    assert.equal(await psnr(whole, await picture(page)), Infinity);
});

test('the camera is turned by drags, by the wheel and by keys', options, async () => {
    const { page } = it, still = await picture(page), box = await page.locator('#stage').boundingBox();
    const [x, y] = [box.x + box.width / 2, box.y + box.height / 2];
    const steps = [
        async () => {
            await page.mouse.move(x, y);
            await page.mouse.down();
            await page.mouse.move(x + 60, y + 20, { steps: 4 });
            await page.mouse.up();
        },
        () => page.mouse.wheel(0, 300),
        async () => {
            await page.locator('#stage canvas').focus();
            await page.keyboard.press('ArrowLeft');
            await page.keyboard.press('+');
        },
    ];
    for (const step of steps) {
        await step();
        assert.ok(await psnr(still, await picture(page)) < 30);
        await page.locator('#stage canvas').press('0');
        assert.equal(await psnr(still, await picture(page)), Infinity);
    }
});

test('Fix gives the file that the program writes; a line divides before and after', options, async () => {
    const { page } = it, before = await picture(page);
    await page.click('#fix');
    await page.waitForSelector('#download:not([hidden])');
    assert.equal(await text(page, 'headline'), 'Seams fixed: 30.3° → 0.00°');
    const half = await picture(page);
    await page.locator('#line').press('End');
    assert.equal(await psnr(before, await picture(page)), Infinity, 'all of it is before');
    await page.locator('#line').press('Home');
    const fixed = await picture(page);
    assert.ok(await psnr(before, fixed) < 45, `${await psnr(before, fixed)} dB`);
    assert.ok(await psnr(half, fixed) > await psnr(before, fixed));
    const { name, bytes } = await downloaded(page), own = await smooth({ name: 'spot_slab5.glb', bytes: await example('spot/spot_slab5.glb') });
    assert.equal(name, 'spot_slab5-smooth.glb');
    assert.ok(bytes.equals(Buffer.from(own.bytes)));
});

test('the line is dragged', options, async () => {
    const { page } = it, box = await page.locator('#line').boundingBox(), room = await page.locator('#stage').boundingBox();
    await page.mouse.move(box.x + box.width / 2, box.y + 200);
    await page.mouse.down();
    await page.mouse.move(room.x + room.width / 4, box.y + 220, { steps: 5 });
    await page.mouse.up();
    assert.equal(await page.locator('#line').getAttribute('aria-valuenow'), '25');
});

test('a model with its materials and textures is dropped and comes back as an archive', options, async () => {
    const { page } = it, names = ['head.obj', 'head.mtl', 'color.jpg', 'normal_from_bump.png'];
    const files = Object.fromEntries(await Promise.all(names.map(async name => [name, await example(`head/${name}`)])));
    await drop(page, files);
    assert.equal(await text(page, 'headline'), '11 borders with a seam, largest 40.8°');
    await page.click('#fix');
    await page.waitForSelector('#download:not([hidden])');
    const { name, bytes } = await downloaded(page), own = await smooth({ name: 'head.obj', bytes: files['head.obj'], files });
    assert.equal(name, 'head-smooth.zip');
    for (const [path, content] of Object.entries(own.files)) {
        assert.ok(bytes.includes(Buffer.from(path === 'model.obj' ? 'head.obj' : path)), path);
        assert.ok(bytes.includes(Buffer.from(content)), `the bytes of ${path}`);
    }
});

test('STL and PLY come in, too', options, async () => {
    const { page } = it;
    const stl = 'solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\nendloop\nendfacet\nendsolid a\n';
    await drop(page, { 'one.stl': Buffer.from(stl) });
    assert.match(await text(page, 'detail'), /one\.stl: 1 object, 1 triangle/);
    const ply = 'ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\nelement face 1\nproperty list uchar int vertex_indices\nend_header\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n';
    await drop(page, { 'two.ply': Buffer.from(ply) });
    assert.match(await text(page, 'detail'), /two\.ply: 1 object, 1 triangle/);
});

test('what is no model gives one clear line, and the page keeps the model before', options, async () => {
    const { page } = it;
    for (const [name, bytes, expected] of [['notes.txt', Buffer.from('hello'), /not a model that the page reads/], ['broken.glb', Buffer.from('glTF\x02\0\0\0\xff\xff\xff\xff', 'latin1'), /^broken\.glb: /]]) {
        await drop(page, { [name]: bytes });
        const line = await text(page, 'message-text');
        assert.match(line, expected);
        assert.ok(!line.includes('\n'));
        assert.match(await text(page, 'detail'), /two\.ply/);
    }
});

test('settings change the picture and stand in the link, which another visit reads', options, async () => {
    const { page, url } = it;
    await openExample(page, url, 'spot');
    await page.reload();
    await page.waitForSelector('body.open');
    const usual = await picture(page);
    await page.click('#tab-look');
    for (const [id, value] of [['lighting', 'phong'], ['shading', 'flat'], ['lights', 'side'], ['channel', 'normal']]) {
        const before = await picture(page);
        await page.selectOption(`#set-${id}`, value);
        assert.ok(await psnr(before, await picture(page)) < 45, id);
    }
    assert.equal(new URL(page.url()).hash, '#lights=side&lighting=phong&shading=flat&channel=normal&model=spot');
    const set = await picture(page);
    await page.reload();
    await page.waitForSelector('body.open');
    assert.equal(await psnr(set, await picture(page)), Infinity);
    for (const id of ['lighting', 'shading', 'lights', 'channel']) await page.locator(`#set-${id}`).evaluate(box => {
        box.selectedIndex = 0;
        box.dispatchEvent(new Event('change'));
    });
    assert.equal(await psnr(usual, await picture(page)), Infinity);
});

test('two lighting models are compared on both sides of the line', options, async () => {
    const { page } = it, one = await picture(page);
    await page.click('#tab-look');
    await page.selectOption('#set-second', 'phong');
    await settled(page);
    assert.equal(await text(page, 'right-name'), 'Phong');
    assert.ok(await psnr(one, await picture(page)) < 45);
    await page.selectOption('#set-second', '');
    assert.equal(await psnr(one, await picture(page)), Infinity);
});

test('a click explains a pixel with the numbers of the program', options, async () => {
    const { page } = it, box = await page.locator('#stage').boundingBox();
    await page.mouse.click(box.x + box.width / 2, box.y + box.height / 2);
    await page.waitForSelector('#pixel:not([hidden])');
    const [, x, y, ...codes] = (await text(page, 'pixel-title')).match(/^Pixel (\d+), (\d+): (\d+), (\d+), (\d+)$/).map(Number);
    const bytes = await example('spot/spot_slab5.glb'), resolution = [Math.round(box.width), Math.round(box.height)];
    const report = await explain(bytes, { resolution, pixel: [x, y], background: '#15171c', normals: 'object' });
    assert.deepEqual(codes, report.rows[0].codes);
    assert.match(await text(page, 'pixel-short'), /^In short: /);
    assert.ok(await page.locator('#cross').isVisible());
    const said = await text(page, 'pixel-text');
    for (const words of ['shows object', 'Triangles that cover the pixel', `sRGB code  ${codes.join(' ')}`]) assert.ok(said.includes(words), words);
});

test('hard edges are drawn, and are fewer by an angle of 180 degrees', options, async () => {
    const { page, url } = it;
    await openExample(page, url, 'knight');
    const without = await picture(page);
    await page.check('#hard');
    const byRule = await picture(page);
    assert.ok(await psnr(without, byRule) < 45);
    await page.click('#tab-look');
    await page.selectOption('#set-crease', 'angle');
    await page.locator('#set-crease-angle').evaluate(box => {
        box.value = 180;
        for (const type of ['input', 'change']) box.dispatchEvent(new Event(type));
    });
    assert.ok(await psnr(byRule, await picture(page)) < 45);
    await page.selectOption('#set-crease', 'auto');
    assert.equal(await psnr(byRule, await picture(page)), Infinity);
    await page.uncheck('#hard');
    assert.equal(await psnr(without, await picture(page)), Infinity);
});

test('settings of normals keep the camera, and Fix uses them', options, async () => {
    const { page, url } = it;
    await openExample(page, url, 'spot');
    await page.click('#tab-seams');
    await page.locator('#borders button').nth(1).click();
    const near = await picture(page);
    await page.click('#tab-look');
    await page.selectOption('#set-weight', 'uniform');
    await settled(page);
    assert.ok(await psnr(near, await picture(page)) > 25, 'the eye stays');
    await page.click('#fix');
    await page.waitForSelector('#download:not([hidden])');
    const { bytes } = await downloaded(page), own = await smooth(await example('spot/spot_slab5.glb'), { weight: 'uniform' });
    assert.ok(bytes.equals(Buffer.from(own.bytes)));
    await page.selectOption('#set-weight', 'auto');
    await settled(page);
    assert.match(await text(page, 'headline'), /^Seams fixed/, 'by the new settings');
    await page.click('#whole');
});

test('parts across a gap are joined where it is asked for', options, async () => {
    const { page } = it;
    const half = (x, sign) => `o half${x}\nv ${x} 0 0\nv ${x} 1 0\nv ${x} 2 0\nv ${x + sign} 0 -0.3\nv ${x + sign} 1 -0.3\nv ${x + sign} 2 -0.3\n`;
    const faces = sign => (sign > 0 ? 'f -6 -3 -2 -5\nf -5 -2 -1 -4\n' : 'f -3 -6 -5 -2\nf -2 -5 -4 -1\n');
    await drop(page, { 'gap.obj': Buffer.from(half(0.001, 1) + faces(1) + half(-0.001, -1) + faces(-1)) });
    assert.match(await text(page, 'gaps-text'), /^Join parts across gaps up to 0\.00\d+ units: seams there have \d/);
    const own = await smooth({ name: 'gap.obj', bytes: Buffer.from(half(0.001, 1) + faces(1) + half(-0.001, -1) + faces(-1)) }, { borderDistance: await page.evaluate(() => document.getElementById('gaps-text').textContent.match(/[\d.]+/)[0]) });
    await page.check('#join-gaps');
    await settled(page);
    await page.click('#fix');
    await page.waitForSelector('#download:not([hidden])');
    const { bytes } = await downloaded(page);
    assert.ok(bytes.equals(Buffer.from(own.bytes)));
    await openExample(page, it.url, 'spot');
    await page.click('#fix');
    await page.waitForSelector('#download:not([hidden])');
});

test('a broken file takes nothing away from the model on the page', options, async () => {
    const { page } = it;
    await drop(page, { 'spot_slab5.glb': Buffer.from('glTF broken') });
    assert.match(await text(page, 'message-text'), /^spot_slab5\.glb: /);
    const { bytes } = await downloaded(page), own = await smooth(await example('spot/spot_slab5.glb'));
    assert.ok(bytes.equals(Buffer.from(own.bytes)));
});

test('of two drops the later one counts', options, async () => {
    const { page } = it, spot = await example('spot/spot_slab5.glb'), wall = await example('wall/wall.obj');
    await Promise.all([drop(page, { 'first.glb': spot }), drop(page, { 'second.obj': wall })]);
    await settled(page);
    assert.match(await text(page, 'detail'), /^second\.obj: 1 object, 2 triangles/);
});

test('a lost context comes back, and the picture with it', options, async () => {
    const { page, url } = it;
    await openExample(page, url, 'teapot');
    const before = await picture(page);
    await page.evaluate(() => globalThis.rakelight.engine.call('loseContext'));
    await page.locator('#stage canvas').press('0');
    await settled(page);
    assert.equal(await page.locator('#message').isVisible(), false);
    await page.evaluate(() => globalThis.rakelight.engine.call('restoreContext'));
    await page.waitForFunction(count => Number(document.querySelector('#stage canvas').dataset.pictures) > count, await page.evaluate(() => Number(document.querySelector('#stage canvas').dataset.pictures)));
    assert.equal(await psnr(before, await picture(page)), Infinity);
});

test('nothing was said in the console, nothing came from elsewhere, and there are no cookies', options, async () => {
    const { problems, requests, context, url } = it;
    assert.deepEqual(problems.filter(text => !/GPU stall|404|CONTEXT_LOST|GL Driver Message/.test(text)), []);
    assert.deepEqual(requests.filter(other => !other.startsWith(url) && !/^(data|blob):/.test(other)), []);
    assert.deepEqual(await context.cookies(), []);
});
