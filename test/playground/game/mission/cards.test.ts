/** A run flown beside the pilot, and the texts of the cards after a flight. */
import { Quaternion, Vector3 } from 'three';
import { describe, expect, it } from 'vitest';
import { scoreCard, verdict } from '../../../../src/playground/game/mission/scoreCard';
import { createGhostFlight } from '../../../../src/playground/game/mission/ghost';
import { crashCard, landedCard, phaseCard } from '../../../../src/playground/game/mission/missionCards';
import type { MissionTracker } from '../../../../src/playground/game/mission/missionTracker';
import type { VerifiedRun } from '../../../../src/playground/game/mission/verifiedRun';
import { LESSONS, type Mission, MISSIONS, TRACK_RATE, TRACK_STRIDE } from '../../../../src/scenarios';
import { makeShip, makeView } from '../../../readout/views';

const near = (values: Iterable<number>) => [...values].map((value): unknown => expect.closeTo(value, 9));

describe('a run flown beside the pilot', () => {
  const turned = (degrees: number) =>
    new Quaternion().setFromAxisAngle(new Vector3(0, 0, 1), (degrees * Math.PI) / 180);
  // Of a body's axes: place and attitude at three tenths of a second.
  const points = [0, 1, 2].map((n) => [1000 + 10 * n, 20 * n * n, -30, ...turned(4 * n)]);
  const track = Float64Array.from(
    points.flatMap((point) => [...point, ...Array<number>(TRACK_STRIDE - 7).fill(0)]),
  );
  const run = (by: string) => ({ by, outcome: { track } }) as unknown as VerifiedRun;
  const view = makeView();
  const attitude = new Quaternion(...view.bodies[view.own.body]!.attitude);

  function ghostAt(seconds: number, by = '') {
    const flight = createGhostFlight();
    flight.race(run(by));
    const { ships } = flight.join({ ...view, tick: 0, sinceTick: seconds });
    expect(ships).toHaveLength(2);
    return ships[1]!;
  }
  const at = (n: number) => points[n]!.slice(0, 3) as [number, number, number];
  const inIcrf = (place: readonly [number, number, number]) =>
    new Vector3(...place).applyQuaternion(attitude);

  it('is at its recorded positions, interpolated linearly between them, and stays at either end', () => {
    const step = 1 / TRACK_RATE;
    for (const [seconds, place] of [
      [0, at(0)],
      [step, at(1)],
      [0.25 * step, [1002.5, 5, -30]],
      [1.5 * step, [1015, 50, -30]],
      [2 * step, at(2)],
      [60, at(2)],
      [-1, at(0)],
    ] as const) {
      const ghost = ghostAt(seconds);
      expect([...ghost.meshPosition], `${String(seconds)} s`).toEqual(near(inIcrf(place)));
      expect(ghost.position).toEqual(ghost.meshPosition);
      expect(ghost.easedPosition).toEqual(ghost.meshPosition);
    }
    const { meshAttitude } = ghostAt(step);
    expect([...meshAttitude]).toEqual(near(attitude.clone().multiply(turned(4))));
    const between = new Quaternion(...ghostAt(1.5 * step).meshAttitude);
    expect(between.length()).toBeCloseTo(1, 12);
    expect(between.angleTo(attitude.clone().multiply(turned(6)))).toBeLessThan(1e-3);
  });

  it('is a ship of the pilot’s class that takes no part in the world, named after the pilot of the run', () => {
    expect([ghostAt(0).name, ghostAt(0, 'Ada').name]).toEqual(['Your best', 'Ada']);
    const ghost = ghostAt(0);
    expect(ghost).toMatchObject({
      ...{
        own: false,
        crashed: false,
        shownState: '',
        surfaceContactState: '',
        impactSpeed: 0,
        serverKnown: false,
      },
      shipClass: view.own.shipClass,
    });
    expect([...ghost.velocity, ...ghost.thrust]).toEqual([0, 0, 0, 0, 0, 0]);
  });

  it('is the same object in each frame, another one for another class, and absent without a run or a ship', () => {
    const flight = createGhostFlight();
    expect(flight.join(view)).toBe(view);
    flight.race(run(''));
    expect(flight.run()?.outcome.track).toBe(track);
    const [, first] = flight.join(view).ships;
    expect(flight.join(view).ships[1]).toBe(first);
    const hauler = { ...view.own, shipClass: makeShip({ shipClass: 'cargo_hauler' }).shipClass };
    expect(flight.join({ ...view, own: hauler }).ships[1]!.shipClass).toBe(hauler.shipClass);
    const without = { ...view, own: null };
    const loading = { ...view, ready: false };
    expect([flight.join(without), flight.join(loading)]).toEqual([without, loading]);
    flight.race(null);
    expect(flight.join(view)).toBe(view);
  });
});

