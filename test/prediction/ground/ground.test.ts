import { describe, expect, it } from 'vitest';
import { type CaseResult, flyCase, RATES } from '../../bench/netcode/foreign/foreign';
import { spread } from '../../bench/netcode/figure';
import { SCENARIOS } from '../../../src/scenarios';
import { CASES, type LiteralCase } from '../literalServer/cases';
import { createLiteralRig } from '../literalServer/literalRig';
import { flyAndMeasure } from '../measure';
import { createRig, SHIP } from '../rig';

/** Display frames a second of a measured flight: half as many moments of it as the bench draws. */
const FPS = 30;

/** Flights of a case that several tests measure are flown once. */
const flown = new Map<string, CaseResult>();
function fly(difference: LiteralCase, hz: number, sends: number): CaseResult {
  const key = `${difference.name} ${hz} ${sends}`;
  const result = flown.get(key) ?? flyCase(difference, hz, sends, ['ours'], FPS);
  flown.set(key, result);
  return result;
}

const caseNamed = (name: string) => CASES.find((one) => one.name === name)!;

describe('terrain that differs slightly from the server’s', () => {
  it.each([
    ['ground +1 m', 10],
    ['ground −1 m', 10],
    ['ground +0.5 m', 10],
    ['ground −0.5 m', 10],
    ['ground +1 m', 1],
    ['ground −1 m', 1],
    ['ground +0.5 m', 1],
    ['ground −0.5 m', 1],
  ])('%s, sent at %i Hz: within 0.1 m (p95) from the third state of a contact on', (name, sends) => {
    const { ours } = fly(caseNamed(name), 50, sends);
    expect(spread(ours.settled).p95).toBeLessThan(0.1);
  });

  it.each([10, 1])('a slope of 5 %%, sent at %i Hz: within 0.5 m (p95) of the whole flight', (sends) => {
    const { ours } = fly(caseNamed('slope 5 %'), 50, sends);
    expect(spread(ours.errors).p95).toBeLessThan(0.5);
  });

  it('is detected from the first bounce on, between two states in flight', () => {
    const difference = caseNamed('ground +0.5 m');
    const rig = createLiteralRig({ scenario: 'opening', hz: 20, sends: 1, difference });
    const states: string[] = [];
    let view = rig.frame();
    while (rig.now < 7) view = rig.frame(({ ships }) => states.push(ships[0]!.surfaceContactState));
    expect(states).toEqual(Array<string>(states.length).fill(''));
    expect(view.own!.groundOffset).toBeGreaterThan(0.4);
    expect(view.own!.groundOffset).toBeLessThan(0.6);
  });

  it.each(CASES.filter(({ rise }) => rise !== undefined))(
    '$name: the status is wrong for at most 0.3 s a contact',
    (difference) => {
      for (const [hz, sends] of RATES) {
        const { ours, contacts } = fly(difference, hz, sends);
        expect(contacts).toBeGreaterThan(3);
        expect(ours.wrongStatus / contacts, `${hz} Hz sent at ${sends} Hz`).toBeLessThan(0.3);
      }
    },
  );

  it.each([1, -1])('%d m: reports the offset and its confidence, and measures heights from it', (metres) => {
    const name = `ground ${metres > 0 ? '+' : '−'}1 m`;
    const rig = createLiteralRig({ scenario: 'settle', hz: 50, sends: 10, difference: caseNamed(name) });
    let view = rig.frame();
    for (let i = 0; i < 8 * 60; i++) view = rig.frame();
    const own = view.own!;
    expect(own.surfaceContactState).toBe('landed');
    // By design a ship counts as landed while it still sinks, up to 0.2 m deep.
    expect(Math.abs(view.diagnosis.groundOffset - metres)).toBeLessThan(0.2);
    expect(own.groundOffset).toBe(view.diagnosis.groundOffset);
    expect(own.groundConfidence).toBeGreaterThan(0.4);
    expect(Math.abs(own.feetHeight)).toBeLessThan(0.1);
    // The mesh is on the drawn ground.
    const mesh = Math.hypot(...own.meshPosition) - own.shipClass.groundContactOffset;
    const drawn = own.groundRadius - own.groundOffset;
    expect(mesh + Math.max(...own.legCompression) - drawn).toBeCloseTo(0, 2);
  });
});

describe('a server of the same ground and other dynamics', () => {
  it.each(['damping 1', 'spring × 2', 'mass 5 % off', 'time scale 1.05 not told'])(
    '%s: the status is wrong for at most 0.3 s a contact',
    (name) => {
      const { ours, contacts } = fly(caseNamed(name), 20, 1);
      expect(ours.wrongStatus / contacts).toBeLessThan(0.3);
    },
  );

  it('no ground is learned on which a ship that the server has in contact would be in the air', () => {
    const difference = caseNamed('damping 1');
    const rig = createLiteralRig({ scenario: 'opening', hz: 20, sends: 1, difference });
    let largest = 0;
    while (rig.now < 12) largest = Math.max(largest, Math.abs(rig.frame().own?.groundOffset ?? 0));
    expect(largest).toBeLessThan(0.1);
  });
});

describe('terrain equal to the server’s', () => {
  it.each(SCENARIOS.map(({ name }) => name))('%s: no offset is learned', (scenario) => {
    const rig = createRig({ scenario, tickRate: 5 });
    const learned = new Set<number>();
    const { frames } = flyAndMeasure(rig, Math.min(20, rig.loaded.scenario.duration), ({ own, diagnosis }) =>
      learned.add(own?.groundOffset ?? 0).add(diagnosis.groundConfidence),
    );
    expect(frames).toBeGreaterThan(100);
    expect([...learned]).toEqual([0]);
  });

  it('is kept when an input came late or was lost', () => {
    const rig = createRig({
      scenario: 'right-itself',
      tickRate: 5,
      holdBack: (message, now) => (message.kind === 'inputs' ? now + 0.8 : now),
    });
    let learned = 0;
    rig.fly(20, ({ ships }) => {
      for (const ship of ships) if (ship.shipId === SHIP && ship.groundOffset !== 0) learned += 1;
    });
    expect(rig.view().diagnosis.correctionsLateInput).toBeGreaterThan(0);
    expect(learned).toBe(0);
  });
});
