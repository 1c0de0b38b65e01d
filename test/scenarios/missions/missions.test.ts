import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import { NEUTRAL_CONTROLS, type Quat } from '../../../src/dynamics';
import {
  findMission,
  findScenario,
  flyRun,
  LESSONS,
  MISSIONS,
  padPlaces,
  readRun,
  type RunInput,
  type RunOutcome,
  SCENARIOS,
  scoreRun,
  TRACK_RATE,
  TRACK_STRIDE,
  loadScenario,
  writeRun,
} from '../../../src/scenarios';
import { valueOf } from '../../authority/moon';
import golden from './goldenMissions.json';
import { recordOf } from './missionRecord';

const ALL = [...MISSIONS, ...LESSONS];

describe('missions', () => {
  it('include at least twelve missions and six lessons, with unique names', () => {
    expect(MISSIONS.length).toBeGreaterThanOrEqual(12);
    expect(LESSONS).toHaveLength(6);
    expect([MISSIONS.some(({ isLesson }) => isLesson), LESSONS.every(({ isLesson }) => isLesson)]).toEqual([
      ...[false, true],
    ]);
    const names = [...ALL.map(({ scenario }) => scenario.name), ...SCENARIOS.map(({ name }) => name)];
    expect(new Set(names).size).toBe(names.length);
    for (const name of names) expect(findScenario(name)?.name).toBe(name);
    expect(findMission('settle')).toBeNull();
    expect(findMission('__proto__')).toBeNull();
  });

  it.each(ALL.map((mission) => [mission.scenario.name, mission] as const))(
    '%s can be started, and its pads are on its terrain',
    (_, mission) => {
      const loaded = valueOf(loadScenario(mission.scenario));
      const places = padPlaces(mission, loaded);
      expect(places).toHaveLength(mission.pads.length);
      for (const place of places) {
        const distance = Math.hypot(...place);
        const [x, y, z] = place.map((v) => v / distance) as [number, number, number];
        const ground = loaded.body.radius + loaded.terrainHeight(loaded.body.name, x, y, z);
        expect(distance).toBeCloseTo(ground, 6);
      }
    },
  );

  it.each(ALL.map((mission) => [mission.scenario.name, mission] as const))(
    '%s starts, ends and scores as its race links of today expect',
    (name, mission) => {
      expect(recordOf(mission)).toEqual((golden as Record<string, unknown>)[name]);
    },
  );

  it('name the touch that they demand in the score as in the goal', () => {
    const demanding = ALL.filter(({ touchLimit }) => touchLimit !== undefined);
    expect(demanding.length).toBeGreaterThan(0);
    const run = { outcome: 'landed', distance: 0, tilt: 0, fuelUsed: 0, seconds: 1 } as RunOutcome;
    for (const mission of demanding) {
      const limit = mission.touchLimit!;
      const missed = (touchSpeed: number) =>
        scoreRun(mission, { ...run, touchSpeed }).lines.find(({ what }) => what === 'Goal missed')?.rule;
      expect(mission.goal).toContain(`softer than ${limit} m/s`);
      expect([missed(limit), missed(limit + 0.1)]).toEqual([
        undefined,
        `the goal was softer than ${limit} m/s`,
      ]);
    }
  });

  it('name the slope of the ground at their pads', () => {
    const REACH = 10;
    for (const mission of ALL.filter(({ slope }) => slope !== undefined)) {
      const loaded = valueOf(loadScenario(mission.scenario));
      const heightAt = (east: number, north: number) =>
        Math.hypot(...padPlaces({ ...mission, pads: [{ east, north, radius: 1 }] }, loaded)[0]!);
      const [rise, lie] = [
        heightAt(REACH, 0) - heightAt(-REACH, 0),
        heightAt(0, REACH) - heightAt(0, -REACH),
      ];
      const degrees = (Math.atan(Math.hypot(rise, lie) / (2 * REACH)) * 180) / Math.PI;
      expect(Math.abs(degrees - mission.slope!), mission.scenario.name).toBeLessThan(1.5);
    }
  });

  it('use the scenario’s share of engine thrust and its factor on the spin', () => {
    const half = valueOf(loadScenario(findScenario('half-engine')!));
    const whole = valueOf(loadScenario({ ...findScenario('half-engine')!, engineShare: 1 }));
    expect(half.shipClass.mainEngineThrust).toBe(whole.shipClass.mainEngineThrust / 2);
    const spun = valueOf(loadScenario(findScenario('fast-rotator')!)).body.angularVelocity;
    const own = valueOf(loadScenario({ ...findScenario('fast-rotator')!, spinFactor: 1 })).body
      .angularVelocity;
    expect(Math.hypot(...spun)).toBeCloseTo(2.6 * Math.hypot(...own), 12);
  });
});

/** First landing: hovers for a while, then descends; cuts the engine at the ground. */
const SOFT: readonly RunInput[] = [
  { tick: 2, substep: 10, controls: { ...NEUTRAL_CONTROLS, thrustLevel: 0.085, attitudeHold: true } },
  {
    tick: 20,
    substep: 3,
    controls: { ...NEUTRAL_CONTROLS, thrustLevel: 0.09, attitudeHold: true, rotationInput: [0, 0, 0.25] },
  },
  { tick: 22, substep: 0, controls: { ...NEUTRAL_CONTROLS, thrustLevel: 0.07, attitudeHold: true } },
];

