import fc from 'fast-check';
import { ATTITUDE_MODES, type Controls, type Quat, SURFACE_STATES, type Vec3 } from '../../src/dynamics';
import { MAX_TICK } from '../../src/wire';
import type { BodyState, InputRecord, ServerFrame, ShipState, WorldEvent } from '../../src/wire';

/** Every legal record, the ends of every range included. */

export const vector = (most: number): fc.Arbitrary<Vec3> => {
  const part = fc.double({ min: -most, max: most, noNaN: true });
  return fc.tuple(part, part, part);
};

/** Of length 1 within the rounding of a division by the length. */
export const quaternion: fc.Arbitrary<Quat> = fc
  .tuple(...([1, 1, 1, 1] as const).map(() => fc.double({ min: -1, max: 1, noNaN: true })))
  .filter((q) => Math.hypot(...q) > 1e-3)
  .map((q) => {
    const length = Math.hypot(...q);
    return q.map((part) => part / length) as unknown as Quat;
  });

export const text = fc.string({ unit: 'grapheme', maxLength: 40 }).filter((t) => t.length <= 128);
export const named = text.filter((t) => t !== '');
const tick = fc.oneof(fc.integer({ min: 0, max: MAX_TICK }), fc.nat());
const substep = fc.nat(99_999);

export const controls: fc.Arbitrary<Controls> = fc.record({
  thrustLevel: fc.double({ min: 0, max: 1, noNaN: true }),
  translationInput: vector(1),
  rotationInput: vector(1),
  attitudeHold: fc.boolean(),
  attitudeMode: fc.constantFrom(...ATTITUDE_MODES),
  targetAttitude: quaternion,
});

const kilograms = fc.double({ min: 0, max: 2e15, noNaN: true });
const impactSpeed = fc.double({ min: 0, max: 1e9, noNaN: true });

/** Consistent members: with a relative state there is an impact speed; without one only if it is not 0. */
const contact = fc.oneof(
  fc.record({
    relativePosition: vector(1e18),
    relativeVelocity: vector(1e9),
    contactImpactSpeed: impactSpeed,
  }),
  fc.record({
    relativePosition: fc.constant(null),
    relativeVelocity: fc.constant(null),
    contactImpactSpeed: impactSpeed.map((speed) => (speed === 0 ? null : speed)),
  }),
);

export const ship: fc.Arbitrary<ShipState> = fc
  .tuple(
    fc.record({
      shipId: named,
      playerId: text,
      name: text,
      shipClass: text,
      position: vector(1e18),
      velocity: vector(1e9),
      attitude: quaternion,
      angularVelocity: vector(1e6),
      fuel: kilograms,
      mass: kilograms,
      wheelMomentum: fc.option(vector(1e25)),
      groundContactOffset: fc.option(fc.double({ min: 0, max: 1e6, noNaN: true })),
      landedBodyName: text,
      surfaceContactState: fc.oneof(fc.constantFrom<string>(...SURFACE_STATES), text),
      referenceBody: text,
      crashed: fc.boolean(),
    }),
    controls,
    contact,
  )
  .map(([own, commanded, touched]) => ({ ...own, ...commanded, ...touched }))
  .chain((state) =>
    fc.oneof(
      fc.constant(state),
      named.map((attitudeMode) => ({ ...state, attitudeMode })),
    ),
  );

const body: fc.Arbitrary<BodyState> = fc.record({
  name: named,
  mass: fc.double({ min: 1e-300, max: 1e40, noNaN: true }),
  radius: fc.double({ min: 1e-3, max: 1e18, noNaN: true }),
  position: vector(1e18),
  velocity: vector(1e9),
  attitude: quaternion,
  angularVelocity: vector(1e6),
});

const event = (before: number): fc.Arbitrary<WorldEvent> =>
  fc.record(
    {
      type: fc.oneof(fc.constantFrom('ship.contact', 'ship.landed', 'ship.destroyed'), named),
      shipId: named,
      tick: fc.integer({ min: 0, max: before }),
      substep: fc.option(substep),
      again: fc.constant(true as const),
      playerId: named,
      body: named,
      reason: named,
    },
    { requiredKeys: ['type', 'shipId', 'tick', 'substep'] },
  );

export const frame: fc.Arbitrary<ServerFrame> = tick.chain((at) =>
  fc.record({
    kind: fc.constant('frame'),
    tick: fc.constant(at),
    tickRate: fc.double({ min: 0.1, max: 100, noNaN: true }),
    timeScale: fc.double({ min: 0.1, max: 100, noNaN: true }),
    paused: fc.boolean(),
    bodies: fc.uniqueArray(body, { selector: ({ name }) => name, maxLength: 3 }),
    ships: fc.uniqueArray(ship, { selector: ({ shipId }) => shipId, maxLength: 3 }),
    events: fc.array(event(at), { maxLength: 3 }),
    lastInput: fc.option(
      fc.record({
        seq: fc.integer({ min: 1, max: Number.MAX_SAFE_INTEGER }),
        tick: fc.integer({ min: 0, max: at }),
        substep,
        margin: fc.double({ min: -1e9, max: 1e9, noNaN: true }),
      }),
    ),
  }),
);

export const input: fc.Arbitrary<InputRecord> = fc.record({
  seq: fc.integer({ min: 1, max: Number.MAX_SAFE_INTEGER }),
  tick,
  substep,
  controls,
});
