/** The page with missions and lessons: races, crashes, and what Enter does. */
import { expect, it } from 'vitest';
import { raceQuery, verifyRun } from '../../../src/playground/game/mission/bestRuns';
import { MISSIONS } from '../../../src/scenarios';
import { useGameClock } from '../game/openGame';
import { openPage } from './openPage';

useGameClock();

it('races the run in a link, and explains why another link has none', async () => {
  const run = verifyRun(MISSIONS[0]!, [])!;
  const invited = await openPage(raceQuery(run, 'Ann'));
  await invited.until(() => invited.text('notice').includes('Race Ann: '));
  expect(invited.text('notice')).toContain('Their ghost flies beside you.');
  invited.play(3);
  const wrong = await openPage('?run=none');
  await wrong.until(() => wrong.text('notice').includes('run: '));
  expect(wrong.text('notice')).toContain('run: the link names no mission in scenario=');
});

it('shows a card for a crash in a demonstration, and the title of free flight', async () => {
  const page = await openPage('?scenario=crash');
  page.play(1);
  expect(page.text('card')).toBe('');
  page.play(9, 250);
  expect(page.text('card')).toContain('Crashed Too fast: a touch above 50 m/s breaks the ship.');
  page.key('Enter', 'Enter');
  page.play(1);
  expect([page.text('card'), page.document.documentElement.dataset['status']]).toEqual(['', 'flight']);
  page.choose('Mission', 'free-flight');
  page.play(2);
  expect([page.text('card'), page.text('goal').startsWith('Free flight')]).toEqual(['', true]);
  // Enter takes a lesson to the next.
  page.choose('Mission', 'school-hover');
  page.play(1);
  page.key('Enter', 'Enter');
  page.play(1);
  expect(page.query()).toBe('?scenario=school-translate');
});

it('advises the pilot, but not while the autopilot flies', async () => {
  const page = await openPage('?scenario=first-landing');
  page.play(3);
  const advice = /(speed|thrust F|thrust V)$/;
  expect(page.text('goal')).toMatch(advice);
  page.key('KeyY');
  page.play(0.5);
  expect(page.text('goal')).not.toMatch(advice);
  page.key('KeyY');
  page.play(0.5);
  expect(page.text('goal')).toMatch(advice);
});
