/** The mistakes of those who use the predictor for the first time, as data: what was done, and the warning that is right. */
import { BODIES, DEFAULT_SETTINGS, NEUTRAL_CONTROLS, SHIP_CLASSES } from '../../src/dynamics';
import { createPredictor, type Predictor } from '../../src/prediction';
import type { Hello, ServerFrame, ShipState } from '../../src/wire';

const LUNA = BODIES.find(({ name }) => name === 'Luna')!;
const HEIGHT = LUNA.radius + 4.56;

/** A ship that has landed on the Moon's pole side, upright along +X. */
const ship: ShipState = {
  ...{ shipId: 'a', playerId: 'p', name: 'A', shipClass: 'planetary_lander' },
  position: [LUNA.position[0] + HEIGHT, LUNA.position[1], LUNA.position[2]],
  velocity: LUNA.velocity,
  // +Z of the ship along +X.
  attitude: [0, Math.SQRT1_2, 0, Math.SQRT1_2],
  angularVelocity: [0, 0, 0],
  ...{ rotationInput: [0, 0, 0], translationInput: [0, 0, 0], thrustLevel: 0, attitudeHold: false },
  ...{ attitudeMode: 'none', targetAttitude: [0, 0, 0, 1], fuel: 100, mass: 1000 },
  ...{
    wheelMomentum: null,
    groundContactOffset: null,
    landedBodyName: 'Luna',
    surfaceContactState: 'landed',
  },
  ...{
    contactImpactSpeed: null,
    referenceBody: '',
    relativePosition: null,
    relativeVelocity: null,
    crashed: false,
  },
};
const frame: ServerFrame = {
  ...{ kind: 'frame', tick: 1, tickRate: 1, timeScale: 1, paused: false },
  ...{ bodies: [LUNA], ships: [ship], events: [], lastInput: null },
};
const hello: Hello = {
  ...{ kind: 'hello', playerId: 'p', shipId: 'a', settings: DEFAULT_SETTINGS, shipClasses: SHIP_CLASSES },
  ...{ bodies: [LUNA], terrain: 'flat', tick: 1, tickRate: 1, timeScale: 1, inputGranularity: 'tick' },
};
const withShip = (changes: object): ServerFrame => ({ ...frame, ships: [{ ...ship, ...changes }] });
const withBody = (changes: object): ServerFrame => ({
  ...frame,
  bodies: [{ ...LUNA, ...changes }],
});
const thousandth = (v: readonly number[]) => v.map((x) => x / 1000);

export interface Warning {
  readonly code: string;
  readonly message: string;
  readonly details: Readonly<Record<string, unknown>>;
}

/** The warnings of a predictor with which `use` does something. */
function warningsOf(use: (predictor: Predictor) => void, options: object = {}): Warning[] {
  const found: Warning[] = [];
  const predictor = createPredictor({
    ownShipId: 'a',
    onWarning: (code, message, details) => found.push({ code, message, details }),
    ...options,
  });
  use(predictor);
  return found;
}

export const made = (options: object) => warningsOf(() => undefined, options);
const received = (...messages: unknown[]) =>
  warningsOf((p) => messages.forEach((message, i) => p.receive(message as ServerFrame, i)));
const flown = (controls: unknown) =>
  warningsOf((p) => {
    p.receive(frame, 0);
    p.advance(controls as typeof NEUTRAL_CONTROLS, 0.01);
  });
/** Frames at 60 Hz and states at 1 Hz for `seconds`, with what each call is given. */
export const played = (
  seconds: number,
  { now = (s: number) => s, hz = 60, times = 1, receiveAt = (s: number) => s, id = 'a', take = true } = {},
) =>
  warningsOf((p) => {
    for (let i = 0; i < seconds * hz; i++) {
      const at = i / hz;
      if (i % hz === 0)
        p.receive({ ...frame, tick: 1 + i / hz, ships: [{ ...ship, shipId: id }] }, receiveAt(at));
      for (let k = 0; k < times; k++)
        p.advance({ ...NEUTRAL_CONTROLS, thrustLevel: i % 2 ? 0.001 : 0 }, now(at));
      p.view(now(at));
      if (take) p.takeOutgoing();
    }
  });

