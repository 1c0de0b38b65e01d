/** Typical mistakes of a page that uses the HUDs: each is named, by the constructor or by one warning. */
import { describe, expect, it } from 'vitest';
import { createCockpitLandingHud, createFleetHud, createFlightHud } from '../../src/hud';
import { checked, requireHost } from '../../src/hud/checks';
import { createFlightReadout, createLandingReadout } from '../../src/readout';

const page = { createElement: () => ({}) };
const host = { append: () => undefined, nodeType: 1 };
const whole = { append: () => undefined, nodeType: 9 };

type Create = (...given: readonly unknown[]) => unknown;
const HUDS: readonly (readonly [name: string, create: Create])[] = [
  ['createCockpitLandingHud', createCockpitLandingHud as Create],
  ['createFleetHud', createFleetHud as Create],
  ['createFlightHud', createFlightHud as Create],
];

const THROWN: readonly (readonly [what: string, given: readonly unknown[], help: RegExp])[] = [
  ['no arguments', [], /^document: expected the page's document first, got Undefined/],
  ['the host first', [host, page], /^document: /],
  ['no host', [page], /^host: expected an element or a shadow root, got Undefined.*in the page/],
  ['the document for the host', [page, whole], /^host: .*got the document: pass its body/],
  ['options of null', [page, host, null], /^options: expected an object, got Null/],
  ['a theme for the options', [page, host, 'light'], /^options: expected an object, got String/],
  ['a list for a theme', [page, host, { theme: ['dark'] }], /^options\.theme: expected dark, light, system/],
  [
    'a width for the layout',
    [page, host, { layout: 320 }],
    /^options\.layout: expected auto, full, compact, got 320/,
  ],
  ['a table of keys', [page, host, { keyLabel: { main: 'F' } }], /^options\.keyLabel: .*Object/],
  ['keys for turnKeys', [page, host, { turnKeys: ['W'] }], /^options\.turnKeys: .*Array/],
  ['the console to warn', [page, host, { onWarning: {} }], /^options\.onWarning: expected a function/],
];

describe.each(HUDS)('an invalid argument of %s is named', (_name, create) => {
  it.each(THROWN)('%s', (_what, given, help) => {
    expect(() => create(...given)).toThrow(RangeError);
    expect(() => create(...given)).toThrow(help);
  });
});

it('an option of another library is warned of, with those that exist', () => {
  const found: string[] = [];
  const onWarning = (code: string, message: string) => found.push(`${code}: ${message}`);
  requireHost(page as never, host as never, { darkMode: true, lang: 'en', onWarning });
  expect(found).toEqual([
    'hud-option: options.darkMode, lang: unknown and ignored. Known: theme, layout, keyLabel, turnKeys, onWarning.',
  ]);
});

/** A painter of these readouts, what it painted, and its warnings. */
function painter(members: readonly string[], changes: object = {}) {
  const painted: unknown[] = [];
  const warnings: string[] = [];
  const root = { isConnected: true, clientWidth: 1, ownerDocument: {}, ...changes };
  const hud = {
    root,
    members,
    madeBy: 'x',
    paint: (readout: unknown) => painted.push(readout),
    dispose: () => undefined,
  };
  const { paint } = checked(hud as never, (code, message) => warnings.push(`${code}: ${message}`));
  return { paint: paint, painted, warnings };
}

const landing = ['status', 'descent', 'touchdown'];
it.each([
  ['nothing', landing, undefined, /without status, descent, touchdown/],
  ['a view', landing, { own: null, ships: [], ready: true }, /without status/],
  ['the readout of flying', landing, createFlightReadout(), /without/],
  ['the readout alone', ['flight', 'aids', 'target'], createFlightReadout(), /without flight/],
  ['flight without aids', ['flight', 'aids', 'target'], { flight: createFlightReadout() }, /without aids/],
])('%s to paint is warned of once, and paints nothing', (_what, members, readout, help) => {
  const { paint, painted, warnings } = painter(members);
  paint(readout);
  paint(readout);
  expect(painted).toEqual([]);
  expect(warnings).toHaveLength(1);
  expect(warnings[0]).toMatch(/^hud-readout: /);
  expect(warnings[0]).toMatch(help);
});

it('a readout is painted without a warning', () => {
  const { paint, painted, warnings } = painter(landing);
  paint(createLandingReadout());
  expect([painted.length, warnings]).toEqual([1, []]);
});

const styled = (ink: string) => ({
  ownerDocument: { defaultView: { getComputedStyle: () => ({ getPropertyValue: () => ink }) } },
});

it.each([
  ['in sight', styled('#fff'), []],
  ['without its style sheet', styled(''), ['hud-unstyled']],
  ['outside the page', { isConnected: false, clientWidth: 0 }, ['hud-detached']],
  ['without room', { clientWidth: 0 }, ['hud-no-room']],
])('a HUD %s is looked at once, at its sixtieth paint', (_what, root, codes) => {
  const { paint, warnings } = painter(landing, root);
  const found = () => warnings.map((warning) => warning.split(':')[0]);
  for (let n = 1; n < 60; n++) paint(createLandingReadout());
  expect(found()).toEqual([]);
  for (let n = 60; n < 130; n++) paint(createLandingReadout());
  expect(found()).toEqual(codes);
});

it('a HUD is disposed once; after that it paints nothing and warns once', () => {
  let disposed = 0;
  const warnings: string[] = [];
  const painted: unknown[] = [];
  const hud = {
    root: { isConnected: true, clientWidth: 1, ownerDocument: {} },
    members: landing,
    madeBy: 'x',
    paint: (readout: unknown) => painted.push(readout),
    dispose: () => (disposed += 1),
  };
  const { paint, dispose } = checked(hud as never, (code) => warnings.push(code));
  dispose();
  dispose();
  paint(createLandingReadout());
  paint(createLandingReadout());
  expect([disposed, painted, warnings]).toEqual([1, [], ['hud-disposed']]);
});
