import fc from 'fast-check';
import { expect, it } from 'vitest';
import {
  decodeFrameJson,
  type DecodedFrame,
  decodeLeanFrameJson,
  decodeServerMessage,
  encodeFrameJson,
  encodeServerMessage,
  MAX_SHIPS,
} from '../../../src/wire';
import { frame } from '../arbitraries';
import { FRAME } from '../messages';
import { faultsOf } from '../sound';

/** The required fields of a ship, in the game's spelling. */
const LEAST = {
  position: [1, 2, 3],
  velocity: [4, 5, 6],
  attitude: [1, 0, 0, 0],
  angular_velocity: [0, 0, 0],
  fuel: 10,
};
const MOON = { mass: 7.342e22, radius: 1737400, position: [1, 2, 3], velocity: [0, 0, 0] };

function accepted(value: unknown): DecodedFrame {
  const decoded = decodeFrameJson(value);
  if (!decoded.ok) throw new Error(decoded.reason);
  return decoded.value;
}

function reasonOf(value: unknown): string {
  const decoded = decodeFrameJson(value);
  return decoded.ok ? 'accepted' : decoded.reason;
}

it('requires a tick and ships only', () => {
  expect(accepted({ tick: 7, ships: {} })).toEqual({ kind: 'frame', tick: 7, ships: [], refusals: [] });
  expect(reasonOf({ ships: [] })).toBe('tick: missing');
  expect(reasonOf({ tick: 7 })).toBe('ships: missing');
  expect(reasonOf({ tick: -1, ships: [] })).toMatch(/^tick: expected a whole number from 0/);
  expect(reasonOf({ tick: 2 ** 53 - 1, ships: [] })).toMatch(/^tick: expected a whole number from 0/);
  expect(reasonOf({ tick: 7, ships: 'all' })).toBe('ships: expected a list or an object, got "all"');
  expect(reasonOf(null)).toBe('message: expected an object, got null');
});

it('reads numbers, flags, vectors and quaternions as Redis stores them, in either spelling', () => {
  const redis = {
    tick: '1201',
    tickRate: '10',
    time_scale: '1.5',
    paused: 'true',
    game_time: '1970-01-02T00:00:01.500000+00:00',
    ships: {
      'ship-1': {
        position: '[1, 2.5, -3e3]',
        velocity: { x: '1', y: 2, z: '3' },
        attitude: '{"w": 0.5, "x": 0.5, "y": 0.5, "z": -0.5}',
        angularVelocity: '[0,0,0]',
        thrustLevel: '0.25',
        attitude_hold: 'true',
        fuel: '15000.0',
        landedBodyName: 'Luna',
      },
    },
  };
  const decoded = accepted(redis);
  expect(decoded).toMatchObject({
    tick: 1201,
    tickRate: 10,
    timeScale: 1.5,
    paused: true,
    gameTime: 86401.5,
  });
  expect(decoded.refusals).toEqual([]);
  expect(decoded.ships[0]).toMatchObject({
    shipId: 'ship-1',
    position: [1, 2.5, -3000],
    velocity: [1, 2, 3],
    attitude: [0.5, 0.5, -0.5, 0.5],
    thrustLevel: 0.25,
    attitudeHold: true,
    fuel: 15000,
    landedBodyName: 'Luna',
  });
});

it('leaves out invalid values, lists their paths and keeps the rest of the frame', () => {
  const decoded = accepted({
    tick: 7,
    tick_rate: 1000,
    paused: 'perhaps',
    ships: { good: LEAST, bad: { ...LEAST, velocity: [1, null, 3] }, ['x'.repeat(200)]: LEAST, other: 5 },
    bodies: {
      Moon: { ...MOON, attitude: [1, 0, 0, 0], angular_velocity: [0, 0, 0] },
      Hole: { ...MOON, axis: [0, 0, 1], period: 9, mass: -1 },
    },
    events: [{ type: 'ship.contact', ship_id: 'good', tick: 9 }, { type: 'ship.landed' }],
    last_input: { seq: 1, tick: 1_000_007, substep: 0, margin: 0 },
  });
  expect(decoded.ships.map(({ shipId }) => shipId)).toEqual(['good']);
  expect(decoded.bodies?.map(({ name }) => name)).toEqual(['Moon']);
  expect(decoded.events).toEqual([]);
  expect(decoded).not.toHaveProperty('tickRate');
  expect(decoded).not.toHaveProperty('lastInput');
  expect(decoded.refusals).toEqual([
    'ships["bad"].velocity.y: missing',
    `ships["${'x'.repeat(40)}…"].ship_id: expected at most 128 characters, got 200`,
    'ships["other"]: expected an object, got 5',
    'tick_rate: expected 0.1 to 100 Hz, got 1000',
    'paused: expected true or false, got "perhaps"',
    expect.stringMatching(/^bodies\["Hole"\]\.mass: expected /),
    "events[0].tick: expected at most the frame's own, 7",
    'events[1].ship_id: expected a non-empty string',
    'last_input.tick: expected a whole number from 0 to 7, got 1000007',
  ]);
});

