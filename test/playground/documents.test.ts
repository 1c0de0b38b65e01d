/** How long a reader waits for a host; counted, since a clock would include other work of this machine. */
import { afterEach, expect, it, vi } from 'vitest';
import { openDocument } from '../../src/playground/offline/documents';
import type { KeptBuild } from '../../src/playground/offline/keptBuild';

const ADDRESS = 'https://host.example/touchdown/';
const KEPT = '<title>kept</title>';

/** The members of a stored build that are used here. */
const build = {
  find: (url: string) => Promise.resolve(url === ADDRESS ? new Response(KEPT) : undefined),
} as KeptBuild;

afterEach(() => {
  vi.restoreAllMocks();
  vi.unstubAllGlobals();
});

/** Time limits, ms, with which a document was opened; each expires at once. */
function endLimitsAtOnce(): number[] {
  const limits: number[] = [];
  vi.spyOn(AbortSignal, 'timeout').mockImplementation((ms) => {
    limits.push(ms);
    return AbortSignal.abort();
  });
  return limits;
}

/** A host that accepts and never answers: a request ends when its caller gives up. */
const neverAnswers: typeof fetch = (_, init) =>
  new Promise((_resolve, reject) => {
    const { signal } = init ?? {};
    if (signal?.aborted === true) reject(new DOMException('given up', 'AbortError'));
    signal?.addEventListener('abort', () => reject(new DOMException('given up', 'AbortError')));
  });

it('the stored document comes within 3 s when the host accepts and never answers', async () => {
  const limits = endLimitsAtOnce();
  vi.stubGlobal('fetch', neverAnswers);
  const answer = await openDocument(new Request(ADDRESS), ADDRESS, build);
  expect(await answer.text()).toBe(KEPT);
  expect(limits).toHaveLength(1);
  expect(limits[0]).toBeLessThanOrEqual(3000);
});

it('the stored document comes within 3 s when the host answers with a document, and never together with its script', async () => {
  const limits = endLimitsAtOnce();
  const html = '<script type="module" src="./assets/index-new.js"></script>';
  vi.stubGlobal('fetch', (url: string, init?: RequestInit) =>
    url === ADDRESS
      ? Promise.resolve(new Response(html, { headers: { 'content-type': 'text/html' } }))
      : neverAnswers(url, init),
  );
  const answer = await openDocument(new Request(ADDRESS), ADDRESS, build);
  expect(await answer.text()).toBe(KEPT);
  expect(Math.max(...limits)).toBeLessThanOrEqual(3000);
});
