import type { BuildCache } from './buildCache';

/**
 * The document that a reader gets: the host's if it answers in time and its scripts are available, so that a new deployment is seen
 * at once; otherwise the stored one, complete. Never a document of one build with scripts of another.
 */

/** ms for the host to answer; then the stored page is shown. */
const HOST_LIMIT = 2000;

/** The scripts and style sheets of a document, and those that they import. */
const NEEDED = /["'`](\.\/[\w./-]+\.(?:js|css))["'`]/g;

export async function openDocument(request: Request, address: string, build: BuildCache): Promise<Response> {
  const stored = await build.match(address);
  if (stored === undefined) return fetch(request);
  try {
    const limit = AbortSignal.timeout(HOST_LIMIT);
    const host = await fetch(request.url, { signal: limit, cache: 'no-cache' });
    const isPage = host.ok && (host.headers.get('content-type') ?? '').startsWith('text/html');
    if (!isPage) return stored;
    const text = await host.text();
    if (text === (await stored.clone().text()) || !(await canBeOpened(text, address, build, limit)))
      return stored;
    return new Response(text, { headers: host.headers });
  } catch {
    return stored;
  }
}

/** Whether everything that a new document may load is stored, or answered as a script or a style sheet. */
async function canBeOpened(
  text: string,
  address: string,
  build: BuildCache,
  signal: AbortSignal,
): Promise<boolean> {
  const seen = new Set<string>();
  const filesIn = (code: string, at: string) =>
    [...code.matchAll(NEEDED)].map(([, file]) => new URL(file!, at).href);
  const answers = async (url: string): Promise<boolean> => {
    if (seen.has(url)) return true;
    seen.add(url);
    const response = (await build.match(url)) ?? (await fetch(url, { signal }));
    const type = response.headers.get('content-type') ?? '';
    if (!response.ok || !/javascript|text\/css/.test(type)) return false;
    const further = type.includes('javascript') ? filesIn(await response.text(), url) : [];
    return (await Promise.all(further.map(answers))).every(Boolean);
  };
  const first = filesIn(text, address);
  return first.length > 0 && (await Promise.all(first.map(answers))).every(Boolean);
}
