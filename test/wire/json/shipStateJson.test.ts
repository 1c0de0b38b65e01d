import fc from 'fast-check';
import { afterEach, expect, it } from 'vitest';
import {
  decodeServerMessage,
  decodeShipStateJson,
  decodeShipStatesJson,
  encodeServerMessage,
  encodeShipStateJson,
  MAX_SHIPS,
} from '../../../src/wire';
import { ship } from '../arbitraries';
import { FRAME, SHIP } from '../messages';
import { faultsOf } from '../sound';

/** SHIP as the game's socket sends it, written by hand. */
const JSON_SHIP = {
  ship_id: 'ship-1',
  player_id: 'player-1',
  name: 'Первый ☾',
  ship_class: 'fast_frigate',
  position: { x: 1.496e11, y: -2.5e9, z: 3.857e8 },
  velocity: { x: 29780.5, y: -12.25, z: 1020 },
  attitude: { w: 0.7, x: 0.1, y: 0.7, z: -0.1 },
  angular_velocity: { x: 0.01, y: -0.02, z: 0.03 },
  rotation_input: { x: -1, y: 0.5, z: 0.125 },
  translation_input: { x: 1, y: -0.5, z: 0.25 },
  thrust_level: 0.75,
  attitude_hold: true,
  attitude_mode: 'retrograde',
  target_attitude: { w: 0.5, x: -0.5, y: 0.5, z: 0.5 },
  fuel: 1234.5,
  mass: 9234.5,
  wheel_momentum: { x: 100, y: -200, z: 0.5 },
  ground_contact_offset: 4.25,
  landed_body_name: 'Luna',
  surface_contact_state: 'contact',
  contact_impact_speed: 12.5,
  reference_body: 'Luna',
  relative_position: { x: 1.5, y: -2.5, z: 1737404 },
  relative_velocity: { x: 0.5, y: 0.25, z: -1.75 },
  crashed: true,
};

const LEAST = {
  ship_id: 'a',
  position: [1, 2, 3],
  velocity: [4, 5, 6],
  attitude: [1, 0, 0, 0],
  angular_velocity: [0, 0, 0],
  fuel: 10,
};

const accepted = (value: unknown) => ({ ok: true, value });
const reasonOf = (value: unknown) => {
  const decoded = decodeShipStateJson(value);
  return decoded.ok ? 'accepted' : decoded.reason;
};

it('reads vectors and quaternions as objects and as lists', () => {
  expect(decodeShipStateJson(JSON_SHIP)).toEqual(accepted(SHIP));
  const lists = Object.fromEntries(
    Object.entries(JSON_SHIP).map(([name, value]) => [
      name,
      typeof value === 'object' ? Object.values(value) : value,
    ]),
  );
  expect(lists['attitude']).toEqual([0.7, 0.1, 0.7, -0.1]);
  expect(decodeShipStateJson(lists)).toEqual(accepted(SHIP));
});

it('writes what the game’s socket sends', () => {
  expect(encodeShipStateJson(SHIP)).toEqual(JSON_SHIP);
});

it('preserves every legal ShipState through a JSON string', () => {
  fc.assert(
    fc.property(ship, (state) => {
      const text = JSON.stringify(encodeShipStateJson(state));
      // JSON.stringify writes −0 as 0.
      const positive = JSON.parse(JSON.stringify(state)) as unknown;
      expect(decodeShipStateJson(JSON.parse(text))).toEqual(accepted(positive));
    }),
    { numRuns: 200 },
  );
});

it('reads the same values as protobuf', () => {
  const decoded = decodeServerMessage(encodeServerMessage({ ...FRAME, ships: [SHIP] }));
  expect(decoded).toMatchObject({ ok: true, value: { ships: [SHIP] } });
  expect(decodeShipStateJson(encodeShipStateJson(SHIP))).toEqual(accepted(SHIP));
});

it('treats null like an absent field', () => {
  const nulls = { ...LEAST, relative_position: null, landed_body_name: null, thrust_level: null };
  for (const sent of [LEAST, nulls]) {
    expect(decodeShipStateJson(sent)).toMatchObject(
      accepted({
        attitude: [0, 0, 0, 1],
        thrustLevel: 0,
        attitudeMode: 'none',
        targetAttitude: [0, 0, 0, 1],
        mass: 0,
        landedBodyName: '',
        surfaceContactState: '',
        contactImpactSpeed: null,
        relativePosition: null,
        relativeVelocity: null,
        crashed: false,
      }),
    );
  }
  const relative = { ...LEAST, relative_position: [1, 2, 3], relative_velocity: [0, 0, 0] };
  expect(decodeShipStateJson(relative)).toMatchObject(accepted({ contactImpactSpeed: 0 }));
});

it.each(Object.keys(LEAST))('refuses a state without %s', (name) => {
  const complaint = name === 'ship_id' ? 'expected a non-empty string' : 'missing';
  expect(reasonOf({ ...LEAST, [name]: undefined })).toBe(`ship.${name}: ${complaint}`);
});

