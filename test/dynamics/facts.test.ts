import { describe, expect, it } from 'vitest';
import { CRASHED, EVENT_CONTACT, EVENT_LANDED, FLYING, LANDED, SURFACE_STATE } from '../../src/dynamics';
import { bodyNamed, createTrial, see, stepOnce } from './provingGround';

interface Touchdown {
  /** Number of touches after the first. */
  readonly bounces: number;
  readonly crashed: boolean;
  readonly landed: boolean;
  /** m */
  readonly deepest: number;
}

/** The 16 t class comes straight down, its feet `above` metres over the ground at `impact` m/s. */
function comeDown(body: string, impact: number, above = 1e-9): Touchdown {
  const trial = createTrial({ body: bodyNamed(body), height: above, velocity: [0, 0, -impact] });
  let [touches, deepest] = [0, 0];
  let event = 0;
  for (let i = 0; i < 20_000 && event !== EVENT_LANDED && trial.ships[CRASHED] !== 1; i++) {
    event = stepOnce(trial);
    if (event === EVENT_CONTACT) touches++;
    if (trial.ships[SURFACE_STATE] !== FLYING) deepest = Math.max(deepest, -see(trial).height);
  }
  const landed = trial.ships[SURFACE_STATE] === LANDED;
  return { bounces: touches - 1, crashed: trial.ships[CRASHED] === 1, landed, deepest };
}

function range(from: number, to: number, step: number): number[] {
  return Array.from({ length: Math.round((to - from) / step) + 1 }, (_, i) => from + i * step);
}

// DYNAMICS, What this gives: results of an independent implementation.
describe('the 16 t class', () => {
  it.each(['Luna', 'Earth', 'Phobos'])('does not bounce from 0.2 to 9.9 m/s on %s', (body) => {
    for (const impact of [0.2, 9.9, ...range(0.5, 9.5, 0.5)]) {
      const { bounces, landed } = comeDown(body, impact);
      expect([impact, bounces, landed]).toEqual([impact, 0, true]);
    }
  });

  it.each(['Luna', 'Earth'])('bounces once from 12 to 20 m/s on %s, twice from 30 to 45', (body) => {
    for (const impact of range(12, 20, 2)) expect(comeDown(body, impact).bounces).toBe(1);
    for (const impact of range(30, 45, 3)) expect(comeDown(body, impact).bounces).toBe(2);
  });

  // Near 50 m/s the second rebound is close to the bounce speed of 10 m/s, so a third depends on the moment within the substep.
  it.each(['Luna', 'Earth'])('bounces two or three times near 50 m/s on %s', (body) => {
    const found = range(49, 49.9, 0.1).map((impact) => comeDown(body, impact, 0.1).bounces);
    for (const bounces of found) expect([2, 3]).toContain(bounces);
  });

  it('compresses 3.4 m at 49.8 m/s', () => {
    for (const body of ['Luna', 'Earth']) {
      expect(Math.abs(comeDown(body, 49.8).deepest - 3.4)).toBeLessThan(0.05);
    }
  });

  it.each(['Luna', 'Earth', 'Mars', 'Phobos'])('crashes above 50 m/s on %s and not below', (body) => {
    expect(comeDown(body, 50.01).crashed).toBe(true);
    expect(comeDown(body, 49.8).crashed).toBe(false);
  });
});
