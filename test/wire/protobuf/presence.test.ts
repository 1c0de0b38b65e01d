import { expect, it } from 'vitest';
import type { Result, Quat } from '../../../src/dynamics';
import {
  decodeServerMessage,
  encodeServerMessage,
  type ServerMessage,
  type ShipState,
} from '../../../src/wire';
import { type Bytes, delimited, double, frameOf, olderShip, quaternion, text, vec3 } from './bytes';
import { FRAME, SHIP } from '../messages';

function shipOf(decoded: Result<ServerMessage>): ShipState {
  if (!decoded.ok || decoded.value.kind !== 'frame')
    throw new Error(decoded.ok ? 'no frame' : decoded.reason);
  return decoded.value.ships[0]!;
}

const shipFrom = (...ship: Bytes[]) =>
  shipOf(decodeServerMessage(frameOf([...olderShip('a'), ...ship.flat()])));

it('reads a server without fields 29 to 35', () => {
  expect(shipFrom()).toEqual({
    shipId: 'a',
    playerId: '',
    name: '',
    shipClass: '',
    position: [1, 2, 3],
    velocity: [4, 5, 6],
    attitude: [0, 0, 0, 1],
    angularVelocity: [0, 0, 0],
    thrustLevel: 0,
    translationInput: [0, 0, 0],
    rotationInput: [0, 0, 0],
    attitudeHold: false,
    attitudeMode: 'none',
    targetAttitude: [0, 0, 0, 1],
    fuel: 0,
    mass: 0,
    wheelMomentum: null,
    groundContactOffset: null,
    landedBodyName: '',
    surfaceContactState: '',
    contactImpactSpeed: null,
    referenceBody: '',
    relativePosition: null,
    relativeVelocity: null,
    crashed: false,
  });
});

it('passes on a landed body without a state, as older servers send it', () => {
  expect(shipFrom(text(29, 'Luna'))).toMatchObject({
    landedBodyName: 'Luna',
    surfaceContactState: '',
    contactImpactSpeed: null,
  });
});

it('distinguishes an impact speed of 0 from none by the relative state', () => {
  const relative = [...vec3(33, 1, 2, 3), ...vec3(34, 0, 0, 0)];
  expect(shipFrom().contactImpactSpeed).toBeNull();
  expect(shipFrom(double(31, 0)).contactImpactSpeed).toBeNull();
  expect(shipFrom(double(31, 7)).contactImpactSpeed).toBe(7);
  expect(shipFrom(relative).contactImpactSpeed).toBe(0);
  expect(shipFrom(relative, double(31, 7)).contactImpactSpeed).toBe(7);
});

it('distinguishes a relative state of zeros from none', () => {
  expect(shipFrom(delimited(33), delimited(34))).toMatchObject({
    relativePosition: [0, 0, 0],
    relativeVelocity: [0, 0, 0],
  });
  expect(shipFrom(delimited(33))).toMatchObject({ relativePosition: [0, 0, 0], relativeVelocity: null });
});

it('ignores unknown fields', () => {
  expect(shipFrom(double(20, NaN), text(4000, 'later'), delimited(28, [1, 2, 3]))).toEqual(shipFrom());
});

it('merges a state that comes in several parts', () => {
  const halves = frameOf([...olderShip('a'), ...delimited(33, double(1, 5)), ...delimited(33, double(3, 7))]);
  expect(shipOf(decodeServerMessage(halves)).relativePosition).toEqual([5, 0, 7]);
});

function attitudeBack(attitude: Quat): Quat {
  return shipOf(decodeServerMessage(encodeServerMessage({ ...FRAME, ships: [{ ...SHIP, attitude }] })))
    .attitude;
}

it('keeps a quaternion’s sign', () => {
  expect(attitudeBack([-0, -0.6, -0, -0.8])).toEqual([-0, -0.6, -0, -0.8]);
});

it('keeps the bits of a quaternion within 1e-12 of unit length, and normalises others', () => {
  const near: Quat = [0, 0, 0, 1 + 9e-13];
  expect(attitudeBack(near)).toEqual(near);
  expect(attitudeBack([0, 0, 0, 1 + 2e-12])).toEqual([0, 0, 0, 1]);
  expect(attitudeBack([0, 0, 0.6 * 0.9995, 0.8 * 0.9995])).toEqual([
    0,
    0,
    expect.closeTo(0.6, 15) as number,
    expect.closeTo(0.8, 15) as number,
  ]);
});

it('normalises a target attitude by the same rule, so that a stored input replays to the same bits', () => {
  const targetAttitude: Quat = [0.6, 0, 0, -0.8 - 5e-13];
  const ship = shipOf(
    decodeServerMessage(encodeServerMessage({ ...FRAME, ships: [{ ...SHIP, targetAttitude }] })),
  );
  expect(ship.targetAttitude).toEqual(targetAttitude);
});

it('refuses a quaternion further than 1e-3 from unit length', () => {
  for (const scale of [1.0011, 0.9989, 0, 1e200]) {
    const refusal = decodeServerMessage(frameOf([...olderShip('a'), ...quaternion(7, scale, 0, 0, 0)]));
    expect(refusal.ok ? 'accepted' : refusal.reason).toMatch(
      /^frame\.ships\[0\]\.attitude: expected a quaternion of length 1 within 0.001, got /,
    );
  }
});

it('clamps controls into range', () => {
  expect(shipFrom(double(11, 3), vec3(9, -2, 0.5, 2), vec3(10, 1e300, -1e300, 0))).toMatchObject({
    thrustLevel: 1,
    rotationInput: [-1, 0.5, 1],
    translationInput: [1, -1, 0],
  });
});
