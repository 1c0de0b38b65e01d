import { describe, expect, it } from 'vitest';
import { networkOf, upNetworkOf } from '../../../src/playground/game/live/live';
import {
  DEFAULT_CHOICES,
  readChoices,
  setChoice,
  writeChoices,
} from '../../../src/playground/panels/choices';
import { NETWORK_PRESETS } from '../../../src/scenarios';

const read = (query: string) => readChoices(new URLSearchParams(query));

describe('choices in the URL', () => {
  it('survive a round trip', () => {
    const choices = {
      ...DEFAULT_CHOICES,
      scenario: 'slide',
      body: 'Mars',
      shipClass: 'fast_frigate',
      terrain: '',
      tickRate: 5,
      timeScale: 0.5,
      network: 'custom',
      delay: 120,
      seed: 4294967295,
      mode: 'last' as const,
      overlays: ['ghost', 'forces'] as const,
      slow: 0.25,
      server: 'wss://example.org/galaxy?x=1&y=2',
      fleet: 40,
      legacy: 1,
    };
    const again = read(writeChoices(choices));
    expect(again.complaints).toEqual([]);
    expect(again.choices).toEqual(choices);
  });

  it('are left out when they are the defaults', () => {
    expect(writeChoices({ ...DEFAULT_CHOICES })).toBe('');
    expect(read('').choices).toEqual(DEFAULT_CHOICES);
  });

  it.each([
    ['scenario=nowhere', 'scenario'],
    ['rate=0.05', 'rate'],
    ['rate=101', 'rate'],
    ['scale=', 'scale'],
    ['scale=NaN', 'scale'],
    ['seed=-1', 'seed'],
    ['seed=1.5', 'seed'],
    ['seed=4294967296', 'seed'],
    ['slow=9', 'slow'],
    ['net=constructor', 'net'],
    ['body=__proto__', 'body'],
    ['show=ghost,everything', 'show'],
    ['server=javascript:alert(1)', 'server'],
    ['server=http://example.org', 'server'],
    ['fleet=1000', 'fleet'],
    ['stalled=Infinity', 'stalled'],
  ])('%s is reported by name, and the default applies', (query, key) => {
    const { choices, complaints } = read(`${query}&mode=gravity`);
    expect(complaints).toHaveLength(1);
    expect(complaints[0]).toMatch(new RegExp(`^${key}: expected `));
    expect(choices).toEqual({ ...DEFAULT_CHOICES, mode: 'gravity' });
  });

  it('have these ranges', async () => {
    const keys = Object.keys(DEFAULT_CHOICES) as (keyof typeof DEFAULT_CHOICES)[];
    // Nothing allows a long text that ends in half a character.
    const wrong = `${'x'.repeat(30)}\uD800`;
    const lines = keys.map((name) => `${name}: ${String(setChoice({ ...DEFAULT_CHOICES }, name, wrong))}`);
    await expect(`${lines.join('\n')}\n`).toMatchFileSnapshot('golden/choices.txt');
  });

  it.each([
    ['delay', 'upDelay', 'jitter', 'upJitter', 'stalled', 'upStalled', 'stall', 'seed', 'fleet', 'legacy'],
  ] as const)('may be 0: %s', (...names) => {
    for (const name of names) expect(setChoice({ ...DEFAULT_CHOICES }, name, '0'), name).toBeNull();
    const choices = { ...DEFAULT_CHOICES, tickRate: 5, timeScale: 5 };
    for (const name of ['tickRate', 'timeScale'] as const) setChoice(choices, name, '0');
    expect(choices).toEqual(DEFAULT_CHOICES);
  });

  it('set one by one are checked the same way', () => {
    const choices = { ...DEFAULT_CHOICES };
    expect(setChoice(choices, 'tickRate', '200')).toMatch(/0.1 to 100/);
    expect(choices.tickRate).toBe(0);
    expect(setChoice(choices, 'tickRate', '20')).toBeNull();
    expect(choices.tickRate).toBe(20);
  });
});

describe('the network of the choices', () => {
  const custom = { ...DEFAULT_CHOICES, network: 'custom', delay: 100, jitter: 20, stalled: 4, stall: 300 };
  const link = { delay: 0.1, jitter: 0.02, stallShare: 0.04, stallSeconds: 0.3, stallRun: 1.5 };

  it('is a named one, or of the numbers beside it', () => {
    expect(networkOf(DEFAULT_CHOICES)).toBe(NETWORK_PRESETS.broadband);
    expect(networkOf(custom)).toEqual(link);
  });

  it.each([
    [{}, undefined],
    [{ upDelay: 7 }, { ...link, delay: 0.007 }],
    [{ upJitter: 0 }, { ...link, jitter: 0 }],
    [{ upStalled: 50 }, { ...link, stallShare: 0.5 }],
  ] as const)('has with %j another link to the server: %j', (up, expected) => {
    expect(upNetworkOf({ ...custom, ...up })).toEqual(expected);
    expect(upNetworkOf({ ...DEFAULT_CHOICES, ...up })).toBeUndefined();
  });
});
