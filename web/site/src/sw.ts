// SPDX-License-Identifier: Apache-2.0
// The page without a network: all its files are kept at the first visit, and examples once they were looked at.
declare const files: string[];  // set by the build
declare const version: string;  // a hash of them

const worker = self as unknown as ServiceWorkerGlobalScope;
const own = `rakelight ${worker.registration.scope} `, name = own + version;  // several copies may lie on one host

worker.addEventListener('install', event => event.waitUntil(caches.open(name).then(cache => cache.addAll(files.map(file => new Request(file, { cache: 'reload' }))))));

worker.addEventListener('activate', event => event.waitUntil((async () => {
    for (const other of await caches.keys()) if (other.startsWith(own) && other !== name) await caches.delete(other);
    await worker.clients.claim();
})()));

worker.addEventListener('fetch', event => {
    const { request } = event;
    if (!request.url.startsWith(worker.registration.scope)) return;
    if (request.method !== 'GET' || new URL(request.url).origin !== location.origin) return;
    event.respondWith((async () => {
        const cache = await caches.open(name), kept = await cache.match(request, { ignoreSearch: true });
        if (kept) return kept;
        const response = await fetch(request);
        if (response.ok && new URL(request.url).pathname.includes('/examples/')) await cache.put(request, response.clone());
        return response;
    })());
});

export {};
