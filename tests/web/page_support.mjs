// SPDX-License-Identifier: Apache-2.0
// The page in Debian's Chromium: a server of its files, a browser, and what tests do there again and again.
import { existsSync } from 'node:fs';
import { readFile } from 'node:fs/promises';
import { createServer } from 'node:http';
import { dirname, extname, join } from 'node:path';
import { fileURLToPath } from 'node:url';

import { chromium } from 'playwright-core';

const here = dirname(fileURLToPath(import.meta.url));
export const site = join(here, '../site');
const browser = process.env.CHROMIUM ?? '/usr/bin/chromium';
const types = { '.html': 'text/html', '.js': 'text/javascript', '.mjs': 'text/javascript', '.wasm': 'application/wasm', '.css': 'text/css', '.svg': 'image/svg+xml', '.png': 'image/png' };

/** Why the page cannot be tested here, or false. */
export const isSkipped = existsSync(browser) && existsSync(site) ? false : `${browser} or ${site} is missing`;

async function answer(request, response) {
    const path = decodeURIComponent(new URL(request.url, 'http://x').pathname).replace(/\/$/, '/index.html');
    try {
        const bytes = await readFile(join(site, path));
        response.writeHead(200, { 'content-type': types[extname(path)] ?? 'application/octet-stream' }).end(bytes);
    } catch {
        response.writeHead(404).end();
    }
}

const flags = {
    webgl: ['--use-gl=angle', '--use-angle=swiftshader', '--enable-unsafe-swiftshader', '--ignore-gpu-blocklist'],
    soft: ['--disable-gpu', '--disable-software-rasterizer'],
};

/** A browser on a server of the page. @param engine  'webgl' or 'soft': without WebGL */
export async function open({ engine = 'webgl', width = 960, height = 640, ...options } = {}) {
    const server = createServer(answer).listen(0, '127.0.0.1');
    await new Promise(resolve => server.once('listening', resolve));
    const app = await chromium.launch({ executablePath: browser, args: ['--no-sandbox', '--disable-dev-shm-usage', ...flags[engine]] });
    const context = await app.newContext({ viewport: { width, height }, reducedMotion: 'reduce', colorScheme: 'dark', acceptDownloads: true, ...options });
    const page = await context.newPage(), problems = [], requests = [];
    page.on('console', message => ['error', 'warning'].includes(message.type()) && problems.push(message.text()));
    page.on('pageerror', fault => problems.push(String(fault.stack)));
    page.on('request', request => requests.push(request.url()));
    const url = `http://127.0.0.1:${server.address().port}/`;
    const end = async () => {
        await app.close();
        server.close();
    };
    return { page, context, url, problems, requests, end };
}

/** Waits until what was asked for is done and drawn. */
export async function settled(page) {
    await page.waitForFunction(() => globalThis.rakelight?.isIdle(), null, { timeout: 60_000, polling: 50 });
    await page.evaluate(() => new Promise(resolve => requestAnimationFrame(() => requestAnimationFrame(resolve))));
}

export async function openExample(page, url, name) {
    await page.goto(`${url}#model=${name}`);
    await page.waitForSelector('body.open', { timeout: 60_000 });
    await settled(page);
}

/** Drops files onto the page. @param files  {path: bytes} */
export async function drop(page, files) {
    const given = Object.entries(files).map(([path, bytes]) => [path, Buffer.from(bytes).toString('base64')]);
    await page.evaluate(list => {
        const transfer = new DataTransfer();
        for (const [path, text] of list) transfer.items.add(new File([Uint8Array.from(atob(text), letter => letter.charCodeAt(0))], path));
        document.dispatchEvent(new DragEvent('drop', { dataTransfer: transfer, bubbles: true }));
    }, given);
    await settled(page);
}

/** The picture without what lies over it. @returns PNG */
export async function picture(page) {
    const hide = is => document.querySelectorAll('#stage > :not(canvas)').forEach(element => (element.style.visibility = is ? 'hidden' : ''));
    await settled(page);
    await page.evaluate(() => document.activeElement?.blur());  // its outline is no part of the picture
    await page.evaluate(hide, true);
    const bytes = await page.locator('#stage canvas').screenshot();
    await page.evaluate(hide, false);
    return bytes;
}

export const text = (page, id) => page.locator(`#${id}`).textContent();
