/** How long a reader waits for a host; counted, since a clock would include other work of this machine. */
import { afterEach, describe, expect, it, vi } from 'vitest';
import { openDocument } from '../../../src/playground/offline/documents';
import type { BuildCache } from '../../../src/playground/offline/buildCache';

const ADDRESS = 'https://host.example/touchdown/';
const STORED = '<title>stored</title>';

/** The members of a stored build that are used here. */
const build = {
  match: (url: string) => Promise.resolve(url === ADDRESS ? new Response(STORED) : undefined),
} as BuildCache;

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

it('the stored document is shown within 3 s when the host accepts and never answers', async () => {
  const limits = endLimitsAtOnce();
  vi.stubGlobal('fetch', neverAnswers);
  const answer = await openDocument(new Request(ADDRESS), ADDRESS, build);
  expect(await answer.text()).toBe(STORED);
  expect(limits).toHaveLength(1);
  expect(limits[0]).toBeLessThanOrEqual(3000);
});

it('the stored document is shown within 3 s when the host answers with a document, and never together with its script', async () => {
  const limits = endLimitsAtOnce();
  const html = '<script type="module" src="./assets/index-new.js"></script>';
  vi.stubGlobal('fetch', (url: string, init?: RequestInit) =>
    url === ADDRESS
      ? Promise.resolve(new Response(html, { headers: { 'content-type': 'text/html' } }))
      : neverAnswers(url, init),
  );
  const answer = await openDocument(new Request(ADDRESS), ADDRESS, build);
  expect(await answer.text()).toBe(STORED);
  expect(Math.max(...limits)).toBeLessThanOrEqual(3000);
});

describe('a host that answers in time', () => {
  const SCRIPT = { 'content-type': 'text/javascript' };
  const page = (file: string) => `<script type="module" src="./${file}"></script>`;
  /** A host of these answers by path; everything else is not found. */
  const answers = (files: Readonly<Record<string, readonly [text: string, type: string]>>) => {
    const asked: string[] = [];
    vi.stubGlobal('fetch', (wanted: string | Request) => {
      const path = (typeof wanted === 'string' ? wanted : wanted.url).replace(ADDRESS, '');
      asked.push(path);
      const [text, type] = files[path] ?? ['not found', 'text/html'];
      const status = path in files ? 200 : 404;
      return Promise.resolve(new Response(text, { status, headers: { 'content-type': type } }));
    });
    return asked;
  };
  const open = async (cache: BuildCache = build) =>
    (await openDocument(new Request(ADDRESS), ADDRESS, cache)).text();
  const [HTML, JS, CSS] = ['text/html; charset=utf-8', 'text/javascript', 'text/css'] as const;

  it('provides its document once all that it loads is available, including the scripts’ imports', async () => {
    const asked = answers({
      '': [page('new.js'), HTML],
      'new.js': ['import("./part.js"); import("./new.js")', JS],
      'part.js': ['"./part.css"', JS],
      'part.css': ['"./missing.js"', CSS],
    });
    expect(await open()).toBe(page('new.js'));
    expect(asked).toEqual(['', 'new.js', 'part.js', 'part.css']);
  });

  it.each<[string, Readonly<Record<string, readonly [string, string]>>]>([
    ['that is not found', {}],
    ['that is no page', { '': [page('new.js'), 'application/json'], 'new.js': ['', JS] }],
    ['without scripts', { '': ['<title>sign in</title>', HTML] }],
    ['whose script is not found', { '': [page('new.js'), HTML] }],
    ['whose script is a page', { '': [page('new.js'), HTML], 'new.js': ['', HTML] }],
    ['with an import that is not found', { '': [page('new.js'), HTML], 'new.js': ['"./part.js"', JS] }],
  ])('is overruled by the stored document if its own is one %s', async (_what, files) => {
    answers(files);
    expect(await open()).toBe(STORED);
  });

  it('need not send stored scripts, and is used at once if nothing is stored', async () => {
    const stored = (files: Readonly<Record<string, Response>>) =>
      ({ match: (url: string) => Promise.resolve(files[url.replace(ADDRESS, '')]) }) as BuildCache;
    answers({ '': [page('new.js'), HTML] });
    const files = { '': new Response(STORED), 'new.js': new Response('', { headers: SCRIPT }) };
    expect(await open(stored(files))).toBe(page('new.js'));
    const asked = answers({ '': ['the host’s', 'text/plain'] });
    expect(await open(stored({}))).toBe('the host’s');
    expect(asked).toEqual(['']);
  });
});