/** What was done, by the code that tells of it, and a part of the message that helps. */
export const MISTAKES: readonly (readonly [
  what: string,
  code: string,
  help: RegExp,
  run: () => Warning[],
])[] = [
  ['ownShipID', 'unknown-option', /mean ownShipId/, () => made({ ownShipID: 'a' })],
  ['shipId for ownShipId', 'unknown-option', /mean ownShipId/, () => made({ shipId: 'a' })],
  ['on_warning', 'unknown-option', /mean onWarning/, () => made({ on_warning: () => undefined })],
  ['budget', 'unknown-option', /Known are/, () => made({ budget: 1 })],
  [
    'smoothing.alongground',
    'unknown-option',
    /mean alongGround/,
    () => made({ smoothing: { alongground: 1 } }),
  ],
  ['defaults.terrains', 'unknown-default', /mean terrain/, () => made({ defaults: { terrains: 'flat' } })],
  [
    'defaults.ship_classes',
    'unknown-default',
    /mean shipClasses/,
    () => made({ defaults: { ship_classes: [] } }),
  ],
  [
    'settings in snake_case',
    'unknown-setting',
    /mean contactCrashSpeed/,
    () => made({ defaults: { settings: { contact_crash_speed: 60 } } }),
  ],
  [
    'a setting made up',
    'unknown-setting',
    /no effect/,
    () => made({ defaults: { settings: { gravity: 2 } } }),
  ],
  [
    'an angle in radians',
    'setting-in-radians',
    /degrees/,
    () => made({ defaults: { settings: { contactTippedAngleDeg: 1.4, contactSettleTiltDeg: 0.1 } } }),
  ],
  ['bytes', 'message-not-decoded', /decode/, () => received(new Uint8Array(3))],
  ['a text', 'message-not-decoded', /decode/, () => received('{"tick":1}')],
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
    'a vector {x, y, z}',
    'ship-unusable',
    /position/,
    () => received(withShip({ position: { x: 1, y: 2, z: 3 } })),
  ],
  ['NaN in a ship', 'ship-unusable', /velocity/, () => received(withShip({ velocity: [0, NaN, 0] }))],
  ['a class not known', 'ship-unusable', /class/i, () => received(withShip({ shipClass: 'zeppelin' }))],
  [
    'km',
    'position-in-kilometres',
    /metres/,
    () => received(withShip({ position: thousandth(ship.position) })),
  ],
  [
    'relative km',
    'position-in-kilometres',
    /metres/,
    () =>
      received(
        withShip({ referenceBody: 'Luna', relativePosition: [1737.4, 0, 0], relativeVelocity: [0, 0, 0] }),
      ),
  ],
  [
    'km/s',
    'velocity-in-kilometres',
    /m\/s/,
    () => received(withShip({ velocity: thousandth(ship.velocity) })),
  ],
  [
    'a relative position as ICRF',
    'ship-inside-body',
    /ICRF/,
    () => received({ ...withShip({ position: [1000, 0, 0] }), bodies: [{ ...LUNA, position: [0, 0, 0] }] }),
  ],
  [
    'degrees a second',
    'spin-in-degrees',
    /radians/,
    () => received(withShip({ angularVelocity: [0, 0, 20] })),
  ],
  [
    'attitude [w, x, y, z] of a landed ship',
    'quaternion-order',
    /\[x, y, z, w\]/,
    () =>
      received(
        withShip({
          position: [LUNA.position[0], LUNA.position[1] + HEIGHT, LUNA.position[2]],
          attitude: [Math.SQRT1_2, -Math.SQRT1_2, 0, 0],
        }),
      ),
  ],
  [
    'attitude [1, 0, 0, 0]',
    'quaternion-order',
    /\[x, y, z, w\]/,
    () => received(withShip({ attitude: [1, 0, 0, 0], landedBodyName: '', surfaceContactState: '' })),
  ],
  ['attitude in degrees', 'attitude-not-unit', /unit/, () => received(withShip({ attitude: [0, 90, 0, 0] }))],
  [
    'bodies of another tick',
    'landed-off-ground',
    /one tick/,
    () => received(withShip({ position: [ship.position[0] + 300_000, ship.position[1], ship.position[2]] })),
  ],
  ['a body nobody told', 'body-unknown', /Deimos/, () => received(withShip({ landedBodyName: 'Deimos' }))],
  ['NaN in a body', 'body-unusable', /position/, () => received(withBody({ position: [NaN, 0, 0] }))],
  [
    'a body {x, y, z}',
    'body-unusable',
    /position/,
    () => received(withBody({ position: { x: 0, y: 0, z: 0 } })),
  ],
  ['radius in km', 'body-density', /radius in m/, () => received(withBody({ radius: 1737.4 }))],
  [
    'spin of a body in degrees',
    'body-spin-in-degrees',
    /radians/,
    () => received(withBody({ angularVelocity: [0, 0, 1] })),
  ],
  ['no tempo', 'tempo-missing', /tickRate/, () => received({ kind: 'frame', tick: 1, ships: [ship] })],
  [
    'the same bodies again',
    'bodies-old',
    /velocity/,
    () => received(frame, { ...frame, tick: 2 }, { ...frame, tick: 3 }),
  ],
  [
    'an acknowledgement of the future',
    'acknowledgement-refused',
    /lastInput/,
    () => received({ ...frame, lastInput: { seq: 1, tick: 9, substep: 0, margin: 0 } }),
  ],
  [
    'thrust_level',
    'unknown-control',
    /mean thrustLevel/,
    () => flown({ ...NEUTRAL_CONTROLS, thrust_level: 1 }),
  ],
  ['part of the controls', 'controls-ignored', /translationInput/, () => flown({ thrustLevel: 1 })],
  ['a number as controls', 'controls-ignored', /object/, () => flown(1)],
  ['percent', 'controls-clamped', /Percent/, () => flown({ ...NEUTRAL_CONTROLS, thrustLevel: 50 })],
  ['now is NaN', 'now-not-finite', /seconds/, () => warningsOf((p) => p.advance(null, NaN))],
  ['now in ms', 'now-in-milliseconds', /seconds/, () => played(1, { now: (s) => s * 1000 })],
  ['now goes back', 'now-went-back', /monotonic/, () => played(1, { now: (s) => (s < 0.5 ? s : s - 0.4) })],
  ['two clocks', 'two-clocks', /one for both/, () => played(1, { receiveAt: (s) => 1.7e9 + s })],
  [
    'advance never',
    'advance-never',
    /display frame/,
    () => received(...Array.from({ length: 12 }, (_, i) => ({ ...frame, tick: i + 1 }))),
  ],
  ['advance twice', 'advance-twice', /once is enough/, () => played(1, { times: 12 })],
  ['advance seldom', 'advance-seldom', /display frame/, () => played(4, { hz: 5 })],
  ['own ship never', 'own-ship-never-seen', /setOwnShip/, () => played(12, { id: 'b' })],
  ['nothing taken', 'outgoing-not-taken', /takeOutgoing/, () => played(8, { take: false })],
  [
    'a spectator steers',
    'controls-without-ship',
    /spectator/,
    () =>
      warningsOf(
        (p) => {
          p.receive(frame, 0);
          p.advance(NEUTRAL_CONTROLS, 0.01);
        },
        { ownShipId: undefined },
      ),
  ],
  [
    'a listener that is none',
    'listener-not-function',
    /function/,
    () => warningsOf((p) => p.onEvent(undefined as unknown as () => void)),
  ],
];
