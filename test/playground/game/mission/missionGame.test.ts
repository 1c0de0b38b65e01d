/** Additions to the goal's text: how to skip a lesson, and the remaining time. */
import { describe, expect, it } from 'vitest';
import type { VerifiedRun } from '../../../../src/playground/game/mission/bestRuns';
import { createMissionGame, type MissionContext } from '../../../../src/playground/game/mission/missionGame';
import type { Action } from '../../../../src/playground/input/keyTable';
import type { Device } from '../../../../src/playground/game/texts/flightTexts';
import type { CardText } from '../../../../src/playground/panels/missionCard';
import { findMission } from '../../../../src/scenarios';
import { makeView } from '../../../readout/views';

function createGame(scenario: string, runs: object = { isKept: () => false }, server = '') {
  const shown = {
    title: '',
    words: '',
    how: '',
    advice: '',
    flash: '',
    device: 'keys' as Device,
    card: null as CardText | null,
    chosen: '',
    skip: null as (() => void) | null,
    scenario,
  };
  const nothing = () => undefined;
  const game = createMissionGame({
    choices: () => ({ scenario: shown.scenario, server }),
    device: () => shown.device,
    cap: (action: Action) => (action === 'modeUpright' ? 'N' : ''),
    resetCamera: nothing,
    goal: {
      show: (title: string, words: string) => Object.assign(shown, { title, words }),
      offerSkip: (skip: (() => void) | null) => (shown.skip = skip),
      how: (text: string) => (shown.how = text),
      advise: (text: string) => (shown.advice = text),
      hide: () => (shown.title = ''),
    },
    card: { show: (card: CardText) => (shown.card = card), hide: nothing },
    choose: (_name: string, text: string) => (shown.chosen = text),
    runs,
    flash: (text: string) => (shown.flash = text),
  } as unknown as MissionContext);
  game.begin();
  return { game, shown };
}

describe('a best run', () => {
  it('flies beside the pilot and is named, in its own mission alone', async () => {
    const best = { score: { total: 967 }, outcome: { track: new Float64Array(0) } };
    const load = () => Promise.resolve({ best: { of: () => best } });
    const { game, shown } = createGame('sidestep', { isKept: () => true, load });
    await expect.poll(() => shown.flash).toBe('The ghost beside you is your best flight: 967 of 1000.');
    expect(game.ghost.run()).toBe(best);
    const other = createGame('sidestep', {
      isKept: () => true,
      load: () => Promise.resolve({ best: { of: () => null } }),
    });
    await Promise.resolve();
    expect([other.shown.flash, other.game.ghost.run()]).toEqual(['', null]);
  });
});

it('a friend’s run flies beside the pilot in each flight of its mission, in no other', () => {
  const { game, shown } = createGame('sidestep');
  const run = { mission: findMission('relay')!, outcome: { track: new Float64Array(0) } } as VerifiedRun;
  const begun = (scenario: string) => {
    shown.scenario = scenario;
    game.begin();
    return game.ghost.run();
  };
  game.race(run);
  expect(game.ghost.run()).toBeNull();
  expect(['relay', 'relay', 'sidestep', 'relay'].map(begun)).toEqual([run, run, null, run]);
  const second = { ...run };
  game.race(second);
  expect(game.ghost.run()).toBe(second);
});

describe('in a world of another page or server', () => {
  const crashed = () => makeView({}, { shownState: 'crashed', provenance: 'confirmed' });

  it('a real server has no mission, even if the address names one', () => {
    const { game, shown } = createGame('first-landing', undefined, 'ws://127.0.0.1:8787');
    expect([shown.title, shown.words]).toEqual(['Free flight', 'No goal: fly where you like.']);
    expect([game.tracker.mission(), game.tracker.pads()]).toEqual([null, []]);
  });

  it('a guest flies the host’s mission, but cannot skip, restart or choose', () => {
    const { game, shown } = createGame('school-land', undefined, 'tab:abc');
    expect(shown.title).toBe('Lesson 3: land');
    game.confirm();
    game.watch(crashed());
    expect(shown.card).toMatchObject({ title: 'Crashed', actions: [] });
    expect(shown.card!.words).toMatch(/Only the host can restart or continue\.$/);
    game.confirm();
    expect(shown.chosen).toBe('');
    const host = createGame('school-land');
    host.game.watch(crashed());
    expect(host.shown.card!.actions.map(({ text }) => text)).toEqual([
      'Try again',
      'Next: Lesson 4: stand on a slope',
    ]);
  });
});

describe('the goal', () => {
  it('of a lesson names the key that skips it; on a touch screen a button does', () => {
    const { game, shown } = createGame('school-hover');
    expect([shown.title, shown.skip]).toEqual(['Lesson 1: hover · Enter to skip', null]);
    shown.device = 'gamepad';
    game.reword();
    expect([shown.title, shown.skip]).toEqual(['Lesson 1: hover · A to skip', null]);
    shown.device = 'thumbs';
    game.reword();
    expect(shown.title).toBe('Lesson 1: hover');
    shown.skip!();
    expect(shown.chosen).toBe('school-translate');
    // The card of a crash offers the next lesson itself, that of a fallen ship does not.
    const view = (shownState: 'tipped' | 'crashed') => makeView({}, { shownState, provenance: 'confirmed' });
    game.watch(view('tipped'));
    expect(shown.skip).not.toBeNull();
    game.watch(view('crashed'));
    expect(shown.skip).toBeNull();
    const mission = createGame('sidestep').shown;
    expect([mission.title, mission.skip]).toEqual(['Sidestep', null]);
  });

  it('of a lesson does not name the skip key while the card uses it, and skips if the card uses another', () => {
    const { game, shown } = createGame('school-right');
    game.watch(makeView({}, { shownState: 'tipped', provenance: 'confirmed' }));
    expect([shown.card!.title, shown.title]).toEqual([
      'Tipped over',
      'Lesson 5: right a fallen ship · Enter to skip',
    ]);
    game.confirm();
    expect(shown.chosen).toBe('school-phobos');
    const crashed = createGame('school-land', undefined, '');
    crashed.game.watch(makeView({}, { shownState: 'crashed', provenance: 'confirmed' }));
    expect(crashed.shown.card!.actions[0]).toMatchObject({ text: 'Try again', cap: 'Enter' });
    expect(crashed.shown.title).toBe('Lesson 3: land');
  });

  it('is absent in free flight, where only the keys are named', () => {
    const { shown } = createGame('free-flight');
    expect([shown.title, shown.words]).toEqual(['Free flight', 'No goal: fly where you like.']);
    expect(shown.how).toContain('upright {N}');
    expect(createGame('bounce').shown.title).toBe('');
  });

  it('of a hover counts down while the ship is between its heights', () => {
    const { game, shown } = createGame('school-hover');
    const at = (seconds: number, feetHeight: number) => {
      const view = { ...makeView({}, { feetHeight, shownState: '' }), tick: 0, sinceTick: seconds };
      game.watch(view);
      game.advise(view, null);
      return shown.advice;
    };
    expect(at(0, 40)).toBe('');
    expect([at(0.5, 40), at(2.5, 40), at(3, 70), at(4, 40)]).toEqual([
      '10 s to go',
      '8 s to go',
      '',
      '9 s to go',
    ]);
    expect(at(13.5, 40)).toBe('');
  });
});
