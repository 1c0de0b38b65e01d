/** The build's files in the browser's cache, and the service worker that answers from it. */
import { afterEach, beforeEach, describe, expect, it, vi } from 'vitest';
import { createBuildCache } from '../../../src/playground/offline/buildCache';

const ADDRESS = 'https://host.example/touchdown/';
const NAME = `touchdown ${ADDRESS} `;
const FILES = { '': 'sha-page', 'app.js': 'sha-app', 'page.css': 'sha-css', 'icon.svg': 'sha-icon' };
/** The host's answers by path; it has no other. */
type Host = Readonly<Record<string, readonly [text: string, type: string, status?: number]>>;
const HOST: Host = {
  '': ['<title>page</title>', 'text/html; charset=utf-8'],
  'app.js': ['run()', 'application/javascript'],
  'page.css': ['p {}', 'text/css'],
  'icon.svg': ['<svg/>', 'image/svg+xml'],
  'offline.js': ['', 'text/javascript'],
};
const pathOf = (url: string) => url.replace(ADDRESS, '');

/** The browser's caches by name: answers by address. */
function createCaches() {
  const all = new Map<string, Map<string, Response>>();
  const caches = {
    keys: () => Promise.resolve([...all.keys()]),
    delete: (name: string) => Promise.resolve(all.delete(name)),
    open(name: string) {
      const cache = all.get(name) ?? new Map<string, Response>();
      all.set(name, cache);
      return Promise.resolve({
        match: (url: string) => Promise.resolve(cache.get(url)?.clone()),
        put: (url: string, answer: Response) => Promise.resolve(void cache.set(url, answer)),
      });
    },
  };
  const stored = () =>
    [...all].map(([name, cache]) => `${name.replace(NAME, '')}: ${[...cache.keys()].map(pathOf).join(' ')}`);
  return { caches: caches as unknown as CacheStorage, all, stored };
}

/** A host; `asked` are the paths that are fetched, each with its expected hash. */
function createHost(changes: Host = {}) {
  const asked: string[] = [];
  const host = { ...HOST, ...changes };
  vi.stubGlobal('fetch', (wanted: string | URL | Request, init: RequestInit = {}) => {
    const path = pathOf(wanted instanceof Request ? wanted.url : String(wanted));
    asked.push(`${path} ${init.integrity ?? ''} ${init.cache ?? ''}`.trim());
    const [text, type, status = 200] = host[path] ?? ['', 'text/html', 404];
    return Promise.resolve(new Response(text, { status, headers: { 'content-type': type } }));
  });
  return asked;
}

beforeEach(() => {
  vi.stubGlobal('OFFLINE_FILES', FILES);
  vi.stubGlobal('OFFLINE_VERSION', 'v2');
});
afterEach(() => void vi.unstubAllGlobals());

describe('the cache of a build', () => {
  it('stores all files of the build, each fetched anew and checked by its hash', async () => {
    const { caches, stored } = createCaches();
    const asked = createHost();
    const build = createBuildCache(ADDRESS, caches);
    await build.store();
    expect(asked).toEqual([
      'sha-page reload',
      'app.js sha-app reload',
      'page.css sha-css reload',
      'icon.svg sha-icon reload',
    ]);
    expect(stored()).toEqual(['v2:  app.js page.css icon.svg']);
    const found = (await build.match(`${ADDRESS}app.js`))!;
    expect([await found.text(), found.headers.get('content-type')]).toEqual([
      'run()',
      'application/javascript',
    ]);
    expect(await build.match(`${ADDRESS}other.js`)).toBeUndefined();
  });

  it.each([
    [
      'is missing',
      { 'app.js': ['', 'text/javascript', 404] },
      'app.js: the host answered 404 text/javascript',
    ],
    ['is an error page', { 'app.js': ['', 'text/html'] }, 'app.js: the host answered 200 text/html'],
    [
      'is not a style sheet',
      { 'page.css': ['', 'text/plain'] },
      'page.css: the host answered 200 text/plain',
    ],
    ['is not a picture', { 'icon.svg': ['', 'image/png'] }, 'icon.svg: the host answered 200 image/png'],
    ['is not a document', { '': ['', 'text/htmlx'] }, 'the document: the host answered 200 text/htmlx'],
  ] as [string, Host, string][])('stores nothing if a file %s', async (_what, changes, reason) => {
    const { caches, stored } = createCaches();
    createHost(changes);
    await expect(createBuildCache(ADDRESS, caches).store()).rejects.toThrow(reason);
    expect(stored()).toEqual([]);
  });

  it('prefers its own file to one of the previous build, and never has another page’s', async () => {
    const { caches, all } = createCaches();
    const put = (name: string, path: string, text: string) =>
      all.set(name, (all.get(name) ?? new Map<string, Response>()).set(ADDRESS + path, new Response(text)));
    put(`${NAME}v1`, 'app.js', 'old');
    put(`${NAME}v1`, 'old.js', 'old');
    put(`touchdown ${ADDRESS}elsewhere/ v9`, 'other.js', 'other');
    const build = createBuildCache(ADDRESS, caches);
    const textOf = async (path: string) => (await build.match(ADDRESS + path))?.text();
    expect(await textOf('app.js')).toBe('old');
    expect(all.has(`${NAME}v2`)).toBe(false);
    put(`${NAME}v2`, 'app.js', 'new');
    expect([await textOf('app.js'), await textOf('old.js'), await textOf('other.js')]).toEqual([
      'new',
      'old',
      undefined,
    ]);
  });

  it('fetches evicted files again, and is removed two builds later', async () => {
    const { caches, all, stored } = createCaches();
    const asked = createHost();
    const build = createBuildCache(ADDRESS, caches);
    all.set('touchdown other v1', new Map());
    all.set(`${NAME}v1`, new Map());
    await build.store();
    all.get(`${NAME}v2`)!.delete(`${ADDRESS}page.css`);
    asked.length = 0;
    await build.restoreEvicted();
    expect(asked).toEqual(['page.css sha-css reload']);
    await build.removeOutdated();
    expect(stored()).toEqual(['touchdown other v1: ', 'v1: ?superseded', 'v2:  app.js icon.svg page.css']);
    await build.removeOutdated();
    expect(stored()).toEqual(['touchdown other v1: ', 'v2:  app.js icon.svg page.css']);
    await build.clear();
    expect(stored()).toEqual(['touchdown other v1: ']);
  });
});

