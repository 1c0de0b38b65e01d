import { DEFAULT_SETTINGS } from '../../../dynamics';
import { LESSONS, type Mission, MISSIONS } from '../../../scenarios';
import type { Action } from '../../input/keyTable';
import type { Choices } from '../../panels/choices';
import type { CardAction, CardText } from '../../panels/missionCard';
import { controlName, type Device } from '../texts/flightTexts';
import type { MissionTracker } from './missionTracker';

/** The actions of a card's buttons, and the keys that they name. */
export interface CardContext {
  readonly choose: (name: keyof Choices, text: string) => void;
  readonly restart: () => void;
  readonly device: () => Device;
  readonly cap: (action: Action) => string;
}

/** The key that takes a card's first action. */
export function confirmCap({ device }: CardContext): string {
  return { keys: 'Enter', gamepad: 'A', thumbs: '' }[device()];
}

export function nextAction(mission: Mission, context: CardContext): CardAction {
  const list = mission.isLesson ? LESSONS : MISSIONS;
  const next = list[list.indexOf(mission) + 1] ?? MISSIONS[0]!;
  return {
    text: `Next: ${next.scenario.title}`,
    cap: confirmCap(context),
    act: () => context.choose('scenario', next.scenario.name),
  };
}

export function retryAction(context: CardContext): CardAction {
  const cap = controlName(context.device(), 'restart', context.cap);
  return { text: 'Try again', cap, act: context.restart };
}

function card(title: string, words: string, actions: readonly CardAction[]): CardText {
  return { title, words, lines: [], actions };
}

/** The cause of the crash and the next actions: "Try again" and those of the mission. */
export function crashCard(context: CardContext, others: readonly CardAction[]): CardText {
  const retry = { ...retryAction(context), cap: confirmCap(context) };
  const words = `Too fast: a touch above ${DEFAULT_SETTINGS.contactCrashSpeed} m/s breaks the ship.`;
  return card('Crashed', words, [retry, ...others]);
}

/** The card of a phase; null where there is none. */
export function phaseCard(tracker: MissionTracker, mission: Mission, context: CardContext): CardText | null {
  const isLanding = mission.done.kind === 'land';
  const retry = retryAction(context);
  switch (tracker.phase()) {
    case 'flying':
      return null;
    case 'crashed':
      return crashCard(context, [{ ...nextAction(mission, context), cap: '' }]);
    case 'tipped':
      return card('Tipped over', 'Right the ship as the display says, or try again.', [retry]);
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
        ? card('Well done', mission.scenario.about, [nextAction(mission, context), retry])
        : landedCard(mission, 'Checking the flight …', context);
  }
}

export function landedCard(mission: Mission, words: string, context: CardContext): CardText {
  return card('Landed', words, [nextAction(mission, context), retryAction(context)]);
}
