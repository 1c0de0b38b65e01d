/**
 * Keeps the built page for use without a network. Built into offline.js beside index.html, with the list of the build's files in it:
 * another build is another script, which the browser installs when it next loads the page. The document comes from the network while
 * there is one, so that a new deployment is seen at once; everything else has its content's hash in its name and comes from the cache.
 */

/** The build's files but the document, as addresses relative to it; put in by the build. */
declare const OFFLINE_FILES: readonly string[];
/** Of all that is kept. */
declare const OFFLINE_VERSION: string;

/** What of a service worker's scope is used here; TypeScript has it in a library that cannot stand beside the document's. */
interface Scope {
  readonly registration: { readonly scope: string };
  readonly clients: { readonly claim: () => Promise<void> };
  addEventListener: ((type: 'install' | 'activate', listener: (event: Lasting) => void) => void) &
    ((type: 'fetch', listener: (event: Asked) => void) => void);
}

interface Lasting {
  readonly waitUntil: (work: Promise<unknown>) => void;
}

interface Asked {
  readonly request: Request;
  readonly respondWith: (response: Promise<Response>) => void;
}

const scope = self as unknown as Scope;
/** Of the document, and so of the folder it is in. */
const address = scope.registration.scope;
/** Caches belong to the whole host: this page's begin with its address. */
const mine = `touchdown ${address} `;
const current = mine + OFFLINE_VERSION;

scope.addEventListener('install', (event) => event.waitUntil(keep()));
scope.addEventListener('activate', (event) => event.waitUntil(begin()));
scope.addEventListener('fetch', (event) => {
  const { request } = event;
  if (request.method !== 'GET' || !request.url.startsWith(address)) return;
  if (request.mode === 'navigate') {
    if (isDocument(request.url)) event.respondWith(fromNetwork(request));
  } else event.respondWith(fromCache(request));
});

/** All or nothing: half a page is no page. The document is fetched anew, past the browser's own cache. */
async function keep(): Promise<void> {
  const cache = await caches.open(current);
  const response = await fetch(address, { cache: 'reload' });
  if (!response.ok) throw new Error(`${address} answered ${response.status}`);
  // A host may have redirected, and an answer that says so is refused where a page is asked for.
  await cache.put(address, new Response(await response.blob(), { headers: response.headers }));
  await cache.addAll(OFFLINE_FILES.map((file) => new URL(file, address).href));
}

async function begin(): Promise<void> {
  for (const name of await caches.keys())
    if (name.startsWith(mine) && name !== current) await caches.delete(name);
  // The page that is open already, too.
  await scope.clients.claim();
}

function isDocument(url: string): boolean {
  const { origin, pathname } = new URL(url);
  return origin + pathname === address || origin + pathname === `${address}index.html`;
}

async function fromNetwork(request: Request): Promise<Response> {
  try {
    return await fetch(request);
  } catch (error) {
    const kept = await (await caches.open(current)).match(address);
    if (kept === undefined) throw error;
    return kept;
  }
}

async function fromCache(request: Request): Promise<Response> {
  return (await (await caches.open(current)).match(request)) ?? fetch(request);
}
