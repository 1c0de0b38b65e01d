import { describe, expect, it } from 'vitest';
import {
  BODY_STRIDE,
  CONTACT,
  CRASHED,
  endTick,
  type Body,
  type BodyMotion,
  beginTick,
  chooseReferenceBody,
  flatTerrain,
  LANDED,
  loadBody,
  loadSettings,
  loadShipClass,
  POSITION,
  REFERENCE_BODY,
  SHIP_STRIDE,
  spawnShip,
  stepWorld,
  SURFACE_STATE,
  timingOfTick,
  type Vec3,
  VELOCITY,
  type World,
  writeBodyMotion,
  TERRAIN_NORMALS,
} from '../../../src/dynamics';
import { bodyNamed, LANDER, must, vectorAt } from '../provingGround';
import { cross, lengthOf, plus } from '../vectors';

interface Place {
  readonly ships: Float64Array;
  readonly bodies: Float64Array;
  readonly world: World;
  readonly motions: readonly BodyMotion[];
}

/** A ship over the first body, at `position` from its centre. */
function placeBetween(
  bodies: readonly (Body & BodyMotion)[],
  position: Vec3,
  velocity: Vec3 = [0, 0, 0],
): Place {
  const world: World = {
    settings: must(loadSettings({})),
    shipClasses: [must(loadShipClass(LANDER))],
    bodies: bodies.map((body) => must(loadBody(body))),
    terrainHeight: flatTerrain,
    terrainNormals: TERRAIN_NORMALS,
  };
  const rows = new Float64Array(bodies.length * BODY_STRIDE);
  bodies.forEach((body, i) => expect(writeBodyMotion(rows, i * BODY_STRIDE, body)).toBeNull());
  const ships = new Float64Array(SHIP_STRIDE);
  const ship = {
    shipClass: LANDER.name,
    referenceBody: bodies[0]!.name,
    relativePosition: position,
    relativeVelocity: velocity,
    attitude: [0, 0, 0, 1],
    angularVelocity: [0, 0, 0],
    fuel: 100,
    surfaceContactState: '',
    contactImpactSpeed: 0,
    crashed: false,
  } as const;
  expect(spawnShip(ships, 0, ship, world)).toBeNull();
  return { ships, bodies: rows, world, motions: bodies };
}

function choose({ ships, bodies, world }: Place): number {
  chooseReferenceBody(ships, 0, bodies, world);
  return ships[REFERENCE_BODY]!;
}

/** Position and velocity in ICRF. */
function icrf({ ships, motions }: Place): readonly [Vec3, Vec3] {
  const { position, velocity } = motions[ships[REFERENCE_BODY]!]!;
  return [plus(position, vectorAt(ships, POSITION)), plus(velocity, vectorAt(ships, VELOCITY))];
}

/** Two equal bodies, 1000 km apart on x, one moving relative to the other. */
const LEFT = { ...bodyNamed('Phobos'), name: 'Left', position: [0, 0, 0], velocity: [0, 0, 0] } as const;
const RIGHT = { ...LEFT, name: 'Right', position: [1e6, 0, 0], velocity: [3, -4, 12] } as const;

describe('the reference body', () => {
  it('is the body with the smallest distance / radius', () => {
    expect(choose(placeBetween([LEFT, RIGHT], [499_999, 0, 0]))).toBe(0);
    expect(choose(placeBetween([LEFT, RIGHT], [500_001, 0, 0]))).toBe(1);
    // Twice the radius reaches twice as far, regardless of mass.
    const large = { ...RIGHT, radius: 2 * LEFT.radius, mass: LEFT.mass / 100 };
    expect(choose(placeBetween([LEFT, large], [333_000, 0, 0]))).toBe(0);
    expect(choose(placeBetween([LEFT, large], [334_000, 0, 0]))).toBe(1);
  });

  // At Phobos the gravity of Mars is stronger than its own: chosen by gravity, the ship would fall through the ground.
  it.each([
    ['Mars', 'Phobos'],
    ['Phobos', 'Mars'],
  ])('lands a ship 2 m above Phobos on Phobos with %s, %s in the list', (...names) => {
    const bodies = names.map((name) => bodyNamed(name));
    const phobos = bodyNamed('Phobos');
    const above: Vec3 = [0, 0, phobos.radius + LANDER.groundContactOffset + 2];
    const turning = cross(phobos.angularVelocity, above);
    const start = plus(plus(phobos.position, bodies[0]!.position, -1), above);
    const place = placeBetween(bodies, start, plus(plus(phobos.velocity, bodies[0]!.velocity, -1), turning));
    const { ships, bodies: rows, world } = place;
    const timing = timingOfTick(1, world.settings.contactLongestSubstep);
    const events = new Uint8Array(1);
    for (let second = 0; second < 120 && ships[SURFACE_STATE] !== LANDED; second++) {
      beginTick(ships, rows, world);
      for (let s = 0; s < timing.substeps; s++) stepWorld(ships, rows, events, world, timing.dt);
      endTick(rows, world, timing);
    }
    expect(ships[SURFACE_STATE]).toBe(LANDED);
    expect(world.bodies[ships[REFERENCE_BODY]!]!.name).toBe('Phobos');
  });

  it('is the first in the list when two are equally near', () => {
    expect(choose(placeBetween([LEFT, RIGHT], [500_000, 0, 0]))).toBe(0);
    const swapped = placeBetween([RIGHT, LEFT], [-500_000, 0, 0]);
    expect(choose(swapped)).toBe(0);
    const late = placeBetween([LEFT, RIGHT], [500_000, 0, 0]);
    late.ships[REFERENCE_BODY] = 1;
    late.ships[POSITION] = -500_000;
    expect(choose(late)).toBe(0);
    expect(late.ships[POSITION]).toBe(500_000);
  });

  it('changes without changing position and velocity in ICRF', () => {
    const place = placeBetween([LEFT, RIGHT], [700_000, 1234.5, -99], [10, 20, -30]);
    const before = icrf(place);
    expect(choose(place)).toBe(1);
    expect(vectorAt(place.ships, POSITION)).toEqual([-300_000, 1234.5, -99]);
    expect(vectorAt(place.ships, VELOCITY)).toEqual([7, 24, -42]);
    expect(icrf(place)).toEqual(before);
  });

  // Target 0. Positions of bodies are doubles of 1.5e11 m, exact to 15 µm; the change adds at most one rounding.
  it('changes ICRF by no more than a double resolves at 1 au', () => {
    const moon = bodyNamed('Luna');
    const earth = bodyNamed('Earth');
    const place = placeBetween([moon, earth], [-3.6e8, -2e8, 1e6], [100, -50, 3]);
    const [position, velocity] = icrf(place);
    expect(choose(place)).toBe(1);
    const [after, speed] = icrf(place);
    expect(lengthOf(plus(after, position, -1))).toBeLessThan(5e-5);
    expect(lengthOf(plus(speed, velocity, -1))).toBeLessThan(1e-11);
    // There and back: the same position, except for that rounding.
    expect(choose(place)).toBe(1);
  });

  it.each([
    ['on the ground', SURFACE_STATE, CONTACT],
    ['crashed', CRASHED, 1],
  ])('does not change for a ship %s', (_, column, value) => {
    const place = placeBetween([LEFT, RIGHT], [700_000, 0, 0]);
    place.ships[column] = value;
    const before = Array.from(place.ships);
    beginTick(place.ships, place.bodies, place.world);
    expect(Array.from(place.ships)).toEqual(before);
  });
});