describe('the cards', () => {
  const [first, second] = MISSIONS as readonly [Mission, Mission];
  const chosen: string[] = [];
  const context = (device: 'keys' | 'gamepad' | 'thumbs' = 'keys') => ({
    choose: (_name: string, text: string) => chosen.push(text),
    restart: () => chosen.push('restart'),
    device: () => device,
    cap: () => 'R',
  });
  const tracker = (phase: string, changes: object = {}) =>
    ({ phase: () => phase, off: () => 42.4, reached: () => 1, ...changes }) as unknown as MissionTracker;

  it('lead to the next mission of their list, and after the last to the first mission', () => {
    const next = (mission: Mission) => {
      landedCard(mission, '', context()).actions[0]!.act();
      return chosen.splice(0)[0];
    };
    expect(next(first)).toBe(second.scenario.name);
    expect(next(MISSIONS.at(-1)!)).toBe(first.scenario.name);
    expect(next(LESSONS[0]!)).toBe(LESSONS[1]!.scenario.name);
    expect(next(LESSONS.at(-1)!)).toBe(first.scenario.name);
  });

  it('name the confirming key of the device on their first action', () => {
    const caps = (['keys', 'gamepad', 'thumbs'] as const).map((device) =>
      landedCard(first, '', context(device)).actions.map(({ cap }) => cap),
    );
    expect(caps.map(([confirm]) => confirm)).toEqual(['Enter', 'A', '']);
    const crash = crashCard(context(), []);
    expect([crash.title, crash.actions.map(({ text, cap }) => `${text} ${cap}`)]).toEqual([
      'Crashed',
      ['Try again Enter'],
    ]);
    crash.actions[0]!.act();
    expect(chosen.splice(0)).toEqual(['restart']);
  });

  it('show the state of the mission', () => {
    const title = (phase: string, mission = first) =>
      phaseCard(tracker(phase), mission, context())?.title ?? null;
    const phases = ['flying', 'crashed', 'tipped', 'beside', 'padReached', 'done'];
    const twoPads = { ...first, pads: [...first.pads, ...first.pads] };
    expect(phases.map((phase) => title(phase, twoPads))).toEqual([
      ...[null, 'Crashed', 'Tipped over', 'Landed 42 m from the beacon', 'Pad 1 of 2', 'Landed'],
    ]);
    const hover = LESSONS.find(({ done }) => done.kind !== 'land')!;
    expect([title('beside', hover), title('done', hover)]).toEqual(['Landed', 'Well done']);
    const beside = phaseCard(tracker('beside'), hover, context());
    expect([beside!.words, beside!.actions.map(({ text }) => text)]).toEqual([hover.goal, ['Try again']]);
    const crashed = phaseCard(tracker('crashed'), first, context())!.actions;
    expect(crashed.map(({ text, cap }) => `${text}|${cap}`)).toEqual([
      'Try again|Enter',
      `Next: ${second.scenario.title}|`,
    ]);
  });

  const scored = (total: number, by = '', mission = first) =>
    ({ mission, by, meetsGoal: true, score: { total, lines: [] } }) as unknown as VerifiedRun;

  it('give the score, and whether the touch was soft enough', () => {
    const card = scoreCard(scored(870), 'Well flown.', () => chosen.push('copy'), context());
    expect([card.title, card.words, card.actions.length]).toEqual(['Landed: 870 of 1000', 'Well flown.', 3]);
    card.actions[2]!.act();
    expect(chosen.splice(0)).toEqual(['copy']);
    const hard = scoreCard({ ...scored(120), meetsGoal: false }, '', () => undefined, context());
    expect(hard.title).toBe('Landed too hard: 120 of 1000');
  });

  it.each([
    [null, null, true, 'Your first score here.'],
    [scored(700), null, true, 'Your best: 700 before.'],
    [scored(900), null, false, 'Your best is 900.'],
    [null, null, false, ''],
    [null, scored(750, 'Ada'), true, '50 points ahead of Ada. Your first score here.'],
    [scored(900), scored(850, 'Ada'), false, '50 points behind Ada. Your best is 900.'],
    [null, scored(800, 'Ada'), false, 'Level with Ada.'],
    [null, scored(801, 'Ada'), false, '1 point behind Ada.'],
    [null, scored(750, 'Ada', second), true, 'Your first score here.'],
  ])('compare 800 points with the best and the rival, %#', (best, rival, isBest, words) => {
    expect(verdict(scored(800), best, rival, isBest)).toBe(words);
  });
});
