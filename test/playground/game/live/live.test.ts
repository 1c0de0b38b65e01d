import { describe, expect, it, vi } from 'vitest';
import { hashRows, NEUTRAL_CONTROLS, readShip, SHIP_STRIDE } from '../../../../src/dynamics';
import { createFlightLink } from '../../../../src/playground/game/flight/flightLink';
import { type Choices, DEFAULT_CHOICES, readChoices } from '../../../../src/playground/panels/choices';
import { createReplay } from '../../../../src/playground/recording/replay';
import { scriptOf } from '../../../../src/playground/game/live/script';
import {
  compareRecording,
  readRecording,
  runScenario,
  SCENARIOS,
  writeRecording,
} from '../../../../src/scenarios';
import { decodeServerMessage } from '../../../../src/wire';
import { valueOf } from '../../../authority/moon';
import { type Game, open, useGameClock } from '../openGame';

useGameClock();

/** What the page must show at the end: the scenario on the dynamics alone. */
function truth(name: string, tickRate: number): { readonly run: string; readonly seconds: number } {
  const scenario = SCENARIOS.find((candidate) => candidate.name === name)!;
  const { ships, world } = valueOf(runScenario({ ...scenario, terrain: 'hills', tickRate }));
  const lastTick = ships.length / SHIP_STRIDE - 1;
  const { relativePosition, relativeVelocity, attitude, angularVelocity, fuel } = readShip(
    ships,
    lastTick * SHIP_STRIDE,
    world,
  );
  const row = Float64Array.of(
    ...relativePosition,
    ...relativeVelocity,
    ...attitude,
    ...angularVelocity,
    fuel,
  );
  return { run: `${lastTick}:${String(hashRows(row))}`, seconds: lastTick / tickRate };
}

const PLANNED = SCENARIOS.filter(({ inputs }) => inputs.length > 0).map(({ name }) => name);

describe('a scenario with planned inputs', () => {
  it('occurs in several scenarios', () => expect(PLANNED.length).toBeGreaterThan(3));

  const ways = [
    [7, 'satellite', 1],
    [20, 'broken', 20],
    [60, 'broadband', 1],
    [60, 'satellite', 100],
    [144, 'fourG', 5],
  ] as const;
  describe.each(PLANNED)('%s', (scenario) => {
    it.each(ways)('ends in the same bits at %i frames per second over %s, at %i Hz', (...way) => {
      const [fps, network, tickRate] = way;
      const { live, play } = open({ scenario, network, tickRate });
      const { run, seconds } = truth(scenario, tickRate);
      play(fps, seconds + 2);
      expect(live.hash()).toBe(run);
      expect(live.ended()).toBe(true);
      const { diagnosis } = live.frame();
      expect(diagnosis.framesAccepted).toBeGreaterThan(10);
      // A known plan causes no correction.
      expect(diagnosis).toMatchObject({
        correctionsLateInput: 0,
        correctionsLostInput: 0,
        correctionsOtherPilot: 0,
        correctionsMismatch: 0,
        snaps: 0,
      });
    });
  });
});

describe('a display that draws nothing for seconds', () => {
  it('counts no correction of a landed ship whose planned launch passed meanwhile', () => {
    const { live, play } = open({ scenario: 'launch', network: 'lan' });
    // Frames and messages arrive, as in a tab that is building its first picture.
    vi.advanceTimersByTime(3300);
    play(60, 19);
    expect(live.hash()).toBe(truth('launch', 1).run);
    const { diagnosis } = live.frame();
    expect(diagnosis.framesAccepted).toBeGreaterThan(10);
    expect(diagnosis).toMatchObject({ correctionsOtherPilot: 0, correctionsMismatch: 0 });
  });
});

describe('a recording of it', () => {
  it('keeps the plan: every interval agrees with the law, and the replay corrects nothing', () => {
    const game = open({ scenario: 'freighter-hold' });
    game.play(60, 9.5);
    const { plan } = scriptOf({ ...DEFAULT_CHOICES, scenario: 'freighter-hold' });
    const entries = game.entries.slice();
    const recording = valueOf(
      readRecording(writeRecording({ header: { note: '', shipId: 'own', plan }, entries })),
    );
    expect(recording.header.plan).toEqual(plan);
    expect(valueOf(compareRecording(recording))).toMatchObject({
      statesCompared: 9,
      unknownInputs: 0,
      outOfTolerance: null,
      disagreement: null,
    });
    const { diagnosis, own } = createReplay(recording).seek(Infinity);
    expect(diagnosis).toMatchObject({ correctionsMismatch: 0, correctionsOtherPilot: 0 });
    expect(own!.easedPosition).toEqual(game.live.frame().own!.easedPosition);
  });

  it.each([
    ['plan[1].tick', { tick: 0.5, substep: 0, controls: NEUTRAL_CONTROLS }],
    ['plan[1].substep', { tick: 1, substep: 2, controls: NEUTRAL_CONTROLS }],
    ['plan[1].controls', { tick: 2, substep: 0 }],
    [
      'plan[1]: controls.thrustLevel',
      { tick: 2, substep: 0, controls: { ...NEUTRAL_CONTROLS, thrustLevel: '1' } },
    ],
  ])('is refused for an invalid %s', (field, second) => {
    const plan = [{ tick: 1, substep: 3, controls: NEUTRAL_CONTROLS }, second as never];
    const read = readRecording(writeRecording({ header: { note: '', shipId: 'own', plan }, entries: [] }));
    expect(read).toMatchObject({ ok: false, reason: expect.stringContaining(`line 1: ${field}`) as string });
  });
});

