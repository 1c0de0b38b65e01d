import { describe, expect, it } from 'vitest';
import { CASES } from './cases';
import { createLiteralRig, literalTruthAt } from './literalRig';
import { FIRST_TICK } from './literalServer';
import { dot, length, minus, rotate, rotationBy, scale } from './vectors';
import { SHIP } from '../rig';

describe('a server that runs ten times as fast', () => {
  it('is drawn without jumps: the limit for easing is in game time, not wall time', () => {
    const difference = CASES.find(({ name }) => name === 'time scale 10 not told')!;
    const rig = createLiteralRig({ scenario: 'slide', hz: 50, sends: 1, difference });
    let snaps = 0;
    for (let i = 0; i < 60 * 12; i++) {
      const { diagnosis, own } = rig.frame();
      // The first three states measure the time scale.
      if (i === 60 * 5) snaps = diagnosis.snaps;
      if (own?.crashed === true) break;
    }
    expect(rig.predictor.view(rig.now).diagnosis.snaps - snaps).toBe(0);
  });
});

describe('a server on which ships bounce that the dynamics let settle', () => {
  it('is shown in flight between its bounces after the first, and never confirmed there', () => {
    const difference = CASES.find(({ name }) => name === 'spring × 2')!;
    const rig = createLiteralRig({ scenario: 'settle', hz: 20, sends: 1, difference });
    const shown: { ticks: number; state: string; provenance: string }[] = [];
    for (let i = 0; i < 60 * 24; i++) {
      const { own, tick, sinceTick, tickRate, timeScale } = rig.frame();
      const ticks = tick + (sinceTick * tickRate) / timeScale;
      if (own !== null) shown.push({ ticks, state: own.surfaceContactState, provenance: own.provenance });
    }
    const wrong = shown.filter(({ ticks, state }) => {
      const truth = literalTruthAt(rig.server, SHIP, ticks);
      return truth !== null && truth.state !== state;
    });
    // The dynamics alone were wrong in 198 frames.
    expect(wrong.length).toBeLessThan(120);
    expect(wrong.filter(({ provenance }) => provenance === 'confirmed')).toEqual([]);
  });
});

describe('a server that sends no events and differs a little', () => {
  it('confirms a touch by its states', () => {
    const difference = CASES.find(({ name }) => name === 'ground +0.05 m')!;
    const rig = createLiteralRig({ scenario: 'settle', hz: 50, sends: 10, difference });
    const confirmed = new Set<string>();
    rig.predictor.onEvent(({ kind, type }) => kind === 'confirmed' && confirmed.add(type));
    for (let i = 0; i < 60 * 15; i++) rig.frame();
    expect(confirmed).toContain('ship.contact');
  });
});

/** The server that others are held against is held against physics itself. */
function truthOf(scenario: string, hz: number, seconds: number) {
  const rig = createLiteralRig({ scenario, hz, sends: 1, difference: CASES[0]! });
  for (let i = 0; i < seconds * 60; i++) rig.frame();
  const at = (second: number) => rig.server.truthAt(SHIP, FIRST_TICK + Math.round(second * hz))!;
  return { rig, at };
}

describe('the literal server', () => {
  it('follows free fall', () => {
    const { rig, at } = truthOf('bounce', 50, 1);
    const { body, ship } = rig.loaded;
    const r = length(ship.relativePosition);
    const g = (6.6743e-11 * body.mass) / r ** 2;
    const climb = dot(ship.relativeVelocity, ship.relativePosition) / r;
    const fallen = length(at(0.6).position) - r;
    expect(fallen).toBeCloseTo(climb * 0.6 - (g / 2) * 0.36, 3);
  });

  it('slides v² / (2 μ g) and lands', () => {
    const { rig, at } = truthOf('slide', 50, 24);
    const { ship, body } = rig.loaded;
    const from = ship.relativePosition;
    // The ground has turned on by then.
    const to = rotate(rotationBy(scale(body.angularVelocity, -23)), at(23).position);
    const way = length(minus(scale(from, 1 / length(from)), scale(to, 1 / length(to))));
    const g = (6.6743e-11 * body.mass) / length(from) ** 2;
    expect(at(23).state).toBe('landed');
    // It touches down after 1.1 s in the air, and the bounce's pressure brakes it by μ times the impact's momentum.
    const fall = (-3 + Math.sqrt(9 + 4 * g)) / g;
    const touch = 15 - 0.5 * (3 + g * fall);
    expect(way * body.radius).toBeGreaterThan(15 * fall + touch ** 2 / (2 * 0.5 * g) - 5);
    expect(way * body.radius).toBeLessThan(15 * fall + 15 ** 2 / (2 * 0.5 * g) + 2);
  });

  it('lands while it is still compressing: the design checks its speed alone', () => {
    const { rig, at } = truthOf('settle', 50, 8);
    const { body, shipClass } = rig.loaded;
    const depth = body.radius + shipClass.groundContactOffset - length(at(7.5).position);
    expect(at(7.5).state).toBe('landed');
    // An impact of v sinks v / 10 / e into critical damping.
    expect(depth).toBeGreaterThan(0);
    expect(depth).toBeLessThan(5 / 10 / Math.E + 0.02);
  });
});