it('does not drop one ship for another’s unknown mode, state or class', () => {
  const odd = {
    ...LEAST,
    attitude_mode: 'surface_prograde',
    surface_contact_state: 'docked',
    ship_class: 'tug',
  };
  const decoded = accepted({
    tick: 1,
    ships: [
      { ...LEAST, ship_id: 'a' },
      { ...odd, ship_id: 'b' },
    ],
  });
  expect(decoded.refusals).toEqual([]);
  expect(decoded.ships[1]).toMatchObject({
    attitudeMode: 'surface_prograde',
    surfaceContactState: 'docked',
    shipClass: 'tug',
  });
});

it('reads events of the game’s stream, which have no time', () => {
  const event = { event: 'ship.destroyed', ship_id: 'a', player_id: 'p', body: 'Luna', reason: 'collision' };
  expect(accepted({ tick: 8, ships: [], events: [event] }).events).toEqual([
    {
      type: 'ship.destroyed',
      shipId: 'a',
      tick: 7,
      substep: null,
      playerId: 'p',
      body: 'Luna',
      reason: 'collision',
    },
  ]);
});

it('lists an invalid game time', () => {
  expect(accepted({ tick: 0, ships: [], game_time: '2026-11-28' }).refusals).toEqual([
    'game_time: expected seconds or ISO 8601, got "2026-11-28"',
  ]);
  expect(accepted({ tick: 0, ships: [], game_time: '5-5' }).refusals).toEqual([
    'game_time: expected seconds or ISO 8601, got "5-5"',
  ]);
});

it('refuses more ships than the wire allows, and duplicate ids', () => {
  const many = Array.from({ length: MAX_SHIPS + 1 }, () => LEAST);
  expect(reasonOf({ tick: 0, ships: many })).toBe(
    `ships: expected at most ${MAX_SHIPS}, got ${MAX_SHIPS + 1}`,
  );
  const twice = { ...LEAST, ship_id: 'a' };
  expect(accepted({ tick: 0, ships: [twice, twice] }).refusals).toEqual([
    'ships[1].ship_id: expected each once',
  ]);
});

/** Normalises −0, which JSON does not have. */
const withoutSign = (value: unknown): unknown => JSON.parse(JSON.stringify(value));

it('has every field that protobuf has', () => {
  fc.assert(
    fc.property(frame, (message) => {
      const bytes = decodeServerMessage(encodeServerMessage(message));
      const decoded = decodeFrameJson(JSON.parse(JSON.stringify(encodeFrameJson(message))));
      if (!bytes.ok || !decoded.ok) throw new Error('refused');
      const { refusals, ...told } = decoded.value;
      expect(refusals).toEqual([]);
      expect(withoutSign(told)).toEqual(withoutSign(bytes.value));
    }),
    { numRuns: 300 },
  );
});

it('decodes states alone in a lean page, of bodies with attitude and spin, and times in seconds', () => {
  const body = { ...MOON, name: 'Luna', attitude: [1, 0, 0, 0], angular_velocity: [0, 0, 0] };
  const exact = { tick: 7, gameTime: '12.5', ships: { a: LEAST }, bodies: [body] };
  expect(accepted(exact).gameTime).toBe(12.5);
  expect(decodeLeanFrameJson(exact)).toEqual(decodeFrameJson(exact));
  const news = { events: [{ type: 'ship.landed', ship_id: 'a', tick: 6 }], last_input: null };
  expect(accepted({ ...exact, ...news }).events).toHaveLength(1);
  expect(decodeLeanFrameJson({ ...exact, ...news })).toEqual(decodeFrameJson(exact));
  const named = { name: 'Luna', position: [1, 2, 3], velocity: [0, 0, 0] };
  const spun = { ...MOON, name: 'Own', spin_axis: [0, 1, 0], rotation_period: 1000 };
  const sent = { ...exact, game_time: '1970-01-01T00:00:12Z', gameTime: undefined, bodies: [named, spun] };
  expect(accepted(sent).refusals).toEqual([]);
  expect(decodeLeanFrameJson(sent)).toEqual({
    ok: true,
    value: {
      kind: 'frame',
      tick: 7,
      ships: accepted(exact).ships,
      bodies: [],
      refusals: [
        'game_time: expected a finite number, got "1970-01-01T00:00:12Z"',
        'bodies[0].attitude: missing',
        'bodies[1].attitude: missing',
      ],
    },
  });
});

it('never throws for any JSON in any field', () => {
  const names = Object.keys(encodeFrameJson(FRAME));
  const within = Object.keys(LEAST);
  fc.assert(
    fc.property(
      fc.oneof(fc.jsonValue(), fc.anything()),
      fc.constantFrom(...names),
      fc.constantFrom(...within),
      (value, name, field) => {
        const whole = encodeFrameJson(FRAME);
        for (const sent of [
          value,
          { ...whole, [name]: value },
          { tick: 1, ships: [{ ...LEAST, ship_id: 'a', [field]: value }] },
        ]) {
          const decoded = decodeFrameJson(sent);
          if (!decoded.ok) expect(decoded.reason).toMatch(/^[a-z_]+[^:]*: ./s);
          else {
            const { refusals, ...told } = decoded.value;
            expect(faultsOf(told)).toEqual([]);
            for (const refusal of refusals) expect(refusal).toMatch(/: ./);
          }
        }
        const bytes = decodeServerMessage(new TextEncoder().encode(fc.stringify(value)));
        if (bytes.ok) expect(faultsOf(bytes.value)).toEqual([]);
      },
    ),
    { numRuns: 500 },
  );
});
