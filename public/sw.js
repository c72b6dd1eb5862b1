// Lissom without a connection. Built files carry a hash of their content in the name and are kept as they are;
// everything else is asked of the network first, so a new version is seen as soon as there is a connection.

const CACHE = 'lissom-1';
/** A server may say that answers vary by origin; built files and pages here do not. */
const ANY = { ignoreVary: true, ignoreSearch: true };
const HASHED = /[\w.-]+-[\w-]{8}\.(?:js|css|wasm)/g;
const FIRST = ['./', './manifest.webmanifest', './icons/lissom.svg', './gallery/index.json'];
const FIRST_MODEL = ['./gallery/recipes/first.json', './gallery/dinosaur.ply'];

self.addEventListener('install', (event) => {
  event.waitUntil(precache().then(() => self.skipWaiting()));
});

self.addEventListener('activate', (event) => {
  event.waitUntil(tidy().then(() => self.clients.claim()));
});

self.addEventListener('fetch', (event) => {
  const { request } = event;
  const url = new URL(request.url);
  if (request.method !== 'GET' || url.origin !== location.origin) return;
  const isBuilt = url.pathname.includes('/assets/');
  event.respondWith(isBuilt ? cacheFirst(request) : networkFirst(request));
});

/** The start page, and from it every built file that one of them names. */
async function precache() {
  const cache = await caches.open(CACHE);
  await cache.addAll([...FIRST, ...FIRST_MODEL].map((url) => new Request(url, { cache: 'reload' })));
  await addNamed(cache, await cache.match('./', ANY));
}

async function addNamed(cache, page) {
  const seen = new Set();
  const waiting = namesIn(await page.clone().text());
  for (let name = waiting.pop(); name !== undefined; name = waiting.pop()) {
    if (seen.has(name)) continue;
    seen.add(name);
    const url = `./assets/${name}`;
    let answer = await cache.match(url, ANY);
    if (!answer) {
      answer = await fetch(url);
      if (!answer.ok) continue;
      await cache.put(url, answer.clone());
    }
    if (/\.(js|css)$/.test(name)) waiting.push(...namesIn(await answer.text()));
  }
  return seen;
}

const namesIn = (text) => [...text.matchAll(HASHED)].map(([name]) => name);

/** Caches of other layouts than this one go. */
async function tidy() {
  for (const name of await caches.keys()) if (name !== CACHE) await caches.delete(name);
}

async function cacheFirst(request) {
  const cache = await caches.open(CACHE);
  const held = await cache.match(request, ANY);
  if (held) return held;
  const answer = await fetch(request);
  if (answer.ok) await cache.put(request, answer.clone());
  return answer;
}

async function networkFirst(request) {
  const cache = await caches.open(CACHE);
  const key = request.mode === 'navigate' ? './' : request;
  try {
    const answer = await fetch(request);
    if (answer.ok) {
      await cache.put(key, answer.clone());
      if (request.mode === 'navigate') replaceOld(cache, answer.clone());
    }
    return answer;
  } catch (error) {
    const held = await cache.match(key, ANY);
    if (held) return held;
    throw error;
  }
}

/** A start page just fetched may belong to a new version: get its files, let those of older ones go. */
async function replaceOld(cache, page) {
  try {
    const named = await addNamed(cache, page);
    if (named.size === 0) return;
    for (const { url } of await cache.keys())
      if (url.includes('/assets/') && !named.has(url.slice(url.lastIndexOf('/') + 1)))
        await cache.delete(url);
  } catch {
    // The connection went meanwhile: the next visit does it.
  }
}
