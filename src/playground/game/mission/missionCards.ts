import { LESSONS, type Mission, MISSIONS } from '../../../scenarios';
import type { Action } from '../../input/keyTable';
import type { Choices } from '../../panels/choices';
import type { CardAction, CardText } from '../../panels/missionCard';
import { controlName, type Device } from '../words/flightWords';
import type { VerifiedRun } from './bestRuns';
import type { MissionTracker } from './missionTracker';

/** What the buttons of a card do, and which keys they name. */
export interface CardPlace {
  readonly choose: (name: keyof Choices, text: string) => void;
  readonly restart: () => void;
  readonly device: () => Device;
  readonly cap: (action: Action) => string;
}

/** The key that takes a card's first action. */
function confirmCap({ device }: CardPlace): string {
  return { keys: 'Enter', gamepad: 'A', thumbs: '' }[device()];
}

export function nextAction(mission: Mission, place: CardPlace): CardAction {
  const list = mission.isLesson ? LESSONS : MISSIONS;
  const next = list[list.indexOf(mission) + 1] ?? MISSIONS[0]!;
  return {
    text: `Next: ${next.scenario.title}`,
    cap: confirmCap(place),
    act: () => place.choose('scenario', next.scenario.name),
  };
}

function retryAction(place: CardPlace): CardAction {
  const cap = controlName(place.device(), 'restart', place.cap);
  return { text: 'Try again', cap, act: place.restart };
}

function card(title: string, words: string, actions: readonly CardAction[]): CardText {
  return { title, words, lines: [], actions };
}

/** The card of a phase; null where there is none. */
export function phaseCard(tracker: MissionTracker, mission: Mission, place: CardPlace): CardText | null {
  const isLanding = mission.done.kind === 'land';
  const retry = retryAction(place);
  switch (tracker.phase()) {
    case 'flying':
      return null;
    case 'crashed':
      return card('Crashed', 'Too fast: a touch above 50 m/s breaks the ship.', [
        { ...retry, cap: confirmCap(place) },
        { ...nextAction(mission, place), cap: '' },
      ]);
    case 'tipped':
      return card('Tipped over', 'Right the ship with the key the display names, or try again.', [retry]);
    case 'beside':
      return card(
        isLanding ? `Landed ${tracker.off().toFixed(0)} m from the beacon` : 'Landed',
        isLanding ? 'Take off again and land inside the ring, or try again.' : mission.goal,
        [retry],
      );
    case 'padReached':
      return card(`Pad ${tracker.reached()} of ${mission.pads.length}`, 'On to the next beacon.', []);
    case 'done':
      return mission.isLesson
        ? card('Well done', mission.scenario.about, [nextAction(mission, place), retry])
        : landedCard(mission, 'Checking the flight …', place);
  }
}

export function landedCard(mission: Mission, words: string, place: CardPlace): CardText {
  return card('Landed', words, [nextAction(mission, place), retryAction(place)]);
}

/** The score of a run, line by line. */
export function scoreCard(run: VerifiedRun, words: string, copyRace: () => void, place: CardPlace): CardText {
  const { mission, score } = run;
  const landed = run.meetsGoal ? 'Landed' : 'Landed too hard';
  return {
    title: `${landed}: ${score.total} of 1000`,
    words,
    lines: score.lines,
    actions: [
      nextAction(mission, place),
      retryAction(place),
      { text: 'Copy race link', cap: '', act: copyRace },
    ],
  };
}

/** How a run compares with the rival's and with one's own best before. */
export function verdict(
  run: VerifiedRun,
  best: VerifiedRun | null,
  rival: VerifiedRun | null,
  isBest: boolean,
): string {
  const parts: string[] = [];
  if (rival?.mission === run.mission) {
    const ahead = run.score.total - rival.score.total;
    parts.push(ahead > 0 ? `${ahead} points ahead of ${rival.by}.` : `${-ahead} points behind ${rival.by}.`);
  }
  if (isBest) parts.push(best === null ? 'Your first score here.' : `Your best: ${best.score.total} before.`);
  else if (best !== null) parts.push(`Your best is ${best.score.total}.`);
  return parts.join(' ');
}
