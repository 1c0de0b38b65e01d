import { describe, expect, it } from 'vitest';
import { verifyRun } from '../../../src/playground/game/mission/bestRuns';
import { createMissionTracker } from '../../../src/playground/game/mission/missionTracker';
import type { WorldView } from '../../../src/prediction';
import {
  createLandingAids,
  createLandingReadout,
  updateLandingAids,
  updateLandingReadout,
} from '../../../src/readout';
import { findMission } from '../../../src/scenarios';
import { type Game, open, useGameClock } from './openGame';

useGameClock();

/** Wall seconds between two looks at the screen, a fast reaction time. */
const REACTION = 0.5;

/**
 * A newcomer who goes by the screen alone: "F more thrust, V less, X cut the engine", the goal, VSPD, AGL and
 * AIM. Taps F when it comes down faster than AIM, V when slower, and X at the touch.
 */
function createNewcomer({ live }: Game): (view: WorldView, now: number) => void {
  const readout = createLandingReadout();
  const aids = createLandingAids();
  let lookedAt = -Infinity;
  let before = NaN;
  return (view, now) => {
    updateLandingReadout(readout, view);
    updateLandingAids(aids, view);
    if (now - lookedAt < REACTION || !readout.known) return;
    lookedAt = now;
    if (readout.status === 'contact') live.flightControls.press('throttleCut');
    const speed = readout.descent.verticalSpeed;
    const quickening = Number.isNaN(before) ? 0 : speed - before;
    before = speed;
    if (!aids.shown) return;
    // The display's words about AIM, and whether it gets worse.
    const tap = (action: 'throttleUp' | 'throttleDown') => {
      live.flightControls.press(action);
      live.flightControls.release(action);
    };
    const off = speed - Math.min(aids.aimSpeed, 8);
    if (off > 0.2 && quickening > -0.3) tap('throttleUp');
    else if (off < -0.2 && quickening < 0.3) tap('throttleDown');
  };
}

describe('the first minute', () => {
  it('a newcomer lands by the beacon at less than 2 m/s at the first try, and a replay of the run proves it', () => {
    const mission = findMission('first-landing')!;
    const tracker = createMissionTracker();
    tracker.begin(mission);
    const game = open({});
    const look = createNewcomer(game);
    let now = 0;
    let hardest = 0;
    game.play(20, 130, (view) => {
      now += 0.05;
      if (view.own?.touchdown.known === true) hardest = Math.max(hardest, view.own.touchdown.verticalSpeed);
      tracker.watch(view);
      if (tracker.phase() === 'flying') look(view, now);
    });
    expect(tracker.phase()).toBe('done');
    const { diagnosis } = game.live.frame();
    expect(hardest).toBeLessThan(2);
    expect(tracker.off()).toBeLessThan(30);
    expect(diagnosis).toMatchObject({ correctionsMismatch: 0, correctionsOtherPilot: 0 });

    game.live.operate({ kind: 'run' });
    game.play(20, 0.5);
    const run = verifyRun(mission, game.runs[0]!)!;
    expect(run.outcome).toMatchObject({ outcome: 'landed', padsReached: 1, hasTipped: false });
    expect(run.outcome.touchSpeed).toBeCloseTo(hardest, 6);
    expect(run.outcome.distance).toBeCloseTo(tracker.off(), 3);
    expect(run.score.total).toBeGreaterThan(400);
    expect(run.score.total).toBe(run.score.lines.reduce((sum, { points }) => sum + points, 0));
  });

  it('without any input the ship still comes down intact, so there is a second try', () => {
    const game = open({});
    const states = new Set<string>();
    game.play(10, 120, (view) => states.add(view.own?.shownState ?? ''));
    expect(states.has('crashed')).toBe(false);
    expect(states.has('contact') || states.has('landed')).toBe(true);
  });
});
