import { readdirSync, readFileSync } from 'node:fs';
import { fileURLToPath } from 'node:url';
import { expect, it } from 'vitest';
import {
  decodeClientMessage,
  decodeServerMessage,
  encodeServerMessage,
  MAX_TICK,
  type ShipState,
} from '../../../src/wire';
import {
  type Bytes,
  bytesOf,
  delimited,
  double,
  frameOf,
  integer,
  olderShip,
  quaternion,
  text,
  vec3,
} from './bytes';
import { FRAME, SHIP } from '../messages';

function shipFrom(ship: Bytes): ShipState {
  const decoded = decodeServerMessage(frameOf(ship));
  if (!decoded.ok || decoded.value.kind !== 'frame')
    throw new Error(decoded.ok ? 'no frame' : decoded.reason);
  return decoded.value.ships[0]!;
}

it('reads fields 29 to 35 of ShipState at their numbers', () => {
  const ship = shipFrom([
    ...olderShip('a'),
    ...text(29, 'Luna'),
    ...text(30, 'tipped'),
    ...double(31, 12.5),
    ...text(32, 'Earth'),
    ...vec3(33, 10, 20, 30),
    ...vec3(34, -1, -2, -3),
    ...integer(35, 1),
  ]);
  expect(ship).toMatchObject({
    shipId: 'a',
    landedBodyName: 'Luna',
    surfaceContactState: 'tipped',
    contactImpactSpeed: 12.5,
    referenceBody: 'Earth',
    relativePosition: [10, 20, 30],
    relativeVelocity: [-1, -2, -3],
    crashed: true,
  });
});

it('has w first on the wire and last in memory', () => {
  const ship = shipFrom([...olderShip('a'), ...quaternion(7, 0.1, 0.7, -0.1, 0.7)]);
  expect(ship.attitude).toEqual([0.7, -0.1, 0.7, 0.1]);
});

it('writes a whole ShipState as the protobuf encoding defines', () => {
  const [ax, ay, az, aw] = SHIP.attitude;
  const [tx, ty, tz, tw] = SHIP.targetAttitude;
  const byHand: Bytes = [
    ...text(1, SHIP.shipId),
    ...text(2, SHIP.playerId),
    ...text(3, SHIP.name),
    ...text(4, SHIP.shipClass),
    ...vec3(5, ...SHIP.position),
    ...vec3(6, ...SHIP.velocity),
    ...quaternion(7, aw, ax, ay, az),
    ...vec3(8, ...SHIP.angularVelocity),
    ...vec3(9, ...SHIP.rotationInput),
    ...vec3(10, ...SHIP.translationInput),
    ...double(11, SHIP.thrustLevel),
    ...integer(12, 1),
    ...text(13, SHIP.attitudeMode),
    ...quaternion(14, tw, tx, ty, tz),
    ...double(15, SHIP.fuel),
    ...double(16, SHIP.mass),
    ...text(29, SHIP.landedBodyName),
    ...text(30, SHIP.surfaceContactState),
    ...double(31, SHIP.contactImpactSpeed!),
    ...text(32, SHIP.referenceBody),
    ...vec3(33, ...SHIP.relativePosition!),
    ...vec3(34, ...SHIP.relativeVelocity!),
    ...integer(35, 1),
    ...vec3(36, ...SHIP.wheelMomentum!),
    ...double(37, SHIP.groundContactOffset!),
  ];
  const { kind, tick, tickRate, timeScale } = FRAME;
  const frame = {
    kind,
    tick,
    tickRate,
    timeScale,
    paused: false,
    bodies: [],
    events: [],
    ships: [SHIP],
    lastInput: null,
  };
  const expected = bytesOf(delimited(2, integer(1, 42), double(2, 5), double(3, 2.5), delimited(6, byHand)));
  expect(encodeServerMessage(frame)).toEqual(expected);
});

it('reads hand-written inputs and pings', () => {
  const controls = delimited(4, double(1, 0.5), text(5, 'radial'), quaternion(6, 0, 1, 0, 0));
  const message = bytesOf(
    delimited(1, delimited(1, integer(1, 7), integer(2, 42), integer(3, 99), controls)),
  );
  expect(decodeClientMessage(message)).toEqual({
    ok: true,
    value: {
      kind: 'inputs',
      inputs: [
        {
          seq: 7,
          tick: 42,
          substep: 99,
          controls: {
            thrustLevel: 0.5,
            translationInput: [0, 0, 0],
            rotationInput: [0, 0, 0],
            attitudeHold: false,
            attitudeMode: 'radial',
            targetAttitude: [1, 0, 0, 0],
          },
        },
      ],
    },
  });
  expect(decodeClientMessage(bytesOf(delimited(2, integer(1, 5))))).toEqual({
    ok: true,
    value: { kind: 'ping', id: 5 },
  });
});

it('reads 64-bit integers as safe numbers, or refuses them and names the field', () => {
  const largest = BigInt(MAX_TICK);
  const pong = (tick: bigint) => decodeServerMessage(bytesOf(delimited(3, integer(1, 1), integer(2, tick))));
  expect(pong(largest)).toEqual({
    ok: true,
    value: { kind: 'pong', id: 1, tick: MAX_TICK, sinceTick: 0 },
  });
  for (const tick of [largest + 1n, 2n ** 60n, 2n ** 63n, 2n ** 64n - 1n]) {
    const refusal = pong(tick);
    expect(refusal.ok ? 'accepted' : refusal.reason).toMatch(/^pong\.tick: expected a whole number/);
  }
});

it('tests every field number of the proto files', () => {
  const folder = fileURLToPath(new URL('../../../proto/', import.meta.url));
  expect(readdirSync(folder).sort()).toEqual(['common.proto', 'physics.proto', 'stream.proto']);
  const physics = readFileSync(`${folder}physics.proto`, 'utf8');
  for (const field of [
    'string landed_body_name = 29;',
    'string surface_contact_state = 30;',
    'double contact_impact_speed = 31;',
    'string reference_body = 32;',
    'Vec3 relative_position = 33;',
    'Vec3 relative_velocity = 34;',
    'bool crashed = 35;',
  ]) {
    expect(physics).toContain(field);
  }
});