it.each([
  [{ position: { x: 1, y: 2 } }, 'position.z: missing'],
  [{ position: [1, 2] }, 'position: expected 3 numbers, got a list of 2'],
  [{ position: [1, null, 3] }, 'position.y: missing'],
  [{ position: [1, 'two', 3] }, 'position.y: expected a finite number, got "two"'],
  [{ position: '[1, 2' }, 'position: expected an object, got "[1, 2"'],
  [{ position: 7 }, 'position: expected an object, got 7'],
  [{ velocity: { x: 1, y: 2, z: 1e10 } }, 'velocity.z: expected '],
  [{ attitude: [1, 0, 0] }, 'attitude: expected 4 numbers, got a list of 3'],
  [{ attitude: { x: 0, y: 0, z: 0 } }, 'attitude.w: missing'],
  [{ attitude: [2, 0, 0, 0] }, 'attitude: expected a quaternion of length 1 within 0.001, got 2'],
  [{ fuel: '0x10' }, 'fuel: expected a finite number, got "0x10"'],
  [{ fuel: '' }, 'fuel: expected a finite number, got ""'],
  [{ fuel: '1e999' }, 'fuel: expected a finite number, got'],
  [{ fuel: true }, 'fuel: expected a finite number, got boolean'],
  [{ crashed: 1 }, 'crashed: expected true or false, got 1'],
  [{ name: 5 }, 'name: expected a string, got 5'],
  [{ name: 'x'.repeat(129) }, 'name: expected at most 128 characters, got 129'],
  [{ name: 'a\ud800' }, 'name: expected well-formed Unicode'],
  [{ surface_contact_state: 5 }, 'surface_contact_state: expected a string, got 5'],
  [{ attitude_mode: ['none'] }, 'attitude_mode: expected a string, got a list of 1'],
])('refuses %j', (change, reason) => {
  expect(reasonOf(LEAST)).toBe('accepted');
  expect(reasonOf({ ...LEAST, ...change })).toContain(`ship.${reason}`);
});

it('never throws for any JSON in any field', () => {
  const json = fc.oneof(fc.jsonValue(), fc.anything());
  fc.assert(
    fc.property(json, fc.constantFrom(...Object.keys(JSON_SHIP)), (value, name) => {
      for (const sent of [value, { ...JSON_SHIP, [name]: value }]) {
        for (const decoded of [
          decodeShipStateJson(sent),
          decodeShipStatesJson(sent),
          decodeShipStatesJson([sent]),
        ]) {
          if (decoded.ok) expect(faultsOf(decoded.value)).toEqual([]);
          else expect(decoded.reason).toMatch(/^ships?[[.:]/);
        }
      }
    }),
    { numRuns: 1000 },
  );
});

it('reads a list of states, or an object keyed by ship_id', () => {
  const other = { ...LEAST, ship_id: 'b' };
  const ids = (value: unknown) => {
    const decoded = decodeShipStatesJson(value);
    return decoded.ok ? decoded.value.map(({ shipId }) => shipId) : decoded.reason;
  };
  expect(ids([LEAST, other])).toEqual(['a', 'b']);
  expect(ids({ a: LEAST, b: { ...other, ship_id: undefined } })).toEqual(['a', 'b']);
  expect(ids([])).toEqual([]);
  expect(ids({})).toEqual([]);
  expect(ids([LEAST, LEAST])).toBe('ships[1].ship_id: expected each once, got "a" again');
  expect(ids({ a: LEAST, c: other })).toBe('ships[1].ship_id: expected "c", got "b"');
  expect(ids({ a: LEAST, b: 5 })).toBe('ships[1]: expected an object, got 5');
  expect(ids([LEAST, { ...other, fuel: NaN }])).toBe('ships[1].fuel: expected a finite number, got NaN');
  expect(ids('ships')).toBe('ships: expected an object, got "ships"');
  expect(ids(Array.from({ length: MAX_SHIPS + 1 }, () => LEAST))).toBe(
    `ships: expected at most ${MAX_SHIPS}, got ${MAX_SHIPS + 1}`,
  );
});

const POLLUTED = Object.prototype as { fuel?: number; crashed?: boolean };
afterEach(() => {
  delete POLLUTED.fuel;
  delete POLLUTED.crashed;
});

it('reads own properties only and does not touch prototypes', () => {
  const keys = Object.getOwnPropertyNames(Object.prototype);
  const withoutFuel = Object.fromEntries(Object.entries(LEAST).filter(([name]) => name !== 'fuel'));
  const text = JSON.stringify(withoutFuel).replace('{', '{"__proto__": {"fuel": 10, "crashed": true},');
  expect(reasonOf(JSON.parse(text))).toBe('ship.fuel: missing');
  expect(decodeShipStatesJson(JSON.parse(`{"__proto__": ${JSON.stringify(LEAST)}}`))).toEqual({
    ok: false,
    reason: 'ships[0].ship_id: expected "__proto__", got "a"',
  });
  expect(Object.getOwnPropertyNames(Object.prototype)).toEqual(keys);
  POLLUTED.fuel = 10;
  POLLUTED.crashed = true;
  expect(reasonOf(withoutFuel)).toBe('ship.fuel: missing');
  expect(decodeShipStateJson({ ...LEAST, fuel: 1 })).toMatchObject(accepted({ crashed: false }));
});
