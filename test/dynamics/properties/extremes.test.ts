import fc from 'fast-check';
import { expect, it } from 'vitest';
import {
  BODY_STRIDE,
  CRASHED,
  flatTerrain,
  loadBody,
  loadControls,
  loadSettings,
  loadShipClass,
  SHIP_STRIDE,
  SURFACE_STATE,
  spawnShip,
  stepWorld,
  type World,
  writeBodyMotion,
  writeControls,
  TERRAIN_NORMALS,
} from '../../../src/dynamics';
import { body, controls, settings, shipClass, shipOver } from './extremes';
import { must } from '../provingGround';

const SUBSTEPS = 1000;
const given = fc
  .record({ body, shipClass, settings, controls, dt: fc.constantFrom(0.001, 0.0073, 0.01) })
  .chain((world) =>
    shipOver(world.body, world.shipClass.groundContactOffset).map((ship) => ({ ...world, ship })),
  );

// Today the largest number in 14,000 such worlds is 1e46.
it('every accepted configuration, at and between the ends of the ranges, stays finite for 1,000 substeps', () => {
  let [refused, accepted] = [0, 0];
  const seen = new Set<number>();
  fc.assert(
    fc.property(given, (made) => {
      const loaded = [
        loadSettings(made.settings),
        loadShipClass(made.shipClass),
        loadBody(made.body),
      ] as const;
      const [ships, bodies] = [new Float64Array(SHIP_STRIDE), new Float64Array(BODY_STRIDE)];
      if (!loaded.every(({ ok }) => ok) || writeBodyMotion(bodies, 0, made.body) !== null) {
        refused++;
        return;
      }
      const world: World = {
        settings: must(loaded[0]),
        shipClasses: [must(loaded[1])],
        bodies: [must(loaded[2])],
        terrainHeight: flatTerrain,
        terrainNormals: TERRAIN_NORMALS,
      };
      if (spawnShip(ships, 0, made.ship, world) !== null) {
        refused++;
        return;
      }
      accepted++;
      writeControls(ships, 0, must(loadControls(made.controls)));
      const events = new Uint8Array(1);
      for (let i = 0; i < SUBSTEPS; i++) {
        stepWorld(ships, bodies, events, world, made.dt);
        const wrong = ships.findIndex((value) => !Number.isFinite(value));
        if (wrong >= 0) throw new Error(`substep ${i}: column ${wrong} is ${ships[wrong]!}`);
        seen.add(ships[CRASHED] === 1 ? -1 : ships[SURFACE_STATE]!);
      }
      expect(bodies.every(Number.isFinite)).toBe(true);
    }),
    { seed: 20_260, numRuns: 800 },
  );
  expect(accepted).toBeGreaterThan(200);
  expect(refused).toBeGreaterThan(100);
  expect([...seen].sort()).toEqual([-1, 0, 1, 2, 3]);
});
