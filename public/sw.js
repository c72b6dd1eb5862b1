// Lissom without a connection. What the build made is fetched at once and kept under the build's version, so a
// page without a connection never has files of two versions. Of everything else what was once seen is kept.
// With a connection the start page and all files whose names carry no hash come from the network.

/** Version and files of this build; the build writes them here. */
const BUILD = /* build */ { version: 'none', files: [] };

const { scope } = self.registration;
const OWN = `lissom ${scope} `;
const CACHE = OWN + BUILD.version;
/** Files that are no part of the build's list: the gallery. */
const SEEN = `lissom-seen ${scope}`;
const START = './';
/** A server may say that answers vary by origin; files here do not. */
const ANY = { ignoreVary: true, ignoreSearch: true };

self.addEventListener('install', (event) => {
  event.waitUntil(precache().then(() => self.skipWaiting()));
});

self.addEventListener('activate', (event) => {
  event.waitUntil(tidy().then(() => self.clients.claim()));
});

self.addEventListener('fetch', (event) => {
  const { request } = event;
  const { href, pathname, origin } = new URL(request.url);
  // The page asks with `no-store` whether there is a newer version: what is kept is no answer to that.
  if (request.method !== 'GET' || request.cache === 'no-store' || request.headers.has('range')) return;
  if (!href.startsWith(scope)) return;
  const file = (origin + pathname).slice(scope.length);
  if (file.startsWith('assets/')) event.respondWith(built(request));
  else if (request.mode === 'navigate' && (file === '' || file === 'index.html'))
    event.respondWith(startPage(request));
  else event.respondWith(newest(request, scope + file));
});

/** All of the build's files, or none: then the version before goes on. */
async function precache() {
  const cache = await caches.open(CACHE);
  try {
    await Promise.all(
      BUILD.files.map(async (file) => {
        const isHashed = file.startsWith('assets/');
        const held = isHashed ? await heldAnywhere(file) : undefined;
        const answer = held ?? (await fetch(file, { cache: isHashed ? 'default' : 'reload' }));
        if (!answer.ok) throw new Error(`${file} answers ${answer.status}`);
        await cache.put(file, plain(answer));
      }),
    );
  } catch (error) {
    await caches.delete(CACHE);
    throw error;
  }
}

/** The version before this one stays: tabs that are still open with it load parts of it when they need them. */
async function tidy() {
  const others = (await ownCaches()).filter((name) => name !== CACHE);
  const old = ['lissom-1', ...others.slice(0, -1)];
  await Promise.all(old.map((name) => caches.delete(name)));
}

async function built(request) {
  return (await heldAnywhere(request)) ?? fetch(request);
}

async function startPage(request) {
  const held = () => caches.match(START, { ...ANY, cacheName: CACHE });
  try {
    const answer = await fetch(request);
    return answer.status < 500 ? answer : ((await held()) ?? answer);
  } catch (error) {
    const page = await held();
    if (page) return page;
    throw error;
  }
}

/** @param address  what it is kept under: never that of another file */
async function newest(request, address) {
  try {
    const answer = await fetch(request);
    if (answer.status === 200 && !(await caches.match(address, { ...ANY, cacheName: CACHE }))) {
      const cache = await caches.open(SEEN);
      await cache.put(address, plain(answer.clone())).catch(() => {}); // no room: it was only for later
    }
    return answer;
  } catch (error) {
    for (const cacheName of [CACHE, SEEN]) {
      const held = await caches.match(address, { ...ANY, cacheName });
      if (held) return held;
    }
    throw error;
  }
}

/** In the caches of this version or of those before. */
async function heldAnywhere(request) {
  for (const cacheName of [CACHE, ...(await ownCaches())]) {
    const held = await caches.match(request, { ...ANY, cacheName });
    if (held) return held;
  }
  return undefined;
}

/** Oldest first. */
const ownCaches = async () => (await caches.keys()).filter((name) => name.startsWith(OWN));

/** An answer that came by a detour may not be given for a page. */
const plain = (answer) =>
  answer.redirected ? new Response(answer.body, { status: answer.status, headers: answer.headers }) : answer;
