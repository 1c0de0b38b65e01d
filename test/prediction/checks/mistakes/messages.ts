/** Mistakes in messages: the mistake, the expected code, and a part of the expected message. */
import { DEFAULT_SETTINGS, NEUTRAL_CONTROLS } from '../../../../src/dynamics';
import type { ServerFrame } from '../../../../src/wire';
import { type Mistake, frame, hello, received, ship, ticks, warningsOf, warningsOfLean } from './given';

const event = { type: 'ship.landed', tick: 0, substep: 3, shipId: 'a' };

export const MESSAGES: readonly Mistake[] = [
  ['bytes', 'message-not-decoded', /decode/, () => received(new Uint8Array(3))],
  ['a string', 'message-not-decoded', /decode/, () => received('{"tick":1}')],
  ['a Result', 'message-in-result', /\.value/, () => received({ ok: true, value: frame })],
  ['kind misspelt', 'message-kind', /mean frame/, () => received({ ...frame, kind: 'Frame' })],
  ['kind missing', 'message-kind', /hello, frame or pong/, () => received({ ...frame, kind: undefined })],
  ['null', 'message-kind', /kind/, () => received(null)],
  [
    'a newer minor version',
    'protocol-version',
    /1\.1.*accepted.*update/,
    () => received(frame, { ...hello, protocolVersion: '1.1' }),
  ],
  [
    'another major version',
    'protocol-version',
    /2\.0.*refused/,
    () => received(frame, { ...hello, protocolVersion: '2.0' }),
  ],
  ['tick_rate', 'unknown-field', /mean tickRate/, () => received({ ...frame, tick_rate: 1 })],
  ['ship for ships', 'unknown-field', /mean ships/, () => received({ ...frame, ship: [] })],
  ['ships by id', 'ships-missing', /list/, () => received({ ...frame, ships: { a: ship } })],
  [
    'a ship not decoded',
    'ship-not-decoded',
    /decodeFrameJson/,
    () => received({ ...frame, ships: [{ ship_id: 'a' }] }),
  ],
  [
    'events, and no feature for them',
    'feature-missing',
    /surfaceEvents.*ignored/,
    () => warningsOfLean((p) => p.receive({ ...frame, events: [event] }, 0)),
  ],
  ['no tempo', 'tempo-missing', /tickRate/, () => received({ kind: 'frame', tick: 1, ships: [ship] })],
  [
    'the same bodies again',
    'bodies-old',
    /velocity/,
    () => received(frame, { ...frame, tick: 2 }, { ...frame, tick: 3 }),
  ],
  [
    'time that no frame has, and no bodies',
    'bodies-unknown',
    /no ship is confirmed/,
    () => {
      const untold = {
        ...frame,
        bodies: [],
        ships: [{ ...ship, relativePosition: null, relativeVelocity: null }],
      };
      return received(untold, { ...untold, tick: 3, tickRate: 2 });
    },
  ],
  [
    'an acknowledgement of a later tick',
    'acknowledgement-refused',
    /lastInput/,
    () => received({ ...frame, lastInput: { seq: 1, tick: 9, substep: 0, margin: 0 } }),
  ],

  ['an ArrayBuffer', 'message-not-decoded', /decodeServerMessage/, () => received(new ArrayBuffer(3))],
  ['a Blob', 'message-not-decoded', /binaryType/, () => received(new Blob(['x']))],
  ['a promise', 'message-not-decoded', /await/, () => received(Promise.resolve(frame))],
  ['the socket’s event', 'message-not-decoded', /\.data/, () => received({ data: '{"tick":1}' })],
  [
    'parsed JSON as it is',
    'message-kind',
    /decodeFrameJson/,
    () => received({ type: 'state', tick: 1, ships: [] }),
  ],
  ['the game’s welcome', 'message-kind', /welcome/, () => received({ kind: 'welcome' })],
  [
    'message and now swapped',
    'now-not-finite',
    /seconds/,
    () => warningsOf((p) => p.receive(1 as unknown as ServerFrame, frame as unknown as number)),
  ],
  [
    'receive without now',
    'now-not-finite',
    /performance\.now\(\) \/ 1000/,
    () => warningsOf((p) => p.receive(frame, undefined as unknown as number)),
  ],
  ['tick as a string', 'message-refused', /frame\.tick.*"?42/, () => received({ ...frame, tick: '42' })],
  ['no tick', 'message-refused', /frame\.tick.*undefined/, () => received({ ...frame, tick: undefined })],
  ['a tick with a fraction', 'message-refused', /frame\.tick.*1\.5/, () => received({ ...frame, tick: 1.5 })],
  ['tickRate 0', 'message-refused', /tickRate|tick_rate/, () => received({ ...frame, tickRate: 0 })],
  [
    'a time scale below 0',
    'message-refused',
    /timeScale|time_scale/,
    () => received({ ...frame, timeScale: -1 }),
  ],
  [
    'ticks each 10 s without tickRate',
    'tick-rate-measured',
    /tickRate.*0\.1 Hz/,
    () =>
      warningsOf((p) => {
        for (const one of ticks(12))
          p.receive({ ...one, tickRate: undefined } as unknown as ServerFrame, one.tick * 10);
      }),
  ],
  [
    'ms from tick to tick for tickRate',
    'tick-rate',
    /ticks per second/,
    () => received(...ticks(12, { tickRate: 1000 })),
  ],
  [
    'a hello without its classes',
    'message-refused',
    /hello/,
    () => received({ ...hello, shipClasses: undefined }),
  ],
  [
    'a hello of a terrain that was not passed',
    'message-refused',
    /no terrain named mars/,
    () => received({ ...hello, terrain: 'mars' }),
  ],
  [
    'a hello with a setting that is invalid',
    'message-refused',
    /contactCrashSpeed/,
    () => received({ ...hello, settings: { ...DEFAULT_SETTINGS, contactCrashSpeed: 'fast' } }),
  ],
  ['a ship twice', 'ship-twice', /Send each ship once/, () => received({ ...frame, ships: [ship, ship] })],
  [
    'two predictors on one connection',
    'acknowledgement-foreign',
    /two predictors/,
    () =>
      warningsOf((p) => {
        p.receive(frame, 0);
        p.advance({ ...NEUTRAL_CONTROLS, thrustLevel: 0.5 }, 0.01);
        p.receive({ ...frame, tick: 2, lastInput: { seq: 40, tick: 1, substep: 0, margin: 0.1 } }, 1);
      }),
  ],
];
