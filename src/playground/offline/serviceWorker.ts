/**
 * Stores the built page for use without a network. Built into offline.js beside index.html, with the list of the build's files in it.
 * Another build is another script: the browser installs it when it next loads the page, and it takes over once it is complete.
 * A host turns it off for good by no longer serving offline.js: stored files are then removed.
 */
import { openDocument } from './documents';
import { createBuildCache } from './buildCache';

/** The members of ServiceWorkerGlobalScope that are used; TypeScript's library for it conflicts with the document's. */
interface WorkerScope {
  readonly registration: { readonly scope: string; readonly unregister: () => Promise<boolean> };
  readonly clients: { readonly claim: () => Promise<void> };
  readonly skipWaiting: () => Promise<void>;
  addEventListener: ((type: 'install' | 'activate', listener: (event: ExtendableEvent) => void) => void) &
    ((type: 'fetch', listener: (event: FetchEvent) => void) => void);
}

interface ExtendableEvent {
  readonly waitUntil: (work: Promise<unknown>) => void;
}

interface FetchEvent extends ExtendableEvent {
  readonly request: Request;
  readonly respondWith: (response: Promise<Response>) => void;
}

const scope = self as unknown as WorkerScope;
/** Of the document, and so of the folder it is in. */
const address = scope.registration.scope;
const build = createBuildCache(address, caches);

scope.addEventListener('install', (event) =>
  event.waitUntil(build.store().then(scope.skipWaiting.bind(scope))),
);
scope.addEventListener('activate', (event) =>
  // The page that is already open is served from here too.
  event.waitUntil(build.removeOutdated().then(() => scope.clients.claim())),
);
scope.addEventListener('fetch', (event) => {
  const { request } = event;
  if (request.method !== 'GET' || !request.url.startsWith(address)) return;
  if (request.mode !== 'navigate') event.respondWith(fromCache(request));
  else if (isDocument(request.url)) {
    event.respondWith(openDocument(request, address, build));
    // Without a network it does not change.
    event.waitUntil(restoreOrUnregister().catch(() => undefined));
  }
});

function isDocument(url: string): boolean {
  const { origin, pathname } = new URL(url);
  return origin + pathname === address || origin + pathname === `${address}index.html`;
}

async function fromCache(request: Request): Promise<Response> {
  return (await build.match(request.url)) ?? fetch(request);
}

/** Status codes for a file that is gone. */
const GONE = [404, 410];

/** Fetches evicted files again, or removes everything if the host no longer has offline.js. */
async function restoreOrUnregister(): Promise<void> {
  const script = await fetch(new URL('offline.js', address), { cache: 'no-store' });
  if (!GONE.includes(script.status)) return build.restoreEvicted();
  await build.clear();
  await scope.registration.unregister();
}