describe('a page that was hidden', () => {
  it('does not decode superseded frames, and its recording replays to the same pose', () => {
    const game = open({ scenario: 'settle', network: 'broadband', tickRate: 20 });
    game.play(60, 3);
    const before = game.live.frame().diagnosis.framesAccepted;
    vi.advanceTimersByTime(30_000);
    game.play(60, 3);
    const view = game.live.frame();
    expect(view.diagnosis.framesSuperseded).toBeGreaterThan(550);
    expect(view.diagnosis.framesAccepted - before).toBeLessThan(100);
    expect(view.diagnosis).toMatchObject({ framesRefused: 0, correctionsMismatch: 0 });
    const received = game.entries.filter(
      (entry) => entry.kind === 'received' && entry.message.kind === 'frame',
    );
    expect(received).toHaveLength(view.diagnosis.framesAccepted);
    const recording = { header: { note: '', shipId: 'own' }, entries: game.entries.slice() };
    expect(createReplay(recording).seek(Infinity).own!.easedPosition).toEqual(view.own!.easedPosition);
  });
});

describe('a link to a flight', () => {
  /** The query of the link that the page would copy for the game so far. */
  function linkOf(game: Game, choices: Choices): string {
    const copied: string[] = [];
    const link = createFlightLink({
      live: () => game.live,
      choices: () => choices,
      address: { write: () => undefined, copy: (query) => copied.push(query) },
      notice: {
        show: () => undefined,
        clear: () => undefined,
        withdraw: () => undefined,
        tell: () => undefined,
        showLink: () => undefined,
      },
    });
    link.copy();
    game.play(60, 0.5);
    expect(link.take(game.runs.at(-1)!)).toBe(true);
    return copied[0]!;
  }

  it('flies the same inputs in the same world to the same bits, on any network and display', () => {
    const asked = { scenario: 'launch', body: 'Mars', network: 'broadband' };
    const game = open(asked);
    game.play(60, 1);
    for (const [action, seconds] of [
      ['throttleFull', 1.2],
      ['pitchPlus', 0.4],
      ['throttleCut', 3],
    ] as const) {
      game.live.flightControls.press(action);
      game.live.steer();
      game.play(60, seconds);
      game.live.flightControls.release(action);
      game.live.steer();
    }
    const query = linkOf(game, { ...DEFAULT_CHOICES, ...asked });
    game.play(60, 60);
    const flown = game.live.hash();
    game.live.dispose();
    const { choices, complaints } = readChoices(new URLSearchParams(query));
    expect(complaints).toEqual([]);
    const again = open({ ...choices, network: 'satellite' });
    again.play(20, 70);
    expect(again.live.hash()).toBe(flown);
    expect(again.live.frame().diagnosis).toMatchObject({ correctionsMismatch: 0, correctionsOtherPilot: 0 });
    expect(linkOf(again, choices)).toBe(query);
  });
});

describe('a pause', () => {
  it('with a key held leaves no mismatch after it: keys held or pressed meanwhile do nothing', () => {
    const { live, play } = open({ scenario: 'school-hover', network: 'broadband' });
    play(60, 2.3);
    live.flightControls.press('throttleUp');
    play(60, 0.4);
    live.flightControls.setPaused(true);
    live.operate({ kind: 'pause', paused: true });
    play(60, 3);
    const paused = live.view().own!.controls.thrustLevel;
    live.flightControls.press('throttleFull');
    live.flightControls.press('pitchPlus');
    play(60, 1);
    expect(live.view().own!.controls).toMatchObject({ thrustLevel: paused, rotationInput: [0, 0, 0] });
    live.flightControls.setPaused(false);
    live.operate({ kind: 'pause', paused: false });
    play(60, 5);
    expect(live.frame().diagnosis).toMatchObject({ correctionsMismatch: 0, correctionsOtherPilot: 0 });
  });
});

it('hands the recording each frame’s own bytes', () => {
  const { entries, sent, play } = open({ scenario: 'first-landing' });
  play(60, 4);
  const frames = entries.filter((entry) => entry.kind === 'received' && entry.message.kind === 'frame');
  expect(frames.length).toBeGreaterThan(2);
  for (const entry of frames)
    expect(entry).toMatchObject({ message: valueOf(decodeServerMessage(sent.get(entry)!)) });
});

it('a page that was hidden holds no key when it returns', () => {
  const { live, play } = open({ scenario: 'first-landing' });
  play(30, 1);
  live.flightControls.press('throttleUp');
  play(30, 0.1);
  const tapped = live.view().own!.controls.thrustLevel;
  play(30, 0.4);
  expect(live.view().own!.controls.thrustLevel - tapped).toBeGreaterThan(0.02);
  live.suspend(true);
  play(30, 0.5);
  live.suspend(false);
  play(30, 0.5);
  const { thrustLevel } = live.view().own!.controls;
  play(30, 1);
  expect(live.view().own!.controls.thrustLevel).toBe(thrustLevel);
  expect(thrustLevel).toBeLessThan(0.3);
});
