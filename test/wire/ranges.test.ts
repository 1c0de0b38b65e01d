import { expect, it } from 'vitest';
import {
  decodeClientMessage,
  decodeServerMessage,
  encodeClientMessage,
  encodeServerMessage,
  type Hello,
  type InputRecord,
  MAX_BODIES,
  MAX_INPUTS,
  MAX_SHIPS,
  type ServerFrame,
  type ShipState,
} from '../../src/wire';
import { BODY, EVENT, FRAME, HELLO, INPUT, SHIP } from './messages';

/** Encodes a record outside the allowed ranges and returns the reason of its refusal, or '' if it is accepted. */

function reasonOf(message: ServerFrame | Hello): string {
  const decoded = decodeServerMessage(encodeServerMessage(message));
  return decoded.ok ? '' : decoded.reason;
}

const frameReason = (change: object) => reasonOf({ ...FRAME, ...change });
const helloReason = (change: object) => reasonOf({ ...HELLO, ...change });
const shipReason = (change: object) => frameReason({ ships: [{ ...SHIP, ...change }] });
const bodyReason = (change: object) => frameReason({ bodies: [{ ...BODY, ...change }] });
const eventReason = (change: object) => frameReason({ events: [EVENT, { ...EVENT, ...change }] });
const settingsReason = (change: object) => helloReason({ settings: { ...HELLO.settings, ...change } });
const classReason = (change: object) =>
  helloReason({ shipClasses: [{ ...HELLO.shipClasses[0]!, ...change }] });

function inputsReason(inputs: readonly InputRecord[]): string {
  const decoded = decodeClientMessage(encodeClientMessage({ kind: 'inputs', inputs }));
  return decoded.ok ? '' : decoded.reason;
}

it.each([
  [{ shipId: '' }, 'ship_id: expected a non-empty string'],
  [
    { position: [0, 2e18, 0] },
    'position.y: expected -1000000000000000000 to 1000000000000000000 m, got 2000000000000000000',
  ],
  [{ velocity: [0, 0, -2e9] }, 'velocity.z: expected -1000000000 to 1000000000 m/s, got -2000000000'],
  [{ angularVelocity: [1e7, 0, 0] }, 'angular_velocity.x: expected -1000000 to 1000000 rad/s, got 10000000'],
  [{ relativePosition: [0, 0, -1e19] }, 'relative_position.z: expected '],
  [{ relativeVelocity: [0, 0, -1e10] }, 'relative_velocity.z: expected '],
  [{ fuel: -1 }, 'fuel: expected 0 to 2000000000000000 kg, got -1'],
  [{ mass: -1 }, 'mass: expected 0 to '],
  [{ contactImpactSpeed: -0.5 }, 'contact_impact_speed: expected 0 to 1000000000 m/s, got -0.5'],
])('refuses a ship with %j', (change, reason) => {
  expect(shipReason({})).toBe('');
  expect(shipReason(change)).toContain(`frame.ships[0].${reason}`);
});

it('passes on unknown modes, states, classes and events', () => {
  expect(
    shipReason({ attitudeMode: 'surface_prograde', surfaceContactState: 'docked', shipClass: 'tug' }),
  ).toBe('');
  expect(eventReason({ type: 'ship.exploded', tick: 42 })).toBe('');
  const ships = [SHIP, { ...SHIP, shipId: 'b', attitudeMode: 'sideways', surfaceContactState: 'docked' }];
  expect(decodeServerMessage(encodeServerMessage({ ...FRAME, ships }))).toEqual({
    ok: true,
    value: { ...FRAME, ships },
  });
});

it('refuses an acknowledgement later than its frame', () => {
  const lastInput = { ...FRAME.lastInput!, tick: FRAME.tick + 1 };
  expect(frameReason({ lastInput })).toBe(
    'frame.last_input.tick: expected a whole number from 0 to 42, got 43',
  );
});

it.each([
  [{ name: '' }, 'name: expected a non-empty string'],
  [{ mass: 0 }, 'mass: expected > 0 kg, got 0'],
  [{ mass: 1e41 }, 'mass: expected 0 to '],
  [{ radius: 0 }, 'radius: expected ≥ 0.001 m, got 0'],
  [{ radius: -5 }, 'radius: expected ≥ 0.001 m, got -5'],
])('refuses a body with %j', (change, reason) => {
  expect(bodyReason(change)).toContain(`frame.bodies[0].${reason}`);
});

it.each([
  [{ type: '' }, 'type: expected a non-empty string'],
  [{ shipId: '' }, 'ship_id: expected a non-empty string'],
  [{ tick: 43 }, "tick: expected at most the frame's own, 42"],
])('refuses an event with %j', (change, reason) => {
  expect(eventReason({ tick: 42 })).toBe('');
  expect(eventReason(change)).toContain(`frame.events[1].${reason}`);
});

it.each([
  [{ contactBounceSpeed: 60 }, 'contact_bounce_speed: expected < contact_crash_speed (50 m/s), got 60'],
  [{ contactCrashSpeed: 0 }, 'contact_crash_speed: expected > 0 m/s, got 0'],
  [{ contactTippedAngleDeg: 90 }, 'contact_tipped_angle_deg: expected < 90°, got 90'],
  [{ contactFrictionKinetic: 0.9 }, 'contact_friction_kinetic: expected '],
  [
    { touchdownAttitude: 'sideways' },
    'touchdown_attitude: expected one of "aligned", "kept", got "sideways"',
  ],
  [{ touchdownAttitude: '' }, 'touchdown_attitude: expected one of '],
])('refuses settings with %j', (change, reason) => {
  expect(settingsReason(change)).toContain(`hello.settings.${reason}`);
});

