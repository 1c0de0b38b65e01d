import type { CardText } from '../../panels/missionCard';

import { type CardContext, nextAction, retryAction } from './missionCards';
import type { VerifiedRun } from './verifiedRun';

/** The score of a run, line by line. */
export function scoreCard(
  run: VerifiedRun,
  words: string,
  copyRace: () => void,
  place: CardContext,
): CardText {
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

/** Compares a run with the rival's and with the pilot's previous best. */
export function verdict(
  run: VerifiedRun,
  best: VerifiedRun | null,
  rival: VerifiedRun | null,
  isBest: boolean,
): string {
  const parts: string[] = [];
  if (rival?.mission === run.mission) {
    const ahead = run.score.total - rival.score.total;
    const points = Math.abs(ahead) === 1 ? '1 point' : `${Math.abs(ahead)} points`;
    const compared = ahead === 0 ? 'Level with' : `${points} ${ahead > 0 ? 'ahead of' : 'behind'}`;
    parts.push(`${compared} ${rival.by}.`);
  }
  if (isBest) parts.push(best === null ? 'Your first score here.' : `Your best: ${best.score.total} before.`);
  else if (best !== null) parts.push(`Your best is ${best.score.total}.`);
  return parts.join(' ');
}
