import { describe, expect, it } from 'vitest';
import { NEUTRAL_CONTROLS, SHIP_CLASSES } from '../../../src/dynamics';
import {
  createLeanPredictor,
  type Feature,
  frameBudget,
  gameCatalogue,
  groundedGhost,
  type LeanOptions,
  replayedImpacts,
  sleepingShips,
  terrainNormals,
  unloadedGround,
} from '../../../src/prediction';
import type { ServerFrame, ShipState } from '../../../src/wire';
import { LUNA } from '../checks/mistakes/given';
import { frameAt, STILL } from '../faults/restingShip';

/** Flies a lean predictor with the features over the frames, one a second; its view, predictor and warnings after the last. */
function flown(
  frames: readonly ServerFrame[],
  features: readonly Feature[],
  options: Omit<LeanOptions, 'features'> = {},
) {
  const warned: string[] = [];
  const predictor = createLeanPredictor({
    ownShipId: 'ship-1',
    onWarning: (code, message) => warned.push(`${code}: ${message}`),
    features: [gameCatalogue, ...features],
    ...options,
  });
  for (const [second, given] of frames.entries()) {
    predictor.receive(given, second);
    for (let i = 0; i < 60; i++) {
      predictor.advance(NEUTRAL_CONTROLS, second + i / 60);
      predictor.view(second + i / 60);
    }
  }
  return { view: predictor.view(frames.length), warned };
}

/** A ship at rest in four states, one a second. */
const RESTING = [1, 2, 3, 4].map((tick) => frameAt(tick, 1));

const of = (warned: readonly string[], feature: Feature): readonly string[] =>
  warned.filter((text) => text.includes(`needs the feature ${feature.feature} of`));

describe('a lean predictor', () => {
  it('has the game’s classes and bodies only with that feature', () => {
    expect(() => createLeanPredictor()).toThrow(
      /^defaults\.shipClasses: expected at least one; .* gameCatalogue$/,
    );
    const defaults = { shipClasses: SHIP_CLASSES };
    expect(() => createLeanPredictor({ defaults })).toThrow(/^defaults\.bodies: /);
    const given = createLeanPredictor({ defaults: { ...defaults, bodies: [LUNA] } });
    expect(given.view(0).bodies).toHaveLength(1);
  });

  it('takes a server’s terrain normals only with that feature', () => {
    const defaults = { settings: { surfaceNormal: 'terrain' } } as const;
    const create = (...features: readonly Feature[]) =>
      createLeanPredictor({ defaults, features: [gameCatalogue, ...features] });
    expect(() => create()).toThrow(
      /^defaults: settings\.surfaceNormal: expected radial without the feature terrainNormals/,
    );
    // A slope of one in ten toward X.
    const terrains = { slope: (_name: string, nx: number) => nx * LUNA.radius * 0.1 };
    const onSlope = flown(RESTING, [terrainNormals], {
      terrains,
      defaults: { ...defaults, bodies: [LUNA], terrain: 'slope' },
    }).view.own!;
    expect(onSlope.groundNormal[0]).toBeCloseTo(-0.1, 2);
    expect(flown(RESTING, []).view.own!.groundNormal[0]).toBeCloseTo(0, 9);
    expect(create(terrainNormals).view(0).settings.surfaceNormal).toBe('terrain');
  });

  it('simulates a landed ship at every substep unless ships may sleep', () => {
    const asleep = flown(RESTING, [sleepingShips]).view;
    const awake = flown(RESTING, []).view;
    expect(asleep.diagnosis.steppedSubsteps).toBe(0);
    expect(awake.diagnosis.steppedSubsteps).toBeGreaterThan(200);
    expect(awake.own!.meshPosition).toEqual(asleep.own!.meshPosition);
  });

  it('leaves out ships that it has no time for only within a frame budget', () => {
    const ships = ['ship-1', 'b', 'c'].map((shipId) => ({ ...STILL, shipId }));
    const frames = RESTING.map((given) => ({ ...given, ships }));
    const limited = (features: readonly Feature[]) => flown(frames, features, { maxSubstepsPerFrame: 2 });
    const within = limited([frameBudget]);
    expect(within.view.diagnosis.budgetOverruns).toBeGreaterThan(0);
    expect(of(within.warned, frameBudget)).toEqual([]);
    const without = limited([]);
    expect(without.view.diagnosis.budgetOverruns).toBe(0);
    expect(of(without.warned, frameBudget)).toHaveLength(1);
  });

  it('extrapolates a ship above ground that is not loaded only with that feature', () => {
    const terrains = { site: () => null };
    const options = { terrains, defaults: { bodies: [LUNA], terrain: 'site' } };
    const known = flown(RESTING, [unloadedGround], options);
    expect(known.view.own!.extrapolated).toBe('ground');
    expect(of(known.warned, unloadedGround)).toEqual([]);
    const unknown = flown(RESTING, [], options);
    expect(unknown.view.own!.extrapolated).toBe('');
    expect(of(unknown.warned, unloadedGround)).toHaveLength(1);
  });

  it('puts the ghost on the ground only with that feature', () => {
    const [x, y, z] = STILL.relativePosition!;
    const sunk = { ...STILL, position: [x, y - 3, z], relativePosition: [x, y - 3, z] } as ShipState;
    const height = (features: readonly Feature[]) => {
      const frames = RESTING.map((given) => ({ ...given, ships: [sunk] }));
      return flown(frames, features).view.own!.ghostPosition[1]! - y;
    };
    expect(height([])).toBeCloseTo(-3, 6);
    // The legs give by a metre.
    expect(height([groundedGhost])).toBeGreaterThan(-1.1);
  });

  it('has the impact of a touch between two states only by replay', () => {
    const [x, y, z] = STILL.relativePosition!;
    const flying = { landedBodyName: '', surfaceContactState: '', relativeVelocity: [0, -4, 0] as const };
    const above = { ...STILL, ...flying, relativePosition: [x, y + 3, z] } as ShipState;
    const touching = { ...STILL, surfaceContactState: 'contact', contactImpactSpeed: null } as ShipState;
    const touched = (features: readonly Feature[]) => {
      const warned: string[] = [];
      const predictor = createLeanPredictor({
        ownShipId: 'ship-1',
        onWarning: (_code, message) => warned.push(message),
        features: [gameCatalogue, ...features],
      });
      // No frame is drawn between the states, so nothing is predicted there.
      predictor.receive(frameAt(1, 1, { ships: [above] }), 0);
      predictor.receive(frameAt(2, 1, { ships: [touching] }), 1);
      predictor.advance(NEUTRAL_CONTROLS, 1);
      return { speed: predictor.view(1).own!.impactSpeed, missing: of(warned, replayedImpacts) };
    };
    const replayed = touched([replayedImpacts]);
    expect(replayed.speed).toBeGreaterThan(4);
    expect(replayed.speed).toBeLessThan(8);
    expect(replayed.missing).toEqual([]);
    expect(touched([]).speed).toBeLessThan(4);
    expect(touched([]).missing).toHaveLength(1);
  });
});
