/**
 * One build of the page in the browser's cache: all of its files or none, each with the build's bytes. A host that
 * answers a script's address with an error page, or serves a mix of two builds, is not stored.
 */

/** The build's files by address relative to the document, '' being the document: their SHA-256, as fetch's `integrity` has it. */
declare const OFFLINE_FILES: Readonly<Record<string, string>>;
/** Changes with any of them. */
declare const OFFLINE_VERSION: string;

/** ms for one file while storing: a host that never answers must not block the worker. */
const FILE_LIMIT = 60_000;
/** Marks a cache whose build was replaced: the pages still open may need it, those of the next replacement do not. */
const SUPERSEDED = '?superseded';

/** The media type that a host must send for the browser to accept a file. */
const TYPES: readonly (readonly [ending: RegExp, type: RegExp])[] = [
  [/(^|\.html)$/, /^text\/html\b/],
  [/\.js$/, /^(text|application)\/(x-)?javascript\b/],
  [/\.css$/, /^text\/css\b/],
  [/\.svg$/, /^image\/svg\+xml\b/],
];

/** Of the page at `address`, a folder's URL. Caches belong to the whole origin: this page's names begin with its address. */
export interface BuildCache {
  /** Fetches all files. Rejects and stores nothing if one is missing or not the build's. */
  store(): Promise<void>;
  /** The stored answer to a request of this build or of the previous one, which open pages may still show. */
  match(url: string): Promise<Response | undefined>;
  /** Fetches files again that the browser has evicted. */
  restoreEvicted(): Promise<void>;
  /** Removes builds that no open page can show. */
  removeOutdated(): Promise<void>;
  /** Removes everything. */
  clear(): Promise<void>;
}

export function createBuildCache(address: string, caches: CacheStorage): BuildCache {
  const mine = `touchdown ${address} `;
  const current = mine + OFFLINE_VERSION;
  const urlOf = (file: string) => new URL(file, address).href;
  const namesOfMine = async () => (await caches.keys()).filter((name) => name.startsWith(mine));

  async function storeFile(cache: Cache, file: string): Promise<void> {
    const response = await fetch(urlOf(file), {
      cache: 'reload',
      integrity: OFFLINE_FILES[file]!,
      signal: AbortSignal.timeout(FILE_LIMIT),
    });
    const type = response.headers.get('content-type') ?? '';
    const expected = TYPES.find(([ending]) => ending.test(file))?.[1];
    if (!response.ok || expected?.test(type) === false)
      throw new Error(`${file || 'the document'}: the host answered ${response.status} ${type}`);
    // A host may have redirected: browsers refuse a redirected response to a navigation.
    await cache.put(urlOf(file), new Response(await response.blob(), { headers: response.headers }));
  }

  return {
    async store() {
      const cache = await caches.open(current);
      try {
        await Promise.all(Object.keys(OFFLINE_FILES).map((file) => storeFile(cache, file)));
      } catch (error) {
        await caches.delete(current);
        throw error;
      }
    },
    async match(url) {
      const names = await namesOfMine();
      for (const name of [current, ...names.filter((each) => each !== current)]) {
        if (!names.includes(name)) continue;
        const found = await (await caches.open(name)).match(url, { ignoreVary: true });
        if (found !== undefined) return found;
      }
      return undefined;
    },
    async restoreEvicted() {
      const cache = await caches.open(current);
      for (const file of Object.keys(OFFLINE_FILES))
        if ((await cache.match(urlOf(file))) === undefined) await storeFile(cache, file);
    },
    async removeOutdated() {
      for (const name of await namesOfMine()) {
        if (name === current) continue;
        const cache = await caches.open(name);
        if ((await cache.match(urlOf(SUPERSEDED))) === undefined)
          await cache.put(urlOf(SUPERSEDED), new Response());
        else await caches.delete(name);
      }
    },
    async clear() {
      for (const name of await namesOfMine()) await caches.delete(name);
    },
  };
}