it('the service worker answers from the cache, and unregisters once its script is gone', async () => {
  const { caches, all, stored } = createCaches();
  const done: string[] = [];
  const listeners = new Map<string, (event: object) => void>();
  const note = (what: string) => () => Promise.resolve(void done.push(what));
  vi.stubGlobal('caches', caches);
  vi.stubGlobal('self', {
    registration: { scope: ADDRESS, unregister: note('unregister') },
    clients: { claim: note('claim') },
    skipWaiting: note('skipWaiting'),
    addEventListener: (type: string, listener: (event: object) => void) => listeners.set(type, listener),
  });
  const asked = createHost();
  await import('../../../src/playground/offline/serviceWorker');
  const send = async (type: string, members: object = {}) => {
    const work: Promise<unknown>[] = [];
    const answers: Promise<Response>[] = [];
    listeners.get(type)!({
      ...members,
      waitUntil: (each: Promise<unknown>) => work.push(each),
      respondWith: (each: Promise<Response>) => answers.push(each),
    });
    const [text] = await Promise.all(answers.map(async (answer) => (await answer).text()));
    await Promise.all(work);
    return text;
  };
  const get = (url: string, mode = 'no-cors', method = 'GET') => {
    asked.length = 0;
    return send('fetch', { request: { url, mode, method } });
  };
  all.set(`${NAME}v1`, new Map());
  await send('install');
  expect([stored(), done.splice(0)]).toEqual([['v1: ', 'v2:  app.js page.css icon.svg'], ['skipWaiting']]);
  await send('activate');
  expect([stored()[0], done.splice(0)]).toEqual(['v1: ?superseded', ['claim']]);

  expect([await get(`${ADDRESS}app.js`), asked]).toEqual(['run()', []]);
  expect(await get(`${ADDRESS}app.js`, 'no-cors', 'POST')).toBeUndefined();
  expect(await get('https://host.example/elsewhere.js')).toBeUndefined();
  for (const document of ['', 'index.html', '?scenario=settle']) {
    expect(await get(ADDRESS + document, 'navigate'), document).toBe('<title>page</title>');
    expect(asked, document).toContain('offline.js  no-store');
  }
  expect(await get(`${ADDRESS}notices.txt`, 'navigate')).toBeUndefined();

  // Evicted files come again; a host that no longer has the script has turned it off.
  all.get(`${NAME}v2`)!.delete(`${ADDRESS}app.js`);
  await get(ADDRESS, 'navigate');
  expect([stored().at(-1), done]).toEqual(['v2:  page.css icon.svg app.js', []]);
  for (const status of [404, 410]) {
    createHost({ 'offline.js': ['', 'text/plain', status] });
    await send('install');
    done.length = 0;
    await get(ADDRESS, 'navigate');
    expect([stored(), done], String(status)).toEqual([[], ['unregister']]);
  }
});
