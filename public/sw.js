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
/** How long a page has to say which version it is, in milliseconds: a sleeping tab does not. */
const PATIENCE = 1000;

self.addEventListener('install', (event) => {
  event.waitUntil(
    precache()
      .then(tidy)
      .then(() => self.skipWaiting()),
  );
});

self.addEventListener('activate', (event) => {
  event.waitUntil(self.clients.claim());
});

self.addEventListener('fetch', (event) => {
  const { request } = event;
  const { href, pathname, origin } = new URL(request.url);
  // The page asks with `no-store` whether there is a newer version: what is kept is no answer to that.
  if (request.method !== 'GET' || request.cache === 'no-store' || request.headers.has('range')) return;
  if (!href.startsWith(scope)) return;
  const file = (origin + pathname).slice(scope.length);
  if (file.startsWith('assets/')) event.respondWith(built(request));
  else if (request.mode === 'navigate' && isStart(request.url)) event.respondWith(startPage(request));
  else event.respondWith(newest(request, scope + file));
});

const isStart = (address) => {
  const { pathname, origin } = new URL(address);
  return [scope, `${scope}index.html`].includes(origin + pathname);
};

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
        if (file === START) await checkStart(answer.clone());
        await cache.put(file, plain(answer));
      }),
    );
  } catch (error) {
    await caches.delete(CACHE);
    throw error;
  }
}

/** A server that changes meanwhile may give the next version's start page, whose scripts would not be there. */
async function checkStart(answer) {
  const named = (await answer.text()).match(/assets\/[\w.-]+/g) ?? [];
  const foreign = named.find((file) => !BUILD.files.includes(file));
  if (foreign) throw new Error(`the start page names ${foreign}, which is of another version`);
}

/**
 * Of the versions before stay the last one and those that tabs are open with, which load parts of them when they are
 * first needed: by then the server no longer has them.
 */
async function tidy() {
  const older = (await ownCaches()).filter((name) => name !== CACHE).slice(0, -1);
  const entries = older.length > 0 ? await openEntries() : [];
  const isOpen = async (name) => {
    const cache = await caches.open(name);
    // A page that does not say may be of any version.
    const held = entries.map((entry) => entry === undefined || cache.match(entry, ANY));
    return (await Promise.all(held)).some(Boolean);
  };
  for (const name of older) if (!(await isOpen(name))) await caches.delete(name);
  await caches.delete('lissom-1');
}

/** The entry scripts of the pages that are open; `undefined` for one that does not say in time. */
async function openEntries() {
  const all = await self.clients.matchAll({ type: 'window', includeUncontrolled: true });
  const pages = all.filter(({ url }) => isStart(url));
  return Promise.all(
    pages.map(
      (page) =>
        new Promise((answer) => {
          const { port1, port2 } = new MessageChannel();
          port1.onmessage = ({ data }) => answer(data);
          page.postMessage('entry', [port2]);
          setTimeout(answer, PATIENCE);
        }),
    ),
  );
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
