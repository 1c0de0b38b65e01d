/** The page's programs on a host that requires Trusted Types. */
import { afterEach, expect, it, vi } from 'vitest';
import { scriptUrl } from '../../src/playground/scriptUrl';

afterEach(() => vi.unstubAllGlobals());

it('a program’s address is plain where no policy is required, else made by the one policy of this page', () => {
  const made: string[] = [];
  vi.stubGlobal('location', new URL('https://game.example/touchdown/?scenario=settle'));
  expect(scriptUrl('https://elsewhere.example/a.js')).toBe('https://elsewhere.example/a.js');
  vi.stubGlobal('trustedTypes', {
    createPolicy: (name: string, rules: object) => (made.push(name), rules),
  });
  expect(scriptUrl('assets/worker.js')).toBe('assets/worker.js');
  expect(scriptUrl('https://game.example/offline.js')).toBe('https://game.example/offline.js');
  expect(() => scriptUrl('https://elsewhere.example/a.js')).toThrow(
    'https://elsewhere.example/a.js is not a program of this page',
  );
  expect(made).toEqual(['touchdown']);
});
