/** Mistakes that the public API refuses or throws for, each with advice in the message. */
import { describe, expect, it } from 'vitest';
import { createGameConnection } from '../../../src/game';
import { createCockpitLandingHud, createFleetHud } from '../../../src/hud';
import { requireHost } from '../../../src/hud/checks';
import {
  createFleetReadout,
  createLandingReadout,
  createPredictor,
  decodeFrameJson,
  decodeHelloJson,
  encodeControlsJson,
  NEUTRAL_CONTROLS,
  type Result,
  updateFleetReadout,
  updateLandingReadout,
} from '../../../src/index';
import { decodeServerMessage, encodeClientMessage } from '../../../src/protobuf';

const text = '{"tick":1,"ships":[]}';
const bytes = new TextEncoder().encode(text);

type Refused = readonly [what: string, run: () => Result<unknown>, help: RegExp];
const frameOf = (value: unknown) => () => decodeFrameJson(value);
const helloOf = (value: unknown) => () => decodeHelloJson(value);
const bytesOf = (value: unknown) => () => decodeServerMessage(value as Uint8Array);

const REFUSED: readonly Refused[] = [
  ['JSON as a string', frameOf(text), /string.*JSON\.parse/],
  ['JSON as bytes', frameOf(bytes), /Uint8Array.*decodeServerMessage/],
  ['JSON as an ArrayBuffer', frameOf(bytes.buffer), /ArrayBuffer.*decodeServerMessage/],
  ['a Blob', frameOf(new Blob([text])), /Blob.*text\(\)/],
  ['a promise', frameOf(Promise.resolve({})), /Promise.*await/],
  ['the socket’s event', frameOf(new MessageEvent('message', { data: text })), /\.data/],
  ['a frame decoded already', frameOf(decodeFrameJson(JSON.parse(text))), /Result.*\.value/],
  [
    'a frame in its envelope',
    frameOf({ type: 'state', payload: JSON.parse(text) as object }),
    /tick.*payload/,
  ],
  ['a frame without ships', frameOf({ tick: 1 }), /ships: missing/],
  ['undefined', frameOf(undefined), /message: missing/],
  ['a frame as a hello', helloOf(JSON.parse(text)), /decodeFrameJson/],
  ['nothing of a hello', helloOf({}), /at least one of .*settings/],
  ['a string as a hello', helloOf(text), /JSON\.parse/],
  ['a setting as a string', helloOf({ settings: { contact_crash_speed: 'fast' } }), /contact_crash_speed/],
  ['JSON’s text to the protobuf decoder', bytesOf(text), /string.*decodeFrameJson/],
  ['JSON’s bytes to the protobuf decoder', bytesOf(bytes), /decodeFrameJson/],
  ['an ArrayBuffer to the protobuf decoder', bytesOf(new ArrayBuffer(4)), /new Uint8Array\(buffer\)/],
  ['a Blob to the protobuf decoder', bytesOf(new Blob(['x'])), /binaryType/],
  ['an event to the protobuf decoder', bytesOf({ data: bytes }), /\.data/],
  ['null to the protobuf decoder', bytesOf(null), /Uint8Array/],
  ['undefined to the protobuf decoder', bytesOf(undefined), /Uint8Array/],
  ['restore of a string', () => createPredictor().restore('{}', 0), /JSON\.parse/],
  [
    'configure of a list',
    () => createPredictor().configure({ shipClasses: {} } as object),
    /configure: .*shipClasses/,
  ],
];

describe('an undecodable message is refused, with what to do', () => {
  it.each(REFUSED)('%s', (_what, run, help) => {
    const outcome = run();
    expect(outcome.ok).toBe(false);
    if (!outcome.ok) expect(outcome.reason).toMatch(help);
  });
});

const clock = { now: () => 0, after: () => () => undefined };
const link = {
  address: 'ws://127.0.0.1/ws',
  token: 't',
  clock,
  jitter: () => 0,
  openSocket: () => ({ close: () => undefined, send: () => undefined }),
};
const connect =
  (options: object, handlers: unknown = { onFrame: () => undefined }) =>
  () =>
    createGameConnection({ ...link, ...options } as never, handlers as never);
const page = { createElement: () => ({}) };
const hud =
  (document: unknown, host: unknown, options = {}) =>
  () =>
    createCockpitLandingHud(document as Document, host as Element, options);
const view = createPredictor().view(0);
/** As a page's WebSocket, which node 20 does not have. */
class Socket {
  static readonly CONNECTING = 0;
  close(): void {}
}