type Pose = [x: number, y: number, z: number, qx: number, qy: number, qz: number, qw: number];

describe('a run', () => {
  const mission = findMission('first-landing')!;

  it('replays to the same bits, also from its encoded form', () => {
    const first = valueOf(flyRun(mission, SOFT));
    const bytes = writeRun(SOFT, 100);
    const again = valueOf(flyRun(mission, valueOf(readRun(bytes, 100))));
    expect(again).toEqual(first);
    expect(bytes.length).toBeLessThan(40);
    expect(Math.abs(first.track.length / TRACK_STRIDE - first.seconds * TRACK_RATE)).toBeLessThan(2);
    // Ten poses a second; the last one is the ship at rest, and within the largest tilt.
    const [x, y, z, qx, qy, qz, qw] = first.track.slice(-7) as unknown as Pose;
    const top = [2 * (qx * qz + qw * qy), 2 * (qy * qz - qw * qx), qw * qw - qx * qx - qy * qy + qz * qz];
    const cosine = (top[0]! * x + top[1]! * y + top[2]! * z) / Math.hypot(x, y, z);
    const atRest = (Math.acos(cosine) * 180) / Math.PI;
    expect(first.tilt).toBeGreaterThanOrEqual(atRest - 1e-3);
    expect(first.tilt).toBeLessThan(atRest + 2);
    expect(scoreRun(mission, again)).toEqual(scoreRun(mission, first));
  });

  it('that ends in a crash scores nothing', () => {
    const dive: RunInput[] = [
      { tick: 0, substep: 1, controls: { ...NEUTRAL_CONTROLS, rotationInput: [1, 0, 0] } },
      { tick: 1, substep: 40, controls: { ...NEUTRAL_CONTROLS, attitudeMode: 'antiradial', thrustLevel: 1 } },
    ];
    const run = valueOf(flyRun(mission, dive));
    expect(run.outcome).toBe('crashed');
    expect(scoreRun(mission, run).total).toBe(0);
  });

  const landedWell = {
    outcome: 'landed' as const,
    seconds: 50,
    padsReached: 1,
    touchSpeed: 0.9,
    distance: 1,
    tilt: 1,
    fuelUsed: 100,
    hasTipped: false,
    track: new Float64Array(0),
  };

  it('loses exactly the points on its score lines', () => {
    expect(scoreRun(mission, landedWell).total).toBe(1000);
    expect(scoreRun(mission, { ...landedWell, touchSpeed: 5.5 }).total).toBe(450);
    expect(scoreRun(mission, { ...landedWell, distance: 30 }).total).toBe(750);
    expect(scoreRun(mission, { ...landedWell, hasTipped: true }).total).toBe(850);
    expect(scoreRun(mission, { ...landedWell, outcome: 'unfinished' }).total).toBe(0);
  });

  it('stands as steadily on a slope as on level ground', () => {
    const steep = findMission('steep-slope')!;
    const tiltLine = (from: typeof steep, tilt: number) =>
      scoreRun(from, { ...landedWell, tilt }).lines.find(({ what }) => what === 'Tilt')!;
    expect(tiltLine(mission, 28).points).toBeLessThan(10);
    expect(tiltLine(steep, 28)).toMatchObject({ points: 100, rule: 'full points up to 28°, none from 55°' });
    expect(tiltLine(steep, 41.5).points).toBe(50);
  });

  it('is decoded or refused with a reason, and never throws, for any bytes', () => {
    fc.assert(
      fc.property(fc.uint8Array({ maxLength: 200 }), (bytes) => {
        const read = readRun(bytes, 100);
        return read.ok ? Array.isArray(read.value) : read.reason.length > 0;
      }),
    );
  });

  it('keeps every bit of controls on the page’s grid', () => {
    const stick = fc.integer({ min: -100, max: 100 }).map((v) => v / 100 + 0);
    const triple = fc.tuple(stick, stick, stick);
    const input = fc.record({
      passed: fc.integer({ min: 0, max: 5000 }),
      thrustLevel: fc.integer({ min: 0, max: 200 }).map((v) => v * 0.005),
      rotationInput: triple,
      translationInput: triple,
      attitudeHold: fc.boolean(),
      attitudeMode: fc.constantFrom('none', 'hold', 'radial', 'surface_retrograde'),
      targetAttitude: fc.constantFrom<Quat[]>(
        [0, 0, 0, 1],
        [1, 0, 0, 0],
        [0.5, -0.5, 0.5, 0.5],
        [0, 0.28, 0.96, 0],
      ),
    });
    fc.assert(
      fc.property(fc.array(input, { maxLength: 30 }), (steps) => {
        let at = 0;
        const inputs = steps.map(({ passed, ...controls }): RunInput => {
          at += passed;
          return {
            tick: Math.floor(at / 100),
            substep: at % 100,
            controls: { ...NEUTRAL_CONTROLS, ...controls },
          };
        });
        expect(valueOf(readRun(writeRun(inputs, 100), 100))).toEqual(inputs);
      }),
      { numRuns: 50 },
    );
  });
});