it('keeps a setting of 0, and uses the default for one that is absent', () => {
  expect(settingsReason({ contactFrictionStatic: undefined })).toBe('');
  const decoded = decodeServerMessage(
    encodeServerMessage({
      ...HELLO,
      settings: { contactFrictionKinetic: 0, contactBounceSpeed: 12 } as Hello['settings'],
    }),
  );
  expect(decoded).toMatchObject({
    ok: true,
    value: {
      settings: {
        contactFrictionKinetic: 0,
        contactBounceSpeed: 12,
        contactFrictionStatic: 0.8,
        touchdownAttitude: 'aligned',
      },
    },
  });
});

it.each([
  [{ name: '' }, 'name: expected a non-empty string'],
  [{ dryMass: 0 }, 'dry_mass: expected ≥ 0.001 kg, got 0'],
  [{ fuelCapacity: -1 }, 'fuel_capacity: expected ≥ 0 kg, got -1'],
  [{ legRadius: 0 }, 'leg_radius: expected ≥ 0.001 m, got 0'],
  [{ rcsTorque: [0, -1, 0] }, 'rcs_torque[1]: expected ≥ 0 N m, got -1'],
  [{ rcsLever: 0 }, 'rcs_lever: expected ≥ 0.001 m, got 0'],
  [{ mainEngineThrust: 1e16 }, 'main_engine_thrust: expected -1000000000000000 to '],
  [
    {
      inertiaTensor: [
        [1, 0, 0],
        [0, 1, 0],
        [0, 0, -1],
      ],
    },
    'inertia_tensor[2][2]: expected > 0, as a positive definite tensor has, got -1',
  ],
])('refuses a ship class with %j', (change, reason) => {
  expect(classReason(change)).toContain(`hello.ship_classes[0].${reason}`);
});

it.each([
  [{ tickRate: 0.05 }, 'tick_rate: expected 0.1 to 100 Hz, got 0.05'],
  [{ tickRate: 101 }, 'tick_rate: expected 0.1 to 100 Hz, got 101'],
  [{ timeScale: 0 }, 'time_scale: expected 0.1 to 100, got 0'],
])('refuses a frame and a hello with %j', (change, reason) => {
  expect(frameReason(change)).toBe(`frame.${reason}`);
  expect(helloReason(change)).toBe(`hello.${reason}`);
});

it('refuses a hello without a terrain or with an unknown input granularity', () => {
  expect(helloReason({ terrain: '' })).toBe('hello.terrain: expected a non-empty string');
  for (const inputGranularity of ['', 'frame']) {
    expect(helloReason({ inputGranularity })).toMatch(
      /^hello\.input_granularity: expected one of "substep", "tick"/,
    );
  }
});

it('refuses duplicate names', () => {
  const [shipClass] = HELLO.shipClasses;
  const again = 'expected each once, got';
  expect(frameReason({ ships: [SHIP, { ...SHIP, shipId: 'b' }, SHIP] })).toBe(
    `frame.ships[2].ship_id: ${again} "ship-1" again`,
  );
  expect(frameReason({ bodies: [BODY, BODY] })).toBe(`frame.bodies[1].name: ${again} "Luna" again`);
  expect(helloReason({ bodies: [BODY, BODY] })).toBe(`hello.bodies[1].name: ${again} "Luna" again`);
  expect(helloReason({ shipClasses: [shipClass, shipClass] })).toBe(
    `hello.ship_classes[1].name: ${again} "fast_frigate" again`,
  );
});

it('accepts lists up to their limit and refuses longer ones', () => {
  const ships = Array.from({ length: MAX_SHIPS + 1 }, (_, i): ShipState => ({ ...SHIP, shipId: `s${i}` }));
  expect(frameReason({ ships: ships.slice(1) })).toBe('');
  expect(frameReason({ ships })).toBe(`frame.ships: expected at most 10000, got more`);
  const bodies = Array.from({ length: MAX_BODIES + 1 }, (_, i) => ({ ...BODY, name: `b${i}` }));
  expect(frameReason({ bodies: bodies.slice(1) })).toBe('');
  expect(frameReason({ bodies })).toBe(`frame.bodies: expected at most 256, got more`);
  expect(helloReason({ bodies })).toBe(`hello.bodies: expected at most 256, got more`);
  const shipClasses = bodies.map(({ name }) => ({ ...HELLO.shipClasses[0]!, name }));
  expect(helloReason({ shipClasses: shipClasses.slice(1) })).toBe('');
  expect(helloReason({ shipClasses })).toBe(`hello.ship_classes: expected at most 256, got more`);
  const inputs = Array.from({ length: MAX_INPUTS + 1 }, (_, i) => ({ ...INPUT, seq: i + 1 }));
  expect(inputsReason(inputs.slice(1))).toBe('');
  expect(inputsReason(inputs)).toBe(`inputs: expected at most 1000, got more`);
});

it('refuses inputs that are not numbered from 1', () => {
  expect(inputsReason([INPUT, { ...INPUT, seq: 0 }])).toMatch(
    /^inputs\[1\]\.seq: expected a whole number from 1 /,
  );
});