const THROWN: readonly (readonly [what: string, run: () => unknown, help: RegExp])[] = [
  ['http for ws', connect({ address: 'http://127.0.0.1' }), /options\.address: expected ws/],
  ['no token', connect({ token: undefined }), /options\.token.*login/],
  ['no clock', connect({ clock: performance }), /options\.clock\.after: expected a function/],
  ['Date.now for the clock', connect({ clock: Date.now }), /options\.clock/],
  ['a socket for openSocket', connect({ openSocket: {} }), /options\.openSocket: expected a function/],
  ['a header for the token', connect({ token: 'Bearer a.b.c' }), /options\.token: .*Bearer/],
  ['url for address', connect({ url: 'ws://x' }), /options\.url: unknown.*address/],
  ['a handler that does not exist', connect({}, { onFrame: () => 0, onState: () => 0 }), /handlers\.onState/],
  ['the class of the socket', connect({ openSocket: Socket }), /new WebSocket\(address\)/],
  [
    'Unix time for the clock',
    connect({ clock: { ...clock, now: () => 1.8e12 } }),
    /options\.clock\.now: .*performance/,
  ],
  ['onframe', connect({}, { onframe: () => undefined }), /handlers\.onFrame: expected a function/],
  ['no handlers', connect({}, null), /^handlers: .*onFrame, got null/],
  ['a HUD without the document', hud({ append: () => undefined }, {}), /document: expected/],
  ['a HUD in an element that is not there', hud(page, null), /host: .*Is it in the page/],
  ['a HUD in a selector', hud(page, '#hud'), /host: .*String/],
  [
    'a text for a handler',
    hud(page, { append: () => undefined }, { keyLabel: 'W' }),
    /options\.keyLabel: .*String/,
  ],
  ['another theme', hud(page, { append: () => undefined }, { theme: 'night' }), /options\.theme: .*"night"/],
  [
    'another layout',
    () => createFleetHud(page as never, { append: () => undefined } as never, { layout: 'small' as 'full' }),
    /options\.layout/,
  ],
  [
    'part of the controls',
    () => encodeControlsJson({ thrustLevel: 1 } as never),
    /controls\.translationInput/,
  ],
  ['no controls', () => encodeControlsJson(null as never), /controls\.thrustLevel.*NEUTRAL_CONTROLS/],
  [
    'NaN in controls',
    () => encodeControlsJson({ ...NEUTRAL_CONTROLS, thrustLevel: NaN }),
    /thrustLevel.*NaN/,
  ],
  ['controls for a message', () => encodeClientMessage(NEUTRAL_CONTROLS as never), /takeOutgoing/],
  ['all messages for one', () => encodeClientMessage([] as never), /each message of takeOutgoing/i],
  [
    'view and readout the wrong way round',
    () => updateLandingReadout(view as never, createLandingReadout() as never),
    /updateLandingReadout\(readout, view\)/,
  ],
  [
    'the same of the fleet',
    () => updateFleetReadout(view as never, createFleetReadout() as never),
    /updateFleetReadout\(readout, view\)/,
  ],
  [
    'one ship’s view for the world’s',
    () => updateLandingReadout(createLandingReadout(), { shipId: 'a', own: true } as never),
    /all that predictor\.view returns/,
  ],
  ['createPredictor of an address', () => createPredictor('ws://x' as never), /options: expected an object/],
  ['a height for a terrain', () => createPredictor({ terrains: { luna: 0 } as never }), /options\.terrains/],
  ['terrains in a Map', () => createPredictor({ terrains: new Map() as never }), /options\.terrains.*a Map/],
  [
    'classes by name',
    () => createPredictor({ defaults: { shipClasses: {} as never } }),
    /shipClasses: .*list/,
  ],
  [
    'bodies by name',
    () => createPredictor({ defaults: { bodies: {} as never } }),
    /defaults\.bodies: .*list/,
  ],
  ['a body without a radius', () => createPredictor({ defaults: { bodies: [{}] as never } }), /bodies\[0\]/],
  ['settings of a number', () => createPredictor({ defaults: { settings: 7 as never } }), /settings/],
  ['a plan of controls', () => createPredictor({ plan: [NEUTRAL_CONTROLS] as never }), /options\.plan/],
];

describe('an invalid argument is named', () => {
  it.each(THROWN)('%s', (_what, run, help) => {
    expect(run).toThrow(help);
  });
});

it('a view before the first frame reads as no ship', () => {
  expect(updateLandingReadout(createLandingReadout(), null).status).toBe('none');
  expect(updateFleetReadout(createFleetReadout(), null).count).toBe(0);
});

it('invalid controls are refused by the connection, not thrown', () => {
  const reasons: string[] = [];
  const connection = createGameConnection(link as never, {
    onFrame: () => undefined,
    onRefused: (reason) => reasons.push(reason),
  });
  expect(connection.sendControls({ thrustLevel: 1 } as never)).toBe(false);
  expect(reasons[0]).toContain('controls.translationInput');
  connection.dispose();
});

it('an option that no HUD has is reported with those that exist', () => {
  const found: string[] = [];
  const onWarning = (code: string, message: string) => found.push(`${code}: ${message}`);
  requireHost(page as never, { append: () => undefined } as never, {
    theme: 'dark',
    themes: 'light',
    onWarning,
  });
  expect(found).toHaveLength(1);
  expect(found[0]).toMatch(/^hud-option: options\.themes: .*theme, layout, keyLabel/);
});
